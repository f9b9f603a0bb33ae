/* tests/lib/motion/test_topp.c -- the yardstick itself: paths whose least time is known
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_chains.h"  /* chain, add_curve, limits */
#include "support/topp.h"           /* topp_grid, topp_time; CHECK, PROPERTY */

static topp grid;

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

int main(void)
{
    PROPERTY(a_line_takes_its_trapezoid, 20);
    PROPERTY(a_diagonal_uses_both_axes, 20);
    PROPERTY(its_profile_keeps_the_limits, 20);
    PROPERTY(a_circle_takes_what_a_linear_program_found, 1);
    return check_failures();
}
