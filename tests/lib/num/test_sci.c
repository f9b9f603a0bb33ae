/* tests/lib/num/test_sci.c -- properties of lib/num/sci.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sci.h"              /* CHECK_EXACT, exact_sci */
#include "num/exact.h"
#include "num/sci.h"

static bool well_formed(loft_sci x)
{
#if LOFT_NUM == LOFT_Q16
    return x.m == 0 || x.m >> 62 == 1;
#else
    return x - x <= 0;
#endif
}

/* Products and quotients of integers: any digits, any exponent within 2^+-200. */
static loft_sci arb_sci(arb *a)
{
    loft_sci x = loft_sci_from_int((int32_t)arb_below(a, 1u << (1 + arb_below(a, 30))));
    const loft_sci two = loft_sci_from_int(2);
    const unsigned up = arb_below(a, 200);

    x = loft_sci_add(loft_sci_mul(x, loft_sci_from_int((int32_t)arb_below(a, 1u << 30))),
                     loft_sci_from_int((int32_t)arb_below(a, 9)));
    x = arb_below(a, 2) ? loft_sci_mul(x, loft_sci_pow(two, up))
                        : loft_sci_div(x, loft_sci_pow(two, up));
    return arb_below(a, 2) ? loft_sci_neg(x) : x;
}

#define SHARE BY_NUM(0x1p-61L, 0x1p-53L, 0x1p-53L)

static void check_share(loft_sci got, long double want, long double size)
{
    CHECK(well_formed(got));
    CHECK_EXACT((exact_sci(got) - want) / (size > 0 ? size : 1), 0, SHARE + 0x1p-62L);
}

static void sums_products_and_quotients_err_by_a_share_of_the_result(arb *a)
{
    for (int k = 0; k < 50; k++) {
        const loft_sci x = arb_sci(a), y = arb_sci(a);
        const long double u = exact_sci(x), v = exact_sci(y);
        check_share(loft_sci_add(x, y), u + v, fmaxl(fabsl(u + v), fmaxl(fabsl(u), fabsl(v))));
        check_share(loft_sci_sub(x, y), u - v, fmaxl(fabsl(u - v), fmaxl(fabsl(u), fabsl(v))));
        check_share(loft_sci_mul(x, y), u * v, fabsl(u * v));
        if (loft_sci_sign(y))
            check_share(loft_sci_div(x, y), u / v, fabsl(u / v));
        CHECK(loft_sci_sign(x) == (u > 0) - (u < 0) && loft_sci_less(x, y) == (u < v));
        check_share(loft_sci_sqrt(loft_sci_sign(x) < 0 ? loft_sci_neg(x) : x), sqrtl(fabsl(u)),
                    sqrtl(fabsl(u)) * 2);
    }
}

/* x - y of neighbours, where all bits except the last cancel. */
static void what_is_exact_stays_exact(arb *a)
{
    const int32_t i = (int32_t)(arb_below(a, 65536) - 32768),
                  j = (int32_t)(arb_below(a, 65536) - 32768), k = j ? j : 1;
    const loft_sci x = loft_sci_from_int(i), y = loft_sci_from_int(k), xy = loft_sci_mul(x, y);

    CHECK_EXACT(exact_sci(xy), (long double)i * k, 0);
    CHECK_EXACT(exact_sci(loft_sci_div(xy, y)), i, 0);
    CHECK_EXACT(exact_sci(loft_sci_sqrt(loft_sci_mul(x, x))), labs(i), 0);
    CHECK_EXACT(exact_sci(loft_sci_sub(loft_sci_add(xy, loft_sci_one()), xy)), 1, 0);
    CHECK_EXACT(exact_sci(loft_sci_pow(y, 3)), (long double)k * k * k, 0);
    CHECK(loft_sci_sign(loft_sci_sub(xy, xy)) == 0 && loft_sci_sign(loft_sci_zero()) == 0);
    CHECK_EXACT(exact_sci(loft_sci_pow(loft_sci_zero(), 0)), 1, 0);

    const loft_sci least = loft_sci_pow(loft_sci_from_unit(LOFT_UNIT(0.5)), BY_NUM(63, 53, 53));
    CHECK_EXACT(exact_sci(loft_sci_sub(loft_sci_one(), loft_sci_sub(loft_sci_one(), least))),
                exact_sci(least), 0);
}

static void numbers_come_in_and_go_out_as_they_are(arb *a)
{
    const loft_real x = arb_real(a, 32767);
    const loft_unit t = arb_unit(a);
    loft_acc wide = 0;
    loft_unit back = -1;

    CHECK_EXACT(exact_sci(loft_sci_from_real(x)), exact_of(x), 0);
    CHECK_EXACT(exact_sci(loft_sci_from_unit(t)), exact_unit(t), 0);
    CHECK_EXACT(exact_sci(loft_sci_of(loft_prod(x, x))), exact_acc(loft_prod(x, x)), 0);
    CHECK_EXACT(exact_sci(loft_sci_from_acc128(loft_acc128_of(loft_to_acc(x)))), exact_of(x), 0);
    CHECK(loft_sci_to_acc(loft_sci_from_real(x), &wide));
    CHECK_EXACT(exact_acc(wide), exact_of(x), 0);
    CHECK(loft_sci_is_unit(loft_sci_from_unit(t), &back));
    CHECK_EXACT(exact_unit(back), exact_unit(t), 0);
    CHECK(!loft_sci_is_unit(loft_sci_neg(loft_sci_one()), &back) &&
          !loft_sci_is_unit(loft_sci_from_int(2), &back));
#if LOFT_NUM != LOFT_F64
    const loft_sci third = loft_sci_div(loft_sci_from_unit(t), loft_sci_from_int(3));
    CHECK(!loft_sci_is_unit(third, &back) ||
          exact_sci(third) * 16777216 - floorl(exact_sci(third) * 16777216) < 1e-30L ||
          LOFT_NUM == LOFT_F32);
    CHECK(!loft_sci_is_unit(
        loft_sci_add(loft_sci_one(), loft_sci_pow(loft_sci_from_unit(LOFT_UNIT(0.5)), 40)), &back));
#endif
}

static void what_does_not_fit_is_refused(arb *a)
{
    loft_acc wide = (loft_acc)7;
    const loft_sci large = loft_sci_pow(loft_sci_from_int(2), 31 + arb_below(a, 40));

    CHECK(loft_sci_to_acc(large, &wide) == BY_NUM(false, true, true));
    CHECK(BY_NUM(wide == (loft_acc)7, true, true));
    CHECK(loft_sci_to_acc(loft_sci_sub(loft_sci_pow(loft_sci_from_int(2), 31), loft_sci_one()),
                          &wide));
    CHECK_EXACT(exact_acc(wide), 2147483647.0L, 0);
    CHECK(loft_sci_to_acc(loft_sci_div(loft_sci_one(), large), &wide));
    const long double small = exact_sci(loft_sci_div(loft_sci_one(), large));
    CHECK_EXACT(exact_acc(wide),
                BY_NUM(floorl(small * 4294967296.0L + 0.5L) / 4294967296.0L, small, small), 0);
}

/* Three points on a line except for one LSB, and far apart: sign and value are those of
 * integers. */
static void cross_products_are_exact_in_sign_and_close_in_value(arb *a)
{
    __extension__ typedef __int128 wide;
    const int32_t limit = arb_below(a, 2) ? INT32_MAX : 1 << (1 + arb_below(a, 30));
    int32_t raw[4][2];
    loft_real p[4][2];

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            raw[k][i] = arb_raw(a, limit);
    if (arb_below(a, 4) == 0)
        for (int k = 0; k < 8; k++)
            raw[k / 2][k % 2] = arb_below(a, 2) ? limit : -limit;
    const bool triangle = arb_below(a, 4) > 0;
    for (int i = 0; i < 2 && triangle; i++) {
        raw[2][i] = raw[0][i];
        if (arb_below(a, 2))
            raw[3][i] = (int32_t)(((int64_t)raw[0][i] + raw[1][i]) / 2 +
                                  (limit < INT32_MAX ? (int)arb_below(a, 3) - 1 : 0));
    }
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++) {
#if LOFT_NUM == LOFT_F32
            raw[k][i] &= ~0xff;
#endif
            p[k][i] = loft_real_from_raw(raw[k][i]);
        }
    const int64_t u[2] = { (int64_t)raw[1][0] - raw[0][0], (int64_t)raw[1][1] - raw[0][1] };
    const int64_t v[2] = { (int64_t)raw[3][0] - raw[2][0], (int64_t)raw[3][1] - raw[2][1] };
    const wide want = (wide)u[0] * v[1] - (wide)u[1] * v[0];
    const loft_sci got = loft_sci_cross(p[0], p[1], p[2], p[3]);

    CHECK(loft_sci_sign(got) == (want > 0) - (want < 0));
    CHECK_EXACT(exact_sci(got) * 4294967296.0L / (want ? (long double)want : 1), want ? 1 : 0,
                BY_NUM(0x1p-60L, 0x1p-47L, 0x1p-47L));
}

/* Differences that no double represents. */
static void cross_products_of_doubles_of_any_digits_are_exact_in_sign(arb *a)
{
#if LOFT_NUM == LOFT_F64
    const double e = ldexp(1, -(int)arb_below(a, 45) - 52), x = (double)(1 + arb_below(a, 999));
    const loft_real o[2] = { e, 0 }, p[2] = { x, 1 }, q[2] = { 2 * x, 2 }, r[2] = { 2 * x - e, 2 };

    /* (x - e) 2 - (2 x - e) = -e */
    CHECK(loft_sci_sign(loft_sci_cross(o, p, o, q)) == -1);
    CHECK_EXACT(exact_sci(loft_sci_cross(o, p, o, q)) / e, -1, 0x1p-47L);
    if (r[0] < q[0])
        CHECK(loft_sci_sign(loft_sci_cross(o, p, o, r)) == 0);

    /* the same with an e of many digits, from the size of x down */
    const double f = ldexp(1 + 0x1p-48, -(int)arb_below(a, 45));
    const loft_real g[2] = { f, 0 };
    CHECK(loft_sci_sign(loft_sci_cross(g, p, g, q)) == -1);
    CHECK_EXACT(exact_sci(loft_sci_cross(g, p, g, q)) / f, -1, 0x1p-50L);
#else
    (void)a;
    const loft_real o[2] = { 0, 0 };
    CHECK(loft_sci_sign(loft_sci_cross(o, o, o, o)) == 0);
#endif
}

/* Small coefficients and an eighth: all exact. The power form is differentiated term by term. */
static void derivatives_are_those_of_the_power_form(arb *a)
{
    const unsigned degree = arb_below(a, 5), order = arb_below(a, 7), eighths = arb_below(a, 9);
    const double t = eighths / 8.0;
    loft_sci c[5];
    double b[5], want = 0;

    for (unsigned i = 0; i <= degree; i++) {
        const int32_t x = (int32_t)arb_below(a, 201) - 100;
        b[i] = x;
        c[i] = loft_sci_from_int(x);
    }
    double choose = 1;
    for (unsigned k = 0; k <= degree; k++) {
        for (unsigned j = degree; j > k; j--)       /* differences of order k + 1 wait at k + 1.. */
            b[j] -= b[j - 1];
        double term = choose * b[k];
        for (unsigned j = 0; j < order; j++)
            term *= (double)k - (double)j;
        for (unsigned j = order; j < k; j++)
            term *= t;
        want += k < order ? 0 : term;
        choose *= (double)(degree - k) / (k + 1);
    }
    CHECK_EXACT(exact_sci(loft_sci_deriv(c, degree, order, loft_sci_from_unit(LOFT_UNIT(t)))),
                (long double)want, 0);
}

int main(void)
{
    PROPERTY(sums_products_and_quotients_err_by_a_share_of_the_result,   400);
    PROPERTY(what_is_exact_stays_exact,                                 2000);
    PROPERTY(derivatives_are_those_of_the_power_form,                   2000);
    PROPERTY(numbers_come_in_and_go_out_as_they_are,                    2000);
    PROPERTY(what_does_not_fit_is_refused,                               200);
    PROPERTY(cross_products_are_exact_in_sign_and_close_in_value,       4000);
    PROPERTY(cross_products_of_doubles_of_any_digits_are_exact_in_sign,  500);
    return check_failures();
}
