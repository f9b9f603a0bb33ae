/* lib/curve/forward.h -- walk a Bezier curve at equal parameter steps, by exact forward differences
 * SPDX-License-Identifier: MIT
 *
 * Each point costs `degree` additions per axis and no multiplication. There is no drift: in q16 the
 * differences are exact where n is a power of two, and for any other n they are rounded once, at
 * the start, by what loft_forward_next states. Use it to trace a curve at a fixed rate. For single
 * points use loft_bezier_eval; for steps that follow the curvature use measure.h.
 *
 *     loft_forward w;
 *     loft_vec     p;
 *     if (loft_forward_init(&w, &curve, 64) == LOFT_OK)
 *         while (loft_forward_next(&w, &p))
 *             move_to(p);                      // 64 points, the last one is the last control point
 *
 * The law of ranges: n steps are valid if S = C(n,1) + .. + C(n,degree) <= 2^32 - 2^15, in every
 * number type. C(n,k) is the binomial coefficient.
 *
 *     degree                  1        2       3      4     5
 *     n at most   2^32 - 2^15    92,681   2,953    567   220
 *     n = 2^m, exact      2^31    65,536   1,024    256    64      q16: correctly rounded to here
 */
#ifndef LOFT_CURVE_FORWARD_H
#define LOFT_CURVE_FORWARD_H

#include "curve/bezier.h"       /* loft_bezier */
#include "num/walk_exact.h"     /* loft_walk, loft_walk_exact: the state of one axis */

LOFT_BEGIN_C

#define LOFT_FORWARD_DEGREE_MAX LOFT_WALK_DEGREE_MAX

/* State of one walk. Complete so that it can be static; do not rely on its fields. */
typedef loft_walks loft_forward;        /* .left: points to come */

/* State of a walk that is exact for any n. */
typedef struct {
    loft_walk_exact axis[LOFT_AXES];
    uint64_t power;                     /* n^degree */
    uint32_t left;
    uint8_t degree;
} loft_forward_exact;

/* Prepare to walk `b` in n equal parameter steps.
 *
 *   shape   will yield n points, at t = 1/n, 2/n .. 1; the start is not repeated; `b` is not kept
 *   range   degree 0..5, n >= 1, otherwise LOFT_ERR_ARG; n within the law of ranges, any control
 *           points (f32, f64: to LOFT_REAL_MAX / 65536), otherwise LOFT_ERR_RANGE. *w is untouched
 *           after an error
 *   error   none of its own: for the points see below
 *   cost    q16: degree * 6 divisions of 32 bits and, per axis, degree * (degree + 15) / 2 products
 *   stack   Cortex-M4 340   Cortex-M0+ 460   ATmega328P 232
 *   see     Foley, van Dam, Feiner, Hughes: Computer Graphics, ch. 11
 */
enum loft_status loft_forward_init(loft_forward *w, const loft_bezier *b, uint32_t n) LOFT_CHECKED;

/* Prepare to walk `b` in so many equal steps that chords from point to point are within `tol`: no
 * point of the curve is farther from its chord, and no point of a chord from the curve. The fewest
 * chords are those of measure.h.
 *
 *   shape   as loft_forward_init; w->left is the number of chords
 *   range   as loft_forward_init; tol <= 0: LOFT_ERR_ARG. q16: tol >= 8 LSB   f32: 2^-20,
 *           f64: 2^-35 of the largest coordinate; below that, or with more steps than the law of
 *           ranges allows: LOFT_ERR_RANGE
 *   error   at most `tol`, for the rounded points as well
 *   cost    that of loft_forward_init, degree - 1 distances and two square roots; in all a
 *           hundredth of that of measure.h or less, for twice the chords
 *   stack   Cortex-M4 340   Cortex-M0+ 564   ATmega328P 314
 *   see     Wang, The subdivision method for finding the intersection between two Bezier curves or
 *           surfaces (1984)
 */
enum loft_status loft_forward_flatten(loft_forward *w, const loft_bezier *b,
                                      loft_real tol) LOFT_CHECKED;

/* Get the next point. Returns false, and leaves *out untouched, at the end of the walk.
 *
 *   error   q16: 1/2 LSB for n = 2^m with degree * m <= 32; any other n: 1/2 LSB + S (2^-33 +
 *           2^-50), which is 0.521 LSB for a cubic of 1023 steps. The last point is exact.
 *           f32, f64: (K n + 8 * 3^degree) / 2^53 of the largest control value, K = 1 3 8 21 56 for
 *           degree 1..5 (a sixth of that was measured); f32 adds 1/2 ulp. The last point is exact.
 *   cost    `degree` additions per axis; no branch on data; safe in an ISR
 *   stack   Cortex-M4 32   Cortex-M0+ 56   ATmega328P 4
 */
bool loft_forward_next(loft_forward *w, loft_vec *out);

/* Get the next `count` points at once, or all that are left; returns the number. The points are
 * those of loft_forward_next. It is faster, since it computes one axis after the other with its
 * state in registers.
 *
 *   error   as loft_forward_next
 *   cost    `degree` additions per axis and point; safe in an ISR
 *   stack   Cortex-M4 104   Cortex-M0+ 156   ATmega328P 38
 */
uint32_t loft_forward_run(loft_forward *w, loft_vec out[], uint32_t count);

/* Continue from the current point with half the step: the number of remaining points doubles.
 *
 *   range   q16: n = 2^m with degree * (m + 1) <= 32, with the current m, or undoing a
 *           loft_forward_double; at least 4 steps for the whole curve, and control values at most
 *           2^31 / (degree * 3^(degree-1)) LSB per step apart; otherwise LOFT_ERR_RANGE, and *w is
 *           untouched.
 *           f32, f64: degree * (m + 1) <= 32 likewise
 *   error   as if the walk had begun with this step
 *   cost    at most 7 small products and 5 shifts per axis
 */
enum loft_status loft_forward_halve(loft_forward *w) LOFT_CHECKED;

/* Continue with twice the step.
 *
 *   range   an even number of remaining points; otherwise LOFT_ERR_RANGE, and *w is untouched
 *   error   every second point of the original walk, bit for bit in q16
 *   cost    at most 12 small products per axis
 */
enum loft_status loft_forward_double(loft_forward *w) LOFT_CHECKED;

/* Prepare a walk whose points are exact for any n, at about ten times the cost per point: a
 * quotient and a remainder per difference instead of a rounded one.
 *
 *   range   as loft_forward_init, but n^degree < 2^63: n to 2,097,151 for a cubic
 *   error   none in q16   f32, f64: as loft_forward_init
 *   cost    q16: degree^2 divisions of 64 bits per axis
 */
enum loft_status loft_forward_exact_init(loft_forward_exact *w, const loft_bezier *b,
                                         uint32_t n) LOFT_CHECKED;

/* Get the next point. Returns false, and leaves *out untouched, at the end of the walk.
 *
 *   error   q16: 1/2 LSB, none at the last point   f32, f64: as loft_forward_next
 *   cost    `degree` additions of a quotient and of a remainder per axis; safe in an ISR
 */
bool loft_forward_exact_next(loft_forward_exact *w, loft_vec *out);

LOFT_END_C

#endif
