/* lib/motion/cell.h -- cell: a short part of the path, passed with an acceleration that changes
 * evenly along it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_CELL_H
#define LOFT_MOTION_CELL_H

#include "motion/arc.h"     /* loft_arc, loft_arc_shape */
#include "motion/ease.h"    /* loft_ease */

LOFT_BEGIN_C

/* Times 1 / a length. */
typedef struct {
    loft_real coarse;           /* of lengths below 1/64 mm */
    loft_unit fine;
} loft_inverse;

/* A cell, with the place where it begins. Do not rely on the fields. */
typedef struct {
    loft_vec  along[2], bend[2], turn[2];   /* at both ends: direction; curvature; its derivative
                                             * times the length */
    loft_vec  jump;             /* of curvature nearby, which is eased: in it, of that */
    loft_unit bends[2][2], turns[2][2];     /* the curvature and its derivative change by these
                                             * parts, each case at both ends */
    uint8_t   eased;            /* how many such cases there are */
    loft_unit bow, bow_change, bow_accel;   /* more than at its ends, part of the acceleration:
                                             * always; per change of `a`; per `a` */
    loft_unit length;           /* mm */
    loft_acc  span;             /* the length times the beats of a second */
    loft_unit grip;             /* part of the jerk that may be used */
    loft_acc  most, gate;       /* the largest square of the speed in it, where it begins */
    loft_acc  b, rise;          /* the control value of the square of the speed; how much it may
                                 * grow */
    loft_acc  top;              /* how large it may be, as far as more of the path is known */
    loft_acc  x, a;             /* where it begins: square of the speed, acceleration */
    loft_real v;                /* and the speed, */
    loft_unit r;                /* and 1 / v */
    loft_unit part;             /* of the length of the one before of both; tie of the first one to
                                 * the second */
    loft_inverse both;          /* 1 / (length of the one before + length) */
} loft_plan_cell;

/* What a bump changes where a cell begins: the square of the speed, the acceleration. */
typedef struct {
    loft_acc x, a;
} loft_cell_rise;

/* The inverse of a length > 0. */
loft_inverse loft_inverse_of(loft_acc length);

/* x / that length. */
loft_acc loft_inverse_mul(loft_acc x, const loft_inverse *by);

/* Set the shape of a cell and the largest speed in it; the rest is for loft_raise. */
void loft_cell_init(loft_plan_cell *c, const loft_budget *b, const loft_arc *arc,
                    const loft_arc_shape *shape, loft_real feed);

/* Ease a jump of curvature: the cell begins `off` mm behind (negative: before) that place. */
void loft_cell_ease(loft_plan_cell *c, const loft_budget *b, const loft_ease *e, loft_acc off);

/* How much of a rise z the cell allows: `at` where it begins, `to` where it ends, which is where
 * `next` begins.
 *
 *   range   first, last: it begins, ends at rest
 */
loft_unit loft_cell_limit(const loft_plan_cell *c, const loft_plan_cell *next, const loft_budget *b,
                          loft_cell_rise at, loft_cell_rise to, loft_unit z, bool first, bool last);

LOFT_END_C

#endif
