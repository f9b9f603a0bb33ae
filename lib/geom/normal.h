/* lib/geom/normal.h -- directions: vectors of length 1, and the one at a right angle to two others
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GEOM_NORMAL_H
#define LOFT_GEOM_NORMAL_H

#include "geom/vec.h"   /* loft_vec */

/* x / |x|; LOFT_SINGULAR, and *out untouched, for x = 0.
 *
 *   range   q16: |x[i]| < 2^29
 *   error   q16: 1/2 LSB + 2^-27 and what 2^-31 in x changes   f32: 1/2 ulp of 1   f64: 4 ulp of 1
 *   cost    one square root, a quotient per axis
 */
enum loft_status loft_vec_unit(const loft_acc x[LOFT_AXES], loft_vec *out) LOFT_CHECKED;

/* The unit vector at a right angle to a and b in the first three axes, b to the left of a seen from its tip;
 * LOFT_SINGULAR, and *out untouched, when a or b is 0, when the sine of their angle is below 2^-20, or when there
 * are fewer than three axes. Further axes are 0.
 *
 *   range   q16: |a[i]|, |b[i]| < 2^29
 *   error   with s the sine of the angle, in q16 and f32: 2^-17 + 2^-22 / s, below 2^-14 where s > 1/64; f64: 2^-50 / s.
 *           An error e in a or b adds e / s of its length
 *   cost    three square roots, 9 quotients
 */
enum loft_status loft_vec_normal(const loft_acc a[LOFT_AXES], const loft_acc b[LOFT_AXES], loft_vec *out) LOFT_CHECKED;

#endif
