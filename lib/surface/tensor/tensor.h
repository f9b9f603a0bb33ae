/* lib/surface/tensor/tensor.h -- tensor-product Bezier patches of degrees 0..9 x 0..9: points,
 * derivatives, pieces
 * SPDX-License-Identifier: MIT
 *
 * A net has (m + 1) (n + 1) control points b_ij, row by row. The outer index i = 0..m runs along u,
 * the inner index j = 0..n along v. Row i begins at p[(n + 1) i]. The patch over 0..1 x 0..1 is
 *
 *     P(u, v) = sum B_i(u) B_j(v) b_ij
 *
 *     loft_tensor s;
 *     if (loft_tensor_init(&s, net, 3, 3) == LOFT_OK)
 *         p = loft_tensor_eval(&s, loft_unit_of(1, 3), LOFT_UNIT(0.5));
 *
 * Points and derivatives are computed wide and rounded once. Functions that give another net work
 * curve by curve: each row or column is a loft_bezier, and the errors are those of its functions.
 * In the `error` lines ulp is that of the largest control value. Coordinates are accepted as in
 * curve/bezier.h.
 */
#ifndef LOFT_SURFACE_TENSOR_TENSOR_H
#define LOFT_SURFACE_TENSOR_TENSOR_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "curve/bezier.h"       /* LOFT_BEZIER_ELEVATE_MAX */
#include "geom/vec.h"           /* loft_vec, loft_box */

LOFT_BEGIN_C

/* A patch. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t m, n;               /* the degrees along u and v */
} loft_tensor;

/* Make a patch of (m + 1) (n + 1) control points, which must outlive it.
 *
 *   range   degrees 0..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise LOFT_ERR_RANGE; *s
 *           is then untouched
 *   error   none: nothing is rounded
 *   cost    one check per coordinate
 */
enum loft_status loft_tensor_init(loft_tensor *s, const loft_vec p[], unsigned m,
                                  unsigned n) LOFT_CHECKED;

/* The point at (u, v), by de Casteljau's algorithm along u and then along v. The error bound holds
 * in either order.
 *
 *   range   u and v are clamped to 0..1 (NaN to 0): cannot fail
 *   error   q16: 1/2 LSB + (m + n) * 2^-17 LSB, exact at the corners   f32: 1 ulp   f64: 3 (m + n)
 *           ulp
 *   cost    (n + 1) m (m + 1) / 2 + n (n + 1) / 2 wide lerps per axis; safe in an ISR
 *   stack   Cortex-M4 288   Cortex-M0+ 364   ATmega328P 278
 *   see     Farin, Curves and Surfaces for CAGD, ch. 14: tensor product patches
 */
loft_vec loft_tensor_eval(const loft_tensor *s, loft_unit u, loft_unit v);

/* The derivative of order a by u and b by v: (1, 0) and (0, 1) are the tangents, (1, 1) the twist.
 *
 *   range   u, v in 0..1, a + b <= 9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when it does not fit;
 *           *out is then untouched
 *   error   with f = m! / (m - a)! n! / (n - b)!, q16: 1/2 LSB + f (m + n - a - b) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp (a + b <= 2)
 *           f64: f 2^(a + b) (3 (m + n) + 2) ulp
 *   cost    differences, then as eval for lower degrees
 *   see     Farin, ch. 14: partial and mixed derivatives
 */
enum loft_status loft_tensor_deriv(const loft_tensor *s, unsigned a, unsigned b, loft_unit u,
                                   loft_unit v, loft_vec *out) LOFT_CHECKED;

/* The curve of constant u, or of constant v: n + 1, or m + 1, control points. At 0 and 1 these are
 * exactly the edges.
 *
 *   range   the parameter is clamped to 0..1
 *   error   per control point q16: 1/2 LSB + degree * 2^-17 LSB   f32: 1 ulp   f64: 3 degree ulp,
 *           with the degree in the other direction
 *   cost    a point of each column, or row
 */
void loft_tensor_at_u(const loft_tensor *s, loft_unit u, loft_vec out[]);
void loft_tensor_at_v(const loft_tensor *s, loft_unit v, loft_vec out[]);


/* Pieces and other forms
 * ----------------------
 * Nets are undefined after an error. A piece may replace the net itself. */

/* The nets of the pieces 0..t and t..1 in u, or in v. `left` and `right` must differ.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a point does not fit
 *   error   that of loft_bezier_split, per control point
 *   cost    that of loft_bezier_split for each column, or row
 */
enum loft_status loft_tensor_split_u(const loft_tensor *s, loft_unit t, loft_vec left[],
                                     loft_vec right[]) LOFT_CHECKED;
enum loft_status loft_tensor_split_v(const loft_tensor *s, loft_unit t, loft_vec left[],
                                     loft_vec right[]) LOFT_CHECKED;

/* The net of the piece from..to in u, or in v. from > to reverses it; 1 to 0 is exact.
 *
 *   range   both in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a point does not fit
 *   error   that of loft_bezier_sub, per control point
 *   cost    that of loft_bezier_sub for each column, or row
 */
enum loft_status loft_tensor_sub_u(const loft_tensor *s, loft_unit from, loft_unit to,
                                   loft_vec out[]) LOFT_CHECKED;
enum loft_status loft_tensor_sub_v(const loft_tensor *s, loft_unit from, loft_unit to,
                                   loft_vec out[]) LOFT_CHECKED;

/* The same patch with the degree in u, or in v, higher by `times`. `out` must not overlap the net.
 *
 *   shape   (m + times + 1) (n + 1), or (m + 1) (n + times + 1), points
 *   range   the degree + times <= LOFT_BEZIER_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   that of loft_bezier_elevate, per control point
 *   cost    that of loft_bezier_elevate for each column, or row
 */
enum loft_status loft_tensor_elevate_u(const loft_tensor *s, unsigned times,
                                       loft_vec out[]) LOFT_CHECKED;
enum loft_status loft_tensor_elevate_v(const loft_tensor *s, unsigned times,
                                       loft_vec out[]) LOFT_CHECKED;

/* The net with u and v exchanged: (n + 1) (m + 1) points. `out` must not overlap the net.
 *
 *   error   none
 *   cost    one copy of the net
 */
void loft_tensor_transpose(const loft_tensor *s, loft_vec out[]);

/* The box of the net. The patch over 0..1 x 0..1 lies inside, even when rounded (f64: up to the
 * error of eval). The box need not be the smallest.
 *
 *   error   none
 *   cost    2 comparisons per coordinate
 */
loft_box loft_tensor_box(const loft_tensor *s);

LOFT_END_C

#endif
