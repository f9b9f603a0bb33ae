/* lib/basis/knots.h -- knot vectors: spans, B-spline weights, one polynomial piece at a time
 * SPDX-License-Identifier: MIT
 *
 * These are the scalar operations behind B-spline and NURBS curves. `points` coefficients of degree
 * p use points + p + 1 nondecreasing knots; the domain is k[p] .. k[points]. Knots and the
 * parameter u are reals of any size, clamped at the ends or not; a knot may occur up to p + 1
 * times. A span is the index s of a piece k[s] < k[s+1] within the domain; its coefficients are s -
 * p .. s. Wide values pass through a chain of lerps that rounds once, at the end:
 *
 *     const unsigned s = loft_knots_find(&knots, u);
 *     for (j = 0; j <= p; j++) c[j] = loft_to_acc(coefficient[s - p + j]);
 *     y = loft_acc_round(loft_knots_eval(&knots, s, u, c));
 *
 * In q16 the place of u between two knots is not rounded, for any spacing of the knots.
 * Coefficients are within the range of loft_real (q16: +-2^15). Functions that take u and a span
 * expect u within the span.
 */
#ifndef LOFT_BASIS_KNOTS_H
#define LOFT_BASIS_KNOTS_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */

LOFT_BEGIN_C

#define LOFT_KNOTS_POINTS_MAX 32000

/* The knots are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_real *k;
    uint16_t points;
    uint8_t  degree;
} loft_knots;

/* Check and store points + degree + 1 knots, which must outlive it.
 *
 *   range   degree 1..9, degree + 1 <= points <= LOFT_KNOTS_POINTS_MAX, knots nondecreasing, none
 *           more than degree + 1 times, a domain that is not empty, otherwise LOFT_ERR_ARG; finite
 *           knots (f64: below 2^1000), otherwise LOFT_ERR_RANGE. *knots is untouched after an error
 *   error   none
 *   cost    two comparisons per knot
 */
enum loft_status loft_knots_init(loft_knots *knots, const loft_real k[], unsigned points,
                                 unsigned degree) LOFT_CHECKED;

/* u clamped to the domain; nan gives its start.
 *
 *   error   none
 *   cost    two comparisons
 */
loft_real loft_knots_clamp(const loft_knots *knots, loft_real u);

/* The span of u, which is clamped: k[s] <= u < k[s+1], and the last span at the end of the domain.
 *
 *   error   none
 *   cost    log2(points) comparisons
 *   see     Piegl and Tiller, The NURBS Book, A2.1
 */
unsigned loft_knots_find(const loft_knots *knots, loft_real u);

/* The first span after `span`, or 0 after the last one. Start with 0, which is never the index of a
 * span.
 *
 *   error   none
 *   cost    a comparison for each knot skipped
 */
unsigned loft_knots_next(const loft_knots *knots, unsigned span);


/* Weights and values
 * ------------------ */

/* The nonzero B-splines at u, which is clamped: the weights of the coefficients first .. first +
 * degree, where `first` is the result.
 *
 *   shape   w[degree + 1]; q16: they sum to exactly 1 (2^32)
 *   error   q16: degree * 2^-32   f32, f64: 6 * degree ulp of double (of 1)
 *   cost    degree * (degree + 1) / 2 times loft_acc_lerp_in
 *   see     The NURBS Book, A2.2; Cox (1972), de Boor (1972)
 */
unsigned loft_knots_weights(const loft_knots *knots, loft_real u, loft_acc w[]);

/* One row of de Boor's scheme, in place: c[j] becomes the value between c[j] and c[j+1], and `rows`
 * of rows + 1 values remain. Start with rows = degree and go down to 1. The same u in each row
 * evaluates the polynomial; different u give the blossom.
 *
 *   error   q16: 2^-33 per row   f32, f64: 5 ulp of double per row
 *   cost    `rows` times loft_acc_lerp_in
 *   see     de Boor, On calculating with B-splines, J. Approx. Theory 6 (1972); Ramshaw, blossoming
 */
void loft_knots_step(const loft_knots *knots, unsigned span, unsigned rows, loft_real u,
                     loft_acc c[]);

/* The value at u of the piece on `span`. The coefficients c[0..degree] are overwritten.
 *
 *   error   q16: degree * 2^-33   f32, f64: 5 * degree ulp of double, of the largest coefficient,
 *           or of the value itself if all are positive
 *   cost    degree * (degree + 1) / 2 times loft_acc_lerp_in
 */
loft_acc loft_knots_eval(const loft_knots *knots, unsigned span, loft_real u, loft_acc c[]);

/* The Bernstein coefficients out[0..degree] of the piece on `span`. c is overwritten; it must not
 * be `out`.
 *
 *   error   as eval
 *   cost    degree * (degree + 1) * (degree + 5) / 6 times loft_acc_lerp_in
 *   stack   Cortex-M4 272   Cortex-M0+ 332   ATmega328P 238
 */
void loft_knots_bezier(const loft_knots *knots, unsigned span, loft_acc c[], loft_acc out[]);


/* Knot insertion -------------- */

/* True if another knot may be inserted at u: u is within the domain and occurs less than degree + 1
 * times.
 *
 *   error   none
 *   cost    two comparisons per knot
 */
bool loft_knots_valid(const loft_knots *knots, loft_real u);

/* The knots with one more at u: points + degree + 2. `out` may be the knots themselves, if the
 * array is large enough.
 *
 *   range   u passes loft_knots_valid
 *   error   none
 *   cost    as find; moves the knots behind u
 */
void loft_knots_insert(const loft_knots *knots, loft_real u, loft_real out[]);

LOFT_END_C

#endif
