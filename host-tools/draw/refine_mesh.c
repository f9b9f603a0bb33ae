/* host-tools/draw/refine_mesh.c -- refined triangles as cells; whether they close, and their volume
 * SPDX-License-Identifier: MIT
 *
 * The volume is a sixth of the sum of the determinants of the corners, from the first node. A
 * tetrahedron from there has its centroid at a quarter of the sum of its corners.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"
#include "draw/refine.h"
#include "num/status.h"     /* LOFT_SINGULAR */

#define NONE SIZE_MAX

/* The corner of a mesh for each node, and the surface for which it was made. */
typedef struct {
    size_t vertex, surface;
} corner_of_node;

static int add_corner(mesh *m, const refined *r, const engine_surface *fine,
                      const refined_triangle *t, const refined_place *x)
{
    mesh_vertex *out = &m->vertex[m->vertices];
    engine_look here;

    *out = (mesh_vertex){ .u = x->u, .v = x->v };
    memcpy(out->p, r->node[x->node], sizeof out->p);
    const int status = engine_f64.surface->look(fine, t->kite, x->u, x->v, &here);
    if (status == LOFT_OK) {
        memcpy(out->normal, here.normal, sizeof out->normal);
        out->gauss = here.gauss;
        out->mean  = here.mean;
    }
    m->vertices++;
    return status == LOFT_SINGULAR ? LOFT_OK : status;
}

static int add_cell(mesh *m, const refined *r, const engine_surface *fine,
                    const refined_triangle *t, corner_of_node known[])
{
    mesh_cell cell = { { 0 }, 0 };
    int status = LOFT_OK;

    for (int i = 0; i < 3 && status == LOFT_OK; i++) {
        corner_of_node *at = &known[t->at[i].node];
        if (at->surface != t->surface) {
            *at = (corner_of_node){ m->vertices, t->surface };
            status = add_corner(m, r, fine, t, &t->at[i]);
        }
        cell.corner[i] = at->vertex;
    }
    cell.corner[3] = cell.corner[2];
    m->cell[m->cells++] = cell;
    return status;
}

static int by_surface(const void *a, const void *b)
{
    const refined_triangle *x = a, *y = b;
    return (x->surface > y->surface) - (x->surface < y->surface);
}

int refined_mesh(host *h, refined *r, const surfaces *all, const char *file, mesh *m)
{
    corner_of_node *known = memory_grow(NULL, (r->nodes + 1) * sizeof *known);
    size_t done = 0;
    int code = 0;

    for (size_t k = 0; k < r->nodes; k++)
        known[k].surface = NONE;
    m->vertex = memory_grow(NULL, (3 * r->triangles + 1) * sizeof *m->vertex);
    m->cell   = memory_grow(NULL, (r->triangles + 1) * sizeof *m->cell);
    qsort(r->triangle, r->triangles, sizeof *r->triangle, by_surface);
    while (done < r->triangles && code == 0) {
        const size_t which = r->triangle[done].surface;
        const surface *s = &all->surface[which];
        engine_surface *fine;
        int status = engine_f64.surface->open(s, &fine);
        const bool opened = status == LOFT_OK;
        for (; done < r->triangles && r->triangle[done].surface == which && status == LOFT_OK;
             done++)
            status = add_cell(m, r, fine, &r->triangle[done], known);
        if (opened)
            engine_f64.surface->close(fine);
        if (status != LOFT_OK)
            code = host_error(h, EX_DATAERR, "surface.not-computed", (host_place){ file, s->line },
                              NULL, "%s: %s", surface_name(s->kind), surface_status(s, status));
    }
    free(known);
    return code;
}


// Bodies
// ------

typedef struct {
    size_t low, high;
    bool along;                 /* its triangle runs from low to high */
} side;

static int by_ends(const void *a, const void *b)
{
    const side *x = a, *y = b;
    return x->low != y->low ? (x->low > y->low) - (x->low < y->low)
                            : (x->high > y->high) - (x->high < y->high);
}

static void count_edges(const refined *r, refined_sum *out)
{
    const size_t all = 3 * r->triangles;
    side *s = memory_grow(NULL, (all + 1) * sizeof *s);

    for (size_t k = 0; k < all; k++) {
        const refined_triangle *t = &r->triangle[k / 3];
        const size_t a = t->at[k % 3].node, b = t->at[(k + 1) % 3].node;
        s[k] = (side){ a < b ? a : b, a < b ? b : a, a < b };
    }
    qsort(s, all, sizeof *s, by_ends);
    for (size_t k = 0, next; k < all; k = next) {
        size_t along = 0;
        for (next = k; next < all && by_ends(&s[k], &s[next]) == 0; next++)
            along += s[next].along;
        out->edges++;
        out->open += next - k == 1;
        out->turned += next - k == 2 && along != 1;
        out->many += next - k > 2;
    }
    free(s);
}

static void count_corners(const refined *r, refined_sum *out)
{
    bool *used = memory_grow(NULL, r->nodes + 1);

    memset(used, 0, r->nodes);
    for (size_t k = 0; k < 3 * r->triangles; k++)
        used[r->triangle[k / 3].at[k % 3].node] = true;
    for (size_t k = 0; k < r->nodes; k++)
        out->corners += used[k];
    free(used);
}

void refined_body(const refined *r, refined_sum *out)
{
    const double zero[ENGINE_AXES] = { 0 }, *from = r->nodes ? r->node[0] : zero;

    *out = (refined_sum){ .triangles = r->triangles };
    count_edges(r, out);
    count_corners(r, out);
    for (size_t k = 0; k < r->triangles; k++) {
        double p[3][3], n[3], six = 0;
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < 3; i++)
                p[c][i] = r->node[r->triangle[k].at[c].node][i] - from[i];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            n[i] = (p[1][j] - p[0][j]) * (p[2][l] - p[0][l]) -
                   (p[1][l] - p[0][l]) * (p[2][j] - p[0][j]);
            six += p[0][i] * n[i];
        }
        out->area += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
        out->volume += six / 6;
        for (int i = 0; i < 3; i++)
            out->centroid[i] += six / 24 * (p[0][i] + p[1][i] + p[2][i]);
    }
    for (int i = 0; i < 3; i++)
        out->centroid[i] = from[i] + (out->volume != 0 ? out->centroid[i] / out->volume : 0);
}
