/* lib/geom/normal.h -- unit vectors: a direction, and the normal to two vectors
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GEOM_NORMAL_H
#define LOFT_GEOM_NORMAL_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

/* x / |x|. For x = 0 it returns LOFT_SINGULAR and leaves *out untouched.
 *
 *   error   q16: 1/2 LSB + 2^-30 LSB   f32: 1/2 ulp   f64: LOFT_AXES + 4 ulp, of 1
 *   cost    in numbers of num/sci.h one product and one quotient per axis, one square root
 */
enum loft_status loft_vec_unit(const loft_acc x[LOFT_AXES], loft_vec *out) LOFT_CHECKED;

/* The unit vector perpendicular to a and b in the first three axes, on the side from which a turns
 * left to b. Further axes are 0. It returns LOFT_SINGULAR, and leaves *out untouched, if a or b is
 * 0, if the sine of their angle is below 2^-20, or with fewer than three axes.
 *
 *   error   with s the sine of the angle:
 *           q16: 1/2 LSB + 2^-16 LSB / s   f32: 1/2 ulp + 2^-52 / s   f64: 2^-52 (8 + 4 / s) Errors
 *           of a and b themselves, e of their length, add e / s
 *   cost    in numbers of num/sci.h 16 products, 3 quotients, one square root
 */
enum loft_status loft_vec_normal(const loft_acc a[LOFT_AXES], const loft_acc b[LOFT_AXES],
                                 loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
