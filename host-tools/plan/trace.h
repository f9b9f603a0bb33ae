/* host-tools/plan/trace.h -- a finished plan looked at: motion at any time, and what held it back,
 * curve by curve
 * SPDX-License-Identifier: MIT
 *
 * What is looked at is the chain of spans as it goes to the machine: cubics in time, evaluated in
 * double. Nothing is taken from the planner: the limits that it was given are compared with what
 * the machine will do.
 *
 * At each moment the plan uses some part of each limit. The one that is used up is what held it
 * back then; the speed at which a corner or a stop is passed is held back by that. Where nothing is
 * used up (a limited jerk lets the acceleration go and come, before and behind a place that must be
 * passed slowly) it is the limit that was or will be, whichever is nearer in time.
 */
#ifndef LOFT_TRACE_H
#define LOFT_TRACE_H

#include "engine/engine.h"         /* engine_span, engine_limits, engine_move */
#include "plan/joints.h"         /* joints */

/* What holds a plan back; those of axes are three each, for x, y, z. */
enum trace_cause {
    TRACE_FEED,
    TRACE_SPEED,                    /* of an axis                                        */
    TRACE_ACCEL = TRACE_SPEED + 3,  /* of an axis, speeding up or slowing down           */
    TRACE_JERK  = TRACE_ACCEL + 3,  /* of an axis                                        */
    TRACE_CURVATURE = TRACE_JERK + 3,   /* acceleration of an axis across the path       */
    TRACE_CORNER,                   /* passed slowly                                     */
    TRACE_STOP,                     /* a corner or an end where it stands                */
    TRACE_CAUSES
};

typedef struct {
    /* of the motors, in mm, mm/s, mm/s^2, mm/s^3 */
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES], j[ENGINE_AXES];
    kinematics_moving tool;
    double speed, along;            /* of the tool, along its path                       */
} trace_motion;

/* A curve, or several of them. */
typedef struct {
    double length, seconds, top;    /* mm, s, mm/s                                       */
    double from;                    /* s: when it begins                                 */
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

/* Plan and look. Gives enum loft_status. `path` and `of`, which was made of it, must outlive it;
 * free with trace_free. Shows a bar where it takes long. */
int trace_make(trace *t, const engine *e, const engine_limits *limits, const toolpath *path,
               joints *of);
void trace_free(trace *t);

/* The motion at a time from 0 to t->seconds. *near is the span of the last call, 0 at first. */
void trace_at(const trace *t, double seconds, size_t *near, trace_motion *out);

/* Add a part to a sum of parts. */
void trace_add(trace_part *sum, const trace_part *p);

/* "feed 82 %, x jerk 18 %": what takes the most time first, as many as matter. */
void trace_words(const trace *t, const trace_part *p, char *out, size_t size);

#endif
