/* lib/polygon/jet_ball_sum.h -- the range of a sum of points whose weights are functions
 * SPDX-License-Identifier: MIT
 *
 * As polygon/jet_weighted_sum.h, over a piece of the plane in place of a point.
 */
#ifndef LOFT_POLYGON_JET_BALL_SUM_H
#define LOFT_POLYGON_JET_BALL_SUM_H

#include "geom/vec.h"           /* loft_vec */
#include "polygon/jet_ball.h"   /* loft_jet_ball */

LOFT_BEGIN_C

/* The sum of (point - origin) times weight, the sum of weights, and that of the absolute terms:
 * rounding moves the bounds by less than 2^-36 of it. */
typedef struct {
    loft_jet_ball x[3], w;
    loft_jet wide;
    loft_vec origin;
} loft_jet_ball_sum;

/* Begin an empty sum; add a point times a weight. Weights that sum to 1 everywhere may leave out
 * the origin.
 *
 *   error   the bounds do not contain the roundings: see above
 *   cost    48 products and 90 sums of loft_sci per point; q16: 1 kB
 */
void loft_jet_ball_sum_start(loft_jet_ball_sum *s, loft_vec origin);
void loft_jet_ball_sum_add(loft_jet_ball_sum *s, const loft_vec *p, const loft_jet_ball *weight);

/* Divide by the sum of the weights. Returns false when that may be 0: *s is then undefined.
 *
 *   error   as above
 *   cost    four loft_jet_ball_div
 */
bool loft_jet_ball_sum_project(loft_jet_ball_sum *s) LOFT_CHECKED;

LOFT_END_C

#endif
