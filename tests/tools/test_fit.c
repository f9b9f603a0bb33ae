/* tests/tools/test_fit.c -- curves near measured points: within the tolerance, corners kept, seams
 * smooth
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "tools/drawn.h"
#include "base/space.h"
#include "plan/point_fit.h"

#define MOST 600

typedef struct {
    double p[MOST][ENGINE_AXES], tol;
    point_row row;
    size_t parts, seen, smooth_seams;
    double end[ENGINE_AXES], start[ENGINE_AXES];
    bool near, whole;
} fitted;

static double random_unit(arb *a) { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* Each part begins where the one before ended, at a point of the row, and is near its points. */
static int take_part(void *context, const spline_fit *f)
{
    fitted *x = context;
    double at[ENGINE_AXES], slope[ENGINE_AXES], end[ENGINE_AXES], last[ENGINE_AXES];

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

static void run_fit(fitted *x, unsigned degree)
{
    const point_fit_options o = { x->tol, 50 * 3.14159 / 180, degree };
    spline_fit f = { .e = &engine_f64 };


    x->near = x->whole = true;
    x->row.p = x->p;
    CHECK(point_fit(&x->row, &o, &f, take_part, x) == 0);
    spline_fit_free(&f);
    CHECK(x->near && x->whole);
    CHECK(x->seen == x->row.count - (x->row.closed ? 0 : 1));
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

/* Whatever is given, each point is near the curves. */
static void any_points_are_met(arb *a)
{
    static fitted x;

    x = (fitted){ .tol = 0.01 + random_unit(a), .row = { .closed = arb_below(a, 2) } };
    for (unsigned k = 3 + arb_below(a, 60); k > 0; k--)
        add_noisy(&x, a, 0, 0, 30);
    run_fit(&x, 1 + arb_below(a, 9));
}

int main(void)
{
    PROPERTY(corners_are_kept,           30);
    PROPERTY(circles_have_a_smooth_seam, 30);
    PROPERTY(waves_are_one_curve,        30);
    PROPERTY(any_points_are_met,        300);
    return check_failures();
}
