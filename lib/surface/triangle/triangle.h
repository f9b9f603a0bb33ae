/* lib/surface/triangle/triangle.h -- Bezier triangles of degree 0..9: points, tangent planes,
 * derivatives, curves on them
 * SPDX-License-Identifier: MIT
 *
 * The control points b_ijk are in the order of barycentric.h: row by row from the corner T1 down to
 * the edge T2 T3. Everything is computed wide and rounded once.
 *
 *     loft_triangle t;
 *     if (loft_triangle_init(&t, points, 3) == LOFT_OK)
 *         p = loft_triangle_eval(&t, (loft_bary) { loft_unit_of(1, 3), loft_unit_of(1, 3) });
 *
 * In the `error` lines ulp is that of the largest control value, and L = |u| + |v| + |w|, which is
 * 1 inside and on the edges. The law of growth: outside, and for directions, each row multiplies
 * values by up to L. The result is LOFT_ERR_RANGE when the product of all rows exceeds 19683
 * (degree 9: L to 3, degree 4: 11, degree 2: 140) or |v| or |w| exceeds 32. So in q16 the error
 * stays below 0.58 LSB. Coordinates are accepted as in curve/bezier.h.
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_H

#include "geom/vec.h"               /* loft_vec, loft_box */
#include "surface/barycentric.h"    /* loft_bary, LOFT_DEGREE_MAX */

LOFT_BEGIN_C

/* A triangle of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t degree;
} loft_triangle;

/* Make a triangle of LOFT_TRIANGLE_POINTS(degree) control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise LOFT_ERR_RANGE; *t
 *           is then untouched
 *   error   none: the points are borrowed
 *   cost    two comparisons per coordinate
 */
enum loft_status loft_triangle_init(loft_triangle *t, const loft_vec p[],
                                    unsigned degree) LOFT_CHECKED;

/* Points
 * ------ */

/* The point at u, by de Casteljau's algorithm.
 *
 *   range   u is clamped to the triangle: cannot fail
 *   error   q16: 1/2 LSB + degree * 2^-17 LSB   f32: 1 ulp   f64: 3 * degree ulp;  exact at the
 *           corners
 *   cost    degree (degree + 1) (degree + 2) / 3 wide products per axis
 *   stack   Cortex-M4 608   Cortex-M0+ 660   ATmega328P 645
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17
 */
loft_vec loft_triangle_eval(const loft_triangle *t, loft_bary u);

/* The point at u, outside the triangle as well.
 *
 *   range   LOFT_ERR_RANGE when the point does not fit or the law of growth fails; *out is then
 *           untouched
 *   error   q16: 1/2 LSB + (1 + L + .. + L^(degree-1)) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 3 * degree * L^degree ulp
 *   cost    as eval
 */
enum loft_status loft_triangle_extrapolate(const loft_triangle *t, loft_bary u,
                                           loft_vec *out) LOFT_CHECKED;

/* The three points of the last row but one. They span the tangent plane at u, and their weighted
 * sum by u, v, w is the point.
 *
 *   range   degree >= 1, otherwise LOFT_ERR_ARG; then as extrapolate
 *   error   as extrapolate with degree - 1
 *   cost    as eval
 */
enum loft_status loft_triangle_tangent(const loft_triangle *t, loft_bary u,
                                       loft_vec out[3]) LOFT_CHECKED;

/* The unit normal, on the side from which T1 T2 T3 turn left, in the first three axes.
 *
 *   range   u is clamped. LOFT_SINGULAR when the three points of loft_triangle_tangent are on a
 *           line, to within a sine of 2^-20, or for fewer than three axes; degree >= 1, otherwise
 *           LOFT_ERR_ARG; *out is then untouched
 *   error   with s the sine of the angle between the two edges at the first of the three points and
 *           l the shorter edge: q16: 2^-17 + (2^-32 + degree * 2^-31 / l) / s, below 2^-14 where s
 *           > 1/64 and s l > 2^-13
 *           f32: 2^-25, f64: 2^-52 (8 + 4 / s), and both 2^-50 degree * largest / (s l)
 *   cost    as eval, and loft_vec_normal
 */
enum loft_status loft_triangle_normal(const loft_triangle *t, loft_bary u,
                                      loft_vec *out) LOFT_CHECKED;

/* The r-th derivative at u in the direction z; 0 for r > degree. The first derivative is degree
 * times the sum of the points of loft_triangle_tangent with the coordinates of z.
 *
 *   range   LOFT_ERR_RANGE when it does not fit or the law of growth fails, with the L of z for r
 *           rows (at least 1); *out is then untouched
 *   error   with f = degree! / (degree - r)!, Z = max(1, |u| + |v| + |w|) of z, m = degree - r:
 *           q16: 1/2 LSB + f ((1 + Z + .. + Z^(r-1)) L^m + 1 + L + .. + L^(m-1)) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 3 f (degree + 1) Z^r L^m ulp
 *   cost    as eval
 *   see     Farin, ch. 17: directional derivatives
 */
enum loft_status loft_triangle_deriv(const loft_triangle *t, unsigned r, loft_bary z, loft_bary u,
                                     loft_vec *out) LOFT_CHECKED;

/* The polar form with `times` arguments a and the others u: (aE)^times (uE)^(degree-times) b.
 *
 *   range   times <= degree, otherwise LOFT_ERR_ARG; then as extrapolate
 *   error   as extrapolate with the larger L
 *   cost    as eval
 *   see     Ramshaw, blossoming
 */
enum loft_status loft_triangle_polar(const loft_triangle *t, unsigned times, loft_bary a,
                                     loft_bary u, loft_vec *out) LOFT_CHECKED;

/* Curves
 * ------
 * `out` has degree + 1 points, the control points of a Bezier curve of the same degree. */

/* The curve on the surface over the straight line from..to in the parameter domain.
 *
 *   range   as extrapolate; `out` is undefined after an error
 *   error   as extrapolate with the larger L, per control point
 *   cost    degree + 1 times up to that of eval
 *   stack   Cortex-M4 1,152   Cortex-M0+ 1,196   ATmega328P 1,173
 *   see     Ramshaw: out[k] = b[from^(degree-k), to^k]
 */
enum loft_status loft_triangle_line(const loft_triangle *t, loft_bary from, loft_bary to,
                                    loft_vec out[]) LOFT_CHECKED;

/* The edge opposite T1 from T2 to T3 (side 0), opposite T2 from T3 to T1 (side 1), opposite T3 from
 * T1 to T2 (side 2).
 *
 *   error   none
 *   cost    copies degree + 1 control points
 */
void loft_triangle_edge(const loft_triangle *t, unsigned side, loft_vec out[]);

/* The box of the control net. The surface over the triangle lies inside. The box need not be the
 * smallest.
 *
 *   error   none for the net; f32, f64: points of eval exceed it by at most their own error
 *   cost    two comparisons per coordinate
 */
loft_box loft_triangle_box(const loft_triangle *t);

LOFT_END_C

#endif
