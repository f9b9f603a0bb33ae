/* tests/host/test_mesh.c -- normals and curvatures of meshes against closed forms; what the text format of surfaces holds
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "drawn.h"          /* CHECK, tool_error */
#include "mesh.h"

#define N 12

static void make(mesh *m, const char *text)
{
    surfaces all = { 0 };

    *m = (mesh){ 0 };
    CHECK(surfaces_read_text(&all, "test", text) == 0);
    CHECK(mesh_make(m, &all, "test", &engine_f64, N, 4) == 0);
    surfaces_free(&all);
}

static void check_vertex(const mesh_vertex *v, const double normal[3], double gauss, double mean, double within)
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
        make(&m, text[k]);
        CHECK(m.vertices == (k ? (N + 1) * (N + 2) / 2 : (N + 1) * (N + 1)) && m.cells == N * N);
        for (size_t i = 0; i < m.vertices; i++) {
            const double normal[3] = { (m.vertex[i].p[0] - 1) / 4, (m.vertex[i].p[1] - 2) / 4, (m.vertex[i].p[2] - 3) / 4 };
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
    make(&m, "tensor 2 1\n0 0 0 : 256\n0 30 0 : 256\n0 0 15 : 181.0193359837562\n0 30 15 : 181.0193359837562\n15 0 15 : 256\n15 30 15 : 256\n");
    for (size_t i = 0; i < m.vertices; i++) {
        const double normal[3] = { (m.vertex[i].p[0] - 15) / 15, 0, m.vertex[i].p[2] / 15 };
        check_vertex(&m.vertex[i], normal, 0, -1 / 30.0, 1e-7);
    }
    mesh_free(&m);
}

/* z = x y / 10, as a tensor product, which the library looks at, and with slopes, where differences do. */
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
        make(&m, text[k]);
        for (size_t i = 0; i < m.vertices; i++) {
            const double p = m.vertex[i].p[1] / 10, q = m.vertex[i].p[0] / 10, w = 1 + p * p + q * q;
            const double normal[3] = { -p / sqrt(w), -q / sqrt(w), 1 / sqrt(w) };
            check_vertex(&m.vertex[i], normal, -0.01 / (w * w), -p * q * 0.1 / (w * sqrt(w)), k ? 5e-3 : 1e-9);
        }
        mesh_free(&m);
    }
}

/* Every corner of a cell turns left as seen from the normal; edges are marked all around and nowhere else. */
static void cells_face_their_normals(arb *a)
{
    static const char *const text[3] = { "tensor 1 1\n0 0 0\n0 10 0\n10 0 0\n10 10 10\n", "triangle\n0 0 0\n9 0 1\n0 9 2\n", "sphere 5\n" };
    mesh m;

    (void)a;
    for (int k = 0; k < 3; k++) {
        unsigned edges = 0;
        make(&m, text[k]);
        for (size_t i = 0; i < m.cells; i++) {
            const mesh_vertex *v[3] = { &m.vertex[m.cell[i].corner[0]], &m.vertex[m.cell[i].corner[1]], &m.vertex[m.cell[i].corner[2]] };
            double along = 0;
            for (int c = 0; c < 3; c++) {
                const int y = (c + 1) % 3, z = (c + 2) % 3;
                along += v[0]->normal[c] * ((v[1]->p[y] - v[0]->p[y]) * (v[2]->p[z] - v[0]->p[z]) - (v[1]->p[z] - v[0]->p[z]) * (v[2]->p[y] - v[0]->p[y]));
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

int main(void)
{
    PROPERTY(spheres_are_round, 1);
    PROPERTY(cylinders_bend_one_way, 1);
    PROPERTY(saddles_bend_both_ways, 1);
    PROPERTY(cells_face_their_normals, 1);
    return check_failures();
}
