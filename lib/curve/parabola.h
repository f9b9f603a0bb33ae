/* lib/curve/parabola.h -- the parabola through three points
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_PARABOLA_H
#define LOFT_CURVE_PARABOLA_H

#include "geom/vec.h"           /* loft_vec */

LOFT_BEGIN_C

/* The curve of degree 2 through p[i] at the parameter t[i], as the control points of its piece
 * from..to (in the same parameter; from > to reverses it).
 *
 *   range   LOFT_SINGULAR if two of t are equal; LOFT_ERR_RANGE if a control point does not fit;
 *           f32, f64: numbers that pass loft_exact_valid, otherwise LOFT_ERR_RANGE. out is
 *           undefined after an error
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 0.52 ulp, f64: 1 ulp of the result
 *   cost    as 3 loft_parabola_eval per axis; not for an ISR
 *   stack   Cortex-M4 2,400   Cortex-M0+ 2,392   ATmega328P 2,735
 *   see     basis/interp.h
 */
enum loft_status loft_bezier_from_parabola(const loft_real t[3], const loft_vec p[3],
                                           loft_real from, loft_real to,
                                           loft_vec out[3]) LOFT_CHECKED;

LOFT_END_C

#endif
