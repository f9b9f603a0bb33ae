/* lib/polygon/toric.h -- toric patches: rational surfaces over the whole points of a polygon
 * SPDX-License-Identifier: MIT
 *
 * A toric patch has a control point for every whole point l of a convex lattice polygon, in the
 * order of loft_lattice_polygon_next:
 *
 *     S = sum w_l B_l V_l / sum w_l B_l        B_l(p) = c_l prod h_i(p)^h_i(l)        0^0 = 1
 *
 * A triangle of size d with multinomials c is a rational Bezier triangle. A rectangle with products
 * of binomials is a tensor product patch. Any other is one rational tensor product patch for each
 * vertex (toric_tensor.h). Along edge i of length m the patch is a rational Bezier
 * curve of degree m with the weights w_t c_t / C(m,t), at the parameter of loft_toric_parameter.
 */
#ifndef LOFT_POLYGON_TORIC_H
#define LOFT_POLYGON_TORIC_H

#include "curve/rational.h"         /* loft_weighted */
#include "polygon/basepoint.h"      /* loft_basepoint */
#include "polygon/lattice.h"        /* loft_lattice_polygon */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

/* Everything is borrowed. c and w are null when all are 1. Do not fill it yourself: call init. */
typedef struct {
    const loft_lattice_polygon *lattice;
    const loft_vec *p;
    const loft_real *c, *w;
} loft_toric;

/* Make a patch of loft_lattice_polygon_count(lattice) points, coefficients and weights, which must
 * outlive it.
 *
 *   range   coefficients above 0 and to 32767, weights 1/256..256, finite coordinates, and a
 *           lattice where no product of heights can exceed 2^900 (one of several hundred points
 *           may exceed it), otherwise LOFT_ERR_RANGE; *t is then untouched
 *   error   none: everything is borrowed
 *   cost    two walks over the whole points with `sides` heights each; per point 4 comparisons and
 *           a check of each coordinate
 */
enum loft_status loft_toric_init(loft_toric *t, const loft_lattice_polygon *lattice,
                                 const loft_vec p[], const loft_real c[],
                                 const loft_real w[]) LOFT_CHECKED;

/* The coefficient times the weight of control point k.
 *
 *   error   q16: 2^-62 of it   f32: none   f64: 1/2 ulp
 *   cost    a product
 */
loft_sci loft_toric_factor(const loft_toric *t, unsigned k);

/* A patch with base points as a toric one: the same surface over the net without its corners, with
 * multinomials as coefficients. Whole point (x, y) is control point (degree - x - y, x, y).
 *
 *   shape   p, c and w [loft_multiindex_count(3, degree)], and the lattice, which must outlive it
 *   error   none
 *   cost    a walk over the whole points, and loft_toric_init
 *   see     Krasauskas (2002): patches with base points are toric ones
 */
enum loft_status loft_toric_from_basepoint(const loft_basepoint *b, loft_lattice_polygon *lattice,
                                           loft_vec p[], loft_real c[], loft_real w[],
                                           loft_toric *t) LOFT_CHECKED;

/* The point at p, in the plane of the lattice.
 *
 *   range   p in the polygon, edges included, otherwise LOFT_ERR_RANGE; *out is then untouched
 *   error   with N points and H the largest sum h_i(l), which is d in a triangle of size d:
 *           q16: 1/2 LSB + (N + 2 H) 2^-28 LSB   f32: 1/2 ulp + (N + 2^7 H) 2^-29 ulp
 *           f64: N + 2^7 H ulp, of the largest coordinate; at a vertex q16: none
 *   cost    n cross products and divisions; per point 2 log2 h_i + 1 products for every side, three
 *           and one per axis; a division per axis; no table
 *   see     Krasauskas, Toric surface patches (2002)
 */
enum loft_status loft_toric_eval(const loft_toric *t, loft_spot p, loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by x and y, for normals and curvatures (surface/differential.h).
 * The width is the sum of |derivatives of a weight| times |distance of its point| over the sum of
 * weights.
 *
 *   range   as eval
 *   error   with L the largest coordinate, A and B the sums of |first and second derivatives of the
 *           weights| over |the sum of the weights|: first derivatives q16: L A 2^-44   f32, f64:
 *           L A 2^-36; second: the same with B + A^2 in place of A
 *   cost    per control point 15 sides (2 log2 h_i + 2) products and 6 per axis; eval once more
 *   stack   Cortex-M4 2,548   Cortex-M0+ 2,552   ATmega328P 1,918
 */
enum loft_status loft_toric_differential(const loft_toric *t, loft_spot p,
                                         loft_differential *out) LOFT_CHECKED;

/* The curve along an edge, from its first vertex to its second.
 *
 *   shape   out[length + 1], length = t->lattice->edge[edge].length; weights with a common factor,
 *           a power of two
 *   range   length 1..9, otherwise LOFT_ERR_ARG; the smallest weight at least 1/256 when the
 *           largest is in 128..256, otherwise LOFT_ERR_RANGE
 *   error   points none; weights q16: 1/2 LSB, the largest is in 128..256   f32: 1 ulp   f64: 4 ulp
 *   cost    3 products a point
 */
enum loft_status loft_toric_edge(const loft_toric *t, unsigned edge,
                                 loft_weighted out[]) LOFT_CHECKED;

/* The parameter of p, a point of the edge, on that curve: r / (1 + r), r = prod h_j^(normal_j .
 * direction of the edge).
 *
 *   range   p on the edge or at one of its ends, otherwise LOFT_ERR_ARG
 *   error   q16: 2^-25   f32: 1 ulp   f64: 2^12 ulp
 *   cost    as eval of one point
 */
enum loft_status loft_toric_parameter(const loft_toric *t, unsigned edge, loft_spot p,
                                      loft_unit *out) LOFT_CHECKED;

LOFT_END_C

#endif
