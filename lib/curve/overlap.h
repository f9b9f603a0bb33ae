/* lib/curve/overlap.h -- the stretch that two Bezier curves share where both are parts of one curve
 * SPDX-License-Identifier: MIT
 *
 * Two polynomial curves that agree on a stretch are, but for a few that run back on themselves, the
 * same polynomial at parameters that are a linear function of each other. That is found from the
 * ends, without looking at what is between.
 */
#ifndef LOFT_CURVE_OVERLAP_H
#define LOFT_CURVE_OVERLAP_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_unit s_from, s_to;     /* on the first, s_from < s_to */
    loft_unit t_from, t_to;     /* the same places on the second; t_from > t_to where it runs the
                                 * other way */
    loft_acc  distance;         /* of the two curves at s_from */
} loft_overlap;

/* Find the stretch that a and b share, longer than 4 tol; false, and *out untouched, when none is
 * found: of curves with ends that are not on each other, or the same points at other speeds, none
 * is.
 *
 *   range   tol > 0, as loft_bezier_intersect; at least two axes, otherwise none is found
 *   error   the points at the same part of both stretches are within 7/8 tol of each other. Curves
 *           that agree to tol / 8 (in q16 to half an LSB at 4 LSB and more) are found
 *   cost    4 times loft_bezier_nearest, up to 28 times loft_bernstein_sub of both; 1.2 KB of
 *           stack in q16
 *   see     a proper polynomial parametrization is unique up to an affine one: Sendra, Winkler &
 *           Perez-Diaz, Rational Algebraic Curves (2008), ch. 4
 */
bool loft_bezier_overlap(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                         loft_overlap *out) LOFT_CHECKED;

/* Is every place where s_from..s_to of `a` meets t_from..t_to of the other curve one of the
 * stretch? So it is where the part of `a` that holds both turns by less than 60 degrees. `a` is
 * that of loft_bezier_overlap.
 *
 *   error   none that invents one: false when it cannot be told
 *   cost    one loft_bernstein_sub
 */
bool loft_overlap_covers(const loft_overlap *o, const loft_bezier *a, loft_unit s_from,
                         loft_unit s_to, loft_unit t_from, loft_unit t_to);

LOFT_END_C

#endif
