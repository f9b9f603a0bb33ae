/* tests/lib/num/test_num.c -- every scalar function of lib/num keeps the bound in its docstring,
 * also at the extremes
 * SPDX-License-Identifier: MIT
 */
#include "num/num.h"

#if LOFT_NUM == LOFT_Q16
#  include "support/num_q16.h"      /* test_num: against exact integers */
#else
#  include "support/num_floats.h"   /* test_num: against long double    */
#endif

__extension__ typedef unsigned __int128 whole;

/* By definition: r^2 <= x < (r + 1)^2, and (2 r - 1)^2 <= 4 x < (2 r + 1)^2 of the nearest. */
static void check_whole_root(uint64_t x)
{
    const whole low = loft_root(x);

    CHECK(low * low <= x && (low + 1) * (low + 1) > x);
    if (x > UINT64_MAX - UINT32_MAX)
        return;
    const whole near = loft_root_nearest(x), below = 2 * near - (near > 0), above = 2 * near + 1;
    CHECK(below * below <= 4 * (whole)x && above * above > 4 * (whole)x);
}

static void roots_of_whole_numbers_are_exact(arb *a)
{
    const uint64_t r = (arb_next(a) >> 32) >> arb_below(a, 32), x = arb_next(a) >> arb_below(a, 64);
    const uint64_t power = (uint64_t)1 << arb_below(a, 64);

    check_whole_root(x);
    for (uint64_t d = 0; d < 3; d++) {
        check_whole_root(r * r + d - 1);
        check_whole_root(r * r + r + d - 1);
        check_whole_root(power + d - 1);
        check_whole_root(UINT64_MAX - (x & 0xffffff) - d);
    }
}

int main(void)
{
    PROPERTY(roots_of_whole_numbers_are_exact, 300000);
    return test_num();
}
