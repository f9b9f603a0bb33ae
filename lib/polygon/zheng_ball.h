/* lib/polygon/zheng_ball.h -- Zheng-Ball patches: Bezier surfaces with 3, 5 or 6 sides
 * SPDX-License-Identifier: MIT
 *
 * A point of the patch has a parameter u_i for every side: 0 on the side, and 1 on the sides that
 * do not touch it. Two neighbours determine the rest. A control point lies l_i steps from side i:
 *
 *     S = sum B_l(u) V_l        l_i = 0 .. degree
 *
 * Every corner i, between sides i - 1 and i, has its own block of points, a = l_(i-1) <= degree / 2
 * and b = l_i < degree / 2 steps from the two sides. They are ordered corner by corner, then by a,
 * then by b. For an even degree the centre comes last. Along side i S is the Bezier curve of the
 * points l_i = 0, l_(i-1) = 0 .. degree, at u_(i-1).
 *
 *   see     Zheng, Ball, Control point surfaces over non-four-sided areas (1997); Sabin,
 *           Non-rectangular surface patches suitable for inclusion in a B-spline surface (1983);
 *           Hosaka, Kimura, Non-four-sided patch expressions with control points (1984): the
 *           parameters
 */
#ifndef LOFT_POLYGON_ZHENG_BALL_H
#define LOFT_POLYGON_ZHENG_BALL_H

#include "basis/bernstein.h"        /* LOFT_DEGREE_MAX */
#include "geom/vec.h"               /* loft_vec */
#include "num/sci.h"                /* loft_sci */
#include "polygon/jet.h"            /* loft_jet */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

#define LOFT_ZHENG_BALL_SIDES 6       /* the largest number of sides */

/* The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t sides, degree;
} loft_zheng_ball;

/* Make a patch of loft_zheng_ball_count(sides, degree) points, which must outlive it.
 *
 *   range   3, 5 or 6 sides, degree 2..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise
 *           LOFT_ERR_RANGE; *r is then untouched
 *   error   none: the points are borrowed
 *   cost    one check per coordinate
 */
enum loft_status loft_zheng_ball_init(loft_zheng_ball *r, const loft_vec p[], unsigned sides,
                                      unsigned degree) LOFT_CHECKED;

/* The number of points: sides * floor(degree / 2 + 1) * ceil(degree / 2), and one more for an even
 * degree.
 *
 *   error   none
 *   cost    2 products of whole numbers
 */
unsigned loft_zheng_ball_count(unsigned sides, unsigned degree);

/* The distances l[sides] of point k, k < loft_zheng_ball_count(sides, degree).
 *
 *   error   none
 *   cost    4 integer quotients or remainders and a product
 */
void loft_zheng_ball_index(unsigned sides, unsigned degree, unsigned k, uint8_t l[]);


/* Parameters
 * ---------- */

/* All parameters from u_1 and u_2.
 *
 *   shape   u[sides]
 *   range   both in 0..1, for 3 sides with a sum of at most 1, otherwise LOFT_ERR_ARG;
 *           LOFT_SINGULAR for u_1 = u_2 = 1, which all points of a far side share; u is then
 *           undefined
 *   error   q16: 2^-54   f32, f64: 2^-48, relative to 1 - u near 1 as well
 *   cost    3 sides: 2 products and a division; 5: 2 and 2; 6: 4 roots, 8 divisions, 120 products;
 *           no table
 *   stack   Cortex-M4 1,668   Cortex-M0+ 1,672   ATmega328P 1,330
 */
enum loft_status loft_zheng_ball_params(unsigned sides, loft_unit u1, loft_unit u2,
                                        loft_sci u[]) LOFT_CHECKED;

/* The parameters of three sides from barycentric coordinates: u = t (b_1, b_2, b_3) with the t in
 * 1..1.1 that makes them consistent. b_3 = 1 - b_1 - b_2.
 *
 *   shape   u[3]
 *   range   none negative, otherwise LOFT_ERR_ARG
 *   error   q16: 2^-56   f32, f64: 2^-50
 *   cost    4 divisions, 25 products
 */
enum loft_status loft_zheng_ball_lift(loft_unit b1, loft_unit b2, loft_sci u[]) LOFT_CHECKED;

/* The parameters with their first and second derivatives by u_1 and u_2, or by b_1 and b_2.
 *
 *   shape   u[sides], u[3]
 *   range   as params, as lift; u is undefined after an error
 *   error   values: that of params or lift. With r the larger of 1 - u_1 and 1 - u_2 (1 for three
 *           sides), first derivatives q16: 2^-56 / r^2   f32, f64: 2^-48 / r^2; second q16: 2^-54 /
 *           r^4   f32, f64: 2^-46 / r^4. That is for r >= 2^-8, which is not checked: nothing is
 *           clamped, and for a smaller r no bound is stated
 *   cost    that of params or lift, and in products of polygon/jet.h: 3 sides 1 and a quotient, 5:
 *           1 and two quotients, 6: 44, a lift 11
 *   stack   Cortex-M4 2,916   Cortex-M0+ 2,904   ATmega328P 2,225
 */
enum loft_status loft_zheng_ball_params_jet(unsigned sides, loft_unit u1, loft_unit u2,
                                            loft_jet u[]) LOFT_CHECKED;
enum loft_status loft_zheng_ball_lift_jet(loft_unit b1, loft_unit b2, loft_jet u[]) LOFT_CHECKED;


/* Points
 * ------ */

/* The weights of all control points. They sum to 1; some may be slightly negative from degree 4 on.
 *
 *   shape   out[loft_zheng_ball_count(sides, degree)]; consistent u[sides]
 *   error   q16: 2^-50   f32, f64: 2^-42
 *   cost    per point about 2 sides + 6 products
 *   stack   Cortex-M4 1,572   Cortex-M0+ 1,584   ATmega328P 1,107
 */
void loft_zheng_ball_weights(unsigned sides, unsigned degree, const loft_sci u[], loft_sci out[]);

/* The point at u.
 *
 *   range   consistent parameters; LOFT_ERR_RANGE when the point does not fit: *out is then
 *           untouched
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp + 2^-16 ulp   f64: 2^12 ulp, of the largest
 *           coordinate; plus that of u. On a side that of loft_weighted_sum_curve, at a corner
 *           none
 *   cost    per control point about 2 sides + 6 products and one per axis; no table
 *   stack   Cortex-M4 1,808   Cortex-M0+ 1,812   ATmega328P 1,322
 */
enum loft_status loft_zheng_ball_eval(const loft_zheng_ball *r, const loft_sci u[],
                                      loft_vec *out) LOFT_CHECKED;

/* The first and second derivatives by the variables of u, for normals and curvatures
 * (surface/differential.h). The width is the sum of |derivatives of a weight| times |distance of
 * its point from the last one|.
 *
 *   shape   consistent u[sides] with their derivatives, u[i] of side i. Rotate the results of the
 *           two functions above to have the parameters of another corner
 *   range   parameters in 0..1: cannot fail
 *   error   with L the largest coordinate, P and Q the largest first and second derivative of u, or
 *           1, and n the degree: first derivatives q16: n L P 2^-52   f32, f64: n L P 2^-44;
 *           second: the same with (n P)^2 + n Q in place of n P; plus that of u
 *   cost    per control point sides (2 log2 degree + 2) products of polygon/jet.h and 6 per axis
 *   stack   Cortex-M4 1,924   Cortex-M0+ 1,936   ATmega328P 1,464
 */
void loft_zheng_ball_differential(const loft_zheng_ball *r, const loft_jet u[],
                                  loft_differential *out);

LOFT_END_C

#endif
