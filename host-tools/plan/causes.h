/* host-tools/plan/causes.h -- what limits a motion, moment by moment
 * SPDX-License-Identifier: MIT
 *
 * At each moment the plan uses some share of each limit. The limit that is used up is the cause at
 * that moment; near a corner or a stop, the corner or the stop is. If nothing is used up (limited
 * jerk makes the acceleration change gradually before and after a slow place), the cause is the
 * previous or the next one, whichever is closer in time.
 *
 * A window of moments moves along the motion; what has left it is summed up, move by move. So the
 * memory does not depend on the length of the motion.
 */
#ifndef LOFT_CAUSES_H
#define LOFT_CAUSES_H

#include "engine/engine.h"  /* engine_move */

/* What limits a plan; limits of axes are three each, for x, y, z. */
enum trace_cause {
    TRACE_FEED,
    TRACE_SPEED,                    /* of an axis                                        */
    TRACE_ACCEL = TRACE_SPEED + 3,  /* of an axis, speeding up or slowing down           */
    TRACE_JERK  = TRACE_ACCEL + 3,  /* of an axis                                        */
    TRACE_CURVATURE = TRACE_JERK + 3,   /* acceleration of an axis across the path       */
    TRACE_CORNER,                   /* passed slowly                                     */
    TRACE_STOP,                     /* a corner or an end with speed 0 */
    TRACE_CAUSES
};

/* A curve, or several curves. */
typedef struct {
    double length, seconds, top;    /* mm, s, mm/s                                       */
    double from;                    /* s: its begin */
    double share[TRACE_CAUSES];     /* seconds                                           */
} trace_part;

/* A short time. */
typedef struct {
    float seconds, speed;           /* the smallest speed in it */
    uint32_t move;
    uint8_t cause;                  /* TRACE_CAUSES: none    */
} causes_moment;

typedef struct {
    trace_part part;
    double feed;
    bool corner;                    /* between the move before and this one */
} causes_move;

/* Called for each move in order, when all of its time is known. */
typedef void causes_done(void *context, size_t move, const trace_part *part);

typedef struct {
    causes_done *done;
    void *context;
    causes_moment *moment;          /* numbers low .. count - 1 */
    size_t low, count, room;
    size_t looked;                  /* corners are found before this one */
    size_t limit;                   /* the last moment before `low` at a limit; SIZE_MAX: none, */
    uint8_t limit_cause;            /* and that limit */
    causes_move *move;              /* numbers first .. moves - 1 */
    size_t first, moves, move_room;
    engine_move last;               /* the last of them */
} causes;

void causes_start(causes *c, causes_done *done, void *context);
void causes_free(causes *c);

/* The next move of the path. */
void causes_add_move(causes *c, const engine_move *move, double length);

/* The next moment; its move has been added. The second function gives the sums of its move. */
void causes_add(causes *c, const causes_moment *now);
trace_part *causes_part(causes *c, size_t move);

/* The motion is over. */
void causes_finish(causes *c);

#endif
