/* lib/motion/course.h -- course: a chain of curves and how fast each place of it is passed, as a point per beat
 * SPDX-License-Identifier: MIT
 *
 * The look-ahead covers the whole chain. What it remembers is the speed at a few nodes; between them it is
 * computed again when the course gets there, so that long drawings need little memory.
 */
#ifndef LOFT_MOTION_COURSE_H
#define LOFT_MOTION_COURSE_H

#include "motion/profile.h" /* loft_piece, loft_phase */

#define LOFT_COURSE_PIECES 32   /* pieces between two nodes, at most */

/* Coordinates of the path must be within +-LOFT_PLAN_REACH mm. */
#define LOFT_PLAN_REACH LOFT_REAL(8191)

/* One curve of the chain, with its speed along the path in mm/s. */
typedef struct {
    loft_cubic curve;
    loft_real  feed;
} loft_move;

/* A place of the path where pieces begin. Do not rely on the fields. */
typedef struct {
    loft_acc speed2;            /* the square of the largest speed there */
    uint32_t curve, from;
} loft_plan_node;

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_budget      budget;
    const loft_move *chain;
    loft_plan_node  *nodes;
    uint32_t         count, node_count;
    uint32_t   node;                        /* the one whose pieces are in the table       */
    loft_arc   whole, arc;                  /* its curve, and the part being walked        */
    loft_piece table[LOFT_COURSE_PIECES];
    loft_phase phase[LOFT_PHASES_MAX];
    loft_acc   end;                         /* the square of the speed after the table     */
    loft_acc   passed, done;                /* length of the phases passed; of the present */
    uint8_t    pieces, piece, phases, now;
    bool       over;
} loft_course;

/* Prepare to run through `chain` (borrowed) from rest to rest; `nodes` is the caller's memory.
 *
 *   range   a connected chain (each curve starts where the one before ended) of at least one curve, otherwise
 *           LOFT_ERR_ARG; coordinates within +-LOFT_PLAN_REACH, feeds LOFT_SPEED_MIN..LOFT_SPEED_MAX,
 *           otherwise LOFT_ERR_RANGE (a feed of 0 or less: LOFT_ERR_ARG); LOFT_ERR_SPACE for too few nodes
 *   cost    two passes over the chain, about 15 arcs per curve each
 */
enum loft_status loft_course_init(loft_course *c, const loft_budget *budget, const loft_move chain[], uint32_t count,
                                  loft_plan_node nodes[], uint32_t node_count) LOFT_CHECKED;

/* The point of the path one beat later. False once the end is reached: then it is the last control point.
 *
 *   error   q16: 2^-17 mm along the path
 */
bool loft_course_next(loft_course *c, loft_acc out[LOFT_AXES]);

#endif
