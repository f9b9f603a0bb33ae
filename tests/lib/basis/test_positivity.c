/* tests/lib/basis/test_positivity.c -- properties of lib/basis/positivity.h
 * SPDX-License-Identifier: MIT
 *
 * Polynomials are made as products of known factors with small whole coefficients, so roots and
 * their multiplicities are known. Others are compared with their values. High degrees have a test
 * of their own, which takes more memory.
 */
#include "basis/positivity.h"
#include "basis/sign.h"
#include "support/signs.h"          /* arb_product, changes_of_values */

#define MOST LOFT_DEGREE_MAX

/* Bernstein coefficients: times a common multiple of the binomials, 2520 at most. False if they do
 * not fit a coordinate of 23 bits. */
static bool to_reals(const product *p, loft_real out[])
{
    for (unsigned i = 0; i <= p->degree; i++) {
        const int64_t raw = p->c[i] * 2520 / loft_binomial(p->degree, i);
        if (raw * loft_binomial(p->degree, i) != p->c[i] * 2520 || raw > 8000000 || raw < -8000000)
            return false;
        out[i] = loft_real_from_raw((int32_t)raw);
    }
    return true;
}

static void known_roots_are_counted(arb *a)
{
    product p;
    loft_real b[MOST + 1];
    loft_positivity got = { false, false, 0 };
    const known k = arb_product(a, &p);

    if (!to_reals(&p, b))
        return;
    CHECK(loft_bernstein_positivity(b, p.degree, &got) == LOFT_OK);
    CHECK(got.roots == k.roots);
    const bool above = value_at(b, p.degree, 1 / 12.0L) > 0;        /* no root is there */
    CHECK(got.nonnegative == (above && !k.changes));
    CHECK(got.positive == (above && k.roots == 0));
}

/* Random coefficients: no root is missed between values of different signs, none is claimed where
 * all coefficients have one sign, and positive ones have positive values. */
static void answers_agree_with_values(arb *a)
{
    const unsigned n = arb_below(a, MOST + 1);
    const int32_t limit = 1 + (int32_t)arb_below(a, 100);
    loft_real b[MOST + 1];
    loft_positivity got = { false, false, 0 };
    bool one_sign = true;

    for (unsigned i = 0; i <= n; i++) {
        b[i] = arb_real(a, limit);
        one_sign = one_sign && b[i] > 0;
    }
    CHECK(loft_bernstein_positivity(b, n, &got) == LOFT_OK);
    const int changes = changes_of_values(b, n, 64, &got);
    CHECK(got.roots < 0 || got.roots >= changes);
    CHECK(!one_sign || (got.positive && got.roots == 0));
}

/* Degree 2: sign.h decides by another theorem. */
static void degree_two_is_that_of_the_theorem(arb *a)
{
    const int32_t limit = 1 + (int32_t)arb_below(a, 100);
    loft_real b[3] = { arb_real(a, limit), arb_real(a, limit), arb_real(a, limit) };
    loft_positivity got = { false, false, 0 };
    loft_sign want;

    if (arb_below(a, 3) == 0) {             /* a double root: b1^2 = b0 b2 */
        const int32_t x = 1 + (int32_t)arb_below(a, 2000), y = 1 + (int32_t)arb_below(a, 2000);
        b[0] = loft_real_from_raw(x * x);
        b[1] = loft_real_from_raw(-x * y + (int32_t)arb_below(a, 3) - 1);
        b[2] = loft_real_from_raw(y * y);
    }
    CHECK(loft_bernstein_positivity(b, 2, &got) == LOFT_OK &&
          loft_quadratic_sign(b, &want) == LOFT_OK);
    CHECK(got.nonnegative == want.nonnegative && got.positive == want.positive);
}

static void mistakes_and_zero_are_told(arb *a)
{
    const loft_real b[MOST + 2] = { 0 };
    loft_positivity got = { false, false, 7 };

    (void)a;
    CHECK(loft_bernstein_positivity(b, MOST + 1, &got) == LOFT_ERR_ARG && got.roots == 7);
    CHECK(loft_bernstein_positivity(b, MOST, &got) == LOFT_OK);
    CHECK(got.nonnegative && !got.positive && got.roots == -1);
}

static void low_convexity_is_that_of_the_theorem(arb *a)
{
    static uint32_t work[LOFT_POSITIVITY_WORK(4)];
    const unsigned n = arb_below(a, 5);
    loft_real b[5];
    bool net[2] = { false, true }, convex[2] = { false, true };

    for (unsigned i = 0; i <= n; i++)
        b[i] = arb_below(a, 2) ? arb_real(a, 100) : LOFT_REAL((int)(i * i));
    CHECK(loft_bernstein_convex(b, n, &net[0], &convex[0]) == LOFT_OK);
    CHECK(loft_bernstein_convex_in(b, n, work, &net[1], &convex[1]) == LOFT_OK);
    CHECK(net[0] == net[1] && convex[0] == convex[1]);
}

int main(void)
{
    PROPERTY(known_roots_are_counted,           300);
    PROPERTY(answers_agree_with_values,         150);
    PROPERTY(degree_two_is_that_of_the_theorem, 300);
    PROPERTY(mistakes_and_zero_are_told,          1);
    PROPERTY(low_convexity_is_that_of_the_theorem, 100);
    return check_failures();
}
