/* lib/geom/chord_pair.h -- where two line segments are near each other
 * SPDX-License-Identifier: MIT
 *
 *     const loft_chord_pair pair = { &a, &b, { from a[0] to b[0], negative .. } };
 *     loft_foot end[2];
 *     loft_chord_ends(&pair, end);
 *     const loft_foot f = loft_chord_closest(&pair, end, fine);
 *     if (f.gap <= near)
 *         last = loft_chord_near_end(&pair, f, end[1], near, most);
 *
 * The distance of the point at sigma of one chord from the other chord is convex in sigma, and its
 * slope times the distance is piecewise linear.
 */
#ifndef LOFT_GEOM_CHORD_PAIR_H
#define LOFT_GEOM_CHORD_PAIR_H

#include "geom/chord.h" /* loft_chord */

LOFT_BEGIN_C

/* The start of a is at `apart` from that of b. */
typedef struct {
    const loft_chord *a, *b;
    loft_acc apart[LOFT_AXES];
} loft_chord_pair;

/* The point at `at` of a, that of b nearest to it at `other`, and the vector between them: its
 * length, and its component along a. That is the slope of the length, times the length. */
typedef struct {
    loft_unit at, other;
    loft_acc  gap, slope;
} loft_foot;

/* The foot of one point of a.
 *
 *   range   chords are aimed; q16: components of chords and of `apart` below 2^28
 *   error   that of loft_chord_foot and loft_acc_hypot for the gap, and of a loft_unit
 *   cost    loft_chord_foot, a root and a division
 */
loft_foot loft_chord_foot_at(const loft_chord_pair *c, loft_unit at);

/* The feet of both ends of a. */
static inline void loft_chord_ends(const loft_chord_pair *c, loft_foot end[2])
{
    end[0] = loft_chord_foot_at(c, 0);
    end[1] = loft_chord_foot_at(c, LOFT_UNIT(1));
}

/* Find the point of a that is nearest to b, or one within `fine` of b. `end` is by
 * loft_chord_ends.
 *
 *   error   the gap exceeds the smallest one by at most sqrt(d L), where d is 4 times the error of
 *           loft_chord_foot and L the length of a, and by the step of a parameter, 2^-24 L
 *   cost    one or two feet as a rule, at most 96
 *   see     false position with bisection: Dahlquist & Bjorck, Numerical Methods, ch. 6
 */
loft_foot loft_chord_closest(const loft_chord_pair *c, const loft_foot end[2], loft_acc fine);

/* Find how far a stays within `near` of b, from `in`, which is that near, toward `out`: a parameter
 * behind that, up to which the gap is at most `most`, or that of `out`.
 *
 *   range   0 < near < most, and in.gap <= near
 *   error   2^-24 of the parameter, if the gap passes both within that
 *   cost    none or one foot as a rule, at most 96
 */
loft_unit loft_chord_near_end(const loft_chord_pair *c, loft_foot in, loft_foot out, loft_acc near,
                              loft_acc most);

LOFT_END_C

#endif
