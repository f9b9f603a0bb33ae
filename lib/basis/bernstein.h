/* lib/basis/bernstein.h -- polynomials of degree 0..9 in Bernstein and in power form, one value at
 * a time
 * SPDX-License-Identifier: MIT
 *
 * These are the scalar operations behind curves and surfaces. A polynomial on 0..1 is an array of
 * degree + 1 wide coefficients (loft_acc), so that a chain of operations rounds to a coordinate
 * only once, at the end:
 *
 *     loft_acc c[4] = { loft_to_acc(a), loft_to_acc(b), loft_to_acc(d), loft_to_acc(e) };
 *     loft_real y = loft_acc_round(loft_bernstein_eval(c, 3, t));
 *
 * Unless stated otherwise, coefficients are within the range of loft_real (q16: +-2^15), the degree
 * is 0..9, t is in -1..2, and nothing overflows (bernstein.c has the proof).
 */
#ifndef LOFT_BASIS_BERNSTEIN_H
#define LOFT_BASIS_BERNSTEIN_H

#include "num/num.h"    /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C

#define LOFT_DEGREE_MAX 9

/* The binomial coefficient n over k; 0 for k > n.
 *
 *   range   n <= 28
 *   error   none
 *   cost    k products and divisions of 32 bits
 */
int32_t loft_binomial(unsigned n, unsigned k);

/* t clamped to 0..1; nan gives 0. */
static inline loft_unit loft_unit_clamp(loft_unit t)
{
    return t > 0 ? t < LOFT_UNIT(1) ? t : LOFT_UNIT(1) : 0;
}


/* Weights and values
 * ------------------ */

/* The Bernstein polynomials B_0..B_degree at t: the weights of the control points.
 *
 *   shape   w[degree + 1]; q16: they sum to exactly 1 (2^32)
 *   error   q16: degree * 2^-32 for t in 0..1, otherwise (3^degree - 1) * 2^-33
 *           f32, f64: 3 * degree ulp of double (of 1; outside 0..1 of 3^degree)
 *   cost    degree * (degree + 1) / 2 wide products
 *   see     Farin, Curves and Surfaces for CAGD, ch. 5: Bernstein polynomials, recursion
 */
void loft_bernstein_weights(unsigned degree, loft_unit t, loft_acc w[]);

/* One row of de Casteljau's scheme, in place: c[i] becomes the value between c[i] and c[i+1] at t,
 * and `degree` coefficients remain. `degree` rows with the same t evaluate the polynomial; rows
 * with different t give the blossom.
 *
 *   error   q16: 2^-33 per row (1/2 of the last bit of loft_acc)   f32, f64: 3 ulp of double per
 *           row
 *   cost    `degree` wide lerps
 *   see     Farin, ch. 4: the de Casteljau algorithm; Ramshaw, blossoming
 */
void loft_bernstein_step(loft_acc c[], unsigned degree, loft_unit t);

/* The value at t. The coefficients are overwritten.
 *
 *   error   law of extrapolation, with L = |1 - t| + |t| (1 in 0..1, at most 3):
 *           q16: 2^-33 * (1 + L + .. + L^(degree-1)), which is degree * 2^-33 in 0..1 and always
 *           below 2^-19.7
 *           f32, f64: 3 * degree * L^degree ulp of double, of the largest coefficient
 *   cost    degree * (degree + 1) / 2 wide lerps
 */
loft_acc loft_bernstein_eval(loft_acc c[], unsigned degree, loft_unit t);

/* The value at exactly j / n, which need not fit a number type. It serves equal steps of any degree
 * and number, beyond the range of forward.h. The coefficients are overwritten.
 *
 *   range   j <= 2 n, 1 <= n < 2^30
 *   error   as loft_bernstein_eval   f32, f64: with 4 instead of 3
 *   cost    degree * (degree + 1) / 2 wide lerps, each with two long divisions in q16
 */
loft_acc loft_bernstein_at(loft_acc c[], unsigned degree, uint32_t j, uint32_t n);


/* Differences and power form
 * -------------------------- */

/* The differences D^k c_0, k = 0..degree, in place.
 *
 *   error   q16: none   f32, f64: k * 2^k roundings of double
 *   cost    degree * (degree + 1) / 2 subtractions
 */
void loft_bernstein_differences(loft_acc c[], unsigned degree);

/* From Bernstein to power coefficients, in place: c_k = C(n,k) D^k c_0.
 *
 *   range   the results may exceed loft_real (up to 5376 times the largest coefficient) and are
 *           still exact
 *   error   q16: none   f32, f64: (k + 1) * 2^k * C(n,k) roundings of double
 *   cost    as differences, and degree - 1 products by an integer
 */
void loft_bernstein_to_power(loft_acc c[], unsigned degree);

/* From power to Bernstein coefficients on 0..1, in place: b_i = sum C(i,k) / C(n,k) c_k.
 *
 *   range   the results may exceed loft_real (up to 10 times the largest coefficient)
 *   error   q16: i * 2^-33 for b_i   f32, f64: (i + 1) * (i + 2) roundings of double
 *   cost    degree * (degree + 1) / 2 products by an integer and divisions by an integer
 */
void loft_bernstein_from_power(loft_acc c[], unsigned degree);

/* Value and first derivative of c_0 + c_1 x + .. + c_n x^n, by nested multiplication.
 *
 *   range   x in -2..2 and degree 0..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if one of the two
 *           results does not fit. Nothing is written after an error
 *   error   q16: value 1/2 LSB + (2^n - 1) * 2^-17 LSB, derivative 1/2 LSB + n * 2^(n-1) * 2^-17
 *           LSB: below 0.52
 *           f32, f64: n * 2^n ulp of double for the value, n^2 * 2^n for the derivative, of the
 *           largest coefficient, and 1/2 ulp of the result
 *   cost    2 * degree wide products
 *   see     Horner's rule; Knuth, The Art of Computer Programming, vol. 2, 4.6.4
 */
enum loft_status loft_power_eval(const loft_real c[], unsigned degree, loft_unit x,
                                 loft_real *value, loft_real *deriv) LOFT_CHECKED;

LOFT_END_C

#endif
