/* tests/lib/path/test_slow.c -- properties of lib/path/slow.h
 * SPDX-License-Identifier: MIT
 */
#define CURVES 60

#include "support/motion_oracle.h"  /* cubic_at    */
#include "support/motion_paths.h"   /* even_limits */

#include "path/slow.h"

#if LOFT_FOLDS

static loft_period period;
static loft_chain  slow;
static loft_move   ring[CURVES];

/* A machine, and a feed at which bends of 1 mm are slow for it, mm/s. */
static double arb_machine(arb *a)
{
    const double accel = arb_decades(a, 500, 3000);

    even_limits(arb_between(a, 20, 300), accel, floor(accel * arb_between(a, 15, 40)));
    limits.tol = real_of(arb_decades(a, 0.004, 0.05));
    loft_period_init(&period, &limits);
    loft_chain_init(&slow, &period, ring, CURVES);
    begin_chain();
    return arb_decades(a, 1 / 60.0, 0.5);
}

static bool push_all(void)
{
    bool good = true;

    for (unsigned k = 0; k < curves; k++)
        good = loft_chain_push(&slow, &chain[k]) == LOFT_OK && good;
    return good;
}

static double cubic_length(const loft_vec p[4])
{
    double at[LOFT_AXES], next[LOFT_AXES], sum = 0;

    cubic_at(p, 0, at);
    for (int n = 1; n <= 1000; n++) {
        cubic_at(p, n / 1000.0, next);
        sum += distance(at, next);
        memcpy(at, next, sizeof at);
    }
    return sum;
}

/* It lasts as many ticks as its length needs at its feed. */
static void a_slow_curve_takes_the_time_of_its_length(arb *a)
{
    const double feed = arb_machine(a);
    loft_slow_curve c;
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 }, size = arb_decades(a, 1, 50);
    const enum kind kind = arb_below(a, 2) ? LINE : ARC;
    double u[4], w[4];

    for (int k = 0; k < 4; k++) {
        u[k] = size * shape[kind][0][k];
        w[k] = size * shape[kind][1][k];
    }
    add_curve(d, e, u, w, feed);
    CHECK(push_all());
    CHECK(loft_slow_measure(&slow, 0, &c));
    const double length = cubic_length(chain[0].curve.p), asked = arb_value(chain[0].feed);
    CHECK_NEAR((double)c.length / LOFT_COORD_MM, length, length * 0x1p-14);
    CHECK_NEAR(c.ticks, length / asked * limits.tick_hz, 1 + c.ticks * 0x1p-14);
    CHECK_NEAR((double)c.speed * c.ticks / (1 << LOFT_SLOW_BITS) / LOFT_COORD_MM, length,
               length * 0x1p-14);
    CHECK(c.longest >= 2 * LOFT_SLOW_SPAN * period.ticks && c.longest <= LOFT_SPAN_TICKS_MAX);
}

/* What is fast, bends by much, or is short is not. */
static void what_matters_to_the_axes_is_not_slow(arb *a)
{
    const double feed = arb_machine(a);
    loft_slow_curve c;

    arb_curve(a, LINE, 50, 100, false);                             /* fast */
    arb_curve(a, CUSP, arb_decades(a, 1, 50), feed, false);         /* turns back */
    arb_curve(a, LINE, feed * 7 * period.ticks / limits.tick_hz, feed, false);      /* short */
    arb_curve(a, POINT, 1, feed, false);
    CHECK(push_all());
    for (unsigned k = 0; k < curves; k++)
        CHECK(!loft_slow_measure(&slow, k, &c));
}

/* Curves before a run may be walked; before it is known to be one, those before it. */
static void a_run_is_a_chain_of_its_own(arb *a)
{
    const double feed = arb_machine(a), part = feed * period.ticks / limits.tick_hz;
    const unsigned before = arb_below(a, 4);
    const bool whole = arb_below(a, 2);
    const double length = part * (whole ? 1200 : 900);

    for (unsigned k = 0; k < before; k++)
        arb_curve(a, LINE, 20, 100, false);
    for (unsigned k = 0; k < 4; k++)
        arb_curve(a, LINE, length, feed, k > 0);
    CHECK(push_all());
    loft_slow_look(&slow);
    CHECK(slow.known == before && slow.stops == whole);
    slow.ended = true;
    loft_slow_look(&slow);
    CHECK(slow.known == (whole ? before : before + 4) && slow.stops == whole);
    CHECK(loft_chain_ends(&slow));
    const loft_vec end = loft_chain_end(&slow);
    loft_chain_finish(&slow);
    CHECK(slow.count == (whole ? 4 : 0) && slow.known == 0 && !slow.stops);
    CHECK(loft_vec_equal(slow.from, end));
}

/* So little a turn is none; what the tolerance has no room for ends the run. */
static void runs_go_on_where_the_tolerance_swallows_the_joint(arb *a)
{
    const double feed = arb_machine(a), h = (double)period.ticks / period.tick_hz,
                 most = arb_value(limits.tol) / 4 / h, turn = arb_between(a, 0.3, 3.1),
                 change = 2 * sin(turn / 2) * feed;
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 }, w[4] = { 0 }, u[4] = { 0, 1, 2, 3 };
    loft_slow_curve before, after;
    int64_t by[LOFT_AXES];

    add_curve(d, e, u, w, feed);
    add_curve(d, e, u, w, feed);
    const double d2[LOFT_AXES] = { cos(turn), sin(turn) };
    add_curve(d2, e, u, w, feed);
    CHECK(push_all());
    CHECK(loft_slow_measure(&slow, 0, &before) && loft_slow_measure(&slow, 1, &after));
    CHECK(!loft_slow_turns(&period, &before, &after, by));
    CHECK(loft_slow_measure(&slow, 2, &after));
    CHECK(loft_slow_turns(&period, &before, &after, by));
    if (change < 0.99 * most)
        CHECK(loft_slow_goes_on(&period, &before, &after));
    if (change > 1.01 * most)
        CHECK(!loft_slow_goes_on(&period, &before, &after));
}

#endif

int main(void)
{
#if LOFT_FOLDS
    PROPERTY(a_slow_curve_takes_the_time_of_its_length, 100);
    PROPERTY(what_matters_to_the_axes_is_not_slow, 50);
    PROPERTY(a_run_is_a_chain_of_its_own, 50);
    PROPERTY(runs_go_on_where_the_tolerance_swallows_the_joint, 100);
#endif
    return check_failures();
}
