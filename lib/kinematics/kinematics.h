/* lib/kinematics/kinematics.h -- kinematics: from where the tool is to where the motors are, and
 * back
 * SPDX-License-Identifier: MIT
 *
 * Kinematics that are a matrix turn a curve into a curve and a span into a span: apply them to the
 * control points. Others turn points only: a path becomes curves of the motors through as many of
 * its points as the tolerance asks for (the host's tools do that), or is sampled at every tick
 * (items of kind LOFT_POINTS), and a motor is between two ticks where a straight line leads: off by
 * at most its acceleration times tick^2 / 8. What is planned is planned for the motors: a plan's
 * axes and limits are theirs. CoreXY: since a = x + y and b = x - y, |x|, |y| <= (|a| + |b|) / 2,
 * so a limit that both motors keep is kept by the tool along x and along y. Lengths are sqrt(2)
 * times as long for the motors: feed, tolerance and corner are to be given so, those of other axes
 * as they are.
 *
 * Where kinematics are wanted, they are two callbacks: */
#ifndef LOFT_KINEMATICS_KINEMATICS_H
#define LOFT_KINEMATICS_KINEMATICS_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

#if LOFT_AXES >= 2

/* Give where the motors are when the tool is at `tool`; `geometry` is what belongs to the
 * function. */
typedef loft_vec loft_motors_of(const void *geometry, loft_vec tool);

/* Give in *tool where the tool is; false, and *tool untouched, if the motors cannot be so. */
typedef bool loft_tool_of(const void *geometry, loft_vec motors, loft_vec *tool);


// CoreXY and H-bot
// ----------------

/* The motors a and b pull x + y and x - y; other axes are as they are. `geometry` is not looked at.
 *
 *   range   |x| + |y| within the range of a coordinate
 *   error   q16: none   f32, f64: 1/2 ulp
 *   cost    one addition, one subtraction */
loft_vec loft_corexy_motors(const void *geometry, loft_vec tool);

/* The way back.
 *
 *   shape   gives true, whatever the motors are
 *   error   q16: none for what loft_corexy_motors gave; else 1/2 LSB   f32, f64: 1/2 ulp */
bool loft_corexy_tool(const void *geometry, loft_vec motors, loft_vec *tool);


// Polar
// -----

/* An arm that moves the tool out from the pole, over a table that turns (or that turns itself). The
 * first motor is the radius, the second the angle, from the first axis towards the second; other
 * axes are as they are. */
typedef struct {
    loft_real turn;             /* a whole turn in units of the angle's axis, 1..16383: 360 for
                                 * degrees */
} loft_polar;

/* Radius and angle, the angle within half a turn to both sides; 0 at the pole. `geometry` is a
 * loft_polar.
 *
 *   range   |coordinates| <= 16383
 *   error   q16: radius 1/2 LSB, angle 1/2 LSB + turn 2^-17 LSB   f32: 0.51 ulp, of half a turn for
 *           the angle
 *           f64: radius 2 ulp, angle 2^-49 of a turn
 *   cost    a 64-bit square root, an angle (num/angle.h), a division */
loft_vec loft_polar_motors(const void *geometry, loft_vec tool);

/* The same place with as many whole turns more or less as bring the angle nearest to that of
 * `before`: motors do not jump back where a path goes round the pole.
 *
 *   range   as loft_polar_motors, the angle before within +-16383 - turn / 2
 *   error   that of `motors`; f32: and 1/2 ulp, f64: 1/2 ulp and one of the turns */
loft_vec loft_polar_near(const void *geometry, loft_vec motors, loft_vec before);

/* The way back, for any number of turns, and for a radius below 0, which is beyond the pole.
 *
 *   shape   gives true
 *   range   |radius|, |angle| <= 16383
 *   error   q16: 1/2 LSB + 2^-33 mm + 2^-56 of the radius   f32: 0.51 ulp of the radius   f64:
 *           2^-48 of the radius, and as many times that as there are turns */
bool loft_polar_tool(const void *geometry, loft_vec motors, loft_vec *tool);

#if LOFT_AXES >= 3


// Linear delta
// ------------

/* Three towers, carriages that run up and down, arms of one length. */
typedef struct {
    loft_real tower[3][2];      /* mm: where each tower stands; the place of its carriage less that
                                 * of the tool's joint */
    loft_real arm;              /* mm, above 0 and up to 16383 */
} loft_delta;

/* The heights of the carriages. `geometry` is a loft_delta.
 *
 *   range   |coordinates| <= 16383; where an arm does not reach, it counts as lying flat
 *   error   q16: that of the square root, 1/2 LSB   f32, f64: 2 ulp of the greatest of tower, tool
 *           and arm, where the arm stands steeply
 *   cost    per tower three products, a 64-bit square root
 *   see     Johann Rocholl's Rostock printer; RepRap wiki, Delta geometry */
loft_vec loft_delta_motors(const void *geometry, loft_vec tool);

/* The way back: the lower of the two places that are an arm's length away from all three carriages.
 *
 *   shape   false if there is none, or the carriages stand in a line
 *   range   |coordinates| <= 16383
 *   error   of motors that are exactly so: q16: 1/2 LSB + 2^-14   f32: 0.51 ulp + 2^-38 mm   f64:
 *           2^-38 mm, for machines to 1000 mm whose arms stand above 8 degrees and whose carriages
 *           make a triangle with sides in proportion 1:8 at most. What motors are rounded by moves
 *           the tool by as much as the geometry makes of it: by at most 2.5 LSB (2.5 ulp of the
 *           largest of them) within half of the towers' radius from the middle, where that is 0.3
 *           to 0.6 of the arm
 *   cost    q16: 60 operations of num/sci.h, five of them divisions or roots: not for an ISR
 *   see     the centre of the circle around a triangle; the place is above or below it by what
 *           Pythagoras leaves of the arm */
bool loft_delta_tool(const void *geometry, loft_vec motors, loft_vec *tool);

#endif
#endif

LOFT_END_C

#endif
