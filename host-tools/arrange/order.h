/* host-tools/arrange/order.h -- the order of a drawing with the least travel
 * SPDX-License-Identifier: MIT
 *
 * Curves that the drawing has twice are drawn once; paths whose ends touch become one path; then
 * paths are drawn in the order, in the direction and, if they are closed, from the point for which
 * the way between them is short (tour.h).
 */
#ifndef LOFT_ORDER_H
#define LOFT_ORDER_H

#include "base/option.h"    /* option */
#include "read/drawing.h"   /* drawing */

struct host;                /* base/host.h */

typedef struct {
    const char *how;            /* "file", "layer" or "best"; NULL: file */
    double effort;              /* seconds, as in tour.h */
    double join;                /* mm */
    const char *seam;           /* "any", "corner" or "X,Y"; NULL: any */
    bool doubles;
} order_options;

extern const option order_rows[];

/* Put the drawing in order, all of it also with "layer" (tools.h), for a tool that begins at `from`
 * and, if it `returns`, ends there. Returns 0, or an exit code after printing one line. */
int order_apply(struct host *h, const order_options *o, drawing *d, const double from[2],
                bool returns, const char *file);

#endif
