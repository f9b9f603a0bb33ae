/* lib/curve/tcb.h -- curves through points with tension, continuity and bias at each point
 * SPDX-License-Identifier: MIT
 *
 * The segment between p[1] and p[2] of four points is the cubic with the tangents
 *
 *     T1 = (1-t)(1+c)(1+b)/2 (p1 - p0) + (1-t)(1-c)(1-b)/2 (p2 - p1)     t c b of p[1]
 *     T2 = (1-t)(1-c)(1+b)/2 (p2 - p1) + (1-t)(1+c)(1-b)/2 (p3 - p2)     t c b of p[2]
 *
 * Tension t draws the curve tight, continuity c other than 0 makes a corner, bias b turns the
 * tangent toward the chord before (1) or behind (-1). All 0 is the Catmull-Rom spline; c = b = 0 is
 * a cardinal spline. Animators know these as Kochanek-Bartels splines.
 *
 *     const loft_tcb smooth = { 0, 0, 0 }, tight = { LOFT_UNIT(0.5), 0, 0 };
 *     for (size_t i = 0; i + 3 < count; i++)
 *         if (loft_cubic_from_tcb(&points[i], &smooth, &tight, &c) == LOFT_OK) ..
 *
 * In the `error` lines ulp is that of the largest coordinate.
 */
#ifndef LOFT_CURVE_TCB_H
#define LOFT_CURVE_TCB_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */

LOFT_BEGIN_C

typedef struct {
    loft_unit tension, continuity, bias;        /* -2..2, usually -1..1 */
} loft_tcb;

/* The tangents at p[1] (out[0]) and at p[2] (out[1]).
 *
 *   range   all of k1 and k2 in -2..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if one does not fit
 *           or a coordinate is not a valid number; *out is then undefined
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp of the result + 2^-20 ulp   f64: 128 ulp
 *   cost    12 products of num/sci.h, and 4 per axis
 *   see     Kochanek, Bartels: Interpolating splines with local tension, continuity, and bias
 *           control, SIGGRAPH 1984
 */
enum loft_status loft_tcb_tangents(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                   loft_vec out[2]) LOFT_CHECKED;

/* The point at t, and the k-th derivative with respect to t (0 for k > 3).
 *
 *   range   t in 0..1, otherwise LOFT_ERR_ARG; k1 and k2 as above; LOFT_ERR_RANGE if the result
 *           does not fit; *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-14 LSB, k-th derivative 1/2 LSB + 2^-12 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 256 ulp, k-th derivative 4096 ulp
 *   cost    that of the tangents, and at most 6 wide lerps per axis
 */
enum loft_status loft_tcb_eval(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                               loft_unit t, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_tcb_deriv(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                unsigned k, loft_unit t, loft_vec *out) LOFT_CHECKED;

/* The control points of that segment.
 *
 *   range   k1 and k2 as above; LOFT_ERR_RANGE if one does not fit; *out is undefined then
 *   error   as eval, none at the ends
 *   cost    that of the tangents, and 4 divisions by small numbers per axis
 */
enum loft_status loft_cubic_from_tcb(const loft_vec p[4], const loft_tcb *k1, const loft_tcb *k2,
                                     loft_cubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
