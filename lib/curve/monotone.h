/* lib/curve/monotone.h -- a function through given points that does not overshoot: y at x
 * SPDX-License-Identifier: MIT
 *
 * Between each two points a cubic; the slopes are such that the function rises where the points
 * rise, falls where they fall, and turns at points alone. For curves of joysticks, tables of
 * sensors, brightness and gradients, where a spline would leave the range of its points.
 *
 *     static const loft_real x[] = { LOFT_REAL(0), LOFT_REAL(0.5), LOFT_REAL(1) };
 *     static const loft_real y[] = { LOFT_REAL(0), LOFT_REAL(10), LOFT_REAL(100) };
 *     static loft_acc slope[3];
 *     loft_monotone f;
 *     if (loft_monotone_init(&f, x, y, 3, slope) == LOFT_OK)
 *         level = loft_monotone_eval(&f, LOFT_REAL(0.75));
 *
 * The first derivative does not jump, the second one may: curve/natural.h is smoother, and leaves
 * the range. `h` below is the distance of the two neighbouring x.
 */
#ifndef LOFT_CURVE_MONOTONE_H
#define LOFT_CURVE_MONOTONE_H

#include "num/num.h"        /* loft_real, loft_acc */

LOFT_BEGIN_C

/* A function. Do not fill it yourself: call init. */
typedef struct {
    const loft_real *x, *y;
    const loft_acc *slope;
    uint32_t count;
} loft_monotone;

/* Make the function through (x[i], y[i]), i = 0 .. count - 1. The points and the memory
 * slope[count] must outlive it.
 *
 *   range   count >= 2 and x[i] < x[i + 1], otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for numbers that
 *           are none (f32, f64), and where the points rise or fall by more than 2^22 per unit
 *   error   of the slopes, q16: 2^-30   f32, f64: 32 ulp of double of the larger secant
 *   cost    O(count): per point 3 long divisions (num/muldiv.h), and a length where points bend
 *           much
 *   stack   Cortex-M4 160   Cortex-M0+ 324   ATmega328P 239
 *   see     Fritsch, Carlson: Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17, 1980
 */
enum loft_status loft_monotone_init(loft_monotone *f, const loft_real x[], const loft_real y[],
                                    uint32_t count, loft_acc slope[]) LOFT_CHECKED;

/* y at x; before the first point and behind the last one their y.
 *
 *   shape   y[i] at x[i]; between two points between their y, but for the error
 *   error   q16: 1/2 LSB + h 2^-15 LSB   f32: 1/2 ulp   f64: 64 ulp of the largest |y|
 *   cost    log2(count) comparisons, 2 long divisions, 6 lerps of 2 divisions
 *   stack   Cortex-M4 232   Cortex-M0+ 292   ATmega328P 246
 */
loft_real loft_monotone_eval(const loft_monotone *f, loft_real x);

/* The slope at x; beyond the points 0, at them that of the function between them.
 *
 *   error   q16: 2^-28   f32, f64: 128 ulp of double of the larger secant
 *   cost    log2(count) comparisons, a long division, 3 lerps of 2 divisions
 */
loft_acc loft_monotone_deriv(const loft_monotone *f, loft_real x);

LOFT_END_C

#endif
