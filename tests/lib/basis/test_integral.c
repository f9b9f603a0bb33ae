/* tests/lib/basis/test_integral.c -- properties of lib/basis/integral.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_basis.h"        /* quad, quad_sci; CHECK, PROPERTY, BY_NUM */
#include "basis/integral.h"

#define MOST (LOFT_DEGREE_MAX + 1)

/* By the power form: sum a_k t^(k+1) / (k + 1). */
static quad primitive(const loft_real b[], unsigned n, quad t)
{
    quad d[MOST], sum = 0, power = t, binomial = 1;

    for (unsigned i = 0; i <= n; i++)
        d[i] = quad_of(b[i]);
    for (unsigned k = 0; k <= n; k++) {
        sum += binomial * d[0] * power / (k + 1);
        power *= t;
        binomial = binomial * (n - k) / (k + 1);
        for (unsigned i = 0; i + k < n; i++)
            d[i] = d[i + 1] - d[i];
    }
    return sum;
}

static void integrals_are_within_their_bound(arb *a)
{
    const unsigned n = arb_below(a, MOST);
    const int32_t limit = (int32_t)1 << arb_below(a, 15);
    const loft_unit from = arb_unit(a), to = arb_unit(a);
    loft_real b[MOST];
    loft_acc whole = 0, part = 0;

    for (unsigned i = 0; i <= n; i++)
        b[i] = arb_real(a, limit);
    CHECK(loft_bernstein_mean(b, n + 1, &whole) == LOFT_OK &&
          loft_bernstein_integral(b, n, from, to, &part) == LOFT_OK);
    const quad all = primitive(b, n, 1);
    const quad some = primitive(b, n, (quad)exact_unit(to)) -
                      primitive(b, n, (quad)exact_unit(from));
    CHECK_EXACT(exact_acc(whole) - (long double)all, 0,
                bound_by_num(0x1p-32L, 10 * ulp_double(limit), 10 * ulp_double(limit)));
    CHECK_EXACT(exact_acc(part) - (long double)some, 0,
                bound_by_num(0x1p-33L + limit * 0x1p-55L, limit * 0x1p-47L, limit * 0x1p-47L) +
                    0x1p-60L);
}

/* The product of two polynomials has the product of their values. */
static void products_have_the_product_of_values(arb *a)
{
    const unsigned m = arb_below(a, MOST), n = arb_below(a, MOST);
    const quad t = (quad)exact_unit(arb_unit(a));
    loft_sci x[2][MOST], out[2 * MOST];
    quad v[2] = { 0, 0 }, product = 0, weight;

    for (int k = 0; k < 2; k++) {
        const unsigned degree = k ? n : m;
        quad c[MOST];
        for (unsigned i = 0; i <= degree; i++) {
            const loft_real b = arb_real(a, 100);
            x[k][i] = loft_sci_from_real(b);
            c[i] = quad_of(b);
        }
        for (unsigned d = degree; d > 0; d--)
            for (unsigned i = 0; i < d; i++)
                c[i] += t * (c[i + 1] - c[i]);
        v[k] = c[0];
    }
    loft_bernstein_product(x[0], m, x[1], n, out);
    for (unsigned k = 0; k <= m + n; k++) {
        weight = 1;
        for (unsigned i = 0; i < k; i++)
            weight = weight * (m + n - i) / (i + 1) * t;
        for (unsigned i = k; i < m + n; i++)
            weight *= 1 - t;
        product += weight * quad_sci(out[k]);
    }
    CHECK_EXACT((long double)(product - v[0] * v[1]), 0,
                bound_by_num(0x1p-53L, 0x1p-45L, 0x1p-45L) * 20000);
}

static void binomials_are_those_of_integers(arb *a)
{
    const unsigned n = arb_below(a, 29), k = arb_below(a, 40);
    const quad c = quad_sci(loft_binomial_sci(n, k));

    CHECK(!(c < loft_binomial(n, k)) && !(c > loft_binomial(n, k)));
    if (n > 0 && k > 0 && k <= n)
        CHECK(loft_binomial(n, k) == loft_binomial(n - 1, k - 1) + loft_binomial(n - 1, k));
}

static void mistakes_are_refused(arb *a)
{
    loft_real b[MOST + 1] = { 0 };
    loft_acc x = 5;

    (void)a;
    CHECK(loft_bernstein_mean(b, 0, &x) == LOFT_ERR_ARG &&
          loft_bernstein_integral(b, MOST, 0, 0, &x) == LOFT_ERR_ARG &&
          loft_bernstein_integral(b, 1, 0, LOFT_UNIT(1.5), &x) == LOFT_ERR_ARG);
    CHECK(!(x < 5) && !(x > 5));
}

int main(void)
{
    PROPERTY(integrals_are_within_their_bound,    2000);
    PROPERTY(products_have_the_product_of_values, 1000);
    PROPERTY(binomials_are_those_of_integers,     2000);
    PROPERTY(mistakes_are_refused,                   1);
    return check_failures();
}
