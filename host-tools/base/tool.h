/* host-tools/base/tool.h -- what all commands share: errors in one line, exit codes
 * SPDX-License-Identifier: MIT
 *
 * Every error is one line on standard error: `loft: file:line: what: remedy`, with a code of
 * <sysexits.h>.
 */
#ifndef LOFT_TOOL_H
#define LOFT_TOOL_H

#include <stdbool.h>
#include <stddef.h>
#include <sysexits.h>       /* EX_USAGE, EX_DATAERR, EX_NOINPUT, EX_UNAVAILABLE, EX_PROTOCOL, .. */

#include "base/bridge.h"    /* tool_error */

/* The seconds of a monotonic clock. */
double tool_clock(void);

/* The plural ending of a word: "%zu curve%s", n, tool_s(n). */
static inline const char *tool_s(size_t n)      { return n == 1 ? "" : "s"; }

/* The version of this program. */
extern const char tool_version[];

#endif
