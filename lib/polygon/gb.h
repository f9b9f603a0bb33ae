/* lib/polygon/gb.h -- generalized Bezier patches: surfaces with 3 to 8 sides made of ribbons along
 * their sides
 * SPDX-License-Identifier: MIT
 *
 * Side i of the domain, from vertex i to vertex i + 1, has local parameters made of coordinates phi
 * with respect to the vertices, whichever these are,
 *
 *     s_i = phi_(i+1) / (phi_i + phi_(i+1))        h_i = 1 - phi_i - phi_(i+1)
 *
 * and a ribbon of degree + 1 points in `layers` = (degree + 1) / 2 rows, V^i_jk: row k, j along it.
 * V^i_jk is V^(i-1)_(degree-k),j too where j < layers. A point V0 in the middle takes what the
 * ribbons leave:
 *
 *     S = sum mu^i_jk B_j(s_i) B_k(h_i) V^i_jk + B0 V0        B0 = 1 - sum mu^i_jk B_j(s_i)
 *                                                             B_k(h_i)
 *
 * Along side i S is the Bezier curve of V^i_j0, and its derivative across depends on the first two
 * rows alone. Over a parallelogram, with Wachspress coordinates, S is the tensor product patch with
 * the same points: for an odd degree B0 is 0, for an even one V0 is the point in the middle. With
 * three sides B0 is negative: S moves against V0.
 *
 * The points are stored once each, corner by corner: a along the side after corner c, b along the
 * one before it, both from the corner, a = 0 .. degree / 2, b = 0 .. layers - 1, b running inside.
 * V0 comes last.
 *
 *   see     Varady, Salvi, Kariko, A multi-sided Bezier patch with a simple control structure
 *           (2016)
 */
#ifndef LOFT_POLYGON_GB_H
#define LOFT_POLYGON_GB_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "geom/vec.h"           /* loft_vec */
#include "polygon/domain.h"     /* LOFT_SIDES_MAX */
#include "polygon/jet.h"        /* loft_jet */
#include "surface/differential.h"      /* loft_differential */

LOFT_BEGIN_C

/* The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t sides, degree;
} loft_gb;

/* Make a patch of loft_gb_count(sides, degree) points, which must outlive it.
 *
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise
 *           LOFT_ERR_RANGE; *g is untouched then
 *   error   none
 *   cost    one look at every coordinate
 */
enum loft_status loft_gb_init(loft_gb *g, const loft_vec p[], unsigned sides,
                              unsigned degree) LOFT_CHECKED;

/* How many points there are, V0 included: sides * (degree / 2 + 1) * layers + 1, at most 201.
 *
 *   error   none
 *   cost    2 products of whole numbers
 */
unsigned loft_gb_count(unsigned sides, unsigned degree);

/* Where V^side_jk is stored.
 *
 *   range   side < sides, j <= degree, k < (degree + 1) / 2
 *   error   none
 *   cost    2 products of whole numbers
 */
unsigned loft_gb_place(unsigned sides, unsigned degree, unsigned side, unsigned j, unsigned k);


/* Nets
 * ---- */

/* The point V0 that a net has when nothing else is said: the mean of V^i_(layers),(layers-1) over
 * all sides.
 *
 *   shape   p[loft_gb_count(sides, degree)], of which the last is not read
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 16 ulp of the largest coordinate
 *   cost    one sum per side and axis, a quotient per axis
 */
enum loft_status loft_gb_middle(const loft_vec p[], unsigned sides, unsigned degree,
                                loft_vec *out) LOFT_CHECKED;

/* A whole net from the curves around it. Point (a, b) of a corner is that of the Coons net between
 * the sides that meet there and those after and before them, whose far ends are drawn together into
 * their mean; points that two corners share equally are the mean of both. Four curves make the net
 * of their Coons patch. V0 is loft_gb_middle.
 *
 *   shape   boundary[sides * degree]: side by side, the first `degree` points of each, the last
 *           being the first of the next side; out[loft_gb_count(sides, degree)]
 *   range   3..8 sides, degree 3..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a point does not
 *           fit, out is undefined then
 *   error   on the boundary none; q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 64 ulp of the
 *           largest coordinate
 *   cost    18 products and sums and a quotient per point and axis
 */
enum loft_status loft_gb_from_boundary(const loft_vec boundary[], unsigned sides, unsigned degree,
                                       loft_vec out[]) LOFT_CHECKED;

/* Parameters
 * ---------- */

/* Those of one side, with what they lack to 1. */
typedef struct {
    loft_sci s, before_s;       /* s_i and 1 - s_i */
    loft_sci h, below_h;        /* h_i and 1 - h_i */
    bool any;                   /* phi_i = phi_(i+1) = 0, a far side: s_i may be anything, is 1/2 */
} loft_gb_side;

/* The parameters of all sides.
 *
 *   shape   phi[sides] that sum to 1, out[sides]
 *   range   any coordinates; LOFT_SINGULAR where phi_i + phi_(i+1) = 0 and they are not, which
 *           needs a negative one; out is undefined then
 *   error   beside what phi has, relative, where none is negative: q16: 2^-58   f32, f64: 2^-50
 *   cost    sides^2 sums and 2 sides quotients
 */
enum loft_status loft_gb_params(unsigned sides, const loft_sci phi[],
                                loft_gb_side out[]) LOFT_CHECKED;

/* What mu^i_jk is. */
enum loft_gb_mu {
    LOFT_GB_NONE,       /* 0                                    */
    LOFT_GB_BEFORE,     /* h_(i-1) / (h_(i-1) + h_i)            */
    LOFT_GB_AFTER,      /* h_(i+1) / (h_(i+1) + h_i)            */
    LOFT_GB_HALF,       /* 1/2                                  */
    LOFT_GB_WHOLE       /* 1                                    */
};

/* Which of them it is.
 *
 *   range   degree 3..9, j <= degree, k < (degree + 1) / 2
 *   error   none
 *   cost    some comparisons
 */
enum loft_gb_mu loft_gb_mu_of(unsigned degree, unsigned j, unsigned k);


/* Points
 * ------ */

/* The weights of all control points, B0 the last of them. They sum to 1.
 *
 *   shape   out[loft_gb_count(sides, degree)]
 *   range   as loft_gb_eval
 *   error   q16: 2^-52   f32, f64: 2^-44, beside what phi has
 *   cost    as loft_gb_eval without its products per axis
 */
enum loft_status loft_gb_weights(unsigned sides, unsigned degree, const loft_sci phi[],
                                 loft_sci out[]) LOFT_CHECKED;

/* The point at phi[sides].
 *
 *   range   3..8 sides, degree 3..9; coordinates that sum to 1; LOFT_SINGULAR where loft_gb_params
 *           is, or where h_i + h_(i+1) = 0 but at a vertex: neither happens where no phi is
 *           negative; LOFT_ERR_RANGE when the point does not fit; *out is untouched then
 *   error   where no phi is negative: q16: 1/2 LSB + 2^-12 LSB   f32: 1/2 ulp + 2^-16 ulp   f64:
 *           2^9 ulp, of the largest coordinate; beside what phi has. On a side that of
 *           loft_weighted_sum_curve, at a corner none
 *   cost    sides (degree + 1) layers times at most one product and one per axis, sides (3 degree +
 *           4 layers + 8) more; 3 sides quotients; no table; q16: 1.5 kB of stack
 */
enum loft_status loft_gb_eval(const loft_gb *g, const loft_sci phi[], loft_vec *out) LOFT_CHECKED;

/* The derivatives by x and y of the first and second order, for normals and curvatures
 * (surface/differential.h). Width is the sum of |derivatives of a weight| times |distance of its
 * point
 * from V0|.
 *
 *   shape   phi[sides] with their derivatives by x and y
 *   range   as loft_gb_eval; LOFT_SINGULAR at vertices too; *out is untouched then
 *   error   where no phi is negative, with L the largest coordinate, P and Q the largest first and
 *           second derivative of phi and n the degree: first q16: n L P 2^-44   f32, f64: n L P
 *           2^-36; second: the same with (n P)^2 + n Q in place of n P; beside what phi has
 *   cost    sides (degree + 1) layers times at most 15 products and 6 per axis, sides (80 degree +
 *           40 layers + 400) more; 24 sides quotients; q16: 4.5 kB of stack
 */
enum loft_status loft_gb_differential(const loft_gb *g, const loft_jet phi[],
                               loft_differential *out) LOFT_CHECKED;

LOFT_END_C

#endif
