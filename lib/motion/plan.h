/* lib/motion/plan.h -- look-ahead: a chain of curves becomes a chain of spans within the machine's limits
 * SPDX-License-Identifier: MIT
 *
 *     static loft_plan_node nodes[LOFT_PLAN_NODES(CURVES)];
 *     loft_plan plan;
 *     loft_span span;
 *     if (loft_plan_init(&plan, &limits, chain, CURVES, nodes, LOFT_PLAN_NODES(CURVES)) == LOFT_OK)
 *         while (loft_plan_next(&plan, &span))
 *             send(&span);
 */
#ifndef LOFT_MOTION_PLAN_H
#define LOFT_MOTION_PLAN_H

#include "motion/course.h"  /* loft_course, loft_move, loft_plan_node, LOFT_PLAN_REACH */
#include "motion/span.h"    /* loft_span */

#define LOFT_PLAN_WINDOW 64 /* samples of the path that one span can see */

/* Nodes that any `count` curves need at most. */
#define LOFT_PLAN_NODES(count) ((count) * 8u + 1u)

/* Complete so that it can be static; do not rely on the fields. About 5 kB in q16. */
typedef struct {
    loft_course course;
    loft_acc    sample[LOFT_PLAN_WINDOW][LOFT_AXES];    /* a ring of control points, one per beat */
    loft_acc    accel[LOFT_AXES];                       /* limits per beat^2                      */
    loft_vec    at;                                     /* the end of the last span               */
    uint8_t     first, held, ends;
} loft_plan;

/* Plan `chain` (borrowed until the last span) from rest to rest; `nodes` is the caller's memory,
 * LOFT_PLAN_NODES(count) of them.
 *
 *   units   mm, mm/s, mm/s^2
 *   range   as loft_limits_check and loft_course_init
 *   cost    two passes over the chain; 600 bytes of stack
 *   see     grbl's planner for junction deviation; Marsden, Schoenberg for the spline's bounds
 */
enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, const loft_move chain[], uint32_t count,
                                loft_plan_node nodes[], uint32_t node_count) LOFT_CHECKED;

/* The next span; false when the chain has ended (exactly on the last control point, at rest). */
bool loft_plan_next(loft_plan *plan, loft_span *out);

#endif
