/* tests/lib/motion/test_topp.c -- the yardstick itself: paths whose least time is known
 * SPDX-License-Identifier: MIT
 */
#include <string.h>         /* memmove */

#include "support/motion_chains.h"  /* chain, add_curve, limits */
#include "support/topp.h"           /* topp_grid, topp_time; CHECK, PROPERTY */
#include "support/topp_jerk.h"      /* topp_jerk_time, scurve_time           */

static topp      grid;
static topp_jerk jerked;

static void even_limits(double speed, double accel)
{
    usual_limits();
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = real_of(speed);
        limits.max_accel[i] = real_of(accel);
    }
}

static void line(double x, double y, double feed)
{
    const double d[LOFT_AXES] = { x, y }, e[LOFT_AXES] = { 0 }, u[4] = { 0, 1 / 3.0, 2 / 3.0, 1 },
                 w[4] = { 0 };
    begin_chain();
    add_curve(d, e, u, w, feed);
}

/* A trapezoid of speed: L / v + v / a; too short for it: 2 sqrt(L / a). */
static void a_line_takes_its_trapezoid(arb *a)
{
    const double length = arb_decades(a, 1, 1000), v = arb_decades(a, 5, 500),
                 accel = arb_decades(a, 100, 5000);
    even_limits(1000, accel);
    line(length, 0, v);
    topp_grid(&grid, chain, 1, &limits, 4000);
    const double want = length >= v * v / accel ? length / v + v / accel : 2 * sqrt(length / accel);
    const double got = topp_time(&grid);
    CHECK(fabs(got / want - 1) < 0.001);
}

/* Axes add up: along a diagonal both may be used to the full. */
static void a_diagonal_uses_both_axes(arb *a)
{
    const double length = arb_decades(a, 10, 500), accel = arb_decades(a, 100, 5000);
    even_limits(1000, accel);
    line(length / sqrt(2), length / sqrt(2), 1400);
    topp_grid(&grid, chain, 1, &limits, 4000);
    const double got = topp_time(&grid), want = 2 * sqrt(length / (accel * sqrt(2)));
    CHECK(length > 1400 * 1400 / (accel * sqrt(2)) || fabs(got / want - 1) < 0.001);
}

/* Within its own limits: the acceleration vector between grid points, by finite differences of
 * place in time. */
static void its_profile_keeps_the_limits(arb *a)
{
    even_limits(200, 1000);
    begin_chain();
    for (int k = 0; k < 4; k++)
        arb_curve(a, SMOOTH, 40, 150, true);
    topp_grid(&grid, chain, curves, &limits, 500);
    CHECK(topp_time(&grid) > 0);
    for (unsigned j = 0; j + 1 < grid.count; j++) {
        const topp_node *n = &grid.node[j];
        const double h = n[1].s - n->s;
        double low, high;
        CHECK(n->x <= n->top * (1 + 1e-9));
        if (h > 0 && topp_range(&grid, n, n->x * (1 - 1e-9), &low, &high)) {
            const double accel = (n[1].x - n->x) / (2 * h);
            CHECK(accel <= high + 1 && accel >= low - 1);
        }
    }
}

/* A circle of r = 10 in 4 cubics: 62.83 mm take 0.5051 s with 200 mm/s, 2000 mm/s^2 (an independent
 * linear program). */
static void a_circle_takes_what_a_linear_program_found(arb *a)
{
    static const double at[4][4] = {
        { 10, 0, 0, 10 }, { 0, 10, -10, 0 }, { -10, 0, 0, -10 }, { 0, -10, 10, 0 }
    };
    const double c = 0.5522847498;
    (void)a;
    even_limits(200, 2000);
    begin_chain();
    for (int q = 0; q < 4; q++) {
        const double *p = at[q];
        const double d[LOFT_AXES] = { 1, 0 }, e[LOFT_AXES] = { 0, 1 };
        here[0] = here[1] = 0;
        const double u[4] = { p[0], p[0] + c * p[2], p[2] + c * p[0], p[2] };
        const double w[4] = { p[1], p[1] + c * p[3], p[3] + c * p[1], p[3] };
        add_curve(d, e, u, w, 1000);
    }
    topp_grid(&grid, chain, curves, &limits, 1000);
    CHECK(fabs(topp_time(&grid) - 0.5051) < 0.001);
}

/* 151 places on an ellipse's arc from angle 0, or on a line where b is 0. */
static void jerk_arc(double a, double b, double angle, double speed)
{
    jerked.count = 151;
    for (unsigned k = 0; k <= 150; k++) {
        const double z = k / 150.0, s = angle * (z - 0.9 * sin(6.283185307 * z) / 6.283185307);
        const double c = a * cos(s), d = b * sin(s), e = a * sin(s), f = b * cos(s);
        jerk_node *n = &jerked.node[k];
        *n = b > 0 ? (jerk_node){ .s = s, .d1 = { -e, f }, .d2 = { -c, -d }, .d3 = { e, -f } }
                   : (jerk_node){ .s = s, .d1 = { a } };
        n->top = speed * speed / (n->d1[0] * n->d1[0] + n->d1[1] * n->d1[1]);
    }
}

static void a_line_takes_its_s_curve(arb *a)
{
    const double length = arb_decades(a, 1, 1000), v = arb_decades(a, 5, 500),
                 accel = arb_decades(a, 100, 5000), jerk = accel * arb_decades(a, 5, 50);

    jerk_arc(length, 0, 1, v);
    for (int i = 0; i < LOFT_AXES; i++) {
        jerked.accel[i] = accel;
        jerked.jerk[i]  = jerk;
    }
    const double want = scurve_time(length, v, accel, jerk), got = topp_jerk_time(&jerked);
    CHECK(got > 0.995 * want && got < 1.03 * want);
}

/* Within its own limits: differences of places over time, up to the third. */
static void its_jerk_is_within_the_limits(arb *a)
{
    const double rx = arb_between(a, 5, 50), ry = arb_between(a, 5, 50),
                 accel = arb_decades(a, 500, 5000), jerk = accel * arb_between(a, 10, 50);
    double t[4] = { 0 }, x[4][2], most[4] = { 0 };

    jerk_arc(rx, ry, arb_between(a, 1, 6), 100);
    for (int i = 0; i < LOFT_AXES; i++) {
        jerked.accel[i] = accel;
        jerked.jerk[i]  = jerk;
    }
    CHECK(topp_jerk_time(&jerked) > 0);
    for (unsigned k = 0; k + 1 < jerked.count; k++) {
        const jerk_node *n = &jerked.node[k];
        memmove(t, t + 1, sizeof t - sizeof *t);
        memmove(x, x + 1, sizeof x - sizeof *x);
        t[3]    = t[2] + (k ? 2 * (n->s - n[-1].s) / (sqrt(n->x) + sqrt(n[-1].x)) : 0);
        x[3][0] = rx * cos(n->s);
        x[3][1] = ry * sin(n->s);
        for (int i = 0; i < 2 && k > 8 && k + 8 < jerked.count; i++) {
            double d[4] = { x[0][i], x[1][i], x[2][i], x[3][i] };
            for (int order = 1; order < 4; order++)
                for (int m = 3; m >= order; m--)
                    d[m] = (d[m] - d[m - 1]) / (t[m] - t[m - order]) * order;
            most[2] = fmax(most[2], fabs(d[2]));
            most[3] = fmax(most[3], fabs(d[3]));
        }
    }
    CHECK(most[2] < 1.005 * accel && most[3] < 1.05 * jerk);
}

int main(void)
{
    PROPERTY(a_line_takes_its_trapezoid, 20);
    PROPERTY(a_diagonal_uses_both_axes, 20);
    PROPERTY(its_profile_keeps_the_limits, 20);
    PROPERTY(a_circle_takes_what_a_linear_program_found, 1);
    PROPERTY(a_line_takes_its_s_curve, 10);
    PROPERTY(its_jerk_is_within_the_limits, 5);
    return check_failures();
}
