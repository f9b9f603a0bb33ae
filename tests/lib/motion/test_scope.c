/* tests/lib/motion/test_scope.c -- properties of lib/motion/scope.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "motion/scope.h"
#include "support/motion_chains.h"  /* arb_direction, real_of, arb_value */

typedef struct {
    loft_limits     limits;
    loft_budget     budget;
    loft_arc        arc;
    loft_arc_shape  shape;
    loft_plan_piece piece;
    double          length, turn[2];            /* curvature times length at both ends */
    bool            steady;                     /* it bends to where it bends at the start */
    /* of length 1: where it starts to, and where it bends to */
    double          ahead[LOFT_AXES], aside[LOFT_AXES];
} scene;

static loft_acc wide_of(double x) { return BY_NUM((loft_acc)floor(x * 4294967296.0 + 0.5), x, x); }
static double value_of(loft_acc x)
{
    return BY_NUM((double)x / 4294967296.0, (double)x, (double)x);
}

static void arb_budget(arb *a, scene *s)
{
    arb_limits(a);
    s->limits = limits;
    loft_budget_init(&s->budget, &s->limits);
}

/* Direction and curvature at the part z of a piece whose curvature is a line. */
static void lie(const scene *s, double z, double along[], double bend[])
{
    const double turned = s->turn[0] * z + (s->turn[1] - s->turn[0]) * z * z / 2,
                 k = (s->turn[0] + (s->turn[1] - s->turn[0]) * z) / s->length;

    for (int i = 0; i < LOFT_AXES; i++) {
        along[i] = s->steady ? s->ahead[i] + turned * s->aside[i]
                             : cos(turned) * s->ahead[i] + sin(turned) * s->aside[i];
        bend[i] = s->steady ? k * s->aside[i]
                            : k * (cos(turned) * s->aside[i] - sin(turned) * s->ahead[i]);
    }
}

static bool piece_of(arb *a, scene *s, double turn0, double turn1, bool steady)
{
    double dot = 0, size = 0;

    arb_budget(a, s);
    s->length  = arb_decades(a, 0.01, 50);
    s->turn[0] = turn0;
    s->turn[1] = turn1;
    s->steady  = steady;
    arb_direction(a, s->ahead);
    arb_direction(a, s->aside);
    for (int i = 0; i < LOFT_AXES; i++)
        dot += s->ahead[i] * s->aside[i];
    for (int i = 0; i < LOFT_AXES; i++) {
        s->aside[i] -= dot * s->ahead[i];
        size += s->aside[i] * s->aside[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        s->aside[i] = sqrt(size) > 1e-6 ? s->aside[i] / sqrt(size) : 0;
    s->shape.tight = false;
    for (int k = 0; k < 3; k++) {
        double along[LOFT_AXES], bend[LOFT_AXES];
        lie(s, k / 2.0, along, bend);
        for (int i = 0; i < LOFT_AXES; i++) {
            s->shape.along[k].axis[i] = real_of(along[i]);
            s->shape.bend[k].axis[i]  = real_of(bend[i]);
        }
    }
    s->arc = (loft_arc){ .length = wide_of(s->length) };
    return loft_scope_init(&s->piece, &s->budget, &s->arc, &s->shape,
                           real_of(arb_decades(a, 0.1, 1000)));
}

/* Part of a circle, or of a line: an arc as loft_arc_next cuts them turns by 1/8 at most. */
static bool arb_piece(arb *a, scene *s)
{
    const double turn = arb_below(a, 4) ? arb_decades(a, 0.001, 0.125) : 0;
    return piece_of(a, s, turn, turn, false);
}

/* How much of the acceleration is used when the piece begins with the square x of the speed and has
 * acceleration g. */
static double use_of(const scene *s, double x, double g)
{
    double most = 0;

    for (int k = 0; k < 3; k += 2)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double u = arb_value(s->shape.along[k].axis[i]),
                         bend = arb_value(s->shape.bend[k].axis[i]);
            const double now = x + (k > 0 ? 2 * g * s->length : 0);
            const double noise = BY_NUM(0x1p-15 * (fabs(g) + fabs(now) + fabs(g) * s->length),
                                        1e-6 * fabs(g), 1e-9);
            most = fmax(most, (fabs(u * g + bend * now) - noise) / arb_value(s->budget.accel[i]));
        }
    return most;
}

static double speeds(loft_real v) { return arb_value(v) * arb_value(v); }

static void speeding_up_in_the_scope_holds_the_limits(arb *a)
{
    scene s;

    (void)arb_piece(a, &s);
    CHECK(s.piece.cap > 0 && s.piece.cap <= s.piece.far && s.piece.rest > 0);
    for (int n = 0; n <= 16; n++) {
        const double x = speeds(s.piece.far) * n / 16,
                     g = arb_value(loft_scope_most(&s.piece, wide_of(x)));
        CHECK(use_of(&s, x, g) <= 1 + BY_NUM(0.001, 0.0005, 0.0001));
    }
}

/* Is the line from x at the start to `end` meant to be in the scope? At the far end it may not be;
 * from the cap it is unless `end` is more than can be reached from there. */
static bool leads(const scene *s, double x, double end)
{
    const double cap = speeds(s->piece.cap);
    return x < speeds(s->piece.far) * 0.9999 &&
           (fabs(x - cap) > 1e-6 * cap ||
            end <= cap + 2 * s->length * arb_value(loft_scope_most(&s->piece, wide_of(cap))));
}

static void braking_in_the_scope_holds_the_limits(arb *a)
{
    scene s;

    (void)arb_piece(a, &s);
    for (int n = 0; n <= 16; n++) {
        const double end = speeds(s.piece.last) * n / 16,
                     x = value_of(loft_scope_brake(&s.piece, wide_of(end)));
        CHECK(x >= 0 && x <= speeds(s.piece.far) * 1.00001);
        if (leads(&s, x, end))
            CHECK(use_of(&s, x, (end - x) / (2 * s.length)) <= 1 + BY_NUM(0.001, 0.0005, 0.0001));
    }
}

/* The same anywhere on the piece. */
static double use_between(const scene *s, double x, double g)
{
    double most = 0, along[LOFT_AXES], bend[LOFT_AXES];

    for (int n = 0; n <= 16; n++) {
        lie(s, n / 16.0, along, bend);
        for (int i = 0; i < LOFT_AXES; i++) {
            const double now = x + 2 * g * s->length * n / 16,
                         noise = BY_NUM(0x1p-14 * (fabs(g) + fabs(now) + fabs(g) * s->length),
                                        1e-6 * fabs(g), 1e-9);
            most = fmax(most, (fabs(along[i] * g + bend[i] * now) - noise) /
                                  arb_value(s->budget.accel[i]));
        }
    }
    return most;
}

static void where_the_curvature_changes_the_limits_hold_between_the_ends(arb *a)
{
    const double turn0 = arb_between(a, -0.1, 0.1), turn1 = arb_between(a, -0.1, 0.1);
    scene s;

    if (!piece_of(a, &s, turn0, turn1, true))
        return;
    for (int n = 0; n <= 16; n++) {
        const double far = speeds(s.piece.far), x = far * n / 16,
                     g = arb_value(loft_scope_most(&s.piece, wide_of(x)));
        CHECK(use_between(&s, x, g) <= 1.005);
        const double end = speeds(s.piece.last) * n / 16,
                     y = value_of(loft_scope_brake(&s.piece, wide_of(end)));
        if (leads(&s, y, end))
            CHECK(use_between(&s, y, (end - y) / (2 * s.length)) <= 1.005);
    }
}

/* A piece that flows passes from cap to cap; on a line that is always so. */
static void along_the_caps_the_limits_hold(arb *a)
{
    scene s;

    if (!arb_piece(a, &s) || !s.piece.flows)
        return;
    const double x = speeds(s.piece.cap), g = (speeds(s.piece.last) - x) / (2 * s.length);
    CHECK(use_of(&s, x, g) <= 1 + BY_NUM(0.001, 0.0005, 0.0001));
    const double v[3] = { sqrt(x), sqrt((x + speeds(s.piece.last)) / 2), arb_value(s.piece.last) };
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++)
            CHECK(fabs(arb_value(s.shape.along[k].axis[i])) * v[k] <=
                  arb_value(s.limits.max_speed[i]) * 1.0001 + BY_NUM(0.001, 1e-4, 1e-9));
}

/* The direction at parameter t of a curve, and how much faster than the curve's parameter its
 * length grows. */
static double heading_at(const loft_vec p[4], double t, double d[])
{
    double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const double x0 = arb_value(p[0].axis[i]), x1 = arb_value(p[1].axis[i]),
                     x2 = arb_value(p[2].axis[i]), x3 = arb_value(p[3].axis[i]);
        d[i] = 3 *
               ((1 - t) * (1 - t) * (x1 - x0) + 2 * t * (1 - t) * (x2 - x1) + t * t * (x3 - x2));
        sum += d[i] * d[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        d[i] /= sqrt(sum);
    return sqrt(sum);
}

/* The part of its speed that an axis uses, at most, when the arc from..to of a curve is passed
 * along the line between its caps. */
static double axis_use(const loft_plan_piece *p, const loft_vec curve[4], uint32_t from,
                       uint32_t to)
{
    enum { PARTS = 32 };
    double way[PARTS + 1] = { 0 }, d[PARTS + 1][LOFT_AXES], most = 0, before = 0;

    for (int n = 0; n <= PARTS; n++) {
        const double rate = heading_at(
            curve, (from + (to - from) * (double)n / PARTS) / LOFT_ARC_WHOLE, d[n]);
        way[n] = n > 0 ? way[n - 1] + (before + rate) / 2 : 0;
        before = rate;
    }
    for (int n = 0; n <= PARTS; n++) {
        const double v = sqrt(speeds(p->cap) +
                              (speeds(p->last) - speeds(p->cap)) * way[n] / way[PARTS]);
        for (int i = 0; i < LOFT_AXES; i++)
            most = fmax(most, (v * fabs(d[n][i]) - BY_NUM(0x1p-15, 0, 0)) /
                                  arb_value(limits.max_speed[i]));
    }
    return most;
}

/* The next piece of a curve: an arc, halved until its caps are near enough to a line; gives where
 * it ends. */
static uint32_t next_piece(scene *s, const loft_cubic *c, uint32_t from, double feed)
{
    uint32_t size = loft_arc_next(&s->arc, c, from, true) - from;

    loft_arc_measure(&s->arc, &s->shape, LOFT_ARC_ALL);
    while (!s->arc.speck && !s->arc.dust &&
           !loft_scope_init(&s->piece, &s->budget, &s->arc, &s->shape, real_of(feed)) && size > 1) {
        size /= 2;
        loft_arc_cut(&s->arc, c, from, from + size, true);
        loft_arc_measure(&s->arc, &s->shape, LOFT_ARC_ALL);
    }
    return from + size;
}

/* The feed is a little more than what one axis can follow somewhere on a curve. */
static void between_the_stations_no_axis_is_faster_than_it_may_be(arb *a)
{
    static const enum kind kinds[] = { ARC, SMOOTH, SMOOTH, WILD };
    const int i = (int)arb_below(a, LOFT_AXES);
    double d[LOFT_AXES];
    scene s;

    arb_budget(a, &s);
    begin_chain();
    arb_curve(a, kinds[arb_below(a, 4)], arb_decades(a, 1, 100), 1, false);
    const loft_cubic *c = &chain[0].curve;
    (void)heading_at(c->p, arb_between(a, 0, 1), d);
    const double feed = fmin(16000, arb_value(limits.max_speed[i]) / fmax(0.05, fabs(d[i])) *
                                        arb_between(a, 1, 1.05));
    for (uint32_t from = 0, to; from < LOFT_ARC_WHOLE; from = to) {
        to = next_piece(&s, c, from, feed);
        if (!s.arc.speck && !s.arc.dust && !s.shape.tight && value_of(s.arc.length) > 0.01)
            CHECK(axis_use(&s.piece, c->p, from, to) <= 1.0005);
    }
}

/* A line is passed with the least of what its axes allow. */
static void on_a_line_the_scope_is_a_rectangle(arb *a)
{
    scene s;
    double most = 16383;

    (void)arb_piece(a, &s);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            s.shape.along[k].axis[i] = s.shape.along[0].axis[i];
            s.shape.bend[k].axis[i]  = 0;
        }
    CHECK(loft_scope_init(&s.piece, &s.budget, &s.arc, &s.shape, real_of(100)) && s.piece.flows);
    for (int i = 0; i < LOFT_AXES; i++)
        most = fmin(most, arb_value(s.budget.accel[i]) /
                              fmax(1e-4, fabs(arb_value(s.shape.along[0].axis[i]))));
    for (int n = 0; n <= 4; n++)
        CHECK_NEAR(arb_value(loft_scope_most(&s.piece, wide_of(speeds(s.piece.far) * n / 4))), most,
                   BY_NUM(0.002, 0.001, 0.001) * most);
    CHECK_NEAR(value_of(loft_scope_brake(&s.piece, 0)), 2 * most * s.length,
               0.002 * 2 * most * s.length + 0.001);
}

static void a_joint_that_bends_nothing_is_none(arb *a)
{
    scene s;

    (void)arb_piece(a, &s);
    CHECK(!loft_scope_join(&s.piece, &s.budget, &s.shape.along[0], &s.shape.along[0], wide_of(1),
                           true, real_of(100), real_of(100)));
    loft_vec back = s.shape.along[0];
    for (int i = 0; i < LOFT_AXES; i++)
        back.axis[i] = -back.axis[i];
    CHECK(loft_scope_join(&s.piece, &s.budget, &s.shape.along[0], &back, wide_of(1), false,
                          real_of(100), real_of(100)));
    CHECK(s.piece.stop ||
          arb_value(s.piece.cap) < arb_value(s.budget.accel[0]) * arb_value(s.budget.pulse) * 100);
}

int main(void)
{
    PROPERTY(speeding_up_in_the_scope_holds_the_limits, 3000);
    PROPERTY(braking_in_the_scope_holds_the_limits,     3000);
    PROPERTY(where_the_curvature_changes_the_limits_hold_between_the_ends, 3000);
    PROPERTY(along_the_caps_the_limits_hold,            3000);
    PROPERTY(between_the_stations_no_axis_is_faster_than_it_may_be, 1500);
    PROPERTY(on_a_line_the_scope_is_a_rectangle,         500);
    PROPERTY(a_joint_that_bends_nothing_is_none,         500);
    return check_failures();
}
