/* lib/surface/differential.h -- a surface near one of its points: tangents, normal, curvatures
 * and their directions, radius of the largest ball
 * SPDX-License-Identifier: MIT
 *
 *     loft_differential here;
 *     loft_curvatures   k;
 *     if (loft_tensor_differential(&s, u, v, &here) == LOFT_OK &&
 *         loft_differential_curvatures(&here, &k) == LOFT_OK)
 *         largest_tool = loft_ball_radius(&k);
 *
 * The normal is P_u x P_v / |P_u x P_v|, in the first three axes. A curvature is positive where the
 * surface curves toward the normal. A ball that rolls on that side must be smaller than
 * 1 / curvature there.
 *
 * In the `error` lines W = |P_u x P_v| / (W_u W_v) is the length of the normal before
 * normalization, relative to the largest that the net allows. W_u and W_v are the largest
 * components of the first derivatives of the net. Below W = 2^-30 there is no normal, and the
 * result is LOFT_SINGULAR. With fewer than three axes it is LOFT_SINGULAR too.
 */
#ifndef LOFT_SURFACE_DIFFERENTIAL_H
#define LOFT_SURFACE_DIFFERENTIAL_H

#include "num/sci.h"                                /* loft_sci */
#include "surface/tensor/coons.h"                   /* loft_coons_bezier */
#include "surface/tensor/tensor.h"                  /* loft_tensor */
#include "surface/tensor/tensor_rational.h"         /* loft_tensor_rational */
#include "surface/triangle/triangle.h"              /* loft_triangle */
#include "surface/triangle/triangle_rational.h"     /* loft_triangle_rational */

LOFT_BEGIN_C

/* The first and second derivatives at a point, and the widths: the largest component of the first
 * derivatives over the net. A rational patch takes the net of the numerator, relative to the point,
 * over the weight at the point. A Coons patch takes the largest possible sum of its curves and
 * blending functions. */
typedef struct {
    loft_sci u[LOFT_AXES], v[LOFT_AXES], uu[LOFT_AXES], uv[LOFT_AXES], vv[LOFT_AXES];
    loft_sci width_u, width_v;
} loft_differential;

/* Compute the derivatives at (u, v); for a triangle in the directions T2 - T1 and T3 - T1.
 *
 *   range   the point inside, otherwise LOFT_ERR_ARG; f32, f64: absolute coordinates below 2^100,
 *           otherwise LOFT_ERR_RANGE; *out is then untouched
 *   error   q16: rows * 2^-59   f32, f64: rows * 2^-50. First derivatives: of the width. Second
 *           derivatives: of the largest second derivative of the net; Coons patches: of the sum
 *           that corresponds to the width; rational patches: of the largest second derivative of
 *           the numerator over the weight, plus 2 R degree widths. rows = m + n; triangle: degree;
 *           rational patches: 2 R (m + n + 2), 2 R (degree + 2), R as in tensor_rational.h; Coons
 *           patches: 16
 *   cost    five times de Casteljau's algorithm per axis, in numbers of num/sci.h; rational patches
 *           once more for the weights. Coons patches: per axis 4 orders (orders + 3) evaluations of
 *           curves and 5 (2 orders + 1)^2 products
 *   stack   Cortex-M4 4,636   Cortex-M0+ 4,664   ATmega328P 3,409
 */
enum loft_status loft_tensor_differential(const loft_tensor *s, loft_unit u, loft_unit v,
                                          loft_differential *out) LOFT_CHECKED;
enum loft_status loft_tensor_rational_differential(const loft_tensor_rational *s, loft_unit u,
                                                   loft_unit v,
                                                   loft_differential *out) LOFT_CHECKED;
enum loft_status loft_triangle_differential(const loft_triangle *t, loft_bary at,
                                            loft_differential *out) LOFT_CHECKED;
enum loft_status loft_triangle_rational_differential(const loft_triangle_rational *t, loft_bary at,
                                                     loft_differential *out) LOFT_CHECKED;
enum loft_status loft_coons_bezier_differential(const loft_coons_bezier *c, loft_unit s,
                                                loft_unit t, loft_differential *out) LOFT_CHECKED;

/* The unit normal.
 *
 *   range   LOFT_SINGULAR where there is no normal; *out is then untouched
 *   error   q16: 1/2 LSB + 2^-52 rows / W: below 2^-16 in all cases   f32: 1/2 ulp + 2^-46 rows / W
 *           f64: 2^-46 rows / W
 *   cost    10 products, a root and 3 quotients of num/sci.h
 */
enum loft_status loft_differential_normal(const loft_differential *at, loft_vec *out) LOFT_CHECKED;

/* The principal curvatures, min <= max, their product and their mean. Wide values, in 1 / unit
 * and 1 / unit^2. */
typedef struct {
    loft_acc gauss, mean, min, max;
} loft_curvatures;

/* The curvatures.
 *
 *   range   LOFT_SINGULAR where there is no normal; LOFT_ERR_RANGE when one does not fit a
 *           loft_acc; *out is then untouched
 *   error   with S = (|P_uu| + 2 |P_uv| + |P_vv|) max(|P_u|, |P_v|)^2 / |P_u x P_v|^2, where the
 *           derivatives are the largest of the net, and e = 2^-50 rows / W (q16), 2^-44 rows / W
 *           (f32, f64): min, max, mean q16: 2^-32 + e S, f32, f64: e S; gauss q16: 2^-32 +
 *           e S^2, f32, f64: e S^2
 *   cost    about 60 products, 2 roots and 5 quotients of num/sci.h
 *   see     do Carmo, Differential Geometry of Curves and Surfaces, ch. 3
 */
enum loft_status loft_differential_curvatures(const loft_differential *at,
                                              loft_curvatures *out) LOFT_CHECKED;

/* The directions of the curvatures min and max: unit vectors at a right angle, of either sign.
 *
 *   range   as loft_differential_curvatures; LOFT_SINGULAR also where these differ by less than
 *           2^-20 of themselves, as all over a sphere: there each direction is one. out[] is then
 *           untouched
 *   error   with k the error of min and max before rounding, 4 k / (max - min), and q16: 1/2 LSB +
 *           2^-16 LSB   f32: 1/2 ulp + 2^-40   f64: 2^-46
 *   cost    about 80 products, 4 roots and 15 quotients of num/sci.h
 *   see     do Carmo, Differential Geometry of Curves and Surfaces, ch. 3
 */
enum loft_status loft_differential_directions(const loft_differential *at,
                                              loft_vec out[2]) LOFT_CHECKED;

/* The radius of the largest ball that touches the surface here from the side of the normal and does
 * not cut into it nearby: 1 / max, rounded down. LOFT_REAL_MAX where the surface curves away from
 * the normal or the radius exceeds that.
 *
 *   error   q16: at most 1 LSB + 2^-30 of the radius too small   f32, f64: 2^-20, 2^-50 of it
 *   cost    one division
 */
loft_real loft_ball_radius(const loft_curvatures *k);

LOFT_END_C

#endif
