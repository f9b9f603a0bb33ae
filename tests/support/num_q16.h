/* tests/support/num_q16.h -- every function of the q16 backend against exact integers
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_NUM_Q16_H
#define LOFT_TESTS_NUM_Q16_H

#include <math.h>           /* sqrtl: the reference of hypot */

#include "check.h"

__extension__ typedef __int128 wide;

/* n / d to nearest, ties upward: the rounding of q16 everywhere. */
static wide round_quotient(wide n, wide d)
{
    if (d < 0) {
        n = -n;
        d = -d;
    }
    n = 2*n + d;
    d = 2*d;
    return n / d - (n % d < 0);
}

static wide size_of(wide x) { return x < 0 ? -x : x; }

/* The k-th of EDGES numbers: all of +-2^e - 1, 2^e, 2^e + 1 with up to `bits` bits and a sign. */
#define EDGES(bits) (6 * (bits) + 3)
static int64_t edge_number(int k, int bits)
{
    const int64_t most = (int64_t)(((uint64_t)1 << bits) - 1);
    if (k >= 6 * bits)
        return k == 6 * bits ? most : k == 6 * bits + 1 ? most - 1 : -most - 1;
    const int64_t v = ((int64_t)1 << k / 6) + k % 3 - 1;
    return k / 3 % 2 ? -v : v;
}

/* Pairs of an edge number and a 16-bit number (all of them), at several scales. */
static void each_pair(void (*pair)(int32_t a, int32_t b))
{
    for (int k = 0; k < EDGES(31); k++) {
        const int32_t b = (int32_t)edge_number(k, 31);
        for (int j = 0; j < EDGES(31); j++)
            pair((int32_t)edge_number(j, 31), b);
        for (int32_t j = -32768; j < 32768; j += CHECK_STEP)
            pair(j, b);
        for (int32_t j = -32768; j < 32768; j += 5 * CHECK_STEP)
            pair(j * 65536 + 21845, b);
    }
}

static void check_product(int32_t a, int32_t b)
{
    const wide exact = (wide)a * b, want = round_quotient(exact, 65536);

    CHECK(loft_prod(a, b) == exact);
    CHECK(loft_acc_int(loft_prod(a, b)) == round_quotient(exact, (wide)1 << 32));
    if (b >= 0)
        CHECK(loft_prod_int(a, b) == round_quotient(exact, (wide)1 << 32));
    if (want >= INT32_MIN && want <= INT32_MAX)
        CHECK(loft_mul(a, b) == want);
    CHECK(loft_acc_valid(loft_prod(a, b)) == (want >= INT32_MIN && want <= INT32_MAX));
}

static void check_quotient(int32_t a, int32_t b)
{
    if (b == 0)
        return;
    const wide n = (wide)a * 65536 * (b < 0 ? -1 : 1), d = size_of(b);
    if (n >= -((wide)1 << 31) * d && n < ((wide)1 << 31) * d)
        CHECK(loft_div(a, b) == round_quotient(n, d));
}

static void between(int32_t a, int32_t b)
{
    static const int32_t t[] = {
        0,       1,       2,       3,        255,      256,      4194303,
        8388607, 8388608, 8388609, 11184811, 16777214, 16777215, 16777216
    };

    for (unsigned k = 0; k < sizeof t / sizeof *t; k++)
        CHECK(loft_lerp(a, b, t[k]) ==
              round_quotient(((wide)b - a) * t[k] + (wide)a * 16777216, 16777216));
    CHECK(loft_lerp(a, b, LOFT_UNIT(1)) == b && loft_lerp(a, b, 0) == a);
}

static void products_are_rounded_to_nearest(arb *a)
{
    (void)a;
    each_pair(check_product);
}
static void quotients_are_rounded_to_nearest(arb *a)
{
    (void)a;
    each_pair(check_quotient);
}

static void lerps_are_rounded_to_nearest(arb *a)
{
    (void)a;
    for (int k = 0; k < EDGES(31); k++)
        for (int j = 0; j < EDGES(31); j++)
            between((int32_t)edge_number(j, 31), (int32_t)edge_number(k, 31));
    /* a third of all parameters, of two spans */
    for (int32_t t = 0; t <= 16777216; t += 3 * CHECK_STEP)
        CHECK(loft_lerp(INT32_MIN, INT32_MAX, t) ==
                  round_quotient((wide)UINT32_MAX * t + (wide)INT32_MIN * 16777216, 16777216) &&
              loft_lerp(7, -65536, t) ==
                  round_quotient((wide)-65543 * t + (wide)7 * 16777216, 16777216));
}

static void random_pairs_obey_the_same_laws(arb *a)
{
    for (int k = 0; k < 1000; k++) {
        const uint64_t r = arb_next(a);
        const int32_t x = (int32_t)(uint32_t)(r >> 32) >> arb_below(a, 31),
                      y = (int32_t)(uint32_t)r >> arb_below(a, 31);
        const int32_t t = (int32_t)arb_below(a, 16777217);
        check_product(x, y);
        check_quotient(x, y);
        between(x, y);
        CHECK(loft_lerp(x, y, t) ==
              round_quotient(((wide)y - x) * t + (wide)x * 16777216, 16777216));
    }
}

/* One acc x with one real or unit a. */
static void check_wide(int64_t x, int32_t a)
{
    const wide room = (wide)1 << 62;

    if (size_of((wide)x * a) <= room << 24)
        CHECK(loft_acc_scale(x, a) == round_quotient((wide)x * a, 16777216));
    if (size_of((wide)x * a) <= room << 16)
        CHECK(loft_acc_mul(x, a) == round_quotient((wide)x * a, 65536));
    if (a != 0 && size_of(x) < (wide)1 << 47 && size_of((wide)x * 65536) < room * size_of(a))
        CHECK(loft_acc_div(x, a) == round_quotient((wide)x * 65536, a));
    if (a >= 1)
        CHECK(loft_acc_ratio(x, a) == round_quotient(x, a));
    for (int k = 0; k < EDGES(62); k += 5) {
        const int64_t y = edge_number(k, 62);
        const wide rise = ((wide)y - x) * a;
        if (size_of(x) < room && size_of(y) < room &&
            ((a >= 0 && a <= 16777216) || size_of(rise) <= room << 24))
            CHECK(loft_acc_lerp(x, y, a) == round_quotient(rise + (wide)x * 16777216, 16777216));
    }
}

static void wide_operations_are_rounded_to_nearest(arb *a)
{
    (void)a;
    for (int j = 0; j < EDGES(63); j++)
        for (int k = 0; k < EDGES(31); k++)
            check_wide(edge_number(j, 63), (int32_t)edge_number(k, 31));
    for (int32_t t = -65536; t <= 65536; t += CHECK_STEP) {
        check_wide(INT64_C(0x123456789abcdef), t * 256);
        check_wide(-INT64_C(0x7fffffffffff), t);
    }
}

static void random_wide_operations_are_rounded_to_nearest(arb *a)
{
    for (int k = 0; k < 200; k++) {
        const int64_t x = (int64_t)arb_next(a) >> arb_below(a, 63);
        check_wide(x, (int32_t)(uint32_t)arb_next(a) >> arb_below(a, 31));
        check_wide(x, (int32_t)arb_below(a, 16777217));
    }
}

/* The parameter j / n is not rounded; also beyond n, up to 2 n. */
static void a_lerp_at_a_fraction_is_rounded_to_nearest(arb *a)
{
    const int64_t x = (int64_t)arb_next(a) >> (1 + arb_below(a, 62)),
                  y = (int64_t)arb_next(a) >> (1 + arb_below(a, 62));
    const uint32_t n = 1 + (arb_below(a, (1u << 30) - 1) >> arb_below(a, 30)),
                   j = arb_below(a, 2 * n + 1);

    if (j <= n || size_of(((wide)y - x) * j) <= ((wide)n << 62))
        CHECK(loft_acc_lerp_at(x, y, j, n) ==
              (int64_t)round_quotient((wide)x * n + ((wide)y - x) * j, n));
    CHECK(loft_acc_lerp_at(x, y, 0, n) == x && loft_acc_lerp_at(x, y, n, n) == y);
    CHECK(loft_acc_mean(x, y) == (int64_t)round_quotient((wide)x + y, 2));
}

static void check_blend(int64_t x, int64_t y, int64_t z, int32_t v, int32_t w)
{
    CHECK(loft_acc_lerp3(x, y, z, v, w) ==
          (int64_t)round_quotient((wide)x * 16777216 + ((wide)y - x) * v + ((wide)z - x) * w,
                                  16777216));
}

/* Inside the triangle of weights any numbers up to 2^30, outside it smaller ones. */
static void a_blend_is_rounded_to_nearest(arb *a)
{
    const int64_t edges[3] = { ((int64_t)1 << 62) - 1, 1 - ((int64_t)1 << 62), 0 };
    int64_t x[3], small[3];

    for (int k = 0; k < 3; k++) {
        x[k] = arb_below(a, 3) ? (int64_t)arb_next(a) >> (1 + arb_below(a, 62))
                               : edges[arb_below(a, 3)];
        small[k] = x[k] / 128;
    }
    const int32_t v = (int32_t)arb_below(a, 16777217),
                  w = (int32_t)arb_below(a, (uint32_t)(16777217 - v));
    const int32_t far[3] = { 1 << 29, -(1 << 29), (int32_t)(arb_next(a) >> 34) - (1 << 29) };
    check_blend(x[0], x[1], x[2], v, w);
    check_blend(x[0], x[1], x[2], v, 16777216 - v);
    check_blend(small[0], small[1], small[2], far[arb_below(a, 3)], far[arb_below(a, 3)]);
    CHECK(loft_acc_lerp3(x[0], x[1], x[2], 0, 0) == x[0] &&
          loft_acc_lerp3(x[0], x[1], x[2], LOFT_UNIT(1), 0) == x[1] &&
          loft_acc_lerp3(x[0], x[1], x[2], 0, LOFT_UNIT(1)) == x[2]);
    const int64_t u = (int64_t)arb_next(a) >> (25 + arb_below(a, 39));
    CHECK(loft_unit_round(u) == (int32_t)round_quotient(u, 256));
}

static void rounding_an_acc_is_exact_where_it_fits(arb *a)
{
    (void)a;
    for (int j = 0; j < EDGES(31); j++) {
        const int32_t r = (int32_t)edge_number(j, 31);
        CHECK(loft_acc_round(loft_to_acc(r)) == r && loft_to_acc(r) == (wide)r * 65536);
        for (int32_t low = -65536; low <= 65536; low += CHECK_STEP) {
            const wide x = (wide)r * 65536 + low, want = round_quotient(x, 65536);
            const bool fits = want >= INT32_MIN && want <= INT32_MAX;
            CHECK(loft_acc_valid((int64_t)x) == fits);
            if (fits)
                CHECK(loft_acc_round((int64_t)x) == want);
        }
    }
    CHECK(!loft_acc_valid(INT64_MAX) && !loft_acc_valid(INT64_MIN));
}

/* r is the nearest root of x: (r - 1/2)^2 <= x <= (r + 1/2)^2, times 4. */
static void check_root(int64_t x)
{
    const wide r = loft_acc_sqrt(x), low = 2*r - 1, high = 2*r + 1;

    if (x < 0)
        CHECK(r == 0);
    else if (x <= ((int64_t)1 << 62) - ((int64_t)1 << 31))
        CHECK((r == 0 || low*low <= 4*(wide)x) && high*high >= 4*(wide)x);
    else
        CHECK(r == INT32_MAX);
}

static void roots_are_nearest(arb *a)
{
    for (int64_t x = -10; x < 300000; x += CHECK_STEP)
        check_root(x);
    for (int j = 0; j < EDGES(63); j++)
        check_root(edge_number(j, 63));
    for (int64_t r = INT32_MAX; r > 0; r -= 30011) {    /* next to squares and to midpoints between
                                                         * roots */
        for (int d = -1; d <= 1; d++) {
            check_root(r*r + d);
            check_root(r*r + r + d);
        }
    }
    for (int k = 0; k < 200000; k++)
        check_root((int64_t)(arb_next(a) >> arb_below(a, 64) >> 1));
    check_root(((int64_t)1 << 62) - ((int64_t)1 << 31) + 1);
    check_root(INT64_MAX);
    check_root(INT64_MIN);
}

static void hypot_is_within_its_bound(arb *a)
{
    int64_t x[6];
    long double sum = 0;
    const int n = (int)arb_below(a, 7), shift = 2 + (int)arb_below(a, 61);
    const bool same = arb_below(a, 2);

    for (int i = 0; i < n; i++) {
        x[i] = (int64_t)arb_next(a) >> shift >> (same ? 0 : arb_below(a, 3));
        if (arb_below(a, 20) == 0)
            x[i] = arb_below(a, 2) ? ((int64_t)1 << 61) - 1 : 1 - ((int64_t)1 << 61);
        sum += (long double)x[i] * (long double)x[i];
    }
    const long double want = sqrtl(sum), got = (long double)loft_acc_hypot(x, n);
    CHECK_NEAR(got - want, 0, want / 268435456.0L + 1);
}

/* Each part rounds the same way by nearly 1/2; five of them are in the worst proportion. */
static void hypot_is_within_its_bound_at_the_worst(arb *a)
{
    const int down = 1 + (int)arb_below(a, 30);
    const int64_t half = ((int64_t)1 << down >> 1) - 1,
                  first = ((int64_t)1 << 29) + arb_below(a, 1000), part = first * 29 / 100;
    const bool all = arb_below(a, 2);
    int64_t x[6];
    long double sum = 0;

    for (int i = 0; i < 6; i++) {
        x[i] = ((i == 0 || all ? first : part + arb_below(a, 1000)) << down) + half;
        sum += (long double)x[i] * (long double)x[i];
    }
    const long double want = sqrtl(sum);
    CHECK_NEAR((long double)loft_acc_hypot(x, 6) - want, 0, want / 268435456.0L + 1);
}

static void hypot_of_whole_triples_is_exact_when_small(arb *a)
{
    const int64_t k = 1 + (int64_t)arb_below(a, 20000000), x[3] = { -3 * k, 4 * k, 0 },
                  y[6] = { k, -k, k, k, 0, 0 };
    CHECK(loft_acc_hypot(x, 3) == 5 * k);
    CHECK(loft_acc_hypot(y, 6) == 2 * k);
    CHECK(loft_acc_hypot(y, 0) == 0);
}

static void parameters_are_nearest(arb *a)
{
    for (uint32_t n = 1; n < 700; n++)
        for (uint32_t j = 0; j <= n; j++)
            CHECK(loft_unit_of(j, n) == round_quotient((wide)j << 24, n));
    for (int k = 0; k < 100000; k++) {
        const uint32_t n = 1 + ((uint32_t)(arb_next(a) >> 32) >> arb_below(a, 32)) % UINT32_MAX,
                       j = arb_below(a, n);
        CHECK(loft_unit_of(j, n) == round_quotient((wide)j << 24, n) &&
              loft_unit_of(n, n) == LOFT_UNIT(1));
    }
    CHECK(loft_unit_of(UINT32_MAX, UINT32_MAX) == 16777216 && loft_unit_of(0, UINT32_MAX) == 0);
}

/* y from 1 to 2^62, x up to 3/2 of it. */
static void ratios_of_accs_are_parameters(arb *a)
{
    const int64_t y = 1 + (int64_t)(arb_next(a) >> 2 >> arb_below(a, 62));
    const int64_t most = arb_below(a, 8) ? y : y / 2 * 3 / (arb_below(a, 2) ? 1 : 2);
    const int64_t x = arb_below(a, 8) ? (int64_t)(arb_next(a) >> 2) % (most + 1) : most;

    CHECK_NEAR((long double)loft_unit_ratio(x, y) - 0x1p24L * (long double)x / (long double)y, 0,
               0.5L + 0x1p-11L);
    CHECK(loft_unit_ratio(-x, y) == -loft_unit_ratio(x, y));
    CHECK(loft_unit_ratio(y, y) == LOFT_UNIT(1) && loft_unit_ratio(-y, y) == LOFT_UNIT(-1) &&
          loft_unit_ratio(0, y) == 0);
}

/* A quotient of two wide numbers of any size that fits a real. */
static void wide_quotients_are_within_their_bound(arb *a)
{
    const int64_t y = (int64_t)(arb_next(a) >> 1 >> arb_below(a, 63)) + 1,
                  most = y > INT64_MAX / 32767 ? INT64_MAX : y * 32767;
    int64_t x = (int64_t)(arb_next(a) >> 1 >> arb_below(a, 63));

    x = arb_below(a, 8) == 0 ? most : x > most ? x % most : x;
    x = arb_below(a, 2) ? x : -x;
    const long double want = 65536.0L * (long double)x / (long double)y;
    CHECK_NEAR((long double)loft_acc_quot(x, y) - want, 0,
               0.5L + 0x1p-11L + fabsl(want) * 0x1p-30L);
}

static void conversions_are_exact(arb *a)
{
    (void)a;
    for (int32_t i = -32768; i < 32768; i++) {
        CHECK(loft_real_from_int(i) == (wide)i * 65536);
        CHECK(loft_real_floor(i * 65536) == i && loft_real_floor(i * 65536 + 65535) == i &&
              loft_real_floor(i) == (i < 0 ? -1 : 0));
    }
    for (int32_t i = -8388608 + 1; i < 8388608; i++)
        CHECK(loft_unit_from(i) == (wide)i * 256);
    CHECK(loft_real_floor(INT32_MIN) == -32768 && loft_real_floor(INT32_MAX) == 32767);
}

static void constants_are_nearest(arb *a)
{
    (void)a;
    CHECK(LOFT_REAL(0) == 0 && LOFT_REAL(1.25) == 81920 && LOFT_REAL(-1.25) == -81920);
    CHECK(LOFT_REAL(0.00001) == 1 && LOFT_REAL(-0.00001) == -1 && LOFT_REAL(0.000007) == 0);
    CHECK(LOFT_REAL(-32768) == INT32_MIN && LOFT_REAL(32767.9999847) == INT32_MAX &&
          LOFT_REAL_MAX == INT32_MAX);
    CHECK(LOFT_UNIT(0.5) == 8388608 && LOFT_UNIT(1) == 16777216 && LOFT_UNIT(1.0 / 3) == 5592405 &&
          LOFT_UNIT(-128) == INT32_MIN);
    CHECK(loft_real_from_raw(INT32_MIN) == INT32_MIN &&
          loft_raw_from_real(INT32_MAX) == INT32_MAX && loft_raw_valid(INT32_MIN));
    CHECK(LOFT_REAL_LSB == 1 && loft_acc_ulp(INT64_MAX) == 1 && loft_real_ulp(0) == loft_to_acc(1));
    CHECK(loft_real_valid(INT32_MIN) && loft_real_valid(INT32_MAX));
}

static int test_num(void)
{
    PROPERTY(products_are_rounded_to_nearest,                   1);
    PROPERTY(quotients_are_rounded_to_nearest,                  1);
    PROPERTY(lerps_are_rounded_to_nearest,                      1);
    PROPERTY(random_pairs_obey_the_same_laws,                  50);
    PROPERTY(wide_operations_are_rounded_to_nearest,            1);
    PROPERTY(random_wide_operations_are_rounded_to_nearest,   200);
    PROPERTY(a_lerp_at_a_fraction_is_rounded_to_nearest,    50000);
    PROPERTY(a_blend_is_rounded_to_nearest,                100000);
    PROPERTY(rounding_an_acc_is_exact_where_it_fits,            1);
    PROPERTY(roots_are_nearest,                                 1);
    PROPERTY(hypot_is_within_its_bound,                    100000);
    PROPERTY(hypot_is_within_its_bound_at_the_worst,        20000);
    PROPERTY(hypot_of_whole_triples_is_exact_when_small,     2000);
    PROPERTY(parameters_are_nearest,                            1);
    PROPERTY(ratios_of_accs_are_parameters,                100000);
    PROPERTY(wide_quotients_are_within_their_bound,        100000);
    PROPERTY(conversions_are_exact,                             1);
    PROPERTY(constants_are_nearest,                             1);
    return check_failures();
}

#endif
