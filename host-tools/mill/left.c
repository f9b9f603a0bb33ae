/* host-tools/mill/left.c -- what a mill left on surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mill/left.h"

/* The bin of a place, limited to the bins that exist. */
static size_t bin_along(const left_over *l, int axis, double x)
{
    const double k = floor((x - l->low[axis]) / l->size);

    return k < 0 ? 0 : k >= (double)l->bins[axis] ? l->bins[axis] - 1 : (size_t)k;
}

static size_t bin_of(const left_over *l, const double at[3])
{
    return bin_along(l, 1, at[1]) * l->bins[0] + bin_along(l, 0, at[0]);
}

static size_t first_of_work(const record *r)
{
    size_t first = 1;

    while (first < r->count && r->pulse[first].at[2] >= r->pulse[first - 1].at[2])
        first++;
    return first < r->count ? first : 0;
}

void left_make(left_over *l, const record *r, double radius, double corner)
{
    const size_t first = first_of_work(r);
    double high[2] = { 0, 0 };

    *l = (left_over){ .radius = radius, .corner = corner, .size = radius / 2 };
    for (size_t i = first; i < r->count; i++)
        for (int k = 0; k < 2; k++) {
            l->low[k] = i == first ? r->pulse[i].at[k] : fmin(l->low[k], r->pulse[i].at[k]);
            high[k] = i == first ? r->pulse[i].at[k] : fmax(high[k], r->pulse[i].at[k]);
        }
    l->size = fmax(l->size, fmax(high[0] - l->low[0], high[1] - l->low[1]) / 2000);
    for (int k = 0; k < 2; k++)
        l->bins[k] = (size_t)((high[k] - l->low[k]) / l->size) + 1;
    const size_t bins = l->bins[0] * l->bins[1];
    l->start = memory_grow(NULL, (bins + 2) * sizeof *l->start);
    memset(l->start, 0, (bins + 2) * sizeof *l->start);
    l->count = r->count - first;
    l->tip = memory_grow(NULL, (l->count + 1) * sizeof *l->tip);
    for (size_t i = first; i < r->count; i++)
        l->start[bin_of(l, r->pulse[i].at) + 2]++;
    for (size_t b = 2; b < bins + 2; b++)
        l->start[b] += l->start[b - 1];
    for (size_t i = first; i < r->count; i++)       /* afterwards start[b] is where bin b begins */
        memcpy(l->tip[l->start[bin_of(l, r->pulse[i].at) + 1]++], r->pulse[i].at, sizeof *l->tip);
}

void left_free(left_over *l)
{
    free(l->tip);
    free(l->start);
}

/* The underside of the tool over x, y; infinite beyond its radius. */
static double underside(const left_over *l, const double tip[3], const double p[3])
{
    const double d = hypot(p[0] - tip[0], p[1] - tip[1]), x = d - (l->radius - l->corner);

    if (d > l->radius)
        return INFINITY;
    return tip[2] + (x > 0 ? l->corner - sqrt(fmax(0, l->corner * l->corner - x * x)) : 0);
}

/* How deep a point is in the tool, whose shank is a cylinder: 0 beyond it. */
static double depth(const left_over *l, const double tip[3], const double p[3])
{
    const double h = p[2] - tip[2],
                 x = hypot(p[0] - tip[0], p[1] - tip[1]) - (l->radius - l->corner);
    const double inside = h >= l->corner ? fmin(h, l->corner - x)
                          : x <= 0       ? h
                                         : l->corner - hypot(x, l->corner - h);

    return fmax(0, inside);
}

/* The height of the material over a point, infinite where there is no block and the tool never was.
 * `cut`: how deep the point was in the tool, or NULL. */
static double height_at(const left_over *l, const double p[3], double *cut)
{
    const stock *const b = l->block;
    bool over = b != NULL;

    for (int k = 0; k < 2 && over; k++)
        over = fabs(p[k] - b->low[k] - b->size[k] / 2) <= b->size[k] / 2 + 1e-6;
    double height = over ? b->low[2] + b->size[2] : INFINITY;

    if (l->count == 0)
        return height;
    for (size_t j = bin_along(l, 1, p[1] - l->radius); j <= bin_along(l, 1, p[1] + l->radius); j++)
        for (size_t i = bin_along(l, 0, p[0] - l->radius); i <= bin_along(l, 0, p[0] + l->radius);
             i++) {
            const size_t bin = j * l->bins[0] + i;
            for (size_t k = l->start[bin]; k < l->start[bin + 1]; k++) {
                height = fmin(height, underside(l, l->tip[k], p));
                if (cut != NULL)
                    *cut = fmax(*cut, depth(l, l->tip[k], p));
            }
        }
    return height;
}

double left_at(void *context, const mesh_vertex *v)
{
    left_over *l = context;
    double cut = 0;
    const double height = height_at(l, v->p, &cut);

    if (height == INFINITY)
        return 0;
    const double over = cut > 0 ? -cut : (height - v->p[2]) * fabs(v->normal[2]);
    l->most[0] = fmax(l->most[0], -over);
    l->most[1] = fmax(l->most[1], over);
    return over;
}


// What is left of the block beside the surfaces
// ---------------------------------------------

#define ALONG 200               /* cells of its longer side */

/* A grid over the block. */
typedef struct {
    const left_over *l;
    mesh *m;
    size_t n[2], rows;          /* cells along x and y, and of the sides upward */
    bool *hidden;               /* the middle of a cell is over a surface */
    double *height;             /* of each corner, NAN: not known yet */
} grid;

static double grid_at(const grid *g, int axis, double i)
{
    return g->l->block->low[axis] + g->l->block->size[axis] * i / (double)g->n[axis];
}

static double grid_height(const grid *g, size_t i, size_t j)
{
    double *const h = &g->height[j * (g->n[0] + 1) + i];
    const double p[3] = { grid_at(g, 0, (double)i), grid_at(g, 1, (double)j), 0 };

    if (isnan(*h))
        *h = fmax(height_at(g->l, p, NULL), g->l->block->low[2]);
    return *h;
}

/* Twice the area of a triangle as seen from above, positive counterclockwise. */
static double area_of(const double a[3], const double b[3], const double c[3])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* The cells along an axis whose middles are within a triangle. */
static void span_of(const grid *g, const double *const at[3], int axis, size_t out[2])
{
    const double size = g->l->block->size[axis] / (double)g->n[axis], low = g->l->block->low[axis],
                 most = (double)g->n[axis],
                 from = fmin(fmin(at[0][axis], at[1][axis]), at[2][axis]),
                 to = fmax(fmax(at[0][axis], at[1][axis]), at[2][axis]);

    out[0] = (size_t)fmin(fmax(floor((from - low) / size - 0.5), 0), most);
    out[1] = (size_t)fmin(fmax(ceil((to - low) / size + 0.5), 0), most);
}

static void hide_below(grid *g, const double *const at[3])
{
    size_t x[2], y[2];

    span_of(g, at, 0, x);
    span_of(g, at, 1, y);
    for (size_t j = y[0]; j < y[1]; j++)
        for (size_t i = x[0]; i < x[1]; i++) {
            const double p[3] = { grid_at(g, 0, (double)i + 0.5), grid_at(g, 1, (double)j + 0.5) };
            const double a = area_of(at[0], at[1], p), b = area_of(at[1], at[2], p),
                         c = area_of(at[2], at[0], p);
            if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))
                g->hidden[j * g->n[0] + i] = true;
        }
}

/* A cell with corners of its own and one normal. `edges`: bit k, its side k is one of the block. */
static void add_cell(const grid *g, double p[4][3], unsigned edges)
{
    const double d[2][3] = { { p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2] },
                             { p[3][0] - p[1][0], p[3][1] - p[1][1], p[3][2] - p[1][2] } };
    const double n[3] = { d[0][1] * d[1][2] - d[0][2] * d[1][1],
                          d[0][2] * d[1][0] - d[0][0] * d[1][2],
                          d[0][0] * d[1][1] - d[0][1] * d[1][0] };
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    mesh *const m = g->m;
    mesh_cell *const c = &m->cell[m->cells++];

    *c = (mesh_cell){ .line = (unsigned char)(edges << 4) };
    for (int k = 0; k < 4; k++) {
        mesh_vertex *const v = &m->vertex[m->vertices];
        *v = (mesh_vertex){ .p = { p[k][0], p[k][1], p[k][2] } };
        for (int i = 0; i < 3 && length > 0; i++)
            v->normal[i] = n[i] / length;
        c->corner[k] = m->vertices++;
    }
}

/* Which edges of a cell are drawn. */
static unsigned edges_of(bool first, bool second, bool third, bool fourth)
{
    return (unsigned)first | (unsigned)second << 1 | (unsigned)third << 2 | (unsigned)fourth << 3;
}

static void add_top(const grid *g)
{
    for (size_t j = 0; j < g->n[1]; j++)
        for (size_t i = 0; i < g->n[0]; i++) {
            double p[4][3];
            if (g->hidden[j * g->n[0] + i])
                continue;
            for (size_t k = 0; k < 4; k++) {
                const size_t x = i + (k == 1 || k == 2), y = j + k / 2;
                p[k][0] = grid_at(g, 0, (double)x);
                p[k][1] = grid_at(g, 1, (double)y);
                p[k][2] = grid_height(g, x, y);
            }
            add_cell(g, p, edges_of(j == 0, i + 1 == g->n[0], j + 1 == g->n[1], i == 0));
        }
}

/* The side along an axis, at the smaller or the larger end of the other one. */
static void add_side(const grid *g, unsigned axis, bool far)
{
    const double low = g->l->block->low[2];
    const size_t n = g->n[axis], over = far ? g->n[1 - axis] : 0;

    for (size_t i = 0; i < n; i++)
        for (size_t r = 0; r < g->rows; r++) {
            double p[4][3];
            for (size_t k = 0; k < 4; k++) {
                const size_t at = i + (k == 1 || k == 2), x = axis == 0 ? at : over,
                             y = axis == 0 ? over : at;
                p[k][0] = grid_at(g, 0, (double)x);
                p[k][1] = grid_at(g, 1, (double)y);
                p[k][2] = low +
                          (grid_height(g, x, y) - low) * (double)(r + k / 2) / (double)g->rows;
            }
            add_cell(g, p, edges_of(r == 0, i + 1 == n, false, i == 0));
        }
}

void left_around(void *context, mesh *m)
{
    const left_over *const l = context;
    grid g = { .l = l, .m = m };

    if (l->block == NULL)
        return;
    const double cell = fmax(l->block->size[0], l->block->size[1]) / ALONG;
    for (int k = 0; k < 2; k++)
        g.n[k] = (size_t)ceil(l->block->size[k] / cell - 1e-9);
    g.rows = (size_t)fmin(ceil(l->block->size[2] / cell), ALONG);
    const size_t cells = g.n[0] * g.n[1], corners = (g.n[0] + 1) * (g.n[1] + 1),
                 most = cells + 2 * (g.n[0] + g.n[1]) * g.rows;
    g.hidden = memory_grow(NULL, cells * sizeof *g.hidden);
    g.height = memory_grow(NULL, corners * sizeof *g.height);
    memset(g.hidden, 0, cells * sizeof *g.hidden);
    for (size_t k = 0; k < corners; k++)
        g.height[k] = NAN;
    for (size_t i = 0; i < m->cells; i++)
        for (int half = 0; half < 2; half++) {
            const size_t *const c = m->cell[i].corner;
            const double *const at[3] = { m->vertex[c[0]].p, m->vertex[c[1 + half]].p,
                                          m->vertex[c[2 + half]].p };
            if (area_of(at[0], at[1], at[2]) != 0)
                hide_below(&g, at);
        }
    m->vertex = memory_grow(m->vertex, (m->vertices + 4 * most) * sizeof *m->vertex);
    m->cell   = memory_grow(m->cell, (m->cells + most) * sizeof *m->cell);
    add_top(&g);
    for (unsigned k = 0; k < 4; k++)
        add_side(&g, k % 2, k > 1);
    free(g.hidden);
    free(g.height);
}
