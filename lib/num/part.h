/* lib/num/part.h -- products of 32 and 16 bits, for loops that are run often on small chips
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUM_PART_H
#define LOFT_NUM_PART_H

#include "num/num.h"    /* int32_t */

LOFT_BEGIN_C

#define LOFT_PART_ONE ((int32_t)1 << 15)

/* a b / 2^16, rounded down.
 *
 *   range   |b| <= 2^15
 *   cost    a Cortex-M0 and an AVR have no product of 64 bits: two of 32, as their high halves are
 *           not needed
 */
static inline int32_t loft_part(int32_t a, int32_t b)
{
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
    return (a >> 16) * b + (((a & 0xffff) * b) >> 16);
#else
    return (int32_t)(((int64_t)a * b) >> 16);
#endif
}

/* x 2^n, at most 2^30; x >= 0. */
static inline int32_t loft_part_scaled(int32_t x, int n)
{
    const int32_t full = INT32_C(1) << 30;

    if (n <= 0)
        return n > -31 ? x >> -n : 0;
    return n < 30 && x < full >> n ? (int32_t)((uint32_t)x << n) : full;
}

/* How often x may be doubled so that it stays below 2^30; x > 0. */
static inline int loft_doublings(uint32_t x)
{
#if defined(__GNUC__) && !defined(__AVR__)
    const int n = __builtin_clz(x) - 2;
    return n > 0 ? n : 0;
#else
    int n = 0;

    while (n < 29 && x >> (29 - n) == 0)
        n++;
    return n;
#endif
}

/* 2^29 / sqrt m, never too large.
 *
 *   range   2^28 <= m <= 2^30
 *   error   2^-10 of it
 *   cost    a product
 */
int32_t loft_part_root(uint32_t m);

/* 2^44 / sqrt m.
 *
 *   range   2^28 <= m < 2^30
 *   error   2^-27 of it
 *   cost    4 products, one of them of 64 bits
 */
int32_t loft_part_root_fine(uint32_t m);

LOFT_END_C

#endif
