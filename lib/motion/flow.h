/* lib/motion/flow.h -- flow: the fastest motion with limited jerk along the known part of a path,
 * raised while it moves
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_FLOW_H
#define LOFT_MOTION_FLOW_H

#include "motion/lane.h"    /* loft_lane, loft_course */

LOFT_BEGIN_C

/* Pieces in rings that use it, 48 at least. A quarter of the ring is raised at once: on a small
 * chip that takes too long, and averaging (law.c) does with fewer. */
#ifndef LOFT_FLOW_PIECES
#  define LOFT_FLOW_PIECES 512
#endif

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_lane lane;
    unsigned  at;               /* the piece where it is, and */
    loft_acc  off;              /* how far on it */
    loft_acc  way;              /* of the last beat */
    loft_acc  time, whole;      /* beats since the piece began; that it takes */
    loft_acc  power[6];         /* the part of its length by the part of that time, powers of it */
    loft_acc  length;           /* of what is passed in that time: the piece, or its row */
    bool      moves;
} loft_flow;

enum loft_flow_state { LOFT_FLOW_RUNS, LOFT_FLOW_WAITS, LOFT_FLOW_RESTS };

/* Rest at the start of an empty course. */
void loft_flow_init(loft_flow *f);

/* Go on for one beat. */
enum loft_flow_state loft_flow_next(loft_flow *f, loft_course *c);

LOFT_END_C

#endif
