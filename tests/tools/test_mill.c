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

/* Squares of x and y, each with the chords of a path that may be the lowest over some point of it.
 * A square with many is divided when a point comes to lie in it. */
typedef struct squares {
    struct squares *quarter[4];
    double middle[2], half;
    size_t *chord, count;
} squares;

typedef struct {
    const mill_cut *path;
    const mill_order *o;
    squares all;
} chords;

/* How high the underside of a cutter, grown sideways, is over a point at `t` of a chord. */
static double over_point(const mill_order *o, double grown, const double *a, const double *b,
                         double t, const double p[3])
{
    const double x = a[0] + t * (b[0] - a[0]) - p[0], y = a[1] + t * (b[1] - a[1]) - p[1],
                 corner = o->corner, beyond = sqrt(x * x + y * y) - (o->radius + grown - corner);

    return a[2] + t * (b[2] - a[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

/* Where a ball is the lowest over a point beside a chord, the slope of its underside is that of the
 * chord. */
static double lowest_of_ball(double length2, double rise, double to, double off2, double r2)
{
    const double across2 = fmax(0, off2 - to * to / length2);

    return to / length2 - rise * sqrt(fmax(0, r2 - across2) / (length2 + rise * rise) / length2);
}

/* The least of it where the cutter is over the point; it is convex there. */
static double over_chord(const mill_order *o, double grown, const double *a, const double *b,
                         const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 off2 = (p[0] - a[0]) * (p[0] - a[0]) + (p[1] - a[1]) * (p[1] - a[1]),
                 r = o->radius + grown, r2 = r * r;
    double low = 0, high = 1;

    if (length2 > 0) {
        const double half2 = to * to - length2 * (off2 - r2);
        if (half2 < 0)
            return FREE;
        low  = fmax(0, (to - sqrt(half2)) / length2);
        high = fmin(1, (to + sqrt(half2)) / length2);
    }
    if (r <= 0 || low > high || (length2 <= 0 && off2 > r2))
        return FREE;
    if (length2 <= 0)
        low = b[2] < a[2] ? 1 : 0;
    else if (o->corner == r)
        low = fmax(low, fmin(high, lowest_of_ball(length2, b[2] - a[2], to, off2, r2)));
    for (int k = 0; k < 40 && length2 > 0 && o->corner != r; k++) {
        const double t = low + (high - low) * 0.4, u = low + (high - low) * 0.6;
        if (over_point(o, grown, a, b, t, p) < over_point(o, grown, a, b, u, p))
            high = u;
        else
            low = t;
    }
    return over_point(o, grown, a, b, low, p);
}

/* No place of the chord is lower over the point. */
static double least_over(const mill_order *o, const double *a, const double *b, const double p[3])
{
    const double x = b[0] - a[0], y = b[1] - a[1], length2 = x * x + y * y,
                 to = (p[0] - a[0]) * x + (p[1] - a[1]) * y,
                 t = length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0, dx = a[0] + t * x - p[0],
                 dy = a[1] + t * y - p[1], d = sqrt(dx * dx + dy * dy), corner = o->corner,
                 beyond = d - (o->radius - corner);

    if (d > o->radius)
        return FREE;
    return fmin(a[2], b[2]) - p[2] +
           (beyond <= 0 ? 0 : corner - sqrt(fmax(0, corner * corner - beyond * beyond)));
}

/* Take from a list the chords that may be the lowest somewhere in the square. With its half
 * diagonal e, over every point the cutter is at least as low as one narrower by e is over the
 * middle, and no lower than one wider by e. */
static void sift_chords(const chords *c, squares *s, const size_t *chord, size_t count)
{
    const double e = s->half * sqrt(2), middle[3] = { s->middle[0], s->middle[1], 0 };
    double most = FREE, *const least = malloc((count + 1) * sizeof *least);

    s->chord = malloc((count + 1) * sizeof *s->chord);
    CHECK(least != NULL && s->chord != NULL);
    for (size_t i = 0; i < count; i++) {
        const double *const a = c->path->point[chord[i]], *const b = a + ENGINE_AXES;
        least[i] = over_chord(c->o, e, a, b, middle);
        most     = fmin(most, over_chord(c->o, -e, a, b, middle));
    }
    for (size_t i = 0; i < count; i++)
        if (least[i] < FREE && least[i] <= most + 1e-6)
            s->chord[s->count++] = chord[i];
    free(least);
}

static void index_chords(chords *c, const mill_cut *path, const mill_order *o)
{
    size_t *const every = malloc(path->count * sizeof *every);

    CHECK(every != NULL);
    *c = (chords){ .path = path, .o = o };
    for (int k = 0; k < 2; k++) {
        c->all.middle[k] = (o->area[0][k] + o->area[1][k]) / 2;
        c->all.half      = fmax(c->all.half, (o->area[1][k] - o->area[0][k]) / 2 + o->radius);
    }
    for (size_t k = 0; k + 1 < path->count; k++)
        every[k] = k;
    sift_chords(c, &c->all, every, path->count - 1);
    free(every);
}

static void free_squares(squares *s)
{
    for (int k = 0; k < 4; k++)
        if (s->quarter[k]) {
            free_squares(s->quarter[k]);
            free(s->quarter[k]);
        }
    free(s->chord);
}

static squares *quarter_at(const chords *c, squares *s, const double p[3])
{
    const int right = p[0] > s->middle[0], up = p[1] > s->middle[1];
    squares **const q = &s->quarter[2 * up + right];

    if (*q == NULL) {
        *q = calloc(1, sizeof **q);
        CHECK(*q != NULL);
        (*q)->half = s->half / 2;
        (*q)->middle[0] = s->middle[0] + (right ? s->half : -s->half) / 2;
        (*q)->middle[1] = s->middle[1] + (up ? s->half : -s->half) / 2;
        sift_chords(c, *q, s->chord, s->count);
    }
    return *q;
}

/* How far a point is beside a ball on its way. */
static double beside_chord(const mill_order *o, const double *a, const double *b, const double p[3])
{
    double way[3], off[3], length2 = 0, to = 0, rest2 = 0;

    for (int k = 0; k < 3; k++) {
        way[k] = b[k] - a[k];
        off[k] = p[k] - a[k] - (k == 2 ? o->radius : 0);
        length2 += way[k] * way[k];
        to += way[k] * off[k];
    }
    const double t = length2 > 0 ? fmax(0, fmin(1, to / length2)) : 0;
    for (int k = 0; k < 3; k++)
        rest2 += (off[k] - t * way[k]) * (off[k] - t * way[k]);
    return sqrt(rest2) - o->radius;
}

/* The height of the underside over a point; what is left there, at most, over its surface. */
static double over_path(chords *c, const double p[3], double *left)
{
    squares *s = &c->all;
    double least = FREE;

    if (fmax(fabs(p[0] - s->middle[0]), fabs(p[1] - s->middle[1])) > s->half)
        return FREE;
    while (s->count > 3 && s->half > c->o->radius / 64)
        s = quarter_at(c, s, p);
    for (size_t i = 0; i < s->count; i++) {
        const double *const a = c->path->point[s->chord[i]], *const b = a + ENGINE_AXES;
        if (least_over(c->o, a, b, p) < least)
            least = fmin(least, over_chord(c->o, 0, a, b, p));
        *left = fmin(*left, beside_chord(c->o, a, b, p));
    }
    return least;
}

static double random_unit(arb *a) { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

/* The least height of the underside over random points of all surfaces, and over how many of them
 * more is left than a cusp and the tolerance. */
static double sweep(arb *a, const surfaces *all, const mill_order *o, const mill_cut *path,
                    size_t *more)
{
    double least = FREE;
    chords c;

    *more = 0;
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
            *more += left > o->cusp + o->tol;
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
    size_t more;

    arb_surfaces(a, turn++ % 4, &all);
    CHECK(engine_mill_f64(&all, &o, &path, &r) == 0);
    CHECK(path.count == 1 && path.cut[0].count > 10);
    CHECK(sweep(a, &all, &o, &path.cut[0], &more) > -1e-9);
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
    size_t more;

    const size_t used = read_shape(name, &all), read = all.count;
    all.count = used;
    CHECK(used > 0 && engine_mill_f64(&all, &o, &path, &r) == 0);
    const double least = sweep(&a, &all, &o, &path.cut[0], &more);
    printf("%-8s %4zu surfaces, %6zu chords, cusp asked %g, at most %.5f; %zu points, the nearest "
           "%.2e mm below the tool, %.3f %% with more left than cusp and tolerance\n",
           name, all.count, path.cut[0].count - 1, o.cusp, r.cusp, points, least,
           100.0 * (double)more / (double)points);
    CHECK(least > -1e-9 && r.cusp <= o.cusp && r.cusp >= 0.95 * o.cusp);
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
