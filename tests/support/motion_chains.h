/* tests/support/motion_chains.h -- chains of curves to plan: all kinds of shapes and sizes, and
 * limits for them
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_CHAINS_H
#define LOFT_TESTS_MOTION_CHAINS_H

#include <math.h>           /* exp, log, sqrt, floor */

#include "check.h"          /* BY_NUM */
#include "motion/plan.h"    /* loft_move, loft_limits */

#ifndef CURVES
#  define CURVES 40
#endif

static loft_move   chain[CURVES];
static unsigned    curves;
static loft_limits limits;

static inline loft_real real_of(double x)      /* a multiple of 2^-16 in every build */
{
    const double raw = floor(x * 65536 + 0.5);
    return BY_NUM((loft_real)raw, (loft_real)(raw / 65536), (loft_real)(raw / 65536));
}

static inline double arb_between(arb *a, double low, double high)
{
    return low + (high - low) * (double)(arb_next(a) >> 11) / 9007199254740992.0;
}

static inline double arb_decades(arb *a, double low, double high)
{
    return exp(arb_between(a, log(low), log(high)));
}

static double here[LOFT_AXES], heading[LOFT_AXES];

static inline void arb_direction(arb *a, double d[])
{
    double len = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        d[i] = arb_below(a, 4) ? arb_between(a, -1, 1) : 0;
        len += d[i] * d[i];
    }
    if (!(len > 0))
        d[0] = len = 1;
    for (int i = 0; i < LOFT_AXES; i++)
        d[i] /= sqrt(len);
}

/* Append the curve whose control points are at u[k] along `d` and w[k] along `e` from here. */
static inline void add_curve(const double d[], const double e[], const double u[4],
                             const double w[4], double feed)
{
    loft_move *m = &chain[curves++];
    m->feed = real_of(feed);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double x = here[i] + u[k] * d[i] + w[k] * e[i];
            m->curve.p[k].axis[i] = real_of(fmax(-8190, fmin(8190, x)));
        }
    if (curves > 1)
        m->curve.p[0] = chain[curves - 2].curve.p[3];
    double len = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        here[i]    = arb_value(m->curve.p[3].axis[i]);
        heading[i] = (u[3] - u[2]) * d[i] + (w[3] - w[2]) * e[i];
        len += heading[i] * heading[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        heading[i] = len > 0 ? heading[i] / sqrt(len) : i == 0;
}

enum kind {
    LINE,
    ARC,
    SMOOTH,
    EASED_LINE,
    WILD,
    CUSP,
    LOOP,
    POINT,
    RETRACTED,
    REVERSED,
    THERE_AND_BACK,
    KINDS
};

/* Curves of one shape, in sizes along two directions. */
static const double shape[KINDS][2][4] = { [LINE] = { { 0, 1 / 3.0, 2 / 3.0, 1 }, { 0, 0, 0, 0 } },
                                           [ARC] = { { 0, 0.5522847, 1, 1 },
                                                     { 0, 0, 0.4477153, 1 } },
    [EASED_LINE]     = { { 0, 0, 1, 1 },          { 0, 0, 0, 0 } },
    [CUSP]           = { { 0, 1, 0, 1 },          { 0, 1, 1, 0 } },
    [LOOP]           = { { 0, 2, -1, 1 },         { 0, 1, 1, 0 } },
    [POINT]          = { { 0, 0, 0, 0 },          { 0, 0, 0, 0 } },
    [REVERSED]       = { { 0, 2, -1, 1 },         { 0, 0, 0, 0 } },
                                           [THERE_AND_BACK] = { { 0, 1, 1, 0 }, { 0, 0, 0, 0 } } };

/* `onward`: it begins in the direction in which the one before ends. */
static inline void arb_curve(arb *a, enum kind kind, double size, double feed, bool onward)
{
    double d[LOFT_AXES], e[LOFT_AXES], u[4] = { 0, 0, 0, 0 }, w[4] = { 0, 0, 0, 0 };

    arb_direction(a, d);
    arb_direction(a, e);
    for (int i = 0; i < LOFT_AXES && onward && curves > 0; i++)
        d[i] = heading[i];
    for (int k = 1; k < 4; k++) {
        const bool drawn = kind == SMOOTH || kind == WILD || kind == RETRACTED;
        u[k] = size * (drawn ? arb_between(a, -1, 1) : shape[kind][0][k]);
        w[k] = size * (drawn ? arb_between(a, -1, 1) : shape[kind][1][k]);
    }
    if (kind == SMOOTH) {               /* a handle at each end, no shorter than a tenth */
        u[1] = size * arb_between(a, 0.1, 1);
        w[1] = 0;
        u[2] = u[3] - size * arb_between(a, 0.1, 0.5);
    }
    const unsigned which = arb_below(a, 3);
    if (kind == RETRACTED && which != 1)
        u[1] = w[1] = 0;
    if (kind == RETRACTED && which != 0) {
        u[2] = u[3];
        w[2] = w[3];
    }
    add_curve(d, e, u, w, feed);
}

static inline void begin_chain(void)
{
    curves = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        here[i] = heading[i] = 0;
}

static inline void usual_limits(void)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = real_of(1000);
        limits.max_accel[i] = real_of(500);
        limits.max_jerk[i]  = 0;
    }
    limits.corner  = 0;
    limits.tol     = real_of(0.005);
    limits.tick_hz = 1000;
}

static inline void arb_limits(arb *a)
{
    static const uint16_t rates[] = { 250, 333, 500, 1000, 1024, 2000, 4000 };
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = real_of(arb_decades(a, 5, 500));
        limits.max_accel[i] = real_of(arb_decades(a, 100, 10000));
        limits.max_jerk[i]  = 0;
    }
    limits.corner  = arb_below(a, 2) ? 0 : real_of(arb_decades(a, 0.002, 0.1));
    limits.tol     = real_of(arb_decades(a, 0.002, 0.1));
    limits.tick_hz = rates[arb_below(a, 7)];
}

/* One to 13 curves of all kinds, from specks to metres, of similar size. */
static inline void arb_chain(arb *a)
{
    const double size = arb_decades(a, 0.0002, 1000),
                 feed = arb_decades(a, fmax(1, size / 60), 500);
    const unsigned n = 1 + arb_below(a, 13);
    const bool one_kind = arb_below(a, 3) == 0;
    const enum kind kind = (enum kind)arb_below(a, KINDS);

    begin_chain();
    for (unsigned k = 0; k < n; k++) {
        const double mine = arb_below(a, 4) ? size * arb_decades(a, 0.2, 1) : size * 0.001;
        arb_curve(a, one_kind ? kind : (enum kind)arb_below(a, KINDS), mine,
                  arb_below(a, 3) ? feed : feed * arb_between(a, 0.1, 1), false);
    }
}

#endif
