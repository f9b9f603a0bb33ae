/* lib/curve/intersect.h -- where two Bezier curves meet
 * SPDX-License-Identifier: MIT
 *
 *     loft_crossing c[9];
 *     size_t        count;
 *     if (loft_bezier_intersect(&p, &q, LOFT_REAL(0.001), c, 9, &count) == LOFT_OK)
 *         for (size_t k = 0; k < count; k++)
 *             use(c[k].s, c[k].t, c[k].point);
 *
 * Coordinates are rounded, so whether two curves touch can only be said within a tolerance. A
 * crossing is a connected stretch along which they are that close; it is short where they cross at
 * an angle, longer where they touch.
 */
#ifndef LOFT_CURVE_INTERSECT_H
#define LOFT_CURVE_INTERSECT_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_unit s, t;                             /* where the two are closest, on the first and on
                                                 * the second */
    loft_vec  point;                            /* half way between the two points there */
    loft_acc  distance;                         /* of the two points, within tol / 4 */
    loft_unit s_from, s_to, t_from, t_to;       /* the stretch */
    bool      along;                            /* the second runs in the direction of the first, or
                                                 * across */
    bool      overlap;                          /* they do not part before one of them ends, on
                                                 * either side */
} loft_crossing;

/* Find all crossings of a and b, sorted by s.
 *
 *   shape   out[room], *count of them are filled
 *   range   tol > 0 and at least two axes (on a line curves do not cross, they overlap: compare
 *           their boxes), otherwise LOFT_ERR_ARG; q16: tol >= 2 LSB, f32: 2^-22, f64: 2^-38 of the
 *           largest coordinate, otherwise LOFT_ERR_RANGE LOFT_MORE: there are more than `room` (a
 *           room of the product of the degrees suffices unless they overlap); LOFT_SINGULAR: at
 *           least one is an overlap, longer than 4 tol. In both cases out[] holds what was found
 *   error   each place where the curves meet lies in the stretch of a crossing, exactly so but for
 *           the rounding of parameters (2^-25 in q16 and f32). Of each crossing the points at s and
 *           t, before that rounding, are within tol of each other, and so are all of a stretch from
 *           the other curve. Two crossings between which the curves stay that close are one. At an
 *           angle of theta a stretch is about tol / sin theta long
 *   cost    about 70 pieces for two cubics that cross once, each degree * (degree + 1) * (degree +
 *           5) / 6 wide lerps per axis and 5 roots; about 150 more where both are parts of one
 *           curve, however long they overlap; where they touch, or overlap otherwise, about 100 *
 *           length / sqrt(radius * tol), at worst length / tol for straight curves of different
 *           degree. 2.2 KB of stack for three axes in q16; not for an ISR
 *   see     Sederberg, White & Zundel, Fat arcs, CAGD 6 (1989), and Lane & Riesenfeld (1980) for
 *           hull and split; the separating plane: Ericson, Real-Time Collision Detection, ch. 5
 */
enum loft_status loft_bezier_intersect(const loft_bezier *a, const loft_bezier *b, loft_real tol,
                                       loft_crossing out[], size_t room,
                                       size_t *count) LOFT_CHECKED;

LOFT_END_C

#endif
