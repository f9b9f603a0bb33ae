/* lib/curve/self_crossings.h -- where a Bezier curve of any degree, with weights or without,
 * crosses itself
 * SPDX-License-Identifier: MIT
 *
 *     loft_crossing c[8];
 *     size_t        count;
 *     if (loft_bezier_self_crossings(&b, LOFT_REAL(0.001), c, 8, &count) == LOFT_OK)
 *         for (size_t k = 0; k < count; k++)
 *             use(c[k].s, c[k].t, c[k].point);        // c[k].s < c[k].t
 *
 * shape.h decides the loop of a plane cubic exactly.
 */
#ifndef LOFT_CURVE_SELF_CROSSINGS_H
#define LOFT_CURVE_SELF_CROSSINGS_H

#include "curve/intersect.h"    /* loft_crossing */
#include "curve/rational.h"     /* loft_rational */

LOFT_BEGIN_C

/* Find where b meets itself, in the plane or in space, sorted by s, s < t: out[room]. A closed
 * curve meets itself at its ends.
 *
 *   range   as loft_bezier_intersect. LOFT_SINGULAR: a stretch runs over another one. LOFT_MORE:
 *           there are more than `room`
 *   error   as loft_bezier_intersect, plus half an LSB (ulp) at each point. One crossing for each
 *           connected stretch of s and t with points within tol of each other; none for the one
 *           that holds s = t. So a cusp, and a bend or a loop as narrow as tol, is no crossing, nor
 *           is a loop that stays within 2 tol of its crossing
 *   cost    for each pair of pieces that turn by less than 180 degrees, and that do not do so
 *           together, once loft_bezier_intersect
 *   stack   Cortex-M4 10,848   Cortex-M0+ 11,076   ATmega328P 9,814
 *   see     a curve whose derivatives are all in one half-space does not cross itself: Farin,
 *           Curves and Surfaces for CAGD, hodographs
 */
enum loft_status loft_bezier_self_crossings(const loft_bezier *b, loft_real tol,
                                            loft_crossing out[], size_t room,
                                            size_t *count) LOFT_CHECKED;

/* The same of a curve with weights: of cubics within tol / 16 of it (curve/to_cubics.h), at their
 * parameters.
 *
 *   range   as loft_bezier_self_crossings, but tol >= q16: 64 LSB   f32: 2^-17, f64: 2^-35 of the
 *           largest coordinate
 *   error   as loft_bezier_self_crossings; the points of a crossing at s and t are those of the
 *           curve within tol. Two crossings within 2^-18 of each other in s and in t are one
 *   cost    for n cubics n times loft_bezier_self_crossings, n^2 / 2 times loft_bezier_intersect
 *           and the making of a cubic
 *   stack   Cortex-M4 11,872   Cortex-M0+ 12,100   ATmega328P 10,798
 *   see     as loft_bezier_self_crossings
 */
enum loft_status loft_rational_self_crossings(const loft_rational *r, loft_real tol,
                                              loft_crossing out[], size_t room,
                                              size_t *count) LOFT_CHECKED;

LOFT_END_C

#endif
