/* tests/lib/wire/test_wire_fuzz.c -- the fuzzer's entry, fed from seeds: a short, repeatable
 * campaign SPDX-License-Identifier: MIT
 */
#include "fuzz_wire.c"

#include "check.h"          /* PROPERTY */

/* A row of contents, most of them of the right length for their type, with small numbers. */
static size_t arb_contents(arb *a, uint8_t out[], size_t room)
{
    static const uint8_t payload[13] = {
        0, 7, 9 + 4 * LOFT_AXES, 0, 0, 4, 2, 0, 38, 21, 16, 36 + 4 * LOFT_AXES, 21 + 4 * LOFT_AXES
    };
    size_t n = 0;
    for (uint32_t frames = 1 + arb_below(a, 30); frames > 0; frames--) {
        const uint8_t type = (uint8_t)arb_below(a, arb_below(a, 9) ? 13 : 16);
        size_t size = 2 + (type < 13 && payload[type] && arb_below(a, 8) ? payload[type]
                                                                         : arb_below(a, 60));
        const uint32_t taste = arb_below(a, 3);
        if (n + 1 + size > room)
            break;
        out[n++] = (uint8_t)(size | (arb_below(a, 20) == 0 ? 0x80 : 0));
        out[n++] = (uint8_t)(type << 4);
        for (size--; size > 0; size--)
            out[n++] = (uint8_t)(taste == 0 ? 0 : taste == 1 ? arb_below(a, 3) : arb_next(a));
    }
    return n;
}

static void nothing_breaks(arb *a)
{
    uint8_t data[2000];
    size_t size = 1;
    data[0] = (uint8_t)arb_below(a, 6);
    if (data[0] == 2 || data[0] == 4)
        size += arb_contents(a, data + 1, sizeof data - 1);
    else
        for (size_t n = arb_below(a, 250); n > 0; n--)
            data[size++] = (uint8_t)(arb_below(a, 2) ? arb_next(a) : arb_below(a, 8));
    CHECK(LLVMFuzzerTestOneInput(data, size) == 0);
}

int main(void)
{
    PROPERTY(nothing_breaks, BY_NUM(20000, 2000, 2000));
    return check_failures();
}
