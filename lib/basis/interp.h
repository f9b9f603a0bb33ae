/* lib/basis/interp.h -- interpolating polynomials: the parabola through three values, and Hermite's
 * from values and derivatives at both ends
 * SPDX-License-Identifier: MIT
 *
 * One coordinate at a time; curve/parabola.h, hermite.h, cardinal.h and natural.h make curves of
 * them.
 */
#ifndef LOFT_BASIS_INTERP_H
#define LOFT_BASIS_INTERP_H

#include "num/num.h"    /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C


/* The parabola through three values
 * ---------------------------------
 *
 * Everything is a quotient of integers (num/exact.h) that is rounded once, for any spacing of the
 * places. Not for an ISR; up to 2.5 kB of stack in q16, more than an ATmega328P has.
 *
 *     loft_parabola p;
 *     if (loft_parabola_init(&p, t, f) == LOFT_OK &&
 *         loft_parabola_eval(&p, LOFT_REAL(2.5), &y) == LOFT_OK) ..
 */

/* The value f[i] at the place t[i]. Do not fill it yourself: call init. */
typedef struct {
    loft_real t[3], f[3];
} loft_parabola;

/* Store three places and their values.
 *
 *   range   the places in any order; LOFT_SINGULAR if two are equal
 *           f32, f64: numbers that pass loft_exact_valid, otherwise LOFT_ERR_RANGE. *p is untouched
 *           after an error
 *   error   none: the numbers are stored unchanged
 *   cost    three differences of exact numbers
 */
enum loft_status loft_parabola_init(loft_parabola *p, const loft_real t[3],
                                    const loft_real f[3]) LOFT_CHECKED;

/* The value and the derivative at t.
 *
 *   range   any t (f32, f64: that passes loft_exact_valid); LOFT_ERR_RANGE if the result does not
 *           fit. *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32, f64: 0.52 ulp of the result, 1 ulp in f64
 *   cost    about 20 products of exact numbers and one quotient
 *   see     Newton's divided differences, over their common denominator
 */
enum loft_status loft_parabola_eval(const loft_parabola *p, loft_real t,
                                    loft_real *out) LOFT_CHECKED;
enum loft_status loft_parabola_deriv(const loft_parabola *p, loft_real t,
                                     loft_real *out) LOFT_CHECKED;

/* The coefficients of a[0] + a[1] t + a[2] t^2.
 *
 *   range   LOFT_ERR_RANGE if one does not fit; a is undefined then
 *   error   as eval
 *   cost    as eval, with three quotients
 */
enum loft_status loft_parabola_power(const loft_parabola *p, loft_real a[3]) LOFT_CHECKED;

/* The Bernstein coefficients of the piece from..to; from > to gives it reversed.
 *
 *   range   as power
 *   error   as eval
 *   cost    three times eval
 */
enum loft_status loft_parabola_bernstein(const loft_parabola *p, loft_real from, loft_real to,
                                         loft_real c[3]) LOFT_CHECKED;

/* Values and derivatives at both ends of 0..1
 * -------------------------------------------
 *
 * Cubic: e[4] = { p(0), p(1), p'(0), p'(1) }; the quintic adds p''(0), p''(1) in e[4], e[5]. Range
 * in q16: |e| <= 2^21 for the cubic, 2^16 for the quintic. For t in 0..1 the limits are larger. The
 * slopes of a cubic may be up to 2^26 and p(1) - p(0) up to 2^25. Up to the first derivative, e of
 * a quintic may be up to 2^24, and p''(0) and p''(1) up to 2^27. */

/* The Bernstein coefficients.
 *
 *   error   q16: 2^-33 each, none at the ends   f32, f64: 3 ulp of double of the largest of e
 *   cost    2 divisions by an integer, 4 for the quintic; safe in an ISR
 *   see     Farin, Curves and Surfaces for CAGD, ch. 7: Hermite interpolation
 */
void loft_ends3_bernstein(const loft_acc e[4], loft_acc c[4]);
void loft_ends5_bernstein(const loft_acc e[6], loft_acc c[6]);

/* The k-th derivative at t: the value for k = 0, and 0 for k above the degree.
 *
 *   range   t in -1..2
 *   error   with L = |1 - t| + |t|, n = 3 or 5, m = n - k, e of the coefficients:
 *           q16: (L^n + 1 + L + .. + L^(n-1)) * 2^-33 for k = 0, else (1 + L + .. + L^(m-1)) *
 *           2^-33
 *           f32, f64: (6 n + 4) L^n for k = 0, else 3 n 2^n L^m (n!/m!), in ulp of double of the
 *           largest of e
 *   cost    as loft_bernstein_eval; safe in an ISR
 */
loft_acc loft_ends3_deriv(const loft_acc e[4], unsigned k, loft_unit t);
loft_acc loft_ends5_deriv(const loft_acc e[6], unsigned k, loft_unit t);

LOFT_END_C

#endif
