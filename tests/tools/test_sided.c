/* tests/tools/test_sided.c -- surfaces with n sides: grids over them and their text format;
 * contours on meshes
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdarg.h>

#include "draw/mesh_contour.h"
#include "tools/drawn.h"            /* CHECK, tool_error */
#include "draw/mesh.h"
#include "polygon/multiindex.h"     /* loft_multiindex_next */
#include "engine/sided.h"
#include "geometry/surface_text.h"

#define N 12

static void say_text(char *text, size_t size, const char *format, ...)
{
    const size_t used = strlen(text);
    va_list values;

    va_start(values, format);
    vsnprintf(text + used, size - used, format, values);
    va_end(values);
}

static void vertex_of(unsigned sides, unsigned i, double out[2])
{
    out[0] = -10 * sin(2 * M_PI * i / sides);
    out[1] = 10 * cos(2 * M_PI * i / sides);
}

static void flat_multi(char *text, size_t size, unsigned sides, unsigned depth,
                       const unsigned cut[3])
{
    uint8_t l[LOFT_SIDES_MAX];

    loft_multiindex_first(l, sides, depth);
    do {
        double at[2] = { 0, 0 };
        for (unsigned i = 0; i < sides; i++) {
            double v[2];
            vertex_of(sides, i, v);
            at[0] += v[0] * l[i] / depth;
            at[1] += v[1] * l[i] / depth;
        }
        if (cut == NULL ||
            (l[0] + cut[0] <= depth && l[1] + cut[1] <= depth && l[2] + cut[2] <= depth))
            say_text(text, size, "%.17g %.17g 3\n", at[0], at[1]);
    } while (loft_multiindex_next(l, sides));
}

static void flat_zheng_ball(char *text, size_t size, unsigned sides, unsigned degree)
{
    for (unsigned c = 0; c < sides; c++)
        for (unsigned a = 0; a < degree / 2 + 1; a++)
            for (unsigned b = 0; b < (degree + 1) / 2; b++) {
                const double s = 2.0 * a / degree, t = 2.0 * b / degree;
                double v[2], next[2], last[2];
                vertex_of(sides, c, v);
                vertex_of(sides, (c + 1) % sides, next);
                vertex_of(sides, (c + sides - 1) % sides, last);
                for (int k = 0; k < 2; k++)
                    v[k] = (1 - s) * (1 - t) * v[k] + s * (1 - t) * (v[k] + next[k]) / 2 +
                           (1 - s) * t * (v[k] + last[k]) / 2;
                say_text(text, size, "%.17g %.17g 3\n", v[0], v[1]);
            }
    if (degree % 2 == 0)
        say_text(text, size, "0 0 3\n");
}

#define KINDS 11

/* The text of flat patch k over a regular polygon of radius 10. Returns its number of sides. */
static unsigned flat_text(char *text, size_t size, unsigned k)
{
    static const unsigned cuts[3][3] = { { 0, 0, 0 }, { 2, 0, 1 }, { 1, 2, 2 } };

    *text = '\0';
    if (k < 3) {
        say_text(text, size, k == 2 ? "spatch 8 1 meanvalue\n" : "spatch %u %u\n", 5 + k, 3 - k);
        flat_multi(text, size, k == 2 ? 8 : 5 + k, 3 - k, NULL);
        return k == 2 ? 8 : 5 + k;
    }
    if (k < 6) {
        const unsigned *cut = cuts[k - 3];
        say_text(text, size, "basepoint 5 %u %u %u\n", cut[0], cut[1], cut[2]);
        flat_multi(text, size, 3, 5, cut);
        return 3u + (cut[0] > 0) + (cut[1] > 0) + (cut[2] > 0);
    }
    if (k == 9) {
        say_text(text, size, "gb 7 4\n");
        flat_zheng_ball(text, size, 7, 4);
        return 7;
    }
    if (k == 10) {                                      /* only the boundary */
        say_text(
            text, size,
            "gb 4 3\n10 0 3\n10 5 3\n10 8 3\n10 10 3\n5 10 3\n2 10 3\n0 10 3\n0 5 3\n0 2 3\n0 0 "
            "3\n2 0 3\n5 0 3\n");
        return 4;
    }
    say_text(text, size, "ring %u %u\n", k == 6 ? 3 : k - 2, k - 4);
    flat_zheng_ball(text, size, k == 6 ? 3 : k - 2, k - 4);
    return k == 6 ? 3 : k - 2;
}

static void make_mesh(mesh *m, surfaces *all, const char *text)
{
    *all = (surfaces){ 0 };
    *m = (mesh){ 0 };
    CHECK(surfaces_read_text(&heard, all, "test", text) == 0);
    CHECK(mesh_make(&heard, m, all, "test", &engine_f64, N, 3) == 0);
}

static double area_of(const mesh *m, const size_t c[3])
{
    const double *p = m->vertex[c[0]].p, *q = m->vertex[c[1]].p, *r = m->vertex[c[2]].p;
    return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

/* Are the triangles of a mesh consistent: does an edge of two triangles run in both directions, and
 * is an edge of a single triangle marked? */
static void edges_are_shared(const mesh *m)
{
    for (size_t i = 0; i < m->cells; i++)
        for (int side = 0; side < 4; side++) {
            const size_t from = m->cell[i].corner[side], to = m->cell[i].corner[(side + 1) % 4];
            unsigned same = 0, back = 0;
            for (size_t j = 0; j < m->cells; j++)
                for (int k = 0; k < 4; k++) {
                    const size_t p = m->cell[j].corner[k], q = m->cell[j].corner[(k + 1) % 4];
                    same += p == from && q == to;
                    back += p == to && q == from;
                }
            CHECK(same == 1 && back + (m->cell[i].line >> (side + 4) & 1) == 1);
        }
}

/* The cells of a flat patch cover the polygon once: none is inverted, and their areas sum to its
 * area, which the marked edges enclose. Normals point up, and nothing is curved. */
static void kites_cover_the_patch_once(arb *a)
{
    char text[20000];
    surfaces all;
    mesh m;

    (void)a;
    for (unsigned k = 0; k < KINDS; k++) {
        const unsigned sides = flat_text(text, sizeof text, k);
        double area = 0, around = 0;
        unsigned edges = 0;
        make_mesh(&m, &all, text);
        CHECK(surface_kites(&all.surface[0]) == sides && m.cells == sides * N / 2 * N / 2 &&
              m.vertices == sides * (N / 2 + 1) * (N / 2) + 1);
        for (size_t i = 0; i < m.cells; i++) {
            const size_t *c = m.cell[i].corner,
                         half[2][3] = { { c[0], c[1], c[2] }, { c[0], c[2], c[3] } };
            for (int h = 0; h < 2; h++) {
                CHECK(area_of(&m, half[h]) > 0);
                area += area_of(&m, half[h]);
            }
            for (int side = 0; side < 4; side++) {
                const double *p = m.vertex[c[side]].p, *q = m.vertex[c[(side + 1) % 4]].p;
                if (m.cell[i].line >> (side + 4) & 1) {
                    around += (p[0] * q[1] - p[1] * q[0]) / 2;
                    edges++;
                }
            }
        }
        CHECK(edges == sides * N);
        edges_are_shared(&m);
        CHECK_NEAR(area, around, 1e-9);
        for (size_t i = 0; i < m.vertices; i++) {
            CHECK_NEAR(m.vertex[i].p[2], 3, 1e-12);
            CHECK_NEAR(m.vertex[i].normal[2], 1, 1e-9);
            CHECK_NEAR(m.vertex[i].gauss, 0, 1e-6);
        }
        mesh_free(&m);
        surfaces_free(&all);
    }
}

/* Over a regular polygon with Wachspress or mean value coordinates the flat S-patch is ten times
 * its parameters. */
static const char *const hollow[] = {                   /* the first two by harmonic coordinates as
                                                         * well */
    "0 0 40 0 40 30 20 10 0 30",
    "0 0 40 0 40 20 20 20 20 40 0 40",
    "0 0 40 0 10 10 0 40",
    "0 0 40 0 40 40 30 40 30 10 10 10 10 40 0 40",
    "20 0 5 5 0 20 -5 5 -20 0 -5 -5 0 -20 5 -5",
    "0 0 40 0 40 40 10 40 10 30 30 30 30 10 0 10",
    "0 0 10 0 20 30 30 0 40 0 25 40 15 40",
    "0 0 40 0 40 30 20.01 0.001 20 30 0 30",
    "0 0 20 0 40 0 40 20 20 20 20 40 0 40"
};

/* Over polygons that are not convex, with each kind of coordinates that they have: a patch that
 * equals its polygon has the polygon's area, no triangle is inverted, and neighbours share their
 * corners. */
static void concave_polygons_are_covered_once(arb *a)
{
    char text[2000];
    surfaces all;
    mesh m;

    (void)a;
    for (size_t k = 0; k < 2 + sizeof hollow / sizeof *hollow; k++) {
        const char *at = hollow[k < 2 ? k : k - 2];
        double area = 0, whole = 0, p[SURFACE_SIDES_MAX + 1][2];
        unsigned n = 0;
        int length;
        for (; sscanf(at, "%lf %lf%n", &p[n][0], &p[n][1], &length) == 2; at += length)
            n++;
        *text = '\0';
        say_text(text, sizeof text, "spatch %u 1 %s\ndomain %s\n", n,
                 k < 2 ? "harmonic" : "meanvalue", hollow[k < 2 ? k : k - 2]);
        for (unsigned i = 0; i < n; i++) {
            say_text(text, sizeof text, "%.17g %.17g 3\n", p[i][0], p[i][1]);
            whole += (p[i][0] * p[(i + 1) % n][1] - p[i][1] * p[(i + 1) % n][0]) / 2;
        }
        make_mesh(&m, &all, text);
        for (size_t i = 0; i < m.cells; i++) {
            const size_t *c = m.cell[i].corner,
                         half[2][3] = { { c[0], c[1], c[2] }, { c[0], c[2], c[3] } };
            for (int j = 0; j < 2; j++) {
                CHECK(area_of(&m, half[j]) > 0);
                area += area_of(&m, half[j]);
            }
        }
        CHECK_NEAR(area, whole, 1e-9);
        edges_are_shared(&m);
        mesh_free(&m);
        surfaces_free(&all);
    }
}

static void parameters_are_points_of_the_polygon(arb *a)
{
    char text[20000];
    surfaces all;
    mesh m;

    (void)a;
    for (unsigned k = 0; k < 3; k++) {
        flat_text(text, sizeof text, k);
        make_mesh(&m, &all, text);
        for (size_t i = 0; i < m.vertices; i++) {
            CHECK_NEAR(m.vertex[i].p[0], 10 * m.vertex[i].u, 1e-12);
            CHECK_NEAR(m.vertex[i].p[1], 10 * m.vertex[i].v, 1e-12);
        }
        mesh_free(&m);
        surfaces_free(&all);
    }
}

/* The net of every kind: the number of its edges, and no isolated point. */
typedef struct {
    const surface *s;
    unsigned count;
    bool seen[1000];
} counting;

static void count_edge(void *context, const surface_point *from, const surface_point *to)
{
    counting *c = context;

    CHECK(from != to);
    c->seen[from - c->s->point] = c->seen[to - c->s->point] = true;
    c->count++;
}

static void nets_are_whole(arb *a)
{
    static const unsigned edges[KINDS] = { 75, 36, 8, 45, 36, 29, 9, 30, 60, 70, 28 };
    char text[20000];
    surfaces all;
    mesh m;

    (void)a;
    for (unsigned k = 0; k < KINDS; k++) {
        flat_text(text, sizeof text, k);
        make_mesh(&m, &all, text);
        counting c = { .s = &all.surface[0] };
        sided_net(c.s, count_edge, &c);
        CHECK(c.count == edges[k]);
        for (unsigned i = 0; i < c.s->count; i++)
            CHECK(c.seen[i]);
        mesh_free(&m);
        surfaces_free(&all);
    }
}

typedef struct {
    double end[2000][3];
    double radius;
    unsigned ends;
} ring_of_ends;

static void collect_piece(void *context, size_t cell, const double from[3], const double to[3])
{
    ring_of_ends *r = context;

    (void)cell;
    for (int k = 0; k < 2 && r->ends < 2000; k++)
        memcpy(r->end[r->ends++], k ? to : from, sizeof r->end[0]);
}

/* On a sphere of radius 5 each contour is a closed circle of radius sqrt(25 - z^2), minus at most
 * the sagitta of a cell. Every end of a piece coincides with one other. */
static void contours_are_closed_rings(arb *a)
{
    static ring_of_ends r;
    const double z = arb_below(a, 9000) / 1000.0 - 4.5, radius = sqrt(25 - z * z);
    surfaces all;
    mesh m;

    make_mesh(&m, &all, "sphere 5\n");
    r.ends = 0;
    contour_lines(&m, z, collect_piece, &r);
    CHECK(r.ends >= 2 * N);
    for (unsigned i = 0; i < r.ends; i++) {
        unsigned met = 0;
        for (unsigned k = 0; k < r.ends; k++)
            met += k != i && hypot(r.end[i][0] - r.end[k][0], r.end[i][1] - r.end[k][1]) < 1e-9;
        CHECK(met == 1);
        CHECK(r.end[i][2] == z);
        const double distance = hypot(r.end[i][0], r.end[i][1]);
        CHECK(distance < radius + 1e-9 &&
              hypot(distance, z) > 5 * cos(M_PI / N) * cos(M_PI / 2 / N));
    }
    mesh_free(&m);
    surfaces_free(&all);
}

static void heights_are_round_and_within(arb *a)
{
    double height[50];
    surfaces all;
    mesh m;

    (void)a;
    make_mesh(&m, &all, "sphere 5\n");
    const size_t count = contour_heights(&m, 10, height, 50);
    CHECK(count == 9);
    for (size_t i = 0; i < count; i++)
        CHECK_NEAR(height[i], (double)i - 4, 1e-12);
    CHECK(contour_heights(&m, 10, height, 3) == 3);
    mesh_free(&m);
    surfaces_free(&all);
}

/* What is refused, and on which line. */
static void broken_texts_are_refused(arb *a)
{
    static const char *const text[][2] = {
        { "spatch 2 3\n", "test:1: not sides and depth" },
        { "spatch 5 3 harmonical\n", "test:1: not a kind of coordinates" },
        { "spatch 3 1\n0 0\n1 0\n", "test:1: spatch with 2 points" },
        { "spatch 3 1\ndomain 0 0 1 0\n0 0\n1 0\n0 1\n", "test:1: 3 sides over a domain of 2" },
        { "spatch 3 1\n0 0\n1 0\n0 1\n1 1\n", "test:5: more than the 3 points" },
        { "toric\n0 0\n", "test:2: no polygon" },
        { "toric\ndomain 0 0  1 0  0.5 1\n0 0\n", "test:3: no polygon" },
        { "toric\n", "test:1: toric without a polygon" },
        { "toric\ndomain 0 0  1 0  0 1\n0 0 0 : 1 0\n", "test:3: not a point" },
        { "basepoint 3 2 1 0\n", "test:1: not a cut" },
        { "basepoint 3\n", "test:1: not a degree and three cuts" },
        { "ring 4 3\n", "test:1: not sides and degree" },
        { "ring 5 3\n0 0 0 : 2\n", "test:2: not a point" },
        { "gb 5 2\n", "test:1: not sides and degree" },
        { "gb 4 3\n0 0\n1 0\n", "test:1: gb with 2 points" },
        { "tensor 1 1\ndomain 0 0\n", "test:2: a polygon of no patch" },
        { "spatch 4 1\ndomain 0 0 0 4 4 4 4 0\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: the vertices of the domain run clockwise: list" },
        { "spatch 4 1\ndomain 0 0 4 4 4 0 0 4\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: sides 1 and 3 of the domain meet at (2, 2): list" },
        { "spatch 4 1\ndomain 0 0 4 0 4 0 0 4\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: vertices 2 and 3 of the domain are one point, (4, 0): " },
        { "spatch 4 1\ndomain 0 0 4 0 -1 0 2 4\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: the domain folds back onto itself at vertex 2, (4, 0)" },
        { "spatch 4 1\ndomain 0 0 4 0 1 1 0 4\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: the domain is not convex at vertex 3, (1, 1), which" },
        { "spatch 4 1\ndomain 0 0 4 0 4 1e-30 0 4\n0 0\n0 4\n4 4\n4 0\n",
          "test:1: vertex 3 of the domain, (4, 1e-30)" },
        { "spatch 3 1\ndomain 0 0 1\n", "test:2: not a vertex" },
        { "spatch 3 1\ndomain 0 0 1 0 2 0 3 0 4 0 5 0 6 0 7 0 8 0\n",
          "test:2: more than 8 vertices" }
    };
    surfaces all;

    (void)a;
    for (size_t i = 0; i < sizeof text / sizeof text[0]; i++) {
        all = (surfaces){ 0 };
        caught[0] = '\0';
        CHECK(surfaces_read_text(&heard, &all, "test", text[i][0]) == EX_DATAERR);
        CHECK(strncmp(caught, text[i][1], strlen(text[i][1])) == 0);
        surfaces_free(&all);
    }
}

int main(void)
{
    PROPERTY(kites_cover_the_patch_once, 1);
    PROPERTY(concave_polygons_are_covered_once, 1);
    PROPERTY(parameters_are_points_of_the_polygon, 1);
    PROPERTY(nets_are_whole, 1);
    PROPERTY(contours_are_closed_rings, 40);
    PROPERTY(heights_are_round_and_within, 1);
    PROPERTY(broken_texts_are_refused, 1);
    return check_failures();
}
