/* host-tools/geometry/stretches.h -- where two curves meet, as stretches over several of their
 * pieces
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_STRETCHES_H
#define LOFT_STRETCHES_H

#include "geometry/element.h"

struct host;                /* base/host.h */

/* A stretch along which two curves meet, with three places on each: its begin, the closest place,
 * its end. */
typedef struct {
    double s[3], t[3], on_first[3][CURVE_AXES], on_second[3][CURVE_AXES];
    double point[ENGINE_AXES], distance;
    bool overlap;
} stretch;

typedef struct {
    stretch *row;
    size_t count, room;
    double range[2];            /* the ranges of the parameters of both curves */
} stretches;

/* Add the stretches of an element of each curve, `tol` apart at most; set `range` before. One that
 * continues in the next piece becomes one with it. Returns an exit code after printing one line. */
int stretches_meet(struct host *h, stretches *list, const engine *e, const element *a,
                   const element *b, double tol);

#endif
