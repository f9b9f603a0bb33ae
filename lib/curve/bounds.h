/* lib/curve/bounds.h -- the smallest box around a Bezier curve
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_BOUNDS_H
#define LOFT_CURVE_BOUNDS_H

#include "curve/bezier.h"   /* loft_bezier, loft_box */

LOFT_BEGIN_C

/* The box around the curve over 0..1. No point of the curve is outside, rounded or not; no side is
 * outside that of loft_bezier_box, the box of the control points.
 *
 *   error   q16: each side is at most 1 LSB beyond the nearest coordinate that holds the curve
 *           f32: 3 ulp of the side   f32, f64: 2^-42 of the largest coordinate of the axis
 *   cost    nothing for an axis without extrema between the ends; otherwise about 40 pieces for
 *           each extremum, of degree * (degree + 1) * (degree + 5) / 6 wide lerps (cubic: 16)
 *   stack   Cortex-M4 536   Cortex-M0+ 628   ATmega328P 522
 *   see     Lane & Riesenfeld, Bounds on a polynomial, BIT 21 (1981): extrema by Bernstein
 *           subdivision
 */
loft_box loft_bezier_bounds(const loft_bezier *b);

LOFT_END_C

#endif
