/* lib/surface/net_nearest.h -- the point of a patch or triangle that is nearest to a given point
 * SPDX-License-Identifier: MIT
 *
 *     loft_net_near near;
 *     if (loft_net_nearest(loft_net_from_tensor(&s), probe, LOFT_REAL(0.001), &near) == LOFT_OK)
 *         use(near.u, near.v, near.distance);
 */
#ifndef LOFT_SURFACE_NET_NEAREST_H
#define LOFT_SURFACE_NET_NEAREST_H

#include "surface/net.h"    /* loft_net */

LOFT_BEGIN_C

#define LOFT_NET_NEAREST_PARTS ((uint32_t)1 << 16)

typedef struct {
    loft_unit u, v;
    loft_vec  point;            /* on the surface, rounded to coordinates         */
    loft_acc  distance;         /* from the given point, before that rounding   */
} loft_net_near;

/* Find the point nearest to p over the whole surface, the global minimum; it may lie on an edge or
 * at a corner, where u and v are exactly 0 or 1 (in a triangle also u + v to 1 rounding). If
 * several points are equally near, the result is one of them. LOFT_MORE: LOFT_NET_NEAREST_PARTS
 * parts did not suffice to prove that none is nearer, as for the centre of a sphere; *out is the
 * nearest point found.
 *
 *   range   tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if p is not a valid number, or the
 *           distance does not fit; *out is untouched after an error
 *   error   distance: at most tol longer than the smallest, plus q16: 2^-29   f32, f64: 2^-44 of
 *           the largest difference of coordinates, with weights 2 R times that, R the largest
 *           weight over the smallest
 *           u, v: a local minimum, found by Newton's method: where the distance grows as the square
 *           of the way from it, to about q16: 2^-25   f64: 2^-40
 *           point: 1/2 LSB (ulp) per axis and as u, v
 *   cost    some 50 to 2000 parts, each once loft_net_form_sub; not for small chips
 *   stack   Cortex-M4 15,796   Cortex-M0+ 15,808   ATmega328P 11,136
 *   see     Ma and Hewitt, Point inversion and projection for NURBS curves and surfaces, CAGD 20
 *           (2003)
 */
enum loft_status loft_net_nearest(loft_net s, loft_vec p, loft_real tol,
                                  loft_net_near *out) LOFT_CHECKED;

LOFT_END_C

#endif
