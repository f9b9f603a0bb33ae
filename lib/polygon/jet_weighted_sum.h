/* lib/polygon/jet_weighted_sum.h -- sums of points whose weights are functions, for derivatives of
 * a patch
 * SPDX-License-Identifier: MIT
 *
 * As polygon/weighted_sum.h, relative to an origin, so that points near it lose no digits.
 */
#ifndef LOFT_POLYGON_JET_WEIGHTED_SUM_H
#define LOFT_POLYGON_JET_WEIGHTED_SUM_H

#include "geom/vec.h"               /* loft_vec */
#include "polygon/jet.h"            /* loft_jet */
#include "surface/differential.h"   /* loft_differential */

LOFT_BEGIN_C

/* The sum of (point - origin) times weight, the sum of weights, and the sums of the absolute terms
 * of first derivatives. */
typedef struct {
    loft_jet x[LOFT_AXES], w;
    loft_sci wide_x[LOFT_AXES], wide_y[LOFT_AXES];
    loft_vec origin;
} loft_jet_weighted_sum;

/* Begin an empty sum; add a point times a weight.
 *
 *   error   one rounding of loft_sci per product and sum
 *   cost    6 products, 8 sums per axis, 6 sums more; q16: 0.5 kB for 3 axes
 */
void loft_jet_weighted_sum_start(loft_jet_weighted_sum *b, loft_vec origin);
void loft_jet_weighted_sum_add(loft_jet_weighted_sum *b, const loft_vec *p, const loft_jet *weight);

/* The derivatives of the sum, for weights that sum to 1 everywhere; or of the sum divided by the
 * sum of the weights.
 *
 *   range   LOFT_SINGULAR when the weights sum to 0; *out is then untouched
 *   error   q16: 2^-57   f32, f64: 2^-49 of the absolute terms; project needs the rounded point
 *           itself as origin
 *   cost    project: 13 products and 5 quotients per axis
 */
void loft_jet_weighted_sum_end(const loft_jet_weighted_sum *b, loft_differential *out);
enum loft_status loft_jet_weighted_sum_project(const loft_jet_weighted_sum *b,
                                               loft_differential *out) LOFT_CHECKED;

LOFT_END_C

#endif
