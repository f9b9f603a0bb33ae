/* lib/surface/tensor/bicubic.h -- bicubic patches from values and derivatives at their corners, and
 * joins of two patches
 * SPDX-License-Identifier: MIT
 *
 * The patch of Coons and Ferguson: Hermite's cubic in both directions. Plain data, no init: fill
 * the fields.
 *
 *     loft_bicubic b = { { { p00, p01, v00, v01 }, { p10, p11, v10, v11 },
 *                          { u00, u01, t00, t01 }, { u10, u11, t10, t11 } } };
 *     if (loft_bicubic_eval(&b, loft_unit_of(1, 3), loft_unit_of(1, 2), &p) == LOFT_OK) ..
 *
 * A point may lie beyond the coordinate range although all data are within it. That is reported,
 * never wrapped. In the `error` lines ulp is that of the largest given coordinate. f64 accepts
 * coordinates below 2^1000.
 */
#ifndef LOFT_SURFACE_TENSOR_BICUBIC_H
#define LOFT_SURFACE_TENSOR_BICUBIC_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

/* at[a][b]: a = 0, 1 is the value at u = 0, 1; a = 2, 3 is the derivative by u there; b likewise
 * with v. So at[0][1] is the corner (0, 1), at[2][0] its tangent along u at (0, 0), and at[3][3]
 * the twist, the mixed derivative, at (1, 1). */
typedef struct {
    loft_vec at[4][4];
} loft_bicubic;

/* The point at (u, v).
 *
 *   range   u, v in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the point does not fit; *out
 *           is then untouched
 *   error   q16: 1/2 LSB + 10 * 2^-17 LSB, exact at the corners   f32: 1/2 ulp of the result + 1/2
 *           ulp   f64: 56 ulp
 *   cost    30 wide lerps and 10 divisions by 3 per axis; safe in an ISR
 *   see     Coons, Surfaces for computer-aided design of space forms (1967); Farin, Curves and
 *           Surfaces for CAGD, ch. 15
 */
enum loft_status loft_bicubic_eval(const loft_bicubic *b, loft_unit u, loft_unit v,
                                   loft_vec *out) LOFT_CHECKED;

/* The derivative, j times by u and k times by v; 0 for j or k above 3.
 *
 *   range   as eval
 *   error   q16: 1/2 LSB + 160 * 2^-17 LSB, below 0.502 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 40000 ulp (with j, k <= 1: 2400)
 *   cost    as eval
 */
enum loft_status loft_bicubic_deriv(const loft_bicubic *b, unsigned j, unsigned k, loft_unit u,
                                    loft_unit v, loft_vec *out) LOFT_CHECKED;

/* The same patch as a tensor product of degree 3 x 3.
 *
 *   shape   net[16], row by row: 4 i + j for b_ij, i along u
 *   range   LOFT_ERR_RANGE when a point does not fit; net[] is then undefined
 *   error   q16: 1/2 LSB + 2 * 2^-17 LSB, none at the corners   f32: 1/2 ulp of the result + 1/2
 *           ulp   f64: 12 ulp
 *   cost    16 divisions by 3 per axis
 */
enum loft_status loft_tensor_from_bicubic(const loft_bicubic *b, loft_vec net[16]) LOFT_CHECKED;

/* How patch A continues patch C over the edge C(u, 1) = A(u, 0). */
typedef struct {
    bool c0;            /* the edges are equal */
    bool c1;            /* c0, and the derivatives by v along the edge are equal */
    bool g1;            /* c0, and A's derivatives are lambda > 0 times C's, not all of them 0 */
    loft_real lambda;   /* 0 where g1 does not hold */
} loft_bicubic_join;

/* Decide how A continues C. g1 is sufficient, not necessary, for one tangent plane along the edge.
 *
 *   range   LOFT_ERR_RANGE when lambda does not fit: the flags are then right and lambda is 0. In
 *           floats also when loft_exact_valid refuses a coordinate: all is then false and 0. *j is
 *           always written
 *   error   none in the flags; lambda q16: 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp   f64: 1 ulp
 *   cost    8 exact products per axis and one quotient; not for an ISR
 *   stack   Cortex-M4 1,800   Cortex-M0+ 1,800   ATmega328P 2,173
 *   see     Chang, Mathematics of Surfaces, ch. 9
 */
enum loft_status loft_bicubic_join_init(loft_bicubic_join *j, const loft_bicubic *c,
                                        const loft_bicubic *a) LOFT_CHECKED;

LOFT_END_C

#endif
