/* tests/bench/bench.c -- time to walk a cubic, in ns per point: loft in q16 against itself and
 * against other libraries
 * SPDX-License-Identifier: MIT
 *
 * Each way walks the same cubics in n equal steps, including set-up, and stores its points. The
 * ways take turns in rounds, measured in CPU time. The table shows medians and the ratio to
 * loft_forward_run. The last column is the largest error in LSB (2^-16) over all points of all
 * curves at n = 1000, against long double; `-` if a way chooses its own points. Compiled once per
 * number of axes.
 */
#define _POSIX_C_SOURCE 199309L     /* clock_gettime */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "curve/bezier.h"
#include "curve/forward.h"

#ifdef BENCH_GSL
#  include <gsl/gsl_bspline.h>
#  include <gsl/gsl_spline.h>
#endif
#ifdef BENCH_CAIRO
#  include <cairo.h>
#endif

#define CURVES 32
#define MOST   1000
#define ROUNDS 15

static const unsigned counts[] = { 16, 64, MOST };
#define COUNTS (sizeof counts / sizeof counts[0])

static loft_cubic curve[CURVES];
static double     plain[CURVES][4][LOFT_AXES];      /* the same control points */
static loft_vec   fixed_out[MOST + 1];
static double     out[MOST + 64][LOFT_AXES];

/* A way walks curve `c` in n steps and returns the number of its points. */
typedef struct {
    const char *name;
    unsigned (*walk)(unsigned c, unsigned n);
    enum { FIXED, PLAIN, OTHER_POINTS } result;
} way;

/* ---- loft ---- */

static loft_bezier loft_curve(unsigned c)
{
    loft_bezier b;
    if (loft_bezier_init(&b, curve[c].p, 3) != LOFT_OK)
        abort();
    return b;
}

static unsigned walk_run(unsigned c, unsigned n)
{
    const loft_bezier b = loft_curve(c);
    loft_forward w;
    if (loft_forward_init(&w, &b, n) != LOFT_OK)
        abort();
    return loft_forward_run(&w, fixed_out, n);
}

static unsigned walk_next(unsigned c, unsigned n)
{
    const loft_bezier b = loft_curve(c);
    loft_forward w;
    unsigned j = 0;
    if (loft_forward_init(&w, &b, n) != LOFT_OK)
        abort();
    while (loft_forward_next(&w, &fixed_out[j]))
        j++;
    return j;
}

static unsigned walk_exact(unsigned c, unsigned n)
{
    const loft_bezier b = loft_curve(c);
    loft_forward_exact w;
    unsigned j = 0;
    if (loft_forward_exact_init(&w, &b, n) != LOFT_OK)
        abort();
    while (loft_forward_exact_next(&w, &fixed_out[j]))
        j++;
    return j;
}

static unsigned eval_points(unsigned c, unsigned n)
{
    for (unsigned j = 1; j <= n; j++)
        fixed_out[j - 1] = loft_cubic_eval(&curve[c], loft_unit_of(j, n));
    return n;
}

/* ---- plain double ---- */

static unsigned eval_horner(unsigned c, unsigned n)
{
    const double step = 1.0 / n;
    double a[4][LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        const double p0 = plain[c][0][i], p1 = plain[c][1][i], p2 = plain[c][2][i],
                     p3 = plain[c][3][i];
        a[0][i] = p0;
        a[1][i] = 3 * (p1 - p0);
        a[2][i] = 3 * (p2 - 2 * p1 + p0);
        a[3][i] = p3 - 3 * p2 + 3 * p1 - p0;
    }
    for (unsigned j = 1; j <= n; j++) {
        const double t = j * step;
        for (int i = 0; i < LOFT_AXES; i++)
            out[j - 1][i] = ((a[3][i] * t + a[2][i]) * t + a[1][i]) * t + a[0][i];
    }
    return n;
}

static unsigned eval_de_casteljau(unsigned c, unsigned n)
{
    const double step = 1.0 / n;

    for (unsigned j = 1; j <= n; j++) {
        const double t = j * step, s = 1 - t;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double q0 = s * plain[c][0][i] + t * plain[c][1][i],
                         q1 = s * plain[c][1][i] + t * plain[c][2][i];
            const double q2 = s * plain[c][2][i] + t * plain[c][3][i];
            const double r0 = s * q0 + t * q1, r1 = s * q1 + t * q2;
            out[j - 1][i] = s * r0 + t * r1;
        }
    }
    return n;
}

static unsigned add_differences(unsigned c, unsigned n)
{
    const double h = 1.0 / n;

    for (int i = 0; i < LOFT_AXES; i++) {
        const double p0 = plain[c][0][i], p1 = plain[c][1][i], p2 = plain[c][2][i],
                     p3 = plain[c][3][i];
        const double a1 = 3 * (p1 - p0) * h, a2 = 3 * (p2 - 2 * p1 + p0) * h * h,
                     a3 = (p3 - 3 * p2 + 3 * p1 - p0) * h * h * h;
        double d0 = p0, d1 = a1 + a2 + a3, d2 = 2 * a2 + 6 * a3;
        const double d3 = 6 * a3;
        for (unsigned j = 0; j < n; j++) {
            d0 += d1;
            d1 += d2;
            d2 += d3;
            out[j][i] = d0;
        }
    }
    return n;
}

/* ---- other libraries ---- */

#if defined(BENCH_AGG) && LOFT_AXES == 2
/* bench_agg.cpp */
unsigned bench_agg_curve4_inc(const double p[4][2], unsigned n, double (*points)[2]);

static unsigned agg_points(unsigned c, unsigned n)
{
    return bench_agg_curve4_inc((const double (*)[2])plain[c], n, out);
}
#endif

#ifdef BENCH_GSL
/* One span of a cubic B-spline with the knots 0 0 0 0 1 1 1 1 is the Bezier cubic. */
static unsigned gsl_bspline_way(unsigned c, unsigned n)
{
    static gsl_bspline_workspace *space;
    static gsl_vector *weight;

    if (!space) {
        space = gsl_bspline_alloc(4, 2);
        weight = gsl_vector_alloc(4);
        gsl_bspline_knots_uniform(0, 1, space);
    }
    for (unsigned j = 1; j <= n; j++) {
        gsl_bspline_eval((double)j / n, weight, space);
        for (int i = 0; i < LOFT_AXES; i++) {
            double sum = 0;
            for (unsigned k = 0; k < 4; k++)
                sum += gsl_vector_get(weight, k) * plain[c][k][i];
            out[j - 1][i] = sum;
        }
    }
    return n;
}

/* The natural cubic through the four points: another curve, but the same work. */
static unsigned gsl_cspline_way(unsigned c, unsigned n)
{
    static const double at[4] = { 0, 1.0 / 3, 2.0 / 3, 1 };
    static gsl_spline *spline;
    static gsl_interp_accel *near;
    double value[4];

    if (!spline) {
        spline = gsl_spline_alloc(gsl_interp_cspline, 4);
        near = gsl_interp_accel_alloc();
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        for (unsigned k = 0; k < 4; k++)
            value[k] = plain[c][k][i];
        gsl_spline_init(spline, at, value, 4);
        for (unsigned j = 1; j <= n; j++)
            out[j - 1][i] = gsl_spline_eval(spline, j == n ? 1 : (double)j / n, near);
    }
    return n;
}
#endif

#if defined(BENCH_CAIRO) && LOFT_AXES == 2
static cairo_t *pen;

static unsigned cairo_points(unsigned c, double tolerance)
{
    unsigned count = 0;

    cairo_set_tolerance(pen, tolerance);
    cairo_new_path(pen);
    cairo_move_to(pen, plain[c][0][0], plain[c][0][1]);
    cairo_curve_to(pen, plain[c][1][0], plain[c][1][1], plain[c][2][0], plain[c][2][1],
                   plain[c][3][0], plain[c][3][1]);
    cairo_path_t *path = cairo_copy_path_flat(pen);
    for (int i = 0; i < path->num_data; i += path->data[i].header.length)
        if (path->data[i].header.type == CAIRO_PATH_LINE_TO && count < MOST) {
            out[count][0] = path->data[i + 1].point.x;
            out[count++][1] = path->data[i + 1].point.y;
        }
    cairo_path_destroy(path);
    return count;
}

/* Cairo takes a tolerance, not a count: this uses the largest power of two that gives n points,
 * found beforehand. */
static unsigned cairo_way(unsigned c, unsigned n)
{
    static double found[CURVES][MOST + 1];

    if (!pen) {
        cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
        pen = cairo_create(surface);
        cairo_surface_destroy(surface);
    }
    if (found[c][n] <= 0) {
        found[c][n] = 64;
        while (found[c][n] > 1e-3 && cairo_points(c, found[c][n]) < n)
            found[c][n] /= 2;
    }
    return cairo_points(c, found[c][n]);
}
#endif

static const way ways[] = {
    { "loft_forward_run",         walk_run,         FIXED },
    { "loft_forward_next",        walk_next,        FIXED },
    { "loft_forward_exact_next",  walk_exact,       FIXED },
    { "loft_cubic_eval",          eval_points,      FIXED },
    { "double Horner",            eval_horner,      PLAIN },
    { "double de Casteljau",      eval_de_casteljau, PLAIN },
    { "double differences",       add_differences,  PLAIN },
#if defined(BENCH_AGG) && LOFT_AXES == 2
    { "AGG curve4_inc",           agg_points,       PLAIN },
#endif
#ifdef BENCH_GSL
    { "GSL bspline",              gsl_bspline_way,  PLAIN },
    { "GSL cspline",              gsl_cspline_way,  OTHER_POINTS },
#endif
#if defined(BENCH_CAIRO) && LOFT_AXES == 2
    { "cairo flattening",         cairo_way,        OTHER_POINTS },
#endif
};
#define WAYS (sizeof ways / sizeof ways[0])

/* ---- measuring ---- */

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* ns per point: all curves, repeated for 0.3 ms */
static double time_way(const way *w, unsigned n)
{
    static volatile unsigned sink;
    unsigned long points = 0;
    const double start = now_ns();
    double end;

    do {
        for (unsigned c = 0; c < CURVES; c++)
            points += sink = w->walk(c, n);
        end = now_ns();
    } while (end - start < 3e5);
    return (end - start) / (double)points;
}

static int compare_times(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double worst_error(const way *w, unsigned n)
{
    double worst = 0;

    for (unsigned c = 0; c < CURVES; c++) {
        if (w->walk(c, n) != n)
            return NAN;
        for (unsigned j = 1; j <= n; j++)
            for (int i = 0; i < LOFT_AXES; i++) {
                const long double t = (long double)j / n, s = 1 - t;
                const long double p = s * s * s * plain[c][0][i] + 3 * s * s * t * plain[c][1][i] +
                                      3 * s * t * t * plain[c][2][i] + t * t * t * plain[c][3][i];
                const double got = w->result == FIXED ? fixed_out[j - 1].axis[i] / 65536.0
                                                      : out[j - 1][i];
                const double off = 65536 * fabs((double)(got - p));
                if (worst < off)
                    worst = off;
            }
    }
    return worst;
}

int main(void)
{
    static double ns[WAYS][COUNTS][ROUNDS];
    uint32_t state = 1;

    for (unsigned c = 0; c < CURVES; c++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++) {
                /* the quick generator of Numerical Recipes */
                state = state * 1664525u + 1013904223u;
                curve[c].p[k].axis[i] = (loft_real)(state >> 6);    /* 0 .. 1024 */
                plain[c][k][i] = curve[c].p[k].axis[i] / 65536.0;
            }

    for (unsigned r = 0; r < ROUNDS; r++)
        for (unsigned q = 0; q < COUNTS; q++)
            for (unsigned w = 0; w < WAYS; w++)
                ns[w][q][r] = time_way(&ways[w], counts[q]);
    for (unsigned w = 0; w < WAYS; w++)
        for (unsigned q = 0; q < COUNTS; q++)
            qsort(ns[w][q], ROUNDS, sizeof(double), compare_times);

    printf("%d-D cubics, ns per point", LOFT_AXES);
    for (unsigned q = 0; q < COUNTS; q++)
        printf("%*s n = %-4u  ratio", q ? 1 : 4, "", counts[q]);
    printf("   error, LSB\n");
    for (unsigned w = 0; w < WAYS; w++) {
        printf("  %-26s", ways[w].name);
        for (unsigned q = 0; q < COUNTS; q++)
            printf(" %8.2f %7.2f", ns[w][q][ROUNDS / 2],
                   ns[w][q][ROUNDS / 2] / ns[0][q][ROUNDS / 2]);
        if (ways[w].result == OTHER_POINTS)
            printf("            -\n");
        else
            printf("   %10.3g\n", worst_error(&ways[w], MOST));
    }
    return 0;
}
