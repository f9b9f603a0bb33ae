/* tests/tools/test_mill.c -- paths of a mill, by brute force: points of the surfaces against each
 * chord; the order of lines
 * SPDX-License-Identifier: MIT
 * usage: test_mill [POINTS SHAPE]: sweep one shape, or a file of surfaces, with so many points
 */
#include <math.h>

#include "engine/mill.h"
#include "engine/surface.h"
#include "tools/drawn.h"            /* CHECK, tool_error */

#define FREE 1e9

static size_t points = 20000;

/* The chords of a path by squares of `by`, grown by the radius of the cutter. */
typedef struct {
    const mill_cut *path;
    const mill_order *o;
    double from[2], by;
    size_t across, rows;
    size_t *first, *chord;          /* of square k: chord[first[k] .. first[k + 1] - 1] */
} chords;

static size_t square_of(const chords *c, double x, int axis, size_t count)
{
    return (size_t)fmax(0, fmin((double)count - 1, floor((x - c->from[axis]) / c->by)));
}

/* Count the chords of each square, or enter them at first[k + 1]. */
static void enter_chords(chords *c, bool count)
{
    for (size_t k = 0; k + 1 < c->path->count; k++) {
        const double *const a = c->path->point[k], *const b = c->path->point[k + 1];
        const double r = c->o->radius;
        const size_t x1 = square_of(c, fmax(a[0], b[0]) + r, 0, c->across),
                     y1 = square_of(c, fmax(a[1], b[1]) + r, 1, c->rows);
        for (size_t y = square_of(c, fmin(a[1], b[1]) - r, 1, c->rows); y <= y1; y++)
            for (size_t x = square_of(c, fmin(a[0], b[0]) - r, 0, c->across); x <= x1; x++) {
                size_t *const place = &c->first[y * c->across + x + 2];
                if (!count)
                    c->chord[place[-1]++] = k;
                else
                    ++*place;
            }
    }
}

static void index_chords(chords *c, const mill_cut *path, const mill_order *o)
{
    *c = (chords){ .path = path, .o = o, .by = o->radius / 2 };
    for (int k = 0; k < 2; k++)
        c->from[k] = o->area[0][k] - o->radius;
    c->across = (size_t)((o->area[1][0] + o->radius - c->from[0]) / c->by) + 1;
    c->rows   = (size_t)((o->area[1][1] + o->radius - c->from[1]) / c->by) + 1;
    c->first  = calloc(c->across * c->rows + 2, sizeof *c->first);
    CHECK(c->first != NULL);
    enter_chords(c, true);
    for (size_t k = 2; k < c->across * c->rows + 2; k++)
        c->first[k] += c->first[k - 1];
    c->chord = malloc((c->first[c->across * c->rows + 1] + 1) * sizeof *c->chord);
    enter_chords(c, false);
}

static void close_chords(chords *c)
{
    free(c->first);
    free(c->chord);
}

/* How high the underside is over a point at `t` of a chord. */
static double over_point(const chords *c, const double *a, const double *b, double t,
                         const double p[3])
{
    const double d = hypot(a[0] + t * (b[0] - a[0]) - p[0], a[1] + t * (b[1] - a[1]) - p[1]),
                 corner = c->o->corner, beyond = d - (c->o->radius - corner);

    return a[2] + t * (b[2] - a[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

/* The least of it where the cutter is over the point; it is convex there. */
static double over_chord(const chords *c, const double *a, const double *b, const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 off2 = (p[0] - a[0]) * (p[0] - a[0]) + (p[1] - a[1]) * (p[1] - a[1]),
                 r2 = c->o->radius * c->o->radius;
    double low = 0, high = 1;

    if (length2 > 0) {
        const double half2 = to * to - length2 * (off2 - r2);
        if (half2 < 0)
            return FREE;
        low  = fmax(0, (to - sqrt(half2)) / length2);
        high = fmin(1, (to + sqrt(half2)) / length2);
    }
    if (low > high || (length2 <= 0 && off2 > r2))
        return FREE;
    for (int k = 0; k < 40; k++) {
        const double t = low + (high - low) * 0.4, u = low + (high - low) * 0.6;
        if (over_point(c, a, b, t, p) < over_point(c, a, b, u, p))
            high = u;
        else
            low = t;
    }
    return over_point(c, a, b, low, p);
}

/* No place of the chord is lower over the point. */
static double least_over(const chords *c, const double *a, const double *b, const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 t = length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0,
                 d = hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]), corner = c->o->corner,
                 beyond = d - (c->o->radius - corner);

    if (d > c->o->radius)
        return FREE;
    return fmin(a[2], b[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

static double over_path(const chords *c, const double p[3])
{
    const size_t k = square_of(c, p[1], 1, c->rows) * c->across + square_of(c, p[0], 0, c->across);
    double least = FREE;

    for (size_t i = c->first[k]; i < c->first[k + 1]; i++) {
        const double *const a = c->path->point[c->chord[i]], *const b = a + 3;
        if (fmin(a[2], b[2]) - p[2] < least && least_over(c, a, b, p) < least)
            least = fmin(least, over_chord(c, a, b, p));
    }
    return least;
}

static double random_unit(arb *a) { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* The least height of the underside over random points of all surfaces. */
static double sweep(arb *a, const surfaces *all, const mill_order *o, const mill_cut *path)
{
    double least = FREE;
    chords c;

    index_chords(&c, path, o);
    for (size_t i = 0; i < all->count; i++) {
        engine_surface *s;
        CHECK(engine_surfaces_f64.open(&all->surface[i], &s) == 0);
        for (size_t n = 0; n < points / all->count; n++) {
            double p[3], u = random_unit(a), v = random_unit(a);
            const unsigned kite = arb_below(a, surface_kites(&all->surface[i]));
            if (engine_surfaces_f64.kite(s, kite, u, v, p) != 0)
                CHECK(engine_surfaces_f64.kite(s, kite, 1 - u, 1 - v, p) == 0);
            least = fmin(least, over_path(&c, p));
        }
        engine_surfaces_f64.close(s);
    }
    close_chords(&c);
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
    CHECK(surfaces_read_text(all, "-", text) == 0);
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

    arb_surfaces(a, turn++ % 4, &all);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(path.count == 1 && path.cut[0].count > 10);
    CHECK(sweep(a, &all, &o, &path.cut[0]) > -1e-9);
    CHECK(r.entries[MILL_HELIX] + r.entries[MILL_RAMP] > 0);
    const double *const from = path.cut[0].point[0], *const to =
                                                         path.cut[0].point[path.cut[0].count - 1];
    CHECK(from[2] >= r.top + 3 - 1e-9 && to[2] >= r.top + 3 - 1e-9);
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
        CHECK(surfaces_read_only(all, "tests/drawings/sided.loft") == 0);
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
        CHECK(surfaces_read_only(all, strchr(name, '.') ? name : "tests/drawings/patch.loft") == 0);
        return all->count;
    }
    if (strcmp(name, "octant") == 0)
        snprintf(text, sizeof text, "octant 20\n");
    else
        say_mesh(text, sizeof text, 32, 1);
    CHECK(surfaces_read_text(all, "-", text) == 0);
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

    const size_t used = read_shape(name, &all), read = all.count;
    all.count = used;
    CHECK(used > 0 && engine_mill_f64(&all, &o, &path, &r) == 0);
    const double least = sweep(&a, &all, &o, &path.cut[0]);
    printf("%-8s %4zu surfaces, %6zu chords, cusp asked %g, at most %.5f; %zu points, the nearest "
           "%.2e mm below the tool\n",
           name, all.count, path.cut[0].count - 1, o.cusp, r.cusp, points, least);
    CHECK(least > -1e-9 && r.cusp <= o.cusp && r.cusp >= 0.92 * o.cusp);
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
    PROPERTY(hills_are_cut_downward, 10);
    return check_failures();
}
