/* lib/surface/triangle/triangle_pieces.h -- Bezier triangles split, reparametrized and
 * degree-elevated
 * SPDX-License-Identifier: MIT
 *
 * Results are nets in the order of barycentric.h. A result may replace the control points, but
 * results must not overlap each other. They are undefined after an error. The `error` lines are
 * those of triangle.h, for each control point.
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_PIECES_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_PIECES_H

#include "curve/bezier.h"               /* LOFT_BEZIER_ELEVATE_MAX */
#include "surface/triangle/triangle.h"  /* loft_triangle */

LOFT_BEGIN_C

/* The three triangles around the point u: (u, T2, T3), (T1, u, T3) and (T1, T2, u).
 *
 *   range   LOFT_ERR_RANGE when a control point does not fit or the law of growth of triangle.h
 *           fails
 *   error   as loft_triangle_extrapolate
 *   cost    as loft_triangle_eval
 *   stack   Cortex-M4 624   Cortex-M0+ 676   ATmega328P 629
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: subdivision at a point
 */
enum loft_status loft_triangle_split(const loft_triangle *t, loft_bary u, loft_vec a[],
                                     loft_vec b[], loft_vec c[]) LOFT_CHECKED;

/* The four triangles between the corners and the edge midpoints. M12 is between T1 and T2, etc.:
 *
 *     part 0   T1 M12 M13         part 2   M13 M23 T3
 *     part 1   M12 T2 M23         part 3   M23 M13 M12
 *
 *   range   part 0..3, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB   f32: 1/2 ulp   f64: degree / 2 ulp
 *   cost    (degree + 1) (degree + 2) (degree + 3) (degree + 8) / 24 sums and halves at most, no
 *           product
 *   stack   Cortex-M4 1,452   Cortex-M0+ 1,528   ATmega328P 1,424
 *   see     Farin, ch. 17; Goldman, Subdivision algorithms for Bezier triangles (1983)
 */
enum loft_status loft_triangle_quarter(const loft_triangle *t, unsigned part,
                                       loft_vec out[]) LOFT_CHECKED;

/* The net over any other triangle, given by its corners: b[corner0^i, corner1^j, corner2^k].
 *
 *   range   LOFT_ERR_RANGE when a control point does not fit or the law of growth of triangle.h
 *           fails
 *   error   as loft_triangle_extrapolate with the largest L
 *   cost    (degree + 1) (degree + 2) (degree + 3) (degree + 8) / 24 weighted sums at most
 *   stack   Cortex-M4 1,484   Cortex-M0+ 1,628   ATmega328P 1,556
 *   see     Ramshaw, blossoming
 */
enum loft_status loft_triangle_sub(const loft_triangle *t, const loft_bary corner[3],
                                   loft_vec out[]) LOFT_CHECKED;

/* The same surface with a degree higher by `times`: LOFT_TRIANGLE_POINTS(degree + times) control
 * points.
 *
 *   range   degree + times <= LOFT_BEZIER_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: degree + 3 ulp
 *           beyond degree 18, q16: 1/2 LSB + degree * 2^-17 LSB   f64: 2 degree + 3 ulp
 *   cost    per control point of the result: at most one small product per point of the net, and
 *           one division; beyond degree 18 degree (degree + 1) (degree + 2) / 6 times three small
 *           products and a division
 *   stack   Cortex-M4 1,024   Cortex-M0+ 1,132   ATmega328P 981
 *   see     Farin, ch. 17: degree elevation
 */
enum loft_status loft_triangle_elevate(const loft_triangle *t, unsigned times,
                                       loft_vec out[]) LOFT_CHECKED;

/* The control points of the surface sum a_pr v^p w^r, where v and w are the coordinates of T2 and
 * T3 as in a loft_bary, which a loft_surface calls u and v. a is in order of degree, then of the
 * power of w: the coefficients of 1, v, w, v^2, v w, w^2, ..
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a point does not fit
 *   error   q16: 1/2 LSB + degree^2 * 2^-17 LSB   f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: (degree + 1)^2 (degree + 2) ulp, of the largest coefficient
 *   cost    one division for each pair of a coefficient and a control point of the same or a higher
 *           power
 *   see     Farin, ch. 17; the form of curve/bezier.h in two variables
 */
enum loft_status loft_triangle_from_power(const loft_vec a[], unsigned degree,
                                          loft_vec out[]) LOFT_CHECKED;

LOFT_END_C

#endif
