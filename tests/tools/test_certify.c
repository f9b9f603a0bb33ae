/* tests/tools/test_certify.c -- the judgement of a plan: exact limits, distances both ways
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "tools/drawn.h"          /* CHECK, PROPERTY, tool_grow */
#include "plan/certify_along.h"
#include "plan/job.h"

#define SPANS 8
#define TOL   0.005
#define HZ    1000
#define LSB   (1 / 65536.0)

static engine_span span[SPANS];
static engine_move move[SPANS];
static engine_limits limits;
static kinematics axes;
static certify_plan plan;

static double random_signed(arb *a, double size)
{
    return (2 * ((double)(arb_next(a) >> 11) / 9007199254740992.0) - 1) * size;
}

/* A chain of smooth cubics that is the drawing of itself, `count` spans of `ticks`. */
static void arb_plan(arb *a, size_t count, uint16_t ticks)
{
    axes = kinematics_usual();
    kinematics_ready(&axes);
    for (int i = 0; i < ENGINE_AXES; i++) {
        double at = 0, by = 0;
        for (size_t n = 0; n < count; n++)
            for (int k = 0; k < 4; k++) {
                span[n].p[k][i] = (int32_t)lround(at * 65536);
                by += k < 2 ? random_signed(a, 0.05) : 0;
                at += k < 3 ? by : 0;
            }
        limits.max_speed[i] = 100;
        limits.max_accel[i] = 2000;
        limits.max_jerk[i]  = 40000;
    }
    for (size_t n = 0; n < count; n++) {
        span[n].ticks = ticks;
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                move[n].p[k][i] = span[n].p[k][i] * LSB;
    }
    limits.tick_hz = HZ;
    plan = (certify_plan){ .k = &axes,
                           .limits = &limits,
                           .span = span,
                           .spans = count,
                           .move = move,
                           .moves = count,
                           .tol = TOL };
}

static double speed_at(const engine_span *s, int i, double z)
{
    const double y = 1 - z, h = (double)s->ticks / HZ;

    return 3 * LSB / h *
           (y * y * (s->p[1][i] - (double)s->p[0][i]) +
            2 * y * z * (s->p[2][i] - (double)s->p[1][i]) +
            z * z * (s->p[3][i] - (double)s->p[2][i]));
}

/* No sample is above the worst, and a sample comes close to it. */
static void worst_speed_is_reached_and_never_exceeded(arb *a)
{
    certify c;

    arb_plan(a, SPANS, (uint16_t)(1 + arb_below(a, 1023)));
    certify_make(&c, &plan);
    for (int i = 0; i < ENGINE_AXES; i++) {
        double most = 0, then = 0;
        for (int n = 0; n < SPANS; n++)
            for (int k = 0; k <= 256; k++) {
                const double v = fabs(speed_at(&span[n], i, k / 256.0)) / limits.max_speed[i];
                then = v > most ? (n + k / 256.0) * span[n].ticks / HZ : then;
                most = fmax(most, v);
            }
        CHECK(most <= c.speed[i].worst);
        CHECK_NEAR(c.speed[i].worst, most, 1e-4 * most);
        CHECK_NEAR(c.speed[i].seconds, then, span[0].ticks / 64.0 / HZ);
    }
}

/* Acceleration and jerk by differences of the polynomial. */
static void worst_acceleration_and_jerk_are_those_of_the_cubics(arb *a)
{
    certify c;

    arb_plan(a, SPANS, (uint16_t)(1 + arb_below(a, 1023)));
    certify_make(&c, &plan);
    for (int i = 0; i < ENGINE_AXES; i++) {
        double accel = 0, jerk = 0;
        for (int n = 0; n < SPANS; n++) {
            const double h = (double)span[n].ticks / HZ, v0 = speed_at(&span[n], i, 0),
                         v1 = speed_at(&span[n], i, 0.5), v2 = speed_at(&span[n], i, 1);
            accel = fmax(accel, fmax(fabs(4 * v1 - 3 * v0 - v2), fabs(v0 + 3 * v2 - 4 * v1)) / h);
            jerk  = fmax(jerk, fabs(4 * v2 - 8 * v1 + 4 * v0) / (h * h));
        }
        CHECK_NEAR(c.accel[i].worst, accel / 2000, 1e-9 * accel / 2000);
        CHECK_NEAR(c.jerk[i].worst, jerk / 40000, 1e-9 * jerk / 40000);
    }
    limits.max_jerk[1] = 0;
    certify_make(&c, &plan);
    CHECK(c.jerk[1].worst == 0);
}

/* A motion beside the drawing is as far as it was moved, both ways. */
static void a_moved_path_is_as_far_as_it_was_moved(arb *a)
{
    const double by = arb_below(a, 3) ? (double)arb_below(a, 600) * 1e-5 : 0.99998 * TOL;
    certify c;

    arb_plan(a, 1 + arb_below(a, SPANS), 10);
    for (size_t n = 0; n < plan.moves; n++)
        for (int k = 0; k < 4; k++) {
            move[n].p[k][0] = move[n].p[k][1] = 0;
            move[n].p[k][2] = by;
            span[n].p[k][1] = span[n].p[k][2] = 0;
            span[n].p[k][0] = (int32_t)(65536 * (3 * n + (size_t)k));
            move[n].p[k][0] = 3 * (double)n + k;
        }
    certify_make(&c, &plan);
    CHECK(c.off.worst >= by && c.off.worst <= by + TOL / 100);
    CHECK(c.missed.worst >= by && c.missed.worst <= by + TOL / 100);
    CHECK(by > TOL || (c.off.worst <= TOL && c.missed.worst <= TOL));
    CHECK(certify_holds(&c) == (c.off.worst <= TOL && c.speed[0].worst <= CERTIFY_SPEED));
}

/* Curves that the motion follows exactly: only the bound on the distance is left. */
static void the_own_path_is_no_distance_away(arb *a)
{
    certify c;

    arb_plan(a, 1 + arb_below(a, SPANS), 10);
    certify_make(&c, &plan);
    CHECK(c.connected);
    CHECK(c.off.worst <= TOL / 100 && c.missed.worst <= TOL / 100);
}

/* What the motion leaves out, and what it adds, is found on the side that has it. */
static void a_spur_is_found(arb *a)
{
    const double high = 0.001 + 0.0001 * (double)arb_below(a, 200);
    const bool drawn = arb_below(a, 2);
    certify c;

    arb_plan(a, 3, 10);
    for (int n = 0; n < 3; n++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++) {
                const double at = i != 0 ? 0 : n == 1 ? 3 : 3 * n + k - (n == 2 ? 3 : 0);
                span[n].p[k][i] = (int32_t)lround(65536 * at);
                move[n].p[k][i] = at;
            }
    for (int k = 1; k < 3; k++) {
        if (drawn)
            move[1].p[k][1] = high;
        else
            span[1].p[k][1] = (int32_t)lround(65536 * high);
    }
    certify_make(&c, &plan);
    const certify_worst *found = drawn ? &c.missed : &c.off, *other = drawn ? &c.off : &c.missed;
    CHECK(found->worst >= 0.75 * high - LSB && found->worst <= 0.75 * high + LSB + TOL / 50);
    CHECK(other->worst <= TOL / 100);
    if (high > TOL / 10)
        CHECK_NEAR(found->at[0], 3, 2 * TOL);
    if (drawn && high > TOL / 10)
        CHECK(found->move == 1);
}

static void add_line(size_t n, double x0, double y0, double x1, double y1, bool drawn)
{
    for (int k = 0; k < 4; k++) {
        const double at[ENGINE_AXES] = { x0 + k / 3.0 * (x1 - x0), y0 + k / 3.0 * (y1 - y0), 0 };
        for (int i = 0; i < ENGINE_AXES; i++)
            if (drawn)
                move[n].p[k][i] = at[i];
            else
                span[n].p[k][i] = (int32_t)lround(65536 * at[i]);
    }
}

/* A motion that cuts a corner of 90 degrees: within the tolerance of corners, or not. A gentle turn
 * is no corner, and what is off far from one is off. */
static void corners_have_a_tolerance_of_their_own(arb *a)
{
    const double cut = TOL * (1.6 + 0.01 * arb_below(a, 1000)), far = arb_below(a, 3) ? 0 : 2 * TOL,
                 turn = arb_below(a, 3) ? 10 : 0.8;
    certify c;

    arb_plan(a, 3, 1000);
    plan.moves  = 2;
    plan.corner = 6 * TOL;
    add_line(0, -10, 0, 0, 0, true);
    add_line(1, 0, 0, turn < 10 ? 10 : 0, turn, true);
    add_line(0, -10, far, -cut, 0, false);
    add_line(1, -cut, 0, turn < 10 ? 10 : 0, turn < 10 ? turn : cut, false);
    add_line(2, turn < 10 ? 10 : 0, turn < 10 ? turn : cut, turn < 10 ? 10 : 0, turn, false);
    certify_make(&c, &plan);
    if (turn == 10) {
        const double off = cut / sqrt(2);
        CHECK(certify_holds(&c) == (far == 0 && c.missed.worst <= 6 * TOL));
        CHECK(far > 0 || (c.missed.tol == 6 * TOL && c.missed.move <= 1));
        CHECK(far > 0 || (c.missed.worst > off - LSB && c.missed.worst < off + TOL / 10));
    } else
        CHECK(far == 0 || (!certify_holds(&c) && c.missed.tol == TOL));
    plan.corner = 0;
    certify_make(&c, &plan);
    CHECK(turn < 10 || (!certify_holds(&c) && c.missed.tol == TOL));
}

static void a_gap_is_refused(arb *a)
{
    certify c;

    arb_plan(a, SPANS, 10);
    limits.max_speed[0] = limits.max_speed[1] = limits.max_speed[2] = 1e5;
    for (int i = 0; i < ENGINE_AXES; i++)
        limits.max_accel[i] = limits.max_jerk[i] = 1e12;
    certify_make(&c, &plan);
    CHECK(certify_holds(&c));
    span[1 + arb_below(a, SPANS - 1)].p[0][arb_below(a, ENGINE_AXES)]++;
    certify_make(&c, &plan);
    CHECK(!c.connected && !certify_holds(&c));
}

static void give_move(void *context, size_t n, engine_move *out)
{
    (void)context;
    *out = move[n];
}

/* Lines between places that are no multiples of 2^-16 mm, with a stop at each: the last span before
 * a stop is three such steps long, and a fourth would exceed the jerk by a third. */
static void limits_are_held_at_stops_between_steps(arb *a)
{
    const engine_plans *make = engine_f64.plan;
    engine_plan *p;
    engine_span s;
    int step;
    double at[ENGINE_AXES] = { 0 };

    limits = (engine_limits){ .tol = 0.05, .exact = 0.1, .tick_hz = HZ };
    for (int i = 0; i < ENGINE_AXES; i++) {
        limits.max_speed[i] = 100;
        limits.max_accel[i] = 500;
        limits.max_jerk[i]  = 3000 + arb_below(a, 3000);
    }
    for (size_t n = 0; n < SPANS; n++) {
        double to[ENGINE_AXES];
        for (int i = 0; i < ENGINE_AXES; i++)
            to[i] = random_signed(a, 5);
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                move[n].p[k][i] = k < 3 ? at[i] + k / 3.0 * (to[i] - at[i]) : to[i];
        move[n].feed = 100;
        memcpy(at, to, sizeof at);
    }
    CHECK(make->open(&limits, give_move, NULL, SPANS, &p) == 0);
    while ((step = make->step(p, &s)) != ENGINE_PLAN_DONE) {
        const double h = (double)s.ticks / HZ;
        CHECK(step >= 0);
        for (int i = 0; i < ENGINE_AXES && step == ENGINE_PLAN_SPAN; i++) {
            const double d3 = s.p[3][i] - 3.0 * s.p[2][i] + 3.0 * s.p[1][i] - s.p[0][i];
            CHECK(fabs(6 * d3 * LSB) <= 1.001 * limits.max_jerk[i] * h * h * h);
        }
    }
    make->close(p);
}

// While a plan is made
// --------------------

/* Judge `plan` span by span; the path is told to be passed `late` spans after it is. */
static bool judge_along(certify *c, size_t late)
{
    certify_along w;
    bool good = true;

    limits.tol    = plan.tol;
    limits.corner = plan.corner;
    certify_along_begin(&w, &limits, give_move, NULL, plan.moves);
    for (size_t n = 0; n < plan.spans; n++) {
        good = certify_along_span(&w, &span[n], n + 1 > late ? n + 1 - late : 0) && good;
        CHECK(w.sure <= w.spans);
    }
    good = certify_along_end(&w) && good;
    CHECK(w.sure == plan.spans);
    *c = w.judged;
    certify_along_free(&w);
    return good;
}

/* The same judgement as of the whole, with corners and without, whatever lies beside the path. */
static void a_plan_is_judged_while_it_is_made(arb *a)
{
    certify all, along;
    const double by = arb_below(a, 3) ? (double)arb_below(a, 900) * 1e-5 : 0;

    arb_plan(a, 1 + arb_below(a, SPANS), (uint16_t)(1 + arb_below(a, 1023)));
    plan.corner = arb_below(a, 2) ? (1 + (double)arb_below(a, 40)) * TOL / 4 : 0;
    for (size_t n = 0; n < plan.moves; n++)
        for (int k = 0; k < 4; k++)
            move[n].p[k][2] += by;
    certify_make(&all, &plan);
    const bool good = judge_along(&along, arb_below(a, 3));
    for (int i = 0; i < ENGINE_AXES; i++) {
        CHECK_NEAR(along.speed[i].worst, all.speed[i].worst, 0);
        CHECK_NEAR(along.accel[i].worst, all.accel[i].worst, 0);
        CHECK_NEAR(along.jerk[i].worst, all.jerk[i].worst, 0);
    }
    CHECK_NEAR(along.off.worst / along.off.tol, all.off.worst / all.off.tol, 0.02);
    CHECK_NEAR(along.missed.worst / along.missed.tol, all.missed.worst / all.missed.tol, 0.02);
    if (fabs(all.off.worst / all.off.tol - 1) > 0.02 &&
        fabs(all.missed.worst / all.missed.tol - 1) > 0.02)
        CHECK(good == certify_holds(&all));
}

/* Of a path that comes back on itself nothing is missed, and nothing is taken for another part. */
static void a_path_that_comes_back_is_met_each_time(arb *a)
{
    const double high = 3 + (double)arb_below(a, 30), by = arb_below(a, 2) ? TOL / 2 : 3 * TOL;
    const size_t bad = arb_below(a, SPANS);
    certify c;

    arb_plan(a, SPANS, 1000);
    for (size_t n = 0; n < SPANS; n++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++) {
                const double t = n % 2 ? 1 - k / 3.0 : k / 3.0;
                span[n].p[k][i] = i == 0 ? (int32_t)lround(t * high * 65536) : 0;
                move[n].p[k][i] = i == 0 ? t * high : 0;
            }
    move[bad].p[1][1] += by / 0.75;
    move[bad].p[2][1] += by / 0.75;
    const bool good = judge_along(&c, 0);
    CHECK(good == (by < TOL));
    CHECK_NEAR(c.missed.worst, by, 0.01 * TOL);
}

const char tool_version[] = "test";

/* A planner that puts one span beside the path. */
static struct bent {
    size_t at, given;
    int32_t by;
} bent;

static int step_bent(engine_plan *p, engine_span *out)
{
    const int step = engine_f64.plan->step(p, out);

    if (step == ENGINE_PLAN_SPAN && bent.given++ == bent.at)
        out->p[1][1] += bent.by, out->p[2][1] += bent.by;
    return step;
}

/* A span that is not within the bounds is never among those that may be sent. */
static void a_plan_that_is_off_is_not_sent(arb *a)
{
    const toolpath path = { .count = 1 };
    engine_plans plans  = *engine_f64.plan;
    engine e            = engine_f64;
    size_t tool[SPANS];
    job_options o = { .e = &e, .kind = arb_below(a, 2) ? LOFT_SPANS : LOFT_POINTS };
    job j;
    int status;

    arb_plan(a, SPANS, 10);
    plans.step = step_bent;
    e.plan     = &plans;
    bent       = (struct bent){ arb_below(a, 60), 0, (int32_t)(4 * TOL * 65536) };
    for (size_t n = 0; n < SPANS; n++) {
        tool[n]      = n;
        move[n].feed = 20;
    }
    o.limits = limits;
    o.limits.tol = TOL;
    o.limits.corner = 0;
    for (int i = 0; i < ENGINE_AXES; i++)
        o.steps_per_mm[i] = 80 * 65536;
    joints of = { .k     = &axes,
                  .move  = move,
                  .of    = tool,
                  .count = SPANS,
                  .path  = &path,
                  .scale = { 1, 1, 1 },
                  .least = 1 };
    status = job_open(&j, &of, &o);
    while (status == LOFT_OK && !j.whole)
        status = job_plan(&j, 0, 1);
    CHECK(bent.given > bent.at ? status == JOB_OUTSIDE : status == LOFT_OK);
    CHECK(status == LOFT_OK || j.spans <= bent.at);
    if (o.kind == LOFT_SPANS && status != LOFT_OK)
        CHECK(job_ready(&j) <= bent.at);
    job_free(&j);
}

int main(void)
{
    PROPERTY(worst_speed_is_reached_and_never_exceeded, 30);
    PROPERTY(worst_acceleration_and_jerk_are_those_of_the_cubics, 30);
    PROPERTY(a_moved_path_is_as_far_as_it_was_moved, 50);
    PROPERTY(the_own_path_is_no_distance_away, 30);
    PROPERTY(a_spur_is_found, 200);
    PROPERTY(corners_have_a_tolerance_of_their_own, 100);
    PROPERTY(a_gap_is_refused, 20);
    PROPERTY(limits_are_held_at_stops_between_steps, 20);
    PROPERTY(a_plan_is_judged_while_it_is_made, 12);
    PROPERTY(a_path_that_comes_back_is_met_each_time, 10);
    PROPERTY(a_plan_that_is_off_is_not_sent, 8);
    return check_failures();
}
