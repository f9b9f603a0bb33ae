/* lib/curve/enclosed.h -- what a closed chain of Bezier curves encloses: area, centroid, moments
 * SPDX-License-Identifier: MIT
 *
 * By Green's theorem these are integrals along the boundary, of polynomials: no flattening. Parts
 * that the chain encloses counterclockwise count positive, clockwise negative, twice for two turns.
 *
 *     loft_enclosed e;
 *     if (loft_chain_enclosed(curves, count, &e) == LOFT_OK)
 *         weight = e.area * ..
 *
 * In the `error` lines L is the largest distance of a control point from the first one, n the
 * largest degree. Coordinates are the first two; others do not count.
 */
#ifndef LOFT_CURVE_ENCLOSED_H
#define LOFT_CURVE_ENCLOSED_H

#include "curve/bezier.h"       /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    loft_acc area;
    loft_acc centroid[2];
    loft_acc xx, xy, yy;        /* second moments about the centroid, signed as the area */
} loft_enclosed;

/* Measure a chain: each curve begins where the one before ends, the first where the last one ends.
 *
 *   range   degrees 0..9, count >= 1, and a closed chain, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if
 *           a result does not fit a loft_acc (q16: 2^31), out->area is set if it does, and f32,
 *           f64: unless coordinates pass loft_exact_valid; LOFT_SINGULAR if the area is exactly 0:
 *           then out->area is 0, and the others are untouched
 *   error   area: q16: 2^-32   f32, f64: 1 ulp of double
 *           centroid: q16: 2^-32 + 2^-52 L^3 / area   f32, f64: 2^-44 L^3 / area
 *           moments: q16: 2^-32 + 2^-50 L^4 (1 + L^2 / area)   f32, f64: 2^-42 L^4 (1 + L^2 / area)
 *   cost    per curve (degree + 1)^2 exact products, and in numbers of num/sci.h products of
 *           polynomials up to the degree 4 n - 1
 *   stack   Cortex-M4 4,504   Cortex-M0+ 4,508   ATmega328P 3,666
 *   see     Green's theorem; Chang, Mathematics of Surfaces, (2-9)
 */
enum loft_status loft_chain_enclosed(const loft_bezier c[], unsigned count,
                                     loft_enclosed *out) LOFT_CHECKED;

/* The area between a curve and the x axis from t = from to t = to, the integral of y dx: negative
 * where x runs back or y is below 0.
 *
 *   range   both in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if it does not fit a loft_acc
 *   error   q16: 2^-32 + 2^-52 L^2   f32, f64: 2^-44 L^2, L the largest coordinate
 *   cost    a product of polynomials of the degrees n and n - 1 in numbers of num/sci.h
 */
enum loft_status loft_bezier_area_under(const loft_bezier *b, loft_unit from, loft_unit to,
                                        loft_acc *out) LOFT_CHECKED;

LOFT_END_C

#endif
