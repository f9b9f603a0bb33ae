/* host-tools/mesh.c -- triangles of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh.h"
#include "sided.h"      /* sided_spot */
#include "tool.h"       /* tool_error, tool_grow, sysexits */

#define STEP 1e-3       /* of a parameter, for differences */

typedef double vector[ENGINE_AXES];

static double dot(const vector a, const vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const vector a, const vector b, vector out)
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Nine points around (u, v), one STEP apart: index 3 (i + 1) + j + 1 at (u + i STEP, v + j STEP). */
static int stencil(const engine_surface *held, unsigned kite, double u, double v, vector at[9])
{
    int status = 0;

    for (int k = 0; k < 9 && status == 0; k++)
        status = engine_f64.surface->kite(held, kite, u + (k / 3 - 1) * STEP, v + (k % 3 - 1) * STEP, at[k]);
    return status;
}

/* Normal and curvatures from the two fundamental forms; 0 where there is no tangent plane. */
static void look(const vector at[9], mesh_vertex *out)
{
    vector a, b, aa, ab, bb, n;

    for (int i = 0; i < 3; i++) {
        a[i]  = (at[7][i] - at[1][i]) / (2 * STEP);
        b[i]  = (at[5][i] - at[3][i]) / (2 * STEP);
        aa[i] = (at[7][i] - 2 * at[4][i] + at[1][i]) / (STEP * STEP);
        bb[i] = (at[5][i] - 2 * at[4][i] + at[3][i]) / (STEP * STEP);
        ab[i] = (at[8][i] - at[6][i] - at[2][i] + at[0][i]) / (4 * STEP * STEP);
    }
    cross(a, b, n);
    const double length = sqrt(dot(n, n)), area = length * length;
    if (!(length > 1e-9 * (dot(a, a) + dot(b, b))))
        return;
    for (int i = 0; i < 3; i++)
        out->normal[i] = n[i] / length;
    const double e = dot(a, a), f = dot(a, b), g = dot(b, b);
    const double l = dot(aa, out->normal), m = dot(ab, out->normal), k = dot(bb, out->normal);
    out->gauss = (l * k - m * m) / area;
    out->mean  = (e * k - 2 * f * m + g * l) / (2 * area);
}

/* The parameters as near as the nine points stay on the surface. */
static void inside(bool triangle, double *u, double *v)
{
    if (triangle) {
        *u = 2 * STEP + *u * (1 - 6 * STEP);
        *v = 2 * STEP + *v * (1 - 6 * STEP);
    } else {
        *u = fmin(fmax(*u, STEP), 1 - STEP);
        *v = fmin(fmax(*v, STEP), 1 - STEP);
    }
}

/* By differences, a little inside. */
static int look_around(const surface *s, const engine_surface *fine, unsigned kite, double u, double v, mesh_vertex *out)
{
    vector at[9];

    inside(surface_is_triangle(s), &u, &v);
    const int status = stencil(fine, kite, u, v, at);
    if (status == 0)
        look((const vector *)at, out);
    return status;
}

static void place(const surface *s, unsigned kite, double u, double v, mesh_vertex *out)
{
    double at[2] = { u, v };

    if (surface_is_sided(s))
        sided_spot(s, sided_kite(s, kite, u, v), at);
    *out = (mesh_vertex){ .u = at[0], .v = at[1] };
}

/* What the library says, or, where it says nothing (a kind it does not look at, the pole of a sphere), differences. */
static int add_vertex(mesh *m, const engine *e, const surface *s, const engine_surface *held, const engine_surface *fine, unsigned kite,
                      double u, double v)
{
    mesh_vertex *out = &m->vertex[m->vertices];
    engine_look here;

    place(s, kite, u, v, out);
    int status = e->surface->kite(held, kite, u, v, out->p);
    if (status != 0)
        return status;
    if (engine_f64.surface->look(fine, kite, u, v, &here) == 0) {
        memcpy(out->normal, here.normal, sizeof out->normal);
        out->gauss = here.gauss;
        out->mean  = here.mean;
    } else {
        status = look_around(s, fine, kite, u, v, out);
    }
    m->vertices += status == 0;
    return status;
}

static bool on_line(unsigned i, unsigned n, unsigned lines) { return i % lines == 0 || i == n; }

/* Which of the sides of a cell are lines: `at` counts the lines of its own direction. */
static unsigned char mark(unsigned side, unsigned at, unsigned n, unsigned lines)
{
    return (unsigned char)((on_line(at, n, lines) ? 1u << side : 0) | (at == 0 || at == n ? 16u << side : 0));
}

static void square_cells(mesh *m, size_t first, unsigned n, unsigned lines)
{
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++) {
            const size_t at = first + i * (n + 1) + j;
            m->cell[m->cells++] = (mesh_cell){ { at, at + n + 1, at + n + 2, at + 1 },
                (unsigned char)(mark(0, j, n, lines) | mark(1, i + 1, n, lines) | mark(2, j + 1, n, lines) | mark(3, i, n, lines)) };
        }
}

/* Row i has i + 1 points, j = 0..i of them towards v; below each row but the last one stand i + 1 upright triangles and i
 * inverted ones. Lines: i constant, j constant, i - j constant. */
static void triangle_cells(mesh *m, size_t first, unsigned n, unsigned lines)
{
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j <= i; j++) {
            const size_t at = first + i * (i + 1) / 2 + j, below = at + i + 1;
            m->cell[m->cells++] = (mesh_cell){ { at, below, below + 1, below + 1 },
                (unsigned char)(mark(0, j, n, lines) | mark(1, i + 1, n, lines) | mark(3, i - j, n, lines)) };
            if (j < i)
                m->cell[m->cells++] = (mesh_cell){ { at, below + 1, at + 1, at + 1 },
                    (unsigned char)(mark(0, i - j, n, lines) | mark(1, j + 1, n, lines) | mark(3, i, n, lines)) };
        }
}

static int add_surface(mesh *m, const surface *s, const engine *e, const engine_surface *held, const engine_surface *fine, unsigned n, unsigned lines)
{
    const bool triangle = surface_is_triangle(s);
    const size_t first = m->vertices;
    int status = 0;

    for (unsigned i = 0; i <= n; i++)
        for (unsigned j = 0; j <= (triangle ? i : n) && status == 0; j++)
            status = add_vertex(m, e, s, held, fine, 0, (triangle ? i - j : i) / (double)n, j / (double)n);
    if (status == 0 && triangle)
        triangle_cells(m, first, n, lines);
    else if (status == 0)
        square_cells(m, first, n, lines);
    return status;
}

/* Kites of h x h cells. Each has its vertices but those of its line v = 1, which are the line u = 1 of the kite before it; one vertex
 * in the middle is common to all. */
static size_t kite_vertex(const surface *s, size_t first, unsigned kite, unsigned i, unsigned j, unsigned h)
{
    const unsigned kites = surface_kites(s), own = (h + 1) * h;

    if (i == h && j == h)
        return first + (size_t)kites * own;
    if (j == h)
        return first + (kite + kites - 1) % kites * own + h * h + i;
    return first + kite * own + i * h + j;
}

static void kite_cells(mesh *m, const surface *s, size_t first, unsigned kite, unsigned h, unsigned lines)
{
    for (unsigned i = 0; i < h; i++)
        for (unsigned j = 0; j < h; j++) {
            const unsigned line = (j % lines == 0 ? 1u : 0) | (j == 0 ? 16u : 0) | ((i + 1) % lines == 0 ? 2u : 0)
                                | ((j + 1) % lines == 0 ? 4u : 0) | (i % lines == 0 ? 8u : 0) | (i == 0 ? 128u : 0);
            m->cell[m->cells++] = (mesh_cell){ { kite_vertex(s, first, kite, i, j, h), kite_vertex(s, first, kite, i + 1, j, h),
                kite_vertex(s, first, kite, i + 1, j + 1, h), kite_vertex(s, first, kite, i, j + 1, h) }, (unsigned char)line };
        }
}

static int add_kites(mesh *m, const surface *s, const engine *e, const engine_surface *held, const engine_surface *fine, unsigned n, unsigned lines)
{
    const unsigned h = n > 1 ? n / 2 : 1, kites = surface_kites(s);
    const size_t first = m->vertices;
    int status = 0;

    for (unsigned k = 0; k < kites; k++)
        for (unsigned i = 0; i <= h; i++)
            for (unsigned j = 0; j < h && status == 0; j++)
                status = add_vertex(m, e, s, held, fine, k, i / (double)h, j / (double)h);
    if (status == 0)
        status = add_vertex(m, e, s, held, fine, 0, 1, 1);
    for (unsigned k = 0; k < kites && status == 0; k++)
        kite_cells(m, s, first, k, h, lines < h ? lines : h);
    return status;
}

static size_t sum_of_kites(const surfaces *all)
{
    size_t kites = 0;

    for (size_t k = 0; k < all->count; k++)
        kites += surface_kites(&all->surface[k]);
    return kites;
}

int mesh_make(mesh *m, const surfaces *all, const char *file, const engine *e, unsigned n, unsigned lines)
{
    const size_t kites = sum_of_kites(all);

    m->vertex = tool_grow(NULL, kites * (n + 1) * (n + 1) * sizeof *m->vertex);
    m->cell   = tool_grow(NULL, kites * n * n * sizeof *m->cell);
    for (size_t k = 0; k < all->count; k++) {
        const surface *s = &all->surface[k];
        engine_surface *held = NULL, *fine = NULL;
        int status = e->surface->open(s, &held);
        if (status == 0) {
            status = engine_f64.surface->open(s, &fine);
            if (status == 0) {
                status = (surface_is_sided(s) ? add_kites : add_surface)(m, s, e, held, fine, n, lines);
                engine_f64.surface->close(fine);
            }
            e->surface->close(held);
        }
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: %s: %s", file, s->line, surface_name(s->kind), engine_status(status));
    }
    return 0;
}

void mesh_free(mesh *m)
{
    free(m->vertex);
    free(m->cell);
    *m = (mesh){ 0 };
}

double mesh_bend(const mesh_vertex *v)
{
    return fabs(v->mean) + sqrt(fmax(v->mean * v->mean - v->gauss, 0));
}
