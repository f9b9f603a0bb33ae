/* lib/motion/profile.h -- profile: how fast a piece of the path may be passed, and with which
 * acceleration, where jerk is limited
 * SPDX-License-Identifier: MIT
 *
 * The limits per axis of speed, acceleration and jerk become a cap of the speed, and bounds of the
 * acceleration along the path: for speeding up and for slowing down two straight lines in the
 * square of the speed, which meet at a knee. Where jerk is not limited it is scope.h that sets a
 * piece.
 */
#ifndef LOFT_MOTION_PROFILE_H
#define LOFT_MOTION_PROFILE_H

#include "motion/cell.h"    /* loft_plan_cell, loft_ease */

LOFT_BEGIN_C

/* A piece of the path, or, of no length, a joint. */
typedef struct {
    loft_unit length;           /* mm */
    loft_real cap;              /* the speed on it, mm/s; jerk not limited: at its start */
    loft_real last, far;        /* jerk not limited: the speed at its end; of the end of the
                                 * bounds */
    loft_real rest;             /* the acceleration along it, from rest and to rest, mm/s^2 */
    loft_real fore[2], back[2]; /* at the knee and at cap: speeding up, slowing down */
    loft_real brake;            /* the speed at its start that all that follows allows, mm/s */
    uint32_t  from, to;         /* the curve's parameters at its ends */
    uint16_t  move;             /* its curve */
    uint8_t   fore_knee, back_knee; /* jerk not limited: in 256ths of far^2 (limited: at 3/4 of
                                     * cap^2) */
    unsigned  flows : 1;        /* jerk not limited: at the cap all along it */
    unsigned  stop : 1;         /* the path rests at its start */
    unsigned  sure : 1;         /* what comes later will not change `brake` */
    unsigned  chord : 1;        /* it is walked evenly */
    unsigned  hop : 1;          /* it is passed as slowly as its row is short */
#if LOFT_PLAN_FILTER > 1
    loft_ease ease;             /* of a joint */
#endif
#if LOFT_PLAN_FLOW
    loft_plan_cell cell;             /* where jerk is limited */
#endif
} loft_plan_piece;

/* Where the path is heading: its direction and curvature vector; where jerk can be limited, at the
 * speed `cap` the part `twist` of it is used. */
typedef struct {
    loft_vec  along, bend;
#if LOFT_PLAN_FILTER > 1
    loft_real cap;
    loft_unit twist;
#endif
} loft_way;

/* What lies beside a joint on one side of it, as far as it may be eased: the way at the joint, with
 * the cap and the twist that use most of the jerk, and the least and the largest of directions and
 * curvatures per axis. */
typedef struct {
    loft_way way;
    loft_vec along[2], bend[2];
} loft_flank;

/* Set the bounds of a piece of this length and shape. False if they change so much along it that it
 * should be halved.
 *
 *   range   feed LOFT_SPEED_MIN..LOFT_SPEED_MAX; the arc's length > 0
 */
bool loft_profile_init(loft_plan_piece *p, const loft_budget *b, const loft_arc *arc,
                       const loft_arc_shape *shape, loft_real feed);

/* The way at station k (0 start, 1 middle, 2 end) of a piece. */
loft_way loft_profile_way(const loft_plan_piece *p, const loft_budget *b,
                          const loft_arc_shape *shape, int k);

/* The side of a joint where the path has this way, and nothing else yet. */
void loft_flank_init(loft_flank *side, const loft_way *way);

/* Take in a piece of this shape. */
void loft_flank_add(loft_flank *side, const loft_plan_piece *p, const loft_budget *b,
                    const loft_arc_shape *shape);

/* Set the bounds of a joint whose next such is `spacing` away: false if it is none, with this feed.
 * It may be eased over `room` on both sides of it, at most LOFT_EASE_MAX. Where it is, they hold
 * once all pieces within its width are added to the sides, on which it does not depend how far it
 * is eased.
 *
 *   range   as loft_profile_init; directions of length 1
 */
bool loft_profile_join(loft_plan_piece *p, const loft_budget *b, const loft_flank *before,
                       const loft_flank *after, loft_acc spacing, loft_acc room, loft_real feed);

/* The most that the square of the speed may be where the curvature jumps, so that three quarters of
 * the jerk are used; another such place is `spacing` away. */
loft_acc loft_profile_jump(const loft_budget *b, const loft_way *before, const loft_way *after,
                           loft_acc spacing, loft_real feed);

/* The acceleration along the path at the square x of the speed, mm/s^2; `fore`: speeding up.
 *
 *   error   q16: 2 LSB
 */
loft_real loft_profile_grip(const loft_plan_piece *p, loft_acc x, bool fore);

LOFT_END_C

#endif
