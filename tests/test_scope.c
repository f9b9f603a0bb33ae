/* tests/test_scope.c -- properties of lib/motion/scope.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "motion/scope.h"
#include "motion_chains.h"  /* arb_direction, real_of, arb_value */

typedef struct {
    loft_limits     limits;
    loft_budget     budget;
    loft_arc        arc;
    loft_arc_shape  shape;
    loft_plan_piece piece;
    double          length;
} scene;

static loft_acc wide_of(double x)   { return BY_NUM((loft_acc)floor(x * 4294967296.0 + 0.5), x, x); }
static double   value_of(loft_acc x) { return BY_NUM((double)x / 4294967296.0, (double)x, (double)x); }

static void arb_budget(arb *a, scene *s)
{
    arb_limits(a);
    s->limits = limits;
    loft_budget_init(&s->budget, &s->limits);
}

/* Part of a circle, or of a line: an arc as loft_arc_next cuts them turns by 1/8 at most. */
static bool arb_piece(arb *a, scene *s)
{
    double u[LOFT_AXES], w[LOFT_AXES], dot = 0, size = 0;
    const double turn = arb_below(a, 4) ? arb_decades(a, 0.001, 0.125) : 0;

    arb_budget(a, s);
    s->length = arb_decades(a, 0.01, 50);
    arb_direction(a, u);
    arb_direction(a, w);
    for (int i = 0; i < LOFT_AXES; i++)
        dot += u[i] * w[i];
    for (int i = 0; i < LOFT_AXES; i++) {
        w[i] -= dot * u[i];
        size += w[i] * w[i];
    }
    size = sqrt(size);
    s->shape.tight = false;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double z = turn * k / 2, v = size > 1e-6 ? w[i] / size : 0;
            s->shape.along[k].axis[i] = real_of(cos(z) * u[i] + sin(z) * v);
            s->shape.bend[k].axis[i]  = real_of(turn / s->length * (cos(z) * v - sin(z) * u[i]));
        }
    s->arc.length = wide_of(s->length);
    return loft_scope_init(&s->piece, &s->budget, &s->arc, &s->shape, real_of(arb_decades(a, 0.1, 1000)));
}

/* How much of the acceleration is used when the piece begins with the square x of the speed and has acceleration g. */
static double use_of(const scene *s, double x, double g)
{
    double most = 0;

    for (int k = 0; k < 3; k += 2)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double u = arb_value(s->shape.along[k].axis[i]), bend = arb_value(s->shape.bend[k].axis[i]);
            const double now = x + (k > 0 ? 2 * g * s->length : 0);
            const double noise = BY_NUM(0x1p-15 * (fabs(g) + fabs(now) + fabs(g) * s->length), 1e-6 * fabs(g), 1e-9);
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
        const double x = speeds(s.piece.far) * n / 16, g = arb_value(loft_scope_most(&s.piece, wide_of(x)));
        CHECK(use_of(&s, x, g) <= 1 + BY_NUM(0.001, 0.0005, 0.0001));
    }
}

static void braking_in_the_scope_holds_the_limits(arb *a)
{
    scene s;

    (void)arb_piece(a, &s);
    for (int n = 0; n <= 16; n++) {
        const double end = speeds(s.piece.last) * n / 16, x = value_of(loft_scope_brake(&s.piece, wide_of(end)));
        CHECK(x >= 0 && x <= speeds(s.piece.far) * 1.00001);
        if (x < speeds(s.piece.far) * 0.9999)
            CHECK(use_of(&s, x, (end - x) / (2 * s.length)) <= 1 + BY_NUM(0.001, 0.0005, 0.0001));
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
            CHECK(fabs(arb_value(s.shape.along[k].axis[i])) * v[k] <= arb_value(s.limits.max_speed[i]) * 1.0001 + BY_NUM(0.001, 1e-4, 1e-9));
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
        most = fmin(most, arb_value(s.budget.accel[i]) / fmax(1e-4, fabs(arb_value(s.shape.along[0].axis[i]))));
    for (int n = 0; n <= 4; n++)
        CHECK_NEAR(arb_value(loft_scope_most(&s.piece, wide_of(speeds(s.piece.far) * n / 4))), most, BY_NUM(0.002, 0.001, 0.001) * most);
    CHECK_NEAR(value_of(loft_scope_brake(&s.piece, 0)), 2 * most * s.length, 0.002 * 2 * most * s.length + 0.001);
}

static void a_joint_that_bends_nothing_is_none(arb *a)
{
    scene s;

    (void)arb_piece(a, &s);
    CHECK(!loft_scope_join(&s.piece, &s.budget, s.shape.along[0], s.shape.along[0], wide_of(1), true, real_of(100), real_of(100)));
    loft_vec back = s.shape.along[0];
    for (int i = 0; i < LOFT_AXES; i++)
        back.axis[i] = -back.axis[i];
    CHECK(loft_scope_join(&s.piece, &s.budget, s.shape.along[0], back, wide_of(1), false, real_of(100), real_of(100)));
    CHECK(s.piece.stop || arb_value(s.piece.cap) < arb_value(s.budget.accel[0]) * arb_value(s.budget.pulse) * 100);
}

int main(void)
{
    PROPERTY(speeding_up_in_the_scope_holds_the_limits, 3000);
    PROPERTY(braking_in_the_scope_holds_the_limits,     3000);
    PROPERTY(along_the_caps_the_limits_hold,            3000);
    PROPERTY(on_a_line_the_scope_is_a_rectangle,         500);
    PROPERTY(a_joint_that_bends_nothing_is_none,         500);
    return check_failures();
}
