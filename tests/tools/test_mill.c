/* tests/tools/test_mill.c -- paths of a mill, by brute force: points of the surfaces against each
 * chord; the order of lines
 * SPDX-License-Identifier: MIT
 * usage: test_mill [POINTS SHAPE]: sweep one shape, or a file of surfaces, with so many points
 */
#include <math.h>

#include "engine/mill.h"
#include "engine/surface.h"
#include "tools/chords.h"           /* over_path */
#include "tools/drawn.h"            /* CHECK, tool_error */
#include "geometry/surface_text.h"

#define CUSP_ERRS 1.05          /* what is left against the cusp that was asked */

static size_t points = 20000;

static double random_unit(arb *a) { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* The least height of the underside over random points of all surfaces; over how many of them more
 * is left than a cusp and the tolerance, and the most that is left. What is found to be no more
 * than that, and than what is proved, may be less. */
static double sweep(arb *a, const surfaces *all, const mill_order *o, const mill_cut *path,
                    double proved, size_t *more, double *most)
{
    const double limit = o->cusp + o->tol;
    double least = FREE;
    chords c;

    *more = 0;
    *most = 0;
    index_chords(&c, path, o);
    for (size_t i = 0; i < all->count; i++) {
        engine_surface *s;
        CHECK(engine_surfaces_f64.open(&all->surface[i], &s) == 0);
        for (size_t n = 0; n < points / all->count; n++) {
            double p[3], u = random_unit(a), v = random_unit(a);
            const unsigned kite = arb_below(a, surface_kites(&all->surface[i]));
            if (engine_surfaces_f64.kite(s, kite, u, v, p) != 0)
                CHECK(engine_surfaces_f64.kite(s, kite, 1 - u, 1 - v, p) == 0);
            double left = FREE;
            least = fmin(least, over_path(&c, p, &left));
            if (left > fmin(o->cusp > 0 ? limit : *most, proved))
                left = left_by_all(&c, p);
            *more += left > limit;
            *most = fmax(*most, left);
        }
        engine_surfaces_f64.close(s);
    }
    free_squares(&c.all);
    return least;
}

static void tell(void *context, double share)
{
    (void)context;
    CHECK(share >= -1e-9 && share <= 1 + 1e-9);
}

static double fresh(arb *a, double most) { return most * random_unit(a); }

static int say_bump(char *text, size_t size, int x, int y)
{
    const double fx = 0.5 * cos(x / 4.0) * cos(y / 5.0), fy = -0.4 * sin(x / 4.0) * sin(y / 5.0),
                 length = sqrt(1 + fx * fx + fy * fy);

    return snprintf(text, size, "%d %d %.6f : %.9f %.9f %.9f\n", x, y,
                    2 * sin(x / 4.0) * cos(y / 5.0), -fx / length, -fy / length, 1 / length);
}

/* Triangles from the normals of a waved sheet: squares of `by` mm, 2 for each of n^2. */
static void say_mesh(char *text, size_t size, int n, int by)
{
    static const int corner[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
    int used = 0;

    for (int k = 0; k < n * n * 6; k++) {
        const int *const c = corner[k % 6];
        if (k % 3 == 0)
            used += snprintf(text + used, size - (size_t)used, "pn\n");
        used += say_bump(text + used, size - (size_t)used, by * (k / 6 % n + c[0]),
                         by * (k / 6 / n + c[1]));
        if (k % 3 == 2)
            used += snprintf(text + used, size - (size_t)used, "\n");
    }
    CHECK((size_t)used < size);
}

/* Hills on a table, a mesh of triangles, or an octant. */
static void arb_surfaces(arb *a, unsigned kind, surfaces *all)
{
    char text[16384] = "octant 9\n";

    if (kind == 1)
        say_mesh(text, sizeof text, 4, 4);
    else if (kind > 1) {
        int used = snprintf(text, sizeof text, "tensor 3 3\n");
        for (int k = 0; k < 16; k++)
            used += snprintf(text + used, sizeof text - (size_t)used, "%d %d %.3f\n", k / 4 * 6,
                             k % 4 * 6, fresh(a, 14));
    }
    CHECK(surfaces_read_text(&heard, all, "-", text) == 0);
}

static void no_way_into_the_material_cuts(arb *a)
{
    static unsigned turn;
    const double radius = 1.5, corner[3] = { 1.5, 0, 0.4 };
    const unsigned kind = arb_below(a, 3);
    mill_order o = { .pattern = arb_below(a, 3),
                     .radius  = radius,
                     .corner  = corner[kind],
                     .step    = 3,
                     .tol     = 0.02,
                     .entry   = 1 + arb_below(a, MILL_ENTRIES - 1),
                     .slope   = 0.1,
                     .around  = 1,
                     .safe    = 3,
                     .tell    = tell };
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    mill_report r;
    double most;
    size_t more;

    arb_surfaces(a, turn++ % 4, &all);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(path.count == 1 && path.cut[0].count > 10);
    CHECK(sweep(a, &all, &o, &path.cut[0], r.left, &more, &most) > -1e-9);
    CHECK(most <= r.left);
    CHECK(r.entries[MILL_HELIX] + r.entries[MILL_RAMP] > 0);
    const double *const from = path.cut[0].point[0], *const to =
                                                         path.cut[0].point[path.cut[0].count - 1];
    CHECK(from[2] >= r.top + 3 - 1e-9 && to[2] >= r.top + 3 - 1e-9);
    mill_cuts_free(&path);
    surfaces_free(&all);
}

static mill_order small_ball(arb *a, double cusp)
{
    return (mill_order){ .radius = 2,
                         .corner = 2,
                         .cusp   = cusp,
                         .tol    = 0.02,
                         .axis   = arb_below(a, 2),
                         .safe   = 1,
                         .tell   = tell };
}

/* An octant, whose border is an upright wall, or a plane with slopes up to 3 along x and y, from
 * corner to corner: of both a raster or a spiral leaves no more than cusps.
 * Without lines that low and that far outside, up to 1 mm is left. */
static void steep_borders_are_reached(arb *a)
{
    static unsigned turn;
    const double x = fresh(a, 30), y = fresh(a, 30);
    mill_order o = small_ball(a, 0.2);
    o.pattern = arb_below(a, 2) ? MILL_SPIRAL : MILL_RASTER;
    char text[128] = "octant 7\n";
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    mill_report r;
    double most;
    size_t more;

    if (turn++ % 4 != 0)
        snprintf(text, sizeof text, "tensor 1 1\n0 0 0\n0 10 %.3f\n10 0 %.3f\n10 10 %.3f\n", y, x,
                 x + y);
    CHECK(surfaces_read_text(&heard, &all, "-", text) == 0);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(sweep(a, &all, &o, &path.cut[0], r.left, &more, &most) > -1e-9);
    CHECK(most <= CUSP_ERRS * o.cusp + o.tol);
    CHECK(most <= r.left && r.left <= most + 2 * o.tol);
    CHECK(r.hollow <= r.reached);
    mill_cuts_free(&path);
    surfaces_free(&all);
}

/* A valley of two planes with a slope of 1/2 to 1, which a ball of radius 2 touches in two places:
 * its bottom is sqrt(1 + slope^2) radii from the centre. The tool may be higher by the tolerance,
 * and bounds come that near, after a plain step too; what the path leaves is bounded too. */
static void hollows_are_told(arb *a)
{
    static unsigned turn;
    const double slope = 0.5 + fresh(a, 0.5), exact = 2 * (sqrt(1 + slope * slope) - 1);
    mill_order o = small_ball(a, 0.1);
    char text[256];
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    mill_report r;
    double most;
    size_t more;

    snprintf(text, sizeof text,
             "tensor 1 1\n0 0 %.6f\n0 4 %.6f\n6 0 0\n6 4 0\n\n"
             "tensor 1 1\n6 0 0\n6 4 0\n12 0 %.6f\n12 4 %.6f\n",
             6 * slope, 6 * slope, 6 * slope, 6 * slope);
    if (turn++ % 2 != 0) {
        o.cusp = 0;
        o.step = 1;
    }
    CHECK(surfaces_read_text(&heard, &all, "-", text) == 0);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(r.hollow > r.reached && r.hollow >= exact - 1e-5);
    CHECK(r.hollow <= exact + 3 * o.tol && r.hollow <= r.left);
    CHECK(sweep(a, &all, &o, &path.cut[0], r.left, &more, &most) > -1e-9);
    CHECK(most <= r.left && r.left <= most + 2 * o.tol);
    mill_cuts_free(&path);
    surfaces_free(&all);
}

/* The border of an octant is upright: waterlines go down to where the ball touches it. Over the
 * lower third their cusps are left, (step / sine of the slope)^2 / 8 radius. */
static void waterlines_reach_below_borders(arb *a)
{
    const double step = 0.5 + fresh(a, 0.5), cusp = step * step / 0.75 / 16;
    mill_order o = { .pattern = MILL_WATERLINE,
                     .radius  = 2,
                     .corner  = 2,
                     .step    = step,
                     .tol     = 0.02,
                     .safe    = 1,
                     .tell    = tell };
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    engine_surface *s;
    mill_report r;

    CHECK(surfaces_read_text(&heard, &all, "-", "octant 7\n") == 0);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(o.lowest < -2 + 2.0 / 16 && o.lowest >= -2 - 1e-6);
    const chords c = { .path = &path.cut[0], .o = &o };
    CHECK(engine_surfaces_f64.open(&all.surface[0], &s) == 0);
    for (int n = 0; n < 1000; n++) {
        double p[3], u = random_unit(a), v = random_unit(a);
        if (engine_surfaces_f64.kite(s, 0, u, v, p) != 0)
            CHECK(engine_surfaces_f64.kite(s, 0, 1 - u, 1 - v, p) == 0);
        CHECK(p[2] > 3.5 || left_by_all(&c, p) <= CUSP_ERRS * cusp + o.tol);
    }
    engine_surfaces_f64.close(s);
    mill_cuts_free(&path);
    surfaces_free(&all);
}

/* Rings around hills that are `apart`; each hill has `levels`, all surrounded by one at the end. */
static void hills_are_cut_downward(arb *a)
{
    const unsigned hills = 2 + arb_below(a, 3), levels = 2 + arb_below(a, 4);
    unsigned order[64], next = 0, changes = 0;
    mill_cuts all = { 0 };

    for (unsigned level = 0; level < levels; level++)
        for (unsigned h = 0; h < hills; h++) {
            mill_cut *const c = mill_cuts_begin(&all, level);
            for (unsigned k = 0; k <= 12; k++) {
                const double turn = 2 * M_PI * (k % 12) / 12, r = 1 + level,
                             p[3] = { 40.0 * h + r * cos(turn), r * sin(turn), -(double)level };
                mill_cuts_add(&all, p);
            }
            c->closed = true;
        }
    mill_cuts_order(&all, 0.5);
    CHECK(all.count == hills * levels);
    for (size_t k = 0; k < all.count; k++) {
        const mill_cut *const c = &all.cut[k];
        order[next++] = (unsigned)floor(c->point[0][0] / 40 + 0.5);
        CHECK(c->level == k % levels && c->count == 13);
        CHECK(memcmp(c->point[0], c->point[12], sizeof *c->point) == 0);
        changes += k > 0 && order[k] != order[k - 1];
    }
    CHECK(changes == hills - 1);
    mill_cuts_free(&all);
}

/* The shapes of a sweep. Returns how many surfaces of the file they are, from the first one. */
static size_t read_shape(const char *name, surfaces *all)
{
    static char text[1 << 19];

    if (strcmp(name, "gb") == 0) {          /* one of a hexagon */
        CHECK(surfaces_read_only(&heard, all, "tests/drawings/sided.loft") == 0);
        for (size_t k = 1; k < all->count; k++)
            if (all->surface[k].kind == SURFACE_GB && all->surface[k].n == 6) {
                const surface first = all->surface[0];
                all->surface[0] = all->surface[k];
                all->surface[k] = first;
                break;
            }
        return 1;
    }
    if (strcmp(name, "bicubic") == 0 || strchr(name, '.') != NULL) {
        CHECK(surfaces_read_only(&heard, all,
                                 strchr(name, '.') ? name : "tests/drawings/patch.loft") == 0);
        return all->count;
    }
    if (strcmp(name, "octant") == 0)
        snprintf(text, sizeof text, "octant 20\n");
    else
        say_mesh(text, sizeof text, 32, 1);
    CHECK(surfaces_read_text(&heard, all, "-", text) == 0);
    return all->count;
}

/* One row: what was asked and what came of it. */
static void sweep_shape(const char *name)
{
    mill_order o = { .radius = 3, .corner = 3, .cusp = 0.1, .tol = 0.01, .safe = 3, .tell = tell };
    arb a = { 1 };
    surfaces all = { 0 };
    mill_cuts path = { 0 };
    mill_report r;
    double most;
    size_t more;

    const size_t used = read_shape(name, &all), read = all.count;
    all.count = used;
    CHECK(used > 0 && engine_mill_f64(&all, &o, &path, &r) == 0);
    const double least = sweep(&a, &all, &o, &path.cut[0], r.left, &more, &most);
    printf("%-8s %4zu surfaces, %6zu chords, cusp asked %g, at most %.5f; %zu points, the nearest "
           "%.2e mm below the tool, %.4f mm left at most, %.4f %% with more left than cusp and "
           "tolerance; proved: at most %.4f, in hollows %.4f\n",
           name, all.count, path.cut[0].count - 1, o.cusp, r.cusp, points, least, most,
           100.0 * (double)more / (double)points, r.left, r.hollow);
    CHECK(least > -1e-9 && r.cusp <= o.cusp && r.cusp >= 0.95 * o.cusp);
    CHECK(most <= r.left);
    CHECK(most <= CUSP_ERRS * o.cusp + o.tol);
    all.count = read;
    mill_cuts_free(&path);
    surfaces_free(&all);
}

int main(int argc, char **argv)
{
    if (argc > 2) {
        points = strtoul(argv[1], NULL, 10);
        sweep_shape(argv[2]);
        return check_failures();
    }
    PROPERTY(no_way_into_the_material_cuts, 4);
    PROPERTY(steep_borders_are_reached, 8);
    PROPERTY(hollows_are_told, 4);
    PROPERTY(waterlines_reach_below_borders, 2);
    PROPERTY(hills_are_cut_downward, 10);
    return check_failures();
}
