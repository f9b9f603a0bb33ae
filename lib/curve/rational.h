/* lib/curve/rational.h -- rational Bezier curves of degree 0..9: points, derivatives, pieces, also
 * beyond their ends
 * SPDX-License-Identifier: MIT
 *
 * Every control point has a weight, and the curve is sum B_k w_k p_k / sum B_k w_k: what NURBS and
 * exact circles are made of. Points are given as they lie in space, not multiplied by their
 * weights:
 *
 *     loft_weighted quarter[3] = { { { { R, 0 } }, one },
 *                                  { { { R, R } }, root_half },
 *                                  { { { 0, R } }, one } };
 *     loft_rational r;
 *     if (loft_rational_init(&r, quarter, 2) == LOFT_OK)
 *         p = loft_rational_eval(&r, loft_unit_of(1, 3));
 *
 * Only the ratios of the weights count. In q16 a weight is rounded to 2^-16 like any number, so
 * large ones lose less: write 256 and 181.01934 rather than 1 and 0.70711. A weight that is off by
 * e of itself moves the curve by at most e/4 of the distance between its point and the others.
 *
 * In the `error` lines R is the largest weight over the smallest, at most 65536, and ulp is that of
 * the largest control value. Coordinates are accepted as in bezier.h.
 */
#ifndef LOFT_CURVE_RATIONAL_H
#define LOFT_CURVE_RATIONAL_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "curve/bezier.h"       /* LOFT_ELEVATE_MAX */
#include "geom/vec.h"           /* loft_vec, loft_box */

LOFT_BEGIN_C

#define LOFT_WEIGHT_MIN LOFT_REAL(0.00390625)
#define LOFT_WEIGHT_MAX LOFT_REAL(256)

/* A mean of weights within 1/256..256, where in f64 its last bit may have been lost. */
static inline loft_real loft_weight_clamp(loft_real w)
{
    return w < LOFT_WEIGHT_MIN ? LOFT_WEIGHT_MIN : w > LOFT_WEIGHT_MAX ? LOFT_WEIGHT_MAX : w;
}

/* A control point with its weight, 1/256..256. */
typedef struct {
    loft_vec  p;
    loft_real w;
} loft_weighted;

/* A curve of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_weighted *p;
    int32_t scale;              /* a power of two: the largest weight times it is in 2^14 .. 2^15 */
    uint8_t degree;
} loft_rational;

/* What makes the largest of `count` weights 2^14 .. 2^15, the scale at which rational curves and
 * patches compute.
 *
 *   range   weights 1/256..256 and finite coordinates, otherwise LOFT_ERR_RANGE
 *   error   none: a power of two
 *   cost    two comparisons a coordinate and a weight, at most 22 doublings
 */
enum loft_status loft_weighted_scale(const loft_weighted p[], unsigned count,
                                     int32_t *scale) LOFT_CHECKED;

/* Make a curve of degree + 1 control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; weights 1/256..256 and finite coordinates,
 *           otherwise LOFT_ERR_RANGE; *r is untouched then
 *   error   none: the points are borrowed
 *   cost    two comparisons a coordinate and a weight, at most 22 doublings
 */
enum loft_status loft_rational_init(loft_rational *r, const loft_weighted p[],
                                    unsigned degree) LOFT_CHECKED;

/* The point at t, by de Casteljau's algorithm for numerator and denominator.
 *
 *   range   t is clamped to 0..1 (nan to 0): cannot fail
 *   error   q16: 1/2 LSB + degree * R * 2^-30 LSB, below 0.501 LSB; exact at 0 and 1
 *           f32: 1 ulp, exact at 0 and 1   f64: 6 * degree + 4 ulp, 1 ulp at 0 and 1
 *   cost    degree * (degree + 1) / 2 wide lerps per axis and once more, a quotient per axis;
 *           80 bytes of stack; safe in an ISR
 *   see     Farin, Curves and Surfaces for CAGD, ch. 13: rational Bezier curves
 */
loft_vec loft_rational_eval(const loft_rational *r, loft_unit t);

/* The point at t, beyond the ends as well. There the denominator may shrink to nothing, and no
 * bound holds for all: what divides by it asks for 2^-20 of the largest weight at least, and the
 * law of extrapolation is that of bezier.h with K in place of L^degree,
 *
 *     L = |1 - t| + |t|       K = L^degree * W / w(t)        W the largest weight, w(t) the
 *                                                            denominator
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE where w(t) < 2^-20 W (not within
 *           2^-40 of that) or the point does not fit; *out is untouched then
 *   error   q16: 1/2 LSB + 2^-40 LSB   f32: 1/2 ulp of the result + 4 * (degree + 2) * K ulp of
 *           double, of the largest of control values and result   f64: 4 * (degree + 2) * K ulp of
 *           that
 *   cost    degree * (degree + 1) / 2 deep lerps per axis and once more, a quotient of 128 bits per
 *           axis; 500 bytes of stack
 */
enum loft_status loft_rational_extrapolate(const loft_rational *r, loft_unit t,
                                      loft_vec *out) LOFT_CHECKED;

/* The first derivative with respect to t, by the quotient rule in the form of Floater: with the two
 * points p0, p1 and weights w0, w1 before the last step, n w0 w1 / w^2 (p1 - p0).
 *
 *   range   as extend; LOFT_ERR_RANGE when the derivative does not fit (it may be degree * R times
 *           the distance of two points, and more outside 0..1)
 *   error   in 0..1: q16: 0.51 LSB   f32, f64: 1/2 ulp of the result + 24 * degree^2 * R ulp of
 *           double (24 * degree * w0 w1 / w^2)
 *           outside: q16: 0.51 LSB + 2^-24 K LSB   f32, f64: 1/2 ulp of the result + 24 * degree^2
 *                                                  * K^2 ulp of
 *           double, of the largest of control values and point
 *   cost    twice extend; per axis 3 long quotients; q16: 900 bytes of stack
 *   see     Floater, Derivatives of rational Bezier curves, CAGD 9 (1992)
 */
enum loft_status loft_rational_deriv(const loft_rational *r, loft_unit t,
                                     loft_vec *out) LOFT_CHECKED;

/* Pieces and other forms
 * ----------------------
 * `out`, `left` and `right` may be the control points themselves. They are undefined after an
 * error. Their points err as those of eval; their weights by 1/2 LSB in q16, which may move the
 * piece by more than that. */

/* The control points of the pieces 0..t and t..1, degree + 1 each. Their weights are as they come,
 * so that both pieces together still have one parameter. `left` and `right` must differ.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; outside 0..1 LOFT_ERR_RANGE when a point does not
 *           fit or a weight is not in 1/256..256: it may vanish or turn negative
 *   error   points as extend, where w(t) is the weight of the point; weights q16: 1/2 LSB + 2^-15
 *           LSB   f32: 1 ulp
 *           f64: 3 * degree ulp, outside 0..1 of L^degree W
 *   cost    as extend, with degree + 1 quotients per axis and piece; q16: 900 bytes of stack
 */
enum loft_status loft_rational_split(const loft_rational *r, loft_unit t, loft_weighted left[],
                                     loft_weighted right[]) LOFT_CHECKED;

/* The control points of the piece from..to; from > to gives it reversed. The weights have a common
 * factor, a power of two that brings the largest into 128..256, so that q16 keeps most of them:
 * there the piece is the same curve to within R * 2^-25 of the width of its polygon, R being that
 * of the piece.
 *
 *   range   both in -1..2, otherwise LOFT_ERR_ARG; outside 0..1 LOFT_ERR_RANGE when a point does
 *           not fit, a weight is below 2^-20 W, or with the common factor below 1/256
 *   error   points as extend with the larger L, where w(t) is the weight of the point
 *   cost    degree * (degree + 1) * (degree + 5) / 6 deep lerps per axis and once more, degree + 1
 *           quotients per axis; q16: 1.1 kB of stack
 *   see     Ramshaw, blossoming, for numerator and denominator
 */
enum loft_status loft_rational_sub(const loft_rational *r, loft_unit from, loft_unit to,
                                    loft_weighted out[]) LOFT_CHECKED;

/* The weights of out[0..degree] from those of the form of num/acc128.h, with a common factor as in
 * loft_rational_sub.
 *
 *   range   q16: w < 2^30, the largest at most 65536 times the smallest   all: the largest at least
 *           128
 *   error   q16: 1/2 LSB   f32: 1 ulp   f64: none but what w has
 *   cost    at most 2 * degree + 24 divisions by a power of two
 */
void loft_rational_weights(const loft_acc w[], unsigned degree, loft_weighted out[]);

/* The same curve with a degree higher by `times`: degree + times + 1 control points.
 *
 *   range   degree + times <= LOFT_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   points: that of eval with times in place of degree; weights q16: 1/2 LSB + times *
 *           2^-17 LSB
 *           f32: 1 ulp   f64: 4 * times ulp
 *   cost    times * (degree + times) wide lerps with two divisions per axis and once more; 304
 *           bytes of stack
 *   see     Farin, ch. 13: degree elevation
 */
enum loft_status loft_rational_elevate(const loft_rational *r, unsigned times,
                                     loft_weighted out[]) LOFT_CHECKED;

/* The box of the control polygon. The curve over 0..1 lies inside; the box is not the smallest.
 *
 *   error   none
 *   cost    two comparisons a coordinate
 */
loft_box loft_rational_box(const loft_rational *r);

LOFT_END_C

#endif
