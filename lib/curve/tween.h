/* lib/curve/tween.h -- easing as in CSS: the share of a way at a share of its time
 * SPDX-License-Identifier: MIT
 *
 * A cubic from (0, 0) to (1, 1) by way of (x1, y1) and (x2, y2), as cubic-bezier() in CSS:
 *
 *     loft_tween e;                                              // ease-in-out
 *     if (loft_tween_init(&e, LOFT_UNIT(0.42), 0, LOFT_UNIT(0.58), LOFT_UNIT(1)) == LOFT_OK)
 *         angle = loft_lerp(from, to, loft_tween_eval(&e, loft_unit_of(frame, frames)));
 *
 * `ease` is 0.25, 0.1, 0.25, 1.
 */
#ifndef LOFT_CURVE_TWEEN_H
#define LOFT_CURVE_TWEEN_H

#include "num/num.h"        /* loft_unit */

LOFT_BEGIN_C

/* Both coordinates as polynomials. Do not fill it yourself: call init. */
typedef struct {
    loft_acc x[3], y[3];        /* of s, s^2, s^3 */
} loft_tween;

/* Prepare a curve.
 *
 *   range   x1, x2 in 0..1 (so that it is a function), otherwise LOFT_ERR_ARG; y1, y2 in -8..8,
 *           otherwise LOFT_ERR_RANGE
 *   error   q16: none   f32, f64: 4 ulp of double of the coefficients
 *   cost    additions
 */
enum loft_status loft_tween_init(loft_tween *e, loft_unit x1, loft_unit y1, loft_unit x2,
                                 loft_unit y2) LOFT_CHECKED;

/* The share of the way at the share t of the time; 0 before 0, 1 behind 1, each exactly.
 *
 *   error   the point (t, result) is within q16: 2^-19   f32: 2^-19   f64: 2^-44 of the curve in
 *           each coordinate
 *   cost    3 products for each bit of a parameter: q16 24 times, f32 and f64 at most 60 times
 *   stack   Cortex-M4 52   Cortex-M0+ 124   ATmega328P 60
 *   see     W3C: CSS Easing Functions Level 1, 2.2
 */
loft_unit loft_tween_eval(const loft_tween *e, loft_unit t);

LOFT_END_C

#endif
