/* lib/path/period.h -- what the limits of a machine allow in a period
 * SPDX-License-Identifier: MIT
 *
 * Motion is planned with places at even periods of time. In one period h, differences of places are
 * at most v h, a h^2 and j h^3.
 */
#ifndef LOFT_PATH_PERIOD_H
#define LOFT_PATH_PERIOD_H

#include "path/coord.h"    /* loft_coord   */
#include "path/limits.h"  /* loft_limits */

LOFT_BEGIN_C

/* The most periods in a span. */
#define LOFT_PERIOD_JOINED (LOFT_PLAN_EFFORT > 1 ? 16 : 8)

/* Do not rely on the fields. All in units of loft_coord. */
typedef struct {
    loft_coord speed[LOFT_AXES];     /* v h, at most 2^28; of 2^-16 mm a multiple of 3 */
    loft_coord accel[LOFT_AXES];     /* a h^2, a multiple of 6 */
    loft_coord jerk[LOFT_AXES];      /* j h^3, a multiple of 6, limited or not */
    loft_coord tol;                  /* how far from the path, */
    loft_coord more;                 /* and so much farther near corners */
    loft_coord tube;                 /* how much of tol is for the smooth path */
    loft_coord off;                  /* and for spans, to be off its samples */
    uint16_t  joined;               /* how many periods a span may last */
    int32_t   exact;                /* the square of loft_limits.exact, 2^-28; 0: no stops */
    uint16_t  tick_hz;
    uint16_t  ticks;                /* of a period, */
    uint16_t  last;                 /* and the fewest of the last one of a chain */
    uint8_t   one_sided;            /* axes that may not pass their end values */
} loft_period;

/* Choose the period for `limits`, which loft_limits_check has accepted. */
void loft_period_init(loft_period *period, const loft_limits *limits);

/* A feed, mm/s, in a period, less what rounding spans adds to it. */
loft_coord loft_period_speed(const loft_period *period, loft_real speed);

LOFT_END_C

#endif
