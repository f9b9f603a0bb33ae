/* tests/lib/basis/test_bernstein.c -- properties of lib/basis/bernstein.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"          /* CHECK, PROPERTY, BY_NUM */
#include "support/exact.h"  /* exact_eval, growth, ulp_double */
#include "basis/bernstein.h"

#define COUNT (LOFT_DEGREE_MAX + 1)
#define ACC_LSB (1 / 4294967296.0L)

typedef struct {
    unsigned n;
    loft_real x[COUNT];
    loft_acc c[COUNT];
    long double exact[COUNT], largest;
} sample;

/* Coefficients of any size; one in eight alternates between the extremes, the worst for
 * differences. */
static sample arb_sample(arb *a)
{
    const uint32_t kind = arb_below(a, 8), limit = (uint32_t)1 << arb_below(a, 15);
    sample s = { .n = arb_below(a, COUNT) };

    for (unsigned k = 0; k <= s.n; k++) {
        s.x[k] = kind == 0 ? (loft_real)(k & 1 ? BY_NUM(INT32_MAX, 32767, 32767)
                                               : BY_NUM(INT32_MIN, -32768, -32768))
                           : arb_real(a, (int32_t)limit);
        s.c[k] = loft_to_acc(s.x[k]);
        s.exact[k] = exact_of(s.x[k]);
        s.largest = fmaxl(s.largest, fabsl(s.exact[k]));
    }
    return s;
}

static loft_unit arb_extended(arb *a)
{
    return arb_below(a, 2) ? arb_unit(a) : (loft_unit)(3 * arb_unit(a) - LOFT_UNIT(1));
}

/* An acc against its bound: q16 in units of 2^-33, floats in ulp of double at `scale`. */
static void check_acc(loft_acc got, long double want, long double q16_steps, long double scale,
                      long double ulps)
{
    const long double by_num[2] = { q16_steps * ACC_LSB / 2 +
                                        1e-15L * (1 + fabsl(want)) * (q16_steps > 0),
                                    ulps * ulp_double(scale) };
    CHECK_EXACT(exact_acc(got), want, by_num[BY_NUM(0, 1, 1)]);
}

static void binomials_obey_pascal(arb *a)
{
    (void)a;
    for (unsigned n = 1; n <= 28; n++) {
        CHECK(loft_binomial(n, 0) == 1 && loft_binomial(n, n) == 1 && loft_binomial(n, n + 1) == 0);
        for (unsigned k = 1; k <= n; k++)
            CHECK(loft_binomial(n, k) == loft_binomial(n - 1, k - 1) + loft_binomial(n - 1, k));
    }
}

static void parameters_are_clamped(arb *a)
{
    const loft_unit t = arb_extended(a), c = loft_unit_clamp(t);
    const loft_unit want = t < 0 ? 0 : t > LOFT_UNIT(1) ? LOFT_UNIT(1) : t;
    CHECK(!(c < want) && !(c > want));
    CHECK(!(loft_unit_clamp(BY_NUM(0, NAN, NAN)) > 0));
}

static void weights_are_within_their_bound_and_sum_to_one(arb *a)
{
    const unsigned n = arb_below(a, COUNT);
    const loft_unit t = arb_extended(a);
    const long double x = exact_unit(t), l = powl(growth(x), n);
    loft_acc w[COUNT], sum = 0;

    loft_bernstein_weights(n, t, w);
    for (unsigned k = 0; k <= n; k++) {
        const long double want = (long double)loft_binomial(n, k) * powl(x, k) * powl(1 - x, n - k);
        check_acc(w[k], want, t >= 0 && t <= LOFT_UNIT(1) ? 2 * n : 2 * growth_sum(x, n), l, 3 * n);
        sum += w[k];
    }
    CHECK_EXACT(exact_acc(sum), 1, BY_NUM(0, 1, 1) * 3 * n * ulp_double(l));
}

static void the_law_of_extrapolation_holds(arb *a)
{
    sample s = arb_sample(a);
    const loft_unit t = arb_extended(a);
    const long double x = exact_unit(t);

    check_acc(loft_bernstein_eval(s.c, s.n, t), exact_eval(s.exact, s.n, x), growth_sum(x, s.n),
              s.largest * powl(growth(x), s.n), 3 * s.n);
}

static void a_step_is_one_row_of_the_scheme(arb *a)
{
    sample s = arb_sample(a);
    const loft_unit t = arb_extended(a);
    const long double x = exact_unit(t);

    loft_bernstein_step(s.c, s.n, t);
    for (unsigned k = 0; k < s.n; k++)
        check_acc(s.c[k], (1 - x) * s.exact[k] + x * s.exact[k+1], 1, s.largest * growth(x), 3);
    CHECK_EXACT(exact_acc(s.c[s.n]), s.exact[s.n], 0);
}

static void a_value_at_a_fraction_knows_the_fraction_exactly(arb *a)
{
    sample s = arb_sample(a), ends = s, last = s;
    const uint32_t n = 1 + (arb_below(a, (1u << 30) - 1) >> arb_below(a, 30)),
                   j = arb_below(a, 2 * n + 1);
    const long double x = (long double)j / n;

    check_acc(loft_bernstein_at(s.c, s.n, j, n), exact_eval(s.exact, s.n, x), growth_sum(x, s.n),
              s.largest * powl(growth(x), s.n), 4 * s.n);
    CHECK_EXACT(exact_acc(loft_bernstein_at(ends.c, s.n, 0, n)), s.exact[0], 0);
    CHECK_EXACT(exact_acc(loft_bernstein_at(last.c, s.n, n, n)), s.exact[s.n], 0);
}

static void differences_are_exact(arb *a)
{
    sample s = arb_sample(a);

    loft_bernstein_differences(s.c, s.n);
    for (unsigned k = 0; k <= s.n; k++) {
        long double want = 0;
        for (unsigned i = 0; i <= k; i++)
            want += ((k - i) & 1 ? -1 : 1) * (long double)loft_binomial(k, i) * s.exact[i];
        check_acc(s.c[k], want, 0, s.largest, k * powl(2, k));
    }
}

static void power_form_is_exact(arb *a)
{
    sample s = arb_sample(a);

    loft_bernstein_to_power(s.c, s.n);
    for (unsigned k = 0; k <= s.n; k++) {
        const long double c = (long double)loft_binomial(s.n, k);
        long double want = 0;
        for (unsigned i = 0; i <= k; i++)
            want += ((k - i) & 1 ? -1 : 1) * (long double)loft_binomial(k, i) * s.exact[i];
        check_acc(s.c[k], c * want, 0, s.largest, (k + 1) * powl(2, k) * c);
    }
}

static void bernstein_form_is_within_its_bound(arb *a)
{
    sample s = arb_sample(a);

    loft_bernstein_from_power(s.c, s.n);
    for (unsigned i = 0; i <= s.n; i++) {
        long double want = 0;
        for (unsigned k = 0; k <= i; k++)
            want += s.exact[k] * (long double)loft_binomial(i, k) /
                    (long double)loft_binomial(s.n, k);
        check_acc(s.c[i], want, i, s.largest, (i + 1) * (i + 2));
    }
}

static void there_and_back_is_where_it_began(arb *a)
{
    sample s = arb_sample(a);

    loft_bernstein_to_power(s.c, s.n);
    for (unsigned k = 0; k <= s.n; k++)
        if (fabsl(exact_acc(s.c[k])) > 32768)
            return;
    loft_bernstein_from_power(s.c, s.n);
    for (unsigned i = 0; i <= s.n; i++)                     /* the divisions have no remainder */
        check_acc(s.c[i], s.exact[i], 0, s.largest, (i + 1) * (i + 2) * 5376);
}

static int fits(long double want)
{
    const long double top = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      bottom = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < top - LSB && want > bottom + LSB   ? 1
           : want > top + LSB || want < bottom - LSB ? 0
                                                     : -1;
}

static void nested_multiplication_is_within_its_bound_or_refused(arb *a)
{
    const sample s = arb_sample(a);
    const double n = s.n;
    const loft_unit t = arb_below(a, 8) ? (loft_unit)(4 * arb_unit(a) - LOFT_UNIT(2))
                                        : LOFT_UNIT(2);
    const long double x = exact_unit(t);
    long double v = 0, d = 0;
    loft_real value = 1, deriv = 1;

    for (unsigned k = s.n + 1; k-- > 0; ) {
        d = d * x + v;
        v = v * x + s.exact[k];
    }
    const enum loft_status status = loft_power_eval(s.x, s.n, t, &value, &deriv);
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !(fits(v) == 1 && fits(d) == 1)));
    CHECK(status != LOFT_OK || (fits(v) && fits(d)));
    if (status != LOFT_OK) {
        CHECK(!(value < 1) && !(value > 1) && !(deriv < 1) && !(deriv > 1));
        return;
    }
    const long double value_bound[3] = { LSB / 2 + (powl(2, n) - 1) * LSB / 131072 + 1e-12L,
                                         ulp(v) / 2 + n * powl(2, n) * ulp_double(s.largest),
                                         ulp(v) / 2 + n * powl(2, n) * ulp_double(s.largest) };
    const long double deriv_bound[3] = { LSB / 2 + n * powl(2, n - 1) * LSB / 131072 + 1e-12L,
                                         ulp(d) / 2 + n * n * powl(2, n) * ulp_double(s.largest),
                                         ulp(d) / 2 + n * n * powl(2, n) * ulp_double(s.largest) };
    CHECK_EXACT(exact_of(value), v, value_bound[BY_NUM(0, 1, 2)]);
    CHECK_EXACT(exact_of(deriv), d, deriv_bound[BY_NUM(0, 1, 2)]);
}

static void mistakes_are_refused(arb *a)
{
    const sample s = arb_sample(a);
    const loft_real ten[COUNT + 1] = { 0 };
    loft_real v, d;

    CHECK(loft_power_eval(ten, COUNT, 0, &v, &d) == LOFT_ERR_ARG);
    CHECK(loft_power_eval(s.x, s.n, LOFT_UNIT(2.00001), &v, &d) == LOFT_ERR_ARG);
    CHECK(loft_power_eval(s.x, s.n, LOFT_UNIT(-2.00001), &v, &d) == LOFT_ERR_ARG);
    CHECK(loft_power_eval(s.x, s.n, BY_NUM(INT32_MAX, NAN, NAN), &v, &d) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(binomials_obey_pascal,                                   1);
    PROPERTY(parameters_are_clamped,                               1000);
    PROPERTY(weights_are_within_their_bound_and_sum_to_one,        5000);
    PROPERTY(the_law_of_extrapolation_holds,                      10000);
    PROPERTY(a_step_is_one_row_of_the_scheme,                      5000);
    PROPERTY(a_value_at_a_fraction_knows_the_fraction_exactly,    10000);
    PROPERTY(differences_are_exact,                                5000);
    PROPERTY(power_form_is_exact,                                  5000);
    PROPERTY(bernstein_form_is_within_its_bound,                   5000);
    PROPERTY(there_and_back_is_where_it_began,                     5000);
    PROPERTY(nested_multiplication_is_within_its_bound_or_refused, 10000);
    PROPERTY(mistakes_are_refused,                                  100);
    return check_failures();
}
