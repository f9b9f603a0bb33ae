/* lib/curve/rational.h -- rational Bezier curves of degree 0..9: points, derivatives, pieces, also
 * beyond their ends
 * SPDX-License-Identifier: MIT
 *
 * Every control point has a weight, and the curve is sum B_k w_k p_k / sum B_k w_k: the form of
 * NURBS and exact circles. Points are given in space, not multiplied by their weights:
 *
 *     loft_weighted quarter[3] = { { { { R, 0 } }, one },
 *                                  { { { R, R } }, root_half },
 *                                  { { { 0, R } }, one } };
 *     loft_rational r;
 *     if (loft_rational_init(&r, quarter, 2) == LOFT_OK)
 *         p = loft_rational_eval(&r, loft_unit_of(1, 3));
 *
 * Only the ratios of the weights matter. In q16 a weight is rounded to 2^-16 like any number, so
 * large weights lose less: write 256 and 181.01934 instead of 1 and 0.70711. A relative error e of
 * a weight moves the curve by at most e/4 of the distance between its point and the others.
 *
 * In the `error` lines R is the ratio of the largest weight to the smallest, at most 65536, and ulp
 * is that of the largest control value. Valid coordinates are those of bezier.h.
 */
#ifndef LOFT_CURVE_RATIONAL_H
#define LOFT_CURVE_RATIONAL_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "curve/bezier.h"       /* LOFT_ELEVATE_MAX */
#include "geom/vec.h"           /* loft_vec, loft_box */

LOFT_BEGIN_C

#define LOFT_WEIGHT_MIN LOFT_REAL(0.00390625)
#define LOFT_WEIGHT_MAX LOFT_REAL(256)

/* Clamp an average of weights to 1/256..256; in f64 its last bit may have left the range. */
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
    int32_t scale;              /* a power of two: scales the largest weight to 2^14 .. 2^15      */
    uint8_t degree;
} loft_rational;

/* The power of two that scales the largest of `count` weights to 2^14 .. 2^15, the scale of the
 * computations with rational curves and patches.
 *
 *   range   weights 1/256..256 and finite coordinates, otherwise LOFT_ERR_RANGE
 *   error   none: a power of two
 *   cost    two comparisons per coordinate and weight, at most 22 doublings
 */
enum loft_status loft_weighted_scale(const loft_weighted p[], unsigned count,
                                     int32_t *scale) LOFT_CHECKED;

/* Make a curve of degree + 1 control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; weights 1/256..256 and finite coordinates,
 *           otherwise LOFT_ERR_RANGE. *r is untouched after an error
 *   error   none: the points are borrowed
 *   cost    two comparisons per coordinate and weight, at most 22 doublings
 */
enum loft_status loft_rational_init(loft_rational *r, const loft_weighted p[],
                                    unsigned degree) LOFT_CHECKED;

/* The point at t, by de Casteljau's algorithm for numerator and denominator.
 *
 *   range   t is clamped to 0..1 (nan to 0); it cannot fail
 *   error   q16: 1/2 LSB + degree * R * 2^-30 LSB, below 0.501 LSB; exact at 0 and 1
 *           f32: 1 ulp, exact at 0 and 1   f64: 6 * degree + 4 ulp, 1 ulp at 0 and 1
 *   cost    degree * (degree + 1) / 2 wide lerps per axis and for the weights, a quotient per axis;
 *           safe in an ISR
 *   stack   Cortex-M4 152   Cortex-M0+ 228   ATmega328P 174
 *   see     Farin, Curves and Surfaces for CAGD, ch. 13: rational Bezier curves
 */
loft_vec loft_rational_eval(const loft_rational *r, loft_unit t);

/* The point at t, also beyond the ends. There the denominator may become arbitrarily small, and no
 * bound holds for all curves. Divisions therefore require at least 2^-20 of the largest weight, and
 * the law of extrapolation is that of bezier.h with K in place of L^degree,
 *
 *     L = |1 - t| + |t|       K = L^degree * W / w(t)
 *
 * where W is the largest weight and w(t) the denominator.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if w(t) < 2^-20 W (to 2^-40 of that)
 *           or the point does not fit. *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-40 LSB   f32: 1/2 ulp of the result + 4 * (degree + 2) * K ulp of
 *           double, of the largest of control values and result   f64: 4 * (degree + 2) * K ulp of
 *           that
 *   cost    degree * (degree + 1) / 2 lerps of loft_acc128 per axis and for the weights, a quotient
 *           of 128 bits per axis
 *   stack   Cortex-M4 560   Cortex-M0+ 572   ATmega328P 556
 */
enum loft_status loft_rational_extrapolate(const loft_rational *r, loft_unit t,
                                           loft_vec *out) LOFT_CHECKED;

/* The first derivative with respect to t, by Floater's form of the quotient rule. With the two
 * points p0, p1 and weights w0, w1 before the last step it is n w0 w1 / w^2 (p1 - p0).
 *
 *   range   as extrapolate; LOFT_ERR_RANGE if the derivative does not fit (it may be degree * R
 *           times the distance of two points, and more outside 0..1)
 *   error   in 0..1: q16: 0.51 LSB   f32, f64: 1/2 ulp of the result + 24 * degree^2 * R ulp of
 *           double (24 * degree * w0 w1 / w^2)
 *           outside: q16: 0.51 LSB + 2^-24 K LSB   f32, f64: 1/2 ulp of the result + 24 * degree^2
 *           * K^2 ulp of double, of the largest of control values and point
 *   cost    twice extrapolate; 3 long quotients per axis
 *   stack   Cortex-M4 1,008   Cortex-M0+ 1,012   ATmega328P 1,001
 *   see     Floater, Derivatives of rational Bezier curves, CAGD 9 (1992)
 */
enum loft_status loft_rational_deriv(const loft_rational *r, loft_unit t,
                                     loft_vec *out) LOFT_CHECKED;

/* Pieces and other forms ---------------------- `out`, `left` and `right` may be the control points
 * themselves. They are undefined after an error. The errors of their points are those of eval.
 * Their weights have an error of 1/2 LSB in q16, which may move the piece by more than that. */

/* The control points of the pieces 0..t and t..1, degree + 1 each. The weights are not rescaled, so
 * both pieces together keep one parameter. `left` and `right` must differ.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; outside 0..1 LOFT_ERR_RANGE if a point does not fit
 *           or a weight is not in 1/256..256: it may vanish or become negative
 *   error   points as extrapolate, where w(t) is the weight of the point; weights q16: 1/2 LSB +
 *           2^-15 LSB   f32: 1 ulp
 *           f64: 3 * degree ulp, outside 0..1 of L^degree W
 *   cost    as extrapolate, with degree + 1 quotients per axis and piece
 *   stack   Cortex-M4 992   Cortex-M0+ 1,004   ATmega328P 986
 */
enum loft_status loft_rational_split(const loft_rational *r, loft_unit t, loft_weighted left[],
                                     loft_weighted right[]) LOFT_CHECKED;

/* The control points of the piece from..to; from > to reverses it. The weights are scaled by a
 * power of two that brings the largest into 128..256, so that q16 keeps most of their bits. In q16
 * the piece is the same curve to within R * 2^-25 of the width of its polygon, with the R of the
 * piece.
 *
 *   range   both in -1..2, otherwise LOFT_ERR_ARG; outside 0..1 LOFT_ERR_RANGE if a point does not
 *           fit, if a weight is below 2^-20 W, or if a scaled weight is below 1/256
 *   error   points as extrapolate with the larger L, where w(t) is the weight of the point
 *   cost    degree * (degree + 1) * (degree + 5) / 6 lerps of loft_acc128 per axis and for the
 *           weights, degree + 1 quotients per axis
 *   stack   Cortex-M4 1,152   Cortex-M0+ 1,156   ATmega328P 1,118
 *   see     Ramshaw, blossoming, for numerator and denominator
 */
enum loft_status loft_rational_sub(const loft_rational *r, loft_unit from, loft_unit to,
                                   loft_weighted out[]) LOFT_CHECKED;

/* Set the weights of out[0..degree] from weights in the form of num/acc128.h, scaled as in
 * loft_rational_sub.
 *
 *   range   q16: w < 2^30, the largest at most 65536 times the smallest   all: the largest at least
 *           128
 *   error   q16: 1/2 LSB   f32: 1 ulp   f64: only that of w
 *   cost    at most 2 * degree + 24 divisions by a power of two
 */
void loft_rational_weights(const loft_acc w[], unsigned degree, loft_weighted out[]);

/* The same curve with its degree elevated by `times`: degree + times + 1 control points.
 *
 *   range   degree + times <= LOFT_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   points: as eval with times in place of degree; weights q16: 1/2 LSB + times * 2^-17 LSB
 *           f32: 1 ulp   f64: 4 * times ulp
 *   cost    times * (degree + times) wide lerps with two divisions per axis and for the weights
 *   stack   Cortex-M4 464   Cortex-M0+ 548   ATmega328P 430
 *   see     Farin, ch. 13: degree elevation
 */
enum loft_status loft_rational_elevate(const loft_rational *r, unsigned times,
                                       loft_weighted out[]) LOFT_CHECKED;

/* The box of the control polygon. The curve over 0..1 lies inside; the box is not the smallest.
 *
 *   error   none
 *   cost    two comparisons per coordinate
 */
loft_box loft_rational_box(const loft_rational *r);

LOFT_END_C

#endif
