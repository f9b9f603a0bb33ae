/* lib/motion/waypoints.h -- move through given points, in two calls
 * SPDX-License-Identifier: MIT
 *
 *     static loft_natural_knot knots[COUNT];
 *     loft_waypoints way;
 *     loft_span span;
 *     if (loft_plan_init(&plan, ..) == LOFT_OK &&
 *         loft_waypoints_init(&way, &plan, points, COUNT, LOFT_REAL(50), knots) == LOFT_OK)
 *         while (loft_waypoints_next(&way, &span) == LOFT_PLAN_SPAN)
 *             ..                                  // walk it, or send it
 *
 * The path is the natural spline with the distances of the points as its knots (curve/natural.h):
 * it passes each point, and curvature does not jump. It may swing beyond the points. Joints of an
 * arm are axes as those of a machine are: a feed of LOFT_SPEED_MAX leaves the speed to the limits
 * of each.
 */
#ifndef LOFT_MOTION_WAYPOINTS_H
#define LOFT_MOTION_WAYPOINTS_H

#include "curve/natural.h"  /* loft_natural */
#include "motion/plan.h"    /* loft_plan    */

LOFT_BEGIN_C

/* The way from the first point to the last. Do not fill it yourself: call init. */
typedef struct {
    loft_natural spline;
    loft_plan *plan;
    loft_real feed;
    uint32_t next;              /* segment */
} loft_waypoints;

/* Prepare the way through p[0..count-1] in `plan`, which has nothing to do. Plan, points and memory
 * must outlive it.
 *
 *   units   mm, mm/s, or whatever the axes have
 *   range   as loft_natural_init; LOFT_ERR_ARG for a feed that is not positive; LOFT_ERR_RANGE
 *           where the spline leaves LOFT_PLAN_REACH, and for feeds beyond those of limits.h
 *   cost    that of loft_natural_init, and 4 points of each segment
 *   stack   Cortex-M4 416   Cortex-M0+ 540   ATmega328P 501
 */
enum loft_status loft_waypoints_init(loft_waypoints *w, loft_plan *plan, const loft_vec p[],
                                     uint32_t count, loft_real feed,
                                     loft_natural_knot memory[]) LOFT_CHECKED;

/* The next span: LOFT_PLAN_SPAN, or LOFT_PLAN_REST behind the last, exactly on the last point.
 *
 *   error   as loft_plan_next
 *   cost    as loft_plan_push of the segments that the plan has room for, and loft_plan_next
 *   stack   Cortex-M4 2,064   Cortex-M0+ 2,468   ATmega328P 1,851
 */
enum loft_plan_state loft_waypoints_next(loft_waypoints *w, loft_span *out);

LOFT_END_C

#endif
