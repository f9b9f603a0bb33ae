/* lib/motion/tube.h -- one smooth path within the tolerance
 * SPDX-License-Identifier: MIT
 *
 * The path is a uniform cubic B-spline over the knots, which are places of it. It leaves them by
 * less than the tolerance, and within that its third differences are as small as can be.
 */
#ifndef LOFT_MOTION_TUBE_H
#define LOFT_MOTION_TUBE_H

#include "motion/path.h"    /* loft_path_place, loft_period */

LOFT_BEGIN_C

/* The most that the pace of a knot may be. It begins as its place does, which is kept then. */
typedef struct {
    loft_coord feed;
    uint16_t   number;
    bool       sharp, loose;
    int32_t    top;         /* the most that speed allows it to be, up to the next knot */
    int32_t    goal;        /* the most that all limits allow an even one, up to the next knot */
    int32_t    aim;         /* what v2 is moved to, at first: aim.h */
} loft_knot_most;

/* A path is smoothed first, and then it is timed. With little effort both use the same memory; the
 * guess (guess.h) goes on with the places. */
#if LOFT_PLAN_EFFORT > 1
#define LOFT_KNOT_EITHER struct
#else
#define LOFT_KNOT_EITHER union
#endif

/* A knot of the path. Do not rely on the fields. */
typedef struct {
    loft_position point;    /* control point of the path */
    union {
        loft_coord room;    /* until it is placed: how far that may be from where it meets places */
        int32_t    v2;      /* then: control value of the squared pace, 2^-24: timing.h */
    } now;
    LOFT_KNOT_EITHER
    {
        loft_path_place on;     /* until the next one is placed, too: what is given */
        loft_knot_most  most;   /* when the next but one is placed, too */
    }
    is;
} loft_knot;

/* Put the control points from..to - 1 where the path through the knots has them.
 *
 *   range   0 < from <= to < n
 */
void loft_tube_load(loft_knot knot[], unsigned from, unsigned to);

/* The control points of the first three knots are where the path begins, if it does; those of the
 * last three where it ends.
 *
 *   range   count >= 3
 */
void loft_tube_tie(loft_knot knot[], unsigned count, bool begins, bool ends);

/* Set how far the control points from..to - 1, which three others precede and follow, may be moved.
 *
 *   range   3 <= from <= to <= n - 3
 */
void loft_tube_measure(const loft_period *period, loft_knot knot[], unsigned from, unsigned to);

/* Smooth them; again, when others follow.
 *
 *   range   as loft_tube_measure
 *   cost    sweeps * (to - from) * LOFT_AXES * 7 products of 32 bits; more where it is a corner
 */
void loft_tube_smooth(loft_knot knot[], unsigned from, unsigned to, int sweeps);

LOFT_END_C

#endif
