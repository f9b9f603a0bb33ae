/* lib/surface/volume.h -- the volume that patches and triangles enclose
 * SPDX-License-Identifier: MIT
 *
 * By the divergence theorem it is a third of the integral of P . (P_u x P_v) over all patches: a
 * polynomial, so nothing is approximated. The patches close a body, with P_u x P_v outward; where
 * it is turned inward the volume is negative. That they close is not checked.
 *
 *     loft_acc volume;
 *     if (loft_net_volume(nets, 6, &volume) == LOFT_OK) ..
 */
#ifndef LOFT_SURFACE_VOLUME_H
#define LOFT_SURFACE_VOLUME_H

#include "surface/net.h"    /* loft_net */

LOFT_BEGIN_C

/* The volume enclosed by s[0..count-1].
 *
 *   range   three axes or more, count >= 1, no weights, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if
 *           it does not fit a loft_acc (q16: 2^31); *out is untouched then
 *   error   with L the largest distance of a control point from the first one: q16: 2^-33 + count
 *           2^-52 L^3   f32, f64: count 2^-44 L^3
 *   cost    per patch of the degrees m, n about 12 (m + 1)^2 (n + 1)^2 products of num/sci.h for
 *           the normal, and as many for its product with the patch
 *   stack   Cortex-M4 17,308   Cortex-M0+ 17,296   ATmega328P 11,929
 *   see     Gonzalez-Ochoa, McCammon, Peters: Computing moments of objects enclosed by piecewise
 *           polynomial surfaces, ACM TOG 17 (1998)
 */
enum loft_status loft_net_volume(const loft_net s[], unsigned count, loft_acc *out) LOFT_CHECKED;

LOFT_END_C

#endif
