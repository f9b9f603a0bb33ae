/* lib/curve/to_cubics.h -- a curve of any degree, rational or not, as a chain of cubics within a
 * tolerance
 * SPDX-License-Identifier: MIT
 *
 * Chords, lengths and plans are made of cubics (curve/measure.h, motion/plan.h); this makes cubics
 * of everything else:
 *
 *     loft_to_cubics s;
 *     loft_cubic  c;
 *     if (loft_rational_to_cubics_init(&s, &curve, LOFT_REAL(0.001)) == LOFT_OK)
 *         while (loft_to_cubics_next(&s, &c))
 *             follow(&c);
 *
 * A cubic has the points and the derivatives of the curve at both its ends, so the chain has the
 * curve's tangents where it is joined; the parameter runs equally fast on both sides of a joint but
 * for a factor, a power of two. Cubics, quadratics and lines are given as they are.
 *
 * What is within tol of a cubic is within the sum of both tolerances of the curve: flatten with
 * half of what is allowed, and with the other half here. The length of the chain differs from the
 * curve's by no more than about tol times the angle, in radians, through which the curve turns
 * (measured).
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
    loft_real            reach;     /* twice the largest coordinate: arms end within that */
    int32_t              scale;     /* a power of two: the largest weight times it is in 2^13 ..
                                     * 2^14 */
    loft_dyad           piece;     /* the next one to try */
    uint8_t              degree;
    bool                 more;
    /* its weighted points and its weights, last */
    loft_acc             x[LOFT_AXES + 1][LOFT_DEGREE_MAX + 1];
} loft_to_cubics;

/* Prepare to cut a polynomial curve into cubics. The control points are borrowed.
 *
 *   range   tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates beyond what bezier.h
 *           says or when tol is below q16: 2 LSB   f32: 2^-22   f64: 2^-39 of the largest
 *           coordinate
 *   error   none of its own: that of the cubics is said below
 *   cost    nothing yet
 */
enum loft_status loft_to_cubics_init(loft_to_cubics *s, const loft_bezier *b,
                                     loft_real tol) LOFT_CHECKED;

/* Prepare to cut a rational curve into cubics. The control points are borrowed.
 *
 *   range   as loft_to_cubics_init, but tol at least q16: 4 LSB   f32: 2^-21   f64: 2^-39 of the
 *           largest coordinate
 *   error   none of its own: that of the cubics is said below
 *   cost    nothing yet
 */
enum loft_status loft_rational_to_cubics_init(loft_to_cubics *s, const loft_rational *r,
                                           loft_real tol) LOFT_CHECKED;

/* Give the next cubic, the largest piece k / 2^m .. (k + 1) / 2^m that can be proved. False, and
 * *out untouched, after the last.
 *
 *   shape   the first starts in the first control point, the last ends in the last one, each starts
 *           exactly where the one before it ended
 *   error   at the same parameter, and so everywhere, the cubic is within tol of the curve,
 *           rounding included. The arms at its ends are those of the curve, a third of the
 *           derivative, within q16: 1/2 LSB + R * 2^-18 LSB (R the largest weight over the
 *           smallest)   f32: 1 ulp   f64: 2000 ulp per axis, and below 2^-29 of the largest
 *           coordinate where they end at the edge of the range
 *   cost    errors fall with the fourth power of a cubic's length: 16 times the accuracy doubles
 *           their number. A cubic takes one or two trials, each degree * (degree + 1) / 2 means per
 *           axis and level, up to 4 * (degree + 1) products, 3 quotients, 2 long divisions and 4
 *           small ones per axis, and degree + 4 square roots; weights count as an axis more in the
 *           means. q16: 450 bytes of stack; not for an interrupt
 *   see     Farin, Curves and Surfaces for CAGD, ch. 5 and 6: products, degree elevation, Hermite
 *           form
 */
bool loft_to_cubics_next(loft_to_cubics *s, loft_cubic *out);

LOFT_END_C

#endif
