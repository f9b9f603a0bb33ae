/* lib/surface/tensor/revolve.h -- surfaces of revolution: a rational profile turned about the z
 * axis
 * SPDX-License-Identifier: MIT
 *
 * A quarter of a turn is one rational patch: u along the profile, v from 90 k to 90 (k + 1)
 * degrees, counterclockwise seen from above. The profile lies anywhere, also off a plane through
 * the axis.
 *
 *     for (unsigned k = 0; k < 4; k++)
 *         if (loft_tensor_rational_from_revolve(&profile, k, net[k]) == LOFT_OK &&
 *             loft_tensor_rational_init(&quarter[k], net[k], profile.degree, 2) == LOFT_OK) ..
 *
 * Turns by 90 degrees swap coordinates, so the quarters share their edges exactly. With fewer than
 * three axes the profile lies in the plane and turns in it.
 */
#ifndef LOFT_SURFACE_TENSOR_REVOLVE_H
#define LOFT_SURFACE_TENSOR_REVOLVE_H

#include "curve/rational.h"     /* loft_rational, loft_weighted */

LOFT_BEGIN_C

/* The control points of quarter k, rows along the profile: out[3 (degree + 1)]. The weights are w,
 * w sqrt(1/2), w of each point.
 *
 *   range   two axes or more and k = 0..3, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a point does
 *           not fit; *out is then undefined. A patch takes weights from 1/256, so those of the
 *           profile should be at least 0.0056
 *   error   points: none   f32, f64: 1/2 ulp in the middle   weights q16: 1/2 LSB   f32: 1 ulp
 *           f64: 1 ulp
 *   cost    4 sums and a product per point
 *   see     Piegl and Tiller, The NURBS Book, ch. 8.5; the quarter of a circle with weights 1,
 *           sqrt(1/2), 1
 */
enum loft_status loft_tensor_rational_from_revolve(const loft_rational *profile, unsigned k,
                                                   loft_weighted out[]) LOFT_CHECKED;

/* The point of quarter k at (u, v): that of the exact patch, whose weights are not rounded.
 *
 *   range   u and v in 0..1, and k as above, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point
 *           does not fit; *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp of the result + 2^-20 ulp of the largest
 *           control value   f64: 8 degree + 16 ulp of that
 *   cost    in numbers of num/sci.h de Casteljau's algorithm for each axis and the weights, a root
 *           and 5 quotients
 */
enum loft_status loft_revolve_eval(const loft_rational *profile, unsigned k, loft_unit u,
                                   loft_unit v, loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
