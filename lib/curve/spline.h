/* lib/curve/spline.h -- cubic splines through given points with any ends: closed, clamped,
 * not-a-knot, natural, hidden points
 * SPDX-License-Identifier: MIT
 *
 * There is one cubic between each point and the next, joined with equal first and second
 * derivatives. What natural.h leaves to the batten, the ends, is said here:
 *
 *   LOFT_ENDS_NATURAL      the second derivative is 0 at both ends
 *   LOFT_ENDS_CLAMPED      the first derivatives at both ends are given
 *   LOFT_ENDS_NOT_A_KNOT   the third derivative does not jump at the second and last but one point;
 *                          three points make a parabola, two a straight line
 *   LOFT_ENDS_CLOSED       the curve returns to its first point, without a corner there
 *
 *     static loft_spline_knot knots[COUNT];
 *     loft_spline s;
 *     if (loft_spline_init(&s, points, COUNT, LOFT_ENDS_CLOSED, LOFT_CHORD, knots) == LOFT_OK)
 *         for (uint32_t i = 0; i < loft_spline_segments(&s); i++)
 *             if (loft_cubic_from_spline(&s, i, &c) == LOFT_OK)
 *                 ..                                  // walk it, flatten it, plan it
 *
 * Points are borrowed, the memory is the caller's. Steps between knots are 1 (LOFT_UNIFORM), the
 * distances of the points (LOFT_CHORD), or given. The numbers are those of num/sci.h, so steps may
 * differ by any factor. A natural spline with uniform or chord length knots is faster by natural.h.
 *
 * In the `error` lines h is the step of the segment and S the largest slope, of the spline or of a
 * chord over its step. Q is 1 for all ends but not-a-knot. There it is the product of two ratios,
 * at least 1: the first step over the second, and the last over the last but one. In q16 2^-57 S h
 * Q exceeds 2^-17 LSB only there, where a step of a few LSB stands beside one of thousands. f64
 * accepts coordinates below 2^1000.
 */
#ifndef LOFT_CURVE_SPLINE_H
#define LOFT_CURVE_SPLINE_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */
#include "curve/natural.h"      /* loft_spacing */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

enum loft_spline_ends {
    LOFT_ENDS_NATURAL,
    LOFT_ENDS_CLAMPED,
    LOFT_ENDS_NOT_A_KNOT,
    LOFT_ENDS_CLOSED
};

/* The data of one point. Complete so that the caller can own it; the fields may change without
 * notice. */
typedef struct {
    loft_sci step;                  /* to the next knot                                         */
    loft_sci next, last;            /* of the elimination: shares of the next and the last slope */
    loft_sci slope[LOFT_AXES];
} loft_spline_knot;

/* A spline. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    const loft_spline_knot *knot;
    uint32_t count, stride;
    uint8_t ends;
} loft_spline;

/* Make the spline through p[0 .. count - 1] with the ends natural, not-a-knot or closed; points and
 * memory[count] must outlive it.
 *
 *   range   count >= 2, closed count >= 3, otherwise LOFT_ERR_ARG (as LOFT_ENDS_CLAMPED, which
 *           needs slopes); LOFT_ERR_RANGE for coordinates that are not valid numbers (f32, f64);
 *           LOFT_SINGULAR if two neighbours coincide with chord length knots
 *   error   of the slopes, q16: 2^-57 S Q   f32, f64: 2^-49 S Q
 *   cost    O(count): per point 5 + 5 LOFT_AXES products and 4 + LOFT_AXES quotients of num/sci.h;
 *           memory of 96 bytes per point (q16, 3 axes)
 *   see     de Boor, A Practical Guide to Splines, ch. 4; Farin, Curves and Surfaces for CAGD, ch.
 *           9
 */
enum loft_status loft_spline_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                  enum loft_spline_ends ends, enum loft_spacing spacing,
                                  loft_spline_knot memory[]) LOFT_CHECKED;

/* Make the spline with the derivatives slope[0] at the first point and slope[1] at the last one:
 * per knot (uniform) or per unit of chord length.
 *
 *   range   as loft_spline_init
 *   error   as loft_spline_init
 *   cost    as loft_spline_init
 */
enum loft_status loft_spline_clamped_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                          const loft_vec slope[2], enum loft_spacing spacing,
                                          loft_spline_knot memory[]) LOFT_CHECKED;

/* Make the spline with the knots u[0] < u[1] < .. of the points p[0], p[stride], p[2 stride] ..,
 * which is not closed: for the lines of a net, and points with times.
 *
 *   range   as loft_spline_init; LOFT_ERR_ARG unless the knots increase, and for closed ends
 *   error   as loft_spline_init
 *   cost    as loft_spline_init
 */
enum loft_status loft_spline_knots_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                        uint32_t stride, const loft_real u[],
                                        enum loft_spline_ends ends,
                                        loft_spline_knot memory[]) LOFT_CHECKED;

/* What the first and the last of the points are for, which the curve is not drawn to. */
enum loft_spline_hidden {
    LOFT_HIDDEN_THROUGH,        /* the natural spline meets them, beyond what is drawn          */
    LOFT_HIDDEN_SLOPE           /* the slope at p[1] is (p[2] - p[0]) / 2, likewise at the end  */
};

/* Make the spline from p[1] to p[count - 2], whose shape at the ends p[0] and p[count - 1] say.
 * Knots are uniform; segment 0 begins at p[1].
 *
 *   range   count >= 4, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE as loft_spline_init
 *   error   as loft_spline_init
 *   cost    as loft_spline_init, for `count` points and memory[count]
 *   see     the second way to complete a natural spline: two readings of one text
 */
enum loft_status loft_spline_hidden_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                         enum loft_spline_hidden hidden,
                                         loft_spline_knot memory[]) LOFT_CHECKED;

/* The number of segments: count - 1, closed count.
 *
 *   error   none
 *   cost    a comparison
 */
uint32_t loft_spline_segments(const loft_spline *s);

/* The point of segment i, from p[i] to p[i+1], at t; the last segment of a closed spline ends at
 * p[0].
 *
 *   range   i < loft_spline_segments(s) and t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if
 *           the point does not fit. *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-17 LSB + 2^-57 S h Q, exact at the points
 *           f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: 16 ulp + 2^-48 S h Q
 *   cost    8 products and 10 sums of num/sci.h per axis
 */
enum loft_status loft_spline_eval(const loft_spline *s, uint32_t i, loft_unit t,
                                  loft_vec *out) LOFT_CHECKED;

/* The k-th derivative with respect to the spline's own parameter, k = 1 or 2: per knot (uniform),
 * per unit of chord length, or per unit of the given knots.
 *
 *   range   as eval, and k = 1 or 2
 *   error   q16: 1/2 LSB + 2^-17 LSB + 2^-54 S Q, k = 2: 2^-54 S Q / h in place of that
 *           f32: 1/2 ulp of the result + 2^-46 S Q, k = 2: + 2^-46 S Q / h
 *           f64: 1 ulp + 2^-46 S Q, k = 2: 1 ulp + 2^-46 S Q / h
 *   cost    8 products, 10 sums and 2 quotients of num/sci.h per axis
 */
enum loft_status loft_spline_deriv(const loft_spline *s, uint32_t i, unsigned k, loft_unit t,
                                   loft_vec *out) LOFT_CHECKED;

/* The k-th derivative of segment i in one axis, k = 0, 1 or 2, at the part x of the segment, wide:
 * for sums of several splines.
 *
 *   range   i and k as above; any x
 *   error   as eval and deriv, without the rounding to a coordinate
 *   cost    as deriv
 */
loft_sci loft_spline_slope(const loft_spline *s, uint32_t i, unsigned k, loft_sci x, int axis);

/* The control points of segment i.
 *
 *   range   as eval; LOFT_ERR_RANGE if a control point does not fit; *out is undefined then
 *   error   as eval
 *   cost    3 products and 2 quotients of num/sci.h per axis
 */
enum loft_status loft_cubic_from_spline(const loft_spline *s, uint32_t i,
                                        loft_cubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
