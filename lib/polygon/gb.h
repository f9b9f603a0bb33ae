/* lib/polygon/gb.h -- generalized Bezier patches: surfaces with 3 to 8 sides made of ribbons along
 * their sides
 * SPDX-License-Identifier: MIT
 *
 * Side i of the domain runs from vertex i to vertex i + 1. It has local parameters made of any
 * coordinates phi with respect to the vertices,
 *
 *     s_i = phi_(i+1) / (phi_i + phi_(i+1))        h_i = 1 - phi_i - phi_(i+1)
 *
 * and a ribbon of degree + 1 points in `layers` = (degree + 1) / 2 rows, V^i_jk: row k, column j.
 * V^i_jk is also V^(i-1)_(degree-k),j where j < layers. A point V0 in the middle has the weight
 * that the ribbons leave:
 *
 *     S  = sum mu^i_jk B_j(s_i) B_k(h_i) V^i_jk + B0 V0
 *     B0 = 1 - sum mu^i_jk B_j(s_i) B_k(h_i)
 *
 * Along side i S is the Bezier curve of V^i_j0, and its derivative across depends only on the first
 * two rows. Over a parallelogram, with Wachspress coordinates, S is the tensor product patch with
 * the same points: for an odd degree B0 is 0, for an even one V0 is the point in the middle. With
 * three sides B0 is negative: S moves opposite to V0.
 *
 * Each point is stored once, corner by corner: a = 0 .. degree / 2 steps from corner c along the
 * side after it, and b = 0 .. layers - 1 steps along the side before it. b varies fastest. V0 comes
 * last.
 *
 *   see     Varady, Salvi, Kariko, A multi-sided Bezier patch with a simple control structure
 *           (2016)
 */
#ifndef LOFT_POLYGON_GB_H
#define LOFT_POLYGON_GB_H

#include "basis/bernstein.h"        /* LOFT_DEGREE_MAX */
#include "geom/vec.h"               /* loft_vec */
#include "polygon/domain.h"         /* LOFT_SIDES_MAX */
#include "polygon/jet.h"            /* loft_jet */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

/* The control points are borrowed. Do not fill it yourself: call an init. */
typedef struct {
    const loft_vec *p;
    const loft_vec *split;      /* or NULL */
    uint8_t sides, degree;
} loft_gb;

/* Make a patch of loft_gb_count(sides, degree) points, which must outlive it.
 *
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise
 *           LOFT_ERR_RANGE; *g is then untouched
 *   error   none
 *   cost    one check per coordinate
 */
enum loft_status loft_gb_init(loft_gb *g, const loft_vec p[], unsigned sides,
                              unsigned degree) LOFT_CHECKED;

/* The same with two points in place of V^i_11 at each corner: that of the net for the ribbon of
 * side i, split[i] for the ribbon of side i - 1. So each side has its own slopes across it, also
 * where the two that meet at a corner have different twists (polygon/hole.h).
 *
 *   shape   split[sides], which must outlive the patch
 *   range   as loft_gb_init
 *   error   none
 *   cost    as loft_gb_init
 *   see     Varady, Rockwood, Salvi, Transfinite surface interpolation over irregular n-sided
 *           domains (2011): ribbons with rational twists
 */
enum loft_status loft_gb_init_split(loft_gb *g, const loft_vec p[], const loft_vec split[],
                                    unsigned sides, unsigned degree) LOFT_CHECKED;

/* The number of points, V0 included: sides * (degree / 2 + 1) * layers + 1, at most 201.
 *
 *   error   none
 *   cost    2 products of whole numbers
 */
unsigned loft_gb_count(unsigned sides, unsigned degree);

/* The index of V^side_jk.
 *
 *   range   side < sides, j <= degree, k < (degree + 1) / 2
 *   error   none
 *   cost    2 products of whole numbers
 */
unsigned loft_gb_place(unsigned sides, unsigned degree, unsigned side, unsigned j, unsigned k);


/* Nets
 * ---- */

/* The default V0 of a net: the mean of V^i_(layers),(layers-1) over all sides.
 *
 *   shape   p[loft_gb_count(sides, degree)]; the last point is not read
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 16 ulp of the largest coordinate
 *   cost    one sum per side and axis, a quotient per axis
 */
enum loft_status loft_gb_middle(const loft_vec p[], unsigned sides, unsigned degree,
                                loft_vec *out) LOFT_CHECKED;

/* A whole net from the boundary curves. Point (a, b) of a corner comes from a Coons net between the
 * two sides that meet there and the sides after and before them, whose far ends are moved to their
 * mean. Points that two corners share equally are the mean of both. Four curves give the net of
 * their Coons patch. V0 is loft_gb_middle.
 *
 *   shape   boundary[sides * degree]: side by side, the first `degree` points of each; the last
 *           point is the first of the next side; out[loft_gb_count(sides, degree)]
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a point does not
 *           fit: out is then undefined
 *   error   on the boundary none; q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 64 ulp of the
 *           largest coordinate
 *   cost    18 products and sums and a quotient per point and axis
 */
enum loft_status loft_gb_from_boundary(const loft_vec boundary[], unsigned sides, unsigned degree,
                                       loft_vec out[]) LOFT_CHECKED;

/* Parameters
 * ---------- */

/* The parameters of one side, and 1 minus each of them. */
typedef struct {
    loft_sci s, before_s;       /* s_i and 1 - s_i */
    loft_sci h, below_h;        /* h_i and 1 - h_i */
    bool any;                   /* phi_i = phi_(i+1) = 0, a far side: s_i is set to 1/2 */
} loft_gb_side;

/* The parameters of all sides.
 *
 *   shape   phi[sides] that sum to 1, out[sides]
 *   range   any coordinates; LOFT_SINGULAR where phi_i + phi_(i+1) = 0 and neither is 0, which
 *           needs a negative one; out is then undefined
 *   error   relative, if no phi is negative: q16: 2^-58   f32, f64: 2^-50; plus that of phi
 *   cost    sides^2 sums and 2 sides quotients
 */
enum loft_status loft_gb_params(unsigned sides, const loft_sci phi[],
                                loft_gb_side out[]) LOFT_CHECKED;

/* The value of mu^i_jk. */
enum loft_gb_mu {
    LOFT_GB_NONE,       /* 0                                    */
    LOFT_GB_BEFORE,     /* h_(i-1) / (h_(i-1) + h_i)            */
    LOFT_GB_AFTER,      /* h_(i+1) / (h_(i+1) + h_i)            */
    LOFT_GB_HALF,       /* 1/2                                  */
    LOFT_GB_WHOLE       /* 1                                    */
};

/* The kind of mu^i_jk.
 *
 *   range   degree 3..9, j <= degree, k < (degree + 1) / 2
 *   error   none
 *   cost    some comparisons
 */
enum loft_gb_mu loft_gb_mu_of(unsigned degree, unsigned j, unsigned k);


/* Points
 * ------ */

/* The weights of all control points; B0 is the last. They sum to 1.
 *
 *   shape   out[loft_gb_count(sides, degree)]
 *   range   as loft_gb_eval
 *   error   q16: 2^-52   f32, f64: 2^-44, plus that of phi
 *   cost    as loft_gb_eval without its products per axis
 */
enum loft_status loft_gb_weights(unsigned sides, unsigned degree, const loft_sci phi[],
                                 loft_sci out[]) LOFT_CHECKED;

/* The point at phi[sides].
 *
 *   range   3..8 sides, degree 3..9; coordinates that sum to 1; LOFT_SINGULAR where loft_gb_params
 *           returns it, or where h_i + h_(i+1) = 0 except at a vertex: neither happens if no phi is
 *           negative; LOFT_ERR_RANGE when the point does not fit; *out is then untouched
 *   error   if no phi is negative: q16: 1/2 LSB + 2^-12 LSB   f32: 1/2 ulp + 2^-16 ulp   f64:
 *           2^9 ulp, of the largest coordinate; plus that of phi. On a side that of
 *           loft_weighted_sum_curve, at a corner none
 *   cost    sides (degree + 1) layers times at most one product and one per axis, sides (3 degree +
 *           4 layers + 8) more; 3 sides quotients; no table
 *   stack   Cortex-M4 1,696   Cortex-M0+ 1,700   ATmega328P 1,215
 */
enum loft_status loft_gb_eval(const loft_gb *g, const loft_sci phi[], loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by x and y, for normals and curvatures (surface/differential.h).
 * The width is the sum of |derivatives of a weight| times |distance of its point from V0|.
 *
 *   shape   phi[sides] with their derivatives by x and y
 *   range   as loft_gb_eval; LOFT_SINGULAR also at vertices; *out is then untouched
 *   error   if no phi is negative, with L the largest coordinate, P and Q the largest first and
 *           second derivative of phi and n the degree: first derivatives q16: n L P 2^-44   f32,
 *           f64: n L P 2^-36; second: the same with (n P)^2 + n Q in place of n P; plus that of phi
 *   cost    sides (degree + 1) layers times at most 15 products and 6 per axis, sides (80 degree +
 *           40 layers + 400) more; 24 sides quotients
 *   stack   Cortex-M4 4,996   Cortex-M0+ 5,000   ATmega328P 3,720
 */
enum loft_status loft_gb_differential(const loft_gb *g, const loft_jet phi[],
                                      loft_differential *out) LOFT_CHECKED;

LOFT_END_C

#endif
