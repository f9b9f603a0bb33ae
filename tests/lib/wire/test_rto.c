/* tests/lib/wire/test_rto.c -- properties of lib/wire/rto.h
 * SPDX-License-Identifier: MIT
 */
#include "wire/rto.h"

#include "support/arb.h"    /* arb */
#include "check.h"          /* CHECK, PROPERTY */

/* Against the law in double: each division drops less than 1 of 8 ms of the round trip, of 4 ms of
 * the deviation. */
static void what_is_measured_is_smoothed(arb *a)
{
    const uint32_t middle = 1 + arb_below(a, 300), spread = arb_below(a, middle);
    double srtt = 0, var = 0;
    loft_rto r;

    loft_rto_init(&r);
    CHECK(loft_rto_trip(&r) == 0 && r.ms == LOFT_RTO_FIRST);
    for (int n = 0; n < 200; n++) {
        const uint32_t m = middle - spread / 2 + (spread ? arb_below(a, spread) : 0);
        const double off = srtt > m ? srtt - m : m - srtt;

        loft_rto_take(&r, m);
        srtt = n ? srtt + (m - srtt) / 8 : m;
        var  = n ? var + (off - var) / 4 : m / 2.0;
        CHECK(r.rtt8 / 8.0 <= srtt + 1 && r.rtt8 / 8.0 >= srtt - 1);
        CHECK(r.var4 / 4.0 <= var + 2 && r.var4 / 4.0 >= var - 2);

        loft_rto_reset(&r);
        const uint32_t ms = r.rtt8 / 4 + r.var4 + 1;
        CHECK(r.ms == (ms < LOFT_RTO_MIN ? LOFT_RTO_MIN : ms > LOFT_RTO_MAX ? LOFT_RTO_MAX : ms));
        CHECK(r.ms > loft_rto_trip(&r) || r.ms == LOFT_RTO_MAX);
    }
}

/* The timeout doubles each time, to LOFT_RTO_MAX. An answer resets it at once; without any
 * measurement it stays. */
static void silence_is_waited_for_ever_longer(arb *a)
{
    const bool measured = arb_below(a, 2);
    loft_rto r;

    loft_rto_init(&r);
    if (measured)
        loft_rto_take(&r, 1 + arb_below(a, 200));
    loft_rto_reset(&r);
    const uint32_t first = r.ms;
    for (uint32_t n = 0, ms = first; n < 12; n++) {
        loft_rto_back_off(&r);
        ms = 2 * ms < LOFT_RTO_MAX ? 2 * ms : LOFT_RTO_MAX;
        CHECK(r.ms == ms);
    }
    loft_rto_reset(&r);
    CHECK(r.ms == (measured ? first : LOFT_RTO_MAX));
}

int main(void)
{
    PROPERTY(what_is_measured_is_smoothed, 200);
    PROPERTY(silence_is_waited_for_ever_longer, 200);
    return check_failures();
}
