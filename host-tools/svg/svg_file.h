/* host-tools/svg/svg_file.h -- a drawing in SVG
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SVG_FILE_H
#define LOFT_SVG_FILE_H

#include <stddef.h>

#include "read/reader.h"

extern const reader reader_svg;

/* Read a text of `size` bytes, followed by a 0; `file` is for messages. Returns 0, or an exit code
 * after one message. */
int drawing_read_svg(host *h, drawing *d, const char *file, const char *text, size_t size);

#endif
