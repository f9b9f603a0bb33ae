/* lib/polygon/basepoint.h -- surfaces with 3 to 6 sides: rational Bezier triangles with corners of
 * the net cut off
 * SPDX-License-Identifier: MIT
 *
 * Control points are in the order of polygon/multiindex.h: (i, j, k) with i + j + k = degree, the
 * powers of phi_1, phi_2, phi_3. Cutting corner 1 by a removes the points with j + k < a: their
 * weights are 0, and the array entries are not read. Cutting corner 2 by b removes those with
 * i + k < b, corner 3 by c those with i + j < c. At a cut corner the quotient is 0/0, a base point,
 * and the surface gets a side there:
 *
 *     order   corner 1, side phi_3 = 0, corner 2, side phi_1 = 0, corner 3, side phi_2 = 0; corners
 *             that are not cut are left out
 */
#ifndef LOFT_POLYGON_BASEPOINT_H
#define LOFT_POLYGON_BASEPOINT_H

#include "geom/vec.h"               /* loft_vec */
#include "polygon/multiindex.h"     /* loft_multiindex_count */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

/* Points and weights are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    const loft_real *w;
    uint8_t degree, cut[3];
} loft_basepoint;

/* Make a patch of loft_multiindex_count(3, degree) points and weights, which must outlive it.
 *
 *   range   degree 1..9, every sum of two cuts below degree, otherwise LOFT_ERR_ARG; weights that
 *           are not cut off 1/256..256, finite coordinates, otherwise LOFT_ERR_RANGE; *b is then
 *           untouched
 *   error   none: points and weights are borrowed
 *   cost    per control point 2 comparisons of its weight and a check of each coordinate; no
 *           product
 */
enum loft_status loft_basepoint_init(loft_basepoint *b, const loft_vec p[], const loft_real w[],
                                     unsigned degree, const uint8_t cut[3]) LOFT_CHECKED;

/* The point at phi_1, phi_2 and phi_3 = 1 - phi_1 - phi_2.
 *
 *   range   none negative, otherwise LOFT_ERR_ARG; LOFT_SINGULAR at a base point; *out is then
 *           untouched
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1 ulp   f64: 8 * degree + 60 ulp, of the largest
 *           coordinate, however close to a base point; on a side that of loft_basepoint_boundary
 *   cost    per control point 4 products and one per axis, one division per axis; no table
 *   see     Warren, Creating multisided rational Bezier surfaces using base points (1992)
 */
enum loft_status loft_basepoint_eval(const loft_basepoint *b, loft_unit phi1, loft_unit phi2,
                                     loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by phi_1 and phi_2, for normals and curvatures
 * (surface/differential.h). The width is as for a toric patch.
 *
 *   range   as eval
 *   error   with L the largest coordinate, A and B the sums of |first and second derivatives of the
 *           weights| over |the sum of the weights|: first derivatives q16: L A 2^-44   f32, f64:
 *           L A 2^-36; second: the same with B + A^2 in place of A
 *   cost    per control point 15 (2 log2 degree + 4) products and 6 per axis; eval once more
 *   stack   Cortex-M4 2,476   Cortex-M0+ 2,464   ATmega328P 1,858
 */
enum loft_status loft_basepoint_differential(const loft_basepoint *b, loft_unit phi1,
                                             loft_unit phi2, loft_differential *out) LOFT_CHECKED;

/* The same surface blown up at corner 3: phi = ((1 - u) v, u v, 1 - v). v = 0 is the side of that
 * corner, or the corner itself. Or at corner 0..2, counted from 0: the three phi are then those of
 * the next corner, the last corner, and the corner itself.
 *
 *   range   u, v in 0..1, otherwise LOFT_ERR_ARG; LOFT_SINGULAR at the base points of the other
 *           corners
 *   error   as eval
 *   cost    per control point 5 products and one per axis, one division per axis
 *   see     Warren (1992); for degree 2 a tensor product patch of degrees 2 and 1
 */
enum loft_status loft_basepoint_uv(const loft_basepoint *b, loft_unit u, loft_unit v,
                                   loft_vec *out) LOFT_CHECKED;
enum loft_status loft_basepoint_corner(const loft_basepoint *b, unsigned corner, loft_unit u,
                                       loft_unit v, loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by u and v there, also on the side of a cut corner. P_u x P_v
 * has the opposite direction to that of loft_basepoint_differential.
 *
 *   range   as corner; at v = 0 of a corner that is not cut the point does not move with u
 *   error   as loft_basepoint_differential, with derivatives by u and v
 *   cost    per control point 15 (2 log2 degree + 5) products and 6 per axis; corner once more
 *   stack   Cortex-M4 2,484   Cortex-M0+ 2,488   ATmega328P 1,865
 */
enum loft_status loft_basepoint_corner_differential(const loft_basepoint *b, unsigned corner,
                                                    loft_unit u, loft_unit v,
                                                    loft_differential *out) LOFT_CHECKED;


/* The boundary, counter-clockwise
 * ------------------------------- */

/* The number of sides, 3..6. Sides are numbered from 0.
 *
 *   error   none
 *   cost    3 comparisons
 */
unsigned loft_basepoint_sides(const loft_basepoint *b);

/* A side: at the cut corner 0..2, or from that corner to the next one. */
typedef struct {
    uint8_t corner, degree;
    bool cut;
} loft_basepoint_side;

/* The side with this number.
 *
 *   range   number below loft_basepoint_sides
 *   error   none
 *   cost    at most 6 comparisons
 */
loft_basepoint_side loft_basepoint_side_of(const loft_basepoint *b, unsigned number);

/* The point at t of side `number`, a rational Bezier curve. It equals that of loft_rational_eval
 * bit for bit at a cut corner, and on sides without cuts at their ends.
 *
 *   range   number below loft_basepoint_sides, t in 0..1, otherwise LOFT_ERR_ARG
 *   error   as eval
 *   cost    4 * degree products and one per axis, for each of degree + 1 points
 */
enum loft_status loft_basepoint_boundary(const loft_basepoint *b, unsigned number, loft_unit t,
                                         loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
