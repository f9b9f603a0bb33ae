/* lib/polygon/multiindex.h -- multi-indices: the names of the control points of an S-patch
 * SPDX-License-Identifier: MIT
 *
 * A multi-index is a row of `sides` numbers l[0], l[1] .. >= 0 that sum to `depth`. They are
 * ordered from (depth, 0 .. 0) to (0 .. 0, depth): first by descending l[0], then by descending
 * l[1], and so on. The rank of a multi-index is its place in that order.
 *
 *     uint8_t l[LOFT_SIDES_MAX];
 *     loft_multiindex_first(l, sides, depth);
 *     do { .. } while (loft_multiindex_next(l, sides));
 *
 *   range   sides 2..8, depth 0..10
 */
#ifndef LOFT_POLYGON_MULTIINDEX_H
#define LOFT_POLYGON_MULTIINDEX_H

#include "basis/bernstein.h"    /* loft_binomial */
#include "polygon/domain.h"     /* LOFT_SIDES_MAX */

LOFT_BEGIN_C

/* The number of multi-indices: C(sides + depth - 1, depth), at most 19448.
 *
 *   error   none
 *   cost    `depth` products and divisions of 32 bits
 */
static inline unsigned loft_multiindex_count(unsigned sides, unsigned depth)
{
    return (unsigned)loft_binomial(sides + depth - 1, depth);
}

/* Set l to (depth, 0 .. 0).
 *
 *   error   none
 *   cost    no product
 */
void loft_multiindex_first(uint8_t l[], unsigned sides, unsigned depth);

/* Set l to the next multi-index. False, and l untouched, after the last.
 *
 *   error   none
 *   cost    at most `sides` comparisons, no product
 */
bool loft_multiindex_next(uint8_t l[], unsigned sides);

/* The rank of l, from 0.
 *
 *   error   none
 *   cost    at most sides (sides - 1) / 2 products and divisions of 32 bits
 */
unsigned loft_multiindex_rank(const uint8_t l[], unsigned sides);

/* depth! / (l[0]! l[1]! ..), at most 10!.
 *
 *   error   none
 *   cost    depth + sides products and `depth` divisions of 32 bits
 */
int32_t loft_multiindex_multinomial(const uint8_t l[], unsigned sides);

LOFT_END_C

#endif
