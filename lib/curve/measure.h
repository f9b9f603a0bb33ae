/* lib/curve/measure.h -- flatten a cubic within a tolerance, its length, the parameter at a length
 * SPDX-License-Identifier: MIT
 *
 *     loft_flatten f;
 *     loft_vec     p;
 *     if (loft_flatten_init(&f, &curve, LOFT_REAL(0.01)) == LOFT_OK)
 *         while (loft_flatten_next(&f, &p))
 *             line_to(p);                             // the last one is curve.p[3]
 *
 * No function here keeps global state; none is meant for an interrupt.
 */
#ifndef LOFT_CURVE_MEASURE_H
#define LOFT_CURVE_MEASURE_H

#include "curve/bezier.h"   /* loft_cubic */

LOFT_BEGIN_C

// Chords
// ------

/* State of one flattening; do not rely on its contents. */
typedef struct {
    loft_cubic curve;
    loft_vec   last;        /* where the next chord starts                   */
    loft_acc   limit;       /* tol, less what the arithmetic may err         */
    uint32_t   at;          /* the parameter of `last`, in steps of 2^-24    */
} loft_flatten;

/* Prepare to cut `c` into chords: no point of the curve is farther than `tol` from its chord, no
 * point of a chord farther than `tol` from the curve, with the points rounded as they are given.
 *
 *   shape   loft_flatten_next yields the end of each chord; c->p[0] is not repeated
 *   range   q16: tol >= 2 LSB, any control points   f32: tol >= 2^-22, f64: 2^-43 of the largest
 *           coordinate; below that, or with a control point that is no number: LOFT_ERR_RANGE, tol
 *           <= 0: LOFT_ERR_ARG
 *   error   none: the curve is kept as it is
 *   cost    nothing yet; `c` is copied
 */
enum loft_status loft_flatten_init(loft_flatten *f, const loft_cubic *c,
                                   loft_real tol) LOFT_CHECKED;

/* Give the end of the next chord, the longest that can be proved from here. Returns false, and
 * leaves *out alone, when the curve has ended; the last point is c->p[3] exactly.
 *
 *   error   none beyond `tol`. There are never more chords than halving at the middle gives when a
 *           piece counts as flat with both inner control points within tol of it (tol >= 8 LSB in
 *           q16, 4 times the least in f32 and f64)
 *   cost    10 to 25 trials of a chord, each of 14 lerps and 4 distances, or a few times that; 500
 *           bytes of stack
 */
bool loft_flatten_next(loft_flatten *f, loft_vec *out);


// Length
// ------

/* The length of the curve, by halving until chord and control polygon, between which it lies,
 * agree.
 *
 *   range   any control points that are numbers; tol below 2^-22 of the control polygon's length
 *           counts as that
 *   error   tol, and for the arithmetic 2^-27 of the polygon's length + 1 LSB in q16, 2^-40 of it
 *           in f32, f64
 *   cost    about sqrt(length / tol) times the turning angle in pieces, each 14 lerps and 4 square
 *           roots
 *   see     Gravesen: Adaptive subdivision and the length and energy of Bezier curves, 1997
 */
loft_acc loft_cubic_arclen(const loft_cubic *c, loft_real tol);

/* The parameter at which the curve has the length `length`; 0 below, 1 beyond. Never decreases with
 * `length`.
 *
 *   range   as loft_cubic_arclen, but 2^-21 of the polygon
 *   error   the length from 0 to the result is off by no more than that of loft_cubic_arclen and,
 *           in q16 and f32, what one step of t = 2^-24 makes
 *   cost    as loft_cubic_arclen, up to there. For many lengths along one curve take a ruler
 */
loft_unit loft_cubic_inv_arclen(const loft_cubic *c, loft_acc length, loft_real tol);


// A ruler along one curve
// -----------------------

#define LOFT_ARCLEN_MARKS 16

/* The lengths at t = 0, 1/16 .. 1, from which the others are soon found; do not rely on its
 * contents. */
typedef struct {
    loft_cubic curve;
    loft_acc   tol;
    loft_acc   mark[LOFT_ARCLEN_MARKS + 1];
} loft_arclen;

/* Measure `c` once; it is copied.
 *
 *   range   tol <= 0: LOFT_ERR_ARG, a control point that is no number: LOFT_ERR_RANGE; else as
 *           at_length
 *   error   that of loft_cubic_arclen in each mark
 *   cost    that of loft_cubic_arclen
 */
enum loft_status loft_arclen_init(loft_arclen *r, const loft_cubic *c, loft_real tol) LOFT_CHECKED;

/* The length of the whole curve, and from 0 to t (clamped to 0..1).
 *
 *   range   as at_length
 *   error   as at_length
 *   cost    length: none; eval: that of loft_cubic_arclen for a sixteenth of the curve
 */
loft_acc loft_arclen_total(const loft_arclen *r);
loft_acc loft_arclen_eval(const loft_arclen *r, loft_unit t);

/* The parameter at a length: loft_cubic_inv_arclen in a sixteenth of the time.
 *
 *   error   as loft_cubic_inv_arclen
 *   cost    at most 16 comparisons, and loft_cubic_inv_arclen in a sixteenth of the curve
 */
loft_unit loft_arclen_inverse(const loft_arclen *r, loft_acc length);

LOFT_END_C

#endif
