/* lib/curve/catmull.h -- Catmull-Rom curves with knots by distance: uniform, centripetal, chordal
 * SPDX-License-Identifier: MIT
 *
 * The segment between p[1] and p[2] of four points, whose knots have the steps |p[i+1] -
 * p[i]|^alpha. alpha 0 is the Catmull-Rom spline of cardinal.h; alpha 1/2 (centripetal) makes no
 * loops and no cusps between points, however unevenly they are spaced; alpha 1 is chordal.
 *
 *     for (size_t i = 0; i + 3 < count; i++)
 *         if (loft_cubic_from_catmull(&points[i], LOFT_UNIT(0.5), &c) == LOFT_OK) ..
 *
 * Two equal neighbours have no knot between them, for any alpha: leave one out.
 *
 * In the `error` lines ulp is that of the largest coordinate.
 */
#ifndef LOFT_CURVE_CATMULL_H
#define LOFT_CURVE_CATMULL_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */

LOFT_BEGIN_C

/* The point at t, and the k-th derivative with respect to t in 0..1 (0 for k > 3).
 *
 *   range   alpha and t in 0..1, otherwise LOFT_ERR_ARG; LOFT_SINGULAR if two neighbours coincide;
 *           LOFT_ERR_RANGE for coordinates that are not valid numbers (f64: below 2^500) and if the
 *           result does not fit; *out is untouched then
 *   error   q16: 1/2 LSB + 2^-14 LSB, exact at 0 and 1; k-th derivative 1/2 LSB + 2^-12 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 128 ulp, k-th derivative 2048 ulp
 *   cost    3 roots; unless alpha is 0, 1/2 or 1, 3 logarithms and exponentials (num/explog.h); 2
 *           quotients per axis
 *   see     Barry, Goldman: A recursive evaluation algorithm for a class of Catmull-Rom splines,
 *           SIGGRAPH 1988; Yuksel, Schaefer, Keyser: Parameterization and applications of
 *           Catmull-Rom curves, CAD 43 (2011)
 */
enum loft_status loft_catmull_eval(const loft_vec p[4], loft_unit alpha, loft_unit t,
                                   loft_vec *out) LOFT_CHECKED;
enum loft_status loft_catmull_deriv(const loft_vec p[4], loft_unit alpha, unsigned k, loft_unit t,
                                    loft_vec *out) LOFT_CHECKED;

/* The control points of that segment.
 *
 *   range   as eval; LOFT_ERR_RANGE if one does not fit; *out is undefined then
 *   error   as eval, none at the ends
 *   cost    as eval
 */
enum loft_status loft_cubic_from_catmull(const loft_vec p[4], loft_unit alpha,
                                         loft_cubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
