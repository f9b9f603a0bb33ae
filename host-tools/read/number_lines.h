/* host-tools/read/number_lines.h -- curves as numbers: control points, or a cubic per line
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUMBER_LINES_H
#define LOFT_NUMBER_LINES_H

#include "read/reader.h"

extern const reader reader_numbers;

/* The control points of one Bezier curve, "0,0 1,2 3,0". */
int curves_of_points(host *h, curves *all, const char *text);

/* The curves of a drawing; the travels of a program are none. */
int curves_of_drawing(host *h, curves *all, const drawing *d, const char *file);

#endif
