/* host-tools/geometry/curve_text.h -- curves in the text format .loft, as LOFT.md describes it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_CURVE_TEXT_H
#define LOFT_HOST_CURVE_TEXT_H

#include "engine/curve.h"       /* curves */

struct host;                    /* base/host.h */

/* True if the name of the file, or the first word of the text, says that it holds curves. */
bool curves_is_text(const char *file, const char *text);

/* Append the curves of a text. Returns 0, or an exit code after one message. `*all` must be
 * zeroed, but for what is asked for. */
int curves_read_text(struct host *h, curves *all, const char *file, const char *text);

#endif
