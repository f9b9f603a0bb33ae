/* host-tools/read/csv.h -- a drawing as numbers: x0,y0,x1,y1,x2,y2,x3,y3 in mm, one cubic per line
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CSV_H
#define LOFT_CSV_H

#include <stddef.h>

#include "base/source.h"        /* source */
#include "read/drawing.h"

/* Read a source of which the first part is there, or a text of `size` bytes, followed by a 0;
 * `file` is for messages. */
int drawing_csv_parts(host *h, drawing *d, const char *file, source *s);
int drawing_read_csv(host *h, drawing *d, const char *file, const char *text, size_t size);

#endif
