/* tests/lib/num/test_acc128.c -- properties of lib/num/acc128.h
 * SPDX-License-Identifier: MIT
 *
 * The value of a loft_acc128 shows in its quotients: all are read through loft_acc128_project and
 * compared with long double.
 */
#include "support/exact.h"              /* exact_acc, exact_unit, CHECK_EXACT */
#include "num/acc128.h"

/* Below 2^limit in magnitude, multiples of the last bit, extremes included. */
static loft_acc arb_acc(arb *a, int limit)
{
    const int64_t top = ((int64_t)1 << (limit + 31)) + (((int64_t)1 << (limit + 31)) - 1);
    int64_t raw = (int64_t)(arb_next(a) >> 1) % top >> arb_below(a, 40);

    if (arb_below(a, 8) == 0)
        raw = top - (int64_t)arb_below(a, 3);
    if (BY_NUM(false, true, true))
        raw &= ~(int64_t)0x3ff;
    if (arb_below(a, 2))
        raw = -raw;
    return (loft_acc)(BY_NUM(raw, (double)raw * 0x1p-32, (double)raw * 0x1p-32));
}

static loft_acc arb_weight(arb *a, int limit)
{
    const loft_acc w = arb_acc(a, limit);
    return w < 0 ? -w : w > 0 ? w : loft_to_acc(LOFT_REAL(1));
}

/* The last bits of a coordinate and, in floats, of the operations before it. */
static long double bound_of(long double want, int roundings)
{
    const long double by_num[2] = { LSB / 2 + fabsl(want) * 0x1p-61L,
                                    ulp(want) / 2 + fabsl(want) * roundings * 0x1p-53L };
    return by_num[BY_NUM(0, 1, 1)];
}

static void projections_are_rounded_to_nearest(arb *a)
{
    const loft_acc w = arb_weight(a, 30), r = arb_acc(a, 30),
                   x = r > w    ? w - w / 32768
                       : r < -w ? -w
                                : r;
    const long double want = 32768 * exact_acc(x) / exact_acc(w);

    if (want >= 32768 - LSB / 2)
        return;
    CHECK_EXACT(exact_of(loft_acc_project(x, w)), want, bound_of(want, 2));
    CHECK_EXACT(exact_of(loft_acc128_project(loft_acc128_of(x), loft_acc128_of(w))), want,
                bound_of(want, 2));
    CHECK_EXACT(exact_of(loft_acc128_project(loft_acc128_guarded(x), loft_acc128_guarded(w))), want,
                bound_of(want, 2));
}

/* The inverse gives the original coordinate. */
static void weighing_is_the_other_way(arb *a)
{
    const loft_acc w = arb_weight(a, 30);
    const loft_real c = arb_real(a, 32767);
    const long double want = exact_acc(w) / 32768 * exact_of(c);

    CHECK_EXACT(exact_acc(loft_acc_weigh(w, c)), want,
                BY_NUM(0x1p-33L + fabsl(want) * 0x1p-63L, fabsl(want) * 0x1.01p-53L,
                       fabsl(want) * 0x1.01p-53L));
    if (exact_acc(w) > 1)
        CHECK_EXACT(exact_of(loft_acc_project(loft_acc_weigh(w, c), w)), exact_of(c),
                    BY_NUM(0, 0, 2 * ulp(exact_of(c))));
}

/* Exactly half an LSB: (2 k + 1) / 2 LSB of 2^-16, with w a power of two. */
static void ties_go_upward_in_q16(arb *a)
{
    const int32_t k = arb_raw(a, 1 << 29);
    const loft_acc w = loft_to_acc(LOFT_REAL(1024)),
                   x = (loft_acc)(2 * (int64_t)k + 1) *
                       loft_acc_ratio(loft_acc_ratio(w, 65536), 65536);
    const long double want = BY_NUM((k + 1) * LSB, (2 * (int64_t)k + 1) * (LSB / 2),
                                    (2 * (int64_t)k + 1) * (LSB / 2));

    if (BY_NUM(false, true, false))
        return;
    CHECK_EXACT(exact_of(loft_acc_project(x, w)), want, 0);
    CHECK_EXACT(exact_of(loft_acc128_project(loft_acc128_of(x), loft_acc128_of(w))), want, 0);
}

static void sums_and_products_are_exact_in_q16(arb *a)
{
    const loft_acc x = arb_acc(a, 20), y = arb_acc(a, 20), z = arb_acc(a, 20);
    const uint32_t k = (uint32_t)arb_next(a) | 1, m = (uint32_t)arb_next(a) | 1;
    const loft_acc128 sum = loft_acc128_sub(
        loft_acc128_add(loft_acc128_times(loft_acc128_times(loft_acc128_of(x), k), m),
                        loft_acc128_times(loft_acc128_of(y), k)),
        loft_acc128_times(loft_acc128_of(z), m));
    const loft_acc128 by = loft_acc128_times(
        loft_acc128_times(loft_acc128_of(loft_to_acc(LOFT_REAL(4096)) * 512), k), m);
    const long double want = 32768 * (exact_acc(x) * k * m + exact_acc(y) * k - exact_acc(z) * m) /
                             (2097152.0L * k * m);
    const long double size =
        32768 * (fabsl(exact_acc(x)) * k * m + fabsl(exact_acc(y)) * k + fabsl(exact_acc(z)) * m) /
        (2097152.0L * k * m);

    CHECK_EXACT(exact_of(loft_acc128_project(sum, by)), want,
                bound_of(want, 4) + size * BY_NUM(0x1p-60L, 0x1p-51L, 0x1p-51L));
}

static void lerps_keep_their_guard_bits(arb *a)
{
    const loft_acc x = arb_acc(a, 20), y = arb_acc(a, 20), w = loft_to_acc(LOFT_REAL(16384)) * 128;
    const loft_unit t = arb_unit(a);
    const loft_acc128 between = loft_acc128_lerp(loft_acc128_guarded(x), loft_acc128_guarded(y), t);
    const long double u = exact_unit(t), want = ((1 - u) * exact_acc(x) + u * exact_acc(y)) / 64,
                      size = fmaxl(fabsl(exact_acc(x)), fabsl(exact_acc(y))) / 64;

    CHECK_EXACT(exact_of(loft_acc128_project(between, loft_acc128_guarded(w))), want,
                bound_of(want, 2) + size * BY_NUM(0x1p-60L, 0x1p-50L, 0x1p-50L));
    /* with a denominator as small as the last bit of an acc, the bits below it show */
    const loft_acc least = BY_NUM(1, 0x1p-32, 0x1p-32);
    const loft_acc128 little = loft_acc128_lerp(loft_acc128_guarded(0), loft_acc128_guarded(least),
                                                t);
    if (u < 1)
        CHECK_EXACT(exact_of(loft_acc128_project(little, loft_acc128_guarded(least))), 32768 * u,
                    bound_of(32768 * u, 4));
}

static void a_lerp_between_reals_is_exact_in_q16(arb *a)
{
    const loft_acc x = arb_acc(a, 20), y = arb_acc(a, 20), w = loft_to_acc(LOFT_REAL(16384)) * 128;
    const loft_real p = arb_real(a, 32767), q = arb_real(a, 32767), lo = p < q ? p : q,
                    hi = p < q ? q : p;
    const loft_real u = arb_real(a, 32767), at = u < lo ? lo : u > hi ? hi : u;
    if (!(lo < hi))
        return;
    const long double t = (exact_of(at) - exact_of(lo)) / (exact_of(hi) - exact_of(lo));
    const long double want = ((1 - t) * exact_acc(x) + t * exact_acc(y)) / 64,
                      size = fmaxl(fabsl(exact_acc(x)), fabsl(exact_acc(y))) / 64;
    const loft_acc128 between = loft_acc128_lerp_in(loft_acc128_guarded(x), loft_acc128_guarded(y),
                                                    at, lo, hi);

    CHECK_EXACT(exact_of(loft_acc128_project(between, loft_acc128_guarded(w))), want,
                bound_of(want, 2) + size * BY_NUM(0x1p-60L, 0x1p-49L, 0x1p-49L));
    CHECK_EXACT(exact_acc(loft_acc128_to_acc(between, 3)), want * 64 / 3,
                BY_NUM(0x1p-33L, 0, 0) + size * 64 * BY_NUM(0x1p-60L, 0x1p-49L, 0x1p-49L));
}

/* -32768 rounds from half an LSB below it, the largest coordinate from less than half above. */
static void a_rate_fits_to_the_last_half_lsb(arb *a)
{
    const loft_acc h = BY_NUM(65536 * (int64_t)(1 + arb_below(a, UINT32_MAX)), 1, 1),
                   half = BY_NUM(h / 131072, 0, 0);
    const loft_acc top = BY_NUM(32768 * h, (double)LOFT_REAL_MAX, LOFT_REAL_MAX);
    const loft_real far = BY_NUM(INT32_MIN, (loft_real)-LOFT_REAL_MAX, (loft_real)-LOFT_REAL_MAX);
    loft_real v = 0;

    (void)a;
    CHECK(loft_acc_rate(-top - half, h, &v) && v <= far && v >= far);
    CHECK(BY_NUM(!loft_acc_rate(-top - half - 1, h, &v), true, true));
    CHECK(BY_NUM(!loft_acc_rate(top - half, h, &v) || 2 * half * 65536 < h, true, true));
    CHECK(loft_acc_rate(top - half - BY_NUM(1, 0, 0), h, &v) && v >= LOFT_REAL_MAX);
    const loft_acc w = BY_NUM((int64_t)1 << 62, 32768, 32768),
                   part = BY_NUM((int64_t)1 << 30, 0, 0), last = BY_NUM(1, 0, 0);
    const loft_acc full = BY_NUM((int64_t)1 << 62, (double)LOFT_REAL_MAX, LOFT_REAL_MAX);
    CHECK(loft_acc128_rate(loft_acc128_of(-full - part), loft_acc128_of(w), &v) && v <= far);
    CHECK(loft_acc128_rate(loft_acc128_of(full - part - last), loft_acc128_of(w), &v) &&
          v >= LOFT_REAL_MAX);
    if (BY_NUM(true, false, false)) {
        v = 5;
        CHECK(!loft_acc128_rate(loft_acc128_of(-full - part - last), loft_acc128_of(w), &v));
        CHECK(!loft_acc128_rate(loft_acc128_of(full - part), loft_acc128_of(w), &v));
        CHECK(!(v < 5 || v > 5));
    }
}

static void a_step_adds_each_difference_to_the_one_before(arb *a)
{
    loft_acc128 d[4];
    long double c[4];

    for (int k = 0; k < 4; k++) {
        const loft_acc x = arb_acc(a, 10);
        d[k] = loft_acc128_of(x);
        c[k] = exact_acc(x);
    }
    const loft_acc128 w = loft_acc128_of(loft_to_acc(LOFT_REAL(16384)) * 128);
    for (int j = 0; j < 20; j++) {
        loft_acc128_step(d, 3);
        for (int k = 0; k < 3; k++)
            c[k] += c[k + 1];
        const long double want = c[0] / 64;
        CHECK_EXACT(exact_of(loft_acc128_project(d[0], w)), want,
                    bound_of(want, 2) + BY_NUM(0, 0x1p-25L, 0x1p-25L) * 0x1p-8L);
    }
}

int main(void)
{
    PROPERTY(projections_are_rounded_to_nearest,               20000);
    PROPERTY(weighing_is_the_other_way,                        20000);
    PROPERTY(ties_go_upward_in_q16,                             2000);
    PROPERTY(sums_and_products_are_exact_in_q16,               20000);
    PROPERTY(lerps_keep_their_guard_bits,                      20000);
    PROPERTY(a_lerp_between_reals_is_exact_in_q16,             20000);
    PROPERTY(a_rate_fits_to_the_last_half_lsb,                  2000);
    PROPERTY(a_step_adds_each_difference_to_the_one_before,     2000);
    return check_failures();
}
