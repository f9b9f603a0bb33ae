/* lib/curve/knot_removal.h -- B-splines and NURBS with fewer knots, near the given ones
 * SPDX-License-Identifier: MIT
 *
 *     loft_acc far;
 *     if (loft_bspline_remove(&b, knot, p, k, &far) == LOFT_OK && far <= tol)
 *         status = loft_bspline_init(&b, p, points - 1, k, degree);
 *
 * What loft_bspline_insert adds is taken away again. `far` bounds the distance of the curves at
 * each parameter, so the bounds of several knots add up.
 */
#ifndef LOFT_CURVE_KNOT_REMOVAL_H
#define LOFT_CURVE_KNOT_REMOVAL_H

#include "curve/bspline.h"      /* loft_bspline */
#include "curve/nurbs.h"        /* loft_nurbs */

LOFT_BEGIN_C

/* The curve without one knot: points - 1 control points, points + degree knots, which must not be
 * the curve's own arrays. Only the points next to the knot change, degree less its multiplicity of
 * them.
 *
 *   range   knot: an index of a knot within the domain, not at its ends, and at most degree times
 *           there, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a control point does not fit; nothing
 *           is written then. f32, f64: coordinates below 2^100
 *   error   far: not smaller than the distance of the two curves at any parameter, less q16: 2^-28
 *           f32, f64: 2^-44 of the largest coordinate; not larger than that of the control polygons
 *           once the knot is inserted again
 *   cost    degree quotients and 3 degree products of num/sci.h per axis
 *   see     Tiller, Knot-removal algorithms for NURBS curves and surfaces, CAD 24 (1992); The NURBS
 *           Book, A5.8
 */
enum loft_status loft_bspline_remove(const loft_bspline *b, unsigned knot, loft_vec p[],
                                     loft_real knots[], loft_acc *far) LOFT_CHECKED;

/* The same with weights.
 *
 *   range   as above; LOFT_ERR_RANGE also if a weight is outside 1/256..256
 *   error   far: not smaller than the distance at any parameter, less q16: 2^-28   f32, f64: 2^-44
 *           of the largest coordinate. Larger than that of the points once the knot is inserted
 *           again by no more than the change of a weight, relative to it, times the largest
 *           distance of the points that count there. q16: a rounded weight w adds 2^-17 / w of it
 *   cost    as above with one axis more; 2 degree + 2 distances of points for each changed one
 */
enum loft_status loft_nurbs_remove(const loft_nurbs *n, unsigned knot, loft_weighted p[],
                                   loft_real knots[], loft_acc *far) LOFT_CHECKED;

LOFT_END_C

#endif
