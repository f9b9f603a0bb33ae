/* tests/lib/basis/test_positivity_high.c -- properties of lib/basis/positivity.h, degrees 10 to 44
 * SPDX-License-Identifier: MIT
 *
 * Products with powers of t and 1 - t, squares in x^k with x = t / (1 - t), polynomials of low
 * degree raised, and second integrals, all with whole coefficients: multiple roots and one LSB
 * decide. Exact vectors go to degree 128.
 */
#include <string.h>

#include "basis/positivity.h"
#include "support/signs.h"          /* arb_product, changes_of_values */

#define HIGH 32
#define HIGHEST (CHECK_SHARE > 1 ? HIGH : 44)   /* 250 kB in floats: more than chips have */
#define MOST LOFT_POSITIVITY_DEGREE

static uint32_t work[LOFT_POSITIVITY_WORK(HIGHEST)];

/* False where the number type does not hold such a coefficient. */
static bool reals_of(const int64_t raw[], unsigned n, loft_real out[])
{
    for (unsigned i = 0; i <= n; i++) {
        if (raw[i] > INT32_MAX || raw[i] < -INT32_MAX)
            return false;
        out[i] = loft_real_from_raw((int32_t)raw[i]);
        if (fabsl(exact_of(out[i]) * 65536 - (long double)raw[i]) > 0)
            return false;
    }
    return true;
}

static void expect(const loft_real b[], unsigned n, bool nonnegative, bool positive, int roots)
{
    loft_positivity got = { false, false, 0 };

    memset(work, 0xa5, sizeof work);
    CHECK(loft_bernstein_positivity_in(b, n, work, &got) == LOFT_OK);
    CHECK(got.nonnegative == nonnegative && got.positive == positive && got.roots == roots);
}

/* t^i (1 - t)^(n - 2 - i) (p t - q (1 - t))^2, with `off` more LSB in the middle coefficient */
static void a_double_root_among_roots_at_the_ends_is_seen(arb *a)
{
    const unsigned n = 10 + arb_below(a, arb_below(a, 20) ? HIGH - 9 : HIGHEST - 9),
                   i = arb_below(a, n - 1);
    const int64_t p = 1 + arb_below(a, 90), q = 1 + arb_below(a, 90), left = n - i;
    const int off = (int)arb_below(a, 3) - 1, ends = (i > 0) + (i + 2 < n);
    int64_t raw[HIGHEST + 1] = { 0 };
    loft_real b[HIGHEST + 1];

    raw[i] = q * q * left * (left - 1);
    raw[i + 1] = -2 * p * q * (i + 1) * (left - 1) + off;
    raw[i + 2] = p * p * (i + 1) * (i + 2);
    if (reals_of(raw, n, b))
        expect(b, n, off >= 0, false, ends + (off == 0 ? 1 : off < 0 ? 2 : 0));
    for (unsigned k = 0; k <= n; k++)
        raw[k] = -raw[k];
    if (reals_of(raw, n, b))
        expect(b, n, false, false, ends + (off == 0 ? 1 : off < 0 ? 2 : 0));
}

/* (p x^k - q)^2 where 2 p q = C(2 k, k): the middle coefficient is -1 LSB, one LSB at an end
 * decides. Times a power of t the root at 0 is multiple. */
static void the_last_bit_decides_at_high_degrees(arb *a)
{
    static const int64_t square[][3] = {
        { 10, 9, 14 }, { 12, 22, 21 }, { 16, 117, 55 }, { 20, 286, 323 }, { 32, 17595, 17081 }
    };
    const unsigned which = arb_below(a, 5), n = (unsigned)square[which][0];
    const int off = (int)arb_below(a, 3) - 1;
    int64_t raw[HIGHEST + 1] = { 0 };
    loft_real b[HIGHEST + 1];

    raw[0] = square[which][2] * square[which][2];
    raw[n / 2] = -1;
    raw[n] = square[which][1] * square[which][1];
    raw[arb_below(a, 2) * n] += off;
    if (reals_of(raw, n, b))
        expect(b, n, off >= 0, off > 0, off == 0 ? 1 : off < 0 ? 2 : 0);
}

/* Of degree 0..4 to degree n: n (n - 1) .. (n - d + 1) times the coefficients are whole. */
static void raised_polynomials_keep_their_answer(arb *a)
{
    const unsigned n = 10 + arb_below(a, HIGH - 9);
    loft_positivity want = { false, false, 0 };
    int64_t raw[HIGHEST + 1];
    loft_real low[5], b[HIGHEST + 1];
    product p;

    (void)arb_product(a, &p);
    if (p.degree > 4)
        return;
    for (unsigned k = 0; k <= n; k++) {             /* sum c_i C(n - d, k - i) / C(n, k) */
        raw[k] = 0;
        for (unsigned i = 0; i <= p.degree; i++) {  /* C(n - d, k - i) n .. (n - d + 1) / C(n, k) */
            int64_t term = p.c[i];
            for (unsigned j = 0; j < i; j++)
                term *= (int64_t)k - j;
            for (unsigned j = 0; j < p.degree - i; j++)
                term *= (int64_t)n - k - j;
            raw[k] += term;
        }
    }
    for (unsigned i = 0; i <= p.degree; i++) {      /* its own, times 12: C(4, i) divides that */
        const int64_t own = p.c[i] * 12 / loft_binomial(p.degree, i);
        low[i] = loft_real_from_raw((int32_t)own);
    }
    CHECK(loft_bernstein_positivity(low, p.degree, &want) == LOFT_OK);
    if (reals_of(raw, n, b))
        expect(b, n, want.nonnegative, want.positive, want.roots);
}

/* n (n - 1) (2 t - 1)^2 times a polynomial of degree n - 2: one root more. */
static void a_square_adds_one_root(arb *a)
{
    const unsigned n = HIGHEST - 11 + arb_below(a, 12);
    int64_t r[HIGHEST + 5] = { 0 }, raw[HIGHEST + 1];
    loft_positivity want = { false, false, 0 };
    loft_real low[HIGHEST + 1], b[HIGHEST + 1];
    long double middle = 0, binomial = 1;

    for (unsigned k = 0; k + 2 <= n; k++) {
        r[k + 2] = (int64_t)arb_below(a, 900) - (arb_below(a, 4) ? 0 : 500);
        low[k] = loft_real_from_raw((int32_t)r[k + 2]);
        middle += binomial * (long double)r[k + 2];
        binomial = binomial * (n - 2 - k) / (k + 1);
    }
    for (unsigned k = 0; k <= n; k++)
        raw[k] = (int64_t)(n - k) * (n - k - 1) * r[k + 2] - 2 * (int64_t)k * (n - k) * r[k + 1] +
                 (int64_t)k * (k - 1) * r[k];
    if (fabsl(middle) < 1 || !reals_of(raw, n, b))
        return;
    CHECK(loft_bernstein_positivity_in(low, n - 2, work, &want) == LOFT_OK);
    expect(b, n, want.nonnegative, false, want.roots + 1);
}

/* Random coefficients of high degree against values. */
static void high_answers_agree_with_values(arb *a)
{
    const unsigned n = 10 + arb_below(a, HIGH - 9);
    loft_positivity got = { false, false, 0 };
    loft_real b[HIGHEST + 1];
    int in_net = 0, last = 0;

    for (unsigned i = 0; i <= n; i++) {
        b[i] = arb_real(a, i % 2 ? 4 : 20);
        if (arb_below(a, 3))
            b[i] = b[i] < 0 ? -b[i] : b[i];
        const int sign = (b[i] > 0) - (b[i] < 0);
        in_net += sign && last && sign != last;
        last = sign ? sign : last;
    }
    CHECK(loft_bernstein_positivity_in(b, n, work, &got) == LOFT_OK);
    const int changes = changes_of_values(b, n, 256, &got);
    CHECK(got.roots >= changes && (changes == 0 || !got.nonnegative));
    CHECK(b[0] == 0 || b[n] == 0 || got.roots <= in_net);       /* Descartes */
}

/* A polynomial is convex where its second differences make one that is not negative. */
static void convexity_is_the_sign_of_the_second_derivative(arb *a)
{
    const unsigned n = 12 + arb_below(a, HIGH - 11), m = n - 2, i = arb_below(a, m - 1);
    const int64_t p = 1 + arb_below(a, 9), q = 1 + arb_below(a, 9), left = m - i;
    const int off = (int)arb_below(a, 3) - 1;
    int64_t second[HIGHEST + 1] = { 0 }, raw[HIGHEST + 1] = { 0 };
    loft_real b[HIGHEST + 1];
    bool net = true, convex = off < 0;

    second[i] = q * q * left * (left - 1);
    second[i + 1] = -2 * p * q * (i + 1) * (left - 1) + off;
    second[i + 2] = p * p * (i + 1) * (i + 2);
    raw[1] = (int64_t)arb_below(a, 2000) - 1000;
    for (unsigned k = 0; k < m + 1; k++)
        raw[k + 2] = 2 * raw[k + 1] - raw[k] + second[k];
    if (!reals_of(raw, n, b))
        return;
    CHECK(loft_bernstein_convex_in(b, n, work, &net, &convex) == LOFT_OK);
    CHECK(net == (second[i + 1] >= 0) && convex == (off >= 0));
}

static void mistakes_and_zero_are_told(arb *a)
{
    const loft_real b[MOST + 2] = { 0 };
    loft_positivity got = { false, false, 7 };
    bool net = false, convex = false;

    (void)a;
    CHECK(loft_bernstein_positivity_in(b, MOST + 1, work, &got) == LOFT_ERR_ARG && got.roots == 7);
    CHECK(loft_bernstein_convex_in(b, MOST + 1, work, &net, &convex) == LOFT_ERR_ARG && !net);
    expect(b, MOST, true, false, -1);
    CHECK(loft_bernstein_convex_in(b, MOST, work, &net, &convex) == LOFT_OK && net && convex);
}

int main(void)
{
    PROPERTY(a_double_root_among_roots_at_the_ends_is_seen,  60);
    PROPERTY(the_last_bit_decides_at_high_degrees,           15);
    PROPERTY(raised_polynomials_keep_their_answer,           60);
    PROPERTY(a_square_adds_one_root,                          2);
    PROPERTY(high_answers_agree_with_values,                 15);
    PROPERTY(convexity_is_the_sign_of_the_second_derivative, 60);
    PROPERTY(mistakes_and_zero_are_told,                      1);
    return check_failures();
}
