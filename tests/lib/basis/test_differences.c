/* tests/lib/basis/test_differences.c -- properties of lib/basis/differences.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_of, exact_eval, ulp, CHECK_EXACT */
#include "basis/differences.h"

typedef struct {
    loft_real a[LOFT_DEGREE_MAX + 1];
    long double c[LOFT_DEGREE_MAX + 1], largest;
    unsigned degree;
} sample;

static sample arb_sample(arb *a, int32_t limit)
{
    sample s = { .degree = arb_below(a, LOFT_DEGREE_MAX + 1) };
    for (unsigned k = 0; k <= s.degree; k++) {
        s.a[k] = arb_real(a, limit);
        s.c[k] = exact_of(s.a[k]);
        s.largest = fmaxl(s.largest, fabsl(s.c[k]));
    }
    return s;
}

/* Adding up the differences gives the samples: f(j/n) = sum C(j,k) e_k, for as many steps as there
 * are differences. */
static void add_up_to_the_samples(arb *a)
{
    const sample s = arb_sample(a, 30);
    const uint32_t n = 1 + (arb_below(a, 2) ? arb_below(a, 20) : arb_below(a, 100000));
    loft_real e[LOFT_DEGREE_MAX + 1];

    if (loft_bernstein_forward_differences(s.a, s.degree, n, e) != LOFT_OK) {
        CHECK(n <= s.degree);                        /* only steps beyond 1 leave the range here */
        return;
    }
    for (unsigned j = 0; j <= s.degree; j++) {
        const long double want = exact_eval(s.c, s.degree, (long double)j / n);
        long double sum = 0,
                    bound = (s.largest + 1) * powl(3.0L * (j > n ? j : n) / n, s.degree) * 1e-17L;
        for (unsigned k = 0; k <= j; k++) {
            sum   += exact_of(e[k]) * loft_binomial(j, k);
            bound += (0.51L * ulp(exact_of(e[k]))) * loft_binomial(j, k);
        }
        CHECK_EXACT(sum, want, bound);
    }
}

/* A polynomial of degree d has a constant d-th difference: d! times its leading coefficient over
 * n^d. */
static void end_with_the_leading_coefficient(arb *a)
{
    const sample s = arb_sample(a, 3000);
    const uint32_t n = 10 + arb_below(a, 50);
    loft_real e[LOFT_DEGREE_MAX + 1];
    long double want = 0;

    CHECK(loft_bernstein_forward_differences(s.a, s.degree, n, e) == LOFT_OK);
    for (unsigned i = 0; i <= s.degree; i++)
        want += s.c[i] * loft_binomial(s.degree, i) * ((s.degree - i) % 2 ? -1 : 1);
    for (unsigned k = 1; k <= s.degree; k++)
        want *= (long double)k / n;
    CHECK_EXACT(exact_of(e[s.degree]), want, 0.51L * ulp(want) + s.largest * 1e-15L);
}

static void refuse_what_cannot_be(arb *a)
{
    const loft_real big[3] = { LOFT_REAL(-32767), LOFT_REAL(32767), LOFT_REAL(-32767) };
    loft_real e[3] = { 1, 2, 3 };
    (void)a;

    CHECK(loft_bernstein_forward_differences(big, 10, 4, e) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_forward_differences(big, 2, 0, e) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_forward_differences(big, 2, 1, e) ==
          BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK));
    CHECK(BY_NUM(e[0] == 1 && e[1] == 2 && e[2] == 3, e[2] < 0, e[2] < 0));
}

int main(void)
{
    PROPERTY(add_up_to_the_samples, 2000);
    PROPERTY(end_with_the_leading_coefficient, 2000);
    PROPERTY(refuse_what_cannot_be, 1);
    return check_failures();
}
