/* lib/curve/intersect.h -- where two Bezier curves meet
 * SPDX-License-Identifier: MIT
 *
 *     loft_crossing c[9];
 *     size_t        count;
 *     if (loft_bezier_intersect(&p, &q, LOFT_REAL(0.001), c, 9, &count) == LOFT_OK)
 *         for (size_t k = 0; k < count; k++)
 *             use(c[k].s, c[k].t, c[k].point);
 *
 * Coordinates are rounded, so whether two curves touch can only be decided within a tolerance. A
 * crossing is a connected stretch on which they are that close. It is short if they cross at an
 * angle, and longer if they touch.
 */
#ifndef LOFT_CURVE_INTERSECT_H
#define LOFT_CURVE_INTERSECT_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_unit s, t;                             /* parameters of the closest points, on the first
                                                 * and on the second curve */
    loft_vec  point;                            /* half way between the two points there */
    loft_acc  distance;                         /* between the two points, exact to tol / 4 */
    loft_unit s_from, s_to, t_from, t_to;       /* the stretch */
    bool      along;                            /* the second runs in the direction of the first or
                                                 * at a right angle */
    bool      overlap;                          /* they stay together until one of them ends, on
                                                 * either side */
} loft_crossing;

/* Find all crossings of a and b, sorted by s.
 *
 *   shape   out[room], of which *count are filled
 *   range   tol > 0 and at least two axes (with one axis curves overlap instead: compare their
 *           boxes), otherwise LOFT_ERR_ARG; q16: tol >= 2 LSB, f32: 2^-22, f64: 2^-38 of the
 *           largest coordinate, otherwise LOFT_ERR_RANGE. LOFT_MORE: there are more than `room`
 *           crossings (the product of the degrees suffices unless the curves overlap).
 *           LOFT_SINGULAR: at least one is an overlap, longer than 4 tol. In both cases out[] holds
 *           the crossings found
 *   error   each place where the curves meet lies in the stretch of a crossing, except for the
 *           rounding of parameters (2^-25 in q16 and f32). The points of a crossing at s and t,
 *           before that rounding, are within tol of each other, and all points of a stretch are
 *           within tol of the other curve. Two crossings between which the curves stay that close
 *           are merged. At an angle of theta a stretch is about tol / sin theta long
 *   cost    about 5 loft_piece_clip and 7 feet of chords for two cubics that cross once; about 4
 *           times loft_bezier_nearest and 150 clips more if both are pieces of one curve, for any
 *           length of overlap. If they touch, or overlap otherwise, about 100 * length /
 *           sqrt(radius * tol) clips, at worst length / tol for straight curves of different
 *           degree; not for an ISR
 *   stack   Cortex-M4 4,328   Cortex-M0+ 4,572   ATmega328P 4,403
 *   see     curve/clip.h; Sederberg & Nishita, Curve intersection using Bezier clipping, CAD 22
 *           (1990); the separating plane: Ericson, Real-Time Collision Detection, ch. 5
 */
enum loft_status loft_bezier_intersect(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                                       loft_crossing out[], size_t room,
                                       size_t *count) LOFT_CHECKED;

LOFT_END_C

#endif
