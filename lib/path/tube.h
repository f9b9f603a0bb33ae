/* lib/path/tube.h -- one smooth path within the tolerance
 * SPDX-License-Identifier: MIT
 *
 * The path is a uniform cubic B-spline over the knots, which are places of it. It leaves them by
 * less than the tolerance, and within that its third differences are as small as can be.
 */
#ifndef LOFT_PATH_TUBE_H
#define LOFT_PATH_TUBE_H

#include "path/path.h"    /* loft_path_place, loft_period */

LOFT_BEGIN_C

/* The pace of a knot. It begins as its place does: that is kept. */
typedef struct {
    loft_coord feed;
    uint16_t   number;
    bool       sharp, loose;
    int32_t    top;         /* the most that speed allows v2 to be, up to the next knot */
    int32_t    goal;        /* the most that all limits allow an even one, up to the next knot */
    int32_t    aim;         /* what v2 is moved to, at first: aim.h */
#if LOFT_PLAN_EFFORT < 2 && LOFT_AXES > 3
    loft_coord at[LOFT_AXES - 3];   /* the rest of a place, which is kept while there is a v2 */
#endif
    int32_t    v2;          /* control value of the squared pace, 2^-24: timing.h */
} loft_knot_pace;

/* A path is smoothed first, and then it is timed. With little effort both use the same memory:
 * `on` is known until a knot is placed, its `at` until the next one is; then it has a pace, and all
 * of it when the next but one is placed. So v2 lies behind `at`. The guess (guess.h) goes on with
 * the places. */
#if LOFT_PLAN_EFFORT > 1
typedef struct {
    loft_path_place on;     /* what is given */
    loft_knot_pace  pace;
} loft_knot_state;
#else
typedef union {
    loft_path_place on;
    loft_knot_pace  pace;
} loft_knot_state;
#endif

/* A knot of the path. Do not rely on the fields. */
typedef struct {
    loft_position   point;  /* control point of the path */
    loft_knot_state is;
} loft_knot;

/* The places of n knots from k on. */
static inline void loft_tube_places(const loft_knot knot[], unsigned k, unsigned n,
                                    const loft_path_place *at[])
{
    for (unsigned i = 0; i < n; i++)
        at[i] = &knot[k + i].is.on;
}

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

/* Smooth them; again, when others follow. Axes that may not pass their end values stay on their
 * side of them.
 *
 *   range   as loft_tube_measure
 *   cost    sweeps * (to - from) * LOFT_AXES * 7 products of 32 bits; more where it is a corner
 */
void loft_tube_smooth(const loft_period *period, loft_knot knot[], unsigned from, unsigned to,
                      int sweeps);

/* Where the path is, at the part z of the way from knot k to the next, 2^-30. */
void loft_tube_place(const loft_knot knot[], unsigned k, int32_t z, loft_position *out);

LOFT_END_C

#endif
