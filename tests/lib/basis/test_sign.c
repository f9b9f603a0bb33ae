/* tests/lib/basis/test_sign.c -- positivity and convexity of Bernstein polynomials against exact
 * answers
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sign.h"         /* exact_sign_of, exact_convex */
#include "basis/bernstein.h"
#include "basis/sign.h"

static loft_real raw(int64_t i)
{
    return loft_real_from_raw((int32_t)(i < INT32_MIN ? INT32_MIN : i > INT32_MAX ? INT32_MAX : i));
}

/* Coefficients of all sizes. s^2, -s t, t^2 touch zero; one LSB off they do not touch it, or cross
 * it. */
static void some_quadratic(arb *a, loft_real c[3])
{
    const int32_t limit[4] = { 3, 4000, 40000000, INT32_MAX };
    const unsigned size = arb_below(a, 4), kind = arb_below(a, 4);
    const int64_t s = arb_below(a, size < 2 ? 60 : 46000), t = arb_below(a, size < 2 ? 60 : 46000);
    const int64_t touching[3] = { s * s, -s * t, t * t },
                  slack = arb_below(a, 2) ? s * t / (1 + arb_below(a, 80)) : 0;
    int64_t x[3];

    for (int k = 0; k < 3; k++)
        x[k] = kind == 0 ? arb_raw(a, limit[size]) : touching[k] + (k == 1 ? slack : 0);
    if (kind == 2)
        x[arb_below(a, 3)] += (int64_t)arb_below(a, 3) - 1;
    for (int k = 0; k < 3; k++)
        c[k] = raw(x[k]);
}

static void flags_and_counts_are_exact(arb *a)
{
    loft_real c[3];
    loft_sign s;

    some_quadratic(a, c);
    const exact_sign want = exact_sign_of(c);
    CHECK(loft_quadratic_sign(c, &s) == LOFT_OK);
    CHECK(s.nonnegative == want.nonnegative && s.positive == want.positive &&
          s.elevations == want.elevations);
    CHECK_EXACT(exact_of(s.min), want.min,
                BY_NUM(LSB / 2 + LSB * 0x1p-16L, ulp(want.min), ulp(want.min)));
}

static void all_answers_are_tried(arb *a)
{
    unsigned positive = 0, touching = 0, negative = 0, elevated = 0, never = 0;
    loft_real c[3];

    for (int k = 0; k < 4000; k += CHECK_STEP) {
        some_quadratic(a, c);
        const exact_sign s = exact_sign_of(c);
        positive += s.positive;
        touching += s.nonnegative && !s.positive;
        negative += !s.nonnegative;
        elevated += s.elevations > 0;
        never += s.positive && s.elevations < 0;
    }
    CHECK(check_sampled() ||
          (positive > 100 && touching > 100 && negative > 100 && elevated > 50 && never > 50));
}

static void the_minimum_is_not_undercut(arb *a)
{
    loft_real c[3];
    loft_sign s;

    some_quadratic(a, c);
    CHECK(loft_quadratic_sign(c, &s) == LOFT_OK);
    long double lowest = INFINITY;
    for (int j = 0; j <= 64; j++) {
        const long double x[3] = { exact_of(c[0]), exact_of(c[1]), exact_of(c[2]) };
        lowest = fminl(lowest, exact_eval(x, 2, j / 64.0L));
    }
    CHECK(exact_of(s.min) <= lowest + ulp(lowest));
    CHECK(s.min <= c[0] && s.min <= c[2]);
}

static void the_sign_is_symmetric(arb *a)
{
    loft_real c[3], d[3];
    loft_sign s, r;

    some_quadratic(a, c);
    for (int k = 0; k < 3; k++)
        d[k] = c[2 - k];
    CHECK(loft_quadratic_sign(c, &s) == LOFT_OK && loft_quadratic_sign(d, &r) == LOFT_OK);
    CHECK(s.nonnegative == r.nonnegative && s.positive == r.positive &&
          s.elevations == r.elevations);
    CHECK(!(s.min < r.min) && !(s.min > r.min));
}

/* b with second differences d: lines, s^2 -s t t^2, anything, or one LSB off these. */
static unsigned some_polynomial(arb *a, loft_real b[5])
{
    const unsigned n = arb_below(a, 5), kind = arb_below(a, 4);
    const int64_t s = arb_below(a, 3000), t = arb_below(a, 3000),
                  touching[3] = { s * s, -s * t, t * t };
    int64_t x[5] = { arb_raw(a, 1000000), arb_raw(a, 1000000) };

    for (unsigned k = 2; k <= n; k++)
        x[k] = 2 * x[k - 1] - x[k - 2] +
               (kind == 1   ? touching[k - 2]
                : kind == 2 ? 0
                            : (int64_t)arb_below(a, 1000) - 100);
    if (arb_below(a, 2))
        x[arb_below(a, n + 1)] += (int64_t)arb_below(a, 3) - 1;
    for (unsigned k = 0; k <= n; k++)
        b[k] = kind == 0 ? raw(arb_raw(a, INT32_MAX)) : raw(x[k]);
    return n;
}

static void convexity_is_exact(arb *a)
{
    loft_real b[5];
    bool net = false, polynomial = false;
    const unsigned n = some_polynomial(a, b);

    CHECK(loft_bernstein_convex(b, n, &net, &polynomial) == LOFT_OK);
    CHECK(net == exact_net_convex(b, n) && polynomial == exact_convex(b, n));
    CHECK(polynomial || !net);
}

/* The shortest witness: a net that is not convex, of a convex polynomial. */
static void a_polynomial_can_be_convex_without_its_net(arb *a)
{
    const loft_real b[5] = { LOFT_REAL(1), 0, LOFT_REAL(0.25), 0, LOFT_REAL(1) };
    bool net = true, polynomial = false;

    (void)a;
    CHECK(loft_bernstein_convex(b, 4, &net, &polynomial) == LOFT_OK && !net && polynomial);
    CHECK(loft_bernstein_convex(b, 5, &net, &polynomial) == LOFT_ERR_ARG);
}

static void numbers_outside_the_window_are_refused(arb *a)
{
    loft_real c[3] = { LOFT_REAL(1), LOFT_REAL(1), LOFT_REAL(1) };
    loft_sign s = { false, false, LOFT_REAL(5), 7 };
    bool net = false, polynomial = false;
    const enum loft_status want = BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE);

    c[arb_below(a, 3)] = (loft_real)BY_NUM(INT32_MAX, 3e6, 3e6);
    CHECK(loft_quadratic_sign(c, &s) == want &&
          loft_bernstein_convex(c, 2, &net, &polynomial) == want);
    CHECK(BY_NUM(s.elevations == 0, s.elevations == 7 && s.min >= 5,
                 s.elevations == 7 && s.min >= 5));
}

int main(void)
{
    PROPERTY(flags_and_counts_are_exact,                  2000);
    PROPERTY(all_answers_are_tried,                          1);
    PROPERTY(the_minimum_is_not_undercut,                  500);
    PROPERTY(the_sign_is_symmetric,                        300);
    PROPERTY(convexity_is_exact,                          5000);
    PROPERTY(a_polynomial_can_be_convex_without_its_net,     1);
    PROPERTY(numbers_outside_the_window_are_refused,        10);
    return check_failures();
}
