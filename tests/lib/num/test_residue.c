/* tests/lib/num/test_residue.c -- properties of lib/num/residue.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "num/residue.h"

static bool divides(uint32_t d, uint32_t n) { return n % d == 0; }

static void primes_are_prime_and_decrease(arb *a)
{
    loft_residue r;
    uint32_t before = (uint32_t)1 << 31;
    unsigned count = 0;

    (void)a;
    for (loft_residue_start(&r, 3000); loft_residue_next(&r); count++) {
        CHECK(r.prime < before && r.prime > (uint32_t)1 << 30);
        for (uint32_t d = 2; d < 46341; d++)
            CHECK(!divides(d, r.prime));
        before = r.prime;
    }
    CHECK(count == 101);
}

/* a b - c d, by remainders and by exact numbers; one in two is 0. */
static void zero_is_told_from_not_zero(arb *a)
{
    const loft_real x[2] = { arb_real(a, 30000), arb_real(a, 30000) };
    loft_real y[2] = { x[1], x[0] };
    loft_residue r;
    bool zero = true;

    if (arb_below(a, 2))
        y[0] = arb_real(a, 30000);
    for (loft_residue_start(&r, 2 * LOFT_RESIDUE_REAL + 1); zero && loft_residue_next(&r); ) {
        const uint32_t left = loft_residue_mul(&r, loft_residue_real(&r, x[0]),
                                               loft_residue_real(&r, x[1]));
        const uint32_t right = loft_residue_mul(&r, loft_residue_real(&r, y[0]),
                                                loft_residue_real(&r, y[1]));
        zero = loft_residue_sub(&r, left, right) == 0;
    }
    const loft_exact det = loft_exact_det(loft_exact_from_real(x[0]), loft_exact_from_real(y[0]),
                                          loft_exact_from_real(y[1]), loft_exact_from_real(x[1]));
    CHECK(zero == (loft_exact_sign(det) == 0));
}

static void operations_are_those_of_a_field(arb *a)
{
    loft_residue r;

    loft_residue_start(&r, 90);
    while (loft_residue_next(&r)) {
        const uint32_t x = loft_residue_real(&r, arb_real(a, 30000)),
                       y = loft_residue_unit(&r, arb_unit(a));
        CHECK(loft_residue_add(&r, loft_residue_sub(&r, x, y), y) == x);
        CHECK(x == 0 || loft_residue_mul(&r, x, loft_residue_inverse(&r, x)) == 1);
        const loft_real b = arb_real(a, 100), c = arb_real(a, 100);     /* sums are exact */
        CHECK(loft_residue_real(&r, b + c) ==
              loft_residue_add(&r, loft_residue_real(&r, b), loft_residue_real(&r, c)));
    }
    CHECK(loft_residue_sub(&r, loft_residue_one(&r), loft_residue_unit(&r, LOFT_UNIT(1))) == 0);
}

static void dependent_vectors_are_found(arb *a)
{
    loft_residue r;
    uint32_t v[4][3];

    loft_residue_start(&r, 1);
    CHECK(loft_residue_next(&r));
    const uint32_t s = (uint32_t)arb_next(a) % r.prime, t = (uint32_t)arb_next(a) % r.prime;
    for (int i = 0; i < 4; i++) {
        v[i][0] = (uint32_t)arb_next(a) % r.prime;
        v[i][1] = (uint32_t)arb_next(a) % r.prime;
        v[i][2] = loft_residue_add(&r, loft_residue_mul(&r, s, v[i][0]),
                                   loft_residue_mul(&r, t, v[i][1]));
    }
    CHECK(loft_residue_dependent(&r, v, 4));
    const unsigned row = arb_below(a, 4), column = arb_below(a, 3);
    v[row][column] = loft_residue_add(&r, v[row][column], 1);
    CHECK(!loft_residue_dependent(&r, v, 4));
}

static void a_skipped_prime_is_replaced(arb *a)
{
    const unsigned bits = arb_below(a, 400);
    loft_residue r;
    unsigned count = 0;

    loft_residue_start(&r, bits);
    while (loft_residue_next(&r))
        if (++count == 1)
            loft_residue_skip(&r);
    CHECK(count == bits / 30 + 2);
}

int main(void)
{
    PROPERTY(primes_are_prime_and_decrease,      1);
    PROPERTY(zero_is_told_from_not_zero,      1000);
    PROPERTY(operations_are_those_of_a_field, 1000);
    PROPERTY(dependent_vectors_are_found,     1000);
    PROPERTY(a_skipped_prime_is_replaced,      100);
    return check_failures();
}
