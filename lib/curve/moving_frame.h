/* lib/curve/moving_frame.h -- frames along a path in space that turn with it and do not twist about
 * it
 * SPDX-License-Identifier: MIT
 *
 * A frame is a place on the path, the direction of the path, and a direction across it. Moved from
 * place to place by two reflections it turns as little as it can: a section that is carried by it
 * does not spin about the path, also where the path is straight or bends the other way.
 *
 *     loft_moving_frame f;
 *     if (loft_moving_frame_start(&f, place[0], tangent[0], up) == LOFT_OK)
 *         for (k = 1; k < n && loft_moving_frame_move(&f, place[k], tangent[k]) == LOFT_OK; k++)
 *             if (loft_moving_frame_point(&f, section, &p) == LOFT_OK) ..
 *
 * Frames need three axes; further axes of a place are kept, those of directions are not used.
 */
#ifndef LOFT_CURVE_MOVING_FRAME_H
#define LOFT_CURVE_MOVING_FRAME_H

#include "geom/vec.h"           /* loft_vec */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

/* A frame. Do not fill it yourself: call start. */
typedef struct {
    loft_vec at;
    loft_sci along[3], across[3];       /* unit vectors at a right angle */
} loft_moving_frame;

/* Begin a frame: `across` is `up` without its part along the tangent. Both may have any length.
 *
 *   range   three axes or more, otherwise LOFT_ERR_ARG; LOFT_SINGULAR if the tangent is 0, or if
 *           the sine of its angle with `up` is below 2^-20; *f is then untouched
 *   error   with s that sine: q16: 2^-56 / s   f32, f64: 2^-48 / s
 *   cost    20 products, 6 quotients and 2 roots of num/sci.h
 */
enum loft_status loft_moving_frame_start(loft_moving_frame *f, loft_vec at, loft_vec tangent,
                                         loft_vec up) LOFT_CHECKED;

/* Move it to the next place. The frame is reflected in the plane halfway between the places, and
 * then in the plane that turns its direction to that of the tangent. Where the places are one, it
 * turns by the angle between the tangents.
 *
 *   range   LOFT_SINGULAR if the tangent is 0, or if the path turns back: the directions are
 *           opposite, or mirror images of each other in the plane halfway between the places,
 *           within 2^-16; *f is then untouched
 *   error   along: as start. across: that of the last place, and q16: 2^-38   f32, f64: 2^-30;
 *           where both tangents are within 60 degrees of the chord 2^-54 and 2^-46. The frame that
 *           does not twist at all differs by the fourth power of the step
 *   cost    50 products, 8 quotients and 2 roots of num/sci.h
 *   see     Wang, Juettler, Zheng and Liu, Computation of rotation minimizing frames (2008)
 */
enum loft_status loft_moving_frame_move(loft_moving_frame *f, loft_vec at,
                                        loft_vec tangent) LOFT_CHECKED;

/* The point with these coordinates in the frame: x across, y at a right angle to both (along x
 * across), z along the path.
 *
 *   range   LOFT_ERR_RANGE if it does not fit; *out is then untouched
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp + 2^-20 ulp   f64: 8 ulp, of the largest
 *           coordinate; plus that of the frame times the length of p
 *   cost    15 products of num/sci.h
 */
enum loft_status loft_moving_frame_point(const loft_moving_frame *f, loft_vec p,
                                         loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
