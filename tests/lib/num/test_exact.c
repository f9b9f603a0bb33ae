/* tests/lib/num/test_exact.c -- exact integers against __int128, and against algebraic laws at full
 * width
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_of, BY_NUM */
#include "num/exact.h"

__extension__ typedef __int128 wide;

#define TOP LOFT_EXACT_BITS

static loft_exact whole(int32_t i) { return loft_exact_from_int(i); }

/* An arbitrary number of at most `bits` bits, one in four with long runs of equal bits. */
static loft_exact arb_exact(arb *a, int bits)
{
    loft_exact x = whole(0);
    const bool runs = arb_below(a, 4) == 0;

    for (int left = bits - (int)arb_below(a, (uint32_t)bits + 1); left > 0; left -= 30) {
        const int take = left < 30 ? left : 30;
        const uint32_t any = arb_below(a, 1u << take), run = arb_below(a, 2) ? (1u << take) - 1 : 0;
        x = loft_exact_add(loft_exact_shift(x, take), whole((int32_t)(runs ? run : any)));
    }
    return arb_below(a, 2) ? loft_exact_neg(x) : x;
}

static loft_exact of_wide(wide v)
{
    loft_exact x = whole((int32_t)(v >> 96));
    for (int k = 2; k >= 0; k--) {
        x = loft_exact_shift(x, 32);
        x.limb[0] = (uint32_t)(v >> 32 * k);
    }
    return x;
}

static wide arb_wide(arb *a, int bits)
{
    const wide v = ((wide)(arb_next(a) >> 2) << 62 | (wide)(arb_next(a) >> 2)) >>
                   arb_below(a, 124) >> (124 - bits);
    return arb_below(a, 2) ? -v : v;
}

static bool same(loft_exact a, loft_exact b) { return loft_exact_compare(a, b) == 0; }
static int  sign(wide v)                     { return v > 0 ? 1 : v < 0 ? -1 : 0; }

static wide halves_upward(wide v, int s) { return (v + ((wide)1 << (s - 1))) >> s; }

static void small_numbers_agree_with_int128(arb *a)
{
    const wide x = arb_wide(a, 62), y = arb_wide(a, 62), z = arb_wide(a, 124);
    const int s = (int)arb_below(a, 60) + 1;

    CHECK(same(loft_exact_add(of_wide(x), of_wide(z)), of_wide(x + z)));
    CHECK(same(loft_exact_sub(of_wide(z), of_wide(y)), of_wide(z - y)));
    CHECK(same(loft_exact_mul(of_wide(x), of_wide(y)), of_wide(x * y)));
    CHECK(same(loft_exact_det(of_wide(x), of_wide(y), of_wide(y), of_wide(x)),
               of_wide(x * x - y * y)));
    CHECK(same(loft_exact_neg(of_wide(z)), of_wide(-z)));
    CHECK(loft_exact_sign(of_wide(z)) == sign(z) &&
          loft_exact_compare(of_wide(x), of_wide(y)) == sign(x - y));
    CHECK(same(loft_exact_shift(of_wide(x), s), of_wide(x * ((wide)1 << s))));
    CHECK(same(loft_exact_shift(of_wide(z), -s), of_wide(halves_upward(z, s))));
    if (y) {
        const wide most = (z < 0 ? -z : z) + (y < 0 ? -y : y) / 2, size = most / (y < 0 ? -y : y);
        CHECK(same(loft_exact_div(of_wide(z), of_wide(y)),
                   of_wide((z < 0) != (y < 0) ? -size : size)));
    }
}

/* The ring axioms, at full width. */
static void wide_numbers_form_a_ring(arb *a)
{
    const loft_exact x = arb_exact(a, TOP / 2 - 2), y = arb_exact(a, TOP / 2 - 2);
    const loft_exact sum = loft_exact_add(x, y), difference = loft_exact_sub(x, y);

    CHECK(same(loft_exact_mul(sum, difference), loft_exact_det(x, y, y, x)));
    CHECK(same(loft_exact_mul(x, y), loft_exact_mul(y, x)));
    CHECK(same(loft_exact_mul(x, whole(-1)), loft_exact_neg(x)));
    CHECK(loft_exact_sign(loft_exact_mul(x, y)) == loft_exact_sign(x) * loft_exact_sign(y));
    CHECK(loft_exact_compare(x, y) == -loft_exact_compare(y, x));
    CHECK(same(loft_exact_add(difference, y), x));
}

static void bits_and_shifts_are_powers_of_two(arb *a)
{
    const loft_exact x = arb_exact(a, TOP / 2);
    const int bits = loft_exact_bits(x), s = (int)arb_below(a, (uint32_t)(TOP / 2));
    const loft_exact size = loft_exact_sign(x) < 0 ? loft_exact_neg(x) : x,
                     power = loft_exact_shift(whole(1), bits);

    CHECK(loft_exact_compare(size, power) < 0);
    CHECK(bits == 0 || loft_exact_compare(loft_exact_add(size, size), power) >= 0);
    CHECK(same(loft_exact_shift(x, s), loft_exact_mul(loft_exact_shift(whole(1), s), x)));
    CHECK(same(loft_exact_shift(loft_exact_shift(x, s), -s), x));
}

/* 2 |a - q b| <= |b| */
static void quotients_are_nearest(arb *a)
{
    const loft_exact x = arb_exact(a, TOP - 2);
    loft_exact y = arb_exact(a, TOP - 2);

    if (loft_exact_sign(y) == 0)
        y = whole(1);
    const loft_exact rest = loft_exact_sub(x, loft_exact_mul(loft_exact_div(x, y), y));
    const loft_exact twice = loft_exact_add(rest, rest);
    CHECK(loft_exact_bits(twice) <= loft_exact_bits(y));
    CHECK(loft_exact_compare(loft_exact_sign(twice) < 0 ? loft_exact_neg(twice) : twice,
                             loft_exact_sign(y) < 0 ? loft_exact_neg(y) : y) <= 0);
}

static void roots_are_the_largest(arb *a)
{
    const loft_exact half = arb_exact(a, TOP / 2),
                     x = arb_below(a, 4) ? arb_exact(a, TOP) : loft_exact_mul(half, half);
    const loft_exact r = loft_exact_root(x), next = loft_exact_add(r, whole(1));

    if (loft_exact_sign(x) <= 0) {
        CHECK(loft_exact_sign(r) == 0);
        return;
    }
    CHECK(loft_exact_compare(loft_exact_mul(r, r), x) <= 0);
    CHECK(loft_exact_bits(next) > TOP / 2 || loft_exact_compare(loft_exact_mul(next, next), x) > 0);
}

/* r^2 <= (x^2 + y^2 + z^2) 2^128 < (r + 1)^2 */
static void lengths_are_roots_of_squares(arb *a)
{
    const loft_exact x[3] = { loft_exact_from_real(arb_real(a, 32767)),
                              loft_exact_from_real(arb_real(a, 3)),
                              whole((int32_t)arb_below(a, 3) - 1) };
    const loft_exact r = loft_exact_hypot(x, 3), next = loft_exact_add(r, whole(1));
    loft_exact sum = whole(0);

    for (int i = 0; i < 3; i++)
        sum = loft_exact_add(sum, loft_exact_mul(x[i], x[i]));
    sum = loft_exact_shift(sum, 2 * LOFT_EXACT_HYPOT);
    CHECK(loft_exact_compare(loft_exact_mul(r, r), sum) <= 0 &&
          loft_exact_compare(loft_exact_mul(next, next), sum) > 0);
}

/* The value of x * 2^-shift in long double: its first 60 bits. */
static long double value(loft_exact x, int shift)
{
    const int cut = loft_exact_bits(x) > 60 ? loft_exact_bits(x) - 60 : 0;
    const loft_exact top = loft_exact_shift(x, -cut);
    const uint64_t low = (uint64_t)top.limb[1] << 32 | top.limb[0];
    return ldexpl(loft_exact_sign(x) < 0 ? -(long double)(~low + 1) : (long double)low,
                  cut - shift);
}

static void quotients_become_wide_values(arb *a)
{
    const loft_exact x = arb_exact(a, TOP),
                     y = loft_exact_add(loft_exact_shift(arb_exact(a, TOP - 3), 1), whole(1));
    const int order = loft_exact_bits(x) - loft_exact_bits(y),
              s = (int)arb_below(a, 80) - 45 - order;
    const long double want = ldexpl(value(x, 0) / value(y, 0), s);
    loft_acc got = 0;

    if (fabsl(want) < BY_NUM(0x1p30L, 0x1p999L, 0x1p999L)) {
        CHECK(loft_exact_quot(x, y, s, &got));
        CHECK_EXACT(
            exact_acc(got), want,
            BY_NUM(0x1p-33L + 0x1p-55L, 0.51L * ulp_double(want), 0.51L * ulp_double(want)) +
                fabsl(want) * 0x1p-57L);
    } else if (loft_exact_quot(x, y, s, &got))
        CHECK_EXACT(exact_acc(got), want, fabsl(want) * 0x1p-52L);
}

static void what_is_too_large_for_a_wide_value_is_refused(arb *a)
{
    const loft_exact x = loft_exact_add(loft_exact_shift(whole(1), TOP - 1), arb_exact(a, TOP - 4));
    loft_acc untouched = 7;

    CHECK(!loft_exact_quot(x, whole(-1), BY_NUM(0, 40, 40), &untouched) && untouched <= 7 &&
          untouched >= 7);
    CHECK(loft_exact_quot(whole(1), x, BY_NUM(0, -40, -40), &untouched) && !(untouched > 0) &&
          !(untouched < 0));
    CHECK(loft_exact_quot(whole(0), x, 3000, &untouched) && !(untouched > 0) && !(untouched < 0));
}

static void coordinates_are_taken_exactly(arb *a)
{
    const int down = (int)arb_below(a, 30);
    const loft_real x = arb_real(a, 32767),
                    y = (loft_real)(x / (loft_real)(1 << BY_NUM(0 * down, down, down)));

    CHECK(loft_exact_valid(y));
    CHECK_EXACT(value(loft_exact_from_real(y), LOFT_EXACT_REAL), exact_of(y), 0);
}

static void parameters_are_taken_exactly(arb *a)
{
    const loft_unit t = arb_unit(a);

    CHECK_EXACT(value(loft_exact_from_unit(t), LOFT_EXACT_UNIT), exact_unit(t), 0);
    CHECK_EXACT(value(loft_exact_from_unit(-t), LOFT_EXACT_UNIT), -exact_unit(t), 0);
}

static void the_window_of_floats_is_kept(arb *a)
{
    (void)a;
#if LOFT_NUM == LOFT_Q16
    CHECK(loft_exact_valid(INT32_MIN) && loft_exact_valid(INT32_MAX));
    CHECK(value(loft_exact_from_real(INT32_MIN), 0) <= -2147483648.0L);
#else
    const loft_real least = (loft_real)BY_NUM(0, 0x1p-108, 0x1p-108);
    CHECK(loft_exact_valid(least) && loft_exact_valid(-least) && loft_exact_valid(0));
    CHECK(same(loft_exact_from_real(-least), whole(-1)));
    CHECK(!loft_exact_valid(least / 2) && !loft_exact_valid((loft_real)1.5 * least));
    CHECK(loft_exact_valid((loft_real)1048575) && !loft_exact_valid((loft_real)1048576) &&
          !loft_exact_valid((loft_real)-1048576));
    CHECK(!loft_exact_valid((loft_real)NAN) && !loft_exact_valid((loft_real)INFINITY));
    CHECK(loft_exact_valid((loft_real)BY_NUM(0, 2.6e-26, 1.4e-17)));
    CHECK(same(loft_exact_from_unit((loft_unit)0x1p-53), whole(1)) &&
          same(loft_exact_from_unit((loft_unit)0x1p-54), whole(1)));
    CHECK(same(loft_exact_from_unit((loft_unit)0x1p-55), whole(0)) &&
          same(loft_exact_from_unit((loft_unit)-0x1p-54), whole(-1)));
#endif
}

int main(void)
{
    PROPERTY(small_numbers_agree_with_int128,               20000);
    PROPERTY(wide_numbers_form_a_ring,                       3000);
    PROPERTY(bits_and_shifts_are_powers_of_two,              3000);
    PROPERTY(quotients_are_nearest,                          1000);
    PROPERTY(roots_are_the_largest,                          1000);
    PROPERTY(lengths_are_roots_of_squares,                    300);
    PROPERTY(quotients_become_wide_values,                   3000);
    PROPERTY(what_is_too_large_for_a_wide_value_is_refused,   100);
    PROPERTY(coordinates_are_taken_exactly,                 10000);
    PROPERTY(parameters_are_taken_exactly,                  10000);
    PROPERTY(the_window_of_floats_is_kept,                      1);
    return check_failures();
}
