/* lib/curve/tangent.h -- a curve with weights near one of its points: first and second derivative,
 * curvature
 * SPDX-License-Identifier: MIT
 *
 *     loft_tangent here;
 *     if (loft_nurbs_tangent(&n, u, &here) == LOFT_OK && !here.stops &&
 *         loft_tangent_curvature(&here, false, &k) == LOFT_OK) ..
 *
 * `stops` says that the first derivative is exactly 0, as the given numbers decide: no rounding
 * makes or hides a cusp.
 *
 * In the `error` lines D1 and D2 are the largest terms of the quotient rule: with X the weighted
 * points relative to the point, w the weight, D1 = |X'| / w + |w'| / w |X| / w, likewise D2 with
 * two derivatives and 2 |w'| / w D1. They are at most degree R and 4 degree^2 R^2 times the
 * distance between two control points, divided by the length of the span and its square.
 */
#ifndef LOFT_CURVE_TANGENT_H
#define LOFT_CURVE_TANGENT_H

#include "curve/nurbs.h"        /* loft_nurbs */
#include "curve/rational.h"     /* loft_rational */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

typedef struct {
    loft_sci first[LOFT_AXES], second[LOFT_AXES];
    bool stops;
} loft_tangent;

/* The derivatives at t, and at u: at a knot of the piece behind it, at the end of the domain of the
 * last piece.
 *
 *   range   t in 0..1, otherwise LOFT_ERR_ARG; u is clamped; f32, f64: LOFT_ERR_RANGE unless all
 *           numbers pass loft_exact_valid. *out is untouched after an error
 *   error   stops: none   derivatives: q16: 2^-55 D1, 2^-54 D2   f32, f64: 2^-47 D1, 2^-46 D2
 *   cost    3 (degree + 1) products per axis and for the weights, the weights of num/sci.h with
 *           two derivatives; 32-bit remainders for one prime, or, where the curve stops, for all
 *   see     The NURBS Book, ch. 4: (4.8)
 */
enum loft_status loft_rational_tangent(const loft_rational *r, loft_unit t,
                                       loft_tangent *out) LOFT_CHECKED;
enum loft_status loft_nurbs_tangent(const loft_nurbs *n, loft_real u,
                                    loft_tangent *out) LOFT_CHECKED;

/* The k-th derivative, k = 1 or 2, as a vector.
 *
 *   range   k = 1 or 2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if it does not fit; *out is
 *           untouched then
 *   error   that of the tangent and q16: 1/2 LSB + 2^-17 LSB   f32: 1/2 ulp
 *   cost    a rounding per axis
 */
enum loft_status loft_tangent_deriv(const loft_tangent *at, unsigned k, loft_vec *out) LOFT_CHECKED;

/* The curvature: with `plane` that of the first two axes, positive where the curve turns left,
 * otherwise the length in all axes. A wide value.
 *
 *   range   LOFT_SINGULAR where the curve stops; LOFT_ERR_RANGE if it does not fit a loft_acc; *out
 *           is untouched then
 *   error   with c the curvature, e1 and e2 the errors of the derivatives relative to |P'|:
 *           4 e1 |P''| / |P'|^2 + e2 / |P'|, and q16: 2^-33   f32, f64: 16 ulp of double
 *   cost    LOFT_AXES^2 products, a root and a quotient of num/sci.h
 */
enum loft_status loft_tangent_curvature(const loft_tangent *at, bool plane,
                                        loft_acc *out) LOFT_CHECKED;

LOFT_END_C

#endif
