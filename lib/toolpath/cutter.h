/* lib/toolpath/cutter.h -- the tool of a mill: ball, bull-nose or flat, about an upright axis
 * SPDX-License-Identifier: MIT
 *
 * The place of a cutter is its tip, the lowest point of its axis. Below its sides it is a disk of
 * radius - corner, rounded by `corner`: a ball if both are equal, flat if the corner is 0.
 *
 *     loft_cutter ball;
 *     if (loft_cutter_init(&ball, LOFT_REAL(3), LOFT_REAL(3)) == LOFT_OK) ..
 */
#ifndef LOFT_TOOLPATH_CUTTER_H
#define LOFT_TOOLPATH_CUTTER_H

#include "num/num.h"    /* loft_real, loft_acc */

LOFT_BEGIN_C

#define LOFT_CUTTER_MAX     128     /* the largest radius */
#define LOFT_CUTTER_SLOPE   64      /* the steepest slope of loft_cutter_lift */

/* Do not fill it yourself: call init. */
typedef struct {
    loft_real radius, corner;
} loft_cutter;

/* Make a cutter.
 *
 *   range   radius 1/64..LOFT_CUTTER_MAX, corner 0..radius, otherwise LOFT_ERR_ARG; *c is then
 *           untouched
 *   error   none
 *   cost    three comparisons
 */
enum loft_status loft_cutter_init(loft_cutter *c, loft_real radius, loft_real corner) LOFT_CHECKED;

/* How high above its tip the cutter's underside is, at a distance from the axis.
 *
 *   range   distance 0..radius; a larger one counts as the radius
 *   error   q16: 1/2 LSB and 1/2 LSB times the slope there   f32, f64: 2 ulp, likewise
 *   cost    one square root
 */
loft_acc loft_cutter_rise(const loft_cutter *c, loft_real distance);

/* How high its tip is above a plane on which the cutter rests, measured along the axis: with slope
 * g it is (radius - corner) g + corner (sqrt(1 + g^2) - 1).
 *
 *   shape   slope: along x and along y
 *   range   |slope| up to LOFT_CUTTER_SLOPE each
 *   error   q16: 1/2 LSB times radius - corner, and 2^-27 of the lift   f32: 2^-22 of it
 *           f64: 2^-49
 *   cost    a ball: two products and a square root; others: twice that
 */
loft_acc loft_cutter_lift(const loft_cutter *c, const loft_real slope[2]);

LOFT_END_C

#endif
