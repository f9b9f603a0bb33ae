/* lib/polygon/wachspress.h -- Wachspress coordinates with respect to the vertices of a convex
 * polygon
 * SPDX-License-Identifier: MIT
 *
 * They are rational: phi_i >= 0, sum phi_i = 1, sum phi_i v_i = p, linear on edges, 1 at vertex i.
 * Of the coordinates in this room, only these are unchanged by an affine map of polygon and point,
 * and bilinear on a parallelogram.
 */
#ifndef LOFT_POLYGON_WACHSPRESS_H
#define LOFT_POLYGON_WACHSPRESS_H

#include "polygon/domain.h" /* loft_domain, loft_spot */
#include "polygon/jet.h"    /* loft_jet */

LOFT_BEGIN_C

/* The coordinates of p.
 *
 *   shape   phi[d->sides]
 *   range   a convex domain, otherwise LOFT_ERR_ARG; p inside, on an edge or at a vertex, otherwise
 *           LOFT_ERR_RANGE
 *   error   relative to each coordinate: q16: n^2 * 2^-60   f32, f64: n^2 * 2^-46
 *   cost    n (n - 2) products, n cross products, n divisions; no table
 *   see     Wachspress, A Rational Finite Element Basis (1975); Meyer, Barr, Lee, Desbrun,
 *           Generalized Barycentric Coordinates on Irregular Polygons (2002): the form with areas
 */
enum loft_status loft_wachspress_eval(const loft_domain *d, loft_spot p,
                                      loft_sci phi[]) LOFT_CHECKED;

/* The coordinates with their derivatives by the point.
 *
 *   shape   phi[d->sides]
 *   range   as loft_wachspress_eval
 *   error   with P and Q the largest first and second derivative: first derivatives q16: P 2^-48
 *           f32, f64: P 2^-40; second: the same with P^2 + Q in place of P
 *   cost    15 n (n - 2) + 22 n products, n cross products, 9 n divisions; no table
 *   stack   Cortex-M4 2,036   Cortex-M0+ 2,064   ATmega328P 1,552
 */
enum loft_status loft_wachspress_jet(const loft_domain *d, loft_spot p,
                                     loft_jet phi[]) LOFT_CHECKED;

LOFT_END_C

#endif
