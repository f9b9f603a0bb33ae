/* host-tools/engine/sided_toric.c -- from the parameters of polygon/toric_tensor.h to those of the
 * patch
 * SPDX-License-Identifier: MIT
 *
 * A point of the polygon is that where the gradient of the convex function sum h_j log h_j - h_j
 * has a given value: by Newton's method, with steps that keep a tenth of every height. On an edge
 * by halving.
 */
#include <math.h>

#include "engine/sided.h"

#define NOTHING 1e-13               /* of a parameter: this is on the edge */

static double height_at(const loft_lattice_edge *e, const double p[2])
{
    return e->normal.at[0] * p[0] + e->normal.at[1] * p[1] + e->offset;
}

/* The sum of log h_j normal_j, and its derivatives xx, xy, yy. */
static void sum_logs(const loft_lattice_polygon *l, const double p[2], double sum[2], double by[3])
{
    sum[0] = sum[1] = by[0] = by[1] = by[2] = 0;
    for (unsigned j = 0; j < l->sides; j++) {
        const double h = height_at(&l->edge[j], p), x = l->edge[j].normal.at[0],
                     y = l->edge[j].normal.at[1];
        sum[0] += x * log(h);
        sum[1] += y * log(h);
        by[0] += x * x / h;
        by[1] += x * y / h;
        by[2] += y * y / h;
    }
}

/* How much of the step keeps a tenth of every height. */
static double share_of_step(const loft_lattice_polygon *l, const double p[2], const double step[2])
{
    double share = 1;

    for (unsigned j = 0; j < l->sides; j++) {
        const loft_lattice_edge *e = &l->edge[j];
        const double down = -(e->normal.at[0] * step[0] + e->normal.at[1] * step[1]);
        if (down * share > 0.9 * height_at(e, p))
            share = 0.9 * height_at(e, p) / down;
    }
    return share;
}

static void find_inside(const loft_lattice_polygon *l, const double target[2], double p[2])
{
    double sum[2], by[3];

    p[0] = p[1] = 0;
    for (unsigned j = 0; j < l->sides; j++)
        for (int k = 0; k < 2; k++)
            p[k] += (double)l->edge[j].from.at[k] / l->sides;
    for (int times = 0; times < 200; times++) {
        sum_logs(l, p, sum, by);
        const double x = target[0] - sum[0], y = target[1] - sum[1],
                     det = by[0] * by[2] - by[1] * by[1],
                     step[2] = { (by[2] * x - by[1] * y) / det, (by[0] * y - by[1] * x) / det };
        const double share = share_of_step(l, p, step);
        p[0] += share * step[0];
        p[1] += share * step[1];
        if (fabs(step[0]) + fabs(step[1]) < 1e-14)
            break;
    }
}

/* On an edge, between its first vertex (share 0) and its second: the sum along it grows. */
static void find_on_edge(const loft_lattice_polygon *l, unsigned edge, double target, double p[2])
{
    const loft_lattice_edge *e = &l->edge[edge];
    const int x = e->normal.at[1], y = -e->normal.at[0];
    double low = 0, high = e->length;

    for (int times = 0; times < 100; times++) {
        const double at = (low + high) / 2;
        double sum = 0;
        p[0] = e->from.at[0] + at * x;
        p[1] = e->from.at[1] + at * y;
        for (unsigned j = 0; j < l->sides; j++)
            if (j != edge)
                sum += (l->edge[j].normal.at[0] * x + l->edge[j].normal.at[1] * y) *
                       log(height_at(&l->edge[j], p));
        *(sum < target ? &low : &high) = at;
    }
}

static void point_of_polygon(const loft_lattice_polygon *l, unsigned vertex, double s, double t,
                             double out[2])
{
    const unsigned before = (vertex + l->sides - 1) % l->sides;
    const loft_whole *n = &l->edge[before].normal, *o = &l->edge[vertex].normal;
    const int det = n->at[0] * o->at[1] - n->at[1] * o->at[0];

    if (s < NOTHING && t < NOTHING) {
        out[0] = l->edge[vertex].from.at[0];
        out[1] = l->edge[vertex].from.at[1];
    } else if (t < NOTHING) {           /* only normal n has a part along edge `vertex` */
        find_on_edge(l, vertex, log(s) * det, out);
    } else if (s < NOTHING) {
        find_on_edge(l, before, -log(t) * det, out);
    } else {
        const double target[2] = { log(s) * n->at[0] + log(t) * o->at[0],
                                   log(s) * n->at[1] + log(t) * o->at[1] };
        find_inside(l, target, out);
    }
}

/* x^power over x^least */
static double over_least(double x, const int power[3], int k)
{
    const int one  = power[1] < power[0] ? power[1] : power[0],
              least = power[2] < one ? power[2] : one;
    return pow(x, power[k] - least);
}

/* The shares are as 1 : X : Y, products of powers of s and t. */
static void shares_of(const loft_lattice_polygon *l, unsigned vertex, double s, double t,
                      double out[2])
{
    const int8_t *n = l->edge[(vertex + l->sides - 1) % l->sides].normal.at,
                 *o = l->edge[vertex].normal.at;
    const int of_s[3] = { 0, n[0], n[1] }, of_t[3] = { 0, o[0], o[1] };
    double share[3], all = 0;

    for (int k = 0; k < 3; k++)
        all += share[k] = over_least(s, of_s, k) * over_least(t, of_t, k);
    for (int k = 0; k < 2; k++)
        out[k] = share[k] / all;
}

void sided_quarter(const surface *patch, const loft_lattice_polygon *lattice, unsigned vertex,
                   double s, double t, double out[2])
{
    if (patch->kind == SURFACE_BASEPOINT)
        shares_of(lattice, vertex, s, t, out);
    else
        point_of_polygon(lattice, vertex, s, t, out);
}
