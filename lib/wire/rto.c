/* lib/wire/rto.c -- how long to wait for an answer
 * SPDX-License-Identifier: MIT
 *
 * The timeout is twice the round trip plus four deviations. On a steady line the deviation goes to
 * 0, and then a STATUS that delays an ACK must not look like a loss. A NAK reports most losses
 * anyway.
 */
#include "wire/rto.h"

void loft_rto_init(loft_rto *r)
{
    r->ms = LOFT_RTO_FIRST;
    r->rtt8 = r->var4 = 0;
}

void loft_rto_take(loft_rto *r, uint32_t m)
{
    m = m > 0 ? m : 1;
    if (r->rtt8 == 0) {
        r->rtt8 = 8 * m;
        r->var4 = 2 * m;
        return;
    }
    const uint32_t srtt = r->rtt8 / 8;
    const uint32_t off  = m > srtt ? m - srtt : srtt - m;
    r->rtt8 = r->rtt8 - srtt + m;
    r->var4 = r->var4 - r->var4 / 4 + off;
}

void loft_rto_reset(loft_rto *r)
{
    const uint32_t ms = r->rtt8 ? r->rtt8 / 4 + r->var4 + 1 : r->ms;
    r->ms = ms < LOFT_RTO_MIN ? LOFT_RTO_MIN : ms > LOFT_RTO_MAX ? LOFT_RTO_MAX : ms;
}

void loft_rto_back_off(loft_rto *r) { r->ms = r->ms > LOFT_RTO_MAX / 2 ? LOFT_RTO_MAX : 2 * r->ms; }

uint32_t loft_rto_trip(const loft_rto *r)       { return r->rtt8 / 8; }
