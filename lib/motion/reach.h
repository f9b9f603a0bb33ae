/* lib/motion/reach.h -- reach: the fastest motion along a course from which it can still stop,
 * where jerk is not limited
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_REACH_H
#define LOFT_MOTION_REACH_H

#include "motion/law.h"     /* loft_law */

LOFT_BEGIN_C

/* Go on for one beat, as loft_law_next does.
 *
 *   cost    a division and two products per beat; per piece about eight divisions and three roots
 */
enum loft_law_state loft_reach_next(loft_law *law);

LOFT_END_C

#endif
