/* lib/motion/cut.h -- cut: curves become pieces of a course, and joints between them
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_CUT_H
#define LOFT_MOTION_CUT_H

#include "motion/course.h"  /* loft_course */

LOFT_BEGIN_C

/* Cut curves into pieces while there is room. */
void loft_cut_load(loft_course *c);

LOFT_END_C

#endif
