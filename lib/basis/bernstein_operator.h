/* lib/basis/bernstein_operator.h -- iterates of Bernstein's operator: a function is replaced by the
 * polynomial of its samples, repeatedly
 * SPDX-License-Identifier: MIT
 *
 * B f is the polynomial with the Bernstein coefficients f(i/n). B (B f) samples B f, and so on. The
 * ends stay and everything between them is averaged, so the limit is the line from f(0) to f(1).
 */
#ifndef LOFT_BASIS_BERNSTEIN_OPERATOR_H
#define LOFT_BASIS_BERNSTEIN_OPERATOR_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */

LOFT_BEGIN_C

#define LOFT_FOREVER UINT32_MAX

/* Apply the operator `times` times to the function with f[i] = f(i / n), i = 0..n, and evaluate the
 * result at x. LOFT_FOREVER gives the limit f(0) + (f(1) - f(0)) x.
 *
 *   shape   f[n + 1]
 *   range   n in 1..9, times >= 1, x in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the value
 *           does not fit. *value is untouched after an error
 *   error   with L = |1 - x| + |x|, 1 in 0..1, and s = n^4 / (4 n - 4), 0 for n = 1, for any number
 *           of times:
 *           q16: 1/2 LSB + (1 + L + .. + L^(n-1) + L^n s) * 2^-17 LSB, below 0.502 LSB in 0..1
 *           f32: 1/2 ulp of the result + L^n / 2 ulp   f64: 4 L^n (n + s) ulp, of the largest f[i]
 *   cost    n^3 / 2 wide lerps for each time, at most 512 times; beyond that the limit is used, at
 *           no cost
 *   see     Kelisky, Rivlin, Iterates of Bernstein polynomials (Pacific J. Math. 21, 1967)
 */
enum loft_status loft_bernstein_iterate(const loft_real f[], unsigned n, uint32_t times,
                                        loft_unit x, loft_real *value) LOFT_CHECKED;

#define LOFT_OPERATOR_MAX 64

/* The value at x of B f for the function with f[i] = f(i / n), once, for many samples, and of its
 * first derivative.
 *
 *   shape   f[n + 1]
 *   range   n in 1..64, x in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for numbers that are not
 *           valid, and if a result does not fit; the results are untouched after an error
 *   error   value: q16: 1/2 LSB + n 2^-17 LSB   f32: 1/2 ulp of the result + 2^-20 ulp   f64: 4 n
 *           ulp of the largest f[i]
 *           deriv: q16: 1/2 LSB + n^2 2^-17 LSB   f32: 1/2 ulp of the result + 2^-14 ulp   f64: 8
 *           n^2 ulp of the largest f[i]
 *   cost    n (n + 1) / 2 wide lerps each
 *   stack   Cortex-M4 592   Cortex-M0+ 692   ATmega328P 606
 *   see     Chang, Mathematics of Surfaces, 2.4, 2.5; Lorentz, Bernstein polynomials (1953)
 */
enum loft_status loft_bernstein_operator(const loft_real f[], unsigned n, loft_unit x,
                                         loft_real *value, loft_real *deriv) LOFT_CHECKED;

LOFT_END_C

#endif
