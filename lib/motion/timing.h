/* lib/motion/timing.h -- timing: how fast a path is passed, within speed, acceleration and jerk of
 * each axis
 * SPDX-License-Identifier: MIT
 *
 * Let u count the knots of the path. Its squared pace, (du / dt)^2 with t in periods, is a
 * quadratic B-spline: v2[k] / 2 + v2[k+1] / 2 at knot k. It is raised by bumps, each as far as all
 * limits allow, so that it may be used after any of them.
 */
#ifndef LOFT_MOTION_TIMING_H
#define LOFT_MOTION_TIMING_H

#include "path/tube.h"    /* loft_knot, loft_period */

LOFT_BEGIN_C

#define LOFT_V2_ONE   ((int32_t)1 << 24)
#define LOFT_V2_MIN   ((int32_t)1 << 10)
#define LOFT_V2_MAX   ((int32_t)1 << 29)

/* Set the most that speed allows between knots from..to - 1 and the next ones. */
void loft_timing_load(const loft_period *period, loft_knot knot[], unsigned from, unsigned to);

/* Are all limits held between knot k and the next, with `share` 64ths of acceleration and jerk?
 *
 *   range   knots k - 1 .. k + 2
 */
bool loft_timing_holds(const loft_period *period, const loft_knot knot[], unsigned k, int share);

/* The squared pace with which all limits are held between knot k and the next, if it is even. */
int32_t loft_timing_even(const loft_period *period, const loft_knot knot[], unsigned k);

/* The least of these from the second knot to the last but two: an even pace for all of them. */
int32_t loft_timing_least(const loft_knot knot[], unsigned count);

/* What may be raised: v2[from .. to - 1]. Limits are held between knots before `end` and the next
 * ones; `open`: the path goes on behind it. */
typedef struct {
    const loft_period *period;
    loft_knot         *knot;
    unsigned           from, to, end;
    bool               open;
} loft_timing;

/* The 64ths of acceleration and jerk that are used between knot k and the next: towards an open end
 * little, so that what comes later can still raise it. */
int loft_timing_share(const loft_timing *timing, unsigned k);

/* Are all limits held from knot `from` to knot `to`, as far as they may be used? */
bool loft_timing_all_hold(const loft_timing *timing, unsigned from, unsigned to);

/* Raise v2[from .. to - 1] at once towards a pace that is nearly the fastest; all limits stay held.
 * Bumps would raise a ramp that is longer than they are by little in each sweep: they do what this
 * leaves out.
 *
 *   cost    to - from knots at most: 6 divisions of 32 bits for each axis and about 3 calls of
 *           loft_bump_part for each
 */
void loft_timing_aim(const loft_timing *timing);

#define LOFT_TIMING_PARTS 5

/* Raise by bumps of one of the widths, 0 .. LOFT_TIMING_PARTS - 1; `shift` moves them. */
void loft_timing_raise_part(const loft_timing *timing, unsigned shift, unsigned part);

/* The time from knot k to the next, 2^-16 periods. */
int32_t loft_timing_time(const loft_knot knot[], unsigned k);

LOFT_END_C

#endif
