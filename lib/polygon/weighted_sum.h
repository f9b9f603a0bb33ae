/* lib/polygon/weighted_sum.h -- sums of weighted points, and Bezier curves along edges of patches
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_POLYGON_WEIGHTED_SUM_H
#define LOFT_POLYGON_WEIGHTED_SUM_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "geom/vec.h"           /* loft_vec */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

/* A sum of points, each times its weight, and the sum of the weights. */
typedef struct {
    loft_sci x[LOFT_AXES], w;
} loft_weighted_sum;

/* Begin an empty sum; add a point times a weight of any sign; add another sum times a factor.
 *
 *   error   one rounding of loft_sci per product and sum
 *   cost    one product per axis, one sum per axis and one more
 */
void loft_weighted_sum_start(loft_weighted_sum *b);
void loft_weighted_sum_add(loft_weighted_sum *b, const loft_vec *p, loft_sci weight);
void loft_weighted_sum_join(loft_weighted_sum *b, const loft_weighted_sum *other, loft_sci factor);

/* The sum itself as a point, for weights that sum to 1; or the sum divided by the sum of the
 * weights.
 *
 *   range   LOFT_ERR_RANGE when a coordinate does not fit, LOFT_SINGULAR when the weights sum to 0;
 *           *out is then untouched
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1/2 ulp   f64: 1 ulp, plus that of the sum
 *   cost    project: one division per axis
 */
enum loft_status loft_weighted_sum_point(const loft_weighted_sum *b, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_weighted_sum_project(const loft_weighted_sum *b, loft_vec *out) LOFT_CHECKED;

/* The point of the Bezier curve with control points p[0..degree] at t = share[1] = 1 - share[0],
 * with weights if w is not null. If loft_unit holds t exactly, the point equals that of
 * loft_bezier_eval or loft_rational_eval bit for bit.
 *
 *   range   degree 0..9; weights 1/256..256
 *   error   that of these functions, or q16: 1/2 LSB + 2^-16 LSB   f32: 1 ulp   f64: 4 * degree + 8
 *           ulp
 *   cost    degree * (degree + 1) / 2 lerps per axis, or 4 * degree products and one per axis and
 *           point
 */
enum loft_status loft_weighted_sum_curve(const loft_vec p[], const loft_real w[], unsigned degree,
                                         const loft_sci share[2], loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
