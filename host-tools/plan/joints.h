/* host-tools/plan/joints.h -- a toolpath as the motors of a machine go it, and a plan of that
 * SPDX-License-Identifier: MIT
 *
 * Each move of the tool becomes one or more moves of the motors. Where the kinematics are a matrix
 * it is one, exactly; otherwise as many cubics as are needed, with the places and directions of the
 * true path at their ends, so that the tool is within `within` of it, and so short that the feed of
 * the motors that belongs to the tool's feed changes little along one; the least is taken.
 *
 * Plans need lengths that mean the same in all directions, so the motors are planned in units in
 * which a mm of the tool is as nearly as possible one length (`scale`). A tolerance for the motors
 * is that of the tool times the least such length, `least`: what the motors are off by is then, for
 * the tool, within its tolerance.
 */
#ifndef LOFT_JOINTS_H
#define LOFT_JOINTS_H

#include "read/drawing.h"        /* drawing */
#include "engine/kinematics.h"     /* kinematics */
#include "plan/toolpath.h"       /* toolpath */

typedef struct {
    const kinematics *k;            /* NULL: none was made */
    engine_move *move;              /* of the motors, in their own units; feed in planned units a
                                     * second */
    size_t *of;                     /* the tool's move that each is of */
    size_t count, room;
    double scale[ENGINE_AXES];      /* planned units in one of each motor */
    double least;                   /* planned units in a mm of the tool */
    double within;                  /* mm of the tolerance that are used up */
    bool   scaled;                  /* is any scale not 1? */
} joints;

typedef struct {
    const char *file;               /* for messages, and                                          */
    const drawing *d;               /* the lines where curves come from                           */
    double start[ENGINE_AXES];      /* where the motors stand                                     */
    double within;                  /* mm                                                         */
    double reach;                   /* of planned coordinates                                     */
    bool   chip;                    /* the machine plans: in its own units                        */
} joints_options;

/* Make *out of the path; a travel past a pole is led through it, which is added to the path. Gives
 * 0, or an exit code after one line. `k` and, while *out is in use, the path must stay. Free with
 * joints_free. */
int  joints_make(joints *out, toolpath *path, const kinematics *k, const joints_options *o);
void joints_free(joints *j);

/* The limits of the plan for limits of the motors, with tolerance and corner of the tool. */
engine_limits joints_limits(const joints *j, const engine_limits *motors);

/* A plan of it under way. */
typedef struct {
    const joints *j;
    const engine *e;
    engine_plan *plan;              /* NULL: none */
} joints_planning;

/* Begin to plan within limits of the motors, with tolerance and corner of the tool. `j` must stay
 * where it is. Gives enum loft_status; end it with joints_end in any case. */
int joints_plan(joints_planning *p, joints *j, const engine *e, const engine_limits *motors);

/* As engine_plans.step; the span is in the motors' own units. */
int joints_step(joints_planning *p, engine_span *out);

/* How many of the moves lie behind the end of the last span; it may be told a little late. */
size_t joints_passed(const joints_planning *p);

void joints_end(joints_planning *p);

#endif
