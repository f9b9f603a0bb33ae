/* lib/motion/kinematics.h -- kinematics: from where the tool is to where the motors are, and back
 * SPDX-License-Identifier: MIT
 *
 * Kinematics that are a matrix turn a span into a span: apply them to its four points, and the motors move as planned. Others turn
 * points only; a path is then sampled at every tick (items of kind LOFT_POINTS), and a motor is between two ticks where a straight
 * line leads: off by at most its acceleration times tick^2 / 8. Limits of a plan are those of the tool's axes. Of motors of a
 * CoreXY it holds that |a|, |b| <= |x| + |y|, so half of what a motor can do is safe for each axis.
 *
 * Where kinematics are wanted, they are one callback: */
#ifndef LOFT_MOTION_KINEMATICS_H
#define LOFT_MOTION_KINEMATICS_H

#include "geom/vec.h"   /* loft_vec */

#if LOFT_AXES >= 2

/* Give where the motors are when the tool is at `tool`; `geometry` is what belongs to the function. */
typedef loft_vec loft_motors_of(const void *geometry, loft_vec tool);

/* CoreXY and H-bot: the motors a and b pull x + y and x - y; other axes are as they are. `geometry` is not looked at.
 *
 *   range   |x| + |y| within the range of a coordinate
 *   error   q16: none   f32, f64: 1/2 ulp
 *   cost    one addition, one subtraction */
loft_vec loft_corexy_motors(const void *geometry, loft_vec tool);

/* The way back.
 *
 *   error   q16: none for what loft_corexy_motors gave; else 1/2 LSB   f32, f64: 1/2 ulp */
loft_vec loft_corexy_tool(loft_vec motors);

#if LOFT_AXES >= 3

/* Linear delta: three towers, carriages that run up and down, arms of one length. */
typedef struct {
    loft_real tower[3][2];      /* mm: where each tower stands; the place of its carriage less that of the tool's joint */
    loft_real arm;              /* mm, above 0 and up to 16383 */
} loft_delta;

/* The heights of the carriages. `geometry` is a loft_delta.
 *
 *   range   |coordinates| <= 16383; where an arm does not reach, it counts as lying flat
 *   error   q16: that of the square root, 1/2 LSB   f32, f64: 2 ulp of the greatest of tower, tool and arm, where the arm stands steeply
 *   cost    per tower three products, a 64-bit square root
 *   see     Johann Rocholl's Rostock printer; RepRap wiki, Delta geometry */
loft_vec loft_delta_motors(const void *geometry, loft_vec tool);

#endif
#endif
#endif
