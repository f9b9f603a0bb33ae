/* host-tools/geometry/surface_text.h -- surfaces in the text format .loft, as LOFT.md describes it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_SURFACE_TEXT_H
#define LOFT_HOST_SURFACE_TEXT_H

#include "engine/surface.h"     /* surfaces */

/* Read `file` ("-" is standard input) if it contains surfaces. Otherwise *all stays empty, and the
 * file may be read as something else. Returns 0, or an exit code after printing one line. `*all`
 * must be zeroed, but for what is asked for. */
int surfaces_read(surfaces *all, const char *file);

/* The same, but a file without surfaces is an error. */
int surfaces_read_only(surfaces *all, const char *file);

/* Does a surface begin with this word? Read a text. */
bool surface_begins(const char *word);
int  surfaces_read_text(surfaces *all, const char *file, const char *text);

#endif
