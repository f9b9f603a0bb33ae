/* lib/curve/tangent.h -- a curve with weights near one of its points: derivatives, curvature,
 * torsion, Frenet's frame
 * SPDX-License-Identifier: MIT
 *
 *     loft_tangent here;
 *     if (loft_nurbs_tangent(&n, u, &here) == LOFT_OK && !here.stops &&
 *         loft_tangent_curvature(&here, false, &k) == LOFT_OK) ..
 *
 * `stops` says that the first derivative is exactly 0, as the given numbers decide: no rounding
 * makes or hides a cusp.
 *
 * In the `error` lines D1, D2 and D3 are the largest terms of the quotient rule: with X the
 * weighted points relative to the point, w the weight, D1 = |X'| / w + |w'| / w |X| / w, D2 with
 * two derivatives and 2 |w'| / w D1, D3 with three and 3 |w'| / w D2 + 3 |w''| / w D1. They are at
 * most degree R, 4 degree^2 R^2 and 24 degree^3 R^3 times the distance between two control points,
 * divided by the length of the span, its square and its cube.
 */
#ifndef LOFT_CURVE_TANGENT_H
#define LOFT_CURVE_TANGENT_H

#include "curve/nurbs.h"        /* loft_nurbs */
#include "curve/rational.h"     /* loft_rational */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

typedef struct {
    loft_sci first[LOFT_AXES], second[LOFT_AXES], third[LOFT_AXES];
    bool stops;
} loft_tangent;

/* The derivatives at t, and at u: at a knot of the piece behind it, at the end of the domain of the
 * last piece.
 *
 *   range   t in 0..1, otherwise LOFT_ERR_ARG; u is clamped; f32, f64: LOFT_ERR_RANGE unless all
 *           numbers pass loft_exact_valid. *out is untouched after an error
 *   error   stops: none   derivatives: q16: 2^-55 D1, 2^-54 D2, 2^-53 D3   f32, f64: 2^-47 D1,
 *           2^-46 D2, 2^-45 D3
 *   cost    4 (degree + 1) products per axis and for the weights, the weights of num/sci.h with
 *           three derivatives; 32-bit remainders for one prime, or, where the curve stops, for all
 *   see     The NURBS Book, ch. 4: (4.8)
 */
enum loft_status loft_rational_tangent(const loft_rational *r, loft_unit t,
                                       loft_tangent *out) LOFT_CHECKED;
enum loft_status loft_nurbs_tangent(const loft_nurbs *n, loft_real u,
                                    loft_tangent *out) LOFT_CHECKED;

/* The k-th derivative, k = 1 to 3, as a vector.
 *
 *   range   k = 1 to 3, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if it does not fit; *out is
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

/* The torsion: how fast the osculating plane turns about the tangent, per length; positive for a
 * right-handed screw. A wide value.
 *
 *   range   three axes or more, of which the first three count, otherwise LOFT_ERR_ARG;
 *           LOFT_SINGULAR where the curve stops or |P' x P''| < 2^-40 |P'| |P''|, as along a
 *           straight line; LOFT_ERR_RANGE if it does not fit a loft_acc; *out is untouched then
 *   error   with A, B, C the lengths of the derivatives, a, b, c their errors, S = |P' x P''|:
 *           2 (a B C + b A C + c A B) / S^2 + 8 |torsion| (a B + b A) / S, and q16: 2^-33   f32,
 *           f64: 16 ulp of double
 *   cost    16 products and a quotient of num/sci.h
 *   see     do Carmo, Differential Geometry of Curves and Surfaces, ch. 1-5
 */
enum loft_status loft_tangent_torsion(const loft_tangent *at, loft_acc *out) LOFT_CHECKED;

/* Frenet's frame: the unit vectors along the curve, to the centre of its circle of curvature, and
 * at a right angle to both (the cross product of the two).
 *
 *   range   as loft_tangent_torsion; frame[] is untouched after an error
 *   error   with a, b, A, B, S as there: tangent 2 a / A, the others 6 (a B + b A) / S, and q16:
 *           1/2 LSB + 2^-16 LSB   f32: 1/2 ulp + 2^-40   f64: 2^-48
 *   cost    30 products, 2 roots and 6 quotients of num/sci.h
 */
enum loft_status loft_tangent_frenet(const loft_tangent *at, loft_vec frame[3]) LOFT_CHECKED;

LOFT_END_C

#endif
