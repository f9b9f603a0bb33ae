/* tests/tools/test_mesh.c -- normals and curvatures of meshes against closed forms; the text format
 * of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "tools/drawn.h"          /* CHECK, tool_error */
#include "engine/engine.h"
#include "draw/mesh.h"
#include "geometry/surface_text.h"

#define N 12

static void make_mesh(mesh *m, const char *text)
{
    surfaces all = { 0 };

    *m = (mesh){ 0 };
    CHECK(surfaces_read_text(&heard, &all, "test", text) == 0);
    CHECK(mesh_make(&heard, m, &all, "test", &engine_f64, N, 4) == 0);
    surfaces_free(&all);
}

static void check_vertex(const mesh_vertex *v, const double normal[3], double gauss, double mean,
                         double within)
{
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(v->normal[i], normal[i], within);
    CHECK_NEAR(v->gauss, gauss, within * (fabs(gauss) + 0.01));
    CHECK_NEAR(v->mean, mean, within * (fabs(mean) + 0.01));
}

/* Radius 4 about (1, 2, 3): outward normals, 1/16 and -1/4; the whole sphere and its eighth. */
static void spheres_are_round(arb *a)
{
    static const char *const text[2] = { "sphere 4\n1 2 3\n", "octant 4\n1 2 3\n" };
    mesh m;

    (void)a;
    for (int k = 0; k < 2; k++) {
        make_mesh(&m, text[k]);
        CHECK(m.vertices == (k ? (N + 1) * (N + 2) / 2 : (N + 1) * (N + 1)) && m.cells == N * N);
        for (size_t i = 0; i < m.vertices; i++) {
            const double normal[3] = { (m.vertex[i].p[0] - 1) / 4, (m.vertex[i].p[1] - 2) / 4,
                                       (m.vertex[i].p[2] - 3) / 4 };
            check_vertex(&m.vertex[i], normal, 1 / 16.0, -0.25, 1e-9);
            CHECK_NEAR(mesh_bend(&m.vertex[i]), 0.25, 1e-6);
        }
        mesh_free(&m);
    }
}

/* A quarter of a cylinder of radius 15 about the y axis through (15, y, 0), of rational spans. */
static void cylinders_bend_one_way(arb *a)
{
    mesh m;

    (void)a;
    make_mesh(&m, "tensor 2 1\n0 0 0 : 256\n0 30 0 : 256\n0 0 15 : 181.0193359837562\n0 30 15 : "
                  "181.0193359837562\n15 0 15 : 256\n15 30 15 : 256\n");
    for (size_t i = 0; i < m.vertices; i++) {
        const double normal[3] = { (m.vertex[i].p[0] - 15) / 15, 0, m.vertex[i].p[2] / 15 };
        check_vertex(&m.vertex[i], normal, 0, -1 / 30.0, 1e-7);
    }
    mesh_free(&m);
}

/* z = x y / 10, as a tensor product and with slopes. */
static void saddles_bend_both_ways(arb *a)
{
    static const char *const text[2] = {
        "tensor 1 1\n0 0 0\n0 10 0\n10 0 0\n10 10 10\n",
        "coons slopes 1 1\n0 0 0\n10 0 0\n0 10 0\n10 10 10\n0 10 0\n0 10 10\n0 10 0\n0 10 10\n"
        "0 0 0\n0 10 0\n10 0 0\n10 10 10\n10 0 0\n10 0 10\n10 0 0\n10 0 10\n"
    };
    mesh m;

    (void)a;
    for (int k = 0; k < 2; k++) {
        make_mesh(&m, text[k]);
        for (size_t i = 0; i < m.vertices; i++) {
            const double p = m.vertex[i].p[1] / 10, q = m.vertex[i].p[0] / 10,
                         w = 1 + p * p + q * q;
            const double normal[3] = { -p / sqrt(w), -q / sqrt(w), 1 / sqrt(w) };
            check_vertex(&m.vertex[i], normal, -0.01 / (w * w), -p * q * 0.1 / (w * sqrt(w)), 1e-9);
        }
        mesh_free(&m);
    }
}

static unsigned looked;     /* number of places with normals to compare with */

#define NODES 9         /* of a polynomial through points of the surface, at steps of STEP */
#define STEP  0.006

/* Its derivatives by two parameters, in the order of loft_differential. */
typedef struct {
    double by[5][3];
} slopes;

/* The weights of the values at the nodes for the first derivative at node i. */
static void node_weights(unsigned i, double out[NODES])
{
    static const double binomial[NODES] = { 1, -8, 28, -56, 70, -56, 28, -8, 1 };

    out[i] = 0;
    for (unsigned k = 0; k < NODES; k++)
        if (k != i) {
            out[k] = binomial[k] / binomial[i] / ((double)i - k) / STEP;
            out[i] -= out[k];
        }
}

/* A place (u, v), and two ways from it that stay on the surface: toward the far corners of a
 * triangle, or toward the far sides of a square. */
typedef struct {
    const engine_surface *held;
    unsigned kite;
    double at[2], way[2][2];
} stencil;

static void set_ways(stencil *s, bool triangle)
{
    static const double corner[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    const double u = s->at[0], v = s->at[1], share[3] = { 1 - u - v, u, v };
    const int later = share[1] >= share[2] ? 1 : 2, near = share[0] >= share[later] ? 0 : later;

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            s->way[k][i] = triangle ? corner[(near + 1 + k) % 3][i] - s->at[i]
                           : k == i ? (s->at[i] < 0.5 ? 1 : -1)
                                    : 0;
}

static slopes slopes_of(const stencil *s)
{
    double first[NODES], second[NODES] = { 0 }, w[NODES], p[3];
    slopes d = { { { 0 } } };

    node_weights(0, first);
    for (unsigned m = 0; m < NODES; m++) {
        node_weights(m, w);
        for (unsigned k = 0; k < NODES; k++)
            second[k] += first[m] * w[k];
    }
    for (unsigned a = 0; a < NODES; a++)
        for (unsigned b = 0; b < NODES; b++) {
            const double u = s->at[0] + STEP * (a * s->way[0][0] + b * s->way[1][0]);
            const double v = s->at[1] + STEP * (a * s->way[0][1] + b * s->way[1][1]);
            const double count[5] = { b ? 0 : first[a], a ? 0 : first[b], b ? 0 : second[a],
                                      first[a] * first[b], a ? 0 : second[b] };
            CHECK(engine_f64.surface->kite(s->held, s->kite, u, v, p) == 0);
            for (int k = 0; k < 5; k++)
                for (int i = 0; i < 3; i++)
                    d.by[k][i] += count[k] * p[i];
        }
    return d;
}

static double cross_product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Normal and curvatures by the fundamental forms. Returns false if there is no normal. */
static bool look_by_slopes(const stencil *s, engine_look *out)
{
    const slopes d = slopes_of(s);
    const double *a = d.by[0], *b = d.by[1];
    const double turn = s->way[0][0] * s->way[1][1] - s->way[0][1] * s->way[1][0];
    const double e = cross_product(a, a), f = cross_product(a, b), g = cross_product(b, b);
    double n[3];

    for (int i = 0; i < 3; i++)
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    const double area = cross_product(n, n);
    if (!(area > 1e-9 * (e + g) * (e + g)))
        return false;
    for (int i = 0; i < 3; i++)
        out->normal[i] = n[i] / sqrt(area) * (turn < 0 ? -1 : 1);
    const double l = cross_product(d.by[2], out->normal), m = cross_product(d.by[3], out->normal);
    const double k = cross_product(d.by[4], out->normal);
    out->gauss = (l * k - m * m) / area;
    out->mean  = (e * k - 2 * f * m + g * l) / (2 * area);
    return true;
}

/* At a vertex of a GB or a Gregory patch curvatures depend on the direction of approach. */
static void check_look(const surface *s, const engine_surface *held, unsigned kite, double u,
                       double v)
{
    stencil at = { .held = held, .kite = kite, .at = { u, v } };
    engine_look got = { .gauss = 0 }, want;

    CHECK(engine_f64.surface->look(held, kite, u, v, &got) == 0);
    CHECK_NEAR(cross_product(got.normal, got.normal), 1, 1e-12);
    set_ways(&at, surface_is_triangle(s));
    if (!look_by_slopes(&at, &want))
        return;
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(got.normal[i], want.normal[i], 1e-6);
    if (s->kind == SURFACE_GB && u == 0 && v == 0)
        return;
    if (s->kind == SURFACE_GREGORY && u * (1 - u) == 0 && v * (1 - v) == 0)
        return;
    const double bend = fabs(want.mean) + sqrt(fmax(want.mean * want.mean - want.gauss, 0));
    CHECK_NEAR(got.gauss, want.gauss, 1e-5 * (bend * bend + 1e-4));
    CHECK_NEAR(got.mean, want.mean, 1e-5 * (bend + 1e-2));
    looked++;
}

static unsigned variety_bit(const surface *s)
{
    const unsigned one = s->kind == SURFACE_COONS ? s->orders : s->rational;
    return 1u << (s->kind == SURFACE_RING ? s->n : one);
}

/* Every kind, and each variety of it, on a grid that includes its edges. */
static void normals_are_those_of_the_surface(arb *a)
{
    static const char *const file[4] = { "patch", "surfaces", "sided", "normals" };
    unsigned seen[SURFACE_KINDS] = { 0 };
    char name[64];

    (void)a;
    for (int k = 0; k < 4; k++) {
        surfaces all = { 0 };
        snprintf(name, sizeof name, "tests/drawings/%s.loft", file[k]);
        CHECK(surfaces_read(&heard, &all, name) == 0 && all.count > 0);
        for (size_t j = 0; j < all.count; j++) {
            const surface *s = &all.surface[j];
            engine_surface *held = NULL;
            seen[s->kind] |= variety_bit(s);
            CHECK(engine_f64.surface->open(s, &held) == 0);
            for (unsigned kite = 0; kite < surface_kites(s); kite++)
                for (int p = 0; p <= 4; p++)
                    for (int q = 0; q <= (surface_is_triangle(s) ? 4 - p : 4); q++)
                        check_look(s, held, kite, p / 4.0, q / 4.0);
            engine_f64.surface->close(held);
        }
        surfaces_free(&all);
    }
    for (int k = 0; k < SURFACE_KINDS; k++)
        CHECK(seen[k] != 0 || k == SURFACE_TETRA);      /* that is four triangles */
    CHECK(seen[SURFACE_TENSOR] == 3 && seen[SURFACE_TRIANGLE] == 3);
    CHECK(seen[SURFACE_COONS] == 14 && seen[SURFACE_RING] == 104 && looked > 1200);
}

/* Every corner of a cell turns left as seen from the normal. Edges are marked all around, and
 * nowhere else. */
static void cells_face_their_normals(arb *a)
{
    static const char *const text[3] = { "tensor 1 1\n0 0 0\n0 10 0\n10 0 0\n10 10 10\n",
                                         "triangle\n0 0 0\n9 0 1\n0 9 2\n", "sphere 5\n" };
    mesh m;

    (void)a;
    for (int k = 0; k < 3; k++) {
        unsigned edges = 0;
        make_mesh(&m, text[k]);
        for (size_t i = 0; i < m.cells; i++) {
            const mesh_vertex *v[3] = { &m.vertex[m.cell[i].corner[0]],
                                        &m.vertex[m.cell[i].corner[1]],
                                        &m.vertex[m.cell[i].corner[2]] };
            double along = 0;
            for (int c = 0; c < 3; c++) {
                const int y = (c + 1) % 3, z = (c + 2) % 3;
                along += v[0]->normal[c] * ((v[1]->p[y] - v[0]->p[y]) * (v[2]->p[z] - v[0]->p[z]) -
                                            (v[1]->p[z] - v[0]->p[z]) * (v[2]->p[y] - v[0]->p[y]));
            }
            CHECK(along > 0 || k == 2);
            CHECK(along > -1e-9);
            for (int side = 0; side < 4; side++)
                edges += m.cell[i].line >> (side + 4) & 1;
        }
        CHECK(edges == (k == 1 ? 3 * N : 4 * N));
        mesh_free(&m);
    }
}

/* Between two other surfaces; the faces of a straight one of degree 1 to 9 lie in its planes, with
 * their normals outward. If it is asked for, it stays what it is. */
static void tetrahedra_become_their_faces(arb *a)
{
    const unsigned n = 1 + arb_below(a, 9), count = (n + 1) * (n + 2) * (n + 3) / 6;
    const char *end = "triangle 0\n9 9 9\n";
    char text[8192];
    size_t used = (size_t)snprintf(text, sizeof text, "%stetra\n", end);
    surfaces all = { 0 }, solid = { .solids = true };

    for (unsigned m = 0; m <= n; m++)
        for (unsigned k = 0; k <= m; k++)
            for (unsigned l = 0; l <= k; l++)
                used += (size_t)snprintf(text + used, sizeof text - used, "%u %u %u\n", m - k,
                                         k - l, l);
    snprintf(text + used, sizeof text - used, "%s", end);
    CHECK(surfaces_read_text(&heard, &solid, "test", text) == 0 && solid.count == 3);
    CHECK(solid.surface[1].kind == SURFACE_TETRA && solid.surface[1].m == n);
    CHECK(solid.surface[1].count == count);
    surfaces_free(&solid);
    CHECK(surfaces_read_text(&heard, &all, "test", text) == 0 && all.count == 6);
    CHECK(all.surface[0].m == 0 && all.surface[5].m == 0 && all.surface[5].count == 1);
    for (unsigned f = 0; f < 4; f++) {
        const surface *s = &all.surface[1 + f];
        static const double out[4][3] = { { 0, 0, -1 }, { 0, -1, 0 }, { -1, 0, 0 }, { 1, 1, 1 } };
        const surface_point *p = s->point, *q = &s->point[s->count - n - 1],
                            *r = &s->point[s->count - 1];
        double normal[3];
        CHECK(s->kind == SURFACE_TRIANGLE && s->m == n && s->count == (n + 1) * (n + 2) / 2);
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            normal[i] = (q->p[j] - p->p[j]) * (r->p[k] - p->p[k]) -
                        (q->p[k] - p->p[k]) * (r->p[j] - p->p[j]);
            CHECK_NEAR(normal[i], out[f][i] * n * n, 1e-9);
        }
        for (unsigned k = 0; k < s->count; k++)
            CHECK_NEAR(cross_product(s->point[k].p, out[f]), f == 3 ? n : 0, 1e-9);
    }
    surfaces_free(&all);
}

/* Add a share of a point to the net, with its weight. */
static void add_share(surface_point *to, const surface_point *from, double share)
{
    const double w = share * from->w;

    for (int i = 0; i < 3; i++)
        to->p[i] += w * from->p[i];
    to->w += w;
}

/* The surface with all its degrees higher by one, by the definition. */
static void raise_once(surface *s)
{
    const bool triangle = s->kind == SURFACE_TRIANGLE;
    const unsigned m = s->m + 1, n = s->n + 1,
                   count = triangle ? (m + 1) * (m + 2) / 2 : (m + 1) * (n + 1);
    surface high = { .kind = s->kind, .m = m, .n = n, .rational = s->rational };

    for (unsigned k = 0; k < count; k++)
        surface_add_point(&high, &(surface_point){ .w = 0 });
    if (triangle)
        for (unsigned r = 0, p = 0; r <= s->m; r++)
            for (unsigned k = 0; k <= r; k++, p++) {
                add_share(&high.point[p], &s->point[p], (double)(m - r) / m);
                add_share(&high.point[p + r + 1], &s->point[p], (double)(r - k + 1) / m);
                add_share(&high.point[p + r + 2], &s->point[p], (double)(k + 1) / m);
            }
    else
        for (unsigned i = 0; i <= s->m; i++)
            for (unsigned j = 0; j <= s->n; j++)
                for (unsigned k = 0; k < 4; k++) {
                    const unsigned down = k / 2, right = k % 2;
                    add_share(&high.point[(i + down) * (n + 1) + j + right], &s->point[i * n + j],
                              (double)(down ? i + 1 : m - i) / m * (double)(right ? j + 1 : n - j) /
                                  n);
                }
    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            high.point[k].p[i] /= high.point[k].w;
    free(s->point);
    *s = high;
}

/* To any degree from 10 to 32: points, normals and curvatures are those of the library. */
static void a_raised_net_looks_the_same(arb *a)
{
    surface s = { .kind = arb_below(a, 2) ? SURFACE_TRIANGLE : SURFACE_TENSOR,
                  .m = 2 + arb_below(a, 7),
                  .n = 2 + arb_below(a, 7),
                  .rational = arb_below(a, 2) };
    const unsigned rows = s.m, columns = s.n, to = 10 + arb_below(a, 23);
    surfaces all = { .surface = &s, .count = 1 };
    mesh was = { 0 }, m = { 0 };

    for (unsigned i = 0; i <= rows; i++)
        for (unsigned j = 0; j <= (s.kind == SURFACE_TRIANGLE ? i : columns); j++)
            surface_add_point(&s, &(surface_point){ .p = { i * 10 + arb_below(a, 300) / 100.0,
                                                           j * 10 + arb_below(a, 300) / 100.0,
                                                           arb_below(a, 2000) / 100.0 },
                                                    .w = s.rational ? 1 + arb_below(a, 8) : 1 });
    CHECK(mesh_make(&heard, &was, &all, "test", &engine_f64, N, 4) == 0);
    while (s.m < to && (s.n < to || s.kind == SURFACE_TRIANGLE))
        raise_once(&s);
    CHECK(surface_is_high(&s) && mesh_make(&heard, &m, &all, "test", &engine_f64, N, 4) == 0);
    CHECK(m.vertices == was.vertices && m.cells == was.cells);
    for (size_t i = 0; i < m.vertices; i++) {
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(m.vertex[i].p[k], was.vertex[i].p[k], 1e-10);
        check_vertex(&m.vertex[i], was.vertex[i].normal, was.vertex[i].gauss, was.vertex[i].mean,
                     1e-8);
    }
    mesh_free(&was);
    mesh_free(&m);
    free(s.point);
}

/* An edge in one point: the normal is that of a place nearby. */
static void a_raised_cone_has_a_normal_at_its_tip(arb *a)
{
    surface s = { .kind = SURFACE_TENSOR, .m = 1, .n = 2 };
    static const double net[6][3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 },
                                      { 10, 0, 0 }, { 10, 10, 0 }, { 0, 10, 0 } };
    surfaces all = { .surface = &s, .count = 1 };
    mesh m = { 0 };

    (void)a;
    for (int k = 0; k < 6; k++)
        surface_add_point(&s, &(surface_point){ .p = { net[k][0], net[k][1], net[k][2] }, .w = 1 });
    while (s.m < 20)
        raise_once(&s);
    CHECK(mesh_make(&heard, &m, &all, "test", &engine_f64, N, 4) == 0);
    for (size_t i = 0; i < m.vertices; i++)
        check_vertex(&m.vertex[i], (const double[3]){ 0, 0, 1 }, 0, 0, 1e-9);
    mesh_free(&m);
    free(s.point);
}

/* Only where a picture is wanted; there to 32. */
static void degrees_above_nine_are_read_for_pictures(arb *a)
{
    char text[16384];
    size_t used = (size_t)snprintf(text, sizeof text, "triangle\n");
    surfaces all = { 0 }, drawn = { .drawn = true };

    (void)a;
    for (unsigned k = 0; k < 561; k++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%u %u 0\n", k % 33, k / 33);
    CHECK(surfaces_read_text(&heard, &drawn, "test", text) == 0 && drawn.surface[0].m == 32);
    CHECK(surface_is_high(&drawn.surface[0]));
    CHECK(surfaces_read_text(&heard, &all, "test", text) != 0);
    surfaces_free(&all);
    surfaces_free(&drawn);
    CHECK(surfaces_read_text(&heard, &all, "test", "tensor 10 1\n") != 0);
    surfaces_free(&all);
    drawn.drawn = true;
    CHECK(surfaces_read_text(&heard, &drawn, "test", "tensor 33 1\n") != 0);
    surfaces_free(&drawn);
    drawn.drawn = true;
    CHECK(surfaces_read_text(&heard, &drawn, "test", "coons 10 1\n") != 0);
    surfaces_free(&drawn);
}

int main(void)
{
    PROPERTY(spheres_are_round, 1);
    PROPERTY(cylinders_bend_one_way, 1);
    PROPERTY(saddles_bend_both_ways, 1);
    PROPERTY(normals_are_those_of_the_surface, 1);
    PROPERTY(cells_face_their_normals, 1);
    PROPERTY(tetrahedra_become_their_faces, 20);
    PROPERTY(a_raised_net_looks_the_same, 40);
    PROPERTY(a_raised_cone_has_a_normal_at_its_tip, 1);
    PROPERTY(degrees_above_nine_are_read_for_pictures, 1);
    return check_failures();
}
