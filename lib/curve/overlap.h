/* lib/curve/overlap.h -- the stretch that two Bezier curves share if both are pieces of one curve
 * SPDX-License-Identifier: MIT
 *
 * Two polynomial curves that agree on a stretch are the same polynomial, with parameters that are a
 * linear function of each other. (Exceptions are a few curves that run back on themselves.) The
 * stretch therefore follows from the ends, without tests between them.
 */
#ifndef LOFT_CURVE_OVERLAP_H
#define LOFT_CURVE_OVERLAP_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_unit s_from, s_to;     /* on the first, s_from < s_to */
    loft_unit t_from, t_to;     /* the same places on the second; t_from > t_to if it runs the other
                                 * way */
    loft_acc  distance;         /* of the two curves at s_from */
} loft_overlap;

/* Find the stretch longer than 4 tol that a and b share. Returns false, and leaves *out untouched,
 * if none is found. None is found if no ends lie on the other curve, or if the curves have the same
 * points at different speeds.
 *
 *   range   tol > 0, as loft_bezier_intersect; at least two axes, otherwise the result is false
 *   error   the points at the same fraction of both stretches are within 7/8 tol of each other.
 *           Curves that agree to tol / 8 (in q16 to half an LSB if tol >= 4 LSB) are found
 *   cost    4 times loft_bezier_nearest, up to 28 times loft_bernstein_sub of both
 *   stack   Cortex-M4 1,944   Cortex-M0+ 2,100   ATmega328P 1,909
 *   see     a proper polynomial parametrization is unique up to an affine one: Sendra, Winkler &
 *           Perez-Diaz, Rational Algebraic Curves (2008), ch. 4
 */
bool loft_bezier_overlap(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                         loft_overlap *out) LOFT_CHECKED;

/* True if every place where s_from..s_to of `a` meets t_from..t_to of the other curve is on the
 * stretch. It is if the piece of `a` that contains both turns by less than 60 degrees. `a` is the
 * one of loft_bezier_overlap.
 *
 *   error   never true by mistake: false if it cannot be decided
 *   cost    one loft_bernstein_sub
 */
bool loft_overlap_covers(const loft_overlap *o, const loft_bezier *a, loft_unit s_from,
                         loft_unit s_to, loft_unit t_from, loft_unit t_to);

LOFT_END_C

#endif
