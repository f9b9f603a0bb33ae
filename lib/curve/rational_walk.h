/* lib/curve/rational_walk.h -- walk a rational curve at equal parameter steps, exactly, for any
 * number of steps
 * SPDX-License-Identifier: MIT
 *
 * Numerator and denominator are walked by forward differences. Both are multiplied by n^degree,
 * which cancels in the quotient. Each point costs `degree` additions and one quotient per axis, and
 * no multiplication. In q16 the differences are whole numbers for any n, so there is no drift; in
 * f32 and f64 the roundings of n additions add up to what loft_rational_walk_next states.
 *
 *     loft_rational_walk w;
 *     loft_vec           p;
 *     if (loft_rational_walk_init(&w, &curve, 1000) == LOFT_OK)
 *         while (loft_rational_walk_next(&w, &p))
 *             move_to(p);                      // 1000 points, the last is the last control point
 *
 * The law of ranges: n^degree < 2^63 in every number type, for any control points and weights:
 *
 *     degree             1               2           3        4       5
 *     n at most   2^32 - 1   3,037,000,499   2,097,151   55,108   6,208
 */
#ifndef LOFT_CURVE_RATIONAL_WALK_H
#define LOFT_CURVE_RATIONAL_WALK_H

#include "curve/rational.h"     /* loft_rational */
#include "num/acc128.h"         /* loft_acc128: the differences */

LOFT_BEGIN_C

#define LOFT_RATIONAL_WALK_DEGREE_MAX 5

/* State of one walk, in q16 96 bytes per axis and for the weights. Do not rely on its fields. */
typedef struct {
    loft_acc128 x[LOFT_AXES][LOFT_RATIONAL_WALK_DEGREE_MAX + 1];
    loft_acc128 w[LOFT_RATIONAL_WALK_DEGREE_MAX + 1];
    loft_vec  end;
    uint32_t  left;             /* points to come */
    uint8_t   degree;
} loft_rational_walk;

/* Prepare to walk `r` in n equal parameter steps.
 *
 *   shape   will yield n points, at t = 1/n, 2/n .. 1; the start is not repeated; `r` is not kept
 *   range   degree 0..5, n >= 1, otherwise LOFT_ERR_ARG; n within the law of ranges and, in f64,
 *           coordinates below 2^900, otherwise LOFT_ERR_RANGE. *walk is untouched after an error
 *   error   none in q16   f32, f64: included in that of the points
 *   cost    degree * (degree + 2) products of a loft_acc128 by an integer per axis and for the
 *           weights
 *   see     Foley, van Dam, Feiner, Hughes: Computer Graphics, ch. 11
 */
enum loft_status loft_rational_walk_init(loft_rational_walk *walk, const loft_rational *r,
                                         uint32_t n) LOFT_CHECKED;

/* Get the next point. Returns false, and leaves *out untouched, at the end of the walk.
 *
 *   error   q16: 1/2 LSB   f32, f64: 2 R (K n + 8 * 3^degree) / 2^53 of the largest control value,
 *           K = 1 3 8 21 56 for degree 1..5, R as in rational.h, and 1/2 ulp of the result. The
 *           last point is exact.
 *   cost    `degree` additions and one quotient (32 subtractions of 128 bits in q16) per axis,
 *           `degree` additions for the weights; no branch on data in the additions; safe in an ISR
 */
bool loft_rational_walk_next(loft_rational_walk *walk, loft_vec *out);

LOFT_END_C

#endif
