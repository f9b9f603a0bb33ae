/* host-tools/geometry/surface_text.h -- surfaces in the text format .loft, as LOFT.md describes it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_SURFACE_TEXT_H
#define LOFT_HOST_SURFACE_TEXT_H

#include "engine/surface.h"     /* surfaces */

struct host;                    /* base/host.h */

/* Read `file` ("-" is standard input) if it contains surfaces. Otherwise *all stays empty, and the
 * file may be read as something else. Returns 0, or an exit code after one message. `*all`
 * must be zeroed, but for what is asked for. */
int surfaces_read(struct host *h, surfaces *all, const char *file);

/* The same, but a file without surfaces is an error. */
int surfaces_read_only(struct host *h, surfaces *all, const char *file);

/* True if a surface begins with this word. Read a text. */
bool surface_begins(const char *word);
int  surfaces_read_text(struct host *h, surfaces *all, const char *file, const char *text);

#endif
