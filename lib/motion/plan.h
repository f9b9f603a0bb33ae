/* lib/motion/plan.h -- look-ahead: curves become a chain of spans within the machine's limits,
 * while it moves
 * SPDX-License-Identifier: MIT
 *
 *     static loft_plan plan;
 *     static loft_move moves[8];
 *     static loft_plan_piece pieces[8 * LOFT_PLAN_PIECES];
 *     loft_span span;
 *
 *     loft_plan_init(&plan, &limits, moves, 8, pieces, 8 * LOFT_PLAN_PIECES);
 *     for (;;) {
 *         while (another curve is at hand && loft_plan_push(&plan, curve) == LOFT_OK)
 *             take the next curve;
 *         if (there is no other)
 *             loft_plan_end(&plan);
 *         while (loft_plan_next(&plan, &span) == LOFT_PLAN_SPAN)
 *             send(&span);
 *     }
 *
 * What becomes of the spans, and what else may run in an interrupt: span.h. A plan belongs to one
 * context, the main loop: it may be interrupted anywhere, but no interrupt may call it. Its memory:
 * loft_plan (2,576 bytes; with LOFT_PLAN_WINDOW 4 and LOFT_PLAN_FILTER 1 488; three axes, q16), 52
 * bytes a curve, 304 a piece, 72 where LOFT_PLAN_FLOW is 0, 56 where LOFT_PLAN_FILTER is 1. On a
 * Cortex-M4 the dearest call takes 1.2 million instructions, on an M0 4.4 million (make
 * bench-motion: the mean of them): let the queue behind it last for that.
 *
 * Speed anywhere is such that the machine can still stop on the path that is known. It is bounded
 * along the real curves, so that it does not matter into how many of them a path is cut.
 */
#ifndef LOFT_MOTION_PLAN_H
#define LOFT_MOTION_PLAN_H

#include "motion/law.h"     /* loft_law, loft_move, loft_plan_piece, LOFT_PLAN_REACH */
#include "motion/span.h"    /* loft_span */

LOFT_BEGIN_C

/* Pieces that a curve of a drawing usually needs; 16 where jerk is limited, for all of them to be
 * seen. Below LOFT_FLOW_PIECES in all, motion with limited jerk takes up to half as long again. */
#define LOFT_PLAN_PIECES 8

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_law law;
    loft_arc arc;                                       /* the piece that is sampled */
    uint32_t from;
    uint16_t number;
    bool     cut;                                       /* does `arc` belong to them? */
    bool     begun;
    loft_vec at;                                        /* the end of the last span */
#if LOFT_PLAN_WINDOW == 4
    loft_acc point[LOFT_AXES], leg[LOFT_AXES];          /* the last control point, from the one
                                                         * before */
    uint16_t behind[3];                                 /* curves that the last three have left
                                                         * behind */
    uint8_t  still;                                     /* how many of them have been on the end */
#else
    loft_acc sample[LOFT_PLAN_WINDOW][LOFT_AXES];       /* a ring of control points, one per beat */
    uint16_t behind[LOFT_PLAN_WINDOW];                  /* curves that each of them has left
                                                         * behind */
    uint8_t  first, held;
    /* limits per beat, beat^2, beat^3 */
    loft_acc speed[LOFT_AXES], accel[LOFT_AXES], jerk[LOFT_AXES];
    loft_acc slack;                                     /* of the speed, mm per beat */
#endif
#if LOFT_PLAN_FILTER > 1
    loft_ease eased;                                    /* the last joint that was, and */
    loft_acc past;                                      /* how far behind it the samples are */
#endif
} loft_plan;

enum loft_plan_state {
    LOFT_PLAN_SPAN,     /* here is a span                                               */
    LOFT_PLAN_WAIT,     /* the next span depends on what comes: push more, or end       */
    LOFT_PLAN_REST      /* at rest, exactly on the last control point                   */
};

/* Plan within `limits` (copied), in memory of the caller.
 *
 *   units   mm, mm/s, mm/s^2, mm/s^3
 *   range   as loft_limits_check; LOFT_ERR_SPACE for no move or less than 3 pieces
 */
enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, loft_move moves[],
                                uint16_t move_room, loft_plan_piece pieces[],
                                uint16_t piece_room) LOFT_CHECKED;

/* Append a curve (copied).
 *
 *   range   LOFT_ERR_ARG if it does not begin where the last one ended, or for a feed that is not
 *           positive; LOFT_ERR_RANGE for coordinates beyond LOFT_PLAN_REACH and feeds beyond those
 *           of limits.h; LOFT_ERR_SPACE while there is no room: take spans, then push again
 *   cost    about 8 pieces: on a PC 20 us
 */
enum loft_status loft_plan_push(loft_plan *plan, const loft_move *move) LOFT_CHECKED;

/* Nothing comes after what was pushed, or not in time: plan to stop there. Another push takes that
 * back. */
void loft_plan_end(loft_plan *plan);

/* The next span.
 *
 *   shape   each span begins exactly where the one before ended, with its velocity (and, where jerk
 *           is limited, its acceleration); the first begins on the first control point, at rest
 *   error   path: within limits.tol (f32: plus half an ulp of the coordinate) speed along the path
 *           and per axis: 0.1 % and 0.001 mm/s above the limit acceleration per axis: 1 %, but,
 *           jerk not limited, where a corner may be passed faster (limits.corner > 0): there the
 *           change of velocity takes two beats, of 2 ms or one tick, as a deviation at a junction
 *           means limits.max_across > 0: along and across the path 1 % of both, and, where the path
 *           turns by w radians in a beat, w / 2 of the other jerk per axis: 2 % Rounding the
 *           control points adds 3 grains / duration of the span to the speed, 12 grains /
 *           duration^2 to the acceleration and 24 grains / duration^3 to the jerk, half a grain
 *           being 2^-17 mm in q16 and 1/2 ulp in f32
 *   cost    on a PC about 0.3 us per millisecond of motion
 */
enum loft_plan_state loft_plan_next(loft_plan *plan, loft_span *out);

/* Curves that can be pushed now. */
static inline uint16_t loft_plan_room(const loft_plan *plan)
{
    return (uint16_t)(plan->law.course.move_room - plan->law.course.move_count);
}

/* Curves that lie entirely behind the end of the last span, of all that were pushed, modulo 2^16.
 *
 *   error   it may be told a beat late */
static inline uint16_t loft_plan_passed(const loft_plan *plan)
{
#if LOFT_PLAN_WINDOW == 4
    return plan->behind[0];
#else
    return plan->held > 0 ? plan->behind[plan->first] : 0;
#endif
}

LOFT_END_C

#endif
