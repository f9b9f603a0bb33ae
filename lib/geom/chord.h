/* lib/geom/chord.h -- a line segment, and its point nearest to another point
 * SPDX-License-Identifier: MIT
 *
 * All numbers are wide and relative to the start of the chord, so that nothing is rounded to a
 * coordinate.
 */
#ifndef LOFT_GEOM_CHORD_H
#define LOFT_GEOM_CHORD_H

#include "num/num.h"    /* loft_acc, loft_unit */

LOFT_BEGIN_C

/* The chord from 0 to u, its length, and its direction to 24 bits (null for length 0). */
typedef struct {
    loft_acc  u[LOFT_AXES];
    loft_acc  length;
    loft_unit toward[LOFT_AXES];
} loft_chord;

/* Set length and direction from c->u.
 *
 *   range   q16: components below 2^29
 *   error   that of loft_acc_hypot and of a loft_unit
 */
void loft_chord_aim(loft_chord *c);

/* Find the point of the chord nearest to w. The result is its distance from the start of the chord,
 * 0..length; r is w minus that point.
 *
 *   range   as aim, for w too
 *   error   |r| is never too small for a point of the chord. It exceeds the smallest distance by at
 *           most
 *           q16: 2^-31 + 2^-43, f32: 2^-43, f64: 2^-50 of the larger of |w| and the length. The
 *           result: 2^-23 |r| (f64 2^-49), and in q16 2^-27 of the length + 2^-30
 *   cost    4 wide products per axis and one division; safe in an ISR
 */
loft_acc loft_chord_foot(const loft_chord *c, const loft_acc w[LOFT_AXES], loft_acc r[LOFT_AXES]);

LOFT_END_C

#endif
