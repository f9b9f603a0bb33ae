/* lib/basis/integral.h -- integrals of Bernstein polynomials, over an interval and over a triangle
 * SPDX-License-Identifier: MIT
 *
 * Every Bernstein polynomial of degree n has the integral 1 / (n + 1) over 0..1, and every one over
 * a triangle the same share of its area: integrals are means of coefficients.
 */
#ifndef LOFT_BASIS_INTEGRAL_H
#define LOFT_BASIS_INTEGRAL_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

/* The mean of `count` coefficients: the integral over 0..1 of the polynomial of degree count - 1,
 * and the mean value over a triangle of a triangular net of that many.
 *
 *   range   count 1..220, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for numbers that are not valid
 *           (f32, f64); *out is untouched then
 *   error   q16: 2^-33   f32, f64: count ulp of double of the largest coefficient
 *   cost    a sum per coefficient and a division
 *   see     Chang, Mathematics of Surfaces, (2-9), (2-19)
 */
enum loft_status loft_bernstein_mean(const loft_real b[], unsigned count,
                                     loft_acc *out) LOFT_CHECKED;

/* The integral of the polynomial b[0..degree] from `from` to `to`; negative if to < from.
 *
 *   range   degree 0..9, both in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE as above
 *   error   q16: 2^-33 + 2^-55 of the largest coefficient   f32, f64: 2^-47 of that
 *   cost    in numbers of num/sci.h twice de Casteljau's algorithm of the degree + 1
 *   see     Farin, Curves and Surfaces for CAGD, ch. 6: integrals
 */
enum loft_status loft_bernstein_integral(const loft_real b[], unsigned degree, loft_unit from,
                                         loft_unit to, loft_acc *out) LOFT_CHECKED;

/* The same for wide coefficients of any degree up to 36.
 *
 *   range   degree 0..36
 *   error   (degree + 2) 4 roundings of num/sci.h of the largest coefficient
 *   cost    as loft_bernstein_integral
 */
loft_sci loft_bernstein_integral_sci(const loft_sci b[], unsigned degree, loft_sci from,
                                     loft_sci to);

/* The Bernstein coefficients out[0 .. m + n] of the product of a[0..m] and b[0..n].
 *
 *   range   m + n <= 36; `out` is neither a nor b
 *   error   4 (m + n) roundings of num/sci.h of the product of the largest coefficients
 *   cost    (m + 1) (n + 1) times 3 products and a quotient
 *   see     Farin, ch. 6: products
 */
void loft_bernstein_product(const loft_sci a[], unsigned m, const loft_sci b[], unsigned n,
                            loft_sci out[]);

/* The binomial coefficient n over k, wide; 0 for k > n.
 *
 *   range   n <= 60
 *   error   f32, f64: none below 2^53   q16: none
 *   cost    k products and quotients of num/sci.h
 */
loft_sci loft_binomial_sci(unsigned n, unsigned k);

LOFT_END_C

#endif
