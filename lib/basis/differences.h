/* lib/basis/differences.h -- the forward differences of a Bernstein polynomial at equal steps of
 * any size
 * SPDX-License-Identifier: MIT
 *
 * Use it for tables and for tests. To walk a curve use curve/forward.h, which keeps its differences
 * with more bits than a coordinate has.
 */
#ifndef LOFT_BASIS_DIFFERENCES_H
#define LOFT_BASIS_DIFFERENCES_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX, loft_binomial */

LOFT_BEGIN_C

/* The differences e[k] = D^k f(0), k = 0..degree, of f at the steps 0, 1/n, 2/n ..
 *
 *   shape   a[degree + 1] Bernstein coefficients on 0..1; e[degree + 1]
 *   range   degree 0..9 and n >= 1, otherwise LOFT_ERR_ARG; coefficients that pass
 *           loft_exact_valid, and results that fit, otherwise LOFT_ERR_RANGE. e is untouched after
 *           an error. For n < degree the steps go beyond 1
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32, f64: 1/2 ulp + 0.51 ulp of double, for each difference
 *   cost    2 degree^2 products and degree quotients of loft_exact; not for an ISR
 *   stack   Cortex-M4 2,624   Cortex-M0+ 2,624   ATmega328P 2,987
 *   see     Jordan, Calculus of Finite Differences, ch. 4: Stirling numbers
 */
enum loft_status loft_bernstein_forward_differences(const loft_real a[], unsigned degree,
                                                    uint32_t n, loft_real e[]) LOFT_CHECKED;

LOFT_END_C

#endif
