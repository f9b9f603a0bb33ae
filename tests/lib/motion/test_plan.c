/* tests/lib/motion/test_plan.c -- properties of lib/motion/plan.h and guess.h
 * SPDX-License-Identifier: MIT
 */
#define CURVES 100

#include "support/motion_any.h"     /* check_case, plan_chain */
#include "support/topp_jerk.h"      /* scurve_time            */
#include "wire/codec.h"             /* loft_packer */

/* Bounds on times for a host, and for the little effort of a chip. */
#define EFFORT(much, little) (LOFT_PLAN_EFFORT > 1 ? (much) : (little))

static const arrival all_at_once = { CURVES, 112, NULL };

/* Chains, limits and arrivals of all kinds: no deadlock, gap or lost step; speed, acceleration and
 * jerk of each axis, and the path, within their limits. */
static void random_cases_hold_all_limits(arb *a)
{
    bad = false;
    check_case(arb_below(a, 1000000));
    CHECK(!bad);
}

/* Curves of all kinds, points among them, come into small rings, one by one or in bursts, some of
 * them late: it gets to the end, and there is no gap. */
static void no_arrival_stalls_it(arb *a)
{
    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    arb_short_chain(a, false);
    const unsigned points = arb_below(a, 4);
    for (unsigned k = 0; k < points && k + 1 < curves; k++)
        for (int n = 0; n < 4; n++)
            chain[k].curve.p[n] = chain[points < curves ? points : curves - 1].curve.p[0];
    const arrival how = { (uint16_t)(1 + arb_below(a, 8)), (uint16_t)(64 + arb_below(a, 60)),
                          arb_below(a, 3) ? a : NULL };
    CHECK(plan_chain(&how) == PLANNED);
    CHECK(count == 0 || spans_connect());
}

static void add_line(double length, double feed)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0 },
                 u[4] = { 0, length / 3, length * 2 / 3, length }, w[4] = { 0 };

    begin_chain();
    add_curve(d, e, u, w, feed);
}

/* A line from here, in any direction, which takes so many seconds. */
static void arb_slow_line(arb *a, double length, double time)
{
    double d[LOFT_AXES], size = 0;
    const double e[LOFT_AXES] = { 0 }, u[4] = { 0, length / 3, length * 2 / 3, length },
                 w[4] = { 0 };

    for (int i = 0; i < LOFT_AXES; i++) {
        d[i] = arb_below(a, 4) ? arb_between(a, -1, 1) : i == 0;
        size += d[i] * d[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        d[i] = size > 0 ? d[i] / sqrt(size) : i == 0;
    add_curve(d, e, u, w, fmax(length / time, 1 / 60.0));
}

/* The same with lines that are slow, some of them among faster ones. */
static void slow_lines_hold_all_limits(arb *a)
{
    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    begin_chain();
    for (unsigned n = 1 + arb_below(a, 4); n > 0; n--)
        arb_slow_line(a, arb_decades(a, 0.01, 100), arb_decades(a, 0.1, EFFORT(10, 1)));
    bad = false;
    check_chain(check_seed, a);
    CHECK(!bad);
}

/* However slow a line is: it has a span for each 1023 ticks, and some at its ends; it takes hardly
 * more time than the exact S-curve. */
static void a_slow_line_costs_little(arb *a)
{
    const double feed = arb_decades(a, 1 / 60.0, 8),
                 length = arb_value(real_of(arb_decades(a, 6 * feed, 200 * fmin(1, feed)))),
                 accel = arb_decades(a, 500, 3000), jerk = floor(accel * arb_between(a, 10, 30));
    const arrival how = { CURVES, (uint16_t)(64 + arb_below(a, 300)), NULL };

    even_limits(500, accel, jerk);
    begin_chain();
    arb_slow_line(a, length, length / feed);
    CHECK(plan_chain(&how) == PLANNED);
    CHECK(spans_connect());
    const double asked = arb_value(chain[0].feed), least = scurve_time(length, asked, accel, jerk),
                 ticks = seconds() * limits.tick_hz;
    loft_period p;
    loft_period_init(&p, &limits);
    CHECK(seconds() >= least * 0.999);
    CHECK(seconds() <= least * 1.001 + 4.0 * p.ticks / p.tick_hz);
    CHECK(count <= ticks / LOFT_SPAN_TICKS_MAX + 150 + length / 64 * 100);
}

/* Lines from rest to rest: within 2 % and a period of the exact S-curve. */
static void lines_take_little_more_than_an_s_curve(arb *a)
{
    const double length = arb_value(real_of(arb_decades(a, 0.2, 60)));
    loft_period p;

    even_limits(200, 3000, 100000);
    loft_period_init(&p, &limits);
    add_line(length, 200);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    CHECK(spans_connect());
    const double least = scurve_time(length, 200, 3000, 100000);
    CHECK(seconds() >= least * 0.99);
    CHECK(seconds() <= least * EFFORT(1.02, 1.08) + (double)p.ticks / p.tick_hz);
}

/* Ramps that are longer than what is raised at first. */
static void long_ramps_are_as_steep_as_short_ones(arb *a)
{
    const double jerk = arb_below(a, 2) ? 0 : 4000, length = 300 + 100 * arb_below(a, 4);
    const arrival how = { CURVES, 176, NULL };

    even_limits(100, 200, jerk);
    add_line(length, 100);
    CHECK(plan_chain(&how) == PLANNED);
    CHECK(spans_connect());
    CHECK(seconds() <= EFFORT(1.02, 1.04) * scurve_time(length, 100, 200, jerk > 0 ? jerk : 1e9));
}

#define LINES 20

/* A line of `length`: its time less a period, over that of the exact S-curve. */
static double over_s_curve(double length, double feed, double accel, double jerk, uint16_t ahead)
{
    const arrival how = { CURVES, ahead, NULL };
    const double least = scurve_time(length, feed, accel, floor(jerk));
    loft_period p;

    even_limits(feed, accel, jerk);
    loft_period_init(&p, &limits);
    add_line(length, feed);
    CHECK(plan_chain(&how) == PLANNED);
    CHECK(spans_connect());
    CHECK(seconds() >= least * 0.99);
    return (seconds() - (double)p.ticks / p.tick_hz) / least;
}

/* Ramps of 5 to 100 periods, and lines that are known as a whole or not: within 15 %, and within
 * 3 % as a rule. */
static void lines_with_any_ramps_take_little_more(arb *a)
{
    static double sum;
    const double accel = arb_decades(a, 100, 3000), length = arb_between(a, 50, 600),
                 over = over_s_curve(length, 100, accel, accel * arb_between(a, 40, 50), 176);

    CHECK(over <= 1.15);
    sum += over;
    if (!check_sampled() && check_seed == LINES)
        CHECK(sum <= LINES * 1.03);
}

/* Lines that end before the feed is reached, or soon after, with ramps of up to hundreds of
 * periods: within a fifth. */
static void lines_shorter_than_their_ramps_take_little_more(arb *a)
{
    const double accel = arb_decades(a, 50, 500), length = arb_between(a, 30, 150);

    CHECK(over_s_curve(length, 200, accel, accel * arb_between(a, 8, 80), 400) <= 1.2);
}

static void outline(double feed)
{
    static const double x[12][8] = {
        { 0, 0, 0, 3.333333, -3.262825, 7.546261, -5.679492, 10 },
        { -5.679492, 10, -8.096159, 12.453739, -11.613249, 13.055765, -14.5, 14.722432 },
        { -14.5, 14.722432, -17.386751, 16.389099, -19.666667, 19.133975, -23, 20 },
        { -23, 20, -26.333333, 20.866025, -31.613249, 21.585251, -34.5, 19.918584 },
        { -34.5, 19.918584, -37.386751, 18.251918, -39.403841, 13.319764, -40.320508, 10 },
        { -40.320508, 10, -41.237175, 6.680236, -40, 3.333333, -40, 0 },
        { -40, 0, -40, -3.333333, -41.237175, -6.680236, -40.320508, -10 },
        { -40.320508, -10, -39.403841, -13.319764, -37.386751, -18.251918, -34.5, -19.918584 },
        { -34.5, -19.918584, -31.613249, -21.585251, -26.333333, -20.866025, -23, -20 },
        { -23, -20, -19.666667, -19.133975, -17.386751, -16.389099, -14.5, -14.722432 },
        { -14.5, -14.722432, -11.613249, -13.055765, -8.096159, -12.453739, -5.679492, -10 },
        { -5.679492, -10, -3.262825, -7.546261, 0, -3.333333, 0, 0 }
    };
    begin_chain();
    for (int c = 0; c < 12; c++, curves++) {
        chain[c].feed = real_of(feed);
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                chain[c].curve.p[k].axis[i] = real_of(i < 2 ? x[c][2 * k + i] : 0);
    }
}

/* Each curve in eight, at even parameters. */
static void cut_in_eight(void)
{
    for (unsigned c = curves; c-- > 0;) {
        const loft_move whole = chain[c];
        for (int n = 7; n >= 0; n--) {
            loft_move *m = &chain[8 * c + (unsigned)n];
            m->feed = whole.feed;
            for (int i = 0; i < LOFT_AXES; i++) {
                double p[4], out[4];
                for (int k = 0; k < 4; k++)
                    p[k] = arb_value(whole.curve.p[k].axis[i]);
                for (int k = 0; k < 4; k++) {           /* blossoms */
                    double q[4] = { p[0], p[1], p[2], p[3] };
                    for (int r = 0; r < 3; r++) {
                        const double t = (n + (r < k)) / 8.0;
                        for (int j = 0; j < 3 - r; j++)
                            q[j] += t * (q[j + 1] - q[j]);
                    }
                    out[k] = q[0];
                }
                for (int k = 0; k < 4; k++)
                    m->curve.p[k].axis[i] = real_of(out[k]);
            }
        }
    }
    curves *= 8;
}

static void it_does_not_matter_how_a_path_is_cut(arb *a)
{
    const bool soft = arb_below(a, 2);
    const double feed = soft ? 100 : 200;

    even_limits(feed, soft ? 500 : 3000, soft ? 10000 : 100000);
    outline(feed);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    const double whole = seconds();
    cut_in_eight();
    CHECK(curves == 96 && plan_chain(&all_at_once) == PLANNED);
    CHECK_NEAR(seconds() / whole, 1, 0.015);
    CHECK(spans_connect());
    CHECK(whole < EFFORT(soft ? 2.05 : 0.95, soft ? 2.20 : 1.02));
}

/* The bytes of all spans on the wire, without frames. */
static unsigned bytes_of_spans(void)
{
    int32_t start[LOFT_AXES];
    loft_predictor at;
    loft_item item;
    unsigned sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        start[i] = loft_raw_from_real(spans[0].p[0].axis[i]);
    loft_predictor_init(&at, start);
    for (unsigned k = 0; k < count; k++) {
        uint8_t byte[LOFT_ITEM_BYTES];
        loft_packer p;
        loft_packer_init(&p, LOFT_SPANS, &at, byte, LOFT_ITEM_BYTES);
        CHECK(loft_item_from_span(&item, &spans[k]) == LOFT_OK);
        CHECK(loft_packer_push(&p, &item) == LOFT_OK);
        sum += p.size;
        at = p.predictor;
    }
    return sum;
}

/* Where the motion is smooth a span lasts many periods. With one span a period these are 336, 307
 * and 432 spans. */
static void spans_are_few_bytes(arb *a)
{
    static const struct {
        double v, accel, jerk;
        unsigned spans, bytes;
    } most[3] = { { 100, 500, 10000, 150, 2200 },
                  { 200, 3000, 100000, 150, 2200 },
                  { 100, 500, 0, 210, 2900 } };
    (void)a;
    for (int n = 0; n < 3; n++) {
        even_limits(most[n].v, most[n].accel, most[n].jerk);
        outline(most[n].v);
        CHECK(plan_chain(&all_at_once) == PLANNED);
        const unsigned bytes = bytes_of_spans();
        CHECK(count <= most[n].spans && bytes <= most[n].bytes);
    }
}

/* A zigzag with smooth hairpins, as a uniform cubic B-spline. */
static void zigzag(double feed)
{
    begin_chain();
    for (int c = 0; c < 10; c++, curves++) {
        chain[curves].feed = real_of(feed);
        for (int i = 0; i < LOFT_AXES; i++) {
            double q[4];
            for (int k = 0; k < 4; k++)
                q[k] = i == 0 ? c + k : i == 1 ? (c + k) * 7 % 19 : 0;
            const double p[4] = { (q[0] + 4 * q[1] + q[2]) / 6, (2 * q[1] + q[2]) / 3,
                                  (q[1] + 2 * q[2]) / 3, (q[1] + 4 * q[2] + q[3]) / 6 };
            for (int k = 0; k < 4; k++)
                chain[curves].curve.p[k].axis[i] = real_of(p[k]);
        }
    }
}

/* From one hairpin to the next jerk is at its limit, and acceleration is high in both. */
static void hairpins_are_passed_at_speed(arb *a)
{
    const arrival how = { CURVES, (uint16_t)(176 + 200 * arb_below(a, 2)), NULL };

    even_limits(300, 2000, 40000);
    zigzag(300);
    CHECK(plan_chain(&how) == PLANNED);
    CHECK(spans_connect());
    CHECK(seconds() < EFFORT(1.20, 1.44));         /* 1.42 with a guess from an even pace */
}

/* A larger tolerance is not slower. */
static void more_tolerance_is_faster(arb *a)
{
    (void)a;
    even_limits(200, 3000, 100000);
    outline(200);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    const double fine = seconds();
    limits.tol = real_of(0.02);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    const double coarse = seconds();
    limits.tol = real_of(0.05);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    CHECK(coarse <= fine && seconds() <= coarse * EFFORT(1.005, 1.03));
}

static void add_line_to(double x, double y, double feed)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 }, u[4] = { 0, x / 3, x * 2 / 3, x },
                 w[4] = { 0, y / 3, y * 2 / 3, y };
    add_curve(d, e, u, w, feed);
}

/* A star of ten sharp corners, or teeth of 60 degrees. */
static void corners_of_lines(bool star)
{
    double x = 20, y = 0;

    begin_chain();
    for (int k = 1; k <= 20; k++) {
        const double r = k % 2 ? 8 : 20, to_x = r * cos(k * 0.314159265358979),
                     to_y = r * sin(k * 0.314159265358979);
        if (star)
            add_line_to(to_x - x, to_y - y, 200);
        else
            add_line_to(1.5, k % 2 ? 2.598 : -2.598, 200);
        x = to_x;
        y = to_y;
    }
}

/* Where corners have a larger tolerance they are faster; they are within it, and all else within
 * the other one. Teeth without a limit of jerk take what their height takes, 1.177 s, and little
 * more, whatever their corners are. */
static void larger_corners_are_faster(bool star)
{
    static path track;
    const double most = star || limits.max_jerk[0] > 0 ? 1 : 1.001;
    double before = 1e9;

    for (int n = 0; n < 3; n++) {
        corners_of_lines(star);
        limits.corner = real_of(n * (n + 3) * 0.005);       /* 0, 20, 50 um */
        limits.tick_hz = 20000;                             /* whole ticks hide little */
        CHECK(plan_chain(&all_at_once) == PLANNED);
        CHECK(spans_connect());
        CHECK(seconds() < before * most);
        before = seconds();
        const motion_uses u = uses_of_spans(1e9);
        CHECK(u.speed <= 1.001 && u.accel <= 1.005 && u.jerk <= 1.02);
        CHECK(follow_path(&track, chain, curves, arb_value(limits.tol) / 64).off <=
              arb_value(limits.tol) * 1.02);
    }
}

static void corners_are_rounded_within_their_own(arb *a)
{
    (void)a;
    even_limits(200, 3000, check_seed & 1 ? 0 : 100000);
    larger_corners_are_faster(check_seed & 2);
}

/* Room falls with each curve; all of them are behind it where it rests, and never more than were
 * pushed. */
static void room_and_passed_curves_are_told(arb *a)
{
    static loft_plan plan;
    static loft_move moves[4];
    static loft_knot knots[LOFT_PLAN_KNOTS_MIN];
    enum loft_plan_state state = LOFT_PLAN_SPAN;
    uint16_t pushed = 0, passed = 0;
    loft_span s;

    even_limits(100, 500, 10000);
    CHECK(loft_plan_init(&plan, &limits, moves, 4, knots, LOFT_PLAN_KNOTS_MIN) == LOFT_OK);
    outline(100);
    while (state != LOFT_PLAN_REST) {
        while (pushed < curves && arb_below(a, 3) > 0) {
            const uint16_t room = loft_plan_room(&plan);
            const bool full = loft_plan_push(&plan, &chain[pushed]) == LOFT_ERR_SPACE;
            CHECK(full == (room == 0));
            if (full)
                break;
            pushed++;
            CHECK(loft_plan_room(&plan) == room - 1);
        }
        if (pushed == curves)
            loft_plan_end(&plan);
        state = loft_plan_next(&plan, &s);
        state = state == LOFT_PLAN_REST && pushed < curves ? LOFT_PLAN_WAIT : state;
        CHECK(loft_plan_passed(&plan) >= passed && loft_plan_passed(&plan) <= pushed);
        passed = loft_plan_passed(&plan);
    }
    CHECK(passed == curves && loft_plan_room(&plan) == 4);
}

/* From end to start smooth chains take as long as from start to end. Of 150 in q16 14 differ by
 * more than 1 % and a period, at most by 7.6 %: not every seed holds the bound. */
static void the_way_back_takes_the_same_time(arb *a)
{
    const arrival far = { CURVES, KNOTS, NULL };
    const double size = arb_decades(a, 5, 100), feed = arb_decades(a, 5, 300);

    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    begin_chain();
    for (unsigned k = 1 + arb_below(a, 8); k > 0; k--)
        arb_curve(a, (enum kind)arb_below(a, SMOOTH + 1), size * arb_decades(a, 0.2, 1), feed,
                  true);
    CHECK(plan_chain(&far) == PLANNED);
    const double there = seconds();
    for (unsigned c = 0; c < (curves + 1) / 2; c++) {
        const loft_move m = chain[c];
        chain[c] = chain[curves - 1 - c];
        chain[curves - 1 - c] = m;
    }
    for (unsigned c = 0; c < curves; c++) {
        const loft_cubic m = chain[c].curve;
        for (int k = 0; k < 4; k++)
            chain[c].curve.p[k] = m.p[3 - k];
    }
    CHECK(plan_chain(&far) == PLANNED);
    loft_period p;
    loft_period_init(&p, &limits);
    CHECK_NEAR(seconds(), there, 0.015 * there + (double)p.ticks / p.tick_hz);
}

/* With the look-ahead of a chip, as if all of it were known. */
static void a_short_look_ahead_costs_little_time(arb *a)
{
    const arrival far = { CURVES, KNOTS, NULL }, near = { 8, 176, NULL };
    const bool soft = arb_below(a, 2);
    const double feed = soft ? 100 : 200;

    even_limits(feed, soft ? 500 : 3000, soft ? 10000 : 100000);
    outline(feed);
    CHECK(plan_chain(&far) == PLANNED);
    const double whole = seconds();
    CHECK(plan_chain(&near) == PLANNED);
    CHECK(seconds() <= EFFORT(1.03, 1.08) * whole);
}

static enum loft_status status_of(uint16_t moves, uint16_t knots)
{
    static loft_plan plan;
    static loft_move ring[12];
    static loft_knot room[LOFT_PLAN_KNOTS_MIN];
    enum loft_status status = loft_plan_init(&plan, &limits, ring, moves, room, knots);

    for (unsigned k = 0; k < curves && status == LOFT_OK; k++)
        status = loft_plan_push(&plan, &chain[k]);
    return status;
}

static void impossible_chains_are_refused(arb *a)
{
    const unsigned k = arb_below(a, 12), i = arb_below(a, LOFT_AXES), j = arb_below(a, 4);

    usual_limits();
    outline(50);
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_OK);
    CHECK(status_of(0, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_SPACE);
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN - 1) == LOFT_ERR_SPACE);
    CHECK(status_of(11, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_SPACE);
    chain[k].feed = 0;
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_ARG);
    chain[k].feed = real_of(16384);
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_RANGE);
    outline(50);
    chain[k].curve.p[j].axis[i] = real_of(arb_below(a, 2) ? 8192 : -8192);
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_RANGE || (j == 0 && k > 0));
    outline(50);
    chain[1 + arb_below(a, 11)].curve.p[0].axis[i] += real_of(0.001);
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_ARG);
    limits.tol = 0;
    CHECK(status_of(12, LOFT_PLAN_KNOTS_MIN) == LOFT_ERR_ARG);
}

static void a_point_needs_no_spans(arb *a)
{
    static loft_plan plan;
    static loft_move moves[4];
    static loft_knot knots[LOFT_PLAN_KNOTS_MIN];
    loft_span s;

    arb_limits(a);
    begin_chain();
    for (unsigned k = 1 + arb_below(a, 3); k > 0; k--)
        arb_curve(a, POINT, 1, 10, false);
    CHECK(loft_plan_init(&plan, &limits, moves, 4, knots, LOFT_PLAN_KNOTS_MIN) == LOFT_OK);
    CHECK(loft_plan_next(&plan, &s) == LOFT_PLAN_REST);
    loft_plan_end(&plan);
    CHECK(loft_plan_next(&plan, &s) == LOFT_PLAN_REST);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_plan_push(&plan, &chain[k]) == LOFT_OK);
    loft_plan_end(&plan);
    CHECK(loft_plan_next(&plan, &s) == LOFT_PLAN_REST);
    CHECK(loft_plan_next(&plan, &s) == LOFT_PLAN_REST);
    CHECK(loft_plan_passed(&plan) == curves);
}

/* Does it rest exactly there? */
static bool rests_at(loft_vec at)
{
    for (unsigned k = 0; k < count; k++)
        if (loft_vec_equal(spans[k].p[3], at) && loft_vec_equal(spans[k].p[2], at))
            return true;
    return false;
}

/* It rests exactly on corners that turn by more than is asked for, however curves arrive, and on no
 * others; a curve without length between hides none. */
static void it_stops_exactly_at_sharp_corners(arb *a)
{
    const double most = arb_between(a, 4, 120);
    const arrival piecemeal = { (uint16_t)(1 + arb_below(a, 8)), (uint16_t)(64 + arb_below(a, 60)),
                                a };
    bool sharp[12];
    double heading_at = 0;

    even_limits(arb_decades(a, 20, 200), arb_decades(a, 500, 5000),
                arb_below(a, 2) ? 0 : arb_decades(a, 10000, 200000));
    limits.exact = real_of(2 * sin(most * 3.14159265358979 / 360));
    begin_chain();
    for (int n = 0; n < 12; n++) {
        const double e[LOFT_AXES] = { 0 }, size = arb_decades(a, 1, 10),
                     u[4] = { 0, size / 3, size * 2 / 3, size }, w[4] = { 0 };
        const double turned = arb_below(a, 2) ? arb_between(a, 0, most - 1)
                                              : arb_between(a, most + 1, 175);
        heading_at += turned * 3.14159265358979 / 180;
        const double d[LOFT_AXES] = { cos(heading_at), sin(heading_at) };
        sharp[n] = turned > most;
        if (n > 0 && arb_below(a, 4) == 0)              /* without length */
            add_curve(d, e, w, w, 100);
        add_curve(d, e, u, w, 100);
    }
    const bool flushed = arb_below(a, 2);       /* then it may rest anywhere */
    CHECK(plan_chain(flushed ? &piecemeal : &all_at_once) == PLANNED);
    CHECK(spans_connect());
    const motion_uses u = uses_of_spans(1e9);
    CHECK(u.speed <= 1.001 && u.accel <= 1.005 && u.jerk <= 1.02);
    for (unsigned c = 1, n = 0; c < curves; c++)
        if (!loft_vec_equal(chain[c].curve.p[0], chain[c].curve.p[3])) {
            n++;
            CHECK(rests_at(chain[c].curve.p[0]) || !sharp[n]);
            CHECK(!rests_at(chain[c].curve.p[0]) || sharp[n] || flushed);
        }
}

/* A smooth path is not slower with it. */
static void smooth_paths_do_not_stop(arb *a)
{
    (void)a;
    even_limits(200, 3000, 100000);
    outline(200);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    const double before = seconds();
    limits.exact = real_of(0.0872);
    CHECK(plan_chain(&all_at_once) == PLANNED);
    CHECK_NEAR(seconds(), before, 1e-9);        /* a tick is 1e-3; i686 sums with 80 bits */
    limits.exact = 0;
}

int main(void)
{
    PROPERTY(random_cases_hold_all_limits, 40);
    PROPERTY(slow_lines_hold_all_limits, 20);
    if (LOFT_PLAN_EFFORT > 1)
        PROPERTY(a_slow_line_costs_little, 20);
    PROPERTY(no_arrival_stalls_it, 50);
    PROPERTY(lines_take_little_more_than_an_s_curve, 20);
    PROPERTY(long_ramps_are_as_steep_as_short_ones, 8);
    PROPERTY(lines_with_any_ramps_take_little_more, LINES);
    PROPERTY(lines_shorter_than_their_ramps_take_little_more, 10);
    PROPERTY(it_does_not_matter_how_a_path_is_cut, 2);
    PROPERTY(spans_are_few_bytes, 1);
    PROPERTY(hairpins_are_passed_at_speed, 2);
    PROPERTY(more_tolerance_is_faster, 1);
    PROPERTY(corners_are_rounded_within_their_own, 4);
    PROPERTY(room_and_passed_curves_are_told, 2);
    PROPERTY(the_way_back_takes_the_same_time, 6);
    PROPERTY(a_short_look_ahead_costs_little_time, 2);
    PROPERTY(impossible_chains_are_refused, 20);
    PROPERTY(a_point_needs_no_spans, 10);
    PROPERTY(it_stops_exactly_at_sharp_corners, 40);
    PROPERTY(smooth_paths_do_not_stop, 1);
    return check_failures();
}
