/* lib/surface/sphere.h -- spheres: points by longitude and colatitude, normals, distances
 * SPDX-License-Identifier: MIT
 *
 * A sphere lies in the first three axes. The other axes have the coordinate of the centre. Plain
 * data, no init.
 *
 *     x = r cos theta sin phi     y = r sin theta sin phi     z = r cos phi       plus the centre
 *
 * Angles are in degrees, unlike elsewhere. A quarter turn is exactly 90, so the poles and the
 * equator have no error. In q16 a degree has 65536 steps; a radian would have as many for 57
 * degrees.
 */
#ifndef LOFT_SURFACE_SPHERE_H
#define LOFT_SURFACE_SPHERE_H

#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

typedef struct {
    loft_vec  centre;
    loft_real radius;       /* >= 0 */
} loft_sphere;

/* The point at longitude theta, colatitude phi (0 at the pole where z is largest).
 *
 *   units   degrees
 *   range   radius >= 0 and angles of -32767..32767, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when
 *           the point does not fit; *out is then untouched
 *   error   q16: 1/2 LSB + 2^-14 LSB   f32: 0.51 ulp of the result + 2^-24 ulp of the radius   f64:
 *           16 ulp of radius and centre; only the sum with the centre is rounded where both angles
 *           are multiples of 90
 *   cost    2 sines, 2 cosines, 2 quotients of 60 rounds in q16
 */
enum loft_status loft_sphere_eval(const loft_sphere *s, loft_real theta, loft_real phi,
                                  loft_vec *out) LOFT_CHECKED;

/* The outward unit normal there; also for a radius of 0.
 *
 *   units   degrees
 *   range   as eval
 *   error   q16: 1/2 LSB + 2^-14 LSB, far below 2^-14   f32: 0.51 ulp of 1   f64: 16 ulp of 1
 *   cost    2 sines, 2 cosines
 */
enum loft_status loft_sphere_normal(const loft_sphere *s, loft_real theta, loft_real phi,
                                    loft_vec *out) LOFT_CHECKED;

/* The derivatives by phi as u and theta as v, per radian, first and second: the normal is outward.
 * At a pole v is 0.
 *
 *   range   as eval; *out is then untouched
 *   error   q16: 2^-55 of the radius   f32, f64: 2^-50 of it
 *   cost    2 sines, 2 cosines, 12 products of num/sci.h
 */
enum loft_status loft_sphere_differential(const loft_sphere *s, loft_real theta, loft_real phi,
                                          loft_differential *out) LOFT_CHECKED;

/* |x - centre| - radius, and (x - centre)^2 - radius^2: negative inside.
 *
 *   range   radius >= 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the result does not fit or, in
 *           floats, loft_exact_valid refuses a number; *out is then untouched
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp   f64: distance 1 ulp of the radius, value 1
 *           ulp
 *   cost    4 exact products, one exact root, one quotient; not for an ISR
 *   stack   Cortex-M4 1,824   Cortex-M0+ 1,816   ATmega328P 2,193
 */
enum loft_status loft_sphere_distance(const loft_sphere *s, loft_vec x,
                                      loft_real *out) LOFT_CHECKED;
enum loft_status loft_sphere_value(const loft_sphere *s, loft_vec x, loft_real *out) LOFT_CHECKED;

/* The unit vector from the centre to x: the normal of the concentric sphere through x.
 *
 *   range   LOFT_SINGULAR at the centre; otherwise as distance
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp   f64: 1 ulp
 *   cost    3 exact products, one exact root, a quotient per axis; not for an ISR
 */
enum loft_status loft_sphere_direction(const loft_sphere *s, loft_vec x,
                                       loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
