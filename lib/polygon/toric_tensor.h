/* lib/polygon/toric_tensor.h -- a toric patch as rational tensor-product patches
 * SPDX-License-Identifier: MIT
 *
 * Patch k covers the quarter around vertex k, from edge k - 1 (u = 0) and edge k (v = 0) to the
 * middle (u = v = 1). Its degrees are the largest heights over these two edges: 2 x 2 over the
 * smallest hexagon, where the quotient of toric.h has degree 6. Neighbours share the curve between
 * them. The patches are nets (surface/net.h), for places, rays, areas and intersections:
 *
 *     loft_weighted p[LOFT_TORIC_TENSOR_MAX];
 *     loft_tensor_rational s;
 *     for (unsigned vertex = 0; vertex < lattice.sides; vertex++)
 *         if (loft_toric_tensor(&t, vertex, p, &s) == LOFT_OK) ..
 *
 * The place (u, v) is the point of the polygon where, in both components,
 *
 *     prod h_j^normal_j = s^normal_(k-1) t^normal_k
 *     s = u / (u + a (1 - u)),   t = v / (v + b (1 - v)),   a^m = C / C_(k-1),   b^n = C / C_k
 *
 * with C the sum of coefficients times weights of all points, C_i that of the points on edge i.
 */
#ifndef LOFT_POLYGON_TORIC_TENSOR_H
#define LOFT_POLYGON_TORIC_TENSOR_H

#include "polygon/toric.h"                      /* loft_toric */
#include "surface/tensor/tensor_rational.h"     /* loft_tensor_rational */

LOFT_BEGIN_C

#define LOFT_TORIC_TENSOR_MAX ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))

/* The factor a or b of an edge: it makes the weights at both ends of the line u = 1 or v = 1 equal.
 *
 *   range   edge < sides; a polygon within 9 of it
 *   error   q16: 2^-55 of it   f32, f64: 2^-46 of it
 *   cost    a walk over the whole points, about 200 products of num/sci.h
 */
loft_sci loft_toric_balance(const loft_toric *t, unsigned edge);

/* The patch at a vertex, over out[(m + 1) (n + 1)], which must outlive it. P_u x P_v points as
 * P_x x P_y does.
 *
 *   range   vertex < sides, and no vertex higher than 9 over the two edges that meet there,
 *           otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the smallest weight would be below 1/256:
 *           coefficients times weights that differ by more than 2^15; *s is then untouched, out[]
 *           undefined
 *   error   of the surface, with N points, L the largest coordinate, E the largest distance of two
 *           control points and v the smallest weight of out[]: q16: 1/2 LSB + E 2^-17 / v + L N
 *           2^-59   f32: 1 ulp + E 2^-22   f64: N ulp + E 2^-50. The largest weight is in 128..256
 *   cost    per axis and weight 3 products and m + n + 2 sums of num/sci.h for each of out[]; two
 *           walks over the whole points; not for an ISR
 *   stack   Cortex-M4 3,956   Cortex-M0+ 3,968   ATmega328P 2,776
 *   see     Krasauskas, Toric surface patches (2002): patches by monomials; its normal fan
 */
enum loft_status loft_toric_tensor(const loft_toric *t, unsigned vertex, loft_weighted out[],
                                   loft_tensor_rational *s) LOFT_CHECKED;

LOFT_END_C

#endif
