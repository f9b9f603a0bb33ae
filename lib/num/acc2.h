/* lib/num/acc2.h -- numbers with twice the bits of loft_acc, for sums with cancellation
 * SPDX-License-Identifier: MIT
 *
 * The direction of a curve is that of a sum of differences of its control points. Where the curve
 * nearly stops, these differences cancel and few bits of a loft_acc remain. Vectors of loft_acc2
 * keep the direction there:
 *
 *     loft_acc2 v[2];
 *     loft_acc  way[2];
 *     for (int i = 0; i < 2; i++)
 *         v[i] = loft_acc2_lerp(loft_acc2_sub(b.axis[i], a.axis[i]),
 *                               loft_acc2_sub(d.axis[i], c.axis[i]), t);
 *     if (loft_acc2_scaled(v, 2, way))
 *         use(way);                       // the direction; false where v is 0
 *
 *   loft_acc2   q16: an integer of 128 bits   f32, f64: the sum of two doubles
 *
 * All loft_acc2 share one unit, which is private: only quotients of two of them have a meaning.
 */
#ifndef LOFT_NUM_ACC2_H
#define LOFT_NUM_ACC2_H

#include "num/acc128.h"     /* loft_acc128 */
#include "num/num.h"        /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C

#if LOFT_NUM == LOFT_Q16

typedef loft_acc128 loft_acc2;

#else

typedef struct {
    double high, low;
} loft_acc2;

#endif

/* a - b, and twice x.
 *
 *   range   twice: a difference or a lerp of differences, and only once
 *   error   none; f64: a result below 2^-850 is lost entirely
 *   cost    q16: a pass over 4 limbs   floats: 7 operations
 */
loft_acc2 loft_acc2_sub(loft_real a, loft_real b);
loft_acc2 loft_acc2_twice(loft_acc2 x);

/* x at t = 0, y at t = 1.
 *
 *   range   t in 0..1, a multiple of 2^-24
 *   error   q16: 2^-89 LSB   f32, f64: 2^-101 of the larger of |x|, |y|; none at 0 and 1
 *   cost    q16: 5 products of 32 bits   floats: 60 operations
 */
loft_acc2 loft_acc2_lerp(loft_acc2 x, loft_acc2 y, loft_unit t);

/* Scale all of x[0..n-1] by one power of two, so that the largest magnitude is 2^27 .. 2^28.
 * Returns false, and leaves out[] untouched, if all are 0.
 *
 *   error   q16: 2^-32, toward 0   f32, f64: 1/2 ulp of double of each
 *   cost    q16: two passes over 4 limbs a number   floats: 10 products a number
 */
bool loft_acc2_scaled(const loft_acc2 x[], int n, loft_acc out[]) LOFT_CHECKED;

LOFT_END_C

#endif
