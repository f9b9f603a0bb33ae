/* lib/motion/plan.h -- look-ahead: curves become a chain of spans within the machine's
 * limits, while it moves
 * SPDX-License-Identifier: MIT
 *
 *     static loft_plan plan;
 *     static loft_move moves[8];
 *     static loft_knot knots[160];
 *     loft_span span;
 *
 *     if (loft_plan_init(&plan, &limits, moves, 8, knots, 160) == LOFT_OK)
 *         do {
 *             while (next < count && loft_plan_push(&plan, &curve[next]) == LOFT_OK)
 *                 next++;                     // LOFT_ERR_SPACE: again when spans are taken
 *             if (next == count)
 *                 loft_plan_end(&plan);
 *             while ((state = loft_plan_next(&plan, &span)) == LOFT_PLAN_SPAN)
 *                 send(&span);
 *         } while (next < count || state != LOFT_PLAN_REST);
 *
 * How it works: MOTION.md. What becomes of the spans, and what else may run in an interrupt:
 * span.h. A plan belongs to one context, the main loop: it may be interrupted anywhere, but no
 * interrupt may call it.
 */
#ifndef LOFT_MOTION_PLAN_H
#define LOFT_MOTION_PLAN_H

#include "motion/cruise.h" /* loft_cruise */
#include "motion/emit.h"   /* loft_emit   */
#include "motion/guess.h"  /* loft_guess  */

LOFT_BEGIN_C

/* The fewest knots. All but 52 of them look ahead, with effort 2 all but 40: each for a period, and
 * with effort 1 for up to 7/4 where no corner is near. More are faster. */
#define LOFT_PLAN_KNOTS_MIN 64

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_period period;
    loft_guess guess;
    loft_knot *knot;
    uint16_t room, count, loaded;
    uint16_t placed;                    /* control points before it never change */
    uint16_t timed;                     /* knots whose timing has begun */
    uint16_t sure;                      /* knots before which it never changes */
    uint16_t known, old;                /* while more are made: `loaded` and `timed` before */
    uint16_t near;                      /* how many before `old` are raised? */
    uint8_t stage, sweep, sweeps, part; /* of making them, */
    uint8_t refined;                    /* which has been done again so often */
    int32_t first;                      /* the pace of the first ones that are raised, before */
    int64_t time;                       /* and the time of all */
    bool ended;                         /* is the last knot the end of the chain? */
    loft_sample at;                     /* the last sample */
    uint32_t steps, step;               /* samples to the end, and which is next, once it is sure */
    uint16_t last;                      /* ticks of the last of these steps */
    bool even;                          /* are they all alike? */
    loft_time lag;                      /* by how much the steps are too long, all of them */
    loft_emit emit;
#if LOFT_FOLDS
    loft_cruise cruise; /* before a chain is planned */
#endif
    loft_vec to;     /* the end of the chain */
    uint16_t passed; /* curves behind the last span */
} loft_plan;

enum loft_plan_state {
    LOFT_PLAN_SPAN, /* here is a span                                               */
    LOFT_PLAN_WAIT, /* the next span depends on what comes: push more, or end       */
    LOFT_PLAN_REST, /* at rest, exactly on the last control point                   */
    LOFT_PLAN_BUSY  /* of loft_plan_part alone: not yet, call it again              */
};

/* Plan within `limits` (copied), in memory of the caller.
 *
 *   units   mm, mm/s, mm/s^2, mm/s^3
 *   range   as loft_limits_check; LOFT_ERR_SPACE for no move or less than LOFT_PLAN_KNOTS_MIN
 *           knots
 *   stack   Cortex-M4 160   Cortex-M0+ 244   ATmega328P 191
 */
enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, loft_move moves[],
                                uint16_t move_room, loft_knot knots[],
                                uint16_t knot_room) LOFT_CHECKED;

/* Append a curve (copied).
 *
 *   range   LOFT_ERR_ARG if it does not begin where the last one ended, or for a feed that is not
 *           positive; LOFT_ERR_RANGE for coordinates beyond LOFT_PLAN_REACH and feeds beyond those
 *           of limits.h; LOFT_ERR_SPACE while there is no room: take spans, then push again
 *   stack   Cortex-M4 500   Cortex-M0+ 560   ATmega328P 437
 */
enum loft_status loft_plan_push(loft_plan *plan, const loft_move *move) LOFT_CHECKED;

/* Nothing comes after what was pushed, or not in time: plan to stop there. Another push takes that
 * back, unless the stop has been reached by what is planned ahead. */
void loft_plan_end(loft_plan *plan);

/* The next span.
 *
 *   shape   each span begins exactly where the one before ended, with its velocity and
 *           acceleration, but for rounding: velocity jumps by up to 4 grains of 2^-16 mm in the
 *           shorter one's ticks; the first begins on the first control point, at rest; on
 *           slow runs, with full effort, acceleration jumps by up to a 128th of its limit
 *   error   speed, acceleration and jerk of each axis: the limits, exactly (f32: but for rounding);
 *           the path is within limits.tol; a feed of less than 6144 grains of 2^-16 mm in a span is
 *           exceeded by up to 6 of them, less a 1024th of it
 *   stack   Cortex-M4 2,048   Cortex-M0+ 2,452   ATmega328P 1,843
 */
enum loft_plan_state loft_plan_next(loft_plan *plan, loft_span *out);

/* The same, but with LOFT_PLAN_EFFORT 1 a call does a part of the work alone. LOFT_PLAN_BUSY: call
 * again.
 *
 *   error   as loft_plan_next
 *   cost    effort 1, 112 knots: Cortex-M4 0.9 million instructions at most, M0 1.9 million
 *   stack   Cortex-M4 2,032   Cortex-M0+ 2,436   ATmega328P 1,837
 */
enum loft_plan_state loft_plan_part(loft_plan *plan, loft_span *out);

/* Curves that can be pushed now. */
static inline uint16_t loft_plan_room(const loft_plan *plan)
{
    return loft_chain_room(&plan->guess.path.chain);
}

/* Curves that lie entirely behind the end of the last span, of all that were pushed, modulo 2^16.
 *
 *   error   it may be told a period late
 */
static inline uint16_t loft_plan_passed(const loft_plan *plan) { return plan->passed; }

LOFT_END_C

#endif
