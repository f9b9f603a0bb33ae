/* lib/surface/triangle/triangle_rational.h -- rational Bezier triangles of degree 0..9: points and
 * derivatives
 * SPDX-License-Identifier: MIT
 *
 * Every control point has a weight; curve/rational.h has the range of weights in q16. The control
 * points are in the order of barycentric.h and lie in space, not multiplied by their weights. In
 * the `error` lines R is the largest weight over the smallest, at most 65536, and ulp is that of
 * the largest control value.
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_RATIONAL_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_RATIONAL_H

#include "curve/rational.h"         /* loft_weighted */
#include "surface/barycentric.h"    /* loft_bary */

LOFT_BEGIN_C

/* A triangle of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_weighted *p;
    int32_t scale;              /* a power of two; scale * the largest weight is in 2^14 .. 2^15 */
    uint8_t degree;
} loft_triangle_rational;

/* Make a triangle of LOFT_TRIANGLE_POINTS(degree) control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; weights 1/256..256 and finite coordinates,
 *           otherwise LOFT_ERR_RANGE; *t is then untouched
 *   error   none: the points are borrowed
 *   cost    three comparisons per control point and two per coordinate
 */
enum loft_status loft_triangle_rational_init(loft_triangle_rational *t, const loft_weighted p[],
                                             unsigned degree) LOFT_CHECKED;

/* The point at u, by de Casteljau's algorithm for numerator and denominator.
 *
 *   range   u is clamped to the triangle: cannot fail
 *   error   q16: 1/2 LSB + degree * R * 2^-30 LSB, below 0.501 LSB   f32: 1 ulp   f64: 6 * degree +
 *           4 ulp
 *   cost    LOFT_AXES + 1 times degree (degree + 1) (degree + 2) / 3 wide products, a quotient per
 *           axis; 450 bytes of stack
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: rational Bezier triangles
 */
loft_vec loft_triangle_rational_eval(const loft_triangle_rational *t, loft_bary u);

/* The derivative at u in the direction z, by the quotient rule.
 *
 *   range   u inside the triangle, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the derivative does
 *           not fit (it may be degree * R times the distance of two points); *out is then untouched
 *   error   with Z = |u| + |v| + |w| of z: q16: 1/2 LSB + degree (degree + 1) Z R * 2^-26 LSB
 *           f32, f64: 1/2 ulp of the result + 16 degree (degree + 1) Z R ulp of double
 *   cost    in numbers of num/sci.h, LOFT_AXES + 1 times degree (degree + 1) (degree + 2) / 2
 *           products and as many sums;
 *           q16: 1.1 kB of stack
 */
enum loft_status loft_triangle_rational_deriv(const loft_triangle_rational *t, loft_bary z,
                                              loft_bary u, loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
