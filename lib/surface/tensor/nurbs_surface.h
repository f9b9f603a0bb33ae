/* lib/surface/tensor/nurbs_surface.h -- B-spline and NURBS surfaces of degrees 1..9 x 1..9
 * SPDX-License-Identifier: MIT
 *
 * A net of rows x columns control points, row by row, with a knot vector along each direction: u
 * from row to row, v within a row. Knots and parameters as in curve/bspline.h: reals of any size,
 * clamped at the ends or not.
 *
 *     loft_nurbs_surface s;
 *     if (loft_nurbs_surface_init(&s, net, rows, columns, u_knots, 3, v_knots, 2) == LOFT_OK &&
 *         loft_nurbs_surface_eval(&s, u, v, &p) == LOFT_OK) ..
 *
 * At a knot the piece behind it counts, at the end of the domain the last one. Whether there is a
 * normal is decided exactly. In the `error` lines h and g are the lengths of the spans along u and
 * v, R is the ratio of the largest weight to the smallest (1 without weights), ulp that of the
 * largest control value.
 */
#ifndef LOFT_SURFACE_TENSOR_NURBS_SURFACE_H
#define LOFT_SURFACE_TENSOR_NURBS_SURFACE_H

#include "basis/knots.h"            /* loft_knots */
#include "curve/rational.h"         /* loft_weighted */
#include "surface/differential.h"   /* loft_differential */
#include "surface/surface.h"        /* loft_surface */

LOFT_BEGIN_C

/* Control points and knots are borrowed. Do not fill it yourself: call an init. */
typedef struct {
    const loft_vec *p;              /* without weights, otherwise NULL */
    const loft_weighted *weighted;
    loft_knots u, v;
} loft_nurbs_surface;

/* Make a surface of rows x columns points, with rows + degree_u + 1 knots u and columns +
 * degree_v + 1 knots v, all of which must outlive it; by weighted points, or without weights.
 *
 *   range   knots as loft_knots_init; weights 1/256..256 and finite coordinates, otherwise
 *           LOFT_ERR_RANGE. *s is untouched after an error
 *   error   none: points and knots are borrowed
 *   cost    two comparisons per coordinate, weight and knot
 */
enum loft_status loft_nurbs_surface_init(loft_nurbs_surface *s, const loft_weighted p[],
                                         unsigned rows, unsigned columns, const loft_real u[],
                                         unsigned degree_u, const loft_real v[],
                                         unsigned degree_v) LOFT_CHECKED;
enum loft_status loft_bspline_surface_init(loft_nurbs_surface *s, const loft_vec p[], unsigned rows,
                                           unsigned columns, const loft_real u[], unsigned degree_u,
                                           const loft_real v[], unsigned degree_v) LOFT_CHECKED;

/* The parameters at the shares s and t of the domain, 0..1.
 *
 *   range   shares are clamped
 *   error   q16: 1/2 LSB   f32: 1 ulp   f64: 3 ulp of the largest knot
 *   cost    two lerps
 */
void loft_nurbs_surface_at(const loft_nurbs_surface *f, loft_unit s, loft_unit t, loft_real out[2]);

/* The derivative of order j by u and k by v, j + k <= 2; the point for j = k = 0.
 *
 *   range   u and v are clamped to the domain; j + k <= 2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE
 *           if the result does not fit; *out is untouched then
 *   error   with E = (2 degree_u R / h)^j (2 degree_v R / g)^k times the largest distance between
 *           two control points: q16: 1/2 LSB + 2^-16 LSB + 2^-54 E   f32: 1/2 ulp of the result +
 *           2^-46 E   f64: 1/2 ulp of the result + 2^-46 E; for the point 64 ulp
 *   cost    the B-splines with their derivatives (basis/knots_basis.h), and two products of
 *           num/sci.h per control point and axis
 *   stack   Cortex-M4 2,292   Cortex-M0+ 2,312   ATmega328P 1,652
 *   see     The NURBS Book, ch. 3.4 and 4.4
 */
enum loft_status loft_nurbs_surface_deriv(const loft_nurbs_surface *s, unsigned j, unsigned k,
                                          loft_real u, loft_real v, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_nurbs_surface_eval(const loft_nurbs_surface *s, loft_real u, loft_real v,
                                         loft_vec *out) LOFT_CHECKED;

/* True if the surface has a tangent plane at (u, v): P_u and P_v are not parallel and not 0.
 *
 *   range   f32, f64: numbers that pass loft_exact_valid, otherwise false
 *   error   none
 *   cost    the B-splines modulo one prime (num/residue.h); where there is none, modulo many
 */
bool loft_nurbs_surface_regular(const loft_nurbs_surface *s, loft_real u, loft_real v);

/* The derivatives at (u, v) for surface/differential.h: normal and curvatures. The widths are 0:
 * loft_nurbs_surface_regular decides about a normal, and not how long it is.
 *
 *   range   LOFT_SINGULAR where the surface has no tangent plane; *out is untouched then
 *   error   as loft_nurbs_surface_deriv, without the rounding to a coordinate
 *   cost    6 times loft_nurbs_surface_deriv, and loft_nurbs_surface_regular
 */
enum loft_status loft_nurbs_surface_differential(const loft_nurbs_surface *s, loft_real u,
                                                 loft_real v, loft_differential *out) LOFT_CHECKED;

/* The next span as a Bezier patch: (degree_u + 1) (degree_v + 1) points, row by row, all weights 1
 * without weights. Spans along v follow each other, then the next ones along u; empty ones are
 * skipped. span[] is { 0, 0 } before the first span, then the indices of the knots where it begins.
 * After the last span the result is false.
 *
 *   error   points q16: 1/2 LSB + 2^-20 LSB   f32: 1 ulp   f64: 8 (degree_u + degree_v + 2) R ulp,
 *           R the largest weight over the smallest; weights q16: 1/2 LSB, which may move the patch
 *           by more   f32: 1 ulp   f64: 8 (degree_u + degree_v) ulp
 *   cost    per coordinate, and for the weights, degree^2 (degree + 1) / 2 lerps and quotients of
 *           num/sci.h for each row and column
 *   stack   Cortex-M4 4,252   Cortex-M0+ 4,264   ATmega328P 2,934
 *   see     Piegl and Tiller, The NURBS Book, ch. 5: decomposition of a surface
 */
bool loft_nurbs_surface_next(const loft_nurbs_surface *s, unsigned span[2],
                             loft_weighted out[]) LOFT_CHECKED;

/* Make a loft_surface of it, its domain over 0..1; it must outlive that.
 *
 *   error   a point: that of loft_nurbs_surface_eval, at parameters of loft_nurbs_surface_at
 *   cost    two pointers copied
 */
loft_surface loft_surface_from_nurbs(const loft_nurbs_surface *s);

LOFT_END_C

#endif
