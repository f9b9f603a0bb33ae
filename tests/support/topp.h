/* tests/support/topp.h -- the shortest time for a path: reachability in double, for limits of speed
 * and acceleration
 * SPDX-License-Identifier: MIT
 *
 * H. Pham, Q.-C. Pham: A new approach to time-optimal path parameterization based on reachability
 * analysis, IEEE Transactions on Robotics 34(3), 2018. On a grid of the path's length s, with x =
 * v^2 and a = x'/2, every grid point allows
 *
 *     |u_i a + k_i x| <= A_i,  |u_i| sqrt x <= V_i,  sqrt x <= feed        u direction, k curvature
 *         vector
 *
 * Backward: the largest x from which the end can still be reached at rest. Forward: as fast as that
 * allows. Nothing is checked between grid points, so the time is a little below the true optimum
 * (by the order of one cell).
 */
#ifndef LOFT_TESTS_TOPP_H
#define LOFT_TESTS_TOPP_H

#include <math.h>           /* sqrt, fabs, fmin, fmax */

#include "support/motion_oracle.h"  /* loft_move, arb_value */

#define TOPP_MAX 40000

typedef struct {
    double   s;                             /* mm from the start                           */
    double   u[LOFT_AXES], k[LOFT_AXES];    /* direction; curvature vector, 1/mm           */
    double   top;                           /* the square of the largest speed here        */
    double   x;                             /* the square of the speed, when solved        */
} topp_node;

typedef struct {
    topp_node node[TOPP_MAX];
    unsigned  count;
    double    accel[LOFT_AXES];
} topp;

static inline void topp_derivatives(const loft_vec p[4], double t, double d1[], double d2[])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const double p0 = arb_value(p[0].axis[i]), p1 = arb_value(p[1].axis[i]),
                     p2 = arb_value(p[2].axis[i]), p3 = arb_value(p[3].axis[i]);
        d1[i] = 3 *
                ((1 - t) * (1 - t) * (p1 - p0) + 2 * t * (1 - t) * (p2 - p1) + t * t * (p3 - p2));
        d2[i] = 6 * ((1 - t) * (p0 - 2 * p1 + p2) + t * (p1 - 2 * p2 + p3));
    }
}

static inline double topp_dot(const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += a[i] * b[i];
    return sum;
}

static inline double topp_rate(const loft_vec p[4], double t)
{
    double d1[LOFT_AXES], d2[LOFT_AXES];
    topp_derivatives(p, t, d1, d2);
    return sqrt(topp_dot(d1, d1));
}

static inline void topp_add(topp *g, const loft_move *m, double t, double s, const loft_limits *l)
{
    topp_node *n = &g->node[g->count < TOPP_MAX ? g->count++ : TOPP_MAX - 1];
    double d1[LOFT_AXES], d2[LOFT_AXES];

    if (!(topp_rate(m->curve.p, t) > 1e-9))     /* a handle of no length */
        t += t < 0.5 ? 0.01 : -0.01;
    topp_derivatives(m->curve.p, t, d1, d2);
    const double rate  = fmax(1e-9, sqrt(topp_dot(d1, d1))),
                 along = topp_dot(d1, d2) / (rate * rate);
    double v = arb_value(m->feed);
    n->s = s;
    for (int i = 0; i < LOFT_AXES; i++) {
        n->u[i] = d1[i] / rate;
        n->k[i] = (d2[i] - along * d1[i]) / (rate * rate);
        v = fabs(n->u[i]) > 0 ? fmin(v, arb_value(l->max_speed[i]) / fabs(n->u[i])) : v;
    }
    n->top = v * v;
    n->x   = 0;
}

/* A grid of about `cells` cells per curve, evenly spaced by length; only for curves without cusps
 * or specks. Joints appear twice, once for each side, at the same s. */
static inline void topp_grid(topp *g, const loft_move moves[], unsigned moved, const loft_limits *l,
                             unsigned cells)
{
    double s0 = 0;

    g->count = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        g->accel[i] = arb_value(l->max_accel[i]);
    for (unsigned c = 0; c < moved; c++) {
        const unsigned fine = 16 * cells;
        const loft_vec *p = moves[c].curve.p;
        double length = 0, s = 0;
        for (unsigned j = 0; j < fine; j++)
            length += topp_rate(p, (j + 0.5) / fine) / fine;
        topp_add(g, &moves[c], 0, s0, l);
        unsigned k = 1;
        for (unsigned j = 0; j < fine; j++) {
            const double ds = topp_rate(p, (j + 0.5) / fine) / fine;
            for (; k < cells && s + ds >= length * k / cells; k++)
                topp_add(g, &moves[c], (j + (length * k / cells - s) / ds) / fine,
                         s0 + length * k / cells, l);
            s += ds;
        }
        topp_add(g, &moves[c], 1, s0 + length, l);
        s0 += length;
    }
    CHECK(g->count < TOPP_MAX);
}

/* The range of a that node n allows at x. Returns false if there is none. */
static inline bool topp_range(const topp *g, const topp_node *n, double x, double *low,
                              double *high)
{
    *low = -1e30;
    *high = 1e30;
    for (int i = 0; i < LOFT_AXES; i++) {
        const double used = n->k[i] * x, u = n->u[i];
        if (fabs(u) < 1e-12) {
            if (fabs(used) > g->accel[i])
                return false;
            continue;
        }
        const double a = (-g->accel[i] - used) / u, b = (g->accel[i] - used) / u;
        *low  = fmax(*low, fmin(a, b));
        *high = fmin(*high, fmax(a, b));
    }
    return *low <= *high;
}

static inline bool topp_leads(const topp *g, unsigned i, double x, double to)
{
    const double h = g->node[i + 1].s - g->node[i].s;
    double low, high;
    return topp_range(g, &g->node[i], x, &low, &high) &&
           fmax(low, -x / (2 * h)) <= fmin(high, (to - x) / (2 * h));
}

/* Solve from rest to rest. Returns the time in s. */
static inline double topp_time(topp *g)
{
    double time = 0;

    g->node[g->count - 1].x = 0;
    for (unsigned i = g->count - 1; i-- > 0; ) {
        topp_node *n = &g->node[i];
        const double to = n[1].x;
        double low = 0, high = n->top, a, b;
        if (!(n[1].s > n->s)) {             /* a joint: the limits of both sides */
            for (int k = 0; k < 60; k++) {
                const double x = (low + high) / 2;
                if (topp_range(g, n, x, &a, &b))
                    low = x;
                else
                    high = x;
            }
            n->x = fmin(low, to);
            continue;
        }
        for (int k = 0; k < 60; k++) {
            const double x = (low + high) / 2;
            if (topp_leads(g, i, x, to))
                low = x;
            else
                high = x;
        }
        n->x = low;
    }
    g->node[0].x = 0;
    for (unsigned i = 0; i + 1 < g->count; i++) {
        const topp_node *n = &g->node[i];
        const double h = n[1].s - n->s;
        double low, high;
        if (!(h > 0)) {
            g->node[i + 1].x = fmin(n->x, n[1].x);
            continue;
        }
        if (topp_range(g, n, n->x, &low, &high))
            g->node[i + 1].x = fmin(g->node[i + 1].x, n->x + 2 * h * high);
        time += 2 * h / (sqrt(n->x) + sqrt(g->node[i + 1].x));
    }
    return time;
}

#endif
