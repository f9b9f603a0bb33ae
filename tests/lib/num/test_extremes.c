/* tests/lib/num/test_extremes.c -- functions that take any number take the most negative one too
 * SPDX-License-Identifier: MIT
 */
#include "support/extremes.h"           /* extreme_acc; exact_acc, CHECK_EXACT */
#include "num/acc128.h"
#include "num/angle.h"
#include "num/exact.h"
#include "num/explog.h"
#include "num/muldiv.h"

static void the_angle_of_any_vector_is_within_its_bound(arb *a)
{
    const loft_acc y = extreme_acc(a), x = extreme_acc(a);
    const long double got = (long double)loft_fine_atan2(y, x) * BY_NUM(0x1p-60L, 1, 1);

    CHECK_EXACT(got, atan2l(exact_acc(y), exact_acc(x)), BY_NUM(0x1p-56L, 0x1p-50L, 0x1p-50L));
    CHECK_EXACT(exact_acc(loft_atan2(y, x)), atan2l(exact_acc(y), exact_acc(x)),
                BY_NUM(0x1p-33L + 0x1p-40L, 0x1p-50L, 0x1p-50L));
}

static void quotients_of_any_numbers_are_within_their_bounds(arb *a)
{
    const loft_acc x = extreme_acc(a), y = extreme_acc(a);
    const long double q = y > 0 || y < 0 ? exact_acc(x) / exact_acc(y) : 1e9L;
    loft_real rate;

    if (fabsl(q) > 0 && fabsl(q) < 0x1p-30L)
        return;                                 /* floats: below the normal numbers */
    if (y > 0 && fabsl(q) < 32767)
        CHECK_EXACT(exact_of(loft_acc_quot(x, y)), q,
                    BY_NUM(0x1p-17L, 0x1p-24L, 0x1p-53L) * BY_NUM(1, fabsl(q), fabsl(q)) +
                        BY_NUM(fabsl(q) * 0x1p-30L, 0, 0));
    if (y > 0 && fabsl(q) <= 1 && q < 1 - 0x1p-31L)
        CHECK_EXACT(exact_of(loft_acc_project(x, y)), 32768 * fmaxl(q, -1),
                    BY_NUM(1.5L * 0x1p-17L, 0x1p-9L, 0x1p-38L));
    if (fabsl(q) < 7)
        CHECK_EXACT((long double)loft_fine_ratio(x, y) * BY_NUM(0x1p-60L, 1, 1), q,
                    BY_NUM(0x1p-61L * 1.01L, 0x1p-50L, 0x1p-50L));
    if (y > 0 && BY_NUM(y < (loft_acc)1 << 48, true, true))
        if (loft_acc_rate(x, y, &rate))
            CHECK_EXACT(exact_of(rate), q,
                        BY_NUM(0x1p-17L, 0x1p-24L, 0x1p-53L) *
                            BY_NUM(1, fmaxl(1, fabsl(q)), fmaxl(1, fabsl(q))));
    CHECK(loft_sci_sign(loft_sci_of(x)) == (x > 0) - (x < 0));
}

static void any_number_times_a_fraction_is_within_its_bound(arb *a)
{
    const loft_acc x = extreme_acc(a);
    const loft_fine f = BY_NUM((loft_fine)1 << (50 + arb_below(a, 9)), 0.25, 0.25);
    const long double want = exact_acc(x) * (long double)f * BY_NUM(0x1p-60L, 1, 1);

    if (BY_NUM(fabsl(want) < 0x1p30L, true, true))
        CHECK_EXACT(exact_acc(loft_fine_scale(x, f)), want, BY_NUM(0x1p-33L, 0, 0));
}

static void any_coordinate_is_taken_or_refused(arb *a)
{
    const loft_real x = extreme_real(a), y = extreme_real(a);
    const loft_unit t = arb_unit(a);

    CHECK(loft_real_abs(x) >= 0 && loft_real_abs(x) >= x && -loft_real_abs(x) - LOFT_REAL_LSB <= x);
    CHECK_EXACT(exact_of(loft_lerp(x, y, loft_unit_of(0, 1))), exact_of(x), 0);
    CHECK_EXACT(exact_of(loft_lerp(x, y, loft_unit_of(1, 1))), exact_of(y), 0);
    const loft_real between = loft_lerp(x / 2, y / 2, t);
    const long double least = fminl(exact_of(x), exact_of(y)) / 2,
                      most = fmaxl(exact_of(x), exact_of(y)) / 2,
                      size = LSB + (most - least + fabsl(most)) * 0x1p-20L;
    CHECK(exact_of(between) >= least - size && exact_of(between) <= most + size);
    CHECK(loft_sci_sign(loft_sci_from_real(x)) == (x > 0) - (x < 0));
    if (loft_exact_valid(x) && loft_exact_valid(y))
        CHECK(loft_exact_compare(loft_exact_from_real(x), loft_exact_from_real(y)) ==
              (x > y) - (x < y));
    if (loft_raw_valid(x))
        CHECK_EXACT(exact_of(loft_real_from_raw(loft_raw_from_real(x))), exact_of(x),
                    BY_NUM(0, 0x1p-16L, 0x1p-17L));
    if (loft_fine_valid(x))
        CHECK(loft_fine_atan2(loft_to_acc(x), loft_to_acc(x)) >= -LOFT_FINE_PI);
}

/* e^x is 0 from where it is below 2^-1000 on. */
static void exponentials_vanish_below_the_stated_power_of_two(arb *a)
{
    const int sixteenths = 16 * 693 - 64 + (int)arb_below(a, 128);
    const loft_sci x = loft_sci_div(loft_sci_from_int(-sixteenths), loft_sci_from_int(16)),
                   got = loft_sci_exp(x);

    CHECK((loft_sci_sign(got) > 0) == (expl(-sixteenths / 16.0L) >= 0x1p-1000L));
    CHECK(loft_sci_sign(got) == 0 || !loft_sci_less(got, loft_sci_power2(-1000)));
}

int main(void)
{
    EXTREMES(loft_fine_atan2, the_angle_of_any_vector_is_within_its_bound, 5000);
    PROPERTY(quotients_of_any_numbers_are_within_their_bounds,  5000);
    PROPERTY(any_number_times_a_fraction_is_within_its_bound,   2000);
    PROPERTY(any_coordinate_is_taken_or_refused,                5000);
    PROPERTY(exponentials_vanish_below_the_stated_power_of_two,  500);
    return check_failures();
}
