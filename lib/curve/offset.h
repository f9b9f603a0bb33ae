/* lib/curve/offset.h -- the offset of a planar cubic at a distance, within a tolerance: for the
 * radius of a tool
 * SPDX-License-Identifier: MIT
 *
 *     loft_offset      o;
 *     loft_offset_span s;
 *     if (loft_offset_init(&o, &curve, LOFT_REAL(3), LOFT_REAL(0.01)) == LOFT_OK)
 *         while (loft_offset_next(&o, &s))
 *             if (!s.behind)
 *                 cut_along(&s.curve);
 *
 * The offset of P(t) is O(t) = P(t) + distance * N(t), where N is the unit normal to the left of
 * the direction of travel; a negative distance is on the right. Plane and normal are those of the
 * first two axes; the others (the height of a tool) are copied from the curve.
 *
 * Where the curve bends towards that side with a radius below the distance, O runs backwards,
 * between two cusps. A tool there would cut into the curve. O is cut at its cusps, and the spans
 * between them are marked `behind`. For milling, leave them out and join the others where they
 * cross (curve/intersect.h).
 *
 * Where the curve itself has a cusp, its normal jumps, and the next span is marked `apart`.
 */
#ifndef LOFT_CURVE_OFFSET_H
#define LOFT_CURVE_OFFSET_H

#include "curve/bezier.h"   /* loft_cubic */
#include "num/acc2.h"       /* loft_acc2 */

LOFT_BEGIN_C

/* State of one offset; do not rely on its contents. */
typedef struct {
    loft_cubic curve;
    loft_real  distance;
    loft_acc   limit, quarter_tol;      /* the tolerance over the distance; tol / 4 */
    loft_acc2  h[2][3];         /* the direction of travel: a polynomial without zeros at 0 and 1 */
    uint8_t    degree;          /* of h */
    int8_t     direction;       /* 1: the offset runs forwards, -1: backwards, 0: not known yet */
    uint32_t   at;              /* the parameter of the last end, in steps of 2^-24 */
} loft_offset;

typedef struct {
    loft_cubic curve;
    loft_unit  from, to;        /* the piece of the given curve                             */
    bool       behind;          /* the radius of the curve is smaller: O runs backwards     */
    bool       apart;           /* does not start at the end of the previous span           */
} loft_offset_span;

/* Prepare the offset of `c`, which is copied.
 *
 *   range   tol > 0 and at least two axes, otherwise LOFT_ERR_ARG; tol >= 4 LSB (f32, f64: 4 ulp of
 *           the largest coordinate of the offset) + 2^-17 of the distance, and coordinates that
 *           stay within their range if twice the distance is added, otherwise LOFT_ERR_RANGE;
 *           LOFT_SINGULAR if all four points are one in the plane: there is no direction
 *   error   none of its own: for the spans see below
 *   cost    nothing yet
 */
enum loft_status loft_offset_init(loft_offset *o, const loft_cubic *c, loft_real distance,
                                  loft_real tol) LOFT_CHECKED;

/* Get the next span, the longest one with a dyadic end that can be proved valid. Returns false, and
 * leaves *out untouched, after the last span.
 *
 *   shape   the spans follow each other, from = 0 to to = 1. Each starts exactly at the end of the
 *           previous one unless it is `apart`. Then a stretch is left out, a cusp or nearly one, on
 *           which the curve turns too fast to be resolved. All such stretches together are at most
 *           2^-18 of the parameter. At 0 or 1 such a stretch is a span of its own, with the normal
 *           of the adjacent span
 *   error   at the same parameter, and so everywhere, the span is within tol of O, rounding
 *           included, except for spans of such a stretch. Ends have the direction of O. Cusps are
 *           found to 2^-24 of the parameter. O is not cut where it runs backwards by less than 3/4
 *           tol per quarter of the span, nor where it runs backwards for less than a quarter; the
 *           span is still within tol
 *   cost    1 to 25 trials, each of 16 lerps per axis, 18 of num/acc2.h, 60 products and 5 square
 *           roots; a cusp 24 more, and 25 for each step of 2^-24 that is left out. 8 spans for a
 *           quarter of a circle at tol = distance / 10^4, twice as many for a sixteenth of that
 *   stack   Cortex-M4 1,256   Cortex-M0+ 1,292   ATmega328P 1,173
 *   see     Tiller & Hanson, Offsets of two-dimensional profiles, IEEE CG&A 4 (1984); Klass, An
 *           offset spline approximation for plane cubic splines, CAD 15 (1983): the ends are
 *           matched with their derivatives, as here
 */
bool loft_offset_next(loft_offset *o, loft_offset_span *out);

LOFT_END_C

#endif
