/* host-tools/plan/trace.h -- analyses a plan while it is made: the motion at any time, and what
 * limits it, curve by curve
 * SPDX-License-Identifier: MIT
 *
 * The input is the chain of spans that the machine gets: cubics in time, evaluated in double. It
 * does not use the planner: it compares the limits with the motion of the machine. What is found is
 * given while it is planned, and only kept if it is asked for.
 */
#ifndef LOFT_TRACE_H
#define LOFT_TRACE_H

#include "engine/engine.h"  /* engine_span, engine_limits, engine_move */
#include "plan/causes.h"    /* trace_part */
#include "plan/joints.h"    /* joints */

struct host;                /* base/host.h */

typedef struct {
    /* of the motors, in mm, mm/s, mm/s^2, mm/s^3 */
    double x[ENGINE_AXES], v[ENGINE_AXES], a[ENGINE_AXES], j[ENGINE_AXES];
    kinematics_moving tool;
    double speed, along;            /* of the tool, along its path                       */
} trace_motion;

/* Where results go as they come. A function that is NULL is not called. */
typedef struct {
    void *context;
    /* a span, and the times of its begin and its end */
    void (*span)(void *context, const engine_span *s, double begin, double end);
    /* the part of move n; all moves in order */
    void (*part)(void *context, size_t n, const trace_part *p);
} trace_sink;

typedef struct {
    engine_limits limits;           /* of the motors; tolerance and corner of the tool   */
    const joints *joints;
    const engine_move *move;        /* of the tool                                       */
    size_t moves, count;            /* `count` spans */
    double seconds;
    /* if they are kept: */
    engine_span *span;
    double *begin;                  /* s; count + 1 of them                              */
    trace_part *part;               /* of each move                                      */
    size_t room;
} trace;

/* Plan and analyse; `keep` all spans and parts. Returns enum loft_status. `path` and `of`, which
 * was made from it, must outlive *t; free with trace_free. Shows a progress bar if it takes long.
 *
 *   memory  without `keep` it does not depend on the length of the path */
#define TRACE_STOPPED (-101)    /* by the host */
int trace_make(struct host *h, trace *t, const engine *e, const engine_limits *limits,
               const toolpath *path, joints *of, const trace_sink *sink, bool keep);
void trace_free(trace *t);

/* The motion at a time from 0 to t->seconds of a trace that was kept. *near is the span of the last
 * call, 0 at first. The second function gives that of a span, at a time from its begin to its end;
 * *t needs to have begun only. */
void trace_at(const trace *t, double seconds, size_t *near, trace_motion *out);
void trace_in(const trace *t, const engine_span *s, double begin, double end, double seconds,
              trace_motion *out);

/* Add a part to a sum of parts. */
void trace_add(trace_part *sum, const trace_part *p);

/* "feed 82 %, x jerk 18 %": the causes with the largest share of the time first, as many as
 * matter. */
void trace_words(const trace *t, const trace_part *p, char *out, size_t size);

#endif
