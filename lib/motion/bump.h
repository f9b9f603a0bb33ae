/* lib/motion/bump.h -- how much of a change of the squared pace all limits allow, between two knots
 * SPDX-License-Identifier: MIT
 *
 * Numbers of 32 bits alone: timing asks for that some hundred times for each knot.
 */
#ifndef LOFT_MOTION_BUMP_H
#define LOFT_MOTION_BUMP_H

#include "motion/timing.h"  /* loft_knot, LOFT_V2_MAX */

LOFT_BEGIN_C

#define LOFT_BUMP_ONE ((int32_t)1 << 15)    /* all of a change */

/* The part of `add` that may be added to v2[k .. k + 2], at most LOFT_BUMP_ONE: speed, acceleration
 * and jerk are held at knot k, at the next one and in the middle, with `share` 64ths of
 * acceleration and jerk, if they are before; speed at knot k is not asked for.
 *
 *   range   0 <= add, v2 < 2^29; knots k - 1 .. k + 2
 *   error   the part is less by 2^-9 of the limits, and by what a tangent of 1 / sqrt is too low
 *   cost    11 products of 32 and 16 bits for each axis, and some 20; for what does not fit 11 more
 *           and a division
 */
int32_t loft_bump_part(const loft_period *period, const loft_knot knot[], unsigned k, int share,
                       const int32_t add[3]);

LOFT_END_C

#endif
