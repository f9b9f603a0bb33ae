/* tests/lib/motion/test_cruise.c -- properties of lib/motion/cruise.h: whole plans of slow curves
 * SPDX-License-Identifier: MIT
 */
#define CURVES 100

#include "support/motion_any.h"     /* check_chain, plan_chain */

#if LOFT_FOLDS

static const arrival all_at_once = { CURVES, 112, NULL };

/* A machine, and a feed that is slow for it, mm/s. */
static double arb_slow_limits(arb *a)
{
    const double accel = arb_decades(a, 300, 3000), feed = arb_decades(a, 1 / 60.0, 1);

    even_limits(arb_between(a, 20, 300), accel, floor(accel * arb_between(a, 15, 40)));
    limits.tol = real_of(arb_decades(a, 0.004, 0.05));
    return feed;
}

/* A curve from here that bends to and fro. */
static void arb_gentle(arb *a, double size, double feed)
{
    double d[LOFT_AXES], e[LOFT_AXES];
    const double u[4] = { 0, size / 3, size * 2 / 3, size },
                 w[4] = { 0, size * arb_between(a, -0.4, 0.4), size * arb_between(a, -0.4, 0.4),
                          size * arb_between(a, -0.4, 0.4) };

    arb_direction(a, d);
    arb_direction(a, e);
    add_curve(d, e, u, w, feed);
}

/* Runs of slow curves, among faster ones. */
static void slow_curves_hold_all_limits(arb *a)
{
    const double feed = arb_slow_limits(a), size = 30 * feed;

    begin_chain();
    for (unsigned n = 1 + arb_below(a, 5); n > 0; n--) {
        const double part = size * arb_decades(a, 0.05, 1), v = arb_below(a, 4) ? feed : 20;
        if (arb_below(a, 3) == 0)
            arb_gentle(a, part, v);
        else
            arb_curve(a, arb_below(a, 2) ? LINE : ARC, part, v, arb_below(a, 2));
    }
    bad = false;
    check_chain(check_seed, a);
    CHECK(!bad);
}

/* A turn of a circle of radius r, in n arcs of less than 90 degrees, or in n chords. */
static void add_turn(double r, unsigned n, bool chords, double feed)
{
    const double step = 2 * acos(-1) / n, k = 4 / 3.0 * tan(step / 4);

    for (unsigned m = 0; m < n; m++) {
        const double d[LOFT_AXES] = { cos(m * step), sin(m * step) },
                     e[LOFT_AXES] = { -sin(m * step), cos(m * step) };
        const double x = cos(step) - 1, y = sin(step),
                     u[4] = { 0, chords ? x / 3 : 0, chords ? x * 2 / 3 : x + k * y, x },
                     w[4] = { 0, chords ? y / 3 : k, chords ? y * 2 / 3 : y - k * (x + 1), y };
        double p[4], q[4];
        for (int i = 0; i < 4; i++) {
            p[i] = r * u[i];
            q[i] = r * w[i];
        }
        add_curve(d, e, p, q, feed);
    }
}

/* However slow a circle is: it has a span for each 1023 ticks, some where it begins, ends or has a
 * joint, and one for each eighth of a radian. It takes the time that its length does at the feed.
 */
static void a_slow_circle_costs_what_its_shape_asks_for(arb *a)
{
    const bool chords = arb_below(a, 2);
    const double pi = acos(-1), feed = arb_slow_limits(a);
    loft_period p;
    loft_period_init(&p, &limits);
    const double r = feed * arb_between(a, 5000, 9000) * p.ticks / p.tick_hz / (2 * pi),
                 sag = arb_value(limits.tol) * arb_between(a, 0.05, 0.4);
    const unsigned n = chords ? (unsigned)fmin(CURVES, ceil(pi / acos(1 - fmin(sag / r, 0.5))))
                              : 4 + arb_below(a, 8);
    const double length = 2 * (chords ? n * r * sin(pi / n) : pi * r);

    begin_chain();
    add_turn(r, n, chords, feed);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    CHECK(spans_connect());
    const double asked = arb_value(chain[0].feed), least = length / asked;
    CHECK(seconds() >= least * 0.9999);
    CHECK(seconds() <= least * 1.001 + (n + 8.0 * p.ticks) / p.tick_hz);
    CHECK(count <= seconds() * limits.tick_hz / LOFT_SPAN_TICKS_MAX + 60 + 5.0 * n);
}

/* Curves that are dropped while a run goes on are behind it, and there is room for others. */
static void a_run_goes_on_through_a_small_ring(arb *a)
{
    const double feed = arb_slow_limits(a);
    loft_period p;
    loft_period_init(&p, &limits);
    const double r = feed * arb_between(a, 9000, 12000) * p.ticks / p.tick_hz / acos(-1);
    const unsigned n = 12 + arb_below(a, 12);
    const arrival few = { (uint16_t)(n / 2), 112, NULL };

    begin_chain();
    add_turn(r, n, false, feed);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    const double whole = seconds();
    const unsigned spans_of_all = count;
    CHECK(plan_chain(&few) == PLANNED);
    CHECK(spans_connect());
    CHECK_NEAR(seconds(), whole, 0.5 / limits.tick_hz);
    CHECK(count == spans_of_all);
}

#endif

int main(void)
{
#if LOFT_FOLDS
    PROPERTY(slow_curves_hold_all_limits, 20);
    PROPERTY(a_slow_circle_costs_what_its_shape_asks_for, 20);
    PROPERTY(a_run_goes_on_through_a_small_ring, 20);
#endif
    return check_failures();
}
