/* tests/lib/motion/test_raise.c -- properties of lib/motion/cell.h, raise.h, lane.h and flow.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_acc                       */
#include "support/motion_oracle.h"  /* CHECK, PROPERTY, arb, arb_value */
#include "support/motion_paths.h"   /* arb_smooth_chain, arb_jerk      */
#include "motion/flow.h"            /* loft_flow, loft_lane            */

#define PIECES 2000

static loft_move       moves[CURVES];
static loft_plan_piece pieces[PIECES];
static loft_course     course;
static loft_lane       lane;

static void begin(void)
{
    loft_budget b;

    CHECK(loft_limits_check(&limits) == LOFT_OK);
    loft_budget_init(&b, &limits);
    loft_course_init(&course, &b, moves, CURVES, pieces, PIECES);
    loft_lane_init(&lane);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_course_push(&course, &chain[k]) == LOFT_OK);
}

static void arb_path(arb *a)
{
    arb_limits(a);
    arb_jerk(a);
    arb_smooth_chain(a);
    begin();
}

static const loft_plan_cell *cell_of(unsigned i) { return &loft_course_piece(&course, i)->cell; }
static bool rests(unsigned i) { return i >= course.count || loft_course_piece(&course, i)->stop; }

/* The largest part of the limits of acceleration and jerk that the cell uses at one end, computed
 * anew from its control values. */
static double use_of(unsigned i, int end)
{
    const loft_plan_cell *c = cell_of(i);
    const double h = (double)exact_acc(loft_unit_to_acc(c->length));
    const bool first = rests(i), last = rests(i + 1);
    double x[2], a[2], most = 0;

    for (int k = 0; k < 2; k++) {
        if (rests(i + (unsigned)k)) {
            x[k] = a[k] = 0;
            continue;
        }
        const loft_plan_cell *p = cell_of(i + (unsigned)k - 1), *q = cell_of(i + (unsigned)k);
        const double l = (double)exact_acc(loft_unit_to_acc(p->length)),
                     m = (double)exact_acc(loft_unit_to_acc(q->length));
        x[k] = (double)(m * exact_acc(p->b) + l * exact_acc(q->b)) / (l + m);
        a[k] = (double)(exact_acc(q->b) - exact_acc(p->b)) / (l + m);
    }
    const double change = first ? a[1] / 3 : last ? -a[0] / 3 : a[1] - a[0], v = sqrt(x[end]);
    for (int n = 0; n < LOFT_AXES; n++) {
        const double u = arb_value(c->along[end].axis[n]), k = arb_value(c->bend[end].axis[n]),
                     turn = arb_value(c->turn[end].axis[n]);
        const double beats = h / (v * course.budget.beat / course.budget.tick_hz);
        most = fmax(most, fabs(u * a[end] + k * x[end]) / arb_value(course.budget.accel[n]));
        most = fmax(most, fabs(u * change + 3 * k * h * a[end] + turn * x[end]) /
                              (arb_value(course.budget.gain[n]) * beats));
    }
    return most;
}

static double use_of_all(void)
{
    double most = 0;

    for (unsigned i = 0; i < course.count; i++)
        for (int end = 0; end < 2 && !loft_course_piece(&course, i)->hop; end++)
            if (!rests(i + (unsigned)end) && cell_of(i)->length > LOFT_UNIT(0.01))
                most = fmax(most, use_of(i, end));
    return most;
}

/* After any number of sweeps, with the path closed, or open and appended to. */
static void all_cells_hold_the_limits_at_their_ends(arb *a)
{
    arb_path(a);
    loft_lane_load(&lane, &course);
    if (arb_below(a, 2))
        loft_lane_raise(&lane, &course, 0);
    loft_lane_close(&lane, &course);
    loft_lane_raise(&lane, &course, 0);
    CHECK(course.count > 2 && lane.sure == course.count);
    CHECK_NEAR(fmax(1, use_of_all()), 1, BY_NUM(0.01, 0.001, 1e-6));
    for (unsigned i = 0; i < course.count; i++)
        CHECK(loft_course_piece(&course, i)->hop ||
              cell_of(i)->b <= cell_of(i)->most + cell_of(i)->most / 1000000);
}

/* The largest part of the jerk that cell i, beside a rest, uses at eight places, with its curvature
 * a parabola: x is x1 z^(4/3) there. */
static double use_beside_rest(unsigned i)
{
    const loft_plan_cell *c = cell_of(i), *at = rests(i) ? cell_of(i + 1) : c;
    const double h = (double)exact_acc(loft_unit_to_acc(c->length)), sign = rests(i) ? 1 : -1,
                 a1 = (double)exact_acc(at->a), x1 = (double)exact_acc(at->x);
    double most = 0;

    for (int part = 1; part <= 8; part++) {
        const double z = part / 8.0, w = rests(i) ? z : 1 - z, third = cbrt(z), x = x1 * z * third,
                     a = a1 * third;
        const double beats = h / (sqrt(x) * course.budget.beat / course.budget.tick_hz),
                     change = sign * a1 / (3 * third * third);
        for (int n = 0; n < LOFT_AXES; n++) {
            const double k0 = arb_value(c->bend[0].axis[n]), k1 = arb_value(c->bend[1].axis[n]),
                         t0 = arb_value(c->turn[0].axis[n]), t1 = arb_value(c->turn[1].axis[n]);
            const double u = arb_value(c->along[0].axis[n]) * (1 - w) +
                             arb_value(c->along[1].axis[n]) * w - (k1 - k0) * h * w * (1 - w) / 2;
            const double k = k0 + (k1 - k0) * w + (t0 - t1) * w * (1 - w) / 2,
                         turn = t0 + (t1 - t0) * w;
            most = fmax(most, fabs(u * change + 3 * k * h * a + turn * x) /
                                  (arb_value(course.budget.gain[n]) * beats));
        }
    }
    return most;
}

/* One curve whose curvature changes much in its last cell, or its first. */
static void beside_a_rest_the_jerk_is_within_its_limit_everywhere(arb *a)
{
    arb_limits(a);
    arb_jerk(a);
    begin_chain();
    arb_curve(a, WILD, arb_decades(a, 0.2, 20), arb_decades(a, 20, 500), false);
    begin();
    loft_lane_load(&lane, &course);
    loft_lane_close(&lane, &course);
    loft_lane_raise(&lane, &course, 0);
    for (unsigned i = 0; i < course.count; i++)
        if ((rests(i) != rests(i + 1)) && !loft_course_piece(&course, i)->hop &&
            cell_of(i)->length > LOFT_UNIT(0.01))
            CHECK(use_beside_rest(i) <= 23 / 24.0 + 1 / 128.0);         /* cell.c leaves a 24th */
}

/* Nothing falls, nothing that has begun to move changes. */
static void raising_only_raises(arb *a)
{
    static loft_acc before[PIECES];

    arb_path(a);
    loft_lane_load(&lane, &course);
    loft_lane_close(&lane, &course);
    for (unsigned i = 0; i < course.count; i++)
        before[i] = cell_of(i)->b;
    const unsigned begun = 1 + arb_below(a, course.count);
    loft_lane_raise(&lane, &course, begun);
    for (unsigned i = 0; i < course.count; i++)
        CHECK(cell_of(i)->b >= before[i] && (i >= begun || !(cell_of(i)->b > before[i])));
}

/* Rounding may leave a limit exceeded that is all used: what does not add to that is not
 * hindered. */
static void a_limit_hinders_nothing_that_does_not_touch_it(arb *a)
{
    const loft_cell_rise none = { 0, 0 };

    arb_path(a);
    loft_lane_load(&lane, &course);
    loft_lane_close(&lane, &course);
    loft_lane_raise(&lane, &course, 0);
    for (unsigned i = 1; i + 1 < course.count; i++) {
        if (rests(i) || rests(i + 1) || loft_course_piece(&course, i)->hop)
            continue;
        loft_course_piece(&course, i)->cell.rise = 0;
        CHECK(loft_cell_limit(cell_of(i), cell_of(i + 1), &course.budget, none, none, LOFT_UNIT(1),
                              false, false) == LOFT_UNIT(1));
    }
}

/* L / v + v / a + a / j */
static void a_long_line_takes_the_time_that_is_known(arb *a)
{
    const double d[LOFT_AXES] = { 1 }, v = arb_between(a, 20, 60), w[4] = { 0 },
                 length = arb_between(a, 40, 100);
    const double u[4] = { 0, length / 3, length * 2 / 3, length };
    loft_flow flow;
    unsigned beats = 0;

    even_limits(1000, 500, 10000);
    begin_chain();
    add_curve(d, d, u, w, v);
    begin();
    course.ended = true;
    loft_flow_init(&flow);
    while (beats < 100000 && loft_flow_next(&flow, &course) == LOFT_FLOW_RUNS)
        beats++;
    const double least = length / v + v / 500 + 500 / 10000.0,
                 took = beats * (double)course.budget.beat / limits.tick_hz;
    CHECK(took > least * 0.999 && took < least * 1.04 + 0.01);
}

/* 4 (L / 2 j)^(1/3), what cells leave of it, and the rest of the last beat */
static void a_short_line_takes_the_time_that_is_known(arb *a)
{
    const double angle = arb_between(a, 0, 6.28), d[LOFT_AXES] = { cos(angle), sin(angle) },
                 e[LOFT_AXES] = { 0, 1 }, w[4] = { 0 };
    const double length = arb_decades(a, 0.05, 2), u[4] = { 0, length / 3, length * 2 / 3, length };
    const double jerk = 10000 / fmax(fabs(d[0]), fabs(d[1])), least = 4 * cbrt(length / (2 * jerk));
    loft_flow flow;
    unsigned beats = 0;

    even_limits(1000, 500, 10000);
    begin_chain();
    add_curve(d, e, u, w, arb_between(a, 40, 60));
    begin();
    course.ended = true;
    loft_flow_init(&flow);
    while (beats < 100000 && loft_flow_next(&flow, &course) == LOFT_FLOW_RUNS)
        beats++;
    const double beat = (double)course.budget.beat / limits.tick_hz;
    CHECK(beats * beat > least * 0.999 && beats * beat < least * 1.08 + beat);
}

/* A line, a tight bend of a quarter of a circle, a line. */
static void cells_shrink_and_grow_by_steps_around_a_bend(arb *a)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 }, w[4] = { 0 },
                 r = arb_decades(a, 0.05, 2), length = arb_between(a, 10, 100);
    const double u[4] = { 0, length / 3, length * 2 / 3, length },
                 out[4] = { 0, 0.5522847 * r, r, r }, up[4] = { 0, 0, 0.4477153 * r, r };

    even_limits(1000, 500, 10000);
    begin_chain();
    add_curve(d, e, u, w, 100);
    add_curve(d, e, out, up, 100);
    add_curve(e, d, u, w, 100);
    begin();
    loft_lane_load(&lane, &course);
    loft_lane_close(&lane, &course);
    for (unsigned i = 0; i + 1 < course.count; i++) {
        const loft_acc h = loft_unit_to_acc(cell_of(i)->length),
                       next = loft_unit_to_acc(cell_of(i + 1)->length);
        CHECK(rests(i + 1) || (h < 4 * next && next < 4 * h));
    }
}

static loft_vec on_circle(double r, double angle, double handle)
{
    return (loft_vec){ { real_of(r * cos(angle) - handle * sin(angle)),
                         real_of(r * sin(angle) + handle * cos(angle)) } };
}

/* A circle, as many more arcs than the ring of curves holds: no slower than one curve would be. */
static void short_curves_are_passed_as_fast_as_long_ones(arb *a)
{
    enum { RING = 64, ARCS = 400 };
    static loft_move ring[RING];
    const double r = arb_between(a, 20, 40), turn = arb_between(a, 0.2, 0.6) / r,
                 v = arb_between(a, 20, 40), handle = 4.0 / 3 * tan(turn / 4) * r;
    loft_move arc = { .curve = { .p = { on_circle(r, 0, 0) } }, .feed = real_of(v) };
    unsigned given = 0, beats = 0;
    loft_budget b;
    loft_flow flow;
    enum loft_flow_state state = LOFT_FLOW_WAITS;

    even_limits(1000, 1000, 20000);
    loft_budget_init(&b, &limits);
    loft_course_init(&course, &b, ring, RING, pieces, 8 * RING);
    loft_flow_init(&flow);
    while (beats < 100000 && state != LOFT_FLOW_RESTS) {
        for (; given < ARCS && course.move_count < RING; given++) {
            arc.curve.p[0] = given ? arc.curve.p[3] : arc.curve.p[0];
            arc.curve.p[1] = on_circle(r, given * turn, handle);
            arc.curve.p[2] = on_circle(r, (given + 1) * turn, -handle);
            arc.curve.p[3] = on_circle(r, (given + 1) * turn, 0);
            CHECK(loft_course_push(&course, &arc) == LOFT_OK);
        }
        course.ended = given == ARCS;
        state = loft_flow_next(&flow, &course);
        beats += state == LOFT_FLOW_RUNS;
    }
    const double least = ARCS * turn * r / v + v / 1000 + 1000 / 20000.0,
                 took = beats * (double)course.budget.beat / limits.tick_hz;
    CHECK(took > least * 0.99 && took < least * 1.03 + 0.02);
}

/* Its pieces come one after the other, places do not go back, and all of the way is gone. */
static void places_follow_each_other(arb *a)
{
    loft_flow flow;
    double gone = 0, length = 0;
    unsigned beats = 0;

    arb_path(a);
    course.ended = true;
    loft_lane_load(&lane, &course);
    for (unsigned i = 0; i < course.count; i++)
        length += (double)exact_acc(loft_unit_to_acc(cell_of(i)->length));
    if (course.cut < course.move_count)
        return;
    begin();
    course.ended = true;
    loft_flow_init(&flow);
    for (; beats < 1000000 && loft_flow_next(&flow, &course) == LOFT_FLOW_RUNS; beats++) {
        CHECK(flow.way >= 0 && flow.off >= 0 &&
              flow.off <= loft_unit_to_acc(cell_of(flow.at)->length));
        gone += (double)exact_acc(flow.way);
    }
    CHECK_NEAR(gone, length, 1e-6 * length + beats * 1e-9);
    CHECK(course.count == 0 && course.move_count == 0);
}

/* Where easing says that the curvature is, that of the points moved aside is. */
static void eased_cells_bend_as_the_points_do(arb *a)
{
    const double w = arb_value(real_of(arb_between(a, 0.2, 2))),
                 off = arb_value(real_of(arb_between(a, -1.4, 1.1) * w));
    const double h = arb_value(real_of(arb_between(a, 0.1, 0.3) * w)),
                 e = arb_value(real_of(w / BY_NUM(64, 64, 256)));
    loft_ease ease = { loft_unit_round(loft_to_acc(real_of(w))), { 0 } };
    const double jump[3] = { arb_between(a, -0.5, 0.5), arb_between(a, -0.5, 0.5),
                             arb_between(a, -0.5, 0.5) };
    loft_plan_cell c = { .length = loft_unit_round(loft_to_acc(real_of(h))),
                         .most = loft_to_acc(real_of(10)) };
    loft_budget b = { .beat = 1, .tick_hz = 1000 };

    for (int i = 0; i < LOFT_AXES; i++) {
        ease.jump[i] = real_of(jump[i]);
        b.max_speed[i] = real_of(100);
    }
    loft_cell_ease(&c, &b, &ease, loft_to_acc(real_of(off)));
    for (int end = 0; end < 2; end++) {
        const double s = off + end * h;
        double p[3][LOFT_AXES];
        if (fabs(s) < 2 * e || fabs(fabs(s) - 0.7937 * w) < 2 * e || fabs(fabs(s) - w) < 2 * e ||
            (off < 0 && off + h > 0))
            continue;
        for (int k = 0; k < 3; k++) {
            loft_acc point[LOFT_AXES] = { 0 };
            loft_ease_point(&ease, loft_to_acc(real_of(s + (k - 1) * e)), point);
            for (int i = 0; i < LOFT_AXES; i++)
                p[k][i] = (double)exact_acc(point[i]);
        }
        for (int i = 0; i < LOFT_AXES; i++) {
            CHECK_NEAR(arb_value(c.bend[end].axis[i]), (p[0][i] - 2 * p[1][i] + p[2][i]) / (e * e),
                       BY_NUM(0.02, 0.02, 0.002));
            CHECK_NEAR(arb_value(c.along[end].axis[i]), (p[2][i] - p[0][i]) / (2 * e),
                       BY_NUM(0.001, 0.001, 0.0005));
        }
    }
}

static void an_inverse_multiplies_by_it(arb *a)
{
    const loft_acc length = loft_to_acc(real_of(arb_decades(a, 0.0003, 1000))),
                   x = loft_to_acc(real_of(arb_decades(a, 0.01, 10)));
    const loft_inverse by = loft_inverse_of(length);
    const double exact = (double)exact_acc(x) / (double)exact_acc(length);

    CHECK_NEAR((double)exact_acc(loft_inverse_mul(x, &by)), exact,
               exact * BY_NUM(0.0005, 1e-6, 1e-12) + 1e-9);
}

int main(void)
{
    PROPERTY(all_cells_hold_the_limits_at_their_ends, 30);
    PROPERTY(a_limit_hinders_nothing_that_does_not_touch_it, 20);
    PROPERTY(beside_a_rest_the_jerk_is_within_its_limit_everywhere, BY_NUM(100, 100, 850));
    PROPERTY(raising_only_raises,                     20);
    PROPERTY(a_long_line_takes_the_time_that_is_known, 10);
    PROPERTY(a_short_line_takes_the_time_that_is_known, 30);
    PROPERTY(cells_shrink_and_grow_by_steps_around_a_bend, 50);
    PROPERTY(short_curves_are_passed_as_fast_as_long_ones, 3);
    PROPERTY(places_follow_each_other,                20);
    PROPERTY(eased_cells_bend_as_the_points_do,      300);
    PROPERTY(an_inverse_multiplies_by_it,            300);
    return check_failures();
}
