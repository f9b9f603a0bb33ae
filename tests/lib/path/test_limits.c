/* tests/lib/path/test_limits.c -- properties of lib/path/limits.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_chains.h"  /* usual_limits, real_of, arb_decades */

static void possible_limits_are_accepted(arb *a)
{
    loft_limits l;

    for (int i = 0; i < LOFT_AXES; i++) {
        l.max_speed[i] = real_of(arb_decades(a, 0.016, 16383));
        l.max_accel[i] = real_of(arb_decades(a, 1, 16383));
        l.max_jerk[i]  = arb_below(a, 2) ? (uint32_t)arb_decades(a, 1, LOFT_JERK_MAX) : 0;
    }
    l.corner  = arb_below(a, 3) ? real_of(arb_decades(a, 0.001, 1)) : 0;
    l.tol     = real_of(arb_decades(a, 0.001, 1));
    l.exact   = arb_below(a, 3) ? real_of(arb_between(a, 0, 2)) : 0;
    l.tick_hz = (uint16_t)arb_decades(a, 50, 50000);
    CHECK(loft_limits_check(&l) == LOFT_OK);
}

static void impossible_limits_of_an_axis_are_refused(arb *a)
{
    const unsigned i = arb_below(a, LOFT_AXES);

    usual_limits();
    loft_limits l = limits;
    l.max_speed[i] = 0;
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.max_speed[i] = real_of(0.015);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l.max_speed[i] = real_of(16384);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l = limits;
    l.max_accel[i] = -limits.max_accel[i];
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.max_accel[i] = real_of(0.99);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l.max_accel[i] = real_of(16384);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l = limits;
    l.max_jerk[i] = LOFT_JERK_MAX + 1;
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
}

static void impossible_tolerances_and_ticks_are_refused(arb *a)
{
    (void)a;
    usual_limits();
    loft_limits l = limits;
    l.tol = 0;
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.tol = real_of(0.0009);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l = limits;
    l.corner = -real_of(0.01);
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.corner = real_of(1.5);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l = limits;
    l.exact = -real_of(0.1);
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.exact = real_of(2.1);
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l = limits;
    l.tick_hz = 0;
    CHECK(loft_limits_check(&l) == LOFT_ERR_ARG);
    l.tick_hz = 49;
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
    l.tick_hz = 50001;
    CHECK(loft_limits_check(&l) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(possible_limits_are_accepted, 200);
    PROPERTY(impossible_limits_of_an_axis_are_refused, 20);
    PROPERTY(impossible_tolerances_and_ticks_are_refused, 1);
    return check_failures();
}
