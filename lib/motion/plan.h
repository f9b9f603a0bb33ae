/* lib/motion/plan.h -- look-ahead: a chain of curves becomes a chain of spans within the machine's limits
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_PLAN_H
#define LOFT_MOTION_PLAN_H

#include "motion/span.h"    /* loft_span */

/* What the machine can do. Coordinates of the path must be within +-LOFT_PLAN_REACH mm. */
#define LOFT_PLAN_REACH LOFT_REAL(8191)

typedef struct {
    loft_real max_speed[LOFT_AXES];     /* mm/s                                                     */
    loft_real max_accel[LOFT_AXES];     /* mm/s^2                                                   */
    loft_real corner;                   /* junction deviation in mm, as grbl's $11; 0: stop at corners */
    loft_real tol;                      /* how far spans may leave the path, rounding included, mm  */
    uint16_t  tick_hz;                  /* ticks per second                                         */
} loft_limits;

/* One curve of the chain, with its speed along the path in mm/s. */
typedef struct {
    loft_cubic curve;
    loft_real  feed;
} loft_move;

/* (draft: the fields of node and plan are the author's; the calls are fixed) */
typedef struct {
    loft_acc length;
    loft_real speed;
} loft_plan_node;

typedef struct {
    const loft_move *chain;
    uint32_t count;
} loft_plan;

enum loft_status loft_limits_check(const loft_limits *limits) LOFT_CHECKED;

/* Plan `chain` (borrowed, connected: each curve starts where the one before ended) from rest to rest.
 * `nodes` is the caller's memory, LOFT_PLAN_NODES(count) of them. */
#define LOFT_PLAN_NODES(count) ((count) * 8u + 1u)
enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, const loft_move chain[], uint32_t count,
                                loft_plan_node nodes[], uint32_t node_count) LOFT_CHECKED;

/* The next span; false when the chain has ended (exactly on the last control point, at rest). */
bool loft_plan_next(loft_plan *plan, loft_span *out);

#endif
