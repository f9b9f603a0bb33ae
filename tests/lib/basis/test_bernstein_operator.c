/* tests/lib/basis/test_bernstein_operator.c -- iterates of Bernstein's operator against long double
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_eval, growth */
#include "basis/bernstein_operator.h"

static unsigned some_function(arb *a, loft_real f[])
{
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    const int32_t limit = arb_below(a, 2) ? 32767 : 100;

    for (unsigned k = 0; k <= n; k++)
        f[k] = arb_real(a, limit);
    return n;
}

static long double exact_iterate(const loft_real f[], unsigned n, uint32_t times, long double x)
{
    long double g[LOFT_DEGREE_MAX + 1], next[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= n; k++)
        g[k] = exact_of(f[k]);
    while (--times) {
        for (unsigned k = 0; k <= n; k++)
            next[k] = exact_eval(g, n, (long double)k / n);
        for (unsigned k = 0; k <= n; k++)
            g[k] = next[k];
    }
    return exact_eval(g, n, x);
}

static long double largest_of(const loft_real f[], unsigned n)
{
    long double most = 0;
    for (unsigned k = 0; k <= n; k++)
        most = fmaxl(most, fabsl(exact_of(f[k])));
    return most;
}

static long double bound(const loft_real f[], unsigned n, long double x, long double want)
{
    const long double sampling = n < 2 ? 0 : powl(n, 4) / (4 * n - 4), gain = powl(growth(x), n),
                      most = largest_of(f, n);

    (void)sampling, (void)most, (void)want;         /* each is used in some number type */
    return BY_NUM(LSB / 2 + (growth_sum(x, n) + gain * sampling) * 0x1p-33L,
                  ulp(want) / 2 + gain * ulp(most) / 2, 4 * gain * (n + sampling) * ulp(most));
}

/* Some number of iterations, mostly small, sometimes near the change to the limit. */
static uint32_t some_times(arb *a)
{
    const uint32_t far[4] = { 511, 512, 513, 700 };
    return arb_below(a, 40) == 0 ? far[arb_below(a, 4)]
                                 : 1 + arb_below(a, arb_below(a, 2) ? 4 : 60);
}

static void iterates_are_within_their_bound(arb *a)
{
    loft_real f[LOFT_DEGREE_MAX + 1], y = 0;
    const unsigned n = some_function(a, f);
    const uint32_t times = some_times(a);
    const loft_unit x = arb_below(a, 4) ? arb_unit(a) : (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
    const long double want = exact_iterate(f, n, times, exact_unit(x));
    const enum loft_status status = loft_bernstein_iterate(f, n, times, x, &y);

    if (status == LOFT_ERR_RANGE)
        CHECK(fabsl(want) > BY_NUM(32767.9L, FLT_MAX, DBL_MAX));
    else {
        CHECK(status == LOFT_OK && fabsl(want) < BY_NUM(32768, FLT_MAX, DBL_MAX));
        CHECK_EXACT(exact_of(y), want, bound(f, n, exact_unit(x), want));
    }
}

static void the_limit_is_the_line_between_the_ends(arb *a)
{
    loft_real f[LOFT_DEGREE_MAX + 1], forever = 0, late = 0;
    const unsigned n = some_function(a, f);
    const loft_unit x = arb_unit(a);
    const long double t = exact_unit(x), want = (1 - t) * exact_of(f[0]) + t * exact_of(f[n]);

    CHECK(loft_bernstein_iterate(f, n, LOFT_FOREVER, x, &forever) == LOFT_OK);
    CHECK(loft_bernstein_iterate(f, n, 512, x, &late) == LOFT_OK);
    CHECK_EXACT(exact_of(forever), want, bound(f, 1, t, want));
    CHECK_EXACT(exact_of(late), want, bound(f, n, t, want));
}

static void lines_and_ends_are_kept(arb *a)
{
    loft_real f[LOFT_DEGREE_MAX + 1], y;
    const unsigned n = 1 + arb_below(a, LOFT_DEGREE_MAX);
    const loft_real from = arb_real(a, 100), step = arb_real(a, 100);
    const uint32_t times = some_times(a);
    const loft_unit x = arb_unit(a);

    for (unsigned k = 0; k <= n; k++)
        f[k] = from + (loft_real)k * step;
    const long double want = exact_of(f[0]) + (exact_of(f[n]) - exact_of(f[0])) * exact_unit(x);
    CHECK(loft_bernstein_iterate(f, n, times, x, &y) == LOFT_OK);
    CHECK_EXACT(exact_of(y), want,
                bound(f, n, exact_unit(x), want) +
                    BY_NUM(0, n * ulp(largest_of(f, n)), n * ulp(largest_of(f, n))));
    CHECK(loft_bernstein_iterate(f, n, times, 0, &y) == LOFT_OK && !(y < f[0]) && !(y > f[0]));
    CHECK(loft_bernstein_iterate(f, n, times, LOFT_UNIT(1), &y) == LOFT_OK && !(y < f[n]) &&
          !(y > f[n]));
}

/* Many samples: value and derivative, by de Casteljau's algorithm in long double. */
static void one_application_takes_many_samples(arb *a)
{
    const unsigned n = 1 + arb_below(a, LOFT_OPERATOR_MAX);
    const int32_t limit = (int32_t)1 << arb_below(a, 9);
    const loft_unit x = arb_unit(a);
    const long double t = exact_unit(x);
    loft_real f[LOFT_OPERATOR_MAX + 1], y = 0, slope = 0;
    long double c[LOFT_OPERATOR_MAX + 1], before[2] = { 0, 0 };

    for (unsigned i = 0; i <= n; i++) {
        f[i] = arb_real(a, limit);
        c[i] = exact_of(f[i]);
    }
    for (unsigned m = n; m > 0; m--) {
        before[0] = c[0];
        before[1] = c[1];
        for (unsigned i = 0; i < m; i++)
            c[i] = (1 - t) * c[i] + t * c[i + 1];
    }
    const long double want = n * (before[1] - before[0]);
    const enum loft_status status = loft_bernstein_operator(f, n, x, &y, &slope);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && fabsl(want) > 32767));
    if (status != LOFT_OK)
        return;
    CHECK_EXACT(exact_of(y), c[0],
                BY_NUM(LSB / 2 + n * LSB / 131072, ulp(c[0]) / 2 + 0x1p-20L * ulp(limit),
                       4 * n * ulp(limit)));
    CHECK_EXACT(exact_of(slope), want,
                BY_NUM(LSB / 2 + n * n * LSB / 131072, ulp(want) / 2 + 0x1p-14L * ulp(limit),
                       8 * n * n * ulp(limit)));
}

static void mistakes_are_told(arb *a)
{
    loft_real f[LOFT_DEGREE_MAX + 1], y = LOFT_REAL(3);

    (void)a;
    for (unsigned k = 0; k <= LOFT_DEGREE_MAX; k++)
        f[k] = k % 2 ? LOFT_REAL(30000) : LOFT_REAL(-30000);
    CHECK(loft_bernstein_iterate(f, 0, 1, 0, &y) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_iterate(f, LOFT_DEGREE_MAX + 1, 1, 0, &y) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_iterate(f, 3, 0, 0, &y) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_operator(f, 0, 0, &y, &y) == LOFT_ERR_ARG &&
          loft_bernstein_operator(f, LOFT_OPERATOR_MAX + 1, 0, &y, &y) == LOFT_ERR_ARG &&
          loft_bernstein_operator(f, 3, LOFT_UNIT(1.5), &y, &y) == LOFT_ERR_ARG);
    CHECK(loft_bernstein_iterate(f, 3, 1, LOFT_UNIT(2.5), &y) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    f[2] = (loft_real)INFINITY;
    const loft_unit x = LOFT_UNIT(0.5);
#else
    const loft_unit x = LOFT_UNIT(2);
#endif
    CHECK(loft_bernstein_iterate(f, 9, 1, x, &y) == LOFT_ERR_RANGE && y <= LOFT_REAL(3) &&
          y >= LOFT_REAL(3));
}

int main(void)
{
    PROPERTY(iterates_are_within_their_bound,       2000);
    PROPERTY(the_limit_is_the_line_between_the_ends,  60);
    PROPERTY(lines_and_ends_are_kept,                300);
    PROPERTY(one_application_takes_many_samples,     500);
    PROPERTY(mistakes_are_told,                        1);
    return check_failures();
}
