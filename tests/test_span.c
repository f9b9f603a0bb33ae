/* tests/test_span.c -- properties of lib/motion/span.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"          /* CHECK, PROPERTY */
#include "motion/span.h"    /* loft_span_walk */

static loft_span arb_span(arb *a)
{
    loft_span s;
    for (int k = 0; k < 4; k++)
        s.p[k] = arb_vec(a, arb_below(a, 2) ? 8191 : 1);
    s.ticks = (uint16_t)(1 + (arb_below(a, 8) ? arb_below(a, LOFT_SPAN_TICKS_MAX) : arb_below(a, 2) * (LOFT_SPAN_TICKS_MAX - 1)));
    return s;
}

/* One point per tick, on the cubic at tick / ticks; the last one is the end, exactly. */
static void a_walk_yields_the_position_after_each_tick(arb *a)
{
    const loft_span s = arb_span(a);
    loft_forward w;
    loft_vec p = s.p[0];
    unsigned n = 0;

    CHECK(loft_span_walk(&w, &s) == LOFT_OK);
    while (n <= s.ticks && loft_forward_next(&w, &p)) {
        const long double t = (long double)++n / s.ticks, q = 1 - t;
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double x[4] = { arb_value(s.p[0].axis[i]), arb_value(s.p[1].axis[i]), arb_value(s.p[2].axis[i]), arb_value(s.p[3].axis[i]) };
            const long double want = q*q*q * x[0] + 3*q*q*t * x[1] + 3*q*t*t * x[2] + t*t*t * x[3];
            CHECK_NEAR(arb_value(p.axis[i]) - want, 0, BY_NUM(0.521 / 65536, 8191 * 0x1p-24, 8191 * 0x1p-39));
        }
    }
    CHECK(n == s.ticks && loft_vec_equal(p, s.p[3]));
}

static void impossible_ticks_are_refused(arb *a)
{
    loft_span s = arb_span(a);
    loft_forward w;

    s.ticks = 0;
    CHECK(loft_span_walk(&w, &s) == LOFT_ERR_RANGE);
    s.ticks = (uint16_t)(LOFT_SPAN_TICKS_MAX + 1 + arb_below(a, 64000));
    CHECK(loft_span_walk(&w, &s) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(a_walk_yields_the_position_after_each_tick, 1000);
    PROPERTY(impossible_ticks_are_refused,                100);
    return check_failures();
}
