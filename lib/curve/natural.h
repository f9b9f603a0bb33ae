/* lib/curve/natural.h -- the natural cubic spline: an elastic batten through given points
 * SPDX-License-Identifier: MIT
 *
 * There is one cubic between each point and the next, joined with equal first and second
 * derivatives. The second derivative is 0 at both ends. Knots are 0, 1, 2 .. (LOFT_UNIFORM), or
 * have the distances of the points (LOFT_CHORD), which follows unevenly spaced points better. The
 * points are borrowed, the memory is the caller's:
 *
 *     static loft_natural_knot knots[COUNT];
 *     loft_natural s;
 *     if (loft_natural_init(&s, points, COUNT, LOFT_CHORD, knots) == LOFT_OK)
 *         for (uint32_t i = 0; i + 1 < COUNT; i++)
 *             if (loft_cubic_from_natural(&s, i, &c) == LOFT_OK)
 *                 ..                                  // walk it, flatten it, plan it
 *
 * The spline may leave the range of coordinates although its points do not; such a result is
 * reported.
 *
 * In the `error` lines ulp is that of the largest coordinate. f64 accepts coordinates below 2^1000.
 */
#ifndef LOFT_CURVE_NATURAL_H
#define LOFT_CURVE_NATURAL_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */

LOFT_BEGIN_C

enum loft_spacing { LOFT_UNIFORM, LOFT_CHORD };

/* The data of one point. Complete so that the caller can own it; the fields may change without
 * notice. */
typedef struct {
    loft_acc slope[LOFT_AXES];  /* the first derivative, for LOFT_CHORD times 2^24          */
    loft_acc length;            /* of the chord that begins here, times 2^shift             */
    uint8_t shift;
} loft_natural_knot;

/* A spline. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    const loft_natural_knot *knot;
    uint32_t count;
    uint8_t knots;
} loft_natural;

/* Make the spline through p[0..count-1]; points and memory[count] must outlive it.
 *
 *   range   count >= 2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates that are not valid
 *           numbers (f32, f64); LOFT_SINGULAR if two consecutive points coincide with chord length
 *           knots
 *   error   of the slopes: uniform q16: 2^-30   f32, f64: 16 ulp of double
 *           chord (a slope is at most 3) q16: 2^-49   f32, f64: 2^-44
 *   cost    O(count): per point 3 + 3 LOFT_AXES long divisions (num/muldiv.h), with chord knots 3 +
 *           4 LOFT_AXES and two lengths; memory of 33 bytes per point on AVR, 40 elsewhere (3 axes)
 *   stack   Cortex-M4 336   Cortex-M0+ 460   ATmega328P 425
 *   see     de Boor, A Practical Guide to Splines, ch. 4; Farin, Curves and Surfaces for CAGD, ch.
 *           9
 */
enum loft_status loft_natural_init(loft_natural *s, const loft_vec p[], uint32_t count,
                                   enum loft_spacing knots,
                                   loft_natural_knot memory[]) LOFT_CHECKED;

/* The point of segment i (from p[i] to p[i+1]) at t.
 *
 *   range   i < count - 1 and t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point does
 *           not fit. *out is untouched after an error
 *   error   q16: 1/2 LSB + 2^-14 LSB, exact at the points   f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: 64 ulp
 *   cost    6 wide lerps per axis, with chord knots 2 more long divisions
 */
enum loft_status loft_natural_eval(const loft_natural *s, uint32_t i, loft_unit t,
                                   loft_vec *out) LOFT_CHECKED;

/* The k-th derivative with respect to the spline's own parameter, k = 1 or 2: per knot (uniform) or
 * per unit of chord length.
 *
 *   range   as eval, and k = 1 or 2
 *   error   q16: 1/2 LSB + 2^-12 LSB, the same from both sides of a knot for k = 1
 *           f32, f64: uniform 1/2 ulp of the result + 256 ulp of double of the largest coordinate
 *           chord 1/2 ulp of the result + 2^-43, for k = 2 divided by the length of the chord
 *   cost    at most 3 wide lerps per axis, with chord knots a long division (k = 2: two)
 */
enum loft_status loft_natural_deriv(const loft_natural *s, uint32_t i, unsigned k, loft_unit t,
                                    loft_vec *out) LOFT_CHECKED;

/* The control points of segment i.
 *
 *   range   as eval; LOFT_ERR_RANGE if a control point does not fit; *out is undefined then
 *   error   as eval
 *   cost    two divisions by 3 per axis, with chord knots two more long divisions
 */
enum loft_status loft_cubic_from_natural(const loft_natural *s, uint32_t i,
                                         loft_cubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
