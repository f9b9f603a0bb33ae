/* lib/surface/tensor/ruled.h -- the ruled surface between two Bezier curves
 * SPDX-License-Identifier: MIT
 *
 * Points of equal parameter are joined by straight lines: a at v = 0, b at v = 1. The curves may
 * have different degrees; the patch has the larger one.
 *
 *     loft_vec net[2 * (LOFT_DEGREE_MAX + 1)];
 *     if (loft_tensor_from_ruled(&a, &b, net) == LOFT_OK &&
 *         loft_tensor_init(&s, net, m, 1) == LOFT_OK) ..       // m the larger degree
 *
 * In the `error` lines ulp is that of the largest control value.
 */
#ifndef LOFT_SURFACE_TENSOR_RULED_H
#define LOFT_SURFACE_TENSOR_RULED_H

#include "curve/bezier.h"       /* loft_bezier */

LOFT_BEGIN_C

/* The control points of the patch, rows along u: out[2 i + j], j = 0 of a, 1 of b; 2 (m + 1) of
 * them for the larger degree m.
 *
 *   range   LOFT_ERR_RANGE never in q16; f32, f64: as loft_bezier_elevate
 *   error   that of loft_bezier_elevate; none where a curve has the larger degree already
 *   cost    that of loft_bezier_elevate
 *   stack   Cortex-M4 648   Cortex-M0+ 748   ATmega328P 586
 *   see     Chang, Mathematics of Surfaces: surfaces from curves; Farin, ch. 15
 */
enum loft_status loft_tensor_from_ruled(const loft_bezier *a, const loft_bezier *b,
                                        loft_vec out[]) LOFT_CHECKED;

/* The derivative of order j by u and k by v at (u, v), j <= 2; the point for j = k = 0. It needs no
 * net.
 *
 *   range   u and v in 0..1, j <= 2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the result does not
 *           fit; *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp of the result + 2^-20 ulp   f64: 16 m^j (m + 2)
 *           ulp, m the larger degree
 *   cost    in numbers of num/sci.h de Casteljau's algorithm for both curves per axis
 */
enum loft_status loft_ruled_deriv(const loft_bezier *a, const loft_bezier *b, unsigned j,
                                  unsigned k, loft_unit u, loft_unit v, loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
