/* host-tools/plan/trace.h -- analyses a finished plan: the motion at any time, and what limits it,
 * curve by curve
 * SPDX-License-Identifier: MIT
 *
 * The input is the chain of spans that the machine gets: cubics in time, evaluated in double. It
 * does not use the planner: it compares the limits with the motion of the machine.
 *
 * At each moment the plan uses some share of each limit. The limit that is used up is the cause at
 * that moment; near a corner or a stop, the corner or the stop is. If nothing is used up (limited
 * jerk makes the acceleration change gradually before and after a slow place), the cause is the
 * previous or the next one, whichever is closer in time.
 */
#ifndef LOFT_TRACE_H
#define LOFT_TRACE_H

#include "engine/engine.h"  /* engine_span, engine_limits, engine_move */
#include "plan/joints.h"    /* joints */

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

typedef struct {
    /* of the motors, in mm, mm/s, mm/s^2, mm/s^3 */
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES], j[ENGINE_AXES];
    kinematics_moving tool;
    double speed, along;            /* of the tool, along its path                       */
} trace_motion;

/* A curve, or several curves. */
typedef struct {
    double length, seconds, top;    /* mm, s, mm/s                                       */
    double from;                    /* s: its begin */
    double share[TRACE_CAUSES];     /* seconds                                           */
} trace_part;

typedef struct {
    engine_limits limits;           /* of the motors; tolerance and corner of the tool   */
    const joints *joints;
    const engine_move *move;        /* of the tool                                       */
    size_t moves;
    engine_span *span;
    double *begin;                  /* s; count + 1 of them                              */
    size_t count, room;
    double seconds;
    trace_part *part;               /* of each move                                      */
} trace;

/* Plan and analyse. Returns enum loft_status. `path` and `of`, which was made from it, must outlive
 * *t; free with trace_free. Shows a progress bar if it takes long. */
int trace_make(trace *t, const engine *e, const engine_limits *limits, const toolpath *path,
               joints *of);
void trace_free(trace *t);

/* The motion at a time from 0 to t->seconds. *near is the span of the last call, 0 at first. */
void trace_at(const trace *t, double seconds, size_t *near, trace_motion *out);

/* Add a part to a sum of parts. */
void trace_add(trace_part *sum, const trace_part *p);

/* "feed 82 %, x jerk 18 %": the causes with the largest share of the time first, as many as
 * matter. */
void trace_words(const trace *t, const trace_part *p, char *out, size_t size);

#endif
