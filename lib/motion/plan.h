/* lib/motion/plan.h -- look-ahead: a chain of curves becomes a chain of spans within the machine's limits
 * SPDX-License-Identifier: MIT
 *
 *     static loft_plan_node nodes[LOFT_PLAN_NODES(CURVES)];
 *     loft_plan plan;
 *     loft_span span;
 *     if (loft_plan_init(&plan, &limits, chain, CURVES, nodes, LOFT_PLAN_NODES(CURVES)) == LOFT_OK)
 *         while (loft_plan_next(&plan, &span))
 *             send(&span);
 *
 * The whole chain is looked at before the first span is given: speed anywhere is such that the machine can
 * still brake for whatever comes. All speeds are bounded along the real curves, so that it does not matter
 * into how many of them a path is cut.
 */
#ifndef LOFT_MOTION_PLAN_H
#define LOFT_MOTION_PLAN_H

#include "motion/course.h"  /* loft_course, loft_move, loft_plan_node, LOFT_PLAN_REACH */
#include "motion/span.h"    /* loft_span */

#define LOFT_PLAN_WINDOW 64 /* samples of the path that one span can see */

/* Nodes that any `count` curves need at most. */
#define LOFT_PLAN_NODES(count) ((count) * 8u + 1u)

/* Complete so that it can be static; do not rely on the fields. About 6 kB in q16. */
typedef struct {
    loft_course course;
    loft_acc    sample[LOFT_PLAN_WINDOW][LOFT_AXES];    /* a ring of control points, one per beat */
    loft_acc    speed[LOFT_AXES], accel[LOFT_AXES];     /* limits per beat and beat^2             */
    loft_vec    at;                                     /* the end of the last span               */
    uint8_t     first, held, ends;
} loft_plan;

/* Plan `chain` (borrowed until the last span) from rest to rest; `nodes` is the caller's memory,
 * LOFT_PLAN_NODES(count) of them.
 *
 *   units   mm, mm/s, mm/s^2
 *   range   as loft_limits_check and loft_course_init: LOFT_ERR_ARG for limits or feeds that are zero and for
 *           a chain that is empty or not connected; LOFT_ERR_RANGE for numbers beyond what is stated there;
 *           LOFT_ERR_SPACE for too few nodes
 *   cost    two passes over the chain: on a PC about 20 us per curve; 900 bytes of stack
 */
enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, const loft_move chain[], uint32_t count,
                                loft_plan_node nodes[], uint32_t node_count) LOFT_CHECKED;

/* The next span; false when the chain has ended (exactly on the last control point, at rest).
 *
 *   shape   each span begins exactly where the one before ended, with its velocity; the first begins on the
 *           first control point, at rest
 *   error   path: within limits.tol (f32: plus half an ulp of the coordinate)
 *           speed along the path and per axis: 1 % and 0.001 mm/s above the limit, for a moment
 *           acceleration per axis: within the limit (to 0.05 %), but where a corner may be passed faster
 *           (limits.corner > 0): there the change of velocity takes one beat, of 2 ms or one tick
 *           Rounding the control points adds 3 grains / duration of the span to the speed and 12 grains / duration^2
 *           to the acceleration, a grain being 2^-16 mm in q16 and 1 ulp in f32: it matters in short spans only
 *           time: at most 6 % and two beats above the least that the limits allow (measured)
 *   cost    on a PC about 0.3 us per millisecond of motion
 */
bool loft_plan_next(loft_plan *plan, loft_span *out);

#endif
