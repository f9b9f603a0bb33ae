/* tests/support/motion_trajectory.h -- the yardsticks of motion_any.h, for lib/motion/trajectory.h
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_TRAJECTORY_H
#define LOFT_TESTS_MOTION_TRAJECTORY_H

#include "motion/plan.h"        /* loft_plan, of which the names are taken below */
#include "motion/trajectory.h"  /* loft_trajectory */

/* With rings of pieces that are too small for it, it has the fewest knots. */
static inline enum loft_status trajectory_init(loft_trajectory *t, const loft_limits *limits,
                                               loft_move moves[], uint16_t room, loft_knot knots[],
                                               uint16_t knot_room)
{
    const uint16_t most = knot_room < 400 ? knot_room : 400;
    return loft_trajectory_init(t, limits, moves, room, knots,
                                most < LOFT_TRAJECTORY_KNOTS_MIN ? LOFT_TRAJECTORY_KNOTS_MIN
                                                                 : most);
}

#undef loft_plan_init
#undef loft_plan_push
#undef loft_plan_end
#undef loft_plan_next
#define loft_plan       loft_trajectory
#define loft_plan_piece loft_knot
#define loft_plan_init  trajectory_init
#define loft_plan_push  loft_trajectory_push
#define loft_plan_end   loft_trajectory_end
#define loft_plan_next  (enum loft_plan_state)loft_trajectory_next

/* Its spans are exact: no part of a limit is left to rounding. */
#define GRAIN_OF(size) BY_NUM(0, ((size) + 1) * 0x1p-23, 0)
#define JUMP_GRAINS(g) (12 * 0x1p-16 + 12 * (g))

#include "support/motion_any.h" /* check_case */

#endif
