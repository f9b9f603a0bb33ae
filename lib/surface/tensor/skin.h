/* lib/surface/tensor/skin.h -- a surface through sections: the skin over the ribs of a hull
 * SPDX-License-Identifier: MIT
 *
 * The sections are Bezier curves of one degree, at the heights v[0] < v[1] < .. of a second
 * parameter. Each of their control points runs along the cubic spline through its positions
 * (curve/spline.h), so the surface meets every section and its curvature does not jump across them.
 *
 *     static loft_spline_knot memory[SECTIONS * (DEGREE + 1)];
 *     loft_skin s;
 *     if (loft_skin_init(&s, points, DEGREE, SECTIONS, v, LOFT_ENDS_NATURAL, memory) == LOFT_OK)
 *         for (uint32_t j = 0; j + 1 < SECTIONS; j++)
 *             if (loft_tensor_from_skin(&s, j, net) == LOFT_OK &&
 *                 loft_tensor_init(&patch, net, DEGREE, 3) == LOFT_OK) ..
 *
 * Sections of different degrees are raised first (loft_bezier_elevate). In the `error` lines h, S
 * and Q are those of curve/spline.h, the largest of all control points.
 */
#ifndef LOFT_SURFACE_TENSOR_SKIN_H
#define LOFT_SURFACE_TENSOR_SKIN_H

#include "curve/spline.h"       /* loft_spline */

LOFT_BEGIN_C

/* A skin. Do not fill it yourself: call init. */
typedef struct {
    loft_spline line[LOFT_DEGREE_MAX + 1];
    const loft_real *v;
    uint32_t sections;
    uint8_t degree;
} loft_skin;

/* Make the skin over the sections p[0..degree], p[degree + 1 ..] ..; points, v and
 * memory[sections (degree + 1)] must outlive it.
 *
 *   range   degree 0..9, two sections or more, increasing v, ends natural or not-a-knot, otherwise
 *           LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates that are not valid numbers (f32, f64)
 *   error   that of loft_spline_init
 *   cost    degree + 1 times loft_spline_init
 *   see     Piegl and Tiller, The NURBS Book, ch. 10.3: skinned surfaces
 */
enum loft_status loft_skin_init(loft_skin *s, const loft_vec p[], unsigned degree,
                                uint32_t sections, const loft_real v[], enum loft_spline_ends ends,
                                loft_spline_knot memory[]) LOFT_CHECKED;

/* The derivative of order j by u and k by v, j <= 2 and k <= 2, at u in 0..1 and v; the point for
 * j = k = 0. v is clamped to the sections; at a section the piece behind it counts, at the last one
 * the last piece.
 *
 *   range   u, j and k as above, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the result does not fit;
 *           *out is untouched after an error
 *   error   k = 0: q16: 1/2 LSB + 2^-16 LSB + degree^j 2^-56 S h Q
 *           k = 1 or 2: q16: 1/2 LSB + 2^-16 LSB + degree^j 2^-53 S Q h^(1-k)
 *           f32: 1/2 ulp of the result + degree^j 2^-45 S Q (h + 1 + 1/h)
 *           f64: 1/2 ulp of the result + degree^j 2^-45 S Q (h + 1 + 1/h)
 *   cost    degree + 1 times loft_spline_slope and de Casteljau's algorithm per axis
 */
enum loft_status loft_skin_deriv(const loft_skin *s, unsigned j, unsigned k, loft_unit u,
                                 loft_real v, loft_vec *out) LOFT_CHECKED;

/* The control points of the piece between sections j and j + 1, as a tensor patch of the degrees
 * `degree` and 3, rows along u: out[4 (degree + 1)].
 *
 *   range   j + 1 < sections, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if one does not fit; *out is
 *           undefined then
 *   error   that of loft_cubic_from_spline
 *   cost    degree + 1 times loft_cubic_from_spline
 */
enum loft_status loft_tensor_from_skin(const loft_skin *s, uint32_t j, loft_vec out[]) LOFT_CHECKED;

LOFT_END_C

#endif
