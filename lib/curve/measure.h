/* lib/curve/measure.h -- flatten a cubic within a tolerance, its arc length, the parameter at an
 * arc length
 * SPDX-License-Identifier: MIT
 *
 *     loft_flatten f;
 *     loft_vec     p;
 *     if (loft_flatten_init(&f, &curve, LOFT_REAL(0.01)) == LOFT_OK)
 *         while (loft_flatten_next(&f, &p))
 *             line_to(p);                             // the last one is curve.p[3]
 *
 * No function here has global state; none is meant for an interrupt.
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
    loft_acc   limit;       /* tol minus the error of the arithmetic         */
    uint32_t   at;          /* the parameter of `last`, in steps of 2^-24    */
} loft_flatten;

/* Prepare to cut `c` into chords: no point of the curve is farther than `tol` from its chord, and
 * no point of a chord is farther than `tol` from the curve. This holds for the rounded points.
 *
 *   shape   loft_flatten_next yields the end of each chord; c->p[0] is not repeated
 *   range   q16: tol >= 2 LSB, any control points   f32: tol >= 2^-22, f64: 2^-43 of the largest
 *           coordinate; below that, or with a control point that is not a valid number:
 *           LOFT_ERR_RANGE; tol <= 0: LOFT_ERR_ARG
 *   error   none: the curve is stored unchanged
 *   cost    nothing yet; `c` is copied
 */
enum loft_status loft_flatten_init(loft_flatten *f, const loft_cubic *c,
                                   loft_real tol) LOFT_CHECKED;

/* Get the end of the next chord, the longest that can be proved valid. Returns false, and leaves
 * *out untouched, at the end of the curve; the last point is exactly c->p[3].
 *
 *   error   at most `tol`. There are never more chords than from halving at the middle until both
 *           inner control points are within tol of the chord (tol >= 8 LSB in q16, 4 times the
 *           smallest tol in f32 and f64)
 *   cost    10 to 25 trials of a chord, each of 14 lerps and 4 distances, or a few times that
 *   stack   Cortex-M4 432   Cortex-M0+ 540   ATmega328P 462
 */
bool loft_flatten_next(loft_flatten *f, loft_vec *out);


// Length
// ------

/* The arc length of the curve, by halving until chord and control polygon, the bounds of the
 * length, agree.
 *
 *   range   any valid control points; a tol below 2^-22 of the control polygon's length is raised
 *           to it
 *   error   tol, and in the arithmetic 2^-27 of the polygon's length + 1 LSB in q16, 2^-40 of it in
 *           f32, f64
 *   cost    about sqrt(length / tol) times the turning angle in pieces, each 14 lerps and 4 square
 *           roots
 *   see     Gravesen: Adaptive subdivision and the length and energy of Bezier curves, 1997
 */
loft_acc loft_cubic_arclen(const loft_cubic *c, loft_real tol);

/* The parameter at the arc length `length`; 0 below the range of lengths, 1 above it. It never
 * decreases with `length`.
 *
 *   range   as loft_cubic_arclen, but with 2^-21 of the polygon
 *   error   the length from 0 to the result is off by at most the error of loft_cubic_arclen and,
 *           in q16 and f32, the length of one step of t = 2^-24
 *   cost    as loft_cubic_arclen, up to the result. For many lengths along one curve use a table,
 *           below
 */
loft_unit loft_cubic_inv_arclen(const loft_cubic *c, loft_acc length, loft_real tol);


// An arc-length table of one curve
// ---------------------------------

#define LOFT_ARCLEN_MARKS 16

/* The lengths at t = 0, 1/16 .. 1, from which other lengths follow quickly; do not rely on its
 * contents. */
typedef struct {
    loft_cubic curve;
    loft_acc   tol;
    loft_acc   mark[LOFT_ARCLEN_MARKS + 1];
} loft_arclen;

/* Make the table of `c`, which is copied.
 *
 *   range   tol <= 0: LOFT_ERR_ARG; a control point that is not a valid number: LOFT_ERR_RANGE;
 *           otherwise as loft_cubic_inv_arclen
 *   error   as loft_cubic_arclen, in each entry
 *   cost    as loft_cubic_arclen
 *   stack   Cortex-M4 532   Cortex-M0+ 580   ATmega328P 486
 */
enum loft_status loft_arclen_init(loft_arclen *r, const loft_cubic *c, loft_real tol) LOFT_CHECKED;

/* The arc length of the whole curve, and from 0 to t (clamped to 0..1).
 *
 *   range   as loft_cubic_inv_arclen
 *   error   as loft_cubic_inv_arclen
 *   cost    total: none; eval: that of loft_cubic_arclen for a sixteenth of the curve
 */
loft_acc loft_arclen_total(const loft_arclen *r);
loft_acc loft_arclen_eval(const loft_arclen *r, loft_unit t);

/* The parameter at an arc length: loft_cubic_inv_arclen in a sixteenth of the time.
 *
 *   error   as loft_cubic_inv_arclen
 *   cost    at most 16 comparisons, and loft_cubic_inv_arclen in a sixteenth of the curve
 *   stack   Cortex-M4 676   Cortex-M0+ 724   ATmega328P 619
 */
loft_unit loft_arclen_inverse(const loft_arclen *r, loft_acc length);

LOFT_END_C

#endif
