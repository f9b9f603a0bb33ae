/* host-tools/plan/joints.h -- a toolpath as a path of the motors, and a plan of it
 * SPDX-License-Identifier: MIT
 *
 * Each move of the tool becomes one or more moves of the motors. If the kinematics are a matrix it
 * is exactly one. Otherwise it is as many cubics as needed, with the positions and directions of
 * the true path at their ends. They keep the tool within `within` of the path. They are so short
 * that the motors' feed for the tool's feed changes little along each; the smallest is used.
 *
 * Plans need lengths that mean the same in all directions. So the motors are planned in units in
 * which a mm of the tool has as nearly as possible one length (`scale`). A tolerance for the motors
 * is that of the tool times the smallest such length, `least`: then an error of the motors within
 * it keeps the tool within its own tolerance.
 */
#ifndef LOFT_JOINTS_H
#define LOFT_JOINTS_H

#include "read/drawing.h"       /* drawing */
#include "engine/machine_kinematics.h"  /* kinematics */
#include "plan/certify_along.h" /* certify_along */
#include "plan/toolpath.h"      /* toolpath */

struct host;                /* base/host.h */

typedef struct {
    const kinematics *k;            /* NULL: not made */
    engine_move *move;              /* of the motors, in their own units; feed in planned units per
                                     * second */
    size_t *of;                     /* the tool's move of each */
    size_t count, room;
    const toolpath *path;           /* its events are those of the job */
    double scale[ENGINE_AXES];      /* planned units per unit of each motor */
    double least;                   /* planned units per mm of the tool */
    double within;                  /* mm of the tolerance that are used up */
    bool   scaled;                  /* some scale is not 1 */
} joints;

typedef struct {
    const char *file;               /* for messages, and */
    const drawing *d;               /* the lines of its curves */
    double start[ENGINE_AXES];      /* positions of the motors */
    double within;                  /* mm                                                         */
    double reach;                   /* limit of planned coordinates */
    bool   chip;                    /* the machine plans, in its own units */
} joints_options;

/* Convert the path to *out. A travel that passes the pole is led through it, which adds moves to
 * the path. Returns 0, or an exit code after printing one line. `k` and the path must outlive *out.
 * Free with joints_free. */
int joints_make(struct host *h, joints *out, toolpath *path, const kinematics *k,
                const joints_options *o);
void joints_free(joints *j);

/* Convert limits of the motors, with tolerance and corner of the tool, to limits of the plan. */
engine_limits joints_limits(const joints *j, const engine_limits *motors);

/* A plan of the path in progress. */
typedef struct {
    const joints *j;
    const engine *e;
    engine_plan *plan;              /* NULL: none */
    size_t first, count;
    certify_along *along;           /* judges each span; NULL: none is judged */
    bool holds;                     /* all is within its bounds so far */
} joints_planning;

/* Begin to plan moves first .. end - 1, from rest to rest, within limits of the motors, with
 * tolerance and corner of the tool. `j` must not move. Returns enum loft_status; call joints_end in
 * any case. */
int joints_plan(joints_planning *p, joints *j, size_t first, size_t end, const engine *e,
                const engine_limits *motors);

/* Judge each span of the plan that has begun, as it is planned; *p must not move. `motors` are as
 * above. */
void joints_certify(joints_planning *p, certify_along *along, const engine_limits *motors);

/* The first move of the motors that is, or is behind, the tool's move number `move`. */
size_t joints_from(const joints *j, size_t move);

/* As engine_plans.step; the span is in the motors' own units. */
int joints_step(joints_planning *p, engine_span *out);

/* The number of moves, from the first of all on, that end at or before the end of the last span; it
 * may lag a little. */
size_t joints_passed(const joints_planning *p);

void joints_end(joints_planning *p);

#endif
