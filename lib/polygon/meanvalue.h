/* lib/polygon/meanvalue.h -- mean value coordinates with respect to the vertices of any simple
 * polygon
 * SPDX-License-Identifier: MIT
 *
 * sum phi_i = 1 and sum phi_i v_i = p, everywhere in the plane. They are linear on edges, and phi_i
 * is 1 at vertex i. They are positive inside a convex polygon. Elsewhere some may be negative or
 * larger than 1.
 */
#ifndef LOFT_POLYGON_MEANVALUE_H
#define LOFT_POLYGON_MEANVALUE_H

#include "polygon/domain.h" /* loft_domain, loft_spot */
#include "polygon/jet.h"    /* loft_jet */

LOFT_BEGIN_C

/* The coordinates of p.
 *
 *   shape   phi[d->sides]
 *   range   any simple polygon; any p, inside or outside (f32, f64: loft_spot_valid, otherwise
 *           LOFT_ERR_RANGE)
 *   error   with K = sum (|t_(i-1)| + |t_i|) / r_i over |sum w_i| (meanvalue.c): q16: (1 + |phi|) K
 *           2^-56   f32, f64: (1 + |phi|) K 2^-47, phi the largest coordinate. K is 1 inside a
 *           convex polygon, and grows as the square of the distance outside
 *   cost    n roots, 4 n products, 3 n divisions, n cross products; no table
 *   stack   Cortex-M4 1,380   Cortex-M0+ 1,392   ATmega328P 1,024
 *   see     Floater, Mean value coordinates (2003); Hormann, Floater, Mean value coordinates for
 *           arbitrary planar polygons (2006)
 */
enum loft_status loft_meanvalue_eval(const loft_domain *d, loft_spot p,
                                     loft_sci phi[]) LOFT_CHECKED;

/* The coordinates with their derivatives by the point, also on edges.
 *
 *   shape   phi[d->sides]
 *   range   as loft_meanvalue_eval; LOFT_SINGULAR at a vertex, where there are no derivatives
 *   error   as loft_wachspress_jet, times K^2 of loft_meanvalue_eval, and with P^2 + Q + P / r in
 *           place of P^2 + Q. r is the smallest distance between two of: the point, the vertices,
 *           the lines through edges that do not end in these
 *   cost    n roots, 22 n divisions, 150 n products and 15 for every pair of an edge and one seen
 *           at an obtuse angle; no table
 *   stack   Cortex-M4 4,588   Cortex-M0+ 4,640   ATmega328P 3,256
 */
enum loft_status loft_meanvalue_jet(const loft_domain *d, loft_spot p, loft_jet phi[]) LOFT_CHECKED;

LOFT_END_C

#endif
