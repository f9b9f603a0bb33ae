/* host-tools/cmd/cmd_fit.c -- loft fit: curves and surfaces near measured points
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "num/status.h"         /* LOFT_SINGULAR */

#include "base/scan.h"          /* scan_numbers */
#include "base/source.h"        /* source_read */
#include "base/space.h"         /* space_distance */
#include "engine/engine.h"
#include "geometry/print.h"       /* print_point */
#include "fit/grid_fit.h"
#include "fit/point_fit.h"
#include "fit/scatter_fit.h"

#define GRID_MOST 1000  /* rows, columns */
#define TOL_MOST  1000
#define FIT_WRONG "give more points than --degree, and --tol above 0"

typedef struct {
    point_fit_options o;
    print_options p;
    spline_fit f;
    const char *file;
    bool close;                 /* rows that do not return, too */
    bool surface;               /* rows are a grid */
    grid_fit grid;
    point_row row;
    unsigned line;              /* where it begins */
    bool failed;
} fitting;


// Curves
// ------

/* A spline without inner knots is a Bezier curve. */
static int print_fit(void *context, const spline_fit *f)
{
    fitting *x = context;
    const size_t points = f->intervals + f->degree;

    if (f->count == 2)
        puts("line");
    else if (f->intervals == 1)
        printf("bezier %u\n", f->degree);
    else
        printf("bspline %u\n", f->degree);
    for (size_t k = 0; k < points; k++)
        print_point(&x->p, f->c[k]);
    for (size_t k = 0; k <= points + f->degree && f->intervals > 1; k++)
        print_knot(f->e, "knots", spline_fit_knot(f, (long)k - (long)f->degree), k,
                   points + f->degree + 1);
    const double off = spline_fit_error(f);
    printf("# %zu control points for %zu points, within %s\n", points, f->count, bound_text(off));
    x->failed = x->failed || !(off <= x->o.tol);
    return 0;
}

// Surfaces
// --------

/* A row of the grid: as long as the first one. */
static int add_row(fitting *x)
{
    grid_fit *g = &x->grid;
    const size_t rows = g->count[0], columns = x->row.count;

    if (columns == 0)
        return 0;
    if (rows == 0)
        g->count[1] = (unsigned)columns;
    if (columns > SCATTER_POINTS)
        return tool_error(EX_DATAERR,
                          "%s:%u: a row of %zu points: give at most %d in no order, or "
                          "a grid of rows of at most %d",
                          x->file, x->line, columns, SCATTER_POINTS, GRID_MOST);
    if (rows > 0 &&
        (columns != g->count[1] || columns < 2 || columns > GRID_MOST || rows >= GRID_MOST))
        return tool_error(EX_DATAERR,
                          "%s:%u: a row of %zu points after rows of %u: give a grid, 2 to %d rows "
                          "of 2 to %d points each",
                          x->file, x->line, columns, g->count[1], GRID_MOST, GRID_MOST);
    g->p = tool_grow(g->p, (rows + 1) * columns * sizeof *g->p);
    memcpy(g->p + rows * columns, x->row.p, columns * sizeof *g->p);
    g->count[0]++;
    x->row.count = 0;
    return 0;
}

/* The tolerance rounded up to two digits: one that suffices. */
static double rounded_up(double tol)
{
    const double unit = pow(10, floor(log10(tol)) - 1);

    return ceil(tol / unit) * unit;
}

/* No net that the points tell comes within --tol. */
static int refuse_net(const fitting *x, const unsigned points[2], double enough)
{
    if (!(enough < INFINITY))
        return tool_error(EX_DATAERR,
                          "%s: the points are noisier than --tol %g, or too few: give more points",
                          x->file, x->o.tol);
    return tool_error(
        EX_DATAERR,
        "%s: the points are noisier than --tol %g, or too few, or have a crease: %u x "
        "%u control points come within %s: give --tol %.3g, or more points",
        x->file, x->o.tol, points[0], points[1], bound_text(enough), rounded_up(enough));
}

static void print_net(fitting *x, const unsigned degree[2], const unsigned points[2],
                      const double net[][ENGINE_AXES], double *const knot[2])
{
    printf("nurbs-surface %u %u %u %u\n", degree[0], degree[1], points[0], points[1]);
    x->p.solid = true;
    for (size_t k = 0; k < (size_t)points[0] * points[1]; k++)
        print_point(&x->p, net[k]);
    for (int along = 0; along < 2; along++) {
        const unsigned knots = points[along] + degree[along] + 1;
        for (unsigned k = 0; k < knots; k++)
            print_knot(x->p.e, along ? "knots v" : "knots u", knot[along][k], k, knots);
    }
}

/* Rows are one: points in no order. */
static int fit_scattered(fitting *x)
{
    scatter_fit f = { .p = (const double(*)[ENGINE_AXES])x->grid.p, .count = x->grid.count[1] };
    int code = 0;

    if (f.count < 4)
        return tool_error(EX_DATAERR,
                          "%s: %zu points in one row: give 4 or more in any order, or rows of a "
                          "grid with empty lines between",
                          x->file, f.count);
    const int status = scatter_fit_make(&f, x->p.e, x->o.degree, x->o.tol);
    if (status == LOFT_SINGULAR && f.loose == 0)
        code = tool_error(EX_DATAERR, "%s: the points lie on a line: give points of a surface",
                          x->file);
    else if (status == LOFT_SINGULAR)
        code = tool_error(EX_DATAERR,
                          "%s: the points do not tell %u of %u control points: give points all "
                          "over the rectangle around them, or a lower --degree",
                          x->file, f.loose, f.points[0] * f.points[1]);
    else if (status != 0)
        code = tool_error(EX_DATAERR, "%s: %s", x->file, engine_status(status, FIT_WRONG));
    else if (!(f.enough <= x->o.tol) && f.loose > 0 && f.enough < INFINITY)
        code = tool_error(
            EX_DATAERR,
            "%s: %u x %u control points come within %s of the points, which do not tell %u of a "
            "finer net: give points all over the rectangle around them, or --tol %.3g",
            x->file, f.best[0], f.best[1], bound_text(f.enough), f.loose, rounded_up(f.enough));
    else if (!(f.enough <= x->o.tol))
        code = refuse_net(x, f.best, f.enough);
    if (code == 0) {
        if (f.blank > 0)
            host_warn(tool_host(), "fit.guessed", (host_place){ x->file, 0 },
                      "give points there, or leave that part out",
                      "no point is within %.3g mm of %.6g,%.6g,%.6g, where the surface is a guess",
                      f.blank, f.guessed[0], f.guessed[1], f.guessed[2]);
        print_net(x, f.degree, f.points, (const double(*)[ENGINE_AXES])f.net, f.knot);
        printf("# %u x %u control points for %zu points in no order, within %s\n", f.points[0],
               f.points[1], f.count, bound_text(f.off));
    }
    scatter_fit_free(&f);
    return code;
}

static int fit_surface(fitting *x)
{
    grid_fit *g = &x->grid;

    if (g->count[0] == 1)
        return fit_scattered(x);
    const int status = grid_fit_make(g, x->p.e, x->o.degree, x->o.tol);
    if (status != 0)
        return tool_error(EX_DATAERR, "%s: %s", x->file,
                          status == LOFT_SINGULAR ? "two rows or columns are one: give different "
                                                    "points"
                                                  : engine_status(status, FIT_WRONG));
    if (!(g->enough <= x->o.tol))
        return refuse_net(x, g->best, g->enough);
    print_net(x, g->degree, g->points, (const double(*)[ENGINE_AXES])g->net, g->knot);
    printf("# %u x %u control points for %u x %u points, within %s\n", g->points[0], g->points[1],
           g->count[0], g->count[1], bound_text(g->off));
    return 0;
}

/* A curve that comes within --tol would need a control point for almost every point. */
static int refuse_noise(fitting *x)
{
    const double enough = point_fit_enough(&x->row, &x->o, TOL_MOST, &x->f);
    char with[40] = "";

    if (enough > 0)
        snprintf(with, sizeof with, "--tol %g, or ", enough);
    return tool_error(
        EX_DATAERR, "%s:%u: the points are noisier than --tol %g, or too few: give %s%smore points",
        x->file, x->line, x->o.tol, with, x->o.degree > 3 ? "a lower --degree, or " : "");
}

static int end_row(fitting *x)
{
    point_row *r = &x->row;
    int code = 0;

    if (x->surface)
        return add_row(x);

    if (r->count == 1)
        code = tool_error(EX_DATAERR, "%s:%u: one point: give two or more", x->file, x->line);
    if (r->count > 1) {
        r->closed = r->count > 3 && !(space_distance(r->p[0], r->p[r->count - 1]) > 0);
        r->count -= r->closed ? 1 : 0;
        r->closed = r->closed || (x->close && r->count > 2);
        code = point_fit(r, &x->o, &x->f, print_fit, x);
        if (code == POINT_FIT_NOISY)
            code = refuse_noise(x);
        else if (x->failed || code != 0)
            code = tool_error(EX_DATAERR,
                              "%s:%u: numbers of %s do not hold points within --tol %g: give a "
                              "larger --tol, or --num f64",
                              x->file, x->line, x->p.e->name, x->o.tol);
    }
    r->count = 0;
    return code;
}


// Points
// ------

static void add_point(fitting *x, const double p[ENGINE_AXES], unsigned line)
{
    point_row *r = &x->row;

    if (r->count == 0)
        x->line = line;
    else if (!x->surface && !(space_distance(p, r->p[r->count - 1]) > 0))
        return;
    if ((r->count & (r->count - 1)) == 0)
        r->p = tool_grow(r->p, (r->count ? 2 * r->count : 1) * sizeof *r->p);
    memcpy(r->p[r->count++], p, ENGINE_AXES * sizeof *p);
}

static int read_point(fitting *x, const char *text, unsigned line, bool *begun)
{
    double p[ENGINE_AXES + 1] = { 0 };
    const int count = scan_numbers(&text, p, ENGINE_AXES + 1);
    const bool over = *text == '\0' || *text == '\n' || *text == '#';

    if (count == 0 && over)
        return *text == '#' ? 0 : end_row(x);
    if (count == 0 && !*begun) {        /* the names of the columns */
        *begun = true;
        return 0;
    }
    for (int i = 0; i < ENGINE_AXES; i++)
        if (!over || count < 2 || count > ENGINE_AXES || !(fabs(p[i]) <= 1e9))
            return tool_error(EX_DATAERR, "%s:%u: not a point: give lines `x,y` or `x,y,z`",
                              x->file, line);
    *begun = true;
    x->p.solid = x->p.solid || count == ENGINE_AXES;
    add_point(x, p, line);
    return 0;
}

static int fit_text(fitting *x, const char *text)
{
    bool begun = false;
    int code = 0;

    for (unsigned line = 1; *text != '\0' && code == 0; line++) {
        code = read_point(x, text, line, &begun);
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    if (code == 0)
        code = end_row(x);
    if (code == 0 && x->line == 0)
        code = tool_error(EX_DATAERR, "%s: no point in it: give lines `x,y` or `x,y,z`", x->file);
    return code;
}

typedef struct {
    const char *file;
    double tol, corner;         /* mm, degrees */
    unsigned degree;
    bool surface, closed;
    const engine *e;
} fit_options;

static const option fit_rows[] = {
    { "tol", OPTION_NUMBER(fit_options, tol), .least = 1e-6, .most = TOL_MOST, .unit = "mm",
      .standard = "0.01", .help = "no point is farther from its curve" },
    { "degree", OPTION_INTEGER(fit_options, degree), .least = 1, .most = 9, .value = "N",
      .standard = "3", .help = "of the curves" },
    { "corner", OPTION_NUMBER(fit_options, corner), .least = 0, .most = 181, .value = "DEGREES",
      .unit = "deg", .standard = "50",
      .help = "points that turn by more stay corners; 181: none does" },
    { "surface", OPTION_FLAG(fit_options, surface),
      .help = "rows of equal length are a grid, one row is points in no order: the surface near "
              "them" },
    { "closed", OPTION_FLAG(fit_options, closed), .help = "each row goes on to its first point" },
    ENGINE_ROW(fit_options, e, "f64", "number type"),
    { "file", OPTION_WORD(fit_options, file), .value = "FILE", .standard = "-" },
    { 0 }
};

static int run_fit(void *options)
{
    const fit_options *o = options;
    size_t size;
    int code;

    char *text = source_read(tool_host(), o->file, &size, &code);
    if (text == NULL)
        return code;
    fitting x = { .o = { o->tol, o->corner / 180 * acos(-1), o->degree },
                  .p = { o->e, false },
                  .f = { .e = o->e },
                  .file = source_name(o->file),
                  .close = o->closed,
                  .surface = o->surface };
    code = fit_text(&x, text);
    if (code == 0 && o->surface)
        code = fit_surface(&x);
    grid_fit_free(&x.grid);
    spline_fit_free(&x.f);
    free(x.row.p);
    free(text);
    return code;
}

const command command_fit = {
    .name = "fit",
    .arguments = "[--tol MM] [FILE|-]",
    .summary = "curves and surfaces near measured points",
    .detail =
        "FILE has one point per line: x,y or x,y,z, also with blanks or semicolons; a first line "
        "of\n"
        "names and what follows # do not count. An empty line ends a row of points; a row whose "
        "last\n"
        "point is its first one is closed. Prints B-splines in the format of host-tools/LOFT.md, "
        "in\n"
        "the order of the points: by least squares, with as many knots as the tolerance takes. "
        "Points\n"
        "that are noisier than --tol, or too few, are refused with a --tol that suffices. The "
        "curves\n"
        "begin and end in points and corners; closed rows without a corner have a smooth seam.\n"
        "With --surface the rows are a grid, v along them: prints the nurbs-surface near it. One "
        "row\n"
        "alone is points in no order, 4 to 20000, of a surface that a plane shows without folds.\n",
    .options = fit_rows,
    .size = sizeof(fit_options),
    .run = run_fit,
};
