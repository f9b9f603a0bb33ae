/* tests/lib/motion/test_plan.c -- properties of lib/motion/plan.h, with course, profile, arc and
 * limits under it
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_chains.h"  /* chain, limits, arb_chain, arb_curve */
#include "support/motion_oracle.h"  /* path, span_at; CHECK, PROPERTY, arb */

#define SPANS 200000

#define PIECES (CURVES * 96)

static loft_move  ring[CURVES];
static loft_plan_piece pieces[PIECES];
static loft_span  spans[SPANS];
static unsigned   count;
static path       track;

/* Plan the chain in rings of this size, pushing as much as there is room for, or `piecemeal`. */
static bool plan_in(uint16_t moves, uint16_t most_pieces, arb *piecemeal)
{
    static loft_plan plan;
    enum loft_status status = loft_plan_init(&plan, &limits, ring, moves, pieces, most_pieces);
    enum loft_plan_state state = LOFT_PLAN_WAIT;
    unsigned next = 0;

    count = 0;
    CHECK(status == LOFT_OK);
    while (status == LOFT_OK && count < SPANS) {
        unsigned batch = piecemeal ? arb_below(piecemeal, 3) : CURVES;
        for (; next < curves && batch > 0 &&
               (status = loft_plan_push(&plan, &chain[next])) == LOFT_OK;
             next++)
            batch--;
        status = status == LOFT_ERR_SPACE ? LOFT_OK : status;
        CHECK(status == LOFT_OK);
        state = LOFT_PLAN_WAIT;
        if (next == curves || (piecemeal && arb_below(piecemeal, 4) == 0))
            loft_plan_end(&plan);
        for (unsigned n = piecemeal ? arb_below(piecemeal, 9) : SPANS; n > 0 && count < SPANS; n--)
            if ((state = loft_plan_next(&plan, &spans[count])) != LOFT_PLAN_SPAN)
                break;
            else
                count++;
        if (state == LOFT_PLAN_REST && next == curves)
            break;
    }
    CHECK(count < SPANS);
    return status == LOFT_OK && count > 0 && count < SPANS;
}

static bool plan_all(void) { return plan_in(CURVES, PIECES, NULL); }

static double seconds(void)
{
    double ticks = 0;
    for (unsigned k = 0; k < count; k++)
        ticks += spans[k].ticks;
    return ticks / limits.tick_hz;
}

/* What rounding the control points, by half a grain each, adds to velocity and acceleration of a
 * span. */
static double grain(void)
{
    double size = 0;
    for (unsigned c = 0; c < curves; c++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                size = fmax(size, fabs(arb_value(chain[c].curve.p[k].axis[i])));
    return BY_NUM(0x1p-16, (size + 1) * 0x1p-23, (size + 1) * 0x1p-52);
}

static double duration(const loft_span *s)       { return s->ticks / (double)limits.tick_hz; }
static double speed_noise(const loft_span *s)    { return 3 * grain() / duration(s); }
static double accel_noise(const loft_span *s) { return 12 * grain() / (duration(s) * duration(s)); }
static double jerk_noise(const loft_span *s)
{
    return 24 * grain() / (duration(s) * duration(s) * duration(s));
}

/* Properties
 * ---------- */

static void check_connected(void)
{
    CHECK(loft_vec_equal(spans[0].p[0], chain[0].curve.p[0]) &&
          loft_vec_equal(spans[0].p[1], spans[0].p[0]));
    CHECK(loft_vec_equal(spans[count - 1].p[3], chain[curves - 1].curve.p[3]));
    CHECK(loft_vec_equal(spans[count - 1].p[2], spans[count - 1].p[3]));
    for (unsigned k = 0; k < count; k++) {
        CHECK(spans[k].ticks >= 1 && spans[k].ticks <= LOFT_SPAN_TICKS_MAX);
        CHECK(k == 0 || loft_vec_equal(spans[k].p[0], spans[k - 1].p[3]));
    }
}

/* A cubic's acceleration is a straight line in time: its ends are its extremes. */
static double accel_excess(void)
{
    double worst = 0;
    for (unsigned k = 0; k < count; k++)
        for (int end = 0; end < 2; end++) {
            const motion m = span_at(&spans[k], end, limits.tick_hz);
            for (int i = 0; i < LOFT_AXES; i++)
                worst = fmax(worst, (fabs(m.a[i]) - accel_noise(&spans[k])) /
                                        arb_value(limits.max_accel[i]));
        }
    return worst;
}

static double speed_excess(double feed)
{
    double worst = 0;
    for (unsigned k = 0; k < count; k++)
        for (int j = 0; j <= 8; j++) {
            const motion m = span_at(&spans[k], j / 8.0, limits.tick_hz);
            const double noise = speed_noise(&spans[k]);
            worst = fmax(worst, (m.speed - sqrt(LOFT_AXES) * noise - 0.001) / feed);
            for (int i = 0; i < LOFT_AXES; i++)
                worst = fmax(worst,
                             (fabs(m.v[i]) - noise - 0.001) / arb_value(limits.max_speed[i]));
        }
    return worst;
}

static double jerk_excess(void)
{
    double worst = 0;
    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_vec *p = spans[k].p;
            const double third = arb_value(p[3].axis[i]) - 3 * arb_value(p[2].axis[i]) +
                                 3 * arb_value(p[1].axis[i]) - arb_value(p[0].axis[i]);
            const double jerk = 6 * fabs(third) / pow(duration(&spans[k]), 3);
            worst = fmax(worst, (jerk - jerk_noise(&spans[k])) / limits.max_jerk[i]);
        }
    return worst;
}

/* The largest jump of acceleration between spans, as a part of the limit. */
static double accel_jump(void)
{
    double worst = 0;
    for (unsigned k = 1; k < count; k++) {
        const motion a = span_at(&spans[k - 1], 1, limits.tick_hz),
                     b = span_at(&spans[k], 0, limits.tick_hz);
        for (int i = 0; i < LOFT_AXES; i++)
            worst = fmax(worst, (fabs(a.a[i] - b.a[i]) - accel_noise(&spans[k - 1]) -
                                 accel_noise(&spans[k])) /
                                    arb_value(limits.max_accel[i]));
    }
    return worst;
}

/* The largest distance of the spans from the path near the place where they should be; *gone: their
 * length. Where the plan rounds a feature smaller than the tolerance it falls short of the path's
 * length, hence `near`. */
static double path_excess(double *gone)
{
    const double tol = arb_value(limits.tol);
    double worst = 0, extent = 0;
    unsigned at = 0;

    for (unsigned c = 0; c < curves; c++)
        extent = fmax(extent, polygon_length(&chain[c].curve));
    path_trace(&track, chain, curves, fmax(1e-6, extent / 200));
    *gone = 0;
    for (unsigned k = 0; k < count; k++) {
        const unsigned n = spans[k].ticks < 7 ? spans[k].ticks : 7;
        for (unsigned j = 1; j <= n; j++) {
            const motion m = span_at(&spans[k], (double)j / n, limits.tick_hz);
            *gone += span_at(&spans[k], (j - 0.5) / n, limits.tick_hz).speed * duration(&spans[k]) /
                     n;
            const double near = 0.02 * *gone + 20 * tol * curves + extent / 50;
            worst = fmax(worst, path_distance(&track, &at, m.x, *gone - near, *gone + near));
        }
    }
    return worst / tol;
}

static void spans_of_any_chain_connect_from_rest_to_rest(arb *a)
{
    arb_limits(a);
    arb_chain(a);
    if (plan_all())
        check_connected();
}

/* With corner = 0 no corner is exempt: cusps, joints, reversals, specks. */
static void acceleration_is_never_exceeded(arb *a)
{
    arb_limits(a);
    limits.corner = 0;
    arb_chain(a);
    if (plan_all())
        CHECK_NEAR(fmax(1, accel_excess()), 1, 0.01);
}

/* Tangents agree at the joints, to rounding. */
static double arb_smooth_chain(arb *a)
{
    const double size = arb_decades(a, 5, 200), feed = arb_value(real_of(arb_decades(a, 5, 500)));
    const unsigned n = 1 + arb_below(a, 12);

    begin_chain();
    for (unsigned k = 0; k < n; k++)
        arb_curve(a, (enum kind)arb_below(a, SMOOTH + 1), size * arb_decades(a, 0.2, 1), feed,
                  true);
    return feed;
}

static void smooth_chains_hold_all_limits_whatever_the_corner(arb *a)
{
    double gone;

    arb_limits(a);
    limits.corner = real_of(arb_decades(a, 0.001, 0.05));
    const double feed = arb_smooth_chain(a);
    if (!plan_all())
        return;
    check_connected();
    CHECK_NEAR(fmax(1, accel_excess()), 1, 0.0005);
    CHECK_NEAR(fmax(1, speed_excess(feed)), 1, 0.001);
    CHECK_NEAR(path_excess(&gone), 0, 1);
    CHECK_NEAR(gone, track.length, 0.001 * track.length + 1);
}

/* Any chain, any corner. Nothing is left out: what is rounded off at a corner is less than 20 times
 * the tolerance. */
static void the_path_is_kept_within_the_tolerance(arb *a)
{
    double gone;

    arb_limits(a);
    arb_chain(a);
    if (!plan_all())
        return;
    CHECK_NEAR(path_excess(&gone), 0, 1);
    CHECK_NEAR(gone, track.length, 0.01 * track.length + 20 * arb_value(limits.tol) * curves);
}

/* Speed per axis holds everywhere, speed along the path on chains of one feed. */
static void speed_is_never_exceeded(arb *a)
{
    arb_limits(a);
    arb_chain(a);
    for (unsigned c = 0; c < curves; c++)
        chain[c].feed = chain[0].feed;
    if (plan_all())
        CHECK_NEAR(fmax(1, speed_excess(arb_value(chain[0].feed))), 1, 0.001);
}

static void arb_jerk(arb *a)
{
    const double ratio = arb_decades(a, 5, 200);
    for (int i = 0; i < LOFT_AXES; i++)
        limits.max_jerk[i] = (uint32_t)(ratio * arb_value(limits.max_accel[i]));
}

static void check_limits(double feed)
{
    double gone;
    check_connected();
    CHECK_NEAR(fmax(1, speed_excess(feed)), 1, 0.001);
    CHECK_NEAR(fmax(1, accel_excess()), 1, 0.01);
    CHECK_NEAR(path_excess(&gone), 0, 1);
    if (limits.max_jerk[0] > 0) {
        CHECK_NEAR(fmax(1, jerk_excess()), 1, 0.02);
        CHECK_NEAR(accel_jump(), 0, 0.01);
    }
}

static void any_chain_keeps_all_limits_where_jerk_is_limited(arb *a)
{
    arb_limits(a);
    arb_jerk(a);
    arb_chain(a);
    for (unsigned c = 0; c < curves; c++)
        chain[c].feed = chain[0].feed;
    if (plan_all())
        check_limits(arb_value(chain[0].feed));
}

static void smooth_chains_keep_all_limits_where_jerk_is_limited(arb *a)
{
    arb_limits(a);
    arb_jerk(a);
    const double feed = arb_smooth_chain(a);
    if (plan_all())
        check_limits(feed);
}

/* Rings of a few curves and pieces, curves that come one by one or late, spans taken early. */
static void however_curves_arrive_all_limits_are_kept(arb *a)
{
    arb_limits(a);
    limits.corner = 0;
    if (arb_below(a, 2))
        arb_jerk(a);
    const double feed = arb_smooth_chain(a);
    if (plan_in((uint16_t)(1 + arb_below(a, 4)), (uint16_t)(3 + arb_below(a, 40)), a))
        check_limits(feed);
}

/* As if all of it were known: spans are given only when what comes later cannot change them. */
static void a_ring_that_sees_far_enough_costs_no_time(arb *a)
{
    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    arb_smooth_chain(a);
    if (!plan_all())
        return;
    const double whole = seconds();
    double top = 0, slow = 1e9, least = 1e9;
    for (unsigned k = 0; k < count; k++)
        top = fmax(top, span_at(&spans[k], 0, limits.tick_hz).speed);
    for (int i = 0; i < LOFT_AXES; i++)
        slow = fmin(slow, arb_value(limits.max_accel[i]));
    for (unsigned c = 0; c < curves; c++)
        least = fmin(least, polygon_length(&chain[c].curve) / 2);
    if (least > 2 * top * top / slow + 0.4 * top && plan_in(4, PIECES, NULL))
        CHECK_NEAR(seconds(), whole, 0.001 * whole + 0.01);
}

/* L / v + v / a, or 2 sqrt(L / a) when the feed is not reached. */
static double trapezoid(double length, double feed, double accel)
{
    return length > feed * feed / accel ? length / feed + feed / accel : 2 * sqrt(length / accel);
}

/* The plan keeps 1/64 of the acceleration and rounds up to beats of at most 2 ms, two of them at
 * each end. */
static void a_line_takes_the_time_of_a_trapezoid(arb *a)
{
    const double length = arb_decades(a, 0.1, 1000), d[LOFT_AXES] = { 1 },
                 u[4] = { 0, length / 3, length * 2 / 3, length }, w[4] = { 0 };

    usual_limits();
    begin_chain();
    add_curve(d, d, u, w, arb_decades(a, fmax(1, length / 60), 500));
    if (!plan_all())
        return;
    const double feed = arb_value(chain[0].feed), least = trapezoid(length, feed, 500),
                 most = trapezoid(length, feed, 500 * 63 / 64.0);
    CHECK(seconds() > least * 0.995);
    CHECK(seconds() < most * 1.001 + 0.009);
}

/* Nothing changes but a joint that is none. */
static void cutting_a_curve_in_two_costs_no_time(arb *a)
{
    usual_limits();
    arb_smooth_chain(a);
    if (!plan_all())
        return;
    const double whole = seconds();
    for (unsigned c = curves; c-- > 0; ) {
        const loft_move m = chain[c];
        chain[2 * c] = chain[2 * c + 1] = m;
        loft_cubic_split(&m.curve, LOFT_UNIT(0.5), &chain[2 * c].curve, &chain[2 * c + 1].curve);
    }
    curves *= 2;
    if (plan_all())
        CHECK_NEAR(seconds(), whole, 0.01 * whole + 0.01);
}

static void the_way_back_takes_the_same_time(arb *a)
{
    arb_limits(a);
    arb_smooth_chain(a);
    if (!plan_all())
        return;
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
    if (plan_all())
        CHECK_NEAR(seconds(), there, 0.01 * there + 0.01);
}

/* The outline of the machine benchmark: 12 cubics, closed, smallest radius 5.2 mm. In nm, two
 * axes. */
static const int32_t outline[12][3][2] = {
    { { 0, 3333333 }, { -3262825, 7546261 }, { -5679492, 10000000 } },
    { { -8096159, 12453739 }, { -11613249, 13055765 }, { -14500000, 14722432 } },
    { { -17386751, 16389099 }, { -19666667, 19133975 }, { -23000000, 20000000 } },
    { { -26333333, 20866025 }, { -31613249, 21585251 }, { -34500000, 19918584 } },
    { { -37386751, 18251918 }, { -39403841, 13319764 }, { -40320508, 10000000 } },
    { { -41237175, 6680236 }, { -40000000, 3333333 }, { -40000000, 0 } },
    { { -40000000, -3333333 }, { -41237175, -6680236 }, { -40320508, -10000000 } },
    { { -39403841, -13319764 }, { -37386751, -18251918 }, { -34500000, -19918584 } },
    { { -31613249, -21585251 }, { -26333333, -20866025 }, { -23000000, -20000000 } },
    { { -19666667, -19133975 }, { -17386751, -16389099 }, { -14500000, -14722432 } },
    { { -11613249, -13055765 }, { -8096159, -12453739 }, { -5679492, -10000000 } },
    { { -3262825, -7546261 }, { 0, -3333333 }, { 0, 0 } }
};

static void load_outline(double feed)
{
    begin_chain();
    for (unsigned c = 0; c < 12; c++) {
        chain[c].feed = real_of(feed);
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const int32_t *p = k == 0 ? outline[(c + 11) % 12][2] : outline[c][k - 1];
                chain[c].curve.p[k].axis[i] = real_of(i < 2 ? p[i] / 1e6 : 0);
            }
    }
    curves = 12;
}

/* The times are those of the f64 build, every build is within 1 %. The least times come from
 * numerical integration (the largest speed that keeps u a + k v^2 within the limits, on 24,000
 * points): a plan needs at most 2.1 % and two beats more; where the radii allow the feed, 0.2 %. */
static void the_outline_takes_the_time_it_should(arb *a)
{
    static const double plans[][4] = {      /* feed mm/s, accel mm/s^2, seconds, the least that
                                             * these limits allow */
        { 16.66667,   500, 7.886, 7.8824 },
        { 50,         500, 2.722, 2.7142 },
        { 100,       2000, 1.361, 1.3571 },
        { 100,        500, 1.776, 1.7393 },
        { 200,      10000, 0.684, 0.6738 }
    };
    (void)a;
    for (unsigned k = 0; k < sizeof plans / sizeof plans[0]; k++) {
        usual_limits();
        for (int i = 0; i < LOFT_AXES; i++)
            limits.max_accel[i] = real_of(plans[k][1]);
        load_outline(plans[k][0]);
        if (!plan_all())
            return;
        CHECK_NEAR(seconds(), plans[k][2], 0.01 * plans[k][2]);
        CHECK(seconds() >= plans[k][3] && seconds() <= plans[k][3] * 1.021 + 0.004);
        CHECK_NEAR(fmax(1, accel_excess()), 1, 0.0005);
    }
}

/* Curvature jumps by 0.08 per mm at six joints of the outline. Least times by linear programs
 * (topp_jerk.py), which know nothing of those jumps: 2.767 s. */
static void the_outline_takes_little_more_where_jerk_is_limited(arb *a)
{
    (void)a;
    usual_limits();
    for (int i = 0; i < LOFT_AXES; i++)
        limits.max_jerk[i] = 10000;
    load_outline(50);
    if (!plan_all())
        return;
    CHECK(seconds() <= 2.767 * 1.08);
    check_limits(arb_value(chain[0].feed));
}


/* Refusals
 * -------- */

static enum loft_status status_of(const loft_limits *l, uint16_t moves, uint16_t most_pieces)
{
    static loft_plan plan;
    enum loft_status status = loft_plan_init(&plan, l, ring, moves, pieces, most_pieces);
    for (unsigned k = 0; k < curves && status == LOFT_OK; k++)
        status = loft_plan_push(&plan, &chain[k]);
    return status;
}

static void impossible_limits_are_refused(arb *a)
{
    (void)a;
    usual_limits();
    load_outline(50);
    CHECK(status_of(&limits, 12, PIECES) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_limits l = limits;
        l.max_speed[i] = 0;
        CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
        l.max_speed[i] = real_of(0.015);
        CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
        l = limits;
        l.max_accel[i] = -limits.max_accel[i];
        CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
        l.max_accel[i] = real_of(16384);
        CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
        l = limits;
        l.max_jerk[i] = LOFT_JERK_MAX + 1;
        CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
    }
    loft_limits l = limits;
    l.tol = 0;
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
    l.tol = real_of(0.0009);
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
    l = limits;
    l.corner = -limits.corner;
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
    l.corner = real_of(1.5);
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
    l = limits;
    l.max_across = -limits.max_accel[0];
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
    l.max_across = real_of(16384);
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
    l = limits;
    l.tick_hz = 0;
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_ARG);
    l.tick_hz = 49;
    CHECK(status_of(&l, 12, PIECES) == LOFT_ERR_RANGE);
}

static void impossible_chains_are_refused(arb *a)
{
    const unsigned k = arb_below(a, 12), i = arb_below(a, LOFT_AXES), j = arb_below(a, 4);

    usual_limits();
    load_outline(50);
    CHECK(status_of(&limits, 0, PIECES) == LOFT_ERR_SPACE &&
          status_of(&limits, 12, 2) == LOFT_ERR_SPACE);
    CHECK(status_of(&limits, 11, PIECES) == LOFT_ERR_SPACE);
    chain[k].feed = 0;
    CHECK(status_of(&limits, 12, PIECES) == LOFT_ERR_ARG);
    chain[k].feed = real_of(16384);
    CHECK(status_of(&limits, 12, PIECES) == LOFT_ERR_RANGE);
    load_outline(50);
    chain[k].curve.p[j].axis[i] = real_of(arb_below(a, 2) ? 8192 : -8192);
    CHECK(status_of(&limits, 12, PIECES) == LOFT_ERR_RANGE || (j == 0 && k > 0));
    load_outline(50);
    chain[1 + arb_below(a, 11)].curve.p[0].axis[i] += real_of(0.001);
    CHECK(status_of(&limits, 12, PIECES) == LOFT_ERR_ARG);
}

static void a_point_needs_no_spans(arb *a)
{
    static loft_plan plan;
    loft_span span;

    arb_limits(a);
    begin_chain();
    for (unsigned k = 0; k < 1 + arb_below(a, 3); k++)
        arb_curve(a, POINT, 1, 10, false);
    CHECK(loft_plan_init(&plan, &limits, ring, CURVES, pieces, PIECES) == LOFT_OK);
    CHECK(loft_plan_next(&plan, &span) == LOFT_PLAN_WAIT);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_plan_push(&plan, &chain[k]) == LOFT_OK);
    loft_plan_end(&plan);
    CHECK(loft_plan_next(&plan, &span) == LOFT_PLAN_REST &&
          loft_plan_next(&plan, &span) == LOFT_PLAN_REST);
}

int main(void)
{
    PROPERTY(spans_of_any_chain_connect_from_rest_to_rest,         10);
    PROPERTY(acceleration_is_never_exceeded,                       40);
    PROPERTY(speed_is_never_exceeded,                              20);
    PROPERTY_LONG(the_path_is_kept_within_the_tolerance,                15);
    PROPERTY_LONG(smooth_chains_hold_all_limits_whatever_the_corner,    12);
    PROPERTY_LONG(any_chain_keeps_all_limits_where_jerk_is_limited,     BY_NUM(15, 4, 8));
    PROPERTY_LONG(smooth_chains_keep_all_limits_where_jerk_is_limited,  BY_NUM(10, 3, 5));
    PROPERTY_LONG(however_curves_arrive_all_limits_are_kept,            15);
    PROPERTY(a_ring_that_sees_far_enough_costs_no_time,            BY_NUM(8, 2, 4));
    PROPERTY(a_line_takes_the_time_of_a_trapezoid,              40);
    PROPERTY(cutting_a_curve_in_two_costs_no_time,                 5);
    PROPERTY(the_way_back_takes_the_same_time,                     5);
    PROPERTY(the_outline_takes_the_time_it_should,                1);
    PROPERTY_LONG(the_outline_takes_little_more_where_jerk_is_limited, 1);
    PROPERTY(impossible_limits_are_refused,                       1);
    PROPERTY(impossible_chains_are_refused,                      50);
    PROPERTY(a_point_needs_no_spans,                             10);
    return check_failures();
}
