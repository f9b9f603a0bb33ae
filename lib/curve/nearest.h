/* lib/curve/nearest.h -- the point of a Bezier curve that is nearest to a given point
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_NEAREST_H
#define LOFT_CURVE_NEAREST_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_unit t;            /* the parameter of the point                      */
    loft_vec  point;        /* on the curve, rounded to coordinates            */
    loft_acc  distance;     /* from the given point, before that rounding      */
} loft_nearest;

/* Find the point nearest to p over all of 0..1, the global minimum. If several points are equally
 * near (p is the centre of an arc), the result is any one of them.
 *
 *   range   tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if p is not a valid number. *out is
 *           untouched after an error
 *   error   distance: at most tol longer than the smallest, plus in q16 2^-25 of it + 2^-29;
 *           f32, f64: 2^-42 of the largest difference of coordinates, from p and along the curve
 *           point: 1/2 LSB (ulp) per axis and as distance;  t: rounded to a loft_unit
 *   cost    pieces: 16 on average, mostly below 60, each of degree * (degree + 1) * (degree + 5) /
 *           6 wide lerps per axis and 3 square roots; if the curve runs around p, up to length /
 *           sqrt(4 * distance * tol); not for an ISR
 *   stack   Cortex-M4 992   Cortex-M0+ 1,124   ATmega328P 1,034
 *   see     Ma & Hewitt, Point inversion and projection for NURBS curves, CAGD 20 (2003), for
 *           subdivision; the bound by a supporting plane is a separating-axis test (Ericson,
 *           Real-Time Collision Detection, ch. 5)
 */
enum loft_status loft_bezier_nearest(const loft_bezier *b, loft_vec p, loft_real tol,
                                     loft_nearest *out) LOFT_CHECKED;

LOFT_END_C

#endif
