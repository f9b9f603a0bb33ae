/* tests/lib/path/test_period.c -- properties of lib/path/period.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_paths.h"   /* arb_limits, arb_jerk */

#include "path/period.h"          /* loft_period_init */

#define GRAIN 256.0                 /* 2^-16 mm: spans are made of them */

static bool is_whole(loft_coord x, int grains) { return x > 0 && x % (256 * grains) == 0; }

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
        const double fast = arb_value(limits.max_speed[i]) * h * unit * 1.000001;
        CHECK(is_whole(p.speed[i], 3) && p.speed[i] <= fmax(fast, 3 * GRAIN));
        CHECK(p.accel[i] <= most + 1);
        CHECK(p.jerk[i] <= fmax(2.0 * p.tol, 6 * GRAIN));
        if (limits.max_jerk[i] > 0)
            CHECK(p.jerk[i] <= limits.max_jerk[i] * h * h * h * unit + 1);
        else
            CHECK(p.accel[i] <= 6 * p.tol && p.jerk[i] <= p.accel[i]);
    }
}

/* Where a tick is short enough, nothing is given away. */
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
        CHECK(p.accel[i] >= most * 0.999 - 1);
        CHECK(p.jerk[i] >= fmin(jerk, 2.0 * p.tol) * 0.999 - 1);
    }
}

static void a_speed_is_that_of_a_period(arb *a)
{
    loft_period p;
    const double v = arb_value(real_of(arb_decades(a, 0.02, 16000)));

    arb_limits(a);
    loft_period_init(&p, &limits);
    const double want = fmin(v * seconds_of(&p) * LOFT_COORD_MM, 1 << 28);
    const double less = fmin(6 * GRAIN, want / 1024);
    CHECK_NEAR(loft_period_speed(&p, real_of(v)), want - less, 2 + want * 1e-6);
}

/* The last period of a chain may last half as long, if grains are as large then as in others. */
static void a_last_period_has_grains(arb *a)
{
    loft_period p;
    bool halved = true;

    arb_limits(a);
    if (arb_below(a, 2))
        for (int i = 0; i < LOFT_AXES; i++)
            limits.max_jerk[i] = (uint32_t)(arb_decades(a, 5, 1e4) *
                                            arb_value(limits.max_accel[i]));
    loft_period_init(&p, &limits);
    const int half = (p.ticks + 1) / 2;
    for (int i = 0; i < LOFT_AXES; i++) {
        const double part = (double)half / p.ticks;
        halved = halved && p.jerk[i] * part * part * part >= 6 * GRAIN &&
                 p.accel[i] * part * part >= 6 * GRAIN;
    }
    CHECK(p.last == (halved && 2 * p.ticks <= 1001 ? half : p.ticks));
}

int main(void)
{
    PROPERTY(no_more_is_allowed_than_the_limits, 5000);
    PROPERTY(little_less_is_allowed_than_the_limits, 5000);
    PROPERTY(a_speed_is_that_of_a_period, 5000);
    PROPERTY(a_last_period_has_grains, 5000);
    return check_failures();
}
