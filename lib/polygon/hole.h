/* lib/polygon/hole.h -- holes with n sides, filled with a patch that has the tangent planes of the
 * surfaces around
 * SPDX-License-Identifier: MIT
 *
 * Each side of a hole is the edge of a neighbour: a Bezier curve, and the neighbour's derivative
 * across it, which points into the hole. Sides follow each other counterclockwise.
 *
 *     loft_hole_side side[5];     // loft_bezier edge and across
 *     if (loft_gb_from_hole(side, 5, 5, net, split, &gap) == LOFT_OK &&
 *         loft_gb_init_split(&g, net, split, 5, 5) == LOFT_OK) ..
 *
 * Where the tangent planes of two neighbours agree at the corner between them, the patch has their
 * tangent planes along all its sides. So it joins them as smoothly as they join each other (G1).
 */
#ifndef LOFT_POLYGON_HOLE_H
#define LOFT_POLYGON_HOLE_H

#include "curve/bezier.h"       /* loft_bezier */
#include "polygon/gb.h"         /* loft_gb_count */

LOFT_BEGIN_C

typedef struct {
    loft_bezier edge, across;
} loft_hole_side;

/* The net of a generalized Bezier patch over the hole, with split corners.
 *
 *   shape   out[loft_gb_count(sides, degree)], split[sides]
 *   range   3..8 sides, degree 3..9, edges of degree 1.. degree, `across` below `degree`, three
 *           axes or more, an edge ends where the next one starts, otherwise LOFT_ERR_ARG.
 *           LOFT_SINGULAR if a neighbour has no tangent plane at a corner (sine below 2^-12), or
 *           the next edge there does not lead into the hole. LOFT_ERR_RANGE if a point does not
 *           fit. out[] and split[] are undefined after an error
 *   error   points q16: on the edges 1/2 LSB + 2^-12 LSB, in the next row 1 LSB + 2^-12 LSB, in row
 *           k k / 2 + 1 LSB   f32: 4 ulp   f64: 2^10 ulp of the largest coordinate. The distance of
 *           the first two rows errs by 1/2 LSB. So with D the length of the derivative across a
 *           side, the tangent plane turns by degree LSB / (2 D), and at the ends by *gap: the
 *           largest sine of the angle between an edge and the tangent plane beside it
 *   cost    per side some 40 degree products of num/sci.h and axis
 *   stack   Cortex-M4 2,120   Cortex-M0+ 2,228   ATmega328P 1,779
 *   see     Farin, ch. 22: G1 joins by a linear field; Varady, Salvi, Kariko, A multi-sided Bezier
 *           patch with a simple control structure (2016)
 */
enum loft_status loft_gb_from_hole(const loft_hole_side side[], unsigned sides, unsigned degree,
                                   loft_vec out[], loft_vec split[], loft_acc *gap) LOFT_CHECKED;

LOFT_END_C

#endif
