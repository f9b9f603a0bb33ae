/* lib/surface/triangle/triangle_curvature.h -- the curvature of a Bezier triangle at a corner
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_CURVATURE_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_CURVATURE_H

#include "surface/triangle/triangle.h"       /* loft_triangle */

LOFT_BEGIN_C

/* The normal curvature at the corner T1 in the direction z, positive where the surface curves to
 * the side from which T1 T2 T3 turn left. It is <S'', N> / |S'|^2 with the derivatives in the
 * direction z and the unit normal N, in the first three axes. To have it elsewhere, split the
 * triangle or take a sub-triangle.
 *
 *   range   degree >= 1, otherwise LOFT_ERR_ARG; |v|, |w| < 127 of z, coordinates that
 *           loft_exact_valid accepts, and a curvature that fits, otherwise LOFT_ERR_RANGE;
 *           LOFT_SINGULAR, decided exactly, where there is no normal or S' is 0, and for fewer than
 *           three axes; *out is then untouched
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp   f64: 1 ulp
 *   cost    about 60 exact products, a root and a quotient; not for an ISR
 *   stack   Cortex-M4 3,992   Cortex-M0+ 3,976   ATmega328P 5,287
 *   see     do Carmo, Differential Geometry of Curves and Surfaces, 3-2
 */
enum loft_status loft_triangle_corner_curvature_vec(const loft_triangle *t, loft_bary z,
                                                    loft_real *out) LOFT_CHECKED;

LOFT_END_C

#endif
