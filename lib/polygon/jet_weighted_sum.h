/* lib/polygon/jet_weighted_sum.h -- sums of weighted points whose weights are functions of a point,
 * for
 * the derivatives of a patch
 * SPDX-License-Identifier: MIT
 *
 * As polygon/weighted_sum.h, counted from an origin: what is near it loses no digits.
 */
#ifndef LOFT_POLYGON_JET_WEIGHTED_SUM_H
#define LOFT_POLYGON_JET_WEIGHTED_SUM_H

#include "geom/vec.h"           /* loft_vec */
#include "polygon/jet.h"        /* loft_jet */
#include "surface/differential.h"      /* loft_differential */

LOFT_BEGIN_C

/* The sum of (point - origin) times weight, the sum of weights, and the sums of the sizes of the
 * terms of first derivatives. */
typedef struct {
    loft_jet x[LOFT_AXES], w;
    loft_sci wide_x[LOFT_AXES], wide_y[LOFT_AXES];
    loft_vec origin;
} loft_jet_weighted_sum;

/* Begin with nothing; add a point times a weight.
 *
 *   error   one rounding of loft_sci per product and sum
 *   cost    6 products, 8 sums per axis, 6 sums more; q16: 0.5 kB for 3 axes
 */
void loft_jet_weighted_sum_start(loft_jet_weighted_sum *b, loft_vec origin);
void loft_jet_weighted_sum_add(loft_jet_weighted_sum *b, const loft_vec *p, const loft_jet *weight);

/* The derivatives of the sum, for weights that sum to 1 everywhere; or of the sum divided by that
 * of the weights.
 *
 *   range   LOFT_SINGULAR when the weights sum to 0; *out is untouched then
 *   error   q16: 2^-57   f32, f64: 2^-49 of the terms' sizes, the latter for an origin that is the
 *           point but for its rounding
 *   cost    project: 13 products and 5 quotients per axis
 */
void loft_jet_weighted_sum_end(const loft_jet_weighted_sum *b, loft_differential *out);
enum loft_status loft_jet_weighted_sum_project(const loft_jet_weighted_sum *b,
                                               loft_differential *out) LOFT_CHECKED;

LOFT_END_C

#endif
