/* lib/surface/triangle/triangle_operator.h -- the Bernstein operator over a triangle, iterated
 * SPDX-License-Identifier: MIT
 *
 * basis/bernstein_operator.h does the same over an interval. The operator replaces a function on a
 * triangle by the polynomial of its samples at the nodes (i/n, j/n, k/n). The corners stay,
 * everything else is averaged, and the limit is the plane through the corners.
 */
#ifndef LOFT_SURFACE_TRIANGLE_TRIANGLE_OPERATOR_H
#define LOFT_SURFACE_TRIANGLE_TRIANGLE_OPERATOR_H

#include "basis/bernstein_operator.h"   /* LOFT_FOREVER */
#include "surface/barycentric.h"        /* loft_bary */

LOFT_BEGIN_C

/* The value at u of the operator applied `times` times to the function with the samples f, in the
 * order of a net of degree n. LOFT_FOREVER gives the limit.
 *
 *   shape   f[LOFT_TRIANGLE_POINTS(n)]
 *   range   n in 1..9, times >= 1, otherwise LOFT_ERR_ARG; finite samples, otherwise
 *           LOFT_ERR_RANGE; u is clamped to the triangle; *value is untouched after an error
 *   error   with s = n^4 / (3 n - 3), 0 for n = 1, for any number of times: q16: 1/2 LSB + (n + s)
 *           * 2^-17 LSB, below 0.503 LSB f32: 1 ulp   f64: 4 (n + s) ulp, of the largest sample
 *   cost    about n^5 / 12 small products and a third as many divisions per round, for at most 512
 *           rounds; none for more
 *   see     Chang, Mathematics of Surfaces, ch. 6; Kelisky, Rivlin, Iterates of Bernstein
 *           polynomials (1967)
 */
enum loft_status loft_triangle_iterate(const loft_real f[], unsigned n, uint32_t times, loft_bary u,
                                       loft_real *value) LOFT_CHECKED;

/* The same polynomial, also outside the triangle; L = |u| + |v| + |w|.
 *
 *   range   LOFT_ERR_RANGE when the value does not fit, when L^n exceeds 19683 (L itself after
 *           more than 512 times), or when |v| or |w| exceeds 32; otherwise as iterate
 *   error   with s of iterate, q16: 1/2 LSB + (s L^n + 1 + L + .. + L^(n-1)) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp   f64: 4 (n + s) L^n ulp, of the largest sample
 *   cost    as iterate
 */
enum loft_status loft_triangle_iterate_extrapolate(const loft_real f[], unsigned n, uint32_t times,
                                                   loft_bary u, loft_real *value) LOFT_CHECKED;

LOFT_END_C

#endif
