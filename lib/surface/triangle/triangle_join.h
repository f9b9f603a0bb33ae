/* lib/surface/triangle/triangle_join.h -- two Bezier triangles with a common edge: how smoothly
 * they join, and how to continue one
 * SPDX-License-Identifier: MIT
 *
 * The first triangle lies over (T1, T2, T3), the second over (T*, T2, T3). T* has the coordinates
 * `star` in the first triangle, outside it beyond the edge T2 T3 (u < 0). Both have the same degree
 * and the order of barycentric.h, so that their points with i = 0 lie on the common edge.
 * Everything is exact in whole numbers (num/exact.h).
 *
 *   range   coordinates that loft_exact_valid accepts: any in q16, multiples of 2^-108 below 2^20
 *           in f32 and f64, otherwise LOFT_ERR_RANGE
 *   cost    2 kB of stack in q16; not for an ISR
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: Cr conditions; Chang, Mathematics of
 *           Surfaces, ch. 8
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_JOIN_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_JOIN_H

#include "surface/triangle/triangle.h"       /* loft_triangle */

LOFT_BEGIN_C

/* The number of points in the rows i = 0..order of a net. */
#define LOFT_TRIANGLE_ROWS(degree, order) (((order) + 1u) * (2u * (degree) - (order) + 2u) / 2u)

/* The control points c_ijk, i = 0..order, of the second triangle for which all derivatives up to
 * that order agree along the edge: row by row from i = 0, in each row with j descending.
 *
 *   shape   out[LOFT_TRIANGLE_ROWS(degree, order)], not the control points themselves
 *   range   order <= degree, otherwise LOFT_ERR_ARG; |v|, |w| < 127 of `star` and points that fit,
 *           otherwise LOFT_ERR_RANGE; `out` is then undefined
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1/2 ulp   f64: 1 ulp, of the result
 *   cost    (i + 1) (i + 2) exact products and a quotient for each coordinate of row i
 */
enum loft_status loft_triangle_join_continue(const loft_triangle *t, loft_bary star, unsigned order,
                                             loft_vec out[]) LOFT_CHECKED;

/* The largest r for which all derivatives up to r agree along the edge; -1 when the edges differ.
 *
 *   range   equal degrees, otherwise LOFT_ERR_ARG; |v|, |w| < 127 of `star`, otherwise
 *           LOFT_ERR_RANGE; *order is then untouched
 *   error   none
 *   cost    (i + 1) (i + 2) exact products for each coordinate of row i, up to the first one that
 *           differs
 */
enum loft_status loft_triangle_join_order(const loft_triangle *b, const loft_triangle *c,
                                          loft_bary star, int *order) LOFT_CHECKED;

LOFT_END_C

#endif
