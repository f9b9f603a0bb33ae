/* lib/polygon/spatch.h -- S-patches: Bezier surfaces with 3 to 8 sides
 * SPDX-License-Identifier: MIT
 *
 * An S-patch has a control point for every index of polygon/multiindex.h, in its order. It has a
 * point for every set of coordinates phi with respect to the vertices of a polygon. Any kind of
 * coordinates will do:
 *
 *     S = sum depth! / l! prod phi_i^l_i V_l
 *
 * Three sides give a Bezier triangle. Along edge i of the polygon S is the Bezier curve of the
 * points (depth - k) e_i + k e_(i+1). Weights make the patch rational.
 *
 *   error   of every point: q16: 1/2 LSB + (1 + M) * 2^-15 LSB   f32: 1/2 ulp + (1 + M) * 2^-40 ulp
 *           f64: 64 (1 + M) ulp, of the largest coordinate. M = (sum |phi_i|)^depth, which is 1 if
 *           no coordinate is negative; rational patches multiply M by the largest weight over |sum
 *           of weights|
 */
#ifndef LOFT_POLYGON_SPATCH_H
#define LOFT_POLYGON_SPATCH_H

#include "geom/vec.h"               /* loft_vec */
#include "polygon/multiindex.h"     /* loft_multiindex_count */
#include "polygon/jet.h"            /* loft_jet */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

/* Points and weights are borrowed. w is null when all weights are 1. Do not fill it yourself: call
 * init. */
typedef struct {
    const loft_vec *p;
    const loft_real *w;
    uint8_t sides, depth;
} loft_spatch;

/* Make a patch of loft_multiindex_count(sides, depth) control points, which must outlive it.
 *
 *   range   sides 3..8, depth 1..9, otherwise LOFT_ERR_ARG; finite coordinates and weights
 *           1/256..256, otherwise LOFT_ERR_RANGE; *s is then untouched
 *   error   none: points and weights are borrowed
 *   cost    per control point 2 comparisons of its weight and a check of each coordinate
 */
enum loft_status loft_spatch_init(loft_spatch *s, const loft_vec p[], const loft_real w[],
                                  unsigned sides, unsigned depth) LOFT_CHECKED;

/* The point at phi[sides], by the sum.
 *
 *   range   coordinates that sum to 1; LOFT_ERR_RANGE when the point does not fit, LOFT_SINGULAR
 *           when the weights sum to 0: neither happens if no phi is negative; *out is then
 *           untouched
 *   error   as above; on an edge that of loft_weighted_sum_curve, at a corner none
 *   cost    per control point about 3 products and one per axis, with weights one more; a division
 *           per axis with weights
 *   stack   Cortex-M4 2,036   Cortex-M0+ 2,056   ATmega328P 1,503
 *   see     Loop, DeRose, A multisided generalization of Bezier surfaces (1989)
 */
enum loft_status loft_spatch_eval(const loft_spatch *s, const loft_sci phi[],
                                  loft_vec *out) LOFT_CHECKED;

/* The same point by de Casteljau's algorithm: V_l of depth r - 1 is sum phi_i V_(l + e_i) of depth
 * r.
 *
 *   shape   work[loft_multiindex_count(sides, depth - 1)]
 *   range   as eval
 *   error   as above
 *   cost    `sides` products per point of every depth, axis by axis
 */
enum loft_status loft_spatch_casteljau(const loft_spatch *s, const loft_sci phi[], loft_sci work[],
                                       loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by x and y, for normals and curvatures (surface/differential.h).
 * The width is the sum of |derivatives of a weight| times |distance of its point|.
 *
 *   shape   phi[sides] with their derivatives by x and y
 *   range   as eval
 *   error   with L the largest coordinate, A and B the sums of |first and second derivatives of the
 *           weights| over |the sum of the weights|: first derivatives q16: L A 2^-44   f32, f64:
 *           L A 2^-36; second: the same with B + A^2 in place of A; plus that of phi
 *   cost    per control point 20 (sides + depth) products and 6 per axis; eval once more
 *   stack   Cortex-M4 3,084   Cortex-M0+ 3,096   ATmega328P 2,217
 */
enum loft_status loft_spatch_differential(const loft_spatch *s, const loft_jet phi[],
                                          loft_differential *out) LOFT_CHECKED;

/* The same patch with a depth higher by 1.
 *
 *   shape   out[loft_multiindex_count(sides, depth + 1)], also w[] unless s->w is null
 *   range   depth 1..8, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 2 * sides + 4 ulp; weights the same
 *   cost    sides + 1 products and a division per point and axis
 */
enum loft_status loft_spatch_elevate(const loft_spatch *s, loft_vec out[],
                                     loft_real w[]) LOFT_CHECKED;

/* The tensor product net of a patch with four sides over a parallelogram and Wachspress
 * coordinates. u runs along the edge from vertex 0 to 1, v along the edge from 0 to 3.
 *
 *   shape   out[(depth + 1)^2], the point of u^i v^j in out[i * (depth + 1) + j]; also w[] unless
 *           s->w is null
 *   range   4 sides, otherwise LOFT_ERR_ARG
 *   error   as elevate
 *   cost    (depth + 1) (depth + 2) (depth + 3) / 6 products per axis, a division per point and
 *           axis
 *   see     Loop, DeRose (1989); each sum is divided by C(depth,i) C(depth,j)
 */
enum loft_status loft_spatch_tensor(const loft_spatch *s, loft_vec out[],
                                    loft_real w[]) LOFT_CHECKED;

/* The control net
 * --------------- */

/* A walk over the edges of the net, once each: points l and m with l - e_r = m - e_(r+1). */
typedef struct {
    uint8_t rest[LOFT_SIDES_MAX], sides, r;
    bool more;
} loft_links;

/* Start a walk; give the next edge as the ranks of its ends. False at the end.
 *
 *   shape   sides * loft_multiindex_count(sides, depth - 1) edges
 *   range   sides 3..8, depth 1..9
 *   error   none
 *   cost    start: none; next: two of loft_multiindex_rank
 */
void loft_links_start(loft_links *w, unsigned sides, unsigned depth);
bool loft_links_next(loft_links *w, unsigned *l, unsigned *m);

LOFT_END_C

#endif
