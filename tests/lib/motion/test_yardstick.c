/* tests/lib/motion/test_yardstick.c -- the yardsticks themselves: uses of limits, distances and
 * counts that are known
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_follow.h"  /* follow_path, uses_of_spans; CHECK, PROPERTY */
#include "support/motion_paths.h"   /* even_limits                                  */
#include "support/motion_steps.h"   /* steps_arrive                                 */

static path track;

/* Every curve of the chain is a span, of so many ticks. */
static void spans_of_chain(uint16_t ticks)
{
    count = curves;
    for (unsigned c = 0; c < curves; c++) {
        for (int k = 0; k < 4; k++)
            spans[c].p[k] = chain[c].curve.p[k];
        spans[c].ticks = ticks;
    }
}

static void one_curve(arb *a, enum kind kind, double size)
{
    even_limits(100, 1000, 10000);
    begin_chain();
    arb_curve(a, kind, size, 100, false);
    spans_of_chain((uint16_t)(1 + arb_below(a, 1000)));
}

/* Never below what 500 samples find, and no more above them than a parabola can rise between
 * two. */
static void the_peak_of_the_speed_is_that_of_many_samples(arb *a)
{
    double most = 0, axis = 0, q[5], v[3];

    one_curve(a, WILD, arb_decades(a, 0.1, 1000));
    for (int n = 0; n <= 500; n++) {
        const motion m = span_at(&spans[0], n / 500.0, limits.tick_hz);
        most = fmax(most, m.speed);
        axis = fmax(axis, fabs(m.v[0]));
    }
    span_squares(&spans[0], 0, 1, q);
    const double peak = sqrt(quartic_peak(q));
    CHECK(peak >= most * (1 - 1e-12) && peak <= most * 1.0001);
    span_speeds(&spans[0], 0, v);
    CHECK(parabola_peak(v) >= axis * (1 - 1e-12) && parabola_peak(v) <= axis * 1.0001 + 1e-12);
}

/* In parts: the parts' peaks give the whole one's. */
static void a_part_of_a_span_has_the_speed_it_has_in_the_whole(arb *a)
{
    double q[5], whole[5], most = 0;

    one_curve(a, WILD, 50);
    span_squares(&spans[0], 0, 1, whole);
    for (int j = 0; j < 7; j++) {
        const double from = j / 7.0, to = (j + 1) / 7.0,
                     first = span_at(&spans[0], from, limits.tick_hz).speed;
        span_squares(&spans[0], from, to, q);
        CHECK_NEAR(sqrt(q[0]), first, 1e-9 * (1 + first));
        most = fmax(most, quartic_peak(q));
    }
    CHECK_NEAR(most, quartic_peak(whole), 3e-6 * most);
}

/* Acceleration and jerk from places a thousandth of the time apart. */
static void uses_agree_with_differences_of_places(arb *a)
{
    one_curve(a, WILD, 100);
    const loft_span *s = &spans[0];
    const double h = duration(s), d = 0.001;
    double accel = 0, jerk = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        for (int end = 0; end < 2; end++) {
            const double z = end ? 1 - 2 * d : 2 * d;
            const double x0 = span_at(s, z - d, 1000).x[i], x1 = span_at(s, z, 1000).x[i],
                         x2 = span_at(s, z + d, 1000).x[i];
            accel = fmax(accel, fabs(x0 - 2 * x1 + x2) / (d * h * d * h) / 1000);
        }
        const double x0 = span_at(s, 0, 1000).x[i], x1 = span_at(s, 1 / 3.0, 1000).x[i];
        const double x2 = span_at(s, 2 / 3.0, 1000).x[i], x3 = span_at(s, 1, 1000).x[i];
        jerk = fmax(jerk, fabs(x3 - 3 * x2 + 3 * x1 - x0) * 27 / (h * h * h) / 10000);
    }
    const motion_uses u = uses_of_spans(100);
    const double g = grain();
    CHECK_NEAR(u.accel + 12 * g / (h * h) / 1000, accel, 0.01 * accel + 1e-6 / (h * h));
    CHECK_NEAR(u.jerk + 24 * g / (h * h * h) / 10000, jerk, 1e-6 * jerk + 1e-9 / (h * h * h));
}

/* Every span becomes two. */
static void halve_spans(void)
{
    for (unsigned k = count; k-- > 0; ) {
        const loft_span s = spans[k];
        loft_cubic c, half[2];
        for (int n = 0; n < 4; n++)
            c.p[n] = s.p[n];
        loft_cubic_split(&c, LOFT_UNIT(0.5), &half[0], &half[1]);
        for (int n = 0; n < 8; n++)
            spans[2 * k + (unsigned)n / 4].p[n % 4] = half[n / 4].p[n % 4];
        spans[2 * k].ticks = spans[2 * k + 1].ticks = s.ticks;
    }
    count *= 2;
}

/* It may cross itself and turn around. */
static void a_chain_is_not_away_from_itself(arb *a)
{
    even_limits(100, 1000, 0);
    begin_chain();
    for (unsigned k = 0, n = 1 + arb_below(a, 6), size = 1 + arb_below(a, 100); k < n; k++)
        arb_curve(a, (enum kind)arb_below(a, KINDS), size, 100, false);
    spans_of_chain(100);
    for (int k = 0; k < 5; k++)
        halve_spans();
    CHECK(follow_path(&track, chain, curves, arb_value(limits.tol) / 64).off <
          arb_value(limits.tol) / 16 + 4 * grain());
}

/* The inner control points of a straight span moved aside by d: its middle is 3/4 d away. */
static void a_span_moved_aside_is_that_far_away(arb *a)
{
    const double d = arb_decades(a, 0.002, 0.05), size = arb_decades(a, 1, 500);
    const unsigned which = arb_below(a, 3);
    const double x[LOFT_AXES] = { 1 }, y[LOFT_AXES] = { 0, 1 },
                 u[4] = { 0, size / 3, size * 2 / 3, size }, w[4] = { 0 };

    even_limits(100, 1000, 0);
    begin_chain();
    for (int k = 0; k < 3; k++)
        add_curve(x, y, u, w, 100);
    spans_of_chain(200);
    for (int k = 1; k < 3; k++)
        spans[which].p[k].axis[1] += real_of(d);
    const double off = follow_path(&track, chain, curves, d / 10000).off -
                       0.75 * arb_value(real_of(d));
    CHECK(off > -1e-4 * d && off < arb_value(limits.tol) / 32 + 2e-4 * d);
}

/* There and back, of a length, left out. */
static void a_tip_that_is_left_out_is_a_distance(arb *a)
{
    const double tip = arb_decades(a, 0.05, 0.09), x[LOFT_AXES] = { 1 }, y[LOFT_AXES] = { 0, 1 };
    const double u[4] = { 0, 10 / 3.0, 20 / 3.0, 10 }, zero[4] = { 0 }, w[4] = { 0, tip, tip, 0 };

    even_limits(100, 1000, 0);
    begin_chain();
    add_curve(x, y, u, zero, 100);
    add_curve(x, y, zero, w, 100);
    add_curve(x, y, u, zero, 100);
    spans_of_chain(200);
    spans[1] = spans[2];
    count = 2;
    const double off = follow_path(&track, chain, curves, tip / 10000).off - 0.75 * tip;
    CHECK(off > -1e-4 * tip && off < arb_value(limits.tol) / 32 + 2e-4 * tip + 2 * grain());
}

/* A span on a slow curve that lasts as long as if it were fast. */
static void speed_is_compared_with_the_feed_of_the_place(arb *a)
{
    const double x[LOFT_AXES] = { 1 }, y[LOFT_AXES] = { 0, 1 }, u[4] = { 0, 20, 40, 60 },
                 w[4] = { 0 };
    const double slow = arb_between(a, 0.1, 1);

    even_limits(1000, 1000, 0);
    begin_chain();
    add_curve(x, y, u, w, 60);
    add_curve(x, y, u, w, 60 * slow);
    spans_of_chain(1000);
    CHECK_NEAR(follow_path(&track, chain, curves, 1).along, 1 / slow, 0.001 / slow);
}

static void steps_arrive_where_the_spans_do(arb *a)
{
    even_limits(100, 1000, 0);
    begin_chain();
    for (int k = 0; k < 3; k++)
        arb_curve(a, WILD, arb_decades(a, 0.01, 20), 100, false);
    spans_of_chain((uint16_t)(1 + arb_below(a, 200)));
    CHECK(steps_arrive(arb_decades(a, 5, 400), (uint16_t)(1 + arb_below(a, 40)), a) == 0);
    spans[2].p[3].axis[0] += real_of(1);
    CHECK(steps_arrive(100, 40, NULL) > 0);
}

int main(void)
{
    PROPERTY(the_peak_of_the_speed_is_that_of_many_samples,      200);
    PROPERTY(a_part_of_a_span_has_the_speed_it_has_in_the_whole, 100);
    PROPERTY(uses_agree_with_differences_of_places,              100);
    PROPERTY(a_chain_is_not_away_from_itself,                     60);
    PROPERTY(a_span_moved_aside_is_that_far_away,                 40);
    PROPERTY(a_tip_that_is_left_out_is_a_distance,                20);
    PROPERTY(speed_is_compared_with_the_feed_of_the_place,        10);
    PROPERTY(steps_arrive_where_the_spans_do,                     20);
    return check_failures();
}
