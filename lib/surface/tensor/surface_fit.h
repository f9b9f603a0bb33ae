/* lib/surface/tensor/surface_fit.h -- the B-spline surface nearest to a grid of points
 * SPDX-License-Identifier: MIT
 *
 *     const loft_fit_grid data = { measured, u, v, ROWS, COLUMNS };
 *     const loft_fit_net  net = { ku, kv, M, N, 3, 3 };
 *     if (loft_surface_fit(&data, &net, controls, middle, memory) == LOFT_OK)
 *         status = loft_bspline_surface_init(&s, controls, M, N, ku, 3, kv, 3);
 *
 * A row of points has one parameter u, a column one parameter v. What parameters and knots to take
 * is the caller's choice, as in curve/fit.h.
 */
#ifndef LOFT_SURFACE_TENSOR_SURFACE_FIT_H
#define LOFT_SURFACE_TENSOR_SURFACE_FIT_H

#include "curve/fit.h"      /* loft_bspline_fit */

LOFT_BEGIN_C

/* rows x columns points, row by row; u of each row, v of each column. Borrowed. */
typedef struct {
    const loft_vec *p;
    const loft_real *u, *v;
    uint16_t rows, columns;
} loft_fit_grid;

/* The knots of points_u x points_v control points. Borrowed. */
typedef struct {
    const loft_real *ku, *kv;
    uint16_t points_u, points_v;
    uint8_t degree_u, degree_v;
} loft_fit_net;

/* Points in between that a fit needs, and numbers: of the longer side. */
#define LOFT_SURFACE_FIT_POINTS(rows, points_u, points_v) ((rows) * ((points_v) + 1u) + (points_u))

/* Make the control points out[points_u * points_v], row by row: along each row of points, and then
 * along each column of what that gives. The corners of the grid are kept, the borders are the
 * curves nearest to its border points. Of all surfaces with these borders the sum of squared
 * distances is the smallest.
 *
 *   shape   middle[LOFT_SURFACE_FIT_POINTS(rows, points_u, points_v)],
 *           memory[LOFT_FIT_MEMORY(points, degree)], the larger one of both directions
 *   range   as loft_bspline_fit, along u and along v, not closed; out[] is undefined after an error
 *   error   along v as loft_bspline_fit, whose control points are rounded; along u as
 *           loft_bspline_fit of those
 *   cost    rows fits along v and points_v fits along u
 *   see     The NURBS Book, 9.4.3: global approximation with a surface
 */
enum loft_status loft_surface_fit(const loft_fit_grid *data, const loft_fit_net *net,
                                  loft_vec out[], loft_vec middle[],
                                  loft_sci memory[]) LOFT_CHECKED;

LOFT_END_C

#endif
