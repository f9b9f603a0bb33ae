/* lib/surface/triangle/triangle_integral.h -- the integral of a Bernstein polynomial over a plane
 * triangle
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_INTEGRAL_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_INTEGRAL_H

#include "geom/vec.h"           /* loft_vec */

LOFT_BEGIN_C

/* The signed area of the triangle t in the first two axes, counterclockwise positive, and the
 * integral over it of the polynomial with the triangular net b, in the order of barycentric.h: its
 * mean value times the area.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a result does not fit a loft_acc
 *           (q16: 2^31), f32, f64: and unless coordinates pass loft_exact_valid; the results are
 *           untouched after an error
 *   error   area: q16: 2^-33   f32, f64: 2^-47 of it, 0 exactly for points on a line
 *           integral: q16: 2^-33 + 2^-59 of it   f32, f64: 2^-46 of the largest |b| times the area
 *   cost    a sum per coefficient; loft_sci_cross, a product and a quotient of num/sci.h
 *   see     Chang, Mathematics of Surfaces, (2-19)
 */
enum loft_status loft_triangle_integral(const loft_real b[], unsigned degree, const loft_vec t[3],
                                        loft_acc *area, loft_acc *integral) LOFT_CHECKED;

LOFT_END_C

#endif
