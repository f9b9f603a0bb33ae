/* lib/surface/triangle/triangle_rational.h -- rational Bezier triangles of degree 0..9: points,
 * derivatives, pieces
 * SPDX-License-Identifier: MIT
 *
 * Every control point has a weight; curve/rational.h has the range of weights in q16. The control
 * points are in the order of barycentric.h and lie in space, not multiplied by their weights. In
 * the `error` lines R is the largest weight over the smallest, at most 65536, and ulp is that of
 * the largest control value.
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_RATIONAL_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_RATIONAL_H

#include "curve/rational.h"         /* loft_weighted */
#include "surface/barycentric.h"    /* loft_bary */

LOFT_BEGIN_C

/* A triangle of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_weighted *p;
    int32_t scale;              /* a power of two; scale * the largest weight is in 2^14 .. 2^15 */
    uint8_t degree;
} loft_triangle_rational;

/* Make a triangle of LOFT_TRIANGLE_POINTS(degree) control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; weights 1/256..256 and finite coordinates,
 *           otherwise LOFT_ERR_RANGE; *t is then untouched
 *   error   none: the points are borrowed
 *   cost    three comparisons per control point and two per coordinate
 */
enum loft_status loft_triangle_rational_init(loft_triangle_rational *t, const loft_weighted p[],
                                             unsigned degree) LOFT_CHECKED;

/* The point at u, by de Casteljau's algorithm for numerator and denominator.
 *
 *   range   u is clamped to the triangle: cannot fail
 *   error   q16: 1/2 LSB + degree * R * 2^-30 LSB, below 0.501 LSB   f32: 1 ulp   f64: 6 * degree +
 *           4 ulp
 *   cost    LOFT_AXES + 1 times degree (degree + 1) (degree + 2) / 3 wide products, a quotient per
 *           axis
 *   stack   Cortex-M4 656   Cortex-M0+ 716   ATmega328P 685
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: rational Bezier triangles
 */
loft_vec loft_triangle_rational_eval(const loft_triangle_rational *t, loft_bary u);

/* The derivative at u in the direction z, by the quotient rule.
 *
 *   range   u inside the triangle, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the derivative does
 *           not fit (it may be degree * R times the distance of two points); *out is then untouched
 *   error   with Z = |u| + |v| + |w| of z: q16: 1/2 LSB + degree (degree + 1) Z R * 2^-26 LSB
 *           f32, f64: 1/2 ulp of the result + 16 degree (degree + 1) Z R ulp of double
 *   cost    in numbers of num/sci.h, LOFT_AXES + 1 times degree (degree + 1) (degree + 2) / 2
 *           products and as many sums
 *   stack   Cortex-M4 1,748   Cortex-M0+ 1,760   ATmega328P 1,279
 */
enum loft_status loft_triangle_rational_deriv(const loft_triangle_rational *t, loft_bary z,
                                              loft_bary u, loft_vec *out) LOFT_CHECKED;

/* The mixed second derivative at u in the directions y and z: 0 for y = 0 or z = 0 alone, since
 * triangles of degree 1 have one by their weights.
 *
 *   range   as loft_triangle_rational_deriv
 *   error   with Y and Z the |u| + |v| + |w| of y and z, and E = degree^2 Y Z R^2 times the
 *           distance between two control points: q16: 1/2 LSB + 2^-17 LSB + 2^-55 E   f32: 1/2 ulp
 *           of the result + 2^-46 E   f64: 2^-46 E
 *   cost    in numbers of num/sci.h, LOFT_AXES + 1 times 4 runs of de Casteljau's algorithm
 *   stack   Cortex-M4 1,924   Cortex-M0+ 1,904   ATmega328P 1,384
 */
enum loft_status loft_triangle_rational_deriv2(const loft_triangle_rational *t, loft_bary y,
                                               loft_bary z, loft_bary u,
                                               loft_vec *out) LOFT_CHECKED;

/* The three triangles between u and the sides, as loft_triangle_split: a is P T2 T3, b T1 P T3, c
 * T1 T2 P. Weights are not rescaled, so all three keep the parameters of the whole. The results
 * must differ from each other and from the control points.
 *
 *   range   u inside the triangle, otherwise LOFT_ERR_ARG
 *   error   points: as loft_triangle_rational_eval; weights: q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp
 *           f64: 6 degree ulp
 *   cost    in numbers of num/sci.h, LOFT_AXES + 1 runs of de Casteljau's algorithm, and as many
 *           quotients as coordinates
 *   stack   Cortex-M4 2,292   Cortex-M0+ 2,304   ATmega328P 1,620
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17
 */
enum loft_status loft_triangle_rational_split(const loft_triangle_rational *t, loft_bary u,
                                              loft_weighted a[], loft_weighted b[],
                                              loft_weighted c[]) LOFT_CHECKED;

/* The same surface with a degree higher by `times`: LOFT_TRIANGLE_POINTS(degree + times) control
 * points, which must not be those of t.
 *
 *   range   degree + times <= LOFT_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   points: q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 128 ulp
 *           weights: q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: 128 ulp
 *   cost    per control point of the result and axis: two products of num/sci.h per point of the
 *           net
 *   see     Farin, ch. 17: degree elevation
 */
enum loft_status loft_triangle_rational_elevate(const loft_triangle_rational *t, unsigned times,
                                                loft_weighted out[]) LOFT_CHECKED;

/* True if the surface has a tangent plane at u: its derivatives there are not parallel and not 0,
 * as the given numbers decide.
 *
 *   range   u inside the triangle; f32, f64: numbers that pass loft_exact_valid, otherwise false
 *   error   none
 *   cost    4 runs of de Casteljau's algorithm modulo one prime (num/residue.h), where there is
 *           none modulo many
 *   stack   Cortex-M4 688   Cortex-M0+ 712   ATmega328P 665
 */
bool loft_triangle_rational_regular(const loft_triangle_rational *t, loft_bary u);

LOFT_END_C

#endif
