/* lib/polygon/spatch_triangle.h -- an S-patch over a convex polygon as rational Bezier triangles
 * SPDX-License-Identifier: MIT
 *
 * With Wachspress coordinates an S-patch is a quotient of polynomials of degree depth (sides - 2).
 * Over a triangle of the polygon it is a rational Bezier triangle: a net (surface/net.h), for
 * places, rays, areas and intersections. Triangles from the middle to each edge cover the polygon.
 *
 *     loft_weighted p[LOFT_SPATCH_TRIANGLE_MAX];
 *     for (unsigned edge = 0; edge < s.sides; edge++)
 *         if (loft_spatch_triangle(&s, &domain, edge, p) == LOFT_OK &&
 *             loft_triangle_rational_init(&t, p, s.depth * (s.sides - 2u)) == LOFT_OK) ..
 */
#ifndef LOFT_POLYGON_SPATCH_TRIANGLE_H
#define LOFT_POLYGON_SPATCH_TRIANGLE_H

#include "curve/rational.h"         /* loft_weighted */
#include "polygon/spatch.h"         /* loft_spatch */
#include "surface/barycentric.h"    /* LOFT_TRIANGLE_MAX */

LOFT_BEGIN_C

#define LOFT_SPATCH_TRIANGLE_MAX LOFT_TRIANGLE_MAX

/* The control points over the triangle from the mean of the vertices (T1) to the vertices `edge`
 * (T2) and edge + 1 (T3): out[LOFT_TRIANGLE_POINTS(depth (sides - 2))]. Their largest weight is
 * 255.
 *
 *   range   depth (sides - 2) <= 9, edge < sides and a convex domain of as many sides, otherwise
 *           LOFT_ERR_ARG; LOFT_ERR_RANGE when a weight would be below 1/256: domains with sides of
 *           very different lengths; `out` is then undefined
 *   error   of the surface, with E the largest distance of two control points and v the smallest
 *           weight of out[]: q16: 1/2 LSB + E (2^-17 / v + 2^-48)   f32: 1 ulp + E 2^-22   f64:
 *           1 ulp + E 2^-40
 *   cost    per axis and weight about 2000 products of num/sci.h for 5 sides and depth 3, at most
 *           9000; not for an ISR
 *   stack   Cortex-M4 15,580   Cortex-M0+ 15,584   ATmega328P 10,862
 *   see     Loop, DeRose, A multisided generalization of Bezier surfaces (1989)
 */
enum loft_status loft_spatch_triangle(const loft_spatch *s, const loft_domain *d, unsigned edge,
                                      loft_weighted out[]) LOFT_CHECKED;

LOFT_END_C

#endif
