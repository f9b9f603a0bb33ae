/* tests/bench/bench_peers.c -- flattening, nearest points, crossings and B-splines of loft in
 * double beside other libraries
 * SPDX-License-Identifier: MIT
 *
 * Each way gets the same curves and the same tolerance. The ways take turns in rounds, measured in
 * CPU time. A row is the median time, its ratio to that of loft, how much came out, and the largest
 * error that was found against dense samples or sums in long double.
 */
#define _POSIX_C_SOURCE 199309L     /* clock_gettime */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "bench_peers.h"
#include "curve/bspline.h"
#include "curve/forward.h"
#include "curve/intersect.h"
#include "curve/measure.h"
#include "curve/nearest.h"

#ifdef BENCH_GSL
#  include <gsl/gsl_bspline.h>
#endif
#ifdef BENCH_CAIRO
#  include <cairo.h>
#endif
#ifdef BENCH_SISL
#  include <sisl.h>
#endif

#define CURVES  64
#define ROUNDS  7
#define SAMPLES 2000
#define FLAT    0.01        /* tolerance of chords                      */
#define FINE    1e-6        /* of nearest points and crossings          */
#define POINTS  10          /* of a B-spline                            */
#define DEGREE  3
#define PLACES  64          /* on it                                    */

static double curve[CURVES][4][2], from[CURVES][2];
static const double knots[POINTS + DEGREE + 1] = { 0, 0, 0, 0, 1, 2.5, 3, 4.25, 5, 6, 8, 8, 8, 8 };
static double spline[POINTS][2], place[PLACES];

/* What a way finds for input c. */
static double found[MOST][4];

typedef struct {
    const char *name;
    unsigned (*run)(unsigned c);
} way;

static double place_of(double p[4][2], double t, int i)
{
    const double s = 1 - t;
    return s * s * s * p[0][i] + 3 * s * s * t * p[1][i] + 3 * s * t * t * p[2][i] +
           t * t * t * p[3][i];
}

/* ---- loft ---- */

/* The points are borrowed. */
static loft_bezier loft_curve(unsigned c, loft_vec p[4])
{
    loft_bezier b;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            p[k].axis[i] = curve[c][k][i];
    if (loft_bezier_init(&b, p, 3) != LOFT_OK)
        abort();
    return b;
}

static unsigned loft_flat(unsigned c)
{
    loft_cubic cubic;
    loft_flatten f;
    loft_vec p;
    unsigned n = 0;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            cubic.p[k].axis[i] = curve[c][k][i];
    if (loft_flatten_init(&f, &cubic, FLAT) != LOFT_OK)
        abort();
    for (; loft_flatten_next(&f, &p); n++) {
        found[n][0] = p.axis[0];
        found[n][1] = p.axis[1];
    }
    return n;
}

static unsigned loft_steps(unsigned c)
{
    static loft_vec at[MOST];
    loft_vec p[4];
    const loft_bezier b = loft_curve(c, p);
    loft_forward w;

    if (loft_forward_flatten(&w, &b, FLAT) != LOFT_OK)
        abort();
    const unsigned n = loft_forward_run(&w, at, MOST);
    for (unsigned k = 0; k < n; k++) {
        found[k][0] = at[k].axis[0];
        found[k][1] = at[k].axis[1];
    }
    return n;
}

static unsigned loft_near(unsigned c)
{
    loft_vec p[4];
    const loft_bezier b = loft_curve(c, p);
    loft_nearest at;

    if (loft_bezier_nearest(&b, (loft_vec){ { from[c][0], from[c][1] } }, FINE, &at) != LOFT_OK)
        abort();
    found[0][0] = at.t;
    return 1;
}

static unsigned loft_cross(unsigned c)
{
    loft_vec p[4], q[4];
    const loft_bezier a = loft_curve(c, p), b = loft_curve((c + 1) % CURVES, q);
    loft_crossing at[9];
    size_t count;

    if (loft_bezier_intersect(&a, &b, FINE, at, 9, &count) != LOFT_OK)
        abort();
    for (size_t k = 0; k < count; k++) {
        found[k][0] = at[k].s;
        found[k][1] = at[k].t;
    }
    return (unsigned)count;
}

static unsigned loft_spline(unsigned c)
{
    loft_vec p[POINTS];
    loft_bspline b;

    (void)c;
    for (int k = 0; k < POINTS; k++)
        for (int i = 0; i < 2; i++)
            p[k].axis[i] = spline[k][i];
    if (loft_bspline_init(&b, p, POINTS, knots, DEGREE) != LOFT_OK)
        abort();
    for (int n = 0; n < PLACES; n++) {
        const loft_vec at = loft_bspline_eval(&b, place[n]);
        found[n][0] = at.axis[0];
        found[n][1] = at.axis[1];
    }
    return PLACES;
}

/* ---- other libraries ---- */

#ifdef BENCH_AGG
static unsigned agg_flat(unsigned c) { return bench_agg_curve4_div(curve[c], FLAT, found); }
#endif
#ifdef BENCH_OCCT
static unsigned occt_flat(unsigned c)   { return bench_occt_flat(curve[c], FLAT, found); }
static unsigned occt_near(unsigned c)   { return bench_occt_near(curve[c], from[c], found); }
static unsigned occt_spline(unsigned c)
{
    (void)c;
    return bench_occt_spline(spline, POINTS, knots, DEGREE, place, PLACES, found);
}
static unsigned occt_cross(unsigned c)
{
    return bench_occt_cross(curve[c], curve[(c + 1) % CURVES], FINE, found);
}
#endif
#ifdef BENCH_RUST
static unsigned lyon_flat(unsigned c)  { return bench_lyon_flat(curve[c], FLAT, found); }
static unsigned kurbo_flat(unsigned c) { return bench_kurbo_flat(curve[c], FLAT, found); }
static unsigned kurbo_near(unsigned c) { return bench_kurbo_near(curve[c], from[c], FINE, found); }
static unsigned lyon_cross(unsigned c)
{
    return bench_lyon_cross(curve[c], curve[(c + 1) % CURVES], found);
}
#endif

#ifdef BENCH_CAIRO
static unsigned cairo_flat(unsigned c)
{
    static cairo_t *pen;
    unsigned n = 0;

    if (!pen) {
        cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
        pen = cairo_create(surface);
        cairo_surface_destroy(surface);
        cairo_set_tolerance(pen, FLAT);
    }
    cairo_new_path(pen);
    cairo_move_to(pen, curve[c][0][0], curve[c][0][1]);
    cairo_curve_to(pen, curve[c][1][0], curve[c][1][1], curve[c][2][0], curve[c][2][1],
                   curve[c][3][0], curve[c][3][1]);
    cairo_path_t *path = cairo_copy_path_flat(pen);
    for (int i = 0; i < path->num_data; i += path->data[i].header.length)
        if (path->data[i].header.type == CAIRO_PATH_LINE_TO && n < MOST) {
            found[n][0] = path->data[i + 1].point.x;
            found[n++][1] = path->data[i + 1].point.y;
        }
    cairo_path_destroy(path);
    return n;
}
#endif

#ifdef BENCH_GSL
static unsigned gsl_spline(unsigned c)
{
    static gsl_bspline_workspace *space;
    static gsl_vector *weight;

    (void)c;
    if (!space) {
        gsl_vector_const_view breaks = gsl_vector_const_view_array(knots + DEGREE,
                                                                   POINTS - DEGREE + 1);
        space = gsl_bspline_alloc(DEGREE + 1, POINTS - DEGREE + 1);
        weight = gsl_vector_alloc(DEGREE + 1);
        gsl_bspline_knots(&breaks.vector, space);
    }
    for (int n = 0; n < PLACES; n++) {
        size_t first, last;
        gsl_bspline_eval_nonzero(place[n], weight, &first, &last, space);
        found[n][0] = found[n][1] = 0;
        for (size_t k = first; k <= last; k++)
            for (int i = 0; i < 2; i++)
                found[n][i] += gsl_vector_get(weight, k - first) * spline[k][i];
    }
    return PLACES;
}
#endif

#ifdef BENCH_SISL
static SISLCurve *sisl_curve(unsigned c)
{
    static double ends[8] = { 0, 0, 0, 0, 1, 1, 1, 1 };
    return newCurve(4, 4, ends, &curve[c][0][0], 1, 2, 0);
}

static unsigned sisl_near(unsigned c)
{
    SISLCurve *b = sisl_curve(c);
    SISLIntcurve **along = NULL;
    double *t = NULL;
    unsigned n = 0;
    int points = 0, curves = 0, status;

    s1953(b, from[c], 2, FINE, FINE, &points, &t, &curves, &along, &status);
    for (; n < (unsigned)points && n < MOST; n++)
        found[n][0] = t[n];
    free(t);
    freeIntcrvlist(along, curves);
    freeCurve(b);
    return n;
}

static unsigned sisl_cross(unsigned c)
{
    SISLCurve *a = sisl_curve(c), *b = sisl_curve((c + 1) % CURVES);
    SISLIntcurve **along = NULL;
    double *s = NULL, *t = NULL;
    unsigned n = 0;
    int points = 0, curves = 0, status;

    s1857(a, b, FINE, FINE, &points, &s, &t, &curves, &along, &status);
    for (; n < (unsigned)points && n < MOST; n++) {
        found[n][0] = s[n];
        found[n][1] = t[n];
    }
    free(s);
    free(t);
    freeIntcrvlist(along, curves);
    freeCurve(a);
    freeCurve(b);
    return n;
}

static unsigned sisl_spline(unsigned c)
{
    SISLCurve *b = newCurve(POINTS, DEGREE + 1, (double *)knots, &spline[0][0], 1, 2, 0);
    int left = 0, status;

    (void)c;
    for (int n = 0; n < PLACES; n++)
        s1227(b, 0, place[n], &left, found[n], &status);
    freeCurve(b);
    return PLACES;
}
#endif

/* ---- errors ---- */

static double distance_to_chord(double x, double y, const double a[2], const double b[2])
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / square : 0;

    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

/* In tolerances. */
static double error_flat(unsigned c, unsigned n)
{
    double worst = 0;

    for (int k = 0; k <= SAMPLES; k++) {
        const double t = (double)k / SAMPLES, x = place_of(curve[c], t, 0),
                     y = place_of(curve[c], t, 1);
        double least = INFINITY;
        for (unsigned j = 0; j < n; j++)
            least = fmin(least, distance_to_chord(x, y, j ? found[j - 1] : curve[c][0], found[j]));
        worst = fmax(worst, least);
    }
    return worst / FLAT;
}

static double away(unsigned c, double t)
{
    return hypot(place_of(curve[c], t, 0) - from[c][0], place_of(curve[c], t, 1) - from[c][1]);
}

/* Beyond the nearest place by samples, halved intervals around the best. */
static double error_near(unsigned c, unsigned n)
{
    double best = 0, step = 1.0 / SAMPLES, least = INFINITY;

    for (int k = 0; k <= SAMPLES; k++)
        if (away(c, k * step) < away(c, best))
            best = k * step;
    for (; step > 1e-12; step /= 2)
        for (int side = -1; side <= 1; side += 2)
            if (best + side * step >= 0 && best + side * step <= 1 &&
                away(c, best + side * step) < away(c, best))
                best += side * step;
    for (unsigned k = 0; k < n; k++)
        least = fmin(least, away(c, found[k][0]));
    return least - away(c, best);
}

static double error_cross(unsigned c, unsigned n)
{
    const unsigned d = (c + 1) % CURVES;
    double worst = 0;

    for (unsigned k = 0; k < n; k++)
        worst = fmax(
            worst, hypot(place_of(curve[c], found[k][0], 0) - place_of(curve[d], found[k][1], 0),
                         place_of(curve[c], found[k][0], 1) - place_of(curve[d], found[k][1], 1)));
    return worst;
}

/* de Boor's algorithm in long double */
static double error_spline(unsigned c, unsigned n)
{
    double worst = 0;

    (void)c;
    for (unsigned q = 0; q < n; q++)
        for (int i = 0; i < 2; i++) {
            long double d[DEGREE + 1];
            int at = DEGREE;
            while (at < POINTS - 1 && place[q] >= knots[at + 1])
                at++;
            for (int k = 0; k <= DEGREE; k++)
                d[k] = spline[at - DEGREE + k][i];
            for (int r = 1; r <= DEGREE; r++)
                for (int k = DEGREE; k >= r; k--) {
                    const long double low = knots[at - DEGREE + k], high = knots[at + 1 + k - r],
                                      t = (place[q] - low) / (high - low);
                    d[k] = (1 - t) * d[k - 1] + t * d[k];
                }
            worst = fmax(worst, fabs((double)(found[q][i] - d[DEGREE])));
        }
    return worst;
}

/* ---- measuring ---- */

static double now_us(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static double time_way(const way *w, unsigned inputs)
{
    unsigned long runs = 0;
    const double start = now_us();
    double end;

    do {
        for (unsigned c = 0; c < inputs; c++)
            (void)w->run(c);
        runs += inputs;
        end = now_us();
    } while (end - start < 2000);
    return (end - start) / (double)runs;
}

static int compare_times(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void compare(const char *title, const char *what, const char *error, const way ways[],
                    unsigned inputs, double (*error_of)(unsigned, unsigned))
{
    double us[8][ROUNDS];
    unsigned n = 0;

    while (ways[n].name)
        n++;
    for (int r = 0; r < ROUNDS; r++)
        for (unsigned w = 0; w < n; w++)
            us[w][r] = time_way(&ways[w], inputs);
    for (unsigned w = 0; w < n; w++)
        qsort(us[w], ROUNDS, sizeof us[w][0], compare_times);
    fflush(stdout);
    printf("%-28s %10s %7s %10s   %s\n", title, "us", "ratio", what, error);
    for (unsigned w = 0; w < n; w++) {
        unsigned total = 0;
        double worst = 0;
        for (unsigned c = 0; c < inputs; c++) {
            const unsigned got = ways[w].run(c);
            total += got;
            worst = fmax(worst, error_of(c, got));
        }
        printf("  %-26s %10.3f %7.2f %10u   %.3g\n", ways[w].name, us[w][ROUNDS / 2],
               us[w][ROUNDS / 2] / us[0][ROUNDS / 2], total, worst);
    }
}

static double any(double most)
{
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;     /* the quick generator of Numerical Recipes */
    return most * (state >> 8) / 16777216.0;
}

int main(void)
{
    static const way flat[] = {
        { "loft_forward_flatten", loft_steps },
        { "loft_flatten_next", loft_flat },
#ifdef BENCH_AGG
        { "AGG curve4_div", agg_flat },
#endif
#ifdef BENCH_CAIRO
        { "cairo", cairo_flat },
#endif
#ifdef BENCH_RUST
        { "lyon_geom", lyon_flat },
        { "kurbo", kurbo_flat },
#endif
#ifdef BENCH_OCCT
        { "OCCT QuasiUniformDeflection", occt_flat },
#endif
        { NULL, NULL },
    };
    static const way near[] = {
        { "loft_bezier_nearest", loft_near },
#ifdef BENCH_RUST
        { "kurbo", kurbo_near },
#endif
#ifdef BENCH_SISL
        { "SISL s1953", sisl_near },
#endif
#ifdef BENCH_OCCT
        { "OCCT ProjectPointOnCurve", occt_near },
#endif
        { NULL, NULL },
    };
    static const way cross[] = {
        { "loft_bezier_intersect", loft_cross },
#ifdef BENCH_RUST
        { "lyon_geom, 1e-9 of t", lyon_cross },
#endif
#ifdef BENCH_SISL
        { "SISL s1857", sisl_cross },
#endif
#ifdef BENCH_OCCT
        { "OCCT InterCurveCurve", occt_cross },
#endif
        { NULL, NULL },
    };
    static const way splines[] = {
        { "loft_bspline_eval", loft_spline },
#ifdef BENCH_GSL
        { "GSL bspline", gsl_spline },
#endif
#ifdef BENCH_SISL
        { "SISL s1227", sisl_spline },
#endif
#ifdef BENCH_OCCT
        { "OCCT D0", occt_spline },
#endif
        { NULL, NULL },
    };

    for (unsigned c = 0; c < CURVES; c++)
        for (int i = 0; i < 2; i++) {
            for (int k = 0; k < 4; k++)
                curve[c][k][i] = any(1024);
            from[c][i] = any(1024);
        }
    for (int k = 0; k < POINTS; k++)
        for (int i = 0; i < 2; i++)
            spline[k][i] = any(1024);
    for (int n = 0; n < PLACES; n++)
        place[n] = any(8);
    compare("a curve, chords of 0.01", "chords", "farthest, tolerances", flat, CURVES, error_flat);
    compare("the nearest point, 1e-6", "points", "too far by", near, CURVES, error_near);
    compare("crossings of two, 1e-6", "crossings", "widest gap", cross, CURVES, error_cross);
    compare("64 points of a B-spline", "points", "error", splines, 1, error_spline);
    return 0;
}
