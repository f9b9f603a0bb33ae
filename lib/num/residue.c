/* lib/num/residue.c
 * SPDX-License-Identifier: MIT
 *
 * Primes are taken downward from 2^31. There are about 2^31 / 21.5 of them below that, and none is
 * used twice. The test of Miller and Rabin with the bases 2, 3, 5 and 7 is exact below 3.2e9
 * (Jaeschke 1993).
 *
 * The sign of an integer v, |v| < M / 2, M the product of the primes: v or M + v is d_0 + d_1 p_0 +
 * d_2 p_0 p_1 + .. with digits d_i < p_i. (M - 1) / 2 has the digits (p_i - 1) / 2, and v is
 * negative if its digits, compared from the last, are larger.
 */
#include "num/residue.h"

static uint32_t mul_mod(uint32_t a, uint32_t b, uint32_t m)
{
    return (uint32_t)((uint64_t)a * b % m);
}

static uint32_t pow_mod(uint32_t a, uint32_t k, uint32_t m)
{
    uint32_t y = 1;

    for (; k > 0; k /= 2, a = mul_mod(a, a, m))
        if (k % 2)
            y = mul_mod(y, a, m);
    return y;
}

static bool passes_base(uint32_t n, uint32_t base)
{
    uint32_t odd = n - 1, twos = 0;

    for (; odd % 2 == 0; odd /= 2)
        twos++;
    uint32_t y = pow_mod(base, odd, n);
    if (y == 1 || y == n - 1)
        return true;
    for (; twos > 1; twos--) {
        y = mul_mod(y, y, n);
        if (y == n - 1)
            return true;
    }
    return false;
}

static bool is_prime(uint32_t n)
{
    return passes_base(n, 2) && passes_base(n, 3) && passes_base(n, 5) && passes_base(n, 7);
}

void loft_residue_start(loft_residue *r, uint32_t bits)
{
    r->prime = (uint32_t)1 << 31;
    r->left = (unsigned)(bits / 30 + 1);
}

bool loft_residue_next(loft_residue *r)
{
    if (r->left == 0)
        return false;
    r->left--;
    r->prime -= r->prime % 2 ? 2 : 1;
    while (!is_prime(r->prime))
        r->prime -= 2;
    return true;
}

void loft_residue_skip(loft_residue *r) { r->left++; }

uint32_t loft_residue_exact(const loft_residue *r, const loft_exact *x)
{
    const bool minus = loft_exact_sign(*x) < 0;
    const loft_exact size = minus ? loft_exact_neg(*x) : *x;
    uint64_t rest = 0;

    for (int i = LOFT_EXACT_LIMBS - 1; i >= 0; i--)
        rest = ((rest << 32) | size.limb[i]) % r->prime;
    return minus && rest ? r->prime - (uint32_t)rest : (uint32_t)rest;
}

uint32_t loft_residue_real(const loft_residue *r, loft_real a)
{
    const loft_exact x = loft_exact_from_real(a);
    return loft_residue_exact(r, &x);
}

uint32_t loft_residue_unit(const loft_residue *r, loft_unit t)
{
    const loft_exact x = loft_exact_from_unit(t);
    return loft_residue_exact(r, &x);
}

uint32_t loft_residue_one(const loft_residue *r) { return loft_residue_unit(r, LOFT_UNIT(1)); }

uint32_t loft_residue_add(const loft_residue *r, uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a + b) % r->prime);
}

uint32_t loft_residue_sub(const loft_residue *r, uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a + r->prime - b) % r->prime);
}

uint32_t loft_residue_mul(const loft_residue *r, uint32_t a, uint32_t b)
{
    return mul_mod(a, b, r->prime);
}

uint32_t loft_residue_inverse(const loft_residue *r, uint32_t a)
{
    return pow_mod(a, r->prime - 2, r->prime);
}

uint32_t loft_residue_radix(const loft_residue *r, const uint32_t prime[], unsigned at)
{
    uint32_t product = 1;

    for (unsigned i = 0; i < at; i++)
        product = mul_mod(product, prime[i] % r->prime, r->prime);
    return loft_residue_inverse(r, product);
}

uint32_t loft_residue_digit(const loft_residue *r, const uint32_t prime[], const uint32_t digit[],
                            unsigned at, uint32_t radix, uint32_t remainder)
{
    uint32_t known = 0;

    for (unsigned i = at; i-- > 0; )        /* d_0 + p_0 (d_1 + p_1 (..)) */
        known = (uint32_t)(((uint64_t)known * prime[i] + digit[i]) % r->prime);
    return mul_mod(loft_residue_sub(r, remainder, known), radix, r->prime);
}

int loft_residue_sign(const uint32_t prime[], const uint32_t digit[], unsigned primes)
{
    bool any = false;

    for (unsigned i = primes; i-- > 0; ) {
        const uint32_t half = (prime[i] - 1) / 2;
        if (digit[i] > half)
            return -1;
        any = any || digit[i] != 0;
        if (digit[i] < half)
            break;
    }
    for (unsigned i = 0; i < primes && !any; i++)
        any = digit[i] != 0;
    return any;
}

static uint32_t minor2(const loft_residue *r, uint32_t v[][3], unsigned i, unsigned j)
{
    return loft_residue_sub(r, mul_mod(v[i][1], v[j][2], r->prime),
                            mul_mod(v[i][2], v[j][1], r->prime));
}

static uint32_t minor3(const loft_residue *r, uint32_t v[][3], unsigned i, unsigned j, unsigned k)
{
    const uint32_t first = mul_mod(v[i][0], minor2(r, v, j, k), r->prime),
                   second = mul_mod(v[j][0], minor2(r, v, i, k), r->prime),
                   third = mul_mod(v[k][0], minor2(r, v, i, j), r->prime);

    return loft_residue_add(r, loft_residue_sub(r, first, second), third);
}

bool loft_residue_dependent(const loft_residue *r, uint32_t v[][3], unsigned size)
{
    for (unsigned i = 0; i < size; i++)
        for (unsigned j = i + 1; j < size; j++)
            for (unsigned k = j + 1; k < size; k++)
                if (minor3(r, v, i, j, k) != 0)
                    return false;
    return true;
}
