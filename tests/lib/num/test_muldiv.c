/* tests/lib/num/test_muldiv.c -- properties of lib/num/muldiv.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"          /* CHECK, PROPERTY, BY_NUM */
#include "support/exact.h"  /* exact_acc */
#include "num/muldiv.h"

#define ACC_LSB (1 / 4294967296.0L)

/* Any size up to 2^bits of the raw number, the largest included. */
static loft_acc arb_acc(arb *a, unsigned bits)
{
    const int64_t most = (int64_t)(((uint64_t)1 << (bits - 1)) - 1) * 2 + 1;
    const int64_t any = (int64_t)(arb_next(a) >> (64 - bits)),
                  size = arb_below(a, 8) ? any >> arb_below(a, bits) : most;
    const int64_t raw = arb_below(a, 2) ? size : -size;
    return (loft_acc)BY_NUM(raw, (double)raw / 4294967296.0, (double)raw / 4294967296.0);
}

static void a_part_is_rounded_once(arb *a)
{
    const loft_acc x = arb_acc(a, 63), y = arb_acc(a, 63), any = arb_acc(a, 63),
                   z = any < 0 ? -any : any;
    const long double want = exact_acc(x) * exact_acc(y) / (z > 0 ? exact_acc(z) : 1);

    if (!(z > 0) || fabsl(want) > 2147483647.0L)
        return;
    const long double by_num[2] = { ACC_LSB / 2 + fabsl(want) * 0x1p-62L, 1.5L * ulp_double(want) };
    CHECK_EXACT(exact_acc(loft_acc_muldiv(x, y, z)), want, by_num[BY_NUM(0, 1, 1)]);
}

#if LOFT_NUM == LOFT_Q16

__extension__ typedef __int128 wide;

/* Exact to the last bit, ties away from 0. */
static void a_quotient_is_the_nearest_number(arb *a)
{
    const loft_acc x = arb_acc(a, 63), y = arb_below(a, 4) ? arb_acc(a, 63) : arb_acc(a, 8),
                   any = arb_acc(a, 63);
    const wide z = any < 0 ? -(wide)any : any, product = (wide)x * y,
               size = product < 0 ? -product : product;
    const wide nearest = z > 0 ? (size + z / 2) / z : 0;

    if (z == 0 || nearest > INT64_MAX)
        return;
    CHECK(loft_acc_muldiv(x, y, (loft_acc)z) == (loft_acc)(product < 0 ? -nearest : nearest));
}

/* |2 l - 2 root| <= 1 without a root: (2 l - 1)^2 <= 4 squares <= (2 l + 1)^2 */
static void a_length_is_the_nearest_number(arb *a)
{
    const int n = (int)arb_below(a, 7);
    loft_acc x[6] = { 0 };
    uint8_t shift;
    wide squares = 0;

    for (int i = 0; i < n; i++)
        x[i] = arb_acc(a, arb_below(a, 2) ? 59 : 33);
    const loft_acc length = loft_acc_length(x, n, &shift);
    for (int i = 0; i < n; i++)
        squares += ((wide)x[i] * ((wide)1 << shift)) * ((wide)x[i] * ((wide)1 << shift));
    const wide twice = 2 * (wide)length;
    CHECK(squares == 0 ? length == 0 && shift == 0
                       : (twice - 1) * (twice - 1) <= 4 * squares &&
                             4 * squares <= (twice + 1) * (twice + 1));
    CHECK(squares == 0 || (length >= (loft_acc)1 << 58 && exact_acc(length) < 330000000));
}

static void a_shift_down_is_rounded_upward(arb *a)
{
    const loft_acc x = arb_acc(a, 63);
    const unsigned shift = arb_below(a, 63);
    const wide unit = (wide)1 << shift, down = loft_acc_down(x, shift);

    CHECK(2 * down * unit > 2 * (wide)x - unit && 2 * down * unit <= 2 * (wide)x + unit);
}

#else

static void a_length_is_that_of_hypot(arb *a)
{
    const int n = 1 + (int)arb_below(a, 6);
    loft_acc x[6] = { 0 };
    uint8_t shift = 7;
    long double squares = 0;

    for (int i = 0; i < n; i++) {
        x[i] = arb_acc(a, 59);
        squares += (long double)x[i] * x[i];
    }
    const loft_acc length = loft_acc_length(x, n, &shift);
    CHECK_EXACT(length, sqrtl(squares), 0x1p-50L * sqrtl(squares));
    CHECK(shift == 0);
}

static void a_shift_down_is_exact(arb *a)
{
    const loft_acc x = arb_acc(a, 59);
    const unsigned shift = arb_below(a, 63);
    CHECK_EXACT(loft_acc_down(x, shift), ldexpl(x, -(int)shift), 0);
}

#endif

int main(void)
{
    PROPERTY(a_part_is_rounded_once,              20000);
#if LOFT_NUM == LOFT_Q16
    PROPERTY(a_quotient_is_the_nearest_number,    20000);
    PROPERTY(a_length_is_the_nearest_number,      20000);
    PROPERTY(a_shift_down_is_rounded_upward,      20000);
#else
    PROPERTY(a_length_is_that_of_hypot,           20000);
    PROPERTY(a_shift_down_is_exact,               20000);
#endif
    return check_failures();
}
