/* tests/lib/num/test_explog.c -- properties of lib/num/explog.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_sci.h"                  /* exact_of */
#include "num/explog.h"

/* Any digits, exponents to 2^+-300, next to 1 over-represented. */
static loft_sci arb_positive(arb *a)
{
    const loft_sci two = loft_sci_from_int(2), one = loft_sci_one();
    const loft_sci digits = loft_sci_div(loft_sci_from_int((int32_t)(1 + arb_below(a, 1u << 30))),
                                         loft_sci_from_int((int32_t)(1 + arb_below(a, 1u << 30))));
    const loft_sci power = loft_sci_pow(two, arb_below(a, 300));

    switch (arb_below(a, 3)) {
    case 0:  return loft_sci_mul(digits, power);
    case 1:  return loft_sci_div(digits, power);
    default:
        return loft_sci_add(one, loft_sci_div(digits, loft_sci_pow(two, 31 + arb_below(a, 20))));
    }
}

static void logarithms_hold_their_bound(arb *a)
{
    const loft_sci x = arb_positive(a);
    const long double want = logl(exact_sci(x)), got = exact_sci(loft_sci_log(x));

    CHECK_EXACT(
        got - want, 0,
        BY_NUM(0x1p-57L + fabsl(want) * 0x1p-60L, fabsl(want) * 0x1p-51L, fabsl(want) * 0x1p-51L));
}

static loft_sci arb_exponent(arb *a)
{
    const unsigned down = arb_below(a, 40);
    const loft_sci x = loft_sci_div(loft_sci_from_int((int32_t)arb_below(a, 1u << 30)),
                                    loft_sci_pow(loft_sci_from_int(2), 21 + down));
    return arb_below(a, 2) ? loft_sci_neg(x) : x;
}

static void exponentials_hold_their_bound(arb *a)
{
    const loft_sci x = arb_exponent(a);
    const long double want = expl(exact_sci(x)), got = exact_sci(loft_sci_exp(x));

    CHECK_EXACT(got / want - 1, 0,
                BY_NUM(0x1p-56L + fabsl(exact_sci(x)) * 0x1p-60L, 0x1p-51L, 0x1p-51L));
}

static void each_undoes_the_other(arb *a)
{
    const loft_sci x = arb_exponent(a);
    const long double size = fmaxl(1, fabsl(exact_sci(x)));

    CHECK_EXACT(exact_sci(loft_sci_log(loft_sci_exp(x))) - exact_sci(x), 0,
                size * BY_NUM(0x1p-54L, 0x1p-49L, 0x1p-49L));
}

static void the_ends_are_exact(arb *a)
{
    const loft_sci far = loft_sci_from_int(-700 - (int32_t)arb_below(a, 1u << 30));

    CHECK(loft_sci_sign(loft_sci_log(loft_sci_one())) == 0);
    CHECK_EXACT(exact_sci(loft_sci_exp(loft_sci_zero())), 1, 0);
    CHECK(loft_sci_sign(loft_sci_exp(far)) == 0);
}

static void fine_numbers_come_back(arb *a)
{
    const loft_fine x = loft_fine_of(arb_real(a, 7));

    CHECK(loft_sci_to_fine(loft_sci_from_fine(x)) - x == 0);
    CHECK_EXACT(exact_sci(loft_sci_from_fine(x)), exact_acc(loft_fine_to_acc(x)), 0);
}

int main(void)
{
    PROPERTY(logarithms_hold_their_bound, 5000);
    PROPERTY(exponentials_hold_their_bound, 5000);
    PROPERTY(each_undoes_the_other, 2000);
    PROPERTY(the_ends_are_exact, 100);
    PROPERTY(fine_numbers_come_back, 1000);
    return check_failures();
}
