/* host-tools/plan/certify_plan.h -- a plan that is judged, and a worst value of it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CERTIFY_PLAN_H
#define LOFT_CERTIFY_PLAN_H

#include "engine/machine_kinematics.h"  /* kinematics, engine_span, engine_limits, engine_move */

/* A worst value and where it is: its time, or its move for certify.missed; its place. Of distances
 * it is the one that is the largest part of the tolerance there. */
typedef struct {
    double worst, seconds, at[ENGINE_AXES];
    double tol;                 /* mm; of distances */
    size_t move;
} certify_worst;

typedef struct {
    const kinematics *k;            /* of motors that a matrix maps */
    const engine_limits *limits;    /* of the motors */
    const engine_span *span;
    size_t spans;
    const engine_move *move;        /* of the drawing, for the tool */
    size_t moves;
    const engine_move *planned;     /* the same as it is planned: its corners count; NULL: `move` */
    size_t planned_moves;
    double tol, corner;             /* mm; near corners at least tol */
} certify_plan;

/* `corner` holds up to so many times itself along the drawing from a corner. */
#define CERTIFY_NEAR 32

#endif
