/* lib/surface/triangle/triangle_shape.h -- exact tests of polynomials over a triangle: positive,
 * convex
 * SPDX-License-Identifier: MIT
 *
 * A polynomial of degree n over a triangle has coefficients b_ijk, i + j + k = n, listed with i
 * descending, then j descending: 200 110 101 020 011 002. Every decision is a sign of whole numbers
 * (num/exact.h), computed from the coefficients as given. In f32 and f64 loft_exact_valid must
 * accept them, otherwise LOFT_ERR_RANGE; nothing is then written.
 *
 *     loft_net_convexity c;
 *     if (loft_triangle_convex(height, 3, &c) == LOFT_OK && c.weak)   // the cubic is convex
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_SHAPE_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_SHAPE_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "num/num.h"            /* loft_real */

LOFT_BEGIN_C

/* The sign of A u1^2 + B u2^2 + C u3^2 + 2 a u2 u3 + 2 b u3 u1 + 2 c u1 u2. */
typedef struct {
    bool nonnegative;       /* >= 0 on the closed triangle: edges, and roots or determinant */
    bool edges;             /* >= 0 on the three edges */
    bool roots;             /* A, B, C >= 0 and sqrt(A B C) + a sqrt A + b sqrt B + c sqrt C >= 0 */
    bool determinant;       /* A B C + 2 a b c - A a^2 - B b^2 - C c^2 >= 0 */
} loft_triangle_sign;

/* Decide on the polynomial of degree 2 with the coefficients A c b B a C, in the order above.
 *
 *   error   none
 *   cost    about 40 exact products; not for an ISR
 *   stack   Cortex-M4 1,832   Cortex-M0+ 1,840   ATmega328P 1,855
 *   see     Hadeler, On copositive matrices (1983); Chang, Mathematics of Surfaces, ch. 7: theorem
 *           7.2
 */
enum loft_status loft_triangle2_sign(const loft_real b[6], loft_triangle_sign *out) LOFT_CHECKED;

/* A sufficient, not necessary, test for >= 0 in any degree: the three sums
 *
 *     L1 = b_n00 + (n-1)! sum over b_ijk < 0 of i / (i! j! k!) b_ijk
 *
 * are all >= 0. L2 and L3 have j and k in place of i.
 *
 *   range   degree 1..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a sum does not fit: the flag
 *           is then right and that sum is 0
 *   error   flag: none; sums q16: none   f32, f64: 0.51 ulp, 1 in f64
 *   cost    one small product and a sum per coefficient and corner, three quotients
 *   see     Wang and Liu; Chang, ch. 7: theorem 7.1
 */
enum loft_status loft_triangle_wang_liu(const loft_real b[], unsigned degree, bool *nonnegative,
                                        loft_real sums[3]) LOFT_CHECKED;

/* The shape of a net over its triangle. Mesh lines of direction 0 have constant i and run from T2
 * to T3, those of direction 1 run from T3 to T1, those of direction 2 from T1 to T2. */
typedef struct {
    bool net;               /* the net of control points is convex, and so is the polynomial */
    bool weak;              /* implies a convex polynomial; for degrees up to 3 equivalent to it */
    bool line[3];           /* every mesh line of the direction is convex */
    int8_t trend[3];        /* 1: all ascend, -1: all descend, 0: all level, or LOFT_TREND_NONE */
} loft_net_convexity;

#define LOFT_TREND_NONE 9

/* E1, E2, E3 increase i, j, k by one. At each index of degree n - 2
 *
 *     D1 = (E1 - E2) (E1 - E3) b     D2 = (E2 - E3) (E2 - E1) b     D3 = (E3 - E1) (E3 - E2) b
 *
 * net: all D >= 0. weak: D1 + D2, D2 + D3, D3 + D1 >= 0 and D1 D2 + D2 D3 + D3 D1 >= 0: the second
 * derivatives with these coefficients are positive semidefinite.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG. Up to degree 1 all is convex
 *   error   none
 *   cost    three exact products per index: 108 for degree 9; not for an ISR
 *   stack   Cortex-M4 1,112   Cortex-M0+ 1,156   ATmega328P 1,077
 *   see     Chang and Davis, The convexity of Bernstein polynomials over triangles (1984); Chang
 *           and Feng, An improved condition for the convexity of Bernstein-Bezier surfaces over
 *           triangles (1984); Chang, ch. 8
 */
enum loft_status loft_triangle_convex(const loft_real b[], unsigned degree,
                                      loft_net_convexity *out) LOFT_CHECKED;

LOFT_END_C

#endif
