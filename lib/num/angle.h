/* lib/num/angle.h -- sine, cosine and the angle of a vector, to the last bits
 * SPDX-License-Identifier: MIT
 *
 * Angles are in radians. Computations with angles need more than the 32 fraction bits of loft_acc,
 * but a small range: loft_fine. On loft_fine numbers, + - < and products by small integers are
 * plain C.
 *
 *   loft_fine   a number below 8 in magnitude   q16: int64_t times 2^60   f32, f64: double
 */
#ifndef LOFT_NUM_ANGLE_H
#define LOFT_NUM_ANGLE_H

#include "num/num.h"    /* loft_real, loft_acc */

LOFT_BEGIN_C

#if LOFT_NUM == LOFT_Q16

typedef int64_t loft_fine;
#define LOFT_FINE_1     ((loft_fine)1 << 60)
#define LOFT_FINE_PI    ((loft_fine)3622009729038561421)

#else

typedef double loft_fine;
#define LOFT_FINE_1     1.0
#define LOFT_FINE_PI    3.141592653589793

#endif

/* True if a coordinate is in the range of these functions. f32, f64: below 2^400. */
bool loft_fine_valid(loft_real a);

/*   range   |a| < 8, |x| < 8
 *   error   of, unit: none   wide: q16: 2^-33   f32, f64: none */
loft_fine loft_fine_of(loft_real a);
loft_fine loft_fine_unit(loft_unit t);
loft_acc  loft_fine_to_acc(loft_fine x);

/* Reduce an angle of any number of turns to -pi..pi.
 *
 *   range   |a| < 2^20
 *   error   q16: 2^-61 of |a| and 2^-60   f32, f64: 2^-51
 */
loft_fine loft_fine_angle(loft_acc a);

/* range   |x| < 8
 *   error   q16: 2^-58   f32, f64: 2^-52
 *   cost    10 products and 9 divisions of 64 bits in q16
 *   see     Taylor series, after reduction to a quarter turn */
loft_fine loft_fine_sin(loft_fine x);
loft_fine loft_fine_cos(loft_fine x);

/* The angle from the first axis to (x, y), within -pi..pi, with the sign of y. For y = 0 it is 0
 * or, where x < 0, pi, also if y is the -0 of floats (C's atan2 gives -pi there). The null vector
 * gives 0.
 *
 *   range   q16: any   f32, f64: |x|, |y| from 2^-500 to 2^1000, or 0
 *   error   q16: 2^-56   f32, f64: 2^-50
 *   cost    three times a sine, a cosine and a quotient
 */
loft_fine loft_fine_atan2(loft_acc y, loft_acc x);

/* Products, quotients and roots. Both arguments of a quotient are loft_fine, or both are loft_acc.
 *
 *   range   mul: |x y| < 8   scale: |a x| < 2^30   quot: y != 0, |x / y| < 2^30
 *           ratio: y != 0, |x / y| < 7   sqrt: 0..1
 *   error   q16: mul 2^-61, scale 2^-33, quot 2^-33, ratio 2^-61, sqrt 2^-59   f32, f64: 1/2 ulp of
 *           double, sqrt 1
 *   cost    ratio: 60 rounds of shift and subtraction in q16; sqrt: 7 to 36 ratios
 */
loft_fine loft_fine_mul(loft_fine x, loft_fine y);
loft_acc  loft_fine_scale(loft_acc a, loft_fine x);
loft_acc  loft_fine_quot(loft_fine x, loft_fine y);
loft_fine loft_fine_ratio(loft_acc x, loft_acc y);
loft_fine loft_fine_sqrt(loft_fine x);

/* Sine, cosine and angle of wide numbers.
 *
 *   range   |a| < 2^20; atan2 as above
 *   error   q16: 2^-33 + 2^-40   f32, f64: 2^-52, atan2 2^-50
 */
loft_acc loft_sin(loft_acc a);
loft_acc loft_cos(loft_acc a);
loft_acc loft_atan2(loft_acc y, loft_acc x);

LOFT_END_C

#endif
