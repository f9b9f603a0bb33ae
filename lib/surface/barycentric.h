/* lib/surface/barycentric.h -- barycentric coordinates, and scalar polynomials over a triangle
 * SPDX-License-Identifier: MIT
 *
 * A point u T1 + v T2 + w T3 with u + v + w = 1 is given by v and w. u is 1 - v - w, so the sum
 * cannot be wrong. A direction has u + v + w = 0 and is given by the same two numbers. The corners
 * T1, T2, T3 are
 *
 *     { 0, 0 }     { LOFT_UNIT(1), 0 }     { 0, LOFT_UNIT(1) }
 *
 * A polynomial of degree n over a triangle is an array of LOFT_TRIANGLE_POINTS(n) coefficients
 * b_ijk, i + j + k = n. i descends, then j descends: 200 110 101 020 011 002. The index of b_ijk is
 * loft_triangle_place(j, k) for every degree. Row j + k holds the points at that distance from T1.
 *
 * In the `error` lines L = |u| + |v| + |w|. L is 1 inside the triangle and on its edges.
 */
#ifndef LOFT_SURFACE_BARYCENTRIC_H
#define LOFT_SURFACE_BARYCENTRIC_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "geom/vec.h"           /* loft_vec */

LOFT_BEGIN_C

#define LOFT_TRIANGLE_POINTS(degree) (((degree) + 1u) * ((degree) + 2u) / 2u)
#define LOFT_TRIANGLE_MAX LOFT_TRIANGLE_POINTS(LOFT_DEGREE_MAX)

/* A point or a direction in a triangle. */
typedef struct {
    loft_unit v, w;
} loft_bary;

static inline unsigned loft_triangle_place(unsigned j, unsigned k)
{
    return (j + k) * (j + k + 1) / 2 + k;
}

/* True if a point is inside the triangle or on its edges. */
static inline bool loft_bary_inside(loft_bary u)
{
    return u.v >= 0 && u.w >= 0 && u.v <= LOFT_UNIT(1) && u.w <= LOFT_UNIT(1) - u.v;
}

/* The point itself if it is inside, otherwise a point on an edge. NaN counts as 0. */
static inline loft_bary loft_bary_clamp(loft_bary u)
{
    u.v = loft_unit_clamp(u.v);
    u.w = loft_unit_clamp(u.w);
    if (!loft_bary_inside(u))
        u.w = LOFT_UNIT(1) - u.v;
    return u;
}


/* Coordinates in a plane triangle
 * -------------------------------
 * In the first two axes. The results are wide, because a point far from a narrow triangle has large
 * coordinates. They are exact up to one rounding.
 *
 *   range   LOFT_SINGULAR for three corners on a line; LOFT_ERR_RANGE when a coordinate is 2^30 or
 *           more, or when loft_exact_valid refuses a number; `out` is then untouched
 *   error   q16: 2^-33 + 2^-60   f32, f64: 0.51 ulp of double
 *   cost    4 determinants and 3 quotients of exact numbers; 1 kB of stack; not for an ISR */

/* u, v, w of the point x. */
enum loft_status loft_bary_from_point(const loft_vec corner[3], loft_vec x,
                                      loft_acc out[3]) LOFT_CHECKED;

/* u, v, w of the vector x, whose sum is 0. */
enum loft_status loft_bary_from_vector(const loft_vec corner[3], loft_vec x,
                                       loft_acc out[3]) LOFT_CHECKED;

/* The area, positive when the corners turn left. It never returns LOFT_SINGULAR.
 *
 *   range   LOFT_ERR_RANGE when it does not fit
 *   error   1/2 LSB, in floats 0.51 ulp
 */
enum loft_status loft_bary_area(const loft_vec corner[3], loft_real *area) LOFT_CHECKED;

/* The point with wide coordinates u, v, w.
 *
 *   range   |v|, |w| <= 32, otherwise LOFT_ERR_RANGE
 *   error   q16: 2^-25   f32: 1/2 ulp   f64: none; v and w each, u takes the rest
 */
enum loft_status loft_bary_round(const loft_acc wide[3], loft_bary *out) LOFT_CHECKED;

/* Change the triangle. x are coordinates in a triangle whose corners have the coordinates
 * corner[0..2] in a triangle T. `out` gets the coordinates of the same point in T.
 *
 *   range   |v|, |w| <= 32, otherwise LOFT_ERR_ARG
 *   error   q16: 2^-33 for v and w, 2^-32 for u   f32, f64: 3 L ulp of double of the largest
 *   cost    4 wide products
 */
enum loft_status loft_bary_change(const loft_bary corner[3], loft_bary x,
                                  loft_acc out[3]) LOFT_CHECKED;

/* Polynomials over a triangle
 * ---------------------------
 * Nothing overflows if loft_bary_grows returns true for all steps taken. */

/* *product bounds the factor by which steps have multiplied the largest coefficient. It is 1 before
 * the first step. Update it for `times` steps with u, which is a point or, with `direction`, a
 * direction. False when coefficients could overflow: a product above 19683 = 3^9, or |v| or |w| >
 * 32. Points inside the triangle always return true.
 *
 *   error   2^-16 of the product
 *   cost    `times` wide products, none inside the triangle
 */
bool loft_bary_grows(loft_bary u, bool direction, unsigned times, loft_acc *product) LOFT_CHECKED;

/* The Bernstein polynomials n!/(i! j! k!) u^i v^j w^k: the weights of the control points.
 *
 *   shape   w[LOFT_TRIANGLE_POINTS(degree)]; q16: they sum to exactly 1 (2^32)
 *   range   degree 0..9, inside the triangle
 *   error   q16: degree * 2^-31   f32, f64: 6 * degree ulp of double of 1
 *   cost    degree (degree + 1) (degree + 2) / 3 wide products
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: Bernstein polynomials over triangles
 */
void loft_bary_weights(unsigned degree, loft_bary u, loft_acc w[]);

/* One row of de Casteljau's algorithm, in place: b_ijk becomes u b_(i+1)jk + v b_i(j+1)k + w
 * b_ij(k+1), and the coefficients of one degree less remain. Rows with the same u give the value.
 * Rows with different u give the polar form. Rows with directions give derivatives, without the
 * factor n.
 *
 *   error   q16: 2^-33 per row   f32, f64: 3 L ulp of double per row
 *   cost    degree (degree + 1) wide products
 *   see     Farin, ch. 17: de Casteljau's algorithm over triangles; Ramshaw, blossoming
 */
void loft_bary_step(loft_acc c[], unsigned degree, loft_bary u);
void loft_bary_slope(loft_acc c[], unsigned degree, loft_bary direction);

/* The value at u, by `degree` rows. The coefficients are overwritten.
 *
 *   error   q16: 2^-33 (1 + L + .. + L^(degree-1)); inside degree * 2^-33; always below 2^-19.7
 *           f32, f64: 3 * degree * L^degree ulp of double, of the largest coefficient
 *   cost    degree (degree + 1) (degree + 2) / 3 wide products
 */
loft_acc loft_bary_eval(loft_acc c[], unsigned degree, loft_bary u);

LOFT_END_C

#endif
