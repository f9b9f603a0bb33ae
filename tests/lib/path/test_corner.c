/* tests/lib/path/test_corner.c -- properties of lib/path/corner.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_paths.h"   /* arb_limits, even_limits */

#include "path/corner.h"          /* loft_corner_of, loft_corners_scan */
#include "path/slow.h"            /* loft_slow_look */

#define ONE ((double)LOFT_CORNER_ONE)

static loft_period  period;
static loft_chain   planned;
static loft_corners corners;
static loft_move    ring[CURVES];


// Launches
// --------

static double launched(double jerk, double time) { return jerk * pow(time / ONE, 3) / 6; }

static double launch_time(double jerk, double way) { return ONE * cbrt(6 * way / jerk); }

static loft_corner arb_corner(arb *a, int64_t s)
{
    return loft_corner_of(s, (loft_coord)arb_decades(a, 1e3, 1e7),
                          (loft_coord)arb_decades(a, 1e2, 1e6), arb_below(a, 4) == 0);
}

/* A corner is passed with v = j t^2 / 2, which a launch has reached after X(t). */
static void a_corner_is_like_a_rest_behind_it(arb *a)
{
    const double speed = floor(arb_decades(a, 1e3, 1e7)), jerk = floor(arb_decades(a, 1e2, 1e6)),
                 time = ONE * sqrt(2 * speed / jerk), way = launched(jerk, time);
    const loft_corner c = loft_corner_of(12345, (loft_coord)speed, (loft_coord)jerk, true);

    CHECK(c.s == 12345 && c.on < 0 && c.jerk == jerk);
    if (way > 0x1p29)
        return;
    CHECK_NEAR(c.time, time, 1);
    CHECK_NEAR(c.way, way, 1 + way * 3 / time + way / 500);
}

/* A period after a place at the time n of the launch it is at n + 1, also where it lands. */
static void a_corner_allows_a_launch(arb *a)
{
    const int64_t at = (int64_t)1 << 36, off = (int64_t)arb_decades(a, 1, 1e8),
                  s = arb_below(a, 2) ? at - off : at + off;
    const loft_corner c = arb_corner(a, at);
    const int32_t part = (int32_t)arb_between(a, ONE / 2, ONE * 7 / 4);
    const double n = launch_time(c.jerk, (double)(off + c.way));
    double want;

    CHECK_NEAR(loft_corner_time(&c, s), n - c.time, 2 + n / 1000);
    if (s >= at)
        want = launched(c.jerk, n + part) - c.way;
    else if (n - part >= c.time)
        want = c.way - launched(c.jerk, n - part);
    else
        want = launched(c.jerk, 2 * c.time - n + part) - c.way;
    const double step = fabs(want - (double)(s - at));
    CHECK_NEAR((double)(loft_corner_allows(&c, s, part) - at), want,
               8 + step / 64 + 3 * launched(c.jerk, n) / n);
}

/* Corners that are forgotten allow no less than those that are kept, where these lie. */
static void what_is_forgotten_did_not_matter(arb *a)
{
    enum { MANY = 12 };
    loft_corner all[MANY];
    int64_t s = 0;

    corners.count = 0;
    for (unsigned k = 0; k < MANY; k++) {
        s += (int64_t)arb_decades(a, 1e3, 1e7);
        all[k] = arb_corner(a, s);
        loft_corners_add(&corners, all[k]);
    }
    CHECK(corners.count > 0 && corners.count <= MANY);
    for (unsigned k = 0, n = 0; k < MANY; k++) {
        if (n < corners.count && corners.corner[n].s == all[k].s) {
            n++;
            continue;
        }
        bool less = false;      /* is it reached, or left, with less than its own speed? */
        for (unsigned i = 0; i < MANY; i++) {
            const loft_corner *c = &all[i];
            less = less || (i != k && c->jerk <= all[k].jerk &&
                            c->way + loft_long_abs(c->s - all[k].s) <= all[k].way);
        }
        CHECK(less && all[k].on >= 0);
    }
    for (unsigned n = 1; n < corners.count; n++)
        CHECK(corners.corner[n].s > corners.corner[n - 1].s);
    for (unsigned n = 1; n < corners.count; n++) {
        const loft_corner *c = &corners.corner[n - 1], *d = &corners.corner[n];
        const int64_t off = d->s - c->s;
        CHECK(d->on < 0 || d->jerk < c->jerk || c->way + off > d->way);
        CHECK(c->on < 0 || c->jerk < d->jerk || d->way + off > c->way);
    }
}

/* Of corners before s only the one stays that allows the least, if that is less than the cap. */
static void the_tightest_corner_behind_stays(arb *a)
{
    int64_t at = 0, least;
    unsigned kept = 0;
    const loft_coord cap = (loft_coord)arb_decades(a, 1e3, 1e7);
    static loft_corners before;

    corners.count = 0;
    for (unsigned k = 0; k < 6; k++) {
        at += (int64_t)arb_decades(a, 1e3, 1e7);
        corners.corner[corners.count++] = arb_corner(a, at);
    }
    before = corners;
    const unsigned n = arb_below(a, 7);
    const int64_t s = n < 6 ? before.corner[n].s - arb_below(a, 2) * 100 : at + 1000;
    least = s + cap;
    for (unsigned k = 0; k < 6; k++)
        if (before.corner[k].s < s) {
            const int64_t to = loft_corner_allows(&before.corner[k], s, LOFT_CORNER_ONE);
            least = to < least ? to : least;
        }
    loft_corners_drop(&corners, s, cap);
    for (unsigned k = 0; k < 6; k++) {
        const loft_corner *c = &before.corner[k];
        const bool stays = kept < corners.count && corners.corner[kept].s == c->s,
                   tight = c->s < s && least < s + cap &&
                           loft_corner_allows(c, s, LOFT_CORNER_ONE) == least;
        CHECK(stays == (c->s >= s || tight));
        kept += stays;
    }
    CHECK(kept == corners.count);
    const loft_corner *sharp = loft_corners_next_sharp(&corners, s), *first = NULL;
    for (unsigned k = 0; k < corners.count && first == NULL; k++)
        if (corners.corner[k].s > s && corners.corner[k].on < 0)
            first = &corners.corner[k];
    CHECK(sharp == first);
}

/* The most speed and the jerk of a launch to it: what the axes allow along a direction. */
static void a_cap_is_what_the_axes_allow(arb *a)
{
    double d[LOFT_AXES], speed = 1e30, accel = 1e30, jerk = 1e30;
    int16_t u[LOFT_AXES];

    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    loft_period_init(&period, &limits);
    arb_direction(a, d);
    for (int i = 0; i < LOFT_AXES; i++) {
        u[i] = (int16_t)floor(d[i] * LOFT_CHAIN_UNIT + 0.5);
        const double part = fmax(1e-9, fabs((double)u[i]) / LOFT_CHAIN_UNIT);
        speed = fmin(speed, period.speed[i] / part);
        accel = fmin(accel, period.accel[i] / part);
        jerk  = fmin(jerk, period.jerk[i] > 0 ? period.jerk[i] / part : 1e30);
    }
    const loft_coord feed = (loft_coord)arb_decades(a, 1e3, 0x1p26),
                     cap = loft_corner_cap(&period, u, feed);
    CHECK_NEAR(cap, fmin(speed, fmin(feed, 4 * LOFT_COORD_MM)), 3 + cap / 1000.0);
    const double ramp = floor(cap / accel),
                 times = LOFT_PLAN_EFFORT < 2 || ramp <= 51 ? 2
                         : ramp < 64                       ? 2 - 1.5 * (ramp - 51) / 13
                                                            : 0.5,
                 want = fmin(jerk, fmin(times * accel * accel / cap, 4 * LOFT_COORD_MM)),
                 slack = ramp > 50 && ramp < 65 ? want / 4 : 0;
    CHECK_NEAR(loft_corner_jerk(&period, u, cap), want, 3 + want / 500 + slack);
}


// What is found on a path
// -----------------------

static void look_at_chain(void)
{
    loft_period_init(&period, &limits);
    loft_chain_init(&planned, &period, ring, CURVES);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_chain_push(&planned, &chain[k]) == LOFT_OK);
    planned.ended = true;
#if LOFT_FOLDS
    loft_slow_look(&planned);
#endif
    loft_corners_begin(&corners, &planned);
    loft_corners_scan(&corners, INT64_MAX / 4);
}

static void add_line(double length, double angle, double feed)
{
    const double d[LOFT_AXES] = { cos(angle), sin(angle) }, e[LOFT_AXES] = { 0 },
                 u[4] = { 0, length / 3, length * 2 / 3, length }, w[4] = { 0 };

    add_curve(d, e, u, w, feed);
}

static double speed_of(const loft_corner *c) { return c->jerk * pow(c->time / ONE, 2) / 2; }

/* Two lines: where the tolerance does not swallow their joint it is passed with the velocity whose
 * change, which takes sqrt(4 v w / j), leaves the corner by no more than that. */
static void a_joint_is_passed_as_the_tolerance_allows(arb *a)
{
    const double turn = arb_between(a, 0.02, 3), start = arb_between(a, 0, 7),
                 accel = arb_decades(a, 300, 8000), ratio = arb_decades(a, 5, 100), feed = 150;
    const bool soft = arb_below(a, 2), loose = arb_below(a, 2);

    even_limits(500, accel, soft ? accel * ratio : 0);
    limits.tol = real_of(arb_decades(a, 0.003, 0.02));
    limits.corner = loose ? real_of(arb_value(limits.tol) * arb_between(a, 1.5, 4)) : 0;
    begin_chain();
    add_line(12, start, feed);
    add_line(15, start + turn, feed);
    look_at_chain();
    CHECK(loft_corners_end_known(&corners) && corners.count <= 1);
    const double w = 2 * sin(turn / 2), sharp = 0.0873, s = ldexp(12, 24);
    if (fabs(w - sharp) > 0.002)
        CHECK(corners.zones == (loose && w > sharp));
    if (corners.zones > 0) {
        const int64_t near = 31 * ((int64_t)period.tol + period.more), at = corners.known / 27 * 12;
        const int64_t off = (int64_t)(arb_between(a, 0.5, 1.5) * (double)near);
        CHECK(loft_corners_loose(&corners, at - near / 2, at + off) == (off < near) ||
              loft_long_abs(off - near) < at / 1000);
        CHECK(loft_corners_loose(&corners, at - off, at + near / 2) == (off < near) ||
              loft_long_abs(off - near) < at / 1000);
    }
    const double tol = period.tol + (corners.zones > 0 ? period.more : 0);
    const double most = fmin(sqrt(8 * period.accel[0] * tol),
                             2.9 * cbrt(period.jerk[0] * tol * tol)) /
                        w,
                 cap = loft_period_speed(&period, real_of(feed));
    const bool swallowed = 16 * w < 1.3, slow = !swallowed && 1.5 * most < cap;
    CHECK(corners.count == 1 || !slow);
    if (corners.count == 1) {
        const loft_corner *c = &corners.corner[0];
        CHECK_NEAR((double)c->s, s, s / 1000);
        CHECK(!swallowed);
        CHECK(speed_of(c) >= 0.95 * fmin(most, cap) && speed_of(c) <= 1.45 * most);
        CHECK((c->on < 0) == (w > sharp) || fabs(w - sharp) < 0.002);
    }
}

/* Joints of chords of a circle are a part of its bend, and no place goes onto one. Where that is
 * slow for the axes, min(sqrt(a / k), cbrt(j / k^2)), it is one corner, as of a smooth bend; where
 * only ways have to be short, they are so to its end. Of chords of more than 64 tolerances no bend
 * is seen. */
static void chords_are_passed_as_their_bend(arb *a)
{
    const double accel = arb_decades(a, 300, 8000), r = arb_decades(a, 1, 10),
                 start = arb_between(a, 0, 7), sag = arb_between(a, 0.05, 0.9);

    even_limits(1000, accel, arb_below(a, 2) ? accel * arb_decades(a, 5, 100) : 0);
    limits.tol = real_of(arb_decades(a, 0.003, 0.01));
    const double turn = sqrt(8 * sag * arb_value(limits.tol) / r);
    const bool near = 8 * sag / turn < 64;
    bool slow = false;
    begin_chain();
    for (unsigned k = 0; k < 36 && k * turn < 6; k++)
        add_line(2 * r * sin(turn / 2), start + k * turn, 1000);
    look_at_chain();
    const double units = ldexp(r, 24), cap = loft_period_speed(&period, real_of(1000)),
                 speed = fmin(sqrt(period.accel[0] * units), cbrt(period.jerk[0] * units * units)),
                 way = pow(units * units * units * period.tol / 16 * 128 / 72, 0.25);
    for (unsigned k = 0; k < corners.count; k++) {
        const loft_corner *c = &corners.corner[k];
        CHECK(c->on >= 0);
        CHECK(speed_of(c) >= 0.9 * fmin(fmin(speed, way), cap));
        slow = slow || speed_of(c) <= 1.5 * speed;
    }
    CHECK(slow || speed > 0.45 * cap || curves * turn < 2 || !near);
    CHECK(corners.count <= 3 || !near);
}

/* Where a smooth bend of more than 16 tolerances is tightest it is a corner for the axes, if they
 * are slower there than half of the cap. */
static void the_tip_of_a_bend_is_a_corner(arb *a)
{
    static const double u[4] = { 0, 1, 1, 0 }, w[4] = { 0, 0, 1, 1 };
    const double size = arb_decades(a, 4, 20), accel = arb_decades(a, 300, 30000);
    double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0 }, far[4], wide[4];

    e[1] = 1;
    even_limits(1000, accel, 0);
    limits.tol = real_of(arb_decades(a, 0.0005, 0.002));
    const double long_by = arb_between(a, 2, 4);
    for (int k = 0; k < 4; k++) {
        far[k]  = size * long_by * u[k];
        wide[k] = size * w[k];
    }
    begin_chain();
    add_curve(d, e, far, wide, 1000);
    look_at_chain();
    /* in the middle C' is 3/2 wide, and C'' -6 far */
    const double r = 1.5 * 1.5 / 6 * size / long_by, units = ldexp(r, 24),
                 speed = sqrt(period.accel[0] * units),
                 way = pow(units * units * units * period.tol * 128 / 12, 0.25),
                 cap = loft_period_speed(&period, real_of(1000));
    const loft_corner *tip = NULL;
    for (unsigned k = 0; k < corners.count; k++)
        if (tip == NULL || speed_of(&corners.corner[k]) < speed_of(tip))
            tip = &corners.corner[k];
    if (fmin(2.5 * speed, way) < cap)
        CHECK(tip != NULL);
    if (tip == NULL)
        return;
    CHECK(tip->on >= 0);
    CHECK_NEAR((double)tip->s / (double)corners.known, 0.5, 0.01);
    CHECK_NEAR(speed_of(tip) / fmin(speed, way), 1.015, 0.03);
}

/* Where the feed changes by more than an eighth, or by what the axes allow along the lines, the
 * joint is passed at the smaller one. */
static void a_change_of_speed_is_a_corner(arb *a)
{
    const double feed = arb_between(a, 30, 60), next = feed * arb_between(a, 0.5, 2),
                 angle = arb_between(a, 0, 7);

    even_limits(200, 2000, arb_below(a, 2) ? 100000 : 0);
    begin_chain();
    add_line(3, angle, feed);
    add_line(3, angle, next);
    look_at_chain();
    const double most = fmax(feed, next), least = fmin(feed, next),
                 cap = loft_period_speed(&period, real_of(least));
    if (fabs(least / most - 0.875) > 0.01)
        CHECK(corners.count == (least / most < 0.875));
    for (unsigned k = 0; k < corners.count; k++) {
        CHECK_NEAR(speed_of(&corners.corner[k]), cap, cap / 50);
        CHECK_NEAR((double)corners.corner[k].s, 0x3p24, 0x1p14);
        CHECK(corners.corner[k].on >= 0);
    }
}

/* Of as many as there are each is found, in its order, however far is looked at once. */
static void each_corner_is_found(arb *a)
{
    const double step = arb_decades(a, 0.5, 100);
    double at[CURVES + 1] = { 0 };
    int64_t before = 0;
    unsigned next = 1;

    even_limits(200, 500, arb_below(a, 2) ? 100000 : 0);
    limits.corner = arb_below(a, 2) ? real_of(0.02) : 0;
    begin_chain();
    for (unsigned k = 0; k < CURVES; k++) {
        const double length = arb_decades(a, 1.3, 4);     /* zones do not meet */
        add_line(length, arb_between(a, 0.4, 1.2) + 1.4 * (k % 2), 60);
        at[k + 1] = at[k] + length;
    }
    look_at_chain();
    loft_corners_begin(&corners, &planned);
    for (int64_t s = 0; next < CURVES && s < INT64_C(1) << 40; s += (int64_t)ldexp(step, 24)) {
        loft_corners_scan(&corners, s);
        for (unsigned k = 0; k < corners.count; k++)
            if (corners.corner[k].on < 0 &&
                ldexp((double)corners.corner[k].s, -24) > at[next] - 0.01) {
                CHECK_NEAR(ldexp((double)corners.corner[k].s, -24), at[next], 0.01);
                next++;
            }
        for (unsigned k = 1; k < next && limits.corner > 0; k++) {
            const int64_t joint = (int64_t)ldexp(at[k], 24);
            if (joint >= before || joint + (1 << 24) < before)
                CHECK(loft_corners_loose(&corners, joint - 0xffff, joint + 0xffff) ==
                      (joint >= before));
        }
        before = corners.known - (INT64_C(4) << 24);
        loft_corners_drop(&corners, corners.known, 1 << 20);
        loft_corners_drop_zones(&corners, before, false);
        if (check_bad)
            return;
    }
    CHECK(next == CURVES);
    loft_corners_scan(&corners, INT64_C(1) << 40);
    CHECK(loft_corners_end_known(&corners));
    CHECK_NEAR(ldexp((double)corners.known, -24), at[CURVES], 0.02);
}

int main(void)
{
    PROPERTY(a_corner_is_like_a_rest_behind_it, 2000);
    PROPERTY(a_corner_allows_a_launch, 2000);
    PROPERTY(what_is_forgotten_did_not_matter, 500);
    PROPERTY(the_tightest_corner_behind_stays, 2000);
    PROPERTY(a_cap_is_what_the_axes_allow, 1000);
    PROPERTY(a_joint_is_passed_as_the_tolerance_allows, 300);
    PROPERTY(chords_are_passed_as_their_bend, 200);
    PROPERTY(the_tip_of_a_bend_is_a_corner, 200);
    PROPERTY(a_change_of_speed_is_a_corner, 200);
    PROPERTY(each_corner_is_found, 50);
    return check_failures();
}
