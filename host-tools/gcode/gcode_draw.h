/* host-tools/gcode/gcode_draw.h -- a G-code program as a drawing in space
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GCODE_DRAW_H
#define LOFT_GCODE_DRAW_H

#include <stdbool.h>
#include <stddef.h>

#include "read/reader.h"

extern const reader reader_gcode;

/* Read a text of `size` bytes, followed by a 0; `file` is for messages. Returns 0, or an exit code
 * after one message. */
int drawing_read_gcode(host *h, drawing *d, const char *file, const char *text, size_t size);

/* True if it is a program of a 3-D printer. */
bool gcode_is_printer(const char *text);

#endif
