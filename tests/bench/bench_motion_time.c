/* tests/bench/bench_motion_time.c -- compares the duration of plans with the shortest possible time
 * for their paths
 * SPDX-License-Identifier: MIT
 * usage: time FOLDER [CHAINS]      FOLDER holds lists of moves; CHAINS random smooth ones as well
 *
 * Prints `accel NAME PLAN LEAST` if jerk is not limited, else `jerk NAME PLAN SHORT` with a time by
 * topp_jerk.h. Prints `rest LENGTH PLAN LEAST PERIOD` for lines from rest to rest. All in seconds.
 */
#define CURVES 64

#include "support/motion_paths.h"   /* test_paths, smooth_path   */
#include "support/motion_spans.h"   /* plan_chain, seconds       */
#include "support/topp.h"           /* topp_grid, topp_time      */
#include "support/topp_jerk.h"      /* topp_jerk_time            */

static topp      grid;
static topp_jerk jerked;

static double twist[TOPP_MAX][LOFT_AXES];      /* the derivative of the curvature vector with
                                                * respect to length */

/* Computed from the neighbours on the same curve. */
static void set_twist(unsigned j)
{
    const unsigned from = j > 0 && grid.node[j - 1].s < grid.node[j].s ? j - 1 : j;
    const unsigned to   = j + 1 < grid.count && grid.node[j + 1].s > grid.node[j].s ? j + 1 : j;
    for (int i = 0; i < LOFT_AXES; i++)
        twist[j][i] = (grid.node[to].k[i] - grid.node[from].k[i]) /
                      (grid.node[to].s - grid.node[from].s);
}

/* If the curvature jumps by d at length s, no speed keeps a jerk limit on the path itself. A path
 * whose curvature changes linearly over a length w deviates by d w^2 / 24: this takes the longest w
 * that the tolerance allows. */
static void ease_jump(unsigned j)
{
    double jump[LOFT_AXES], size = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        jump[i] = grid.node[j + 1].k[i] - grid.node[j].k[i];
        size   += jump[i] * jump[i];
    }
    const double s = grid.node[j].s, w = sqrt(24 * arb_value(limits.tol) / fmax(1e-9, sqrt(size)));
    for (unsigned n = 0; n < grid.count; n++) {
        topp_node *node = &grid.node[n];
        const double x = (node->s - s) / w;
        if (fabs(x) > 0.5)
            continue;
        const double by = n <= j ? x + 0.5 : x - 0.5;
        for (int i = 0; i < LOFT_AXES; i++) {
            node->k[i]  += by * jump[i];
            twist[n][i] += jump[i] / w;
        }
    }
}

static void ease_grid(void)
{
    for (unsigned j = 0; j < grid.count; j++)
        set_twist(j);
    for (unsigned j = 0; j + 1 < grid.count; j++)
        if (!(grid.node[j + 1].s > grid.node[j].s))
            ease_jump(j);
}

/* Some of the places of the grid: 1500 evenly, and denser towards both ends. */
static double short_time(void)
{
    const double length = grid.node[grid.count - 1].s, least = length / 20000;
    double next = 0;

    jerked.count = 0;
    for (unsigned j = 0; j < grid.count; j++) {
        const topp_node *n = &grid.node[j];
        const double away = fmin(n->s, length - n->s);
        jerk_node *to = &jerked.node[jerked.count];
        if ((n->s < next || away < least) && j + 1 < grid.count && j > 0)
            continue;
        *to = (jerk_node){ .s = n->s, .top = n->top };
        memcpy(to->d1, n->u, sizeof n->u);
        memcpy(to->d2, n->k, sizeof n->k);
        memcpy(to->d3, twist[j], sizeof twist[j]);
        next = n->s + fmin(length / 1500, fmax(least, away / 20));
        jerked.count++;
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        jerked.accel[i] = arb_value(limits.max_accel[i]);
        jerked.jerk[i]  = limits.max_jerk[i];
    }
    return topp_jerk_time(&jerked);
}

static void measure(const char *name)
{
    const arrival all = { CURVES, KNOTS, NULL };

    if (plan_chain(&all) != PLANNED || count == 0)
        return;
    topp_grid(&grid, chain, curves, &limits, 1000);
    if (limits.max_jerk[0] > 0) {
        ease_grid();
        printf("jerk %s %.6f %.6f\n", name, seconds(), short_time());
    } else
        printf("accel %s %.6f %.6f\n", name, seconds(), topp_time(&grid));
}

/* A check of the oracle itself: the best jerk-limited time of this line is L / v + v / a + a / j =
 * 2.15 s. */
static void line_path(void)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 },
                 u[4] = { 0, 100 / 3.0, 200 / 3.0, 100 }, w[4] = { 0 };

    even_limits(1000, 500, 10000);
    begin_chain();
    add_curve(d, e, u, w, 50);
}

static void measure_line(double length, double v, double accel)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 },
                 u[4] = { 0, length / 3, length * 2 / 3, length }, w[4] = { 0 };
    const arrival all = { CURVES, KNOTS, NULL };
    loft_period p;

    even_limits(1000, accel, 20 * accel);
    begin_chain();
    add_curve(d, e, u, w, v);
    if (plan_chain(&all) != PLANNED)
        return;
    loft_period_init(&p, &limits);
    printf("rest %g-mm-at-%g-mm/s-%g-mm/s2 %.6f %.6f %.6f\n", length, v, accel, seconds(),
           scurve_time(length, v, accel, 20 * accel), (double)p.ticks / p.tick_hz);
}

static void measure_lines(void)
{
    static const double lengths[] = { 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 40, 50, 100 };

    for (unsigned k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        measure_line(lengths[k], 30, 500);
        measure_line(lengths[k], 5, 500);
        measure_line(lengths[k], 100, 1000);
    }
}

int main(int words, char **word)
{
    const unsigned chains = words > 2 ? (unsigned)atoi(word[2]) : 0;
    char name[40];

    if (words < 2)
        return 64;
    for (unsigned k = 0; k < TEST_PATHS; k++)
        if (strcmp(test_paths[k].drawing, "outline12") == 0) {
            if (!load_path(&test_paths[k], word[1]))
                return 66;
            measure(test_paths[k].name);
        }
    line_path();
    measure("line");
    measure_lines();
    for (unsigned seed = 1; seed <= chains; seed++) {
        snprintf(name, sizeof name, "smooth-seed-%u", seed);
        smooth_path(seed, seed % 4 == 0);
        measure(name);
    }
    return 0;
}
