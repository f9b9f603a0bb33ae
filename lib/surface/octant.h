/* lib/surface/octant.h -- an eighth of a sphere as a rational Bezier triangle of degree 4
 * SPDX-License-Identifier: MIT
 *
 * The surface is an exact sphere: with the weights as given here x^2 + y^2 + z^2 = r^2. T1, T2, T3
 * are the ends of the first, second and third axis; other axes are 0.
 */
#ifndef LOFT_SURFACE_OCTANT_H
#define LOFT_SURFACE_OCTANT_H

#include "curve/rational.h"         /* loft_weighted */
#include "surface/barycentric.h"    /* loft_bary */

LOFT_BEGIN_C

/* The point of the unit sphere at u, which is also its normal.
 *
 *   range   u is clamped to the triangle: cannot fail
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp + 2^-48   f64: 2^-47
 *   cost    in numbers of num/sci.h about 300 products and as many sums, 9 quotients, 2 square
 *           roots
 *   see     Farin, Piper, Worsey, The octant of a sphere as a non-degenerate triangular Bezier
 *           patch (CAGD 4, 1987)
 */
loft_vec loft_octant_eval(loft_bary u);

/* The control points of the octant of radius r around the origin, for loft_triangle_rational_init.
 * Their weights are between 106 and 163.
 *
 *   range   0 <= r; LOFT_ERR_RANGE otherwise
 *   error   points q16: 1/2 LSB   f32: 1/2 ulp   f64: 2^-47 r; weights are rounded to coordinates.
 *           The surface is a sphere to within q16: 1.5 LSB + 2^-22 r   f32: 2^-22 r   f64:
 *           2^-46 r
 *   cost    15 products per axis, 9 quotients, 2 square roots in numbers of num/sci.h
 */
enum loft_status loft_octant_from_radius(loft_real r, loft_weighted out[15]) LOFT_CHECKED;

LOFT_END_C

#endif
