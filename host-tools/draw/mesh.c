/* host-tools/draw/mesh.c -- triangles of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"     /* LOFT_SINGULAR */

#include "draw/mesh.h"
#include "geometry/drawn_surface.h"
#include "engine/sided.h"   /* sided_spot */
#include "base/host.h"
#include "base/memory.h"

static void make_vertex(const surface *s, unsigned kite, double u, double v, mesh_vertex *out)
{
    double at[2] = { u, v };

    if (surface_is_sided(s))
        sided_spot(s, sided_kite(s, kite, u, v), at);
    *out = (mesh_vertex){ .u = at[0], .v = at[1] };
}

/* Compute the point in the number type of `e`, the rest in double; of a degree above those of the
 * library all in double. A degenerate surface (a line) has no normal. */
static int add_vertex(mesh *m, const engine *e, const surface *s, const engine_surface *held,
                      const engine_surface *fine, unsigned kite, double u, double v)
{
    mesh_vertex *out = &m->vertex[m->vertices];
    engine_look here;

    make_vertex(s, kite, u, v, out);
    int status = held ? e->surface->kite(held, kite, u, v, out->p) : 0;
    if (status != 0)
        return status;
    status = held ? engine_f64.surface->look(fine, kite, u, v, &here)
                  : drawn_surface(s, u, v, out->p, &here);
    if (status == 0) {
        memcpy(out->normal, here.normal, sizeof out->normal);
        out->gauss = here.gauss;
        out->mean  = here.mean;
    }
    if (status == LOFT_SINGULAR)
        status = 0;
    m->vertices += status == 0;
    return status;
}

static bool on_marked_line(unsigned i, unsigned n, unsigned lines)
{
    return i % lines == 0 || i == n;
}

/* Which sides of a cell lie on drawn lines; `at` counts the lines in its own direction. */
static unsigned char side_marks(unsigned side, unsigned at, unsigned n, unsigned lines)
{
    return (unsigned char)((on_marked_line(at, n, lines) ? 1u << side : 0) |
                           (at == 0 || at == n ? 16u << side : 0));
}

static void square_cells(mesh *m, size_t first, unsigned n, unsigned lines)
{
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++) {
            const size_t at = first + i * (n + 1) + j;
            m->cell[m->cells++] = (mesh_cell){
                { at, at + n + 1, at + n + 2, at + 1 },
                (unsigned char)(side_marks(0, j, n, lines) | side_marks(1, i + 1, n, lines) |
                                side_marks(2, j + 1, n, lines) | side_marks(3, i, n, lines))
            };
        }
}

/* Row i has i + 1 points, j = 0..i towards v. Below each row but the last are i + 1 upright
 * triangles and i inverted ones. The lines are i constant, j constant, and i - j constant. */
static void triangle_cells(mesh *m, size_t first, unsigned n, unsigned lines)
{
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j <= i; j++) {
            const size_t at = first + i * (i + 1) / 2 + j, below = at + i + 1;
            m->cell[m->cells++] = (mesh_cell){ { at, below, below + 1, below + 1 },
                                               (unsigned char)(side_marks(0, j, n, lines) |
                                                               side_marks(1, i + 1, n, lines) |
                                                               side_marks(3, i - j, n, lines)) };
            if (j < i)
                m->cell[m->cells++] = (mesh_cell){ { at, below + 1, at + 1, at + 1 },
                                                   (unsigned char)(side_marks(0, i - j, n, lines) |
                                                                   side_marks(1, j + 1, n, lines) |
                                                                   side_marks(3, i, n, lines)) };
        }
}

static int add_surface(mesh *m, const surface *s, const engine *e, const engine_surface *held,
                       const engine_surface *fine, unsigned n, unsigned lines)
{
    const bool triangle = surface_is_triangle(s);
    const size_t first = m->vertices;
    int status = 0;

    for (unsigned i = 0; i <= n; i++)
        for (unsigned j = 0; j <= (triangle ? i : n) && status == 0; j++)
            status = add_vertex(m, e, s, held, fine, 0, (triangle ? i - j : i) / (double)n,
                                j / (double)n);
    if (status == 0 && triangle)
        triangle_cells(m, first, n, lines);
    else if (status == 0)
        square_cells(m, first, n, lines);
    return status;
}

/* Index of a node; kites have h x h cells. */
static size_t node_index(sided_node at, unsigned h)
{
    return ((size_t)at.kite * (h + 1) + at.i) * (h + 1) + at.j;
}

static void kite_cells(mesh *m, const surface *s, const size_t vertex[], unsigned kite, unsigned h,
                       unsigned lines)
{
    const bool border = sided_is_border(s, kite, false), before = sided_is_border(s, kite, true);

    for (unsigned i = 0; i < h; i++)
        for (unsigned j = 0; j < h; j++) {
            const size_t at = node_index((sided_node){ kite, i, j }, h);
            const unsigned line = (j % lines == 0 ? 1u : 0) | (j == 0 && border ? 16u : 0) |
                                  ((i + 1) % lines == 0 ? 2u : 0) |
                                  ((j + 1) % lines == 0 ? 4u : 0) | (i % lines == 0 ? 8u : 0) |
                                  (i == 0 && before ? 128u : 0);
            m->cell[m->cells++] = (mesh_cell){ { vertex[at], vertex[at + h + 1], vertex[at + h + 2],
                                                 vertex[at + 1] },
                                               (unsigned char)line };
        }
}

/* A point that several kites share becomes one vertex. */
static int kite_vertices(mesh *m, const surface *s, const engine *e, const engine_surface *held,
                         const engine_surface *fine, unsigned h, size_t vertex[])
{
    const unsigned kites = surface_kites(s);
    int status = 0;

    for (unsigned all = 0; all < 2; all++)                  /* first those that own it */
        for (unsigned k = 0; k < kites; k++)
            for (unsigned i = 0; i <= h; i++)
                for (unsigned j = 0; j <= h && status == 0; j++) {
                    const sided_node at = { k, i, j };
                    const size_t here = node_index(at, h),
                                 owner = node_index(sided_owner(s, at, h), h);
                    if (all)
                        vertex[here] = vertex[owner];
                    else if (here == owner) {
                        vertex[here] = m->vertices;
                        status = add_vertex(m, e, s, held, fine, k, i / (double)h, j / (double)h);
                    }
                }
    return status;
}

static int add_kites(mesh *m, const surface *s, const engine *e, const engine_surface *held,
                     const engine_surface *fine, unsigned n, unsigned lines)
{
    const unsigned h = n > 1 ? n / 2 : 1, kites = surface_kites(s);
    size_t *vertex = memory_grow(NULL, (size_t)kites * (h + 1) * (h + 1) * sizeof *vertex);
    const int status = kite_vertices(m, s, e, held, fine, h, vertex);

    for (unsigned k = 0; k < kites && status == 0; k++)
        kite_cells(m, s, vertex, k, h, lines < h ? lines : h);
    free(vertex);
    return status;
}

static size_t count_kites(const surfaces *all)
{
    size_t kites = 0;

    for (size_t k = 0; k < all->count; k++)
        kites += surface_kites(&all->surface[k]);
    return kites;
}

static int mesh_surface(mesh *m, const surface *s, const engine *e, unsigned n, unsigned lines)
{
    engine_surface *held, *fine;

    if (surface_is_high(s))
        return add_surface(m, s, e, NULL, NULL, n, lines);
    int status = e->surface->open(s, &held);
    if (status != 0)
        return status;
    status = engine_f64.surface->open(s, &fine);
    if (status == 0) {
        status = (surface_is_sided(s) ? add_kites : add_surface)(m, s, e, held, fine, n, lines);
        engine_f64.surface->close(fine);
    }
    e->surface->close(held);
    return status;
}

int mesh_make(host *h, mesh *m, const surfaces *all, const char *file, const engine *e, unsigned n,
              unsigned lines)
{
    const size_t kites = count_kites(all);

    m->vertex = memory_grow(NULL, kites * (n + 1) * (n + 1) * sizeof *m->vertex);
    m->cell   = memory_grow(NULL, kites * n * n * sizeof *m->cell);
    for (size_t k = 0; k < all->count; k++) {
        const surface *s = &all->surface[k];
        const int status = mesh_surface(m, s, e, n, lines);
        if (status != 0)
            return host_error(h, EX_DATAERR, "surface.not-computed", (host_place){ file, s->line },
                              NULL, "%s: %s", surface_name(s->kind), surface_status(s, status));
    }
    m->mapped = m->vertices;
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
