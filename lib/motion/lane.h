/* lib/motion/lane.h -- lane: the known part of a path cut into cells, raised as far as it is known
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_LANE_H
#define LOFT_MOTION_LANE_H

#include "motion/raise.h"   /* loft_course, loft_raise */

LOFT_BEGIN_C

/* How the course is being cut into cells. Do not rely on the fields. */
typedef struct {
    bool      closed;           /* the path rests at the end of what is known */
    loft_ease ease;             /* the last joint that was eased, and */
    loft_acc  since;            /* how far behind it the last cell ends */
    loft_acc  run;              /* how far behind the last rest */
    loft_acc  left;             /* how far on only the part `grip` of the jerk may be used */
    loft_unit grip;
    loft_acc  gate;             /* of the next cell */
    loft_acc  last;             /* length of the last one */
    uint32_t  seen;             /* where the arc that is being cut ends, and */
    loft_acc  beyond;           /* how long the first cell behind it may be */
    bool      may_rest;         /* may the path rest at the end of the curve that is being cut? */
    bool      hop;              /* is the last one in a row that is passed at once? */
    bool      stop;             /* does it begin at rest? */
    unsigned  sure;             /* pieces whose speed has been raised */
} loft_lane;

/* An empty lane. */
void loft_lane_init(loft_lane *l);

/* Cut curves into cells while there is room. */
void loft_lane_load(loft_lane *l, loft_course *c);

/* The path rests at the end of what is known; pieces from `at` on may have begun. */
void loft_lane_close(loft_lane *l, loft_course *c);

/* Raise the speed of what was appended, and of what it allows before that; pieces before `begun`
 * have begun to move. */
void loft_lane_raise(loft_lane *l, loft_course *c, unsigned begun);

/* The first piece whose speed depends on what is appended. */
unsigned loft_lane_open(const loft_lane *l, const loft_course *c);

/* Drop the oldest pieces. */
void loft_lane_drop(loft_lane *l, loft_course *c, unsigned count);

LOFT_END_C

#endif
