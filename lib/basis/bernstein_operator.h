/* lib/basis/bernstein_operator.h -- Bernstein's operator: a function replaced by the polynomial of
 * its
 * samples, again and again
 * SPDX-License-Identifier: MIT
 *
 * B f is the polynomial with the Bernstein coefficients f(i/n). B (B f) samples that one, and so
 * on. The ends stay, everything between is averaged, and what remains in the end is the line from
 * f(0) to f(1).
 */
#ifndef LOFT_BASIS_BERNSTEIN_OPERATOR_H
#define LOFT_BASIS_BERNSTEIN_OPERATOR_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */

LOFT_BEGIN_C

#define LOFT_FOREVER UINT32_MAX

/* The value at x of the operator applied `times` times to the function with f[i] = f(i / n), i =
 * 0..n. With LOFT_FOREVER: of its limit f(0) + (f(1) - f(0)) x.
 *
 *   shape   f[n + 1]
 *   range   n in 1..9, times >= 1, x in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the
 *           value does not fit, *value is untouched then
 *   error   with L = |1 - x| + |x|, 1 in 0..1, and s = n^4 / (4 n - 4), 0 for n = 1, however many
 *           times:
 *           q16: 1/2 LSB + (1 + L + .. + L^(n-1) + L^n s) * 2^-17 LSB, below 0.502 LSB in 0..1
 *           f32: 1/2 ulp of the result + L^n / 2 ulp   f64: 4 L^n (n + s) ulp, of the largest f[i]
 *   cost    n^3 / 2 wide lerps for each time, at most 512 times; then none, the limit has arrived
 *   see     Kelisky, Rivlin, Iterates of Bernstein polynomials (Pacific J. Math. 21, 1967)
 */
enum loft_status loft_bernstein_iterate(const loft_real f[], unsigned n, uint32_t times,
                                        loft_unit x, loft_real *value) LOFT_CHECKED;

LOFT_END_C

#endif
