/* lib/num/acc128.h -- numbers with more bits than loft_acc, for curves with weights
 * SPDX-License-Identifier: MIT
 *
 * A point of a rational curve is a pair (x, w): a sum of weighted points and a sum of weights. Both
 * have the same scale. For a coordinate p and a weight v,
 *
 *     x = loft_prod(p, v)        w = loft_to_acc(v) * LOFT_PROJECT
 *     loft_acc_project(x, w) = p
 *
 * Then |x| <= w for any p, and a division takes 32 subtractions.
 *
 *   loft_acc128   q16: an integer of 128 bits in two's complement, which wraps
 *                 f32, f64: double
 */
#ifndef LOFT_NUM_ACC128_H
#define LOFT_NUM_ACC128_H

#include "num/num.h"    /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C

#define LOFT_PROJECT 32768

#if LOFT_NUM == LOFT_Q16

typedef struct {
    uint32_t limb[4];           /* the lowest first */
} loft_acc128;

#else

typedef double loft_acc128;

#endif

/* The coordinate LOFT_PROJECT * x / w.
 *
 *   range   w > 0; q16: -1 - 2^-32 <= x / w < 1 - 2^-32   f32, f64: |x| <= w + 2^-17 w
 *   error   q16: 1/2 LSB   f32: 1/2 ulp   f64: 1 ulp
 *   cost    q16: 32 rounds of a comparison and a subtraction of 64 bits; safe in an ISR
 */
loft_real loft_acc_project(loft_acc x, loft_acc w);

/* The inverse: w a / LOFT_PROJECT, the weighted coordinate of a.
 *
 *   range   q16: 0 <= w <= 2^30
 *   error   q16: 2^-33, ties upward   f32, f64: 1/2 ulp of double
 *   cost    q16: two products of 32 bits; safe in an ISR
 */
loft_acc loft_acc_weigh(loft_acc w, loft_real a);

/* loft_acc_project for loft_acc128; q16: 32 rounds of 128 bits.
 *
 *   range   as loft_acc_project
 *   error   as loft_acc_project
 */
loft_real loft_acc128_project(loft_acc128 x, loft_acc128 w);

/* The same for any x and any w > 0. Returns false, and leaves *out untouched, if the result does
 * not fit.
 *
 *   error   as loft_acc_project
 *   cost    q16: 33 rounds of 128 bits
 */
bool loft_acc128_rate(loft_acc128 x, loft_acc128 w, loft_real *out) LOFT_CHECKED;

/* x / h as a real. Returns false, and leaves *out untouched, if it does not fit.
 *
 *   range   h > 0; q16: h < 2^16, -32768 - 2^-17 <= x / h < 32768 - 2^-17 fits
 *   error   q16: 1/2 LSB   f32: 1/2 ulp   f64: 1/2 ulp
 *   cost    q16: 32 rounds of a comparison and a subtraction of 64 bits
 */
bool loft_acc_rate(loft_acc x, loft_acc h, loft_real *out) LOFT_CHECKED;

/* x as a loft_acc128. In q16 `guarded` adds 46 guard bits below the last bit, for a chain of lerps:
 * then |x| < 2^109.
 *
 *   error   none
 *   cost    guarded: 4 products of 32 bits
 */
loft_acc128 loft_acc128_of(loft_acc x);
loft_acc128 loft_acc128_guarded(loft_acc x);

/* The inverse of loft_acc128_guarded, divided by k >= 1.
 *
 *   range   q16: |x / k| < 2^31
 *   error   q16: 2^-33 + 2^-78   f32, f64: 1/2 ulp of double
 *   cost    q16: 4 divisions of 64 by 32 bits
 */
loft_acc loft_acc128_to_acc(loft_acc128 x, uint32_t k);

/* x + y, x - y, k x.
 *
 *   error   q16: none, modulo 2^128   f32, f64: 1/2 ulp of double
 *   cost    q16: one pass over 4 limbs; times: 4 32-bit products
 */
loft_acc128 loft_acc128_add(loft_acc128 x, loft_acc128 y);
loft_acc128 loft_acc128_sub(loft_acc128 x, loft_acc128 y);
loft_acc128 loft_acc128_times(loft_acc128 x, uint32_t k);

/* x < y. q16: |x|, |y| < 2^126
 *
 *   error   none
 *   cost    q16: one pass over 4 limbs
 */
bool      loft_acc128_below(loft_acc128 x, loft_acc128 y);

/* One step of forward differences: d[k] += d[k+1], k = 0 .. degree - 1 upwards.
 *
 *   error   as loft_acc128_add
 *   cost    `degree` additions; safe in an ISR
 */
void loft_acc128_step(loft_acc128 d[], unsigned degree);

/* True if a coordinate is small enough for a walk. f64: below 2^900, which leaves headroom for a
 * weight and n^degree.
 *
 *   error   none
 *   cost    two comparisons
 */
bool loft_acc128_valid(loft_real a);

/* The value that is x at t = 0, y at t = 1, and linear in t.
 *
 *   range   t in -1..2; q16: |x|, |y| < 2^125, and the result
 *   error   q16: 1/2 of the last bit   f32, f64: 2 ulp of double of the larger of |x|, |y|, outside
 *           0..1 three times that; none at 0 and 1
 *   cost    q16: 5 products of 32 bits
 */
loft_acc128 loft_acc128_lerp(loft_acc128 x, loft_acc128 y, loft_unit t);

/* The value that is x at a = lo, y at a = hi, and linear in a, as loft_acc_lerp_in.
 *
 *   range   lo <= a <= hi, lo < hi; q16: |x|, |y| < 2^125
 *   error   q16: 1/2 of the last bit   f32, f64: as loft_acc_lerp_in; none at lo and hi
 *   cost    q16: 5 products of 32 bits and 5 divisions of 64 by 32
 */
loft_acc128 loft_acc128_lerp_in(loft_acc128 x, loft_acc128 y, loft_real a, loft_real lo,
                                loft_real hi);

/* k (x[1] w[0] - x[0] w[1]) / (v v), v between w[0] and w[1], as an acc. Returns false, and leaves
 * *out untouched, if it does not fit (q16: 2^31). All arguments have guard bits; the weights do not
 * have the factor LOFT_PROJECT.
 *
 *   range   v > 0, k = 0..9
 *   error   q16: 2^-33 + 2^-58 of the two terms of the result   f32, f64: 4 ulp of double of the
 *           terms
 *   cost    q16: 2 products of 64 bits and 3 quotients of 63 rounds
 */
bool loft_acc128_slope(const loft_acc128 x[2], const loft_acc128 w[2], loft_acc128 v, int32_t k,
                       loft_acc *out) LOFT_CHECKED;

LOFT_END_C

#endif
