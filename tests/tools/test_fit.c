/* tests/tools/test_fit.c -- curves near measured points: within the tolerance, corners kept, seams
 * smooth
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "tools/drawn.h"
#include "base/space.h"
#include "base/tool.h"          /* tool_grow */
#include "num/status.h"         /* LOFT_OK */
#include "fit/grid_fit.h"
#include "fit/point_fit.h"
#include "fit/scatter_fit.h"

#define MOST  600
#define LOOKS 40

typedef struct {
    double p[MOST][ENGINE_AXES], tol;
    point_row row;
    size_t parts, seen, smooth_seams, control;
    double end[ENGINE_AXES], start[ENGINE_AXES];
    double low[2], high[2];     /* of the curves */
    bool near, whole;
} fitted;

static double random_unit(arb *a) { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* Each part begins where the one before ended, at a point of the row, and is near its points. */
static int take_part(void *context, const spline_fit *f)
{
    fitted *x = context;
    double at[ENGINE_AXES], slope[ENGINE_AXES], end[ENGINE_AXES], last[ENGINE_AXES];

    x->control += f->intervals + (f->closed ? 0 : f->degree - 1);
    for (size_t k = 0; k < f->intervals; k++)
        for (int j = 0; j <= LOOKS; j++) {
            spline_fit_eval(f, k, f->knot[k] + (f->knot[k + 1] - f->knot[k]) * j / LOOKS, at,
                            slope);
            for (int i = 0; i < 2; i++) {
                x->low[i]  = fmin(x->low[i], at[i]);
                x->high[i] = fmax(x->high[i], at[i]);
            }
        }
    spline_fit_eval(f, 0, 0, at, slope);
    spline_fit_eval(f, f->intervals - 1, f->knot[f->intervals], end, last);
    x->near = x->near && spline_fit_error(f) <= x->tol;
    if (f->closed)
        x->smooth_seams += space_distance(at, end) < 1e-9 && space_distance(slope, last) < 1e-9;
    else
        x->whole = x->whole && space_distance(at, f->p[0]) < 1e-9 &&
                   space_distance(end, f->p[f->count - 1]) < 1e-9 &&
                   (x->parts == 0 || space_distance(at, x->end) < 1e-9);
    if (x->parts++ == 0)
        memcpy(x->start, at, sizeof at);
    memcpy(x->end, end, sizeof end);
    x->seen += f->count - 1;
    return 0;
}

/* With the tolerance, or with the one that the refusal names; false: with none. */
static bool run_wider_fit(fitted *x, unsigned degree)
{
    point_fit_options o = { x->tol, 50 * 3.14159 / 180, degree };
    spline_fit f = { .e = &engine_f64 };
    int code;

    x->near = x->whole = true;
    x->row.p = x->p;
    code = point_fit(&x->row, &o, &f, take_part, x);
    if (code == POINT_FIT_NOISY) {
        CHECK(x->parts == 0);
        o.tol = x->tol = point_fit_enough(&x->row, &o, 1e4, &f);
        code = o.tol > 0 ? point_fit(&x->row, &o, &f, take_part, x) : POINT_FIT_NOISY;
    }
    spline_fit_free(&f);
    CHECK(code == 0 || (code == POINT_FIT_NOISY && !(o.tol > 0)));
    return code == 0;
}

static void check_parts(const fitted *x)
{
    CHECK(x->near && x->whole);
    CHECK(x->seen == x->row.count - (x->row.closed ? 0 : 1));
}

static void run_fit(fitted *x, unsigned degree)
{
    const double tol = x->tol;

    CHECK(run_wider_fit(x, degree) && !(x->tol > tol));
    check_parts(x);
}

static void add_noisy(fitted *x, arb *a, double px, double py, double noise)
{
    double *p = x->p[x->row.count++];

    p[0] = px + noise * (2 * random_unit(a) - 1);
    p[1] = py + noise * (2 * random_unit(a) - 1);
    p[2] = 0;
}

/* A polygon with measured sides: as many parts as sides, and corners stay. */
static void corners_are_kept(arb *a)
{
    static fitted x;
    const unsigned sides = 3 + arb_below(a, 3), each = 20 + arb_below(a, 60);
    const double tol = 0.05, size = 20 + 50 * random_unit(a);

    x = (fitted){ .tol = tol, .row = { .closed = true } };
    for (unsigned k = 0; k < sides; k++)
        for (unsigned j = 0; j < each; j++) {
            const double t = (double)j / each, from = 6.283185307179586 * k / sides,
                         to = 6.283185307179586 * (k + 1) / sides;
            add_noisy(&x, a, size * (cos(from) + t * (cos(to) - cos(from))),
                      size * (sin(from) + t * (sin(to) - sin(from))), tol / 4);
        }
    run_fit(&x, 1 + arb_below(a, 5));
    CHECK(x.parts == sides);
    CHECK(space_distance(x.start, x.end) < 1e-9);
}

/* A circle measured with noise is one closed curve with a smooth seam. */
static void circles_have_a_smooth_seam(arb *a)
{
    static fitted x;
    const double tol = 0.05, size = 20 + 50 * random_unit(a);
    const unsigned count = 100 + arb_below(a, 400);

    x = (fitted){ .tol = tol, .row = { .closed = true } };
    for (unsigned k = 0; k < count; k++)
        add_noisy(&x, a, size * cos(6.283185307179586 * k / count),
                  size * sin(6.283185307179586 * k / count), tol / 4);
    run_fit(&x, 2 + arb_below(a, 4));
    CHECK(x.parts == 1 && x.smooth_seams == 1);
}

/* Waves are one curve; what turns at once is cut there. */
static void waves_are_one_curve(arb *a)
{
    static fitted x;
    const double tol = 0.02 + random_unit(a) / 10, high = 10 * random_unit(a);
    const unsigned count = 100 + arb_below(a, 400);

    x = (fitted){ .tol = tol };
    for (unsigned k = 0; k < count; k++)
        add_noisy(&x, a, k * 0.3, high * sin(k / 20.0), tol / 4);
    run_fit(&x, 3);
    CHECK(x.parts == 1);
}

/* Whatever is given, each point is near the curves, or they are refused, and a tolerance is named
 * that suffices. */
static void any_points_are_met_or_refused(arb *a)
{
    static fitted x;

    x = (fitted){ .tol = 0.01 + random_unit(a), .row = { .closed = arb_below(a, 2) } };
    for (unsigned k = 3 + arb_below(a, 60); k > 0; k--)
        add_noisy(&x, a, 0, 0, 30);
    if (run_wider_fit(&x, 1 + arb_below(a, 9)))
        check_parts(&x);
}

/* The box of the points holds the curve, but for 5 tolerances and 0.87 of the longest gap. There
 * are fewer control points than points. */
static void check_shape(const fitted *x)
{
    double low[2] = { INFINITY, INFINITY }, high[2] = { -INFINITY, -INFINITY }, gap = 0;

    for (size_t k = 0; k < x->row.count; k++)
        for (int i = 0; i < 2; i++) {
            low[i]  = fmin(low[i], x->p[k][i]);
            high[i] = fmax(high[i], x->p[k][i]);
            gap     = fmax(gap, k > 0 ? space_distance(x->p[k], x->p[k - 1]) : 0);
        }
    if (x->row.closed)
        gap = fmax(gap, space_distance(x->p[0], x->p[x->row.count - 1]));
    for (int i = 0; i < 2; i++)
        CHECK(x->low[i] > low[i] - 5 * x->tol - 0.87 * gap &&
              x->high[i] < high[i] + 5 * x->tol + 0.87 * gap);
    CHECK(3 * x->control <= 2 * x->row.count);
}

static double rounded(double x, double to) { return to > 0 ? to * floor(x / to + 0.5) : x; }

/* Points that are noisier than the tolerance do not make the curve leave them. */
static void noise_makes_no_shape(arb *a)
{
    static fitted x;
    const unsigned count = 40 + arb_below(a, 160);
    const double noise = exp(-6 * random_unit(a)), high = 2 + 10 * random_unit(a),
                 turns = 0.5 + 2 * random_unit(a);
    const bool ellipse = arb_below(a, 2), grid = arb_below(a, 2);

    x = (fitted){ .tol = 0.001 + 0.3 * random_unit(a) * random_unit(a),
                  .row = { .closed = ellipse && arb_below(a, 2) },
                  .low = { INFINITY, INFINITY },
                  .high = { -INFINITY, -INFINITY } };
    for (unsigned k = 0; k < count; k++) {
        const double t = 6.283185307179586 * k / count;
        add_noisy(&x, a, ellipse ? 20 * cos(t) : 10 * t, high * sin(ellipse ? t : turns * t),
                  grid ? 0 : noise);
        for (int i = 0; i < 2; i++)
            x.p[k][i] = rounded(x.p[k][i], grid ? noise / 4 : 0);
    }
    CHECK(run_wider_fit(&x, 2 + arb_below(a, 3)));
    check_parts(&x);
    check_shape(&x);
}


// Surfaces
// --------

/* A wave with a crease, a step or neither, and noise. */
static double height(arb *a, int kind, double noise, double x, double y)
{
    return 2 * sin(x / 2) * cos(y / 3) +
           (kind == 1            ? fabs(x - 5.2)
            : kind == 2 && x > 5 ? 3
                                 : 0) +
           noise * (2 * random_unit(a) - 1);
}

static double draw_noise(arb *a) { return arb_below(a, 3) == 0 ? 0 : exp(-1 - 6 * random_unit(a)); }

/* The largest distance of a place on a surface from the box of the points, in z. */
static double net_beyond(const double p[][ENGINE_AXES], size_t count, engine_net_fit *all,
                         const double net[][ENGINE_AXES])
{
    static double at[41 * 41][2], place[41 * 41][ENGINE_AXES];
    double low = INFINITY, high = -INFINITY, beyond = 0;

    for (size_t k = 0; k < count; k++) {
        low  = fmin(low, p[k][2]);
        high = fmax(high, p[k][2]);
    }
    for (int k = 0; k < 41 * 41; k++) {
        at[k][0] = k / 41 / 40.0;
        at[k][1] = k % 41 / 40.0;
    }
    all->at = (const double(*)[2])at;
    all->count = 41 * 41;
    CHECK(engine_f64.fit_places(all, net, place) == LOFT_OK);
    for (int k = 0; k < 41 * 41; k++)
        beyond = fmax(beyond, fmax(low - place[k][2], place[k][2] - high));
    return beyond;
}

/* Of a grid: within the tolerance, or refused with one that suffices; never far from its points. */
static void a_grid_makes_no_shape(arb *a)
{
    const unsigned rows = 5 + arb_below(a, 20), columns = 5 + arb_below(a, 15);
    const int kind = (int)arb_below(a, 3);
    const double noise = draw_noise(a), tol = 0.001 + 0.1 * random_unit(a) * random_unit(a);
    grid_fit g = { .count = { rows, columns } };
    double (*const p)[ENGINE_AXES] = tool_grow(NULL, (size_t)rows * columns * sizeof *p);

    for (unsigned k = 0; k < rows * columns; k++) {
        p[k][0] = 10.0 * (k / columns) / (rows - 1);
        p[k][1] = 10.0 * (k % columns) / (columns - 1);
        p[k][2] = height(a, kind, noise, p[k][0], p[k][1]);
    }
    g.p = p;
    CHECK(grid_fit_make(&g, &engine_f64, 3, tol) == LOFT_OK);
    CHECK(g.enough < INFINITY);
    double met = tol;
    if (g.enough > tol) {               /* again, with what the refusal names */
        grid_fit again = { .p = p, .count = { rows, columns } };
        met = g.enough;
        g.p = NULL;
        grid_fit_free(&g);
        g = again;
        CHECK(grid_fit_make(&g, &engine_f64, 3, met) == LOFT_OK && g.enough <= met);
    }
    for (int k = 0; k < 2; k++)
        CHECK(g.points[k] <= 4 || 3 * g.points[k] <= 2 * g.count[k]);
    engine_net_fit all = { .knot = { g.knot[0], g.knot[1] },
                           .points = { g.points[0], g.points[1] },
                           .degree = { g.degree[0], g.degree[1] } };
    const double gap = 10 * M_SQRT2 / (fmin(rows, columns) - 1);
    CHECK(net_beyond((const double(*)[ENGINE_AXES])p, (size_t)rows * columns, &all,
                     (const double(*)[ENGINE_AXES])g.net) < 5 * met + gap / 2);
    grid_fit_free(&g);
}

/* The same of points in no order. */
static void a_cloud_makes_no_shape(arb *a)
{
    enum { MOST_POINTS = 120 };
    static double p[MOST_POINTS][ENGINE_AXES];
    const unsigned count = 40 + arb_below(a, MOST_POINTS - 40);
    const int kind = (int)arb_below(a, 3);
    const double noise = draw_noise(a), tol = 0.001 + 0.1 * random_unit(a) * random_unit(a);
    scatter_fit f = { .p = (const double(*)[ENGINE_AXES])p, .count = count };

    for (unsigned k = 0; k < count; k++) {
        p[k][0] = 10 * random_unit(a);
        p[k][1] = 10 * random_unit(a);
        p[k][2] = height(a, kind, noise, p[k][0], p[k][1]);
    }
    const int status = scatter_fit_make(&f, &engine_f64, 3, tol);
    CHECK(status == LOFT_OK || (status == LOFT_SINGULAR && f.loose > 0));
    if (status == LOFT_OK && f.enough <= tol) {
        CHECK(f.off <= tol && 2 * f.points[0] * f.points[1] <= count);
        for (unsigned k = 0; k < f.points[0] * f.points[1]; k++)
            CHECK(f.net[k][2] > -20 && f.net[k][2] < 20);
    } else if (status == LOFT_OK && f.enough < INFINITY) {
        scatter_fit again = { .p = f.p, .count = count };
        CHECK(scatter_fit_make(&again, &engine_f64, 3, f.enough) == LOFT_OK &&
              again.enough <= f.enough);
        scatter_fit_free(&again);
    }
    scatter_fit_free(&f);
}

/* A disk, a ring or a triangle tells nothing of the corners of the rectangle around it. What is
 * given for them lies in the box of the points along the axes, but for 1/30 of its size, as no
 * direction of theirs is better. */
static void corners_without_points_stay_in_the_box(arb *a)
{
    enum { COUNT = 100, LOOK = 20 };
    static double p[COUNT][ENGINE_AXES], at[(LOOK + 1) * (LOOK + 1)][2],
        place[(LOOK + 1) * (LOOK + 1)][ENGINE_AXES];
    const int kind = (int)arb_below(a, 3);
    const double bend = 0.02 * (random_unit(a) - 0.5), slope = 0.2 * (random_unit(a) - 0.5);
    scatter_fit f = { .p = (const double(*)[ENGINE_AXES])p, .count = COUNT };

    for (unsigned k = 0; k < COUNT; k++) {
        double x, y;
        do {
            x = 10 * random_unit(a) - 5;
            y = 10 * random_unit(a) - 5;
        } while (kind == 2 ? x + y > 0 : hypot(x, y) > 5 || (kind == 1 && hypot(x, y) < 2));
        p[k][0] = x;
        p[k][1] = y;
        p[k][2] = slope * x + bend * x * y;
    }
    for (unsigned k = 0; k < (LOOK + 1) * (LOOK + 1); k++) {
        at[k][0] = k / (LOOK + 1) / (double)LOOK;
        at[k][1] = k % (LOOK + 1) / (double)LOOK;
    }
    CHECK(scatter_fit_make(&f, &engine_f64, 3, 0.05) == LOFT_OK && f.enough <= 0.05);
    const engine_net_fit all = { .at = (const double(*)[2])at,
                                 .count = (LOOK + 1) * (LOOK + 1),
                                 .knot = { f.knot[0], f.knot[1] },
                                 .points = { f.points[0], f.points[1] },
                                 .degree = { f.degree[0], f.degree[1] } };
    CHECK(engine_f64.fit_places(&all, (const double(*)[ENGINE_AXES])f.net, place) == LOFT_OK);
    for (int axis = 0; axis < 2; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (unsigned k = 0; k < COUNT; k++) {
            low = fmin(low, p[k][axis]);
            high = fmax(high, p[k][axis]);
        }
        for (unsigned k = 0; k < (LOOK + 1) * (LOOK + 1); k++)
            CHECK(place[k][axis] > low - 1 / 3.0 && place[k][axis] < high + 1 / 3.0);
    }
    scatter_fit_free(&f);
}

/* A corner, or the middle, without points: the place is told. All over the rectangle: none is. */
static void places_without_points_are_told(arb *a)
{
    enum { COUNT = 300 };
    static double p[COUNT][ENGINE_AXES];
    const int kind = (int)arb_below(a, 3);
    const double slope = 0.2 * (random_unit(a) - 0.5), turn = arb_below(a, 2) ? 1 : -1;
    scatter_fit f = { .p = (const double(*)[ENGINE_AXES])p, .count = COUNT };

    for (unsigned k = 0; k < COUNT; k++) {
        double x, y;
        do {
            x = 10 * random_unit(a) - 5;
            y = 10 * random_unit(a) - 5;
        } while ((kind == 1 && x > 1.5 && turn * y > 1.5) || (kind == 2 && hypot(x, y) < 2.5));
        p[k][0] = kind ? x : (k / 17 % 18 - 8.5) * 0.6;
        p[k][1] = kind ? y : (k % 17 - 8.0) * 0.6;
        p[k][2] = slope * x;
    }
    CHECK(scatter_fit_make(&f, &engine_f64, 2, 2) == LOFT_OK && f.enough <= 2);
    CHECK((f.blank > 0) == (kind > 0));
    if (kind == 1)
        CHECK(f.blank > 1.5 && f.guessed[0] > 3 && turn * f.guessed[1] > 3);
    if (kind == 2)
        CHECK(f.blank > 1.5 && hypot(f.guessed[0], f.guessed[1]) < 1);
    scatter_fit_free(&f);
}

int main(void)
{
    PROPERTY(places_without_points_are_told, 20);
    PROPERTY(corners_are_kept,           30);
    PROPERTY(circles_have_a_smooth_seam, 30);
    PROPERTY(waves_are_one_curve,        30);
    PROPERTY(any_points_are_met_or_refused, 50);
    PROPERTY(noise_makes_no_shape,       40);
    PROPERTY(a_grid_makes_no_shape,      30);
    PROPERTY(a_cloud_makes_no_shape,      4);
    PROPERTY(corners_without_points_stay_in_the_box, 30);
    return check_failures();
}
