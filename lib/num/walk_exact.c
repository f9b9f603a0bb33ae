/* lib/num/walk_exact.c -- the differences of a polynomial as integers and remainders
 * SPDX-License-Identifier: MIT
 *
 * The j-th difference of i^k at i = 0 is c(k, j) = j! S(k, j), the number of ways to map k things
 * onto j (S: Stirling numbers of the second kind). A walk of n steps along sum_k g_k t^k therefore
 * starts with
 *
 *     e_j = sum_k  g_k c(k, j) / n^k
 *
 * g and c are integers, |g_k c(k, j)| < 2^45, and Horner's scheme in 1/n gives e_j without
 * rounding: if V = I + R / n^s then
 *
 *     V / n = floor(I / n) + (R + (I mod n) n^s) / n^(s+1)
 *
 * After `degree` divisions R < n^degree < 2^63. The sum of two remainders is below 2^64; its excess
 * over n^degree is carried to the integers. The integers may wrap: the value is correct modulo 2^32
 * and fits 32 bits. Half of n^degree is added once to the remainder of the value, so that dropping
 * the remainder rounds to nearest.
 */
#include "num/walk_exact.h"

bool loft_walk_exact_steps_valid(unsigned degree, uint32_t n)
{
    const uint64_t limit = (uint64_t)INT64_MAX;
    uint64_t power = 1;

    for (unsigned k = 0; k < degree; k++) {
        if (power > limit / n)
            return false;
        power *= n;
    }
    return true;
}

uint64_t loft_walk_exact_power(unsigned degree, uint32_t n)
{
    uint64_t power = 1;

    while (degree--)
        power *= n;
    return power;
}

#if LOFT_NUM == LOFT_Q16

/* c(k, j) for j <= k <= 5. */
static const uint8_t onto_maps[LOFT_WALK_DEGREE_MAX + 1][LOFT_WALK_DEGREE_MAX + 1] = {
    { 1 }, { 0, 1 }, { 0, 1, 2 }, { 0, 1, 6, 6 }, { 0, 1, 14, 36, 24 }, { 0, 1, 30, 150, 240, 120 }
};

/* e_j, j >= 1, as an integer and a remainder over n^degree. */
static int64_t exact_difference(const loft_acc g[], unsigned degree, unsigned j, uint32_t n,
                                uint64_t *rest)
{
    int64_t whole = 0;
    uint64_t power = 1;

    *rest = 0;
    for (unsigned k = degree; k >= 1; k--) {
        whole += g[k] * onto_maps[k][j];
        int64_t quotient = whole / n, left = whole - quotient * n;
        if (left < 0) {
            left += n;
            quotient--;
        }
        *rest += (uint64_t)left * power;
        power *= n;
        whole = quotient;
    }
    return whole;
}

void loft_walk_exact_init(loft_walk_exact *s, const loft_real p[], unsigned degree, uint32_t n)
{
    loft_acc g[LOFT_WALK_DEGREE_MAX + 1];

    loft_walk_powers(g, p, degree);
    s->whole[0] = (uint32_t)p[0];
    s->rest[0] = loft_walk_exact_power(degree, n) / 2;
    for (unsigned j = 1; j <= LOFT_WALK_DEGREE_MAX; j++) {
        s->whole[j] = 0;
        s->rest[j] = 0;
        if (j <= degree)
            s->whole[j] = (uint32_t)exact_difference(g, degree, j, n, &s->rest[j]);
    }
}

#else

void loft_walk_exact_init(loft_walk_exact *s, const loft_real p[], unsigned degree, uint32_t n)
{
    loft_powers powers;

    loft_powers_init(&powers, degree, n);
    loft_walk_init(s, p, degree, &powers);
}

#endif
