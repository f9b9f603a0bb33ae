/* lib/curve/fit.h -- the B-spline nearest to many points, by least squares
 * SPDX-License-Identifier: MIT
 *
 * Points with parameters and weights are given, and the knots of a curve. Of all B-splines with
 * these knots, and the first and the last point as ends, the one is made whose weighted sum of
 * squared distances from the points, each at its parameter, is the smallest. A closed one joins its
 * end with degree - 1 continuous derivatives, and need not meet any point.
 *
 *     loft_sci memory[LOFT_FIT_MEMORY(CONTROLS, 3)];
 *     const loft_fit_points data = { measured, lengths, NULL, COUNT };
 *     if (loft_bspline_fit(&data, knots, CONTROLS, 3, false, controls, memory) == LOFT_OK)
 *         status = loft_bspline_init(&b, controls, CONTROLS, knots, 3);
 *
 * The knots 0 .. 0 1 .. 1 alone make a Bezier curve. What parameters and knots to take is the
 * caller's choice: lengths along the points, and a knot wherever the curve is too far from them.
 */
#ifndef LOFT_CURVE_FIT_H
#define LOFT_CURVE_FIT_H

#include "basis/knots.h"        /* loft_knots */
#include "geom/vec.h"           /* loft_vec */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

/* For a curve of so many control points. */
#define LOFT_FIT_MEMORY(points, degree) ((points) * (2u * (degree) + 1u + LOFT_AXES))

/* Borrowed. */
typedef struct {
    const loft_vec *p;
    const loft_real *u;         /* parameters, which do not descend   */
    const loft_real *weight;    /* above 0; NULL: 1 each              */
    uint32_t count;
} loft_fit_points;

/* Make the control points out[0 .. points - 1] for points + degree + 1 knots.
 *
 *   shape   memory[LOFT_FIT_MEMORY(points, degree)]
 *   range   knots as loft_knots_init; at least 2 points, parameters within the domain, weights
 *           above 0, otherwise LOFT_ERR_ARG. Unless closed the first and the last knot occur degree
 *           + 1 times, and the first and the last parameter are the ends of the domain. Closed:
 *           points > 2 degree, and knots that repeat, each the one points - degree before it and
 *           the length of the domain (rounding apart). LOFT_SINGULAR: too few points lie along some
 *           part of the curve to tell its control points. LOFT_ERR_RANGE if a control point does
 *           not fit, or a number is not valid (f64: below 2^250). out[] is undefined after an error
 *   error   with N_i the B-splines, w the weights, W_i the sum of w N_i(u) and W the largest of
 *           them, L the largest coordinate, also of out[]: for each control point that is not kept
 *           |sum of w N_i(u) (C(u) - p)|, which is 0 for the smallest sum of squares, is at most
 *           q16: (1/2 LSB + 2^-17 LSB) W_i + (degree + 1)^3 (8 + count) 2^-60 L W
 *           f32: 1/2 ulp of L times W_i + (degree + 1)^3 (8 + count) 2^-52 L W
 *           f64: (degree + 1)^3 (8 + count) 2^-52 L W
 *           Closed: once more degree LSB of the knots over the shortest step between knots, times
 *           that. Ends that are kept: none
 *   cost    per point (degree + 1) (3 degree / 2 + 1 + LOFT_AXES) products and degree (degree + 1)
 *           quotients of num/sci.h; per control point (degree + 1) (degree / 2 + LOFT_AXES)
 *           products, closed three times as many
 *   see     de Boor, A Practical Guide to Splines (2001), ch. XIV; Golub and Van Loan, Matrix
 *           Computations, 4.3.5 (band Cholesky)
 */
enum loft_status loft_bspline_fit(const loft_fit_points *data, const loft_real knots[],
                                  unsigned points, unsigned degree, bool closed, loft_vec out[],
                                  loft_sci memory[]) LOFT_CHECKED;

LOFT_END_C

#endif
