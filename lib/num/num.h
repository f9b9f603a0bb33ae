/* lib/num/num.h -- the operations that loft needs of a number type
 * SPDX-License-Identifier: MIT
 *
 * Every algorithm in lib/ is written once, with these three types:
 *
 *   loft_real   a coordinate, a length, a speed     q16: int32_t Q16.16   f32: float   f64: double
 *   loft_unit   a parameter or weight               q16: int32_t Q8.24    f32: float   f64: double
 *   loft_acc    a wide value with guard bits        q16: int64_t Q32.32   f32: double  f64: double
 *
 * and these operations, which mean the same in every build:
 *
 *   a + b   a - b   -a   a < b   3 * a        plain C, within one type
 *   loft_mul(a, b)      loft_div(a, b)        rounded product and quotient of two reals
 *   loft_lerp(a, b, t)                        real between two reals: a at t = 0, b at t = 1,
 *                                             both exactly
 *   loft_to_acc(a)                            real to acc, exactly
 *   loft_prod(a, b)                           product of two reals as acc, exactly in q16 and f32
 *   loft_acc_lerp(x, y, t)                    acc between two accs
 *   loft_acc_lerp_at(x, y, j, n)              acc between two accs, at exactly j / n
 *   loft_acc_lerp_in(x, y, a, lo, hi)         acc between two accs, at exactly the place of a
 *                                             between two reals
 *   loft_acc_lerp3(x, y, z, v, w)             acc between three accs: x at 0 0, y at 1 0, z at 0 1
 *   loft_acc_mean(x, y)                       mean of two accs
 *   loft_acc_abs(x)     loft_real_abs(a)      |x|, |a|
 *   loft_acc_min(x, y)  loft_acc_max(x, y)    the smaller, the larger of two
 *   loft_acc_scale(x, t)                      acc times unit
 *   loft_acc_mul(x, a)  loft_acc_div(x, a)    acc times real, acc divided by real
 *   loft_acc_ratio(x, k)                      acc divided by an integer k >= 1
 *   loft_acc_quot(x, y)                       quotient of two accs as real
 *   loft_acc_valid(x)   loft_acc_round(x)     whether it fits a real; the nearest real
 *   loft_real_valid(a)                        whether it is a valid coordinate: always in q16
 *   loft_acc_ulp(s)     loft_real_ulp(s)      the distance between neighbouring numbers of size s
 *   loft_acc_int(x)     loft_prod_int(a, b)   the nearest integer, ties upward
 *   loft_acc_sqrt(x)                          square root as real
 *   loft_acc_hypot(x, n)                      sqrt(x[0]^2 + .. + x[n-1]^2), without inner overflow
 *   loft_hypot_ulp(s)                         an upper bound of the error of a loft_acc_hypot of s
 *   loft_unit_of(j, n)                        the parameter j / n
 *   loft_unit_ratio(x, y)                     the parameter x / y of two accs
 *   loft_unit_from(a)                         real to unit, |a| < 128, exactly in q16
 *   loft_unit_round(x)                        the unit nearest to an acc, |x| < 128
 *   loft_unit_to_acc(t)                       unit to acc, exactly
 *   loft_real_from_int(i)                     integer to real
 *   loft_real_floor(a)                        the largest integer <= a real
 *   loft_real_from_raw(i)                     raw Q16.16, the form on the wire, to real
 *   loft_raw_from_real(a) loft_raw_valid(a)   real to raw Q16.16; whether it fits
 *   LOFT_REAL(1.25)  LOFT_UNIT(0.5)           constants, folded by the compiler
 *
 * q16 rounds to nearest, ties upward. Nothing saturates and nothing may wrap: each operation states
 * its range, and the algorithms check their ranges once, in init.
 *
 * Only the files in this room may test LOFT_NUM.
 */
#ifndef LOFT_NUM_NUM_H
#define LOFT_NUM_NUM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "config.h"
#include "num/status.h"

#if   LOFT_NUM == LOFT_Q16
#  include "num/q16.h"
#elif LOFT_NUM == LOFT_F32
#  include "num/f32.h"
#elif LOFT_NUM == LOFT_F64
#  include "num/f64.h"
#else
#  error "LOFT_NUM must be LOFT_Q16, LOFT_F32 or LOFT_F64 (see config.h)"
#endif

LOFT_BEGIN_C

/* The square root of a whole number, rounded down.
 *
 *   error   none
 *   cost    8 products of 32 bits, no division; AVR: 140 cycles for each byte of x, without leading
 *           zeros
 */
uint32_t loft_root(uint64_t x);

/* The integer nearest to it.
 *
 *   range   x <= 2^64 - 2^32
 *   error   1/2
 *   cost    as loft_root, and a product
 */
uint32_t loft_root_nearest(uint64_t x);

/* The square root of x.
 *
 *   range   q16: x <= 2^30 - 1/2, above that LOFT_REAL_MAX; a negative x gives 0
 *   error   q16: 1/2 LSB   f32: 0.5001 ulp   f64: 1/2 ulp
 *   cost    q16: loft_root_nearest, no division
 */
loft_real loft_acc_sqrt(loft_acc x);

/* x / y for two accs of any size.
 *
 *   range   y > 0, |x / y| < 32767
 *   error   q16: 1/2 LSB + 2^-30 of the quotient   f32: 1/2 ulp   f64: 1/2 ulp
 *   cost    q16: at most 17 rounds of shift and one division
 */
loft_real loft_acc_quot(loft_acc x, loft_acc y);

#if LOFT_NUM == LOFT_Q16
/* The value that is x at a = lo, y at a = hi, and linear in a between them: no parameter is
 * rounded.
 *
 *   range   lo <= a <= hi, lo < hi; f64: these below 2^1000; q16: |x|, |y| < 2^30
 *   error   q16: 2^-33   f32, f64: 5 ulp of double of the larger of |x|, |y|, and 5 ulp of the
 *           result when both are positive; none at lo and hi
 *   cost    q16: two 64-bit divisions with remainder; floats: two divisions
 */
loft_acc loft_acc_lerp_in(loft_acc x, loft_acc y, loft_real a, loft_real lo, loft_real hi);
#endif

/* The length of the vector x[0..n-1].
 *
 *   range   q16: |x[i]| < 2^29, n = 0..6   f32, f64: any n, the result below DBL_MAX
 *   error   q16: 2^-28 of the result + 2^-32   f32, f64: 2^-50 of the result, normal numbers
 *   cost    q16: n multiplications and one square root
 */
loft_acc loft_acc_hypot(const loft_acc x[], int n);

#if LOFT_NUM == LOFT_Q16

/* The parameter x / y.
 *
 *   range   y > 0, |x| <= 1.5 y
 *   error   2^-25 + 2^-35; none at x = 0 and x = +-y
 *   cost    one 64-bit division
 */
loft_unit loft_unit_ratio(loft_acc x, loft_acc y);

#endif

LOFT_END_C

#endif
