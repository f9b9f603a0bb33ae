/* lib/num/walk2.h -- forward differencing of a polynomial in two variables, in one coordinate
 * SPDX-License-Identifier: MIT
 *
 * The state is d[l][k], the k-th difference from row to row of the l-th difference along the row.
 * It is stored column by column, l = 0..q, each with its k = 0..p. A step to the next row is
 * d[l][k] += d[l][k+1]. The row itself is then a walk with the differences d[l][0] (num/walk.h).
 * surface/tensor/grid.h walks all coordinates of a patch with it.
 *
 *   square     degrees p and q: B(u, v) of a net of (p + 1) (q + 1) values, row by row
 *   triangle   total degree p = q: column l has only k = 0 .. p - l; row r of the net has r + 1
 *              values
 *   blend      a square whose inner control values are ignored: the bilinear blend of the four
 *              edges of the net (Coons), which has no terms with both k and l above 1
 */
#ifndef LOFT_NUM_WALK2_H
#define LOFT_NUM_WALK2_H

#include "num/walk.h"   /* loft_state, LOFT_WALK_DEGREE_MAX */

LOFT_BEGIN_C

typedef struct {
    uint32_t rows, columns;     /* steps from row to row, and along the last row */
    uint8_t p, q;
    bool triangle, blend;       /* at most one of them */
} loft_walk2;

/* The number of differences in column l above the 0-th, and the index of the column in the
 * state. */
static inline unsigned loft_walk2_degree(const loft_walk2 *s, unsigned l)
{
    return s->triangle ? s->p - l : s->p;
}
static inline size_t   loft_walk2_column(const loft_walk2 *s, unsigned l)
{
    return s->triangle ? l * (s->p + 1u) - l * (l - 1u) / 2 : l * (s->p + 1u);
}

/* True if these numbers of steps are within the law of ranges (walk2.c). All >= 1, degrees up to
 * LOFT_WALK_DEGREE_MAX. */
bool loft_walk2_steps_valid(const loft_walk2 *s);

/* True if it is a valid control value for such a walk. f32, f64: within LOFT_REAL_MAX / 2^32, so
 * that no sum overflows. */
bool loft_walk2_valid(loft_real a);

/* Start at the first value of the net net[0], net[stride] .. in the order above.
 *
 *   range   valid numbers of steps, valid values
 *   error   q16: 2^-33 + 2^-44 LSB in each difference; none where rows^p columns^q (triangle:
 *           rows^p; blend: both rows^p columns and rows columns^q) divides 2^32
 *           f32, f64: 2^(p + q + 3) ulp of double of the largest value
 *   cost    q16: (p + 1) (q + 1) (p + q) / 2 divisions of 128 by 32 bits, shifts for powers of two
 *   stack   Cortex-M4 476   Cortex-M0+ 572   ATmega328P 467
 */
void loft_walk2_init(loft_state d[], const loft_walk2 *s, const loft_real net[], size_t stride);

/* Step to the next row. */
void loft_walk2_step(loft_state d[], const loft_walk2 *s);

LOFT_END_C

#endif
