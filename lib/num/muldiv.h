/* lib/num/muldiv.h -- products, quotients and lengths of accs that keep all bits
 * SPDX-License-Identifier: MIT
 *
 * These are for equations whose unknowns are finally multiplied by long lengths: a chord of 2^17
 * turns an error of 2^-32 into 2 LSB. Values below 1 are therefore scaled by a power of two, and a
 * length uses all available bits.
 */
#ifndef LOFT_NUM_MULDIV_H
#define LOFT_NUM_MULDIV_H

#include "num/num.h"    /* loft_acc */

LOFT_BEGIN_C

/* x * y / z.
 *
 *   range   z > 0, q16: |x * y / z| < 2^31   f32, f64: |x / z| and the result below 2^1023
 *   error   q16: 2^-33, ties away from 0   f32, f64: 1.5 ulp of double
 *   cost    q16: 4 products of 32 bits and 64 rounds of shift and subtract
 */
loft_acc loft_acc_muldiv(loft_acc x, loft_acc y, loft_acc z);

/* Replace *x by *x * k / h. Returns false, and leaves *x untouched, if the result does not fit q16.
 *
 *   range   h > 0, k = 1..9; q16: h < 2^16, |*x| and the result up to 2^26 always fit
 *   error   as loft_acc_muldiv
 *   cost    as loft_acc_muldiv, and a division
 */
bool loft_acc_grow(loft_acc *x, int32_t k, loft_acc h) LOFT_CHECKED;

/* The length of the vector x[0..n-1], times 2^shift. In q16 the shift is the largest possible; in
 * floats it is 0.
 *
 *   shape   q16: 0, or 2^26 <= result < 2^28.3
 *   range   q16: |x[i]| < 2^27, n = 0..6   f32, f64: as loft_acc_hypot
 *   error   q16: 2^-33, which is 2^-59 of the length   f32, f64: 2^-50 of the result
 *   cost    q16: n squares and 64 rounds of shift and subtract, of 128 bits
 */
loft_acc loft_acc_length(const loft_acc x[], int n, uint8_t *shift);

/* x / 2^shift, shift in 0..62.
 *
 *   error   q16: 2^-33, ties upward   f32, f64: none
 *   cost    q16: two shifts
 */
loft_acc loft_acc_down(loft_acc x, unsigned shift);

LOFT_END_C

#endif
