/* lib/kinematics/kinematics.h -- inverse and forward kinematics: tool position to motor positions,
 * and back
 * SPDX-License-Identifier: MIT
 *
 * Linear kinematics (a matrix) map a curve to a curve and a span to a span: apply them to the
 * control points. Others map only points. There are two ways to move along a path. The host tools
 * fit curves of the motors through as many points of the path as the tolerance needs. Or the path
 * is sampled at every tick (items of kind LOFT_POINTS). Between two ticks a motor then moves in a
 * straight line, so it is off by at most its acceleration times tick^2 / 8.
 *
 * Plans are for the motors: the axes and limits of a plan are those of the motors. CoreXY: since
 * a = x + y and b = x - y, |x|, |y| <= (|a| + |b|) / 2. So a limit that holds for both motors holds
 * for the tool along x and along y. Lengths are sqrt(2) times as long for the motors. Multiply
 * feed, tolerance and corner by that; values of other axes stay.
 *
 * Where kinematics are an argument, they are two callbacks: */
#ifndef LOFT_KINEMATICS_KINEMATICS_H
#define LOFT_KINEMATICS_KINEMATICS_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

#if LOFT_AXES >= 2

/* Inverse kinematics: give the motor positions for the tool position `tool`. `geometry` is the data
 * of the function. */
typedef loft_vec loft_motors_of(const void *geometry, loft_vec tool);

/* Forward kinematics: give the tool position in *tool. False, and *tool is untouched, if no tool
 * position has these motor positions. */
typedef bool loft_tool_of(const void *geometry, loft_vec motors, loft_vec *tool);


// CoreXY and H-bot
// ----------------

/* The motors a and b are at x + y and x - y. Other axes are unchanged. `geometry` is not used.
 *
 *   range   |x| + |y| within the range of a coordinate
 *   error   q16: none   f32, f64: 1/2 ulp
 *   cost    one addition, one subtraction */
loft_vec loft_corexy_motors(const void *geometry, loft_vec tool);

/* Forward kinematics.
 *
 *   shape   always true
 *   error   q16: none for results of loft_corexy_motors; otherwise 1/2 LSB   f32, f64: 1/2 ulp */
bool loft_corexy_tool(const void *geometry, loft_vec motors, loft_vec *tool);


// Polar
// -----

/* An arm moves the tool out from the pole, and the table (or the arm itself) rotates. The first
 * motor is the radius. The second is the angle, from the first axis toward the second. Other axes
 * are unchanged. */
typedef struct {
    loft_real turn;             /* a whole turn in units of the axis, 1..16383; degrees: 360 */
} loft_polar;

/* Radius and angle, the angle within half a turn to both sides; 0 at the pole. `geometry` is a
 * loft_polar.
 *
 *   range   |coordinates| <= 16383
 *   error   q16: radius 1/2 LSB, angle 1/2 LSB + turn 2^-17 LSB
 *           f32: 0.51 ulp; for the angle, ulp is that of half a turn
 *           f64: radius 2 ulp, angle 2^-49 of a turn
 *   cost    a 64-bit square root, an angle (num/angle.h), a division
 *   stack   Cortex-M4 176   Cortex-M0+ 292   ATmega328P 250 */
loft_vec loft_polar_motors(const void *geometry, loft_vec tool);

/* The same position with the number of whole turns that brings the angle nearest to that of
 * `before`. So motors do not jump back where a path goes around the pole.
 *
 *   range   as loft_polar_motors, the angle before within +-16383 - turn / 2
 *   error   that of `motors`, and f32: 1/2 ulp   f64: 1/2 ulp, and one ulp of the turns */
loft_vec loft_polar_near(const void *geometry, loft_vec motors, loft_vec before);

/* Forward kinematics, for any number of turns. A radius below 0 is beyond the pole.
 *
 *   shape   always true
 *   range   |radius|, |angle| <= 16383
 *   error   q16: 1/2 LSB + 2^-33 mm + 2^-56 of the radius   f32: 0.51 ulp of the radius   f64:
 *           2^-48 of the radius times the number of turns */
bool loft_polar_tool(const void *geometry, loft_vec motors, loft_vec *tool);

#if LOFT_AXES >= 3


// Linear delta
// ------------

/* Three towers, carriages that move up and down, arms of one length. */
typedef struct {
    loft_real tower[3][2];      /* mm: tower position, minus the offset of the tool's joint */
    loft_real arm;              /* mm, above 0 and up to 16383 */
} loft_delta;

/* The heights of the carriages. `geometry` is a loft_delta.
 *
 *   range   |coordinates| <= 16383; an arm that does not reach counts as horizontal
 *   error   q16: that of the square root, 1/2 LSB   f32, f64: 2 ulp of the largest of tower, tool
 *           and arm, if the arm is steep
 *   cost    per tower three products, a 64-bit square root
 *   stack   Cortex-M4 76   Cortex-M0+ 132   ATmega328P 77
 *   see     Johann Rocholl's Rostock printer; RepRap wiki, Delta geometry */
loft_vec loft_delta_motors(const void *geometry, loft_vec tool);

/* Forward kinematics: the lower of the two points at an arm's length from all three carriages.
 *
 *   shape   false if there is none, or the carriages are on a line
 *   range   |coordinates| <= 16383
 *   error   for exact motor positions: q16: 1/2 LSB + 2^-14   f32: 0.51 ulp + 2^-38 mm   f64:
 *           2^-38 mm. This holds for machines to 1000 mm whose arms are steeper than 8 degrees and
 *           whose carriages make a triangle with sides in proportion 1:8 at most. Rounded motor
 *           positions move the tool by the rounding times a factor of the geometry: by at most
 *           2.5 LSB (2.5 ulp of the largest) within half of the towers' radius from the middle, if
 *           that radius is 0.3 to 0.6 of the arm
 *   cost    q16: 60 operations of num/sci.h, five of them divisions or roots: not for an ISR
 *   stack   Cortex-M4 980   Cortex-M0+ 1,024   ATmega328P 756
 *   see     the centre of the circle through a triangle; the tool is below it at the distance that
 *           Pythagoras' theorem gives */
bool loft_delta_tool(const void *geometry, loft_vec motors, loft_vec *tool);

#endif
#endif

LOFT_END_C

#endif
