/* tests/lib/num/test_part.c -- properties of lib/num/part.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>           /* floor, sqrt: the reference */

#include "check.h"          /* CHECK, PROPERTY */
#include "num/part.h"       /* loft_part */

static void a_product_loses_its_low_half(arb *a)
{
    const int32_t x = (int32_t)(uint32_t)arb_next(a) >> arb_below(a, 32);
    const int32_t y = (int32_t)arb_below(a, 65537) - 32768;

    CHECK(loft_part(x, y) == (int32_t)floor((double)x * y / 65536));
}

static void doubled_numbers_have_30_bits(arb *a)
{
    const uint32_t x = 1 + ((uint32_t)arb_next(a) >> (2 + arb_below(a, 30)));
    const int n = loft_doublings(x);

    if (x < UINT32_C(1) << 30)
        CHECK(n >= 0 && (uint64_t)x << n < UINT32_C(1) << 30 &&
              (uint64_t)x << n >= UINT32_C(1) << 29);
}

static void inverse_roots_are_not_too_large(arb *a)
{
    const uint32_t m = (UINT32_C(1) << 28) + arb_below(a, 3u << 28) + arb_below(a, 2);
    const double want = 0x1p29 / sqrt(m), got = loft_part_root(m);

    CHECK(got <= want && got >= want * (1 - 0x1p-10) - 1);
}

static void fine_inverse_roots_are_close(arb *a)
{
    const uint32_t m = (UINT32_C(1) << 28) + arb_below(a, 3u << 28);

    CHECK_NEAR(loft_part_root_fine(m) * sqrt(m) / 0x1p44, 1, 0x1p-27);
}

int main(void)
{
    PROPERTY(a_product_loses_its_low_half, 20000);
    PROPERTY(doubled_numbers_have_30_bits, 20000);
    PROPERTY(inverse_roots_are_not_too_large, 50000);
    PROPERTY(fine_inverse_roots_are_close, 50000);
    return check_failures();
}
