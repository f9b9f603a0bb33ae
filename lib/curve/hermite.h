/* lib/curve/hermite.h -- Hermite curves: points and derivatives at both ends, cubic and quintic
 * SPDX-License-Identifier: MIT
 *
 * Plain data, no init: fill the fields.
 *
 *     const loft_hermite h = { p0, p1, t0, t1 };
 *     loft_cubic c;
 *     if (loft_cubic_from_hermite(&h, &c) == LOFT_OK) ..      // walk it, flatten it, plan it
 *
 * Control points of a cubic reach up to 4/3 of the range of the data (p0 + t0 / 3). Points and
 * control points may therefore be out of range although all data are within it. Such a result is
 * reported, never wrapped. In the `error` lines L = |1 - t| + |t|, and ulp is that of the largest
 * given coordinate. f64 accepts coordinates below 2^1000.
 */
#ifndef LOFT_CURVE_HERMITE_H
#define LOFT_CURVE_HERMITE_H

#include "curve/bezier.h"       /* loft_cubic, loft_vec */

LOFT_BEGIN_C

/* p(0), p(1), p'(0), p'(1) */
typedef struct {
    loft_vec p0, p1, t0, t1;
} loft_hermite;

/* and p''(0), p''(1) */
typedef struct {
    loft_vec p0, p1, t0, t1, a0, a1;
} loft_hermite5;

/* The point at t.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point does not fit. *out is
 *           untouched after an error
 *   error   n = 3 or 5, q16: 1/2 LSB + (L^n + 1 + L + .. + L^(n-1)) * 2^-17 LSB, exact at 0 and 1
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: (6 n + 4) L^n ulp
 *   cost    n (n + 1) / 2 wide lerps per axis; safe in an ISR
 *   see     Farin, Curves and Surfaces for CAGD, ch. 7
 */
enum loft_status loft_hermite_eval(const loft_hermite *h, loft_unit t, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_hermite5_eval(const loft_hermite5 *h, loft_unit t,
                                    loft_vec *out) LOFT_CHECKED;

/* The k-th derivative with respect to t; 0 for k above the degree.
 *
 *   range   as eval
 *   error   n = 3 or 5, m = n - k, k > 0, q16: 1/2 LSB + (1 + L + .. + L^(m-1)) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 3 n 2^n L^m (n!/m!) ulp
 *   cost    as eval
 */
enum loft_status loft_hermite_deriv(const loft_hermite *h, unsigned k, loft_unit t,
                                    loft_vec *out) LOFT_CHECKED;
enum loft_status loft_hermite5_deriv(const loft_hermite5 *h, unsigned k, loft_unit t,
                                     loft_vec *out) LOFT_CHECKED;

/* The control points of the curve: 4, or 6 for degree 5.
 *
 *   range   LOFT_ERR_RANGE if one does not fit; *out is undefined then
 *   error   q16: 1/2 LSB + 2^-17 LSB, none at the ends   f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: 3 ulp
 *   cost    2 or 4 divisions by small numbers per axis
 */
enum loft_status loft_cubic_from_hermite(const loft_hermite *h, loft_cubic *out) LOFT_CHECKED;
enum loft_status loft_bezier_from_hermite5(const loft_hermite5 *h, loft_vec out[6]) LOFT_CHECKED;

LOFT_END_C

#endif
