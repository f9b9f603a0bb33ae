/* host-tools/arrange/fill.h -- fills the closed shapes of a drawing with lines
 * SPDX-License-Identifier: MIT
 *
 * What is inside is what a browser paints: all outlines of one element together, by its fill-rule;
 * open outlines are closed by a line. The lines of all shapes lie on one grid through 0, 0, so
 * those of neighbours meet.
 */
#ifndef LOFT_FILL_H
#define LOFT_FILL_H

#include "base/option.h"    /* option */
#include "read/drawing.h"

struct host;                /* base/host.h */

typedef struct {
    double degrees, distance;       /* distance: mm; 0: no fill */
    bool cross;                     /* a second time, 90 degrees further */
    bool contour, spiral;           /* lines parallel to the outline; without lifts */
    const char *outline;            /* "all", "stroke", "none"; NULL: all */
} fill_options;

extern const option fill_rows[];

/* Add the lines behind each shape, and leave out the outlines that are not wanted. Returns 0, or an
 * exit code after printing one line.
 *
 *   error   ends of lines are within 1e-9 mm of the outline; lines shorter than FILL_LEAST are left
 *           out */
int fill_apply(struct host *h, const fill_options *f, drawing *d, const char *file);

#define FILL_LEAST 0.001        /* mm */

#endif
