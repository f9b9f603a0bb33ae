/* lib/polygon/patch_ball.h -- patches with n sides over a piece of their parameters: the range of
 * the point and of its derivatives
 * SPDX-License-Identifier: MIT
 *
 * The formulas are those of the patches, with ranges in place of numbers (polygon/jet_ball.h). All
 * functions are those of two parameters of the caller: see toolpath/sector.h.
 */
#ifndef LOFT_POLYGON_PATCH_BALL_H
#define LOFT_POLYGON_PATCH_BALL_H

#include "polygon/basepoint.h"      /* loft_basepoint */
#include "polygon/gb.h"             /* loft_gb */
#include "polygon/jet_ball_sum.h"   /* loft_jet_ball_sum */
#include "polygon/spatch.h"         /* loft_spatch */
#include "polygon/toric.h"          /* loft_toric */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball */

LOFT_BEGIN_C

/* Wachspress coordinates from the areas of loft_wachspress_eval. Returns false where they have no
 * bounds: *phi is then undefined.
 *
 *   shape   area[d->sides], phi[d->sides]
 *   range   a convex domain
 *   error   ranges grow with the piece: about as its size times that of third derivatives
 *   cost    n (n - 2) products and n quotients of polygon/jet_ball.h
 */
bool loft_wachspress_ball(const loft_domain *d, const loft_jet_ball area[],
                          loft_jet_ball phi[]) LOFT_CHECKED;

/* The point of an S-patch, relative to the origin of the sum; of a toric patch, h[sides] its
 * heights; of a patch with base points, factor[3] the three factors of loft_basepoint_corner and
 * factor[3] its v. Returns false where there are no bounds: *out is then undefined.
 *
 *   error   as above
 *   cost    per control point the number of its factors in products, and one loft_jet_ball_sum_add;
 *           9 products per factor before
 *   stack   Cortex-M4 19,084   Cortex-M0+ 19,096   ATmega328P 13,046
 */
bool loft_spatch_ball(const loft_spatch *s, const loft_jet_ball phi[],
                      loft_jet_ball_sum *out) LOFT_CHECKED;
bool loft_toric_ball(const loft_toric *t, const loft_jet_ball h[],
                     loft_jet_ball_sum *out) LOFT_CHECKED;
bool loft_basepoint_ball(const loft_basepoint *b, unsigned corner, const loft_jet_ball factor[4],
                         loft_jet_ball_sum *out) LOFT_CHECKED;

/* The point of a gb patch with Wachspress coordinates. At a vertex derivatives have no bounds:
 * `point` asks for the range of the point alone.
 *
 *   shape   area, phi: of loft_wachspress_ball
 *   error   as above
 *   cost    per control point a product and one loft_jet_ball_sum_add; per side 3 degree + 30
 *           products and 4 quotients
 *   stack   Cortex-M4 14,636   Cortex-M0+ 14,648   ATmega328P 10,509
 */
bool loft_gb_ball(const loft_gb *g, const loft_domain *d, const loft_jet_ball area[],
                  const loft_jet_ball phi[], bool point, loft_jet_ball_sum *out) LOFT_CHECKED;

/* The parameters of a Zheng-Ball patch from u_1 and u_2, as loft_zheng_ball_params. Returns false
 * where they have no bounds: u is then undefined.
 *
 *   shape   u[sides]
 *   range   as loft_zheng_ball_params; bounds are near where u_1 and u_2 are not both near 1
 *   error   as above
 *   cost    5 sides 1 product and 2 quotients; 6: 28 products, 4 roots and 4 quotients
 */
bool loft_zheng_ball_params_ball(unsigned sides, const loft_jet_ball *u1, const loft_jet_ball *u2,
                                 loft_jet_ball u[]) LOFT_CHECKED;

/* The point of a Zheng-Ball patch; u[sides] its parameters, in the order of its sides.
 *
 *   error   as above
 *   cost    per control point about 4 products and one loft_jet_ball_sum_add; 6 degree products
 *           before
 *   stack   Cortex-M4 13,788   Cortex-M0+ 13,848   ATmega328P 9,638
 */
void loft_zheng_ball_range(const loft_zheng_ball *r, const loft_jet_ball u[],
                           loft_jet_ball_sum *out);

LOFT_END_C

#endif
