/* lib/motion/scope.h -- scope: which accelerations a piece of the path allows at which speed, where
 * jerk is not limited
 * SPDX-License-Identifier: MIT
 *
 * Along a piece that is passed with even acceleration a the square of the speed is a line, x + 2 a
 * s, which is told by its value x where the piece begins, and a. The pairs that hold the limits per
 * axis are a polygon; the scope of a piece is one inside of it.
 */
#ifndef LOFT_MOTION_SCOPE_H
#define LOFT_MOTION_SCOPE_H

#include "motion/profile.h" /* loft_plan_piece */

LOFT_BEGIN_C

/* Set the bounds of a piece of this length and shape. False if they change so much along it that it
 * should be halved.
 *
 *   range   feed LOFT_SPEED_MIN..LOFT_SPEED_MAX; the arc's length > 0
 *   error   acceleration per axis: 1/160 of the limit where the curvature is not the line between
 *           that of its ends
 *   cost    two quotients for each axis that moves, three roots, and about 40 products
 */
bool loft_scope_init(loft_plan_piece *p, const loft_budget *b, const loft_arc *arc,
                     const loft_arc_shape *shape, loft_real feed);

/* Set the bounds of a joint where the direction jumps from `before` to `after`: false if it is
 * none, with these feeds before and after it.
 *
 *   range   as loft_profile_join; `corner`: it is between curves, where a junction deviation holds
 */
bool loft_scope_join(loft_plan_piece *p, const loft_budget *b, const loft_vec *before,
                     const loft_vec *after, loft_acc spacing, bool corner, loft_real feed0,
                     loft_real feed1);

/* The largest acceleration with which a piece may be passed that begins with the square x of the
 * speed; less than 0 where it has to slow down. */
loft_real loft_scope_most(const loft_plan_piece *p, loft_acc x);

/* The largest square of the speed at its start from which the square `end` can be reached at its
 * end: the cap or more where it need not brake on all of it. */
loft_acc loft_scope_brake(const loft_plan_piece *p, loft_acc end);

LOFT_END_C

#endif
