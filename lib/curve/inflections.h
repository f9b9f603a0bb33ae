/* lib/curve/inflections.h -- where a plane Bezier curve of any degree is flat, decided exactly
 * SPDX-License-Identifier: MIT
 *
 *     loft_flat f[LOFT_FLATS_MAX];
 *     unsigned  count;
 *     if (loft_bezier_inflections(&b, f, &count) == LOFT_OK)
 *         for (unsigned k = 0; k < count; k++)
 *             if (f[k].multiplicity % 2 == 1)
 *                 use(f[k].t);                // the curvature changes its sign
 *
 * shape.h tells inflections of cubics faster.
 */
#ifndef LOFT_CURVE_INFLECTIONS_H
#define LOFT_CURVE_INFLECTIONS_H

#include "curve/bezier.h"       /* loft_bezier */
#include "curve/rational.h"     /* loft_rational */

LOFT_BEGIN_C

#define LOFT_FLATS_MAX       16
#define LOFT_FLATS_RATIONAL  7      /* the highest degree with weights */

typedef struct {
    loft_unit t;
    uint8_t   multiplicity;     /* 1: an inflection; 2: flat, or a cusp; 3: a flat inflection; .. */
} loft_flat;

/* All t in 0..1, ends included, where P' x P'' is 0 in the first two axes, in increasing order:
 * out[LOFT_FLATS_MAX]. Where the multiplicity is odd it changes its sign. LOFT_SINGULAR: it is 0
 * everywhere, the curve is straight; *count is then 0.
 *
 *   range   at least two axes, with weights degrees up to LOFT_FLATS_RATIONAL, otherwise
 *           LOFT_ERR_ARG; f32, f64: numbers that pass loft_exact_valid, otherwise LOFT_ERR_RANGE.
 *           That is also the answer for two places closer than 2^-52
 *   error   number and multiplicities: none; t: q16: 2^-25 + 2^-32   f32: 2^-25   f64: 2^-51
 *   cost    loft_whole_roots of the degree 2 n - 4, with weights 3 n - 6; not for small chips
 *   stack   Cortex-M4 10,856   Cortex-M0+ 10,884   ATmega328P 10,617
 *   see     Chang, Mathematics of Surfaces, 3.6; with weights the Wronskian of x w, y w, w
 */
enum loft_status loft_bezier_inflections(const loft_bezier *b, loft_flat out[],
                                         unsigned *count) LOFT_CHECKED;
enum loft_status loft_rational_inflections(const loft_rational *r, loft_flat out[],
                                           unsigned *count) LOFT_CHECKED;

LOFT_END_C

#endif
