/* lib/motion/aim.h -- a pace that is nearly the fastest, in one pass from the end and one back
 * SPDX-License-Identifier: MIT
 *
 * What has just been loaded creeps. Bumps would raise a ramp that is longer than they are by
 * little in each sweep: so all of it is moved at once, as far as limits allow, to a pace that is
 * the fastest but for what is left out. Bumps do the rest.
 */
#ifndef LOFT_MOTION_AIM_H
#define LOFT_MOTION_AIM_H

#include "motion/timing.h"  /* loft_timing */

LOFT_BEGIN_C

/* Raise v2[from .. to - 1] towards such a pace; all limits stay held.
 *
 *   cost    to - from knots at most: 6 divisions of 32 bits for each axis and about 3 calls of
 *           loft_bump_part for each
 */
void loft_aim_raise(const loft_timing *timing);

LOFT_END_C

#endif
