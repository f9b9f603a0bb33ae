/* lib/surface/tensor/gregory.h -- Gregory patches: bicubic patches that follow slopes across all
 * their sides, also where the twists of two sides disagree
 * SPDX-License-Identifier: MIT
 *
 * Four of the sixteen points of a bicubic net are inside. Each of them sets the slope across two
 * sides, near the corner (1, 1) for example
 *
 *     across v = 0:   S_v = 3 (b_11 - b_10)           across u = 0:   S_u = 3 (b_11 - b_01)
 *
 * A Gregory patch has two points there: one for the side along u, one for the side along v. The
 * patch is the bicubic one with their mean, weighted by the distances from the sides:
 *
 *     b_11(u, v) = (u p_u + v p_v) / (u + v)
 *
 * So every side keeps its curve and its slopes. With both points equal it is the bicubic patch.
 *
 *     p[16]   the net, row by row, 4 i + j for b_ij, i along u; inside those for the sides along u
 *     p[16 ..19]  those for the sides along v: b_11, b_12, b_21, b_22
 *
 *     loft_gregory g;
 *     if (loft_gregory_init(&g, p) == LOFT_OK && loft_gregory_eval(&g, u, v, &x) == LOFT_OK) ..
 */
#ifndef LOFT_SURFACE_TENSOR_GREGORY_H
#define LOFT_SURFACE_TENSOR_GREGORY_H

#include "surface/differential.h"       /* loft_differential */
#include "surface/surface.h"            /* loft_surface */
#include "surface/tensor/coons.h"       /* loft_coons_bezier */

LOFT_BEGIN_C

#define LOFT_GREGORY_POINTS 20

/* The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
} loft_gregory;

/* Take LOFT_GREGORY_POINTS points, which must outlive the patch.
 *
 *   range   f32, f64: coordinates below 2^100, otherwise LOFT_ERR_RANGE; *g is then untouched
 *   error   none
 *   cost    one check per coordinate
 */
enum loft_status loft_gregory_init(loft_gregory *g, const loft_vec p[]) LOFT_CHECKED;

/* The patch of a Coons patch with slopes: it has the same curves and the same slopes across all
 * four sides, whatever the twists.
 *
 *   range   curves and slopes of degree 0..3, with slopes, otherwise LOFT_ERR_ARG; the slopes at
 *           the corners are taken from the curves there. LOFT_ERR_RANGE if a point does not fit;
 *           out[] is then undefined
 *   error   q16: 1/2 LSB + 2^-16 LSB inside, that of loft_bezier_elevate on the sides   f32: 1 ulp
 *           f64: 16 ulp
 *   cost    8 times loft_bezier_elevate, 8 quotients per axis
 *   see     Gregory, Smooth interpolation without twist constraints (1974); Farin, ch. 22
 */
enum loft_status loft_gregory_from_coons(const loft_coons_bezier *c,
                                         loft_vec out[LOFT_GREGORY_POINTS]) LOFT_CHECKED;

/* The derivative of order j by u and k by v, j + k <= 2; the point for j = k = 0.
 *
 *   range   u, v in 0..1 and j + k <= 2, otherwise LOFT_ERR_ARG; LOFT_SINGULAR for j + k = 2 at a
 *           corner with two points inside: there it depends on the direction; LOFT_ERR_RANGE if the
 *           result does not fit; *out is untouched after an error
 *   error   with f = 1, 12, 90 for j + k = 0, 1, 2: q16: 1/2 LSB + f 2^-20 LSB   f32: 1/2 ulp of
 *           the result + f 2^-16 ulp   f64: 32 f ulp, of the largest coordinate
 *   cost    20 products of num/sci.h per axis, and 100 for the weights
 *   stack   Cortex-M4 1,652   Cortex-M0+ 1,616   ATmega328P 1,260
 *   see     Chiyokura and Kimura, Design of solids with free-form surfaces (1983)
 */
enum loft_status loft_gregory_deriv(const loft_gregory *g, unsigned j, unsigned k, loft_unit u,
                                    loft_unit v, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_gregory_eval(const loft_gregory *g, loft_unit u, loft_unit v,
                                   loft_vec *out) LOFT_CHECKED;

/* The derivatives for surface/differential.h: normal and curvatures.
 *
 *   range   u, v in 0..1, otherwise LOFT_ERR_ARG; LOFT_SINGULAR at a corner with two points inside;
 *           *out is then untouched
 *   error   first derivatives q16: 2^-52   f32, f64: 2^-44 of the width, which is 3 times the
 *           largest difference of a control point and the first; second derivatives 8 times that
 *   cost    5 times loft_gregory_deriv
 */
enum loft_status loft_gregory_differential(const loft_gregory *g, loft_unit u, loft_unit v,
                                           loft_differential *out) LOFT_CHECKED;

/* Make a loft_surface of it; it must outlive that.
 *
 *   error   a point: that of loft_gregory_eval
 *   cost    two pointers copied
 */
loft_surface loft_surface_from_gregory(const loft_gregory *g);

LOFT_END_C

#endif
