/* lib/motion/arc.h -- arc: a part of a cubic that is nearly straight, walked by its length
 * SPDX-License-Identifier: MIT
 *
 * A curve is cut into arcs so short that direction, curvature and rate (length per parameter)
 * change little.
 */
#ifndef LOFT_MOTION_ARC_H
#define LOFT_MOTION_ARC_H

#include "curve/bezier.h"   /* loft_cubic */

LOFT_BEGIN_C

/* parameters of cuts are whole numbers: 2^20 is the end of the curve */
#define LOFT_ARC_WHOLE ((uint32_t)1 << 20)

/* Do not rely on the fields. */
typedef struct {
    loft_acc  length;           /* mm */
    loft_unit ends[2], inner[3];    /* how the parameter depends on the length; `inner` is set by
                                     * loft_arc_pace */
    bool      speck;            /* walked evenly, as its chord: at most 2^-16 mm */
    bool      crumb;            /* a speck that may bend in any way: at most 2^-18 mm */
    bool      dust;             /* too small to have a direction: at most 2^-18 mm; f32, f64: 2^-38
                                 * of the coordinates */
    loft_acc  c[4][LOFT_AXES];  /* coefficients of the parameter's powers */
} loft_arc;

/* How an arc lies: direction (of length 1) and curvature vector (1/mm) at its start, middle and
 * end. */
typedef struct {
    bool     tight;                 /* dust, or bent more than `bend` can say (q16: 16383 / mm) */
    loft_vec along[3], bend[3];     /* dust: all ones, and no curvature                         */
} loft_arc_shape;

/* Cut the arc that begins at parameter `from` (a multiple of 2^-20); gives the parameter where it
 * ends. A curve that does not leave its chord by more than 2^-16 mm and does not overshoot its ends
 * is walked evenly, as the chord. `coarse`: it may turn and change its rate by 1/4, not by 1/8.
 *
 *   range   from = 0..LOFT_ARC_WHOLE - 1; coordinates within half their range
 *   error   the length errs by less than 2^-16 of itself; q16: start and end by less than 2^-29 mm
 *   cost    24 wide products per axis and 6 for each halving, 20 at most, 2 are usual; as many
 *           roots as halvings and 5
 */
uint32_t loft_arc_next(loft_arc *arc, const loft_cubic *curve, uint32_t from, bool coarse);

/* Cut the arc from..to, which loft_arc_next has found, or half of one. Not a chord: its
 * coefficients are rounded otherwise here, so that it may be too small to be nearly straight and
 * too large to be a chord. */
void loft_arc_cut(loft_arc *arc, const loft_cubic *curve, uint32_t from, uint32_t to, bool coarse);

/* The arc from..to again, for loft_arc_eval; `chord`: it is a speck or dust. */
void loft_arc_pace(loft_arc *arc, const loft_cubic *curve, uint32_t from, uint32_t to, bool chord);

/* The shape of an arc: of its start, middle and end those in `which`, 1 + 2 + 4; the others are set
 * already.
 *
 *   error   q16: direction 2^-16, curvature 2^-15 / length of the arc
 */
void loft_arc_measure(const loft_arc *arc, loft_arc_shape *shape, unsigned which);
#define LOFT_ARC_ALL 7u

/* The point at length s, 0 <= s <= arc->length, of an arc with length > 0.
 *
 *   range   the arc is from loft_arc_pace
 *   error   q16: 2^-23 of the length   f32: 2^-24 of the length
 *   cost    3 wide products per axis, 6 for the parameter, and a division
 */
void loft_arc_eval(const loft_arc *arc, loft_acc s, loft_acc out[LOFT_AXES]);

LOFT_END_C

#endif
