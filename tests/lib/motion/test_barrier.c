/* tests/lib/motion/test_barrier.c -- properties of lib/motion/barrier.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_knots.h"   /* arb_path */

#include "motion/barrier.h"         /* loft_barrier_time */

static double time_of_knots(void)
{
    double time = 0;
    for (unsigned k = 1; k + 2 < knots; k++)
        time += loft_timing_time(knot, k) / 65536.0;
    return time;
}

static double most_used(void)
{
    double most = 0, use[3];
    for (unsigned k = 1; k + 2 < knots; k++) {
        uses_of(k, use);
        most = fmax(most, fmax(use[0], fmax(use[1], use[2])));
    }
    return most;
}

/* It is faster than bumps that raise a creep, but for 2 %, and uses little more of the limits
 * between the places that are looked at. */
static void it_takes_no_more_time_than_bumps(arb *a)
{
    arb_path(a);
    for (unsigned k = 0; k < knots; k++)
        knot[k].is.pace.v2 = LOFT_V2_ONE / 1024;
    const loft_timing t = { &period, knot, 1, knots, knots - 2, false };
    for (unsigned n = 0; n < 12; n++)
        for (unsigned part = 0; part < LOFT_TIMING_PARTS; part++)
            loft_timing_raise_part(&t, n, part);
    const double bumps = time_of_knots();
    double fastest = 0;
    for (unsigned k = 0; k < knots; k++)
        fastest = fmax(fastest, knot[k].is.pace.v2);
    loft_barrier_time(&period, knot, knots, 0, false, 30);
    if (fastest < LOFT_BARRIER_FASTEST)
        CHECK(time_of_knots() <= 1.02 * bumps);
    CHECK(most_used() <= 1.3);
}

/* A few steps are nearly as good as many. */
static void eight_steps_come_near(arb *a)
{
    arb_path(a);
    loft_barrier_time(&period, knot, knots, 0, false, 40);
    const double best = time_of_knots();
    loft_barrier_time(&period, knot, knots, 0, false, 8);
    CHECK(time_of_knots() <= 1.1 * best);
}

/* A pace that is known is kept, and the next knots follow it. */
static void tied_knots_keep_their_pace(arb *a)
{
    int32_t v2[KNOTS];

    arb_path(a);
    loft_barrier_time(&period, knot, knots, 0, false, 12);
    const unsigned tied = 2 + arb_below(a, knots - 4);
    for (unsigned k = 0; k < knots; k++)
        v2[k] = knot[k].is.pace.v2;
    loft_barrier_time(&period, knot, knots, tied, false, 12);
    for (unsigned k = 0; k < tied; k++)
        CHECK(knot[k].is.pace.v2 == v2[k]);
    CHECK_NEAR(knot[tied].is.pace.v2, v2[tied], v2[tied] / 4);
}

/* However slow a feed is. */
static void slow_feeds_are_held(arb *a)
{
    arb_path(a);
    for (unsigned k = 0; k < knots; k++)
        if (arb_below(a, 2)) {
            knot[k].is.pace.top  = LOFT_V2_MIN << arb_below(a, 12);
            knot[k].is.pace.goal = knot[k].is.pace.goal < knot[k].is.pace.top ? knot[k].is.pace.goal
                                                                              : knot[k].is.pace.top;
        }
    loft_barrier_time(&period, knot, knots, 0, false, 30);
    for (unsigned k = 1; k + 2 < knots; k++)
        CHECK((knot[k].is.pace.v2 + knot[k + 1].is.pace.v2) / 2 < knot[k].is.pace.top + 32);
}

int main(void)
{
    PROPERTY(it_takes_no_more_time_than_bumps, 100);
    PROPERTY(eight_steps_come_near, 100);
    PROPERTY(tied_knots_keep_their_pace, 100);
    PROPERTY(slow_feeds_are_held, 100);
    return check_failures();
}
