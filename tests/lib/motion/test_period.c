/* tests/lib/motion/test_period.c -- properties of lib/motion/period.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_paths.h"   /* arb_limits, arb_jerk */

#include "motion/period.h"          /* loft_period_init */

static double seconds_of(const loft_period *p) { return (double)p->ticks / p->tick_hz; }

/* A difference of places that holds what a period allows holds the limit. */
static void no_more_is_allowed_than_the_limits(arb *a)
{
    loft_period p;

    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    loft_period_init(&p, &limits);
    const double h = seconds_of(&p), unit = LOFT_COORD_MM;
    CHECK(p.ticks >= 1 && (p.ticks == 1 || h <= 0.05 + 1.0 / p.tick_hz));
    for (int i = 0; i < LOFT_AXES; i++) {
        const double most = arb_value(limits.max_accel[i]) * h * h * unit;
        CHECK(p.speed[i] <= arb_value(limits.max_speed[i]) * h * unit * 1.000001);
        CHECK(p.accel[i] >= 1 && p.accel[i] <= most + 1 && p.accel[i] <= 6 * p.tol);
        CHECK(p.jerk[i] >= 1 && p.jerk[i] <= p.accel[i]);
        if (limits.max_jerk[i] > 0)
            CHECK(p.jerk[i] <= limits.max_jerk[i] * h * h * h * unit + 1);
    }
}

/* Where a tick is short enough, nothing is given away but by rounding. */
static void little_less_is_allowed_than_the_limits(arb *a)
{
    loft_period p;

    arb_limits(a);
    limits.tick_hz = 50000;
    arb_jerk(a);
    loft_period_init(&p, &limits);
    const double h = seconds_of(&p), unit = LOFT_COORD_MM;
    for (int i = 0; i < LOFT_AXES; i++) {
        const double most = arb_value(limits.max_accel[i]) * h * h * unit;
        const double jerk = limits.max_jerk[i] * h * h * h * unit;
        CHECK(p.accel[i] >= fmin(most, 6.0 * p.tol) * 0.999 - 2);
        CHECK(p.jerk[i] >= fmin(jerk, p.accel[i]) * 0.999 - 4 || p.jerk[i] == 1);
    }
}

static void a_speed_is_that_of_a_period(arb *a)
{
    loft_period p;
    const double v = arb_value(real_of(arb_decades(a, 0.02, 16000)));

    arb_limits(a);
    loft_period_init(&p, &limits);
    const double want = v * seconds_of(&p) * LOFT_COORD_MM;
    CHECK_NEAR(loft_period_speed(&p, real_of(v)), fmin(want, 1 << 28), 1 + want * 1e-6);
}

int main(void)
{
    PROPERTY(no_more_is_allowed_than_the_limits, 5000);
    PROPERTY(little_less_is_allowed_than_the_limits, 5000);
    PROPERTY(a_speed_is_that_of_a_period, 5000);
    return check_failures();
}
