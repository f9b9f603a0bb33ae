/* tests/support/motion_knots.h -- smooth paths of knots, and what a pace uses of the limits there
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_KNOTS_H
#define LOFT_TESTS_MOTION_KNOTS_H

#include <math.h>                   /* sqrt, fabs */

#include "support/motion_paths.h"   /* even_limits */

#include "motion/timing.h"          /* loft_timing_load */

#define KNOTS 60

static loft_period period;
static loft_knot   knot[KNOTS];
static unsigned    knots;

/* A smooth path from rest to rest, with steps of a period or so. */
static inline void arb_path(arb *a)
{
    double at[LOFT_AXES] = { 0 }, step[LOFT_AXES], turn[LOFT_AXES];

    even_limits(arb_decades(a, 50, 500), arb_decades(a, 500, 5000), arb_decades(a, 10000, 300000));
    loft_period_init(&period, &limits);
    knots = 12 + arb_below(a, KNOTS - 12);
    arb_direction(a, step);
    arb_direction(a, turn);
    for (unsigned k = 0; k < knots; k++) {
        const double size = period.accel[0] * arb_between(a, 0.5, 1) *
                            fmin(8, fmin(k, knots - 1 - k)) / 2;
        knot[k].is.on.feed = period.speed[0];
        knot[k].is.on.skip = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            knot[k].is.on.at.axis[i] = knot[k].point.axis[i] = (loft_coord)at[i];
            at[i] += size * (step[i] + 0.02 * k * turn[i]);
        }
    }
    for (unsigned k = 0; k < 3; k++) {
        knot[k].point = knot[0].point;
        knot[knots - 1 - k].point = knot[knots - 1].point;
    }
    loft_tube_measure(&period, knot, 3, knots - 3);
    loft_tube_smooth(&period, knot, 3, knots - 3, 20);
    loft_timing_load(&period, knot, 1, knots - 2);
}

static inline double v2_at(unsigned k, double z, double *slope, double *curve)
{
    const double x = knot[k].is.pace.v2, y = knot[k + 1].is.pace.v2, w = knot[k + 2].is.pace.v2,
                 one = LOFT_V2_ONE;
    *curve = (x - 2 * y + w) / one;
    *slope = (y - x) / one + *curve * z;
    return ((x + y) / 2 + (y - x) * z) / one + *curve * z * z / 2;
}

/* The largest parts of speed, acceleration and jerk between knot k and the next. */
static inline void uses_of(unsigned k, double use[3])
{
    for (int n = 0; n < 3; n++)
        use[n] = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int s = 0; s <= 16; s++) {
            const double z = s / 16.0, a = knot[k - 1].point.axis[i], b = knot[k].point.axis[i],
                         c = knot[k + 1].point.axis[i], d = knot[k + 2].point.axis[i];
            double slope, curve;
            const double v2 = v2_at(k, z, &slope, &curve), d3 = d - 3 * c + 3 * b - a;
            const double d2 = a - 2 * b + c + d3 * z,
                         d1 = (c - a) / 2 + (a - 2 * b + c) * z + d3 * z * z / 2;
            use[0] = fmax(use[0], fabs(d1) * sqrt(v2) / period.speed[i]);
            use[1] = fmax(use[1], fabs(d2 * v2 + d1 * slope / 2) / period.accel[i]);
            use[2] = fmax(use[2], fabs(d3 * v2 + 1.5 * d2 * slope + d1 * curve / 2) * sqrt(v2) /
                                      period.jerk[i]);
        }
}

#endif
