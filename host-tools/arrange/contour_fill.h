/* host-tools/arrange/contour_fill.h -- fills an area with lines parallel to its outline
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CONTOUR_H
#define LOFT_CONTOUR_H

#include "read/drawing.h"

struct host;                /* base/host.h */

typedef struct {
    double distance;            /* mm, between lines; the outermost is half of it inside */
    bool spiral;                /* lines go over into the next, without a lift */
} contour_options;

/* Append the lines of the shape of curves first .. last - 1 of `d` to `to`; they are like `like`.
 * Returns 0, or an exit code after printing one line.
 *
 *   error   between neighbours: 2 % of the distance, and 0.002 mm */
int contour_fill(struct host *h, const contour_options *o, const drawing *d, size_t first,
                 size_t last, const drawing_curve *like, drawing *to, const char *file);

#endif
