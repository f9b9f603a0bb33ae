/* lib/curve/reduce.h -- Bezier curves of a lower degree: exactly where possible, else the nearest
 * one
 * SPDX-License-Identifier: MIT
 *
 *     loft_vec q[LOFT_DEGREE_MAX + 1];
 *     loft_acc bound;
 *     if (loft_bezier_reduce(&b, 2, q, &bound) == LOFT_OK && bound <= tolerance)
 *         loft_bezier_init(&low, q, b.degree - 2) ..
 *
 * In the `error` lines ulp is that of the largest control value.
 */
#ifndef LOFT_CURVE_REDUCE_H
#define LOFT_CURVE_REDUCE_H

#include "curve/bezier.h"       /* loft_bezier */

LOFT_BEGIN_C

/* The degree of the curve as a polynomial, 0 for a point, and its control points of that degree:
 * out[*degree + 1].
 *
 *   range   f32, f64: LOFT_ERR_RANGE unless coordinates pass loft_exact_valid, and if a point does
 *           not fit; *degree is then untouched, out is undefined
 *   error   degree: none   points: q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 8^(n - degree) ulp
 *   cost    n^2 / 2 exact sums per axis, and in numbers of num/sci.h n products for each degree
 *           that is taken away
 *   see     Chang, Mathematics of Surfaces, 2.1 (21), 4.1: the k-th differences
 */
enum loft_status loft_bezier_exact_degree(const loft_bezier *b, unsigned *degree,
                                          loft_vec out[]) LOFT_CHECKED;

/* The degree of one coordinate as a polynomial: the highest k with a k-th difference that is not 0.
 *
 *   range   f32, f64: coordinates that pass loft_exact_valid; axes beyond LOFT_AXES are 0
 *   error   none
 *   cost    n^2 / 2 exact sums
 */
unsigned loft_bezier_axis_degree(const loft_bezier *b, int axis);

/* The curve with a degree lower by `times` and the same ends whose square of the distance, summed
 * over the parameter, is the smallest: out[degree - times + 1].
 *
 *   range   1 <= times < degree, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a point or the bound
 *           does not fit; *bound is then untouched, out is undefined
 *   error   points: q16: 1/2 LSB + 2^-10 LSB   f32: 1/2 ulp of the result + 1/2 ulp   f64: 2^20
 *           ulp; none at the ends
 *           *bound: the largest length of a Bernstein coefficient of the difference, for the points
 *           as rounded and before, and rounded up: both curves are closer than that everywhere. It
 *           is too large by at most q16: 2 LSB   f32, f64: 2^-31 E and 2 ulp, E the largest
 *           difference of a coordinate of either curve from that of the first point
 *   cost    in numbers of num/sci.h a system of the order degree - times - 1 and (degree + 1)^2
 *           products
 *   stack   Cortex-M4 2,988   Cortex-M0+ 2,992   ATmega328P 2,354
 *   see     Farin, Curves and Surfaces for CAGD, ch. 6: degree reduction; Lutterkort, Peters and
 *           Reif, Polynomial degree reduction in the L2-norm (1999)
 */
enum loft_status loft_bezier_reduce(const loft_bezier *b, unsigned times, loft_vec out[],
                                    loft_acc *bound) LOFT_CHECKED;

LOFT_END_C

#endif
