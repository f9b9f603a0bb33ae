/* lib/geom/normal.h -- directions: vectors of length 1, and the one at a right angle to two others
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GEOM_NORMAL_H
#define LOFT_GEOM_NORMAL_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

/* x / |x|; LOFT_SINGULAR, and *out untouched, for x = 0.
 *
 *   error   q16: 1/2 LSB + 2^-30 LSB   f32: 1/2 ulp   f64: LOFT_AXES + 4 ulp, of 1
 *   cost    in numbers of num/sci.h one product and one quotient per axis, one square root
 */
enum loft_status loft_vec_unit(const loft_acc x[LOFT_AXES], loft_vec *out) LOFT_CHECKED;

/* The unit vector at a right angle to a and b in the first three axes, on the side from which a
 * turns left to b; LOFT_SINGULAR, and *out untouched, when a or b is 0, when the sine of their
 * angle is below 2^-20, or when there are fewer than three axes. Further axes are 0.
 *
 *   error   with s the sine of the angle: q16: 1/2 LSB + 2^-16 LSB / s   f32: 1/2 ulp + 2^-52 / s
 *           f64: 2^-52 (8 + 4 / s) What a and b err by themselves, e of their length, adds e / s
 *   cost    in numbers of num/sci.h 16 products, 3 quotients, one square root
 */
enum loft_status loft_vec_normal(const loft_acc a[LOFT_AXES], const loft_acc b[LOFT_AXES],
                                 loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
