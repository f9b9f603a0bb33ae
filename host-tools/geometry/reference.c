/* host-tools/geometry/reference.c -- each kind of curve from its formula, in long double
 * SPDX-License-Identifier: MIT
 *
 * B-splines: de Boor's recurrence in homogeneous coordinates. Knots outside the curve's range are
 * used as they are.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/reference.h"

#define WIDE (CURVE_AXES + 1)       /* homogeneous: the weight is last */

static void blend_points(long double a[WIDE], const long double b[WIDE], long double t)
{
    for (int i = 0; i < WIDE; i++)
        a[i] += t * (b[i] - a[i]);
}

static void lift_point(const curve *c, unsigned k, long double out[WIDE])
{
    const long double w = curve_is_rational(c) ? (long double)c->point[k].w : 1;

    for (int i = 0; i < CURVE_AXES; i++)
        out[i] = w * (long double)c->point[k].p[i];
    out[CURVE_AXES] = w;
}

static void project_point(const long double p[WIDE], long double out[CURVE_AXES])
{
    for (int i = 0; i < CURVE_AXES; i++)
        out[i] = p[i] / p[CURVE_AXES];
}

static void eval_bezier(const curve *c, long double t, long double out[CURVE_AXES])
{
    long double b[CURVE_DEGREE_MAX + 1][WIDE];

    for (unsigned k = 0; k <= c->degree; k++)
        lift_point(c, k, b[k]);
    for (unsigned row = c->degree; row > 0; row--)
        for (unsigned k = 0; k < row; k++)
            blend_points(b[k], b[k + 1], t);
    project_point(b[0], out);
}

/* The last span with knot[s] < knot[s + 1] and knot[s] <= t, by bisection; the first span if t is
 * before it. */
static unsigned span_of(const curve *c, long double t)
{
    unsigned low = c->degree, high = c->count;      /* knot[low] <= t, or low is the first; t <
                                                     * knot[high], or high is the last */

    while (high - low > 1) {
        const unsigned middle = (low + high) / 2;
        if ((long double)c->knot[middle] <= t && c->knot[middle] < c->knot[c->count])
            low = middle;
        else
            high = middle;
    }
    while (!(c->knot[low] < c->knot[low + 1]))
        low++;
    return low;
}

static void eval_bspline(const curve *c, long double t, long double out[CURVE_AXES])
{
    const unsigned n = c->degree;
    const unsigned s = span_of(c, t);
    long double d[CURVE_DEGREE_MAX + 1][WIDE];

    for (unsigned k = 0; k <= n; k++)
        lift_point(c, s - n + k, d[k]);
    for (unsigned row = 1; row <= n; row++)
        for (unsigned k = n; k >= row; k--) {
            const long double from = (long double)c->knot[s - n + k],
                              to = (long double)c->knot[s + 1 + k - row];
            long double p[WIDE];
            memcpy(p, d[k - 1], sizeof p);
            blend_points(p, d[k], (t - from) / (to - from));
            memcpy(d[k], p, sizeof p);
        }
    project_point(d[n], out);
}

static long double point_distance(const double a[CURVE_AXES], const double b[CURVE_AXES])
{
    long double sum = 0;

    for (int i = 0; i < CURVE_AXES; i++)
        sum += ((long double)b[i] - (long double)a[i]) * ((long double)b[i] - (long double)a[i]);
    return sqrtl(sum);
}

static void eval_parabola(const curve *c, long double t, long double out[CURVE_AXES])
{
    memset(out, 0, CURVE_AXES * sizeof *out);
    for (int k = 0; k < 3; k++) {
        long double weight = 1;
        for (int j = 0; j < 3; j++)
            if (j != k)
                weight *= (t - (long double)c->point[j].w) /
                          ((long double)c->point[k].w - (long double)c->point[j].w);
        for (int i = 0; i < CURVE_AXES; i++)
            out[i] += weight * (long double)c->point[k].p[i];
    }
}

static void eval_hermite(const reference *r, unsigned k, long double t, long double out[CURVE_AXES])
{
    const curve_point *a = &r->c->point[k], *b = a + 1;
    const long double t2 = t * t, t3 = t2 * t, t4 = t2 * t2, t5 = t4 * t;
    const bool five      = r->c->kind == CURVE_HERMITE5;
    const long double f1 = five ? 10*t3 - 15*t4 + 6*t5 : 3*t2 - 2*t3;
    const long double g0 = five ? t - 6 * t3 + 8 * t4 - 3 * t5 : t - 2 * t2 + t3,
                      g1 = five ? -4 * t3 + 7 * t4 - 3 * t5 : t3 - t2;
    const long double h0 = five ? (t2 - 3 * t3 + 3 * t4 - t5) / 2 : 0,
                      h1 = five ? (t3 - 2 * t4 + t5) / 2 : 0;

    for (int i = 0; i < CURVE_AXES; i++)
        out[i] = (1 - f1) * (long double)a->p[i] + f1 * (long double)b->p[i] +
                 g0 * (long double)a->d[0][i] + g1 * (long double)b->d[0][i] +
                 h0 * (long double)a->d[1][i] + h1 * (long double)b->d[1][i];
}

/* From point k + 1 to k + 2 with the slopes s (P[k+2] - P[k]) and s (P[k+3] - P[k+1]), s = (1 -
 * tension) / 2. */
static void cardinal_slopes(const curve *c, const curve_point p[], int i, long double slope[2])
{
    const long double s = (1 - (long double)c->tension) / 2;

    for (int k = 0; k < 2; k++)
        slope[k] = s * ((long double)p[k + 2].p[i] - (long double)p[k].p[i]);
}

/* Kochanek and Bartels (1984). */
static void tcb_slopes(const curve_point p[], int i, long double slope[2])
{
    for (int k = 0; k < 2; k++) {
        const double *way   = p[k + 1].d[0];
        const long double t = 1 - (long double)way[0], c = k ? -(long double)way[1] : way[1],
                          b = (long double)way[2];
        slope[k] = t * (1 + c) * (1 + b) / 2 * ((long double)p[k + 1].p[i] - p[k].p[i]) +
                   t * (1 - c) * (1 - b) / 2 * ((long double)p[k + 2].p[i] - p[k + 1].p[i]);
    }
}

/* Knots with the steps |P[i+1] - P[i]|^alpha: the slopes of the parabolas through three points. */
static void catmull_slopes(const curve *c, const curve_point p[], int i, long double slope[2])
{
    long double h[3], d[3];

    for (int k = 0; k < 3; k++) {
        h[k] = powl(point_distance(p[k].p, p[k + 1].p), (long double)c->tension);
        d[k] = ((long double)p[k + 1].p[i] - (long double)p[k].p[i]) / h[k];
    }
    for (int k = 0; k < 2; k++)
        slope[k] = h[1] *
                   (d[k] + d[k + 1] -
                    ((long double)p[k + 2].p[i] - (long double)p[k].p[i]) / (h[k] + h[k + 1]));
}

/* Between two points with slopes. */
static void eval_between(const curve_point p[], int i, const long double d[2], long double t,
                         long double out[CURVE_AXES])
{
    const long double a = p[1].p[i], b = p[2].p[i];

    out[i] = a + t * (d[0] + t * (3 * (b - a) - 2 * d[0] - d[1] + t * (2 * (a - b) + d[0] + d[1])));
}

static void eval_cardinal(const reference *r, unsigned k, long double t,
                          long double out[CURVE_AXES])
{
    for (int i = 0; i < CURVE_AXES; i++) {
        long double d[2];
        cardinal_slopes(r->c, &r->c->point[k], i, d);
        eval_between(&r->c->point[k], i, d, t, out);
    }
}

static void eval_tcb(const reference *r, unsigned k, long double t, long double out[CURVE_AXES])
{
    for (int i = 0; i < CURVE_AXES; i++) {
        long double d[2];
        tcb_slopes(&r->c->point[k], i, d);
        eval_between(&r->c->point[k], i, d, t, out);
    }
}

static void eval_catmull(const reference *r, unsigned k, long double t, long double out[CURVE_AXES])
{
    for (int i = 0; i < CURVE_AXES; i++) {
        long double d[2];
        catmull_slopes(r->c, &r->c->point[k], i, d);
        eval_between(&r->c->point[k], i, d, t, out);
    }
}

static void eval_line(const reference *r, unsigned k, long double t, long double out[CURVE_AXES])
{
    const curve_point *p = &r->c->point[k];

    for (int i = 0; i < CURVE_AXES; i++)
        out[i] = (long double)p[0].p[i] + t * ((long double)p[1].p[i] - (long double)p[0].p[i]);
}

/* Rotate about the centre by the fraction of the sweep. The difference of the radii at both ends,
 * and the other axes, change in proportion. */
static void eval_arc(const curve *c, long double t, long double out[CURVE_AXES])
{
    const curve_point *p = c->point;
    const long double a[2] = { (long double)p[0].p[0] - (long double)p[1].p[0],
                               (long double)p[0].p[1] - (long double)p[1].p[1] };
    const long double z[2] = { (long double)p[2].p[0] - (long double)p[1].p[0],
                               (long double)p[2].p[1] - (long double)p[1].p[1] };
    const long double way  = c->turns > 0 ? 1 : -1, turn = 2 * acosl(-1);
    long double sweep = way * atan2l(a[0] * z[1] - a[1] * z[0], a[0] * z[0] + a[1] * z[1]);

    if (sweep < 1e-14L)
        sweep += turn;
    sweep += turn * (fabsl((long double)c->turns) - 1);
    const long double angle = way * t * sweep, last = way * sweep;
    out[0] = (long double)p[1].p[0] + a[0] * cosl(angle) - a[1] * sinl(angle) +
             t * (z[0] - a[0] * cosl(last) + a[1] * sinl(last));
    out[1] = (long double)p[1].p[1] + a[0] * sinl(angle) + a[1] * cosl(angle) +
             t * (z[1] - a[0] * sinl(last) - a[1] * cosl(last));
    out[2] = (long double)p[0].p[2] + t * ((long double)p[2].p[2] - (long double)p[0].p[2]);
}

/* A kind by its definition: prepared or not; a point of piece k, or of the whole curve. */
static const struct {
    bool (*init)(reference *r);
    void (*eval)(const reference *r, unsigned k, long double local, long double out[CURVE_AXES]);
    void (*eval_at)(const curve *c, long double t, long double out[CURVE_AXES]);
} definitions[CURVE_KINDS] = {
    [CURVE_BEZIER]   = { .eval_at = eval_bezier },
    [CURVE_LINE]     = { .eval = eval_line },
    [CURVE_RATIONAL] = { .eval_at = eval_bezier },
    [CURVE_PARABOLA] = { .eval_at = eval_parabola },
    [CURVE_HERMITE3] = { .eval = eval_hermite },
    [CURVE_HERMITE5] = { .eval = eval_hermite },
    [CURVE_CARDINAL] = { .eval = eval_cardinal },
    [CURVE_NATURAL]  = { reference_spline_init, .eval = reference_spline_eval },
    [CURVE_CHORD]    = { reference_spline_init, .eval = reference_spline_eval },
    [CURVE_BSPLINE]  = { .eval_at = eval_bspline },
    [CURVE_NURBS]    = { .eval_at = eval_bspline },
    [CURVE_ARC]      = { .eval_at = eval_arc },
    [CURVE_SPLINE]   = { reference_spline_init, .eval = reference_spline_eval },
    [CURVE_TCB]      = { .eval = eval_tcb },
    [CURVE_CATMULL]  = { .eval = eval_catmull },
};

bool reference_init(reference *r, const curve *c)
{
    *r = (reference){ .c = c };
    return definitions[c->kind].init == NULL || definitions[c->kind].init(r);
}

void reference_free(reference *r)
{
    free(r->step);
    free(r->second);
    *r = (reference){ 0 };
}

void reference_eval(const reference *r, long double t, long double out[CURVE_AXES])
{
    const enum curve_kind kind = r->c->kind;
    long double local;

    if (definitions[kind].eval_at != NULL) {
        definitions[kind].eval_at(r->c, t, out);
        return;
    }
    const unsigned k = curve_locate(r->c, t, &local);
    definitions[kind].eval(r, k, local, out);
}
