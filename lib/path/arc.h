/* lib/path/arc.h -- arc: a part of a cubic that is nearly straight, walked by its length
 * SPDX-License-Identifier: MIT
 *
 * A curve is cut into arcs so short that direction, curvature and rate (length per parameter)
 * change little.
 */
#ifndef LOFT_PATH_ARC_H
#define LOFT_PATH_ARC_H

#include "curve/bezier.h"   /* loft_cubic */

LOFT_BEGIN_C

/* parameters of cuts are whole numbers: 2^20 is the end of the curve */
#define LOFT_ARC_WHOLE ((uint32_t)1 << 20)

/* Do not rely on the fields. */
typedef struct {
    loft_acc  length;           /* mm */
    loft_unit ends[2], inner[3];    /* how the parameter depends on the length */
    bool      dust;             /* too small to have a direction: at most 2^-18 mm; f32, f64: 2^-38
                                 * of the coordinates */
    loft_acc  c[4][LOFT_AXES];  /* coefficients of the parameter's powers */
} loft_arc;

/* Cut the arc that begins at parameter `from` (a multiple of 2^-20); gives the parameter where it
 * ends. A curve that does not leave its chord by more than 2^-16 mm and does not overshoot its ends
 * is walked evenly, as the chord.
 *
 *   range   from = 0..LOFT_ARC_WHOLE - 1; coordinates within half their range
 *   error   the length errs by less than 2^-16 of itself; q16: start and end by less than 2^-29 mm
 *   cost    24 wide products per axis and 6 for each halving, 20 at most, 2 are usual; as many
 *           roots as halvings and 5
 */
uint32_t loft_arc_next(loft_arc *arc, const loft_cubic *curve, uint32_t from);

/* Does it leave its chord by less than `within`, mm, and is it walked nearly evenly? */
bool loft_arc_is_straight(const loft_arc *arc, loft_acc within);

/* Make a straight arc its chord, less `by` of it, mm: it stays longer than dust. */
void loft_arc_fold(loft_arc *arc, const loft_acc by[LOFT_AXES]);

/* The direction (of length 1) at the start, the middle or the end of an arc, n = 0..2, that is not
 * dust.
 *
 *   error   q16: 2^-16
 */
void loft_arc_direction(const loft_arc *arc, unsigned n, loft_vec *out);

/* The point at length s, 0 <= s <= arc->length, of an arc with length > 0.
 *
 *   error   q16: 2^-23 of the length   f32: 2^-24 of the length
 *   cost    3 wide products per axis, 6 for the parameter, and a division
 */
void loft_arc_eval(const loft_arc *arc, loft_acc s, loft_acc out[LOFT_AXES]);

/* And the direction there, of an arc that is not dust.
 *
 *   error   q16: 2^-15
 */
void loft_arc_heading(const loft_arc *arc, loft_acc s, loft_vec *out);

LOFT_END_C

#endif
