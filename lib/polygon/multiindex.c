/* lib/polygon/multiindex.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/multiindex.h"

void loft_multiindex_first(uint8_t l[], unsigned sides, unsigned depth)
{
    for (unsigned i = 0; i < sides; i++)
        l[i] = 0;
    l[0] = (uint8_t)depth;
}

/* The last number that can pass one on does so; the number at the end moves next to it. */
bool loft_multiindex_next(uint8_t l[], unsigned sides)
{
    unsigned i = sides - 1;
    const uint8_t tail = l[sides - 1];

    do {
        if (i == 0)
            return false;
    } while (l[--i] == 0);
    l[sides - 1] = 0;
    l[i]--;
    l[i + 1] = (uint8_t)(tail + 1);
    return true;
}

/* Among the indices with the same first i numbers, those before l leave less to the
 * k = sides - 1 - i numbers after number i than l does, `left`. Their count is the sum of
 * C(s + k - 1, k - 1) for s < left, which is C(left - 1 + k, k). */
unsigned loft_multiindex_rank(const uint8_t l[], unsigned sides)
{
    unsigned left = 0, rank = 0;

    for (unsigned i = sides - 1; i > 0; i--) {
        left += l[i];
        if (left > 0)
            rank += (unsigned)loft_binomial(left - 1 + sides - i, sides - i);
    }
    return rank;
}

int32_t loft_multiindex_multinomial(const uint8_t l[], unsigned sides)
{
    unsigned sum = 0;
    int32_t ways = 1;

    for (unsigned i = 0; i < sides; i++) {
        sum += l[i];
        ways *= loft_binomial(sum, l[i]);
    }
    return ways;
}
