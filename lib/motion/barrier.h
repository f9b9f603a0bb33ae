/* lib/motion/barrier.h -- the least time along a path, nearly: what a plan is guessed from
 * SPDX-License-Identifier: MIT
 *
 * Speed, acceleration and jerk of each axis are kept from their limits by a barrier, which is made
 * steeper from step to step. A step is one of Newton's method for all knots at once.
 */
#ifndef LOFT_MOTION_BARRIER_H
#define LOFT_MOTION_BARRIER_H

#include "motion/timing.h"  /* loft_knot */

LOFT_BEGIN_C

#define LOFT_BARRIER_KNOTS 80
#define LOFT_BARRIER_FASTEST (2 * LOFT_V2_ONE)

/* Set the pace v2[1 .. count - 1], which may be any at both ends. The first `tied` knots keep
 * theirs, and the others follow them as far as limits allow; so do they the pace 1 at an `open`
 * end.
 *
 *   range   count <= LOFT_BARRIER_KNOTS, loaded by loft_timing_load
 *   error   a guess: between the places that are looked at, limits are exceeded by up to 3/10; 8
 *           steps take at most 1.1 times as long as 40
 *   cost    steps * count * about 130 products for each axis that moves
 */
void loft_barrier_time(const loft_period *period, loft_knot knot[], unsigned count, unsigned tied,
                       bool open, int steps);

LOFT_END_C

#endif
