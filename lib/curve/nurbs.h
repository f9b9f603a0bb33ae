/* lib/curve/nurbs.h -- NURBS: B-spline curves with weights, of degree 1..9 on any knots; points,
 * derivative, rational Bezier spans
 * SPDX-License-Identifier: MIT
 *
 * As bspline.h, with the control points of rational.h: points in space, each with a weight of
 * 1/256..256. For knots and u see bspline.h. A circle of degree 2 with nine points:
 *
 *     loft_nurbs n;
 *     if (loft_nurbs_init(&n, nine, 9, knots, 2) == LOFT_OK)          // 0 0 0 1 1 2 2 3 3 4 4 4
 *         p = loft_nurbs_eval(&n, LOFT_REAL(0.5));
 *
 * In the `error` lines R is the ratio of the largest weight to the smallest, at most 65536, and ulp
 * is that of the largest control value.
 */
#ifndef LOFT_CURVE_NURBS_H
#define LOFT_CURVE_NURBS_H

#include "basis/knots.h"        /* loft_knots */
#include "curve/rational.h"     /* loft_weighted */

LOFT_BEGIN_C

/* Control points and knots are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_weighted *p;
    loft_knots knots;
    int32_t scale;              /* a power of two: scales the largest weight to 2^14 .. 2^15      */
} loft_nurbs;

/* Make a curve of `points` control points and points + degree + 1 knots, which must outlive it.
 *
 *   range   knots as loft_knots_init; weights 1/256..256 and finite coordinates, otherwise
 *           LOFT_ERR_RANGE. *n is untouched after an error
 *   error   none: points and knots are borrowed
 *   cost    two comparisons per coordinate, weight and knot, at most 22 doublings per weight
 */
enum loft_status loft_nurbs_init(loft_nurbs *n, const loft_weighted p[], unsigned points,
                                 const loft_real knots[], unsigned degree) LOFT_CHECKED;

/* The point at u, by de Boor's algorithm for numerator and denominator.
 *
 *   range   u is clamped as in loft_bspline_eval; it cannot fail
 *   error   q16: 1/2 LSB + degree * R * 2^-30 LSB, below 0.501 LSB   f32: 1 ulp   f64: 10 * degree
 *           + 4 ulp
 *   cost    degree * (degree + 1) / 2 times loft_acc_lerp_in per axis and for the weights, a
 *           quotient per axis
 *   stack   Cortex-M4 288   Cortex-M0+ 356   ATmega328P 274
 *   see     Piegl and Tiller, The NURBS Book, ch. 4
 */
loft_vec loft_nurbs_eval(const loft_nurbs *n, loft_real u);

/* The first derivative with respect to u, of the same piece: with the points p0, p1 and weights w0,
 * w1 before the last row, degree / h * w0 w1 / w^2 (p1 - p0), h the length of the span.
 *
 *   range   u as eval; LOFT_ERR_RANGE if the derivative does not fit. *out is untouched then
 *   error   q16: 0.51 LSB + 2^-17 / h LSB   f32, f64: 1/2 ulp of the result + 40 * degree^2 * R / h
 *           ulp of double
 *   cost    eval; degree * (degree + 1) / 2 times loft_acc128_lerp_in per axis and for the weights;
 *           4 long quotients per axis
 *   stack   Cortex-M4 1,004   Cortex-M0+ 1,024   ATmega328P 947
 *   see     Floater, Derivatives of rational Bezier curves, CAGD 9 (1992), extended to knots; The
 *           NURBS Book, ch. 4
 */
enum loft_status loft_nurbs_deriv(const loft_nurbs *n, loft_real u, loft_vec *out) LOFT_CHECKED;

/* The next span as a rational Bezier curve, degree + 1 control points; *span and the result as in
 * loft_bspline_next. Each span scales its weights by a power of two that brings the largest into
 * 128..256.
 *
 *   error   points as eval; weights q16: 1/2 LSB, which is 2^-24 of the largest: the span is the
 *           same curve to within R * 2^-25 of the width of its polygon   f32: 1 ulp   f64: 10 *
 *           degree ulp
 *   cost    degree * (degree + 1) * (degree + 5) / 6 times loft_acc_lerp_in per axis and for the
 *           weights, degree + 1 quotients per axis
 *   stack   Cortex-M4 560   Cortex-M0+ 612   ATmega328P 514
 */
bool loft_nurbs_next(const loft_nurbs *n, unsigned *span, loft_weighted out[]) LOFT_CHECKED;

/* The same curve with one more knot, at u, as loft_bspline_insert.
 *
 *   range   as loft_bspline_insert
 *   error   points q16: 0.501 LSB   f32: 1 ulp   f64: 14 ulp weights q16: 1/2 LSB + 2^-17 LSB,
 *           which may move the curve by more than that   f32: 1 ulp   f64: 6 ulp
 *   cost    degree times loft_acc_lerp_in and a quotient, per axis and for the weights
 */
enum loft_status loft_nurbs_insert(const loft_nurbs *n, loft_real u, loft_weighted p[],
                                   loft_real knots[]) LOFT_CHECKED;

LOFT_END_C

#endif
