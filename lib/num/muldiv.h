/* lib/num/muldiv.h -- products, quotients and lengths of wide numbers that keep all bits of a
 * loft_acc
 * SPDX-License-Identifier: MIT
 *
 * For equations whose unknowns are multiplied by long lengths at the end: a chord of 2^17 makes 2
 * LSB of an error of 2^-32. What is below 1 is therefore kept times a power of two, a length in as
 * many bits as there are.
 */
#ifndef LOFT_NUM_MULDIV_H
#define LOFT_NUM_MULDIV_H

#include "num/num.h"    /* loft_acc */

LOFT_BEGIN_C

/* The part y / z of x, that is x * y / z.
 *
 *   range   z > 0, q16: |x * y / z| < 2^31   f32, f64: |x / z| and the result below 2^1023
 *   error   q16: 2^-33, ties away from 0   f32, f64: 1.5 ulp of double
 *   cost    q16: 4 products of 32 bits and 64 rounds of shift and subtract
 */
loft_acc loft_acc_muldiv(loft_acc x, loft_acc y, loft_acc z);

/* *x * k / h, in place; false, and *x untouched, when q16 has no room for that.
 *
 *   range   h > 0, k = 1..9; q16: h < 2^16, |*x| and the result to 2^26 always have room
 *   error   as loft_acc_muldiv
 *   cost    as loft_acc_muldiv, and a division
 */
bool loft_acc_grow(loft_acc *x, int32_t k, loft_acc h) LOFT_CHECKED;

/* The length of the vector x[0..n-1], times 2^shift: in q16 as long as it can be made, in floats
 * shift is 0.
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
