/* lib/curve/crossings.h -- where two plane Bezier curves meet, decided exactly
 * SPDX-License-Identifier: MIT
 *
 *     loft_meeting m[LOFT_MEETINGS_MAX];
 *     unsigned     count;
 *     if (loft_bezier_crossings(&p, &q, m, &count) == LOFT_OK)
 *         for (unsigned k = 0; k < count; k++)
 *             use(m[k].s, m[k].t, m[k].multiplicity);
 *
 * Curves that touch, and curves that miss each other by the last bit, are told apart. intersect.h
 * takes higher degrees and space, and answers within a tolerance.
 */
#ifndef LOFT_CURVE_CROSSINGS_H
#define LOFT_CURVE_CROSSINGS_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

#define LOFT_MEETINGS_DEGREE 4
#define LOFT_MEETINGS_MAX    16

typedef struct {
    loft_unit s, t;             /* parameters on the first and on the second curve */
    uint8_t   multiplicity;     /* 1: they cross, 2: they touch, 3: both, ..; 0: not finite, pieces
                                 * of one curve meet at their ends */
} loft_meeting;

/* All parameters s, t in 0..1 where the first two coordinates of a and b are the same, sorted by s
 * and then by t: out[LOFT_MEETINGS_MAX]. LOFT_SINGULAR: they share a piece, or one curve is a point
 * of the other; *count is then 0.
 *
 *   range   at least two axes, degrees 1..4, otherwise LOFT_ERR_ARG; f32, f64: coordinates that
 *           pass loft_exact_valid, otherwise LOFT_ERR_RANGE. That is also the answer for two
 *           meetings at parameters closer than 2^-52
 *   error   number and multiplicities: none, except that of pieces of one curve a stretch shorter
 *           than q16: 8 LSB   f32: 2^-20   f64: 2^-36 of the largest coordinate counts as a point,
 *           and that points of both curves at meetings with others count as one if they are within
 *           2^-44 of the largest coordinate and of the length of the polygons
 *           s, t: q16: 2^-25 + 2^-32   f32: 2^-25   f64: 2^-51; for pieces of one curve, unless
 *           ends are equal, those of loft_bezier_intersect
 *   cost    twice loft_whole_roots of the product of the degrees; about 10^7 products of 32 bits
 *           for two cubics (floats: 4 * 10^7); not for small chips
 *   stack   Cortex-M4 12,280   Cortex-M0+ 12,308   ATmega328P 11,771
 *   see     Sederberg, Improperly parametrized rational curves (1986), and Chang, Mathematics of
 *           Surfaces, 3.1; Bezout's resultant
 */
enum loft_status loft_bezier_crossings(const loft_bezier *a, const loft_bezier *b,
                                       loft_meeting out[], unsigned *count) LOFT_CHECKED;

LOFT_END_C

#endif
