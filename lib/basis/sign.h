/* lib/basis/sign.h -- where a polynomial in Bernstein form is positive or convex, decided exactly
 * SPDX-License-Identifier: MIT
 *
 * The coefficients are a quick test: if none is negative, the polynomial is not negative on 0..1.
 * The converse is false, and degree elevation brings the coefficients closer to the polynomial.
 * These functions decide about the polynomial itself. Every decision is a sign of integers
 * (num/exact.h), for the coefficients exactly as given. In f32 and f64 the coefficients must pass
 * loft_exact_valid, otherwise LOFT_ERR_RANGE; nothing is written then.
 */
#ifndef LOFT_BASIS_SIGN_H
#define LOFT_BASIS_SIGN_H

#include "num/num.h"    /* loft_real */

LOFT_BEGIN_C

#define LOFT_ELEVATIONS_MAX 60      /* loft_quadratic_sign stops there  */

typedef struct {
    bool nonnegative;       /* >= 0 on 0..1, ends included                                   */
    bool positive;          /* > 0 on 0..1, ends included                                    */
    loft_real min;          /* the minimum on 0..1, rounded                                  */
    int8_t elevations;      /* degree elevations until all coefficients are > 0; -1: over 60 */
} loft_sign;

/* The sign of the polynomial of degree 2 with Bernstein coefficients a[0..2].
 *
 *   error   none in the flags and the count; min q16: 1/2 LSB + 2^-16 LSB   f32, f64: 1 ulp
 *   cost    5 exact products, one quotient, and fewer than 4000 exact sums
 *   stack   Cortex-M4 2,208   Cortex-M0+ 2,200   ATmega328P 2,618
 *   see     Chang, Mathematics of Surfaces, theorem 2.1: a0 >= 0, a2 >= 0, a1 + sqrt(a0 a2) >= 0
 */
enum loft_status loft_quadratic_sign(const loft_real a[3], loft_sign *out) LOFT_CHECKED;

/* Decide whether a polynomial of degree 0..4 is convex on 0..1 (to 32: positivity.h). `net` tells
 * whether its control polygon is convex: all second differences >= 0, which is sufficient, and for
 * degrees up to 3 also necessary.
 *
 *   range   degree 0..4, otherwise LOFT_ERR_ARG
 *   error   none
 *   cost    2 exact products for degree 4
 *   stack   Cortex-M4 1,456   Cortex-M0+ 1,524   ATmega328P 1,443
 *   see     Chang, theorem 2.1, applied to the second differences
 */
enum loft_status loft_bernstein_convex(const loft_real b[], unsigned degree, bool *net,
                                       bool *polynomial) LOFT_CHECKED;

LOFT_END_C

#endif
