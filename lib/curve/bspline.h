/* lib/curve/bspline.h -- B-spline curves of degree 1..9 on any knots: points, derivatives, Bezier
 * spans, knot insertion
 * SPDX-License-Identifier: MIT
 *
 * Control points and knots are borrowed (basis/knots.h states which knots are valid). The parameter
 * u is a real in the units of the knots. A point is computed in wide numbers and rounded once; the
 * place of u between its knots is not rounded.
 *
 *     loft_bspline b;
 *     if (loft_bspline_init(&b, points, 7, knots, 3) == LOFT_OK)      // 11 knots
 *         p = loft_bspline_eval(&b, LOFT_REAL(2.5));
 *
 * Walking, flattening, measuring and motion need Bezier curves. The spans are returned one by one
 * as Bezier curves, in memory of the caller:
 *
 *     loft_vec out[4];
 *     for (unsigned span = 0; loft_bspline_next(&b, &span, out); )
 *         ...                             // u from knots[span] to knots[span + 1]
 *
 * In the `error` lines ulp is that of the largest control value. Valid coordinates are those of
 * bezier.h.
 */
#ifndef LOFT_CURVE_BSPLINE_H
#define LOFT_CURVE_BSPLINE_H

#include "basis/knots.h"        /* loft_knots */
#include "geom/vec.h"           /* loft_vec */

LOFT_BEGIN_C

/* Control points and knots are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    loft_knots knots;
} loft_bspline;

/* Make a curve of `points` control points and points + degree + 1 knots, which must outlive it.
 *
 *   range   knots as loft_knots_init; finite coordinates, otherwise LOFT_ERR_RANGE. *b is untouched
 *           after an error
 *   error   none: points and knots are borrowed
 *   cost    two comparisons per coordinate and per knot
 */
enum loft_status loft_bspline_init(loft_bspline *b, const loft_vec p[], unsigned points,
                                   const loft_real knots[], unsigned degree) LOFT_CHECKED;

/* The point at u, by de Boor's algorithm.
 *
 *   range   u is clamped to the domain (nan to its start); it cannot fail. At a knot where the
 *           curve jumps (degree + 1 times) the piece to the right is used, at the end of the domain
 *           the last one
 *   error   q16: 1/2 LSB + degree * 2^-17 LSB   f32: 1 ulp   f64: 5 * degree + 1 ulp
 *   cost    degree * (degree + 1) / 2 times loft_acc_lerp_in per axis
 *   stack   Cortex-M4 280   Cortex-M0+ 348   ATmega328P 260
 *   see     de Boor (1972); Piegl and Tiller, The NURBS Book, ch. 3
 */
loft_vec loft_bspline_eval(const loft_bspline *b, loft_real u);

/* The k-th derivative with respect to u, of the same piece; 0 for k > degree.
 *
 *   range   u as eval; LOFT_ERR_RANGE if the derivative does not fit: it is up to 2^k f / h^k times
 *           a coordinate, f = degree! / (degree - k)!, h the length of the span. *out is untouched
 *           after an error
 *   error   q16: 1/2 LSB + (k + (2^k * degree + k) * f / h^k) * 2^-17 LSB
 *           f32, f64: 1/2 ulp of the result + 5 * (degree + k) * 2^k * f / h^k ulp of double
 *   cost    as eval, k * (k + 1) * (k + 5) / 6 times loft_acc_lerp_in more, k long quotients per
 *           axis
 *   see     The NURBS Book, ch. 3: derivatives of a B-spline curve; Ramshaw, blossoming
 */
enum loft_status loft_bspline_deriv(const loft_bspline *b, unsigned k, loft_real u,
                                    loft_vec *out) LOFT_CHECKED;

/* The next span as a Bezier curve, degree + 1 control points; empty spans are skipped. *span is 0
 * before the first span, then the index of the knot where the span begins. After the last span the
 * result is false and *span is 0 again.
 *
 *   error   per control point as eval; where two spans meet without a jump they have the same
 *           control point to 1 LSB
 *   cost    degree * (degree + 1) * (degree + 5) / 6 times loft_acc_lerp_in per axis
 *   stack   Cortex-M4 464   Cortex-M0+ 540   ATmega328P 418
 *   see     Ramshaw, blossoming; Boehm, CAD 12 (1980)
 */
bool loft_bspline_next(const loft_bspline *b, unsigned *span, loft_vec out[]) LOFT_CHECKED;

/* The same curve with one more knot, at u: points + 1 control points, points + degree + 2 knots.
 * Both may be the curve's own arrays, if they are large enough. Call init with the new ones
 * afterwards.
 *
 *   range   u within the domain and at most degree times a knot there, otherwise LOFT_ERR_ARG, and
 *           nothing is written
 *   error   q16: control points 1/2 LSB + 2^-17 LSB, and the curve at most as much   f32: 1 ulp
 *           f64: 6 ulp
 *   cost    degree times loft_acc_lerp_in per axis; moves the points and knots behind u
 *   see     Boehm, Inserting new knots into B-spline curves, CAD 12 (1980)
 */
enum loft_status loft_bspline_insert(const loft_bspline *b, loft_real u, loft_vec p[],
                                     loft_real knots[]) LOFT_CHECKED;

LOFT_END_C

#endif
