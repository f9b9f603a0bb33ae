/* tests/support/topp_jerk.h -- a short time for a path under limits of speed, acceleration and jerk
 * of each axis: barriers and Newton's method, in double
 * SPDX-License-Identifier: MIT
 *
 * A path P(s), of any parameter s, is known on a grid with three derivatives. With x = (ds/dt)^2 at
 * the places and a = x'/2 between them, acceleration and jerk of an axis are
 *
 *     P' a + P'' x        and        sqrt(x) (P' a' + 3 P'' a + P''' x)
 *
 * The first is checked at both ends of each cell, the second at each place, with means of both
 * sides, and sqrt(x) of the mean of three: else a place with x = 0 would allow a jump of
 * acceleration. Rest is left with a constant jerk at most, s = j t^3 / 6: that bounds x at the
 * first place, and the first cell takes 3 h / v; likewise at the end.
 *
 *     minimise   time - sum mu log(slack)        mu = kappa * the time of the cell
 *
 * kappa falls from 0.3 to LEAST_KAPPA. Only the second derivatives of the time and of the linear
 * slacks are exact; for those of jerk the squares of the first ones are taken. So every matrix is
 * positive, with two diagonals beside the main one. Every state holds all limits on the grid: the
 * result is feasible there, but need not be the least.
 */
#ifndef LOFT_TESTS_TOPP_JERK_H
#define LOFT_TESTS_TOPP_JERK_H

#include <math.h>           /* sqrt, cbrt, log, exp */
#include <stdbool.h>        /* bool */

#define TOPP_JERK_MAX 40000
#define LEAST_KAPPA   3e-5

typedef struct {
    double s;                                                   /* the parameter             */
    double d1[LOFT_AXES], d2[LOFT_AXES], d3[LOFT_AXES];         /* derivatives               */
    double top;                                                 /* the largest x of speed    */
    double x, mu;                                               /* when solved               */
} jerk_node;

typedef struct {
    long double g, h[3];    /* slope; the main diagonal and the two beside it, above */
} jerk_row;

typedef struct {
    jerk_node node[TOPP_JERK_MAX];
    unsigned  count;
    double    accel[LOFT_AXES], jerk[LOFT_AXES];
    jerk_row  row[TOPP_JERK_MAX];
    double    was[TOPP_JERK_MAX];
    long double slope[TOPP_JERK_MAX];
} topp_jerk;

/* From rest to rest: up to seven phases of constant jerk. */
static inline double scurve_time(double length, double v, double a, double j)
{
    if (v * j < a * a)
        return length < 2 * v * sqrt(v / j) ? 4 * cbrt(length / (2 * j))
                                            : length / v + 2 * sqrt(v / j);
    if (length < 2 * a * a * a / (j * j))
        return 4 * cbrt(length / (2 * j));
    v = fmin(v, (sqrt(a * a * a * a / (j * j) + 4 * a * length) - a * a / j) / 2);
    return length / v + v / a + a / j;
}

static inline double jerk_weight(const topp_jerk *g, unsigned c)
{
    const double h = g->node[c + 1].s - g->node[c].s;
    return c == 0 || c + 2 == g->count ? 3 * h : 2 * h;
}

static inline double jerk_time(const topp_jerk *g)
{
    double time = 0;
    for (unsigned c = 0; c + 1 < g->count; c++)
        time += jerk_weight(g, c) / (sqrt(g->node[c].x) + sqrt(g->node[c + 1].x));
    return time;
}

/* The barrier of one slack that depends on the three x from `at` on, with this slope by their
 * logarithms. With `add`, its derivatives as well. Returns infinity outside. */
static inline double jerk_slack(topp_jerk *g, unsigned at, double mu, double slack,
                                const double slope[3], bool add)
{
    for (unsigned k = 0; k < 3 && add && at + k < g->count; k++) {
        const double d = slope[k] / slack;
        g->row[at + k].g -= mu * d;
        for (unsigned m = k; m < 3; m++)
            g->row[at + k].h[m - k] += mu * d * slope[m] / slack;
    }
    return slack > 0 ? -mu * log(slack) : INFINITY;
}

/* |v| <= most, where the logarithm of `most` falls by `bend` with those of x. */
static inline double jerk_both(topp_jerk *g, unsigned at, double mu, double v, double most,
                               const double slope[3], const double bend[3], bool add)
{
    double sum = 0;

    for (int sign = -1; sign <= 1; sign += 2) {
        double d[3];
        for (int k = 0; k < 3; k++)
            d[k] = -sign * (slope[k] + bend[k] * v) / most;
        sum += jerk_slack(g, at, mu, 1 - sign * v / most, d, add);
    }
    return sum;
}

static inline double jerk_cell(topp_jerk *g, unsigned c, bool add)
{
    const jerk_node *n = &g->node[c];
    const double h = n[1].s - n->s, a = (n[1].x - n->x) / (2 * h), none[3] = { 0 };
    double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned e = 0; e < 2; e++) {
            const double u = n[e].d1[i], k = n[e].d2[i];
            const double slope[3] = { n->x * ((e == 0 ? k : 0) - u / (2 * h)),
                                      n[1].x * ((e == 1 ? k : 0) + u / (2 * h)), 0 };
            sum += jerk_both(g, c, n[e].mu, u * a + k * n[e].x, g->accel[i], slope, none, add);
        }
    return sum;
}

/* The place c + 1, between two cells. */
static inline double jerk_place(topp_jerk *g, unsigned c, bool add)
{
    const jerk_node *n = &g->node[c], *m = n + 1;
    const double h0 = m->s - n->s, h1 = n[2].s - m->s, mean = (h0 + h1) / 2,
                 a0 = (m->x - n->x) / (2 * h0), a1 = (n[2].x - m->x) / (2 * h1), x = m->x;
    const double mix = n->x + 2 * x + n[2].x, root = sqrt(mix / 4),
                 bend[3] = { n->x / mix / 2, x / mix, n[2].x / mix / 2 },
                 top[3] = { 0, -x / m->top, 0 };
    double sum = jerk_slack(g, c, m->mu, 1 - x / m->top, top, add);

    for (int i = 0; i < LOFT_AXES; i++) {
        const double u = m->d1[i] / mean, k = 1.5 * m->d2[i], most = g->jerk[i] / root;
        const double v = u * (a1 - a0) + k * (a1 + a0) + m->d3[i] * x;
        const double slope[3] = { n->x * (u - k) / (2 * h0),
                                  x * (-(u + k) / (2 * h1) - (u - k) / (2 * h0) + m->d3[i]),
                                  n[2].x * (u + k) / (2 * h1) };
        sum += jerk_both(g, c, m->mu, v, most, slope, bend, add);
    }
    return sum;
}

/* What is minimised. With `add`, its derivatives by the logarithms of x as well. */
static inline double jerk_merit(topp_jerk *g, bool add)
{
    double sum = 0;

    for (unsigned c = 0; c < g->count && add; c++)
        g->row[c] = (jerk_row){ 0 };
    for (unsigned c = 0; c + 1 < g->count; c++) {
        const double r0 = sqrt(g->node[c].x), r1 = sqrt(g->node[c + 1].x), r = r0 + r1,
                     w = jerk_weight(g, c);
        sum += w / r + jerk_cell(g, c, add) + (c + 2 < g->count ? jerk_place(g, c, add) : 0);
        if (!add)
            continue;
        const double d0 = -w / (r * r) * r0 / 2, d1 = -w / (r * r) * r1 / 2;
        g->row[c].g += d0;
        g->row[c + 1].g += d1;
        g->row[c].h[0] += w * r0 * r0 / (2 * r * r * r) - d0 / 2;
        g->row[c].h[1] += w * r0 * r1 / (2 * r * r * r);
        g->row[c + 1].h[0] += w * r1 * r1 / (2 * r * r * r) - d1 / 2;
    }
    return sum;
}

/* Solve for Newton's step, into g of the rows. Both ends stay. Returns the decrement. */
static inline double jerk_solve(topp_jerk *g)
{
    jerk_row *r = g->row;
    const unsigned n = g->count;
    double decrement = 0;

    for (unsigned i = 0; i < n; i++) {
        const bool end = i == 0 || i + 1 == n;
        r[i].h[0] = end ? 1 : r[i].h[0];
        r[i].g    = end ? 0 : -r[i].g;
        for (unsigned k = 1; k < 3; k++)
            if (end || i + k + 1 >= n)
                r[i].h[k] = 0;
        g->slope[i] = r[i].g;
    }
    for (unsigned i = 0; i < n; i++)            /* L D L^T, and forward */
        for (unsigned k = 1; k < 3 && i + k < n; k++) {
            const long double l = r[i].h[k] / r[i].h[0];
            for (unsigned m = k; m < 3 && i + m < n; m++)
                r[i + k].h[m - k] -= l * r[i].h[m];
            r[i + k].g -= l * r[i].g;
        }
    for (unsigned i = n; i-- > 0; ) {
        for (unsigned k = 1; k < 3 && i + k < n; k++)
            r[i].g -= r[i].h[k] * r[i + k].g;
        r[i].g /= r[i].h[0];
        decrement += (double)(g->slope[i] * r[i].g);
    }
    return decrement;
}

/* One step, as long as the merit falls. Returns the part of it that was gone. */
static inline double jerk_step(topp_jerk *g, double *decrement)
{
    const double before = jerk_merit(g, true);
    double part = 1;

    *decrement = jerk_solve(g);
    for (unsigned i = 0; i < g->count; i++) {
        g->was[i] = g->node[i].x;
        part = fmin(part, 0.9 / fmax(0.9, -(double)g->row[i].g));
    }
    for (; part > 1e-6; part /= 2) {
        for (unsigned i = 0; i < g->count; i++)
            g->node[i].x = g->was[i] * (1 + part * (double)g->row[i].g);
        if (jerk_merit(g, false) < before)
            return part;
    }
    for (unsigned i = 0; i < g->count; i++)
        g->node[i].x = g->was[i];
    return 0;
}

static inline void jerk_weigh(topp_jerk *g, double kappa)
{
    for (unsigned c = 0; c + 1 < g->count; c++) {
        const double r = sqrt(g->node[c].x) + sqrt(g->node[c + 1].x);
        g->node[c].mu = kappa * jerk_weight(g, c) / r;
    }
    g->node[g->count - 1].mu = g->node[g->count - 2].mu;
}

/* A slow start: one constant speed, launched from rest and back, that holds all. */
static inline void jerk_start(topp_jerk *g)
{
    const unsigned last = g->count - 1;
    const double length = g->node[last].s - g->node[0].s;
    double least = INFINITY;

    for (unsigned e = 0; e < 2; e++) {
        const jerk_node *end = &g->node[e ? last : 0];
        jerk_node *near = &g->node[e ? last - 1 : 1];
        const double h = fabs(near->s - end->s);
        double most = INFINITY;
        for (int i = 0; i < LOFT_AXES; i++)
            if (fabs(end->d1[i]) > 1e-9)
                most = fmin(most, g->jerk[i] / fabs(end->d1[i]));
        near->top = fmin(near->top, most * most / 4 * pow(6 * h / most, 4 / 3.0));
    }
    for (unsigned c = 2; c + 2 <= last; c++)
        least = fmin(least, g->node[c].top);
    for (double scale = 0.5; ; scale /= 2) {
        for (unsigned c = 0; c <= last; c++) {
            jerk_node *n = &g->node[c];
            const double away = fmin(n->s - g->node[0].s, g->node[last].s - n->s) / length;
            n->x = scale * fmin(n->top, fmin(least, pow(2 * away, 4 / 3.0) * least));
        }
        g->node[0].x = g->node[last].x = 0;
        jerk_weigh(g, 0.3);
        if (scale < 1e-30 || jerk_merit(g, false) < INFINITY)
            return;
    }
}

/* Returns the time from rest to rest in s. Six places at least. */
static inline double topp_jerk_time(topp_jerk *g)
{
    double kappa = 0.3;

    jerk_start(g);
    for (unsigned n = 0; n < 300; n++) {
        double decrement;
        jerk_weigh(g, kappa);
        const double part = jerk_step(g, &decrement), time = jerk_time(g);
        if (kappa <= LEAST_KAPPA && (part == 0 || decrement < 1e-5 * time))
            break;
        if (part == 0 || decrement < 0.5 * kappa * time)
            kappa = fmax(LEAST_KAPPA, 0.35 * kappa);
    }
    return jerk_time(g);
}

#endif
