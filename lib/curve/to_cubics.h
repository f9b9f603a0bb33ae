/* lib/curve/to_cubics.h -- a curve of any degree, rational or not, as a chain of cubics within a
 * tolerance
 * SPDX-License-Identifier: MIT
 *
 * Chords, lengths and plans need cubics (curve/measure.h, motion/plan.h). This converts any other
 * curve to cubics:
 *
 *     loft_to_cubics s;
 *     loft_cubic  c;
 *     if (loft_rational_to_cubics_init(&s, &curve, LOFT_REAL(0.001)) == LOFT_OK)
 *         while (loft_to_cubics_next(&s, &c))
 *             follow(&c);
 *
 * A cubic has the points and the derivatives of the curve at both its ends, so the chain has the
 * tangents of the curve at its joints. The parameter speeds on both sides of a joint are equal
 * except for a factor, a power of two. Cubics, quadratics and lines are returned unchanged.
 *
 * A point within a tolerance of a cubic is within the sum of both tolerances of the curve: use half
 * of the permitted tolerance here and the other half for flattening. The length of the chain
 * differs from that of the curve by at most about tol times the angle, in radians, through which
 * the curve turns (measured).
 */
#ifndef LOFT_CURVE_TO_CUBICS_H
#define LOFT_CURVE_TO_CUBICS_H

#include "basis/dyadic.h"   /* loft_dyad */
#include "curve/bezier.h"   /* loft_bezier, loft_cubic */
#include "curve/rational.h" /* loft_rational */

LOFT_BEGIN_C

/* State of one chain; do not rely on its contents. With three axes in q16 368 bytes, on AVR 355. */
typedef struct {
    const loft_vec      *p;         /* the control points, or */
    const loft_weighted *weighted;  /* those of a rational curve; the other is NULL */
    loft_vec             last;      /* where the next cubic starts */
    loft_real            tol;
    loft_real            reach;     /* twice the largest coordinate: the limit of arm ends */
    int32_t              scale;     /* a power of two: scales the largest weight to 2^13 .. 2^14 */
    loft_dyad           piece;     /* the next one to try */
    uint8_t              degree;
    bool                 more;
    /* its weighted points, then its weights */
    loft_acc             x[LOFT_AXES + 1][LOFT_DEGREE_MAX + 1];
} loft_to_cubics;

/* Prepare to cut a polynomial curve into cubics. The control points are borrowed.
 *
 *   range   tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates beyond the range of
 *           bezier.h, or if tol is below q16: 2 LSB   f32: 2^-22   f64: 2^-39 of the largest
 *           coordinate
 *   error   none of its own: for the cubics see below
 *   cost    nothing yet
 */
enum loft_status loft_to_cubics_init(loft_to_cubics *s, const loft_bezier *b,
                                     loft_real tol) LOFT_CHECKED;

/* Prepare to cut a rational curve into cubics. The control points are borrowed.
 *
 *   range   as loft_to_cubics_init, but tol at least q16: 4 LSB   f32: 2^-21   f64: 2^-39 of the
 *           largest coordinate
 *   error   none of its own: for the cubics see below
 *   cost    nothing yet
 */
enum loft_status loft_rational_to_cubics_init(loft_to_cubics *s, const loft_rational *r,
                                              loft_real tol) LOFT_CHECKED;

/* Get the next cubic, for the largest piece k / 2^m .. (k + 1) / 2^m that can be proved valid.
 * Returns false, and leaves *out untouched, after the last.
 *
 *   shape   the first starts at the first control point, the last ends at the last one, and each
 *           starts exactly at the end of the previous one
 *   error   at the same parameter, and so everywhere, the cubic is within tol of the curve,
 *           rounding included. The arms at its ends are those of the curve, a third of the
 *           derivative, to within
 *           q16: 1/2 LSB + R * 2^-18 LSB (R is the ratio of the largest weight to the smallest)
 *           f32: 1 ulp
 *           f64: 2000 ulp per axis, and below 2^-29 of the largest coordinate if they end at the
 *           edge of the range
 *   cost    errors fall with the fourth power of a cubic's length: 16 times the accuracy doubles
 *           their number. A cubic takes one or two trials, each degree * (degree + 1) / 2 averages
 *           per axis and level, up to 4 * (degree + 1) products, 3 quotients, 2 long divisions and
 *           4 small ones per axis, and degree + 4 square roots; weights count as one more axis in
 *           the averages; not for an interrupt
 *   stack   Cortex-M4 336   Cortex-M0+ 444   ATmega328P 427
 *   see     Farin, Curves and Surfaces for CAGD, ch. 5 and 6: products, degree elevation, Hermite
 *           form
 */
bool loft_to_cubics_next(loft_to_cubics *s, loft_cubic *out);

/* The parameter of the curve where the next cubic starts, and the last one ended; 1 after the last.
 *
 *   error   q16, f32: 2^-25, of pieces below 2^-24   f64: none
 *   cost    a quotient
 */
loft_unit loft_to_cubics_at(const loft_to_cubics *s);

LOFT_END_C

#endif
