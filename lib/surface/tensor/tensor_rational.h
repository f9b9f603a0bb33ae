/* lib/surface/tensor/tensor_rational.h -- rational tensor-product patches of degrees 0..9 x 0..9:
 * points, derivatives, pieces
 * SPDX-License-Identifier: MIT
 *
 * As surface/tensor/tensor.h, with a weight for every control point (curve/rational.h has the range
 * of weights in q16). Control points lie in space; they are not multiplied by their weights. In the
 * `error` lines R is the largest weight over the smallest, at most 65536, and ulp is that of the
 * largest control value.
 *
 *     loft_tensor_rational s;                 // a cylinder, a torus, a piece of a sphere ..
 *     if (loft_tensor_rational_init(&s, net, 2, 1) == LOFT_OK)
 *         p = loft_tensor_rational_eval(&s, u, v);
 */
#ifndef LOFT_SURFACE_TENSOR_TENSOR_RATIONAL_H
#define LOFT_SURFACE_TENSOR_TENSOR_RATIONAL_H

#include "curve/rational.h"     /* loft_weighted, LOFT_ELEVATE_MAX */
#include "geom/vec.h"           /* loft_vec, loft_box */

LOFT_BEGIN_C

/* A patch. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_weighted *p;
    int32_t scale;              /* a power of two; scale * the largest weight is in 2^14 .. 2^15 */
    uint8_t m, n;               /* the degrees along u and v */
} loft_tensor_rational;

/* Make a patch of (m + 1) (n + 1) control points, row by row, which must outlive it.
 *
 *   range   degrees 0..9, otherwise LOFT_ERR_ARG; weights 1/256..256 and finite coordinates,
 *           otherwise LOFT_ERR_RANGE; *s is then untouched
 *   error   none: nothing is rounded
 *   cost    one check per coordinate and weight
 */
enum loft_status loft_tensor_rational_init(loft_tensor_rational *s, const loft_weighted p[],
                                           unsigned m, unsigned n) LOFT_CHECKED;

/* The point at (u, v), by de Casteljau's algorithm for numerator and denominator.
 *
 *   range   u and v are clamped to 0..1 (NaN to 0): cannot fail
 *   error   q16: 1/2 LSB + (m + n) R * 2^-30 LSB, below 0.502 LSB; exact at the corners
 *           f32: 1 ulp   f64: 6 (m + n) + 4 ulp
 *   cost    LOFT_AXES + 1 times (n + 1) m (m + 1) / 2 + n (n + 1) / 2 wide lerps, a quotient per
 *           axis; safe in an ISR
 *   stack   Cortex-M4 280   Cortex-M0+ 372   ATmega328P 285
 *   see     Farin, Curves and Surfaces for CAGD, ch. 16: rational Bezier surfaces
 */
loft_vec loft_tensor_rational_eval(const loft_tensor_rational *s, loft_unit u, loft_unit v);

/* The derivatives by u and by v.
 *
 *   range   u, v in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when one does not fit (it may be
 *           degree * R times the distance of two points), or for f32, f64 absolute coordinates of
 *           2^100 and more; nothing is then written
 *   error   with d the larger degree, q16: 1/2 LSB + d (m + n) R * 2^-26 LSB
 *           f32, f64: 1/2 ulp of the result + 32 d (m + n + 1) R ulp of double
 *   cost    that of loft_tensor_rational_differential (surface/differential.h)
 */
enum loft_status loft_tensor_rational_deriv(const loft_tensor_rational *s, loft_unit u, loft_unit v,
                                            loft_vec *by_u, loft_vec *by_v) LOFT_CHECKED;


/* Pieces and other forms
 * ----------------------
 * Nets are undefined after an error. A piece may replace the net itself. Points err as those of the
 * curves (curve/rational.h). Weights err by 1/2 LSB in q16, which may move the piece by more. */

/* The nets of the pieces 0..t and t..1 in u, or in v. `left` and `right` must differ.
 *
 *   range   that of loft_rational_split: t in -1..2, otherwise LOFT_ERR_ARG
 *   error   that of loft_rational_split, per control point
 *   cost    that of loft_rational_split for each column, or row
 */
enum loft_status loft_tensor_rational_split_u(const loft_tensor_rational *s, loft_unit t,
                                              loft_weighted left[],
                                              loft_weighted right[]) LOFT_CHECKED;
enum loft_status loft_tensor_rational_split_v(const loft_tensor_rational *s, loft_unit t,
                                              loft_weighted left[],
                                              loft_weighted right[]) LOFT_CHECKED;

/* The same patch with the degree in u, or in v, higher by `times`. `out` must not overlap the net.
 *
 *   range   the degree + times <= LOFT_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   that of loft_rational_elevate, per control point
 *   cost    that of loft_rational_elevate for each column, or row
 */
enum loft_status loft_tensor_rational_elevate_u(const loft_tensor_rational *s, unsigned times,
                                                loft_weighted out[]) LOFT_CHECKED;
enum loft_status loft_tensor_rational_elevate_v(const loft_tensor_rational *s, unsigned times,
                                                loft_weighted out[]) LOFT_CHECKED;

/* The box of the net. The patch over 0..1 x 0..1 lies inside, even when rounded (f64: up to the
 * error of eval).
 *
 *   error   none
 *   cost    2 comparisons per coordinate
 */
loft_box loft_tensor_rational_box(const loft_tensor_rational *s);

LOFT_END_C

#endif
