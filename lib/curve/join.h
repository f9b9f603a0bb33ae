/* lib/curve/join.h -- how smoothly one Bezier curve continues another, and how to continue one
 * SPDX-License-Identifier: MIT
 *
 *     loft_join j;
 *     if (loft_join_init(&j, &first, &second, 0) == LOFT_OK && j.g2)
 *         ...                                          // no jump of the curvature
 *
 * The curve P ends with the edges a[n-1], a[n] (a[k] = P[k] - P[k-1]), and the curve Q starts with
 * b[1], b[2]. The continuity conditions are
 *
 *     C0 = G0   P[n] = Q[0]
 *     C1        and b[1] = a[n]
 *     C2        and b[2] - b[1] = a[n] - a[n-1]
 *     G1        C0, and b[1] = alpha a[n], alpha > 0: one tangent
 *     G2        G1, and b[2] = -alpha^2 a[n-1] + eta a[n]: one curvature
 *
 * G1 and G2 need a direction: they do not hold if a[n] or b[1] is null, even if C2 does.
 */
#ifndef LOFT_CURVE_JOIN_H
#define LOFT_CURVE_JOIN_H

#include "curve/bezier.h"   /* loft_bezier */

LOFT_BEGIN_C

typedef struct {
    bool c0, c1, c2, g0, g1, g2;
    bool regular;               /* neither a[n] nor b[1] is null     */
    loft_real alpha, eta;       /* 0 if g1 or g2 does not hold       */
} loft_join;

/* Decide how smoothly Q continues P.
 *
 *   range   P and Q of the same degree 1..9, tol >= 0, otherwise LOFT_ERR_ARG. For degree 1 C2 is
 *           C1 and G2 is G1 (then eta = alpha + alpha^2, that of the elevated curves).
 *           LOFT_ERR_RANGE if alpha or eta does not fit: the flags are correct, and the number that
 *           does not fit is 0. In floats also if a coordinate fails loft_exact_valid: then all is
 *           false and 0. *j is always written
 *   error   tol = 0: none, the flags are exact for the given coordinates
 *           tol > 0: each difference above counts as zero up to a length of tol. For G1 and G2 it
 *           is the component of b[1] and of b[2] + alpha^2 a[n-1] perpendicular to a[n], with alpha
 *           from the projection of b[1]. An edge is null up to that length. Lengths are compared to
 *           2^-28 of them + 2^-31 (q16), 2^-49 (floats)
 *           alpha, eta: q16 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp
 *           f64: 1 ulp
 *   cost    about 100 exact products in three axes (num/exact.h) and, for tol > 0, 15 quotients;
 *           not for an ISR
 *   stack   Cortex-M4 3,008   Cortex-M0+ 3,000   ATmega328P 3,962
 *   see     Farin, Curves and Surfaces for CAGD, ch. 5 (C) and ch. 11 (G)
 */
enum loft_status loft_join_init(loft_join *j, const loft_bezier *p, const loft_bezier *q,
                                loft_real tol) LOFT_CHECKED;

/* The first three control points of a curve of P's degree that continues P with G2:
 *
 *     c[0] = P[n]   c[1] = c[0] + alpha a[n]   c[2] = c[1] - alpha^2 a[n-1] + eta a[n]
 *
 * alpha = 1 and eta = 2 is C2. The points after these are free.
 *
 *   range   degree 2..9, otherwise LOFT_ERR_ARG; any alpha, but only alpha > 0 keeps the tangent;
 *           LOFT_ERR_RANGE if a point does not fit or, in floats, a number fails loft_exact_valid.
 *           c[] is untouched after an error
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp of the result   f64: 1 ulp of the result
 *   cost    4 exact products and 2 quotients per axis
 *   see     Farin, ch. 11: osculants and G2
 */
enum loft_status loft_join_continue(const loft_bezier *p, loft_real alpha, loft_real eta,
                                    loft_vec c[3]) LOFT_CHECKED;

LOFT_END_C

#endif
