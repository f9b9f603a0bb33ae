/* lib/curve/cardinal.h -- cardinal splines: a curve through points, with tangents parallel to
 * chords
 * SPDX-License-Identifier: MIT
 *
 * The segment between p[1] and p[2] of four points has the tangents s (p[2] - p[0]) and s (p[3] -
 * p[1]) with s = (1 - tension) / 2. Tension 0 is the Catmull-Rom spline; tension 1 has straight
 * segments that stop at each point. Segments of consecutive points join with equal derivatives, and
 * each depends on four points only:
 *
 *     for (size_t i = 0; i + 3 < count; i++)
 *         if (loft_cubic_from_cardinal(&points[i], tension, &c) == LOFT_OK) ..
 *
 * In the `error` lines L = |1 - t| + |t|, S = 1 + |1 - tension|, and ulp is that of the largest
 * coordinate.
 */
#ifndef LOFT_CURVE_CARDINAL_H
#define LOFT_CURVE_CARDINAL_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */

LOFT_BEGIN_C

/* The point at t, and the k-th derivative with respect to t (0 for k > 3).
 *
 *   range   t in -1..2 and tension in -60..60, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the result
 *           does not fit. *out is untouched after an error. f64: coordinates below 2^1000
 *   error   eval: q16: 1/2 LSB + (2 L^3 + 1 + L + L^2) * 2^-17 LSB, exact at 0 and 1
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 96 S L^3 ulp
 *           deriv, 1 <= k <= 3, m = 3 - k: q16: 1/2 LSB + (2^k (3!/m!) L^m + 1 + .. + L^(m-1)) *
 *           2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 96 S L^m (3!/m!) ulp
 *   cost    2 wide products and at most 6 wide lerps per axis; safe in an ISR
 *   see     Catmull, Rom: A class of local interpolating splines (1974)
 */
enum loft_status loft_cardinal_eval(const loft_vec p[4], loft_unit tension, loft_unit t,
                                    loft_vec *out) LOFT_CHECKED;
enum loft_status loft_cardinal_deriv(const loft_vec p[4], loft_unit tension, unsigned k,
                                     loft_unit t, loft_vec *out) LOFT_CHECKED;

/* The control points of that segment.
 *
 *   range   tension as above; LOFT_ERR_RANGE if one does not fit; *out is undefined then
 *   error   q16: 1/2 LSB + 2^-16 LSB, none at the ends   f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: 4 S ulp
 *   cost    2 wide products and 4 divisions by small numbers per axis
 */
enum loft_status loft_cubic_from_cardinal(const loft_vec p[4], loft_unit tension,
                                          loft_cubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
