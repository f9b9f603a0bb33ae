/* tests/support/num_floats.h -- every function of the f32 and f64 backends against long double
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_NUM_FLOATS_H
#define LOFT_TESTS_NUM_FLOATS_H

#include <math.h>           /* sqrtl, frexpl, ldexpl: the reference */

#include "check.h"

#define REAL_BITS BY_NUM(0, 24, 53)

/* The distance between neighbours of a binary number with `bits` bits, at x. */
static long double ulp(long double x, int bits)
{
    int exponent;
    frexpl(x, &exponent);
    return ldexpl(1, exponent - bits);
}

/* |got - want| within `ulps` of the ulp at `scale`. */
static void check_ulps(long double got, long double want, long double scale, int bits,
                       long double ulps)
{
    CHECK_NEAR((got - want) / ulp(scale, bits), 0, ulps);
}

/* Numbers of all sizes from 2^-40 to 2^40; one in eight is a power of two or next to one; never
 * 0. */
static double arb_number(arb *a, int bits)
{
    const uint64_t r = arb_next(a);
    double m = (double)(r >> (64 - bits));
    if (arb_below(a, 8) == 0)
        m = ldexp(1, bits - 1) + (double)arb_below(a, 3) - 1;
    m = ldexp(m + (m < 1), (int)arb_below(a, 80) - 40 - bits);
    return arb_below(a, 2) ? -m : m;
}

static loft_real arb_float(arb *a)   { return (loft_real)arb_number(a, REAL_BITS); }
static loft_acc  arb_double(arb *a)  { return arb_number(a, 53); }
static long double larger(long double x, long double y) { return fabsl(x) > fabsl(y) ? x : y; }

static void products_and_quotients_are_rounded_to_nearest(arb *a)
{
    const loft_real x = arb_float(a), y = arb_float(a);
    const long double product = (long double)x * y, quotient = (long double)x / y;

    check_ulps(loft_mul(x, y), product, product, REAL_BITS, 0.5L);
    check_ulps(loft_div(x, y), quotient, quotient, REAL_BITS, BY_NUM(0, 0.5L, 0.5L + 0x1p-11L));
    check_ulps(loft_prod(x, y), product, product, 53, BY_NUM(0, 0, 0.5L + 0x1p-11L));
    CHECK(loft_to_acc(x) - x <= 0 && loft_to_acc(x) - x >= 0);
}

static void lerp_is_within_two_ulps_and_exact_at_the_ends(arb *a)
{
    const loft_real x = arb_float(a), y = arb_below(a, 2) ? arb_float(a) : x * (loft_real)0.75;
    const loft_unit t = arb_below(a, 2) ? arb_unit(a)
                                        : (loft_unit)((double)(arb_next(a) >> 11) * 0x1p-53);
    const loft_acc  v = arb_double(a), w = arb_double(a);

    check_ulps(loft_lerp(x, y, t), (1 - (long double)t) * x + (long double)t * y, larger(x, y),
               REAL_BITS, 2);
    check_ulps(loft_acc_lerp(v, w, t), (1 - (long double)t) * v + (long double)t * w, larger(v, w),
               53, 2);
    check_ulps(loft_lerp(x, y, 0), x, x, REAL_BITS, 0);
    check_ulps(loft_lerp(x, y, 1), y, y, REAL_BITS, 0);
    check_ulps(loft_acc_lerp(v, w, 0), v, v, 53, 0);
    check_ulps(loft_acc_lerp(v, w, 1), w, w, 53, 0);
}

static void a_lerp_at_a_fraction_is_within_three_ulps(arb *a)
{
    const loft_acc x = arb_double(a), y = arb_below(a, 2) ? arb_double(a) : x * 0.75;
    const uint32_t n = 1 + (arb_below(a, (1u << 30) - 1) >> arb_below(a, 30)),
                   j = arb_below(a, 2 * n + 1);
    const long double t = (long double)j / n;

    check_ulps(loft_acc_lerp_at(x, y, j, n), (1 - t) * x + t * y, larger(x, y) * (j > n ? t : 1),
               53, 3);
    check_ulps(loft_acc_lerp_at(x, y, 0, n), x, x, 53, 0);
    check_ulps(loft_acc_lerp_at(x, y, n, n), y, y, 53, 0);
    check_ulps(loft_acc_mean(x, y), ((long double)x + y) / 2, ((long double)x + y) / 2, 53,
               0.5L + 0x1p-11L);
}

static void a_blend_is_within_three_ulps_and_exact_at_the_corners(arb *a)
{
    const loft_acc x = arb_double(a), y = arb_below(a, 2) ? arb_double(a) : x * 0.75,
                   z = arb_below(a, 2) ? arb_double(a) : y;
    const loft_unit v = arb_unit(a) * (loft_unit)(arb_below(a, 2) ? 1 : -3), w = arb_unit(a);
    const long double u = 1 - (long double)v - w, growth = fabsl(u) + fabsl(v) + w;

    check_ulps(loft_acc_lerp3(x, y, z, v, w), u * x + (long double)v * y + (long double)w * z,
               larger(larger(x, y), z) * growth, 53, 3);
    check_ulps(loft_acc_lerp3(x, y, z, 0, 0), x, x, 53, 0);
    check_ulps(loft_acc_lerp3(x, y, z, 1, 0), y, y, 53, 0);
    check_ulps(loft_acc_lerp3(x, y, z, 0, 1), z, z, 53, 0);
    check_ulps(loft_unit_round(x), x, x, REAL_BITS, BY_NUM(0, 0.5L, 0));
}

static void wide_operations_are_rounded_to_nearest(arb *a)
{
    const loft_acc  x = arb_double(a);
    const loft_real y = arb_float(a);
    const int32_t   k = 1 + (int32_t)(arb_next(a) >> 33 >> arb_below(a, 30)) % INT32_MAX;
    const long double half = 0.5L + 0x1p-11L;       /* the reference itself has 64 bits */

    check_ulps(loft_acc_scale(x, y), (long double)x * y, (long double)x * y, 53, half);
    check_ulps(loft_acc_mul(x, y), (long double)x * y, (long double)x * y, 53, half);
    check_ulps(loft_acc_div(x, y), (long double)x / y, (long double)x / y, 53, half);
    check_ulps(loft_acc_ratio(x, k), (long double)x / k, (long double)x / k, 53, half);
    check_ulps(loft_acc_round(x), x, x, REAL_BITS, BY_NUM(0, 0.5L, 0));
}

static void what_fits_a_real_is_known(arb *a)
{
    const loft_acc most = (loft_acc)LOFT_REAL_MAX;

    CHECK(loft_acc_valid(arb_double(a)) && loft_acc_valid(most) && loft_acc_valid(-most));
    CHECK(!loft_acc_valid(INFINITY) && !loft_acc_valid(-INFINITY) && !loft_acc_valid(NAN));
    CHECK(loft_real_valid(LOFT_REAL_REACH) && loft_real_valid(-LOFT_REAL_REACH) &&
          loft_real_valid(0));
    CHECK(!loft_real_valid((loft_real)INFINITY) && !loft_real_valid(-(loft_real)INFINITY) &&
          !loft_real_valid((loft_real)NAN));
    CHECK(loft_acc_valid(most * 1.0001) == false && loft_acc_valid(-most * 1.0001) == false);
}

static void roots_are_within_their_bound(arb *a)
{
    loft_acc x = fabs(arb_double(a));

    if (arb_below(a, 4) == 0)
        x = ldexp(x,
                  REAL_BITS == 24 ? (int)arb_below(a, 200) - 100 : (int)arb_below(a, 1900) - 950);
    const long double want = sqrtl(x);
    check_ulps(loft_acc_sqrt(x), want, want, REAL_BITS, BY_NUM(0, 0.5001L, 0.5001L));
    CHECK(!(loft_acc_sqrt(0) > 0) && !(loft_acc_sqrt(-x) > 0));

    const loft_acc whole = arb_below(a, 4096);
    check_ulps(loft_acc_sqrt(whole * whole), whole, whole, REAL_BITS, 0);
}

static void hypot_is_within_its_bound(arb *a)
{
    loft_acc x[6];
    long double sum = 0;
    const int n = (int)arb_below(a, 7), far = (int)arb_below(a, 1900) - 950;

    for (int i = 0; i < n; i++) {
        x[i] = ldexp(arb_below(a, 2) ? arb_double(a) : (double)arb_real(a, 32767), far);
        sum += (long double)x[i] * (long double)x[i];
    }
    const long double want = sqrtl(sum);
    CHECK_NEAR(want > 0 ? (loft_acc_hypot(x, n) - want) / want : loft_acc_hypot(x, n), 0, 0x1p-50L);
}

static void parameters_are_nearest(arb *a)
{
    const uint32_t n = 1 + (uint32_t)(arb_next(a) >> 33 >> arb_below(a, 31)),
                   j = arb_below(a, n) + arb_below(a, 2);
    const long double want = (long double)j / n;

    check_ulps(loft_unit_of(j, n), want, want, REAL_BITS, BY_NUM(0, 0.5001L, 0.5L + 0x1p-11L));
    check_ulps(loft_unit_of(n, n), 1, 1, REAL_BITS, 0);
}

static void ratios_of_accs_are_nearest(arb *a)
{
    const loft_acc x = arb_double(a), y = fabs(arb_double(a));
    const long double want = (long double)x / y;
    check_ulps(loft_unit_ratio(x, y), want, want, REAL_BITS, BY_NUM(0, 0.5001L, 0.5L + 0x1p-11L));
    check_ulps(loft_unit_ratio(-y, y), -1, 1, REAL_BITS, 0);
    check_ulps(loft_acc_quot(x, y), want, want, REAL_BITS, BY_NUM(0, 0.5001L, 0.5L + 0x1p-11L));
}

static void grains_are_one_to_two_ulps(arb *a)
{
    const loft_acc x = fabs(arb_double(a));
    CHECK(loft_acc_ulp(x) >= (loft_acc)ulp(x, 53) && loft_acc_ulp(x) <= 2 * (loft_acc)ulp(x, 53));
    CHECK(loft_real_ulp(x) >= (loft_acc)ulp(x, REAL_BITS) &&
          loft_real_ulp(x) <= 2 * (loft_acc)ulp(x, REAL_BITS));
}

static void conversions_are_exact(arb *a)
{
    const int32_t i = (int32_t)(uint32_t)arb_next(a) >> arb_below(a, 31);

    check_ulps(loft_real_from_int(i), i, i, REAL_BITS,
               BY_NUM(0, i <= 16777216 && i >= -16777216 ? 0 : 0.5L, 0));
    /* below 2^20 */
    const loft_real x = (loft_real)i * (loft_real)0.000244140625 + arb_real(a, 1);
    CHECK((long double)loft_real_floor(x) - floorl(x) <= 0 &&
          (long double)loft_real_floor(x) - floorl(x) >= 0);
    check_ulps(loft_unit_from(x), x, x, REAL_BITS, 0);
}

/* To the nearest whole number, ties upward; and to raw Q16.16 and back. */
static void whole_and_raw_numbers_are_nearest(arb *a)
{
    const int32_t i = (int32_t)(uint32_t)arb_next(a) >> arb_below(a, 31);
    const loft_acc part[5] = { -0.5, -0.25, 0, 0.25, 0x1.fffffp-2 },
                   most = 2147483647.0 + 0x1.fffffp-2;
    const loft_real x = loft_real_from_raw(i), y = (loft_real)arb_number(a, 30);

    for (int k = 0; k < 5; k++)
        CHECK(loft_acc_int((loft_acc)i + part[k]) == i);
    CHECK(loft_acc_int(most) == INT32_MAX && loft_acc_int(-2147483648.0) == INT32_MIN);
    check_ulps(x, i / 65536.0L, i / 65536.0L, REAL_BITS, BY_NUM(0, 0.5L, 0));
    if (loft_raw_valid(x))
        CHECK_NEAR(loft_raw_from_real(x), (long double)x * 65536, 0);
    if (loft_raw_valid(y))
        CHECK_NEAR(loft_raw_from_real(y) - (long double)y * 65536, 0, 0.5000001L);
    CHECK(loft_raw_valid(y) ==
          ((long double)y > -32768 - 0x1p-17L && (long double)y < 32768 - 0x1p-17L));
    CHECK(loft_raw_valid(-32768) && !loft_raw_valid(32768) &&
          !loft_raw_valid((loft_real)-32768.1) && !loft_raw_valid((loft_real)NAN));
}

static void floors_of_whole_numbers_and_extremes_are_exact(arb *a)
{
    (void)a;
    for (int32_t i = -70000; i <= 70000; i++)
        CHECK(loft_real_floor((loft_real)i) == i &&
              loft_real_floor((loft_real)i + (loft_real)0.5) == i &&
              loft_real_floor((loft_real)i - (loft_real)0.25) == i - 1);
    CHECK(loft_real_floor((loft_real)-2147483648.0) == INT32_MIN &&
          loft_real_floor((loft_real)2147483520.0) == 2147483520);
}

static void constants_are_nearest(arb *a)
{
    (void)a;
    check_ulps(LOFT_REAL(0.1), 0.1L, 0.1L, REAL_BITS, 0.5L);
    check_ulps(LOFT_UNIT(1.0 / 3), 1.0L / 3, 1.0L / 3, REAL_BITS, 0.5001L);
    check_ulps(LOFT_REAL(-32768), -32768, 1, REAL_BITS, 0);
    CHECK(!(LOFT_REAL_LSB > 0) && !(LOFT_REAL_LSB < 0));
}

static int test_num(void)
{
    PROPERTY(products_and_quotients_are_rounded_to_nearest,    200000);
    PROPERTY(lerp_is_within_two_ulps_and_exact_at_the_ends,    200000);
    PROPERTY(a_lerp_at_a_fraction_is_within_three_ulps,        200000);
    PROPERTY(a_blend_is_within_three_ulps_and_exact_at_the_corners, 200000);
    PROPERTY(wide_operations_are_rounded_to_nearest,           200000);
    PROPERTY(what_fits_a_real_is_known,                           100);
    PROPERTY(roots_are_within_their_bound,                     200000);
    PROPERTY(hypot_is_within_its_bound,                        100000);
    PROPERTY(parameters_are_nearest,                           200000);
    PROPERTY(ratios_of_accs_are_nearest,                       100000);
    PROPERTY(grains_are_one_to_two_ulps,                       100000);
    PROPERTY(conversions_are_exact,                            100000);
    PROPERTY(whole_and_raw_numbers_are_nearest,                100000);
    PROPERTY(floors_of_whole_numbers_and_extremes_are_exact,        1);
    PROPERTY(constants_are_nearest,                                 1);
    return check_failures();
}

#endif
