/* lib/curve/bezier.h -- Bezier curves of degree 0..9: points, derivatives, pieces
 * SPDX-License-Identifier: MIT
 *
 * There are two kinds: loft_bezier, of any degree with borrowed control points, and loft_cubic,
 * four points by value, which has a faster implementation. Everything is computed in loft_acc and
 * rounded once at the end, so the errors below are little more than the 1/2 LSB that no result can
 * avoid.
 *
 *     loft_bezier b;
 *     if (loft_bezier_init(&b, points, 5) == LOFT_OK)
 *         p = loft_bezier_eval(&b, loft_unit_of(1, 3));
 *
 * Outside 0..1 the law of extrapolation holds (basis/bernstein.c). With L = |1 - t| + |t|, which is
 * at most 3 for t in -1..2, values grow like L^degree. In q16 the error still stays below 0.6 LSB
 * because of the 16 guard bits. A result that does not fit a coordinate is reported, never wrapped.
 *
 * A parameter is a loft_unit. A parameter given with more digits (q16: than 2^-24) has already been
 * rounded; that moves the point by at most 2^-25 * max|P'|.
 *
 * In the `error` lines ulp is that of the largest control value. q16 and f32 accept any finite
 * coordinates, f64 those below 2^1000, so that a difference of control points cannot overflow.
 */
#ifndef LOFT_CURVE_BEZIER_H
#define LOFT_CURVE_BEZIER_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "geom/vec.h"           /* loft_vec, loft_box */

LOFT_BEGIN_C

#define LOFT_BEZIER_ELEVATE_MAX 32      /* the highest degree to which curves, triangles and tensor
                                         * nets are elevated */
#define LOFT_ELEVATE_MAX 18             /* ... those with weights, and other nets */

/* A cubic, by value: the input of motion planning and flattening. */
typedef struct {
    loft_vec p[4];
} loft_cubic;

/* A curve of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t degree;
} loft_bezier;


/* Any degree: points
 * ------------------ */

/* Make a curve of degree + 1 control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise LOFT_ERR_RANGE. *b
 *           is untouched after an error
 *   error   none: the points are borrowed
 *   cost    two comparisons per coordinate
 */
enum loft_status loft_bezier_init(loft_bezier *b, const loft_vec p[], unsigned degree) LOFT_CHECKED;

/* The point at t, by de Casteljau's algorithm.
 *
 *   range   t is clamped to 0..1 (nan to 0); it cannot fail
 *   error   q16: 1/2 LSB + degree * 2^-17 LSB, exact at 0 and 1
 *           f32: 1 ulp   f64: 3 * degree ulp
 *   cost    degree * (degree + 1) / 2 wide lerps per axis; safe in an ISR
 *   stack   Cortex-M4 168   Cortex-M0+ 228   ATmega328P 158
 *   see     Farin, Curves and Surfaces for CAGD, ch. 4
 */
loft_vec loft_bezier_eval(const loft_bezier *b, loft_unit t);

/* The point at t, also beyond the ends.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point does not fit. *out is
 *           untouched after an error
 *   error   q16: 1/2 LSB + (L^degree - 1) / (L - 1) * 2^-17 LSB, below 0.58 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 3 * degree * L^degree ulp
 *   cost    as eval
 */
enum loft_status loft_bezier_extrapolate(const loft_bezier *b, loft_unit t,
                                         loft_vec *out) LOFT_CHECKED;

/* The k-th derivative with respect to t; 0 for k > degree.
 *
 *   range   as extrapolate
 *   error   q16: 1/2 LSB + f * e LSB, f = degree! / (degree - k)!, e = (m in 0..1, (L^m - 1) / (L -
 *           1) outside) * 2^-17, m = degree - k
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: f * 2^k * L^m * (3 * m + k + 1) ulp
 *   cost    differences, then as eval for degree - k
 *   see     Farin, ch. 5: derivatives of a Bezier curve
 */
enum loft_status loft_bezier_deriv(const loft_bezier *b, unsigned k, loft_unit t,
                                   loft_vec *out) LOFT_CHECKED;

/* The point at t of a curve given in Bezier's own form: a start point a[0] and edges
 * a[1]..a[degree]. Their partial sums are the control points, which may leave the range; only the
 * result must fit.
 *
 *   range   degree 0..9 and t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point does
 *           not fit. Outside 0..1 and for degree 8 and 9, also if one of the sums does not fit
 *   error   as extrapolate (ulp of the largest sum)
 *   cost    as eval, and `degree` additions per axis
 *   see     P. Bezier, Numerical Control: Mathematics and Applications (1972)
 */
enum loft_status loft_bezier_from_edges(const loft_vec a[], unsigned degree, loft_unit t,
                                        loft_vec *out) LOFT_CHECKED;

/* Any degree: pieces and other forms
 * ----------------------------------
 * `out`, `left` and `right` may be the control points themselves. They are undefined after an
 * error. */

/* The control points of the pieces 0..t and t..1, degree + 1 each. `left` and `right` must differ.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a point does not fit
 *   error   as extrapolate, per control point; left[degree] equals right[0]
 *   cost    as eval
 */
enum loft_status loft_bezier_split(const loft_bezier *b, loft_unit t, loft_vec left[],
                                   loft_vec right[]) LOFT_CHECKED;

/* The control points of the piece from..to; from > to reverses it.
 *
 *   range   both in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a point does not fit
 *   error   as extrapolate with the larger L, per control point
 *   cost    degree * (degree + 1) * (degree + 5) / 6 wide lerps per axis at most
 *   stack   Cortex-M4 248   Cortex-M0+ 324   ATmega328P 236
 *   see     Ramshaw, blossoming: out[k] = b[from^(degree-k), to^k]
 */
enum loft_status loft_bezier_sub(const loft_bezier *b, loft_unit from, loft_unit to,
                                 loft_vec out[]) LOFT_CHECKED;

/* The same curve with its degree elevated by `times`: degree + times + 1 control points.
 *
 *   range   degree + times <= LOFT_BEZIER_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   with e = degree + times - 18, 0 if that is negative: q16: 1/2 LSB + (1 + e) 2^-17 LSB
 *           f32: 1 ulp   f64: degree + 3 + 4 e ulp
 *   cost    (degree + 1) * (times + 1) small products and degree + times + 1 divisions per axis;
 *           beyond degree 18 a division for each point of each degree
 *   see     Farin, ch. 6: repeated degree elevation
 */
enum loft_status loft_bezier_elevate(const loft_bezier *b, unsigned times,
                                     loft_vec out[]) LOFT_CHECKED;

/* The coefficients of t^0..t^degree.
 *
 *   range   LOFT_ERR_RANGE if one does not fit
 *   error   q16: none   f32: 1/2 ulp of the result + 1/2 ulp   f64: (k + 1) * 2^k * C(degree,k) ulp
 *   cost    degree * (degree + 1) / 2 subtractions and degree - 1 products by an integer per axis
 */
enum loft_status loft_bezier_power(const loft_bezier *b, loft_vec out[]) LOFT_CHECKED;

/* The control points of the curve c[0] + c[1] t + .. + c[degree] t^degree.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a point does not fit
 *   error   q16: 1/2 LSB + degree * 2^-17 LSB   f32: 1/2 ulp of the result + 1/2 ulp   f64: (degree
 *           + 1) * (degree + 2) ulp
 *   cost    as loft_bernstein_from_power, per axis
 */
enum loft_status loft_bezier_from_power(const loft_vec c[], unsigned degree,
                                        loft_vec out[]) LOFT_CHECKED;

/* The box of the control polygon. The curve over 0..1 lies inside; the box is not the smallest.
 *
 *   error   none
 *   cost    two comparisons per coordinate
 */
loft_box loft_bezier_box(const loft_bezier *b);


/* Cubics: the faster implementation
 * ---------------------------------
 *
 * No init. Parameters are clamped to 0..1; nothing can fail. */

/* The line from..to as a cubic, evenly run through: for what takes cubics alone, as a plan.
 *
 *   error   of the inner points, q16: 1/2 LSB   f32: 1/2 ulp   f64: 4 ulp;  none at the ends
 *   cost    4 lerps per axis
 */
loft_cubic loft_cubic_line(loft_vec from, loft_vec to);

/* The point at t.
 *
 *   error   q16: 1/2 LSB + 2^-15 LSB   f32: 1 ulp   f64: 16 ulp;  exact at 0 and 1
 *   cost    4 wide products per axis; safe in an ISR
 *   stack   Cortex-M4 112   Cortex-M0+ 172   ATmega328P 101
 */
loft_vec loft_cubic_eval(const loft_cubic *c, loft_unit t);

/* The k-th derivative at t as loft_acc, since it may exceed the coordinates 6-fold (k = 1), 24-fold
 * (k = 2) or 48-fold (k = 3); 0 for k > 3.
 *
 *   error   q16: (3 - k) * 2^-33, for k = 0 2^-31   f32, f64: 2^(k+6) ulp of double
 *   cost    k = 1: 3 wide products per axis, k = 2: 1
 */
void loft_cubic_deriv(const loft_cubic *c, unsigned k, loft_unit t, loft_acc out[LOFT_AXES]);

/* The piece from..to; from > to reverses it.
 *
 *   error   q16: 1/2 LSB + 3 * 2^-17 LSB   f32: 1 ulp   f64: 9 ulp;  exact at 0 and 1
 *   cost    14 wide lerps per axis
 */
loft_cubic loft_cubic_sub(const loft_cubic *c, loft_unit from, loft_unit to);

/* The pieces 0..t and t..1.
 *
 *   error   as sub; left->p[3] equals right->p[0]
 *   cost    6 wide lerps per axis
 */
void loft_cubic_split(const loft_cubic *c, loft_unit t, loft_cubic *left, loft_cubic *right);

LOFT_END_C

#endif
