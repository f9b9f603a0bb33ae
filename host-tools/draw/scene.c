/* host-tools/draw/scene.c -- draws a mesh from far to near
 * SPDX-License-Identifier: MIT
 *
 * Cells, pieces of control nets and contours are sorted by their distance from the eye and painted
 * in that order. Cells are small, so none of them hides something in front of it.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_contour.h"   /* contour_lines */
#include "draw/scene.h"
#include "engine/sided.h"   /* sided_net */
#include "base/memory.h"

#define NET_PIECES 24   /* per edge of a control net */

/* A projected point: its place on the canvas, and its nearness. */
typedef struct {
    double x, y, near;
} spot;

/* One item to paint: a cell, or (cell NULL) a piece of a line, or a point (both ends in one
 * place). */
typedef struct {
    const mesh_cell *cell;
    spot from, to;
    enum scene_pen pen;
    double near;
} item;

typedef struct {
    const scene *s;
    const plot_view *v;
    spot *seen;                 /* of each vertex */
    item *items;
    size_t count;
} painting;


// Lines
// -----

void scene_add(scene *s, enum scene_pen pen, const double from[3], const double to[3])
{
    if ((s->lines & (s->lines - 1)) == 0)       /* at powers of two there is room for as many
                                                 * again */
        s->line = memory_grow(s->line, (s->lines ? 2 * s->lines : 1) * sizeof *s->line);
    scene_line *l = &s->line[s->lines++];
    memcpy(l->p[0], from, sizeof l->p[0]);
    memcpy(l->p[1], to, sizeof l->p[1]);
    l->pen  = pen;
    l->cell = 0;
}

static void add_edge(void *context, const surface_point *from, const surface_point *to)
{
    scene_add(context, SCENE_NET, from->p, to->p);
}

static void tensor_net(scene *s, const surface_point *q, unsigned m, unsigned n)
{
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            const surface_point *at = q + i * (n + 1) + j;
            if (i < m)
                add_edge(s, at, at + n + 1);
            if (j < n)
                add_edge(s, at, at + 1);
        }
}

static void triangle_net(scene *s, const surface_point *q, unsigned m)
{
    for (unsigned i = 0; i < m; i++)
        for (unsigned j = 0; j <= i; j++) {
            const surface_point *at = q + i * (i + 1) / 2 + j, *below = at + i + 1;
            add_edge(s, at, below);
            add_edge(s, at, below + 1);
            add_edge(s, below, below + 1);
        }
}

static void polygon_net(scene *s, const surface_point *q, unsigned degree)
{
    for (unsigned k = 0; k < degree; k++)
        add_edge(s, q + k, q + k + 1);
    for (unsigned k = 0; k <= degree; k++)
        add_edge(s, q + k, q + k);
}

/* For a Coons patch, only of its boundaries. */
static void net_of(scene *s, const surface *p)
{
    const surface_point *v = p->point + 2 * p->orders * (p->m + 1);
    unsigned points = p->count;

    switch (p->kind) {
    case SURFACE_TENSOR:   tensor_net(s, p->point, p->m, p->n); break;
    case SURFACE_TRIANGLE: triangle_net(s, p->point, p->m);     break;
    case SURFACE_PN:       break;
    case SURFACE_COONS:
        for (unsigned k = 0; k < 2; k++) {
            polygon_net(s, p->point + k * (p->m + 1), p->m);
            polygon_net(s, v + k * (p->n + 1), p->n);
        }
        points = 0;
        break;
    case SURFACE_GREGORY: tensor_net(s, p->point, 3, 3); break;
    case SURFACE_NURBS:   tensor_net(s, p->point, p->rows - 1, p->columns - 1); break;
    case SURFACE_BICUBIC:
    case SURFACE_SPHERE:
    case SURFACE_OCTANT: points = 0; break;
    default:               sided_net(p, add_edge, s);           break;
    }
    for (unsigned k = 0; k < points; k++)
        add_edge(s, p->point + k, p->point + k);
}

void scene_net(scene *s, const surfaces *all)
{
    for (size_t i = 0; i < all->count; i++)
        net_of(s, &all->surface[i]);
}

static void add_contour(void *context, size_t cell, const double from[3], const double to[3])
{
    scene *s = context;

    scene_add(s, SCENE_CONTOUR, from, to);
    s->line[s->lines - 1].cell = cell;
}

void scene_contour(scene *s, double height) { contour_lines(s->m, height, add_contour, s); }

void scene_free(scene *s)
{
    free(s->line);
    s->line  = NULL;
    s->lines = 0;
}


// The view
// --------

static double dot_product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* In mm from the centre, before scaling. */
static spot project_point(const scene *s, const double p[3])
{
    const double from[3] = { p[0] - s->centre[0], p[1] - s->centre[1], p[2] - s->centre[2] };
    const double near = dot_product(from, s->axis[2]), eye = s->distance * s->diameter;
    const double grow = eye > 0 ? eye / fmax(eye - near, 0.05 * eye) : 1;

    return (spot){ dot_product(from, s->axis[0]) * grow, dot_product(from, s->axis[1]) * grow,
                   near };
}

static spot canvas_spot(const scene *s, const plot_view *v, const double p[3])
{
    const spot at = project_point(s, p);

    return (spot){ plot_x(v, at.x), plot_y(v, at.y), at.near };
}

void scene_place(const scene *s, const plot_view *v, const double p[3], double out[3])
{
    const spot at = canvas_spot(s, v, p);

    out[0] = at.x;
    out[1] = at.y;
    out[2] = at.near;
}

typedef void point_visit(void *context, const double p[3]);

/* Visit all points that must be visible. */
static void visit_points(const scene *s, point_visit *each, void *context)
{
    for (size_t i = 0; i < s->m->vertices; i++)
        each(context, s->m->vertex[i].p);
    for (size_t i = 0; i < s->lines; i++) {
        each(context, s->line[i].p[0]);
        each(context, s->line[i].p[1]);
    }
}

typedef struct {
    const scene *s;
    double least[3], most[3];
} extent;

static void widen_space(void *context, const double p[3])
{
    extent *e = context;

    for (int i = 0; i < 3; i++) {
        e->least[i] = fmin(e->least[i], p[i]);
        e->most[i]  = fmax(e->most[i], p[i]);
    }
}

static void widen_view(void *context, const double p[3])
{
    extent *e = context;
    const spot at = project_point(e->s, p);
    const double seen[3] = { at.x, at.y, at.near };

    widen_space(e, seen);
}

void scene_look(scene *s)
{
    const double a = s->azimuth * M_PI / 180, e = s->elevation * M_PI / 180;
    const double axis[3][3] = { { -sin(a), cos(a), 0 },
                                { -sin(e) * cos(a), -sin(e) * sin(a), cos(e) },
                                { cos(e) * cos(a), cos(e) * sin(a), sin(e) } };
    extent space = { s, { INFINITY, INFINITY, INFINITY }, { -INFINITY, -INFINITY, -INFINITY } },
           seen = space;

    visit_points(s, widen_space, &space);
    for (int i = 0; i < 3; i++)
        s->centre[i] = (space.least[i] + space.most[i]) / 2;
    s->diameter = fmax(hypot(hypot(space.most[0] - space.least[0], space.most[1] - space.least[1]),
                             space.most[2] - space.least[2]),
                       1e-9);
    memcpy(s->axis, axis, sizeof axis);
    visit_points(s, widen_view, &seen);
    for (int i = 0; i < 2; i++) {
        s->seen[0][i] = seen.least[i];
        s->seen[1][i] = fmax(seen.most[i], seen.least[i] + 1e-3 * s->diameter);
    }
}

void scene_fit(const scene *s, plot_view *v)
{
    const double wide = v->right - v->left, high = v->bottom - v->top;

    v->scale = fmin(wide / (s->seen[1][0] - s->seen[0][0]), high / (s->seen[1][1] - s->seen[0][1]));
    v->x0 = (s->seen[0][0] + s->seen[1][0]) / 2 - wide / 2 / v->scale;
    v->y0 = (s->seen[0][1] + s->seen[1][1]) / 2 - high / 2 / v->scale;
}


// What is painted
// ---------------

static void add_item(painting *p, item it)
{
    if ((p->count & (p->count - 1)) == 0)
        p->items = memory_grow(p->items, (p->count ? 2 * p->count : 1) * sizeof *p->items);
    p->items[p->count++] = it;
}

static double cell_nearness(const painting *p, size_t cell)
{
    const mesh_cell *c = &p->s->m->cell[cell];
    double near = 0;

    for (int k = 0; k < 4; k++)
        near += p->seen[c->corner[k]].near / 4;
    return near;
}

/* Nearer than its cell and those that share a corner with it. */
static double nearness_before_cell(const painting *p, size_t cell)
{
    double least = INFINITY, most = -INFINITY;

    for (int k = 0; k < 4; k++) {
        const double near = p->seen[p->s->m->cell[cell].corner[k]].near;
        least = fmin(least, near);
        most  = fmax(most, near);
    }
    return most + (most - least);
}

static void add_cells(painting *p)
{
    for (size_t i = 0; i < p->s->m->cells; i++) {
        const mesh_cell *c = &p->s->m->cell[i];
        add_item(p, (item){ .cell = c, .near = cell_nearness(p, i) });
        for (unsigned k = 0; k < 4; k++)
            if (c->line >> (k + 4) & 1)
                add_item(p, (item){ .from = p->seen[c->corner[k]],
                                    .to = p->seen[c->corner[(k + 1) % 4]],
                                    .pen = SCENE_EDGE,
                                    .near = nearness_before_cell(p, i) });
    }
}

/* Draw a line a little nearer than it is, so that a line that touches the surface is visible; a
 * contour lies on its cell. */
static void add_line(painting *p, const scene_line *l)
{
    const bool point = memcmp(l->p[0], l->p[1], sizeof l->p[0]) == 0;
    const int pieces = l->pen == SCENE_CONTOUR || point ? 1 : NET_PIECES;
    const double lift = (point ? 0.006 : 0.004) * p->s->diameter;
    double a[3], b[3];

    for (int n = 0; n < pieces; n++) {
        for (int i = 0; i < 3; i++) {
            a[i] = l->p[0][i] + (l->p[1][i] - l->p[0][i]) * n / pieces;
            b[i] = l->p[0][i] + (l->p[1][i] - l->p[0][i]) * (n + 1) / pieces;
        }
        const spot first = canvas_spot(p->s, p->v, a), last = canvas_spot(p->s, p->v, b);
        const double near = l->pen == SCENE_CONTOUR ? nearness_before_cell(p, l->cell)
                                                    : (first.near + last.near) / 2;
        add_item(p, (item){ .from = first, .to = last, .pen = l->pen, .near = near + lift });
    }
}

static int compare_depths(const void *a, const void *b)
{
    const double x = ((const item *)a)->near, y = ((const item *)b)->near;
    return x < y ? -1 : x > y;
}

/* Light from the upper left, in front of the surface; both sides are lit. */
static void shade_cell(const scene *s, const mesh_cell *c, double rgb[3])
{
    static const double light[3] = { -0.42, 0.56, 0.71 };
    const bool mapped = s->value && c->corner[0] < s->m->mapped;
    double n[3] = { 0, 0, 0 }, value = 0, at[3];

    for (int k = 0; k < 4; k++) {
        value += mapped ? s->value[c->corner[k]] / 4 : 0;
        for (int i = 0; i < 3; i++)
            n[i] += s->m->vertex[c->corner[k]].normal[i];
    }
    const double length = sqrt(dot_product(n, n));
    for (int i = 0; i < 3; i++)
        at[i] = length > 0 ? dot_product(n, s->axis[i]) / length : i == 2;
    const bool back = at[2] < 0;
    const double lit = fmax((back ? -1 : 1) * dot_product(at, light), 0), gleam = pow(lit, 24);
    const double dark = s->value ? 0.68 + 0.32 * lit : 0.42 + 0.58 * lit;
    if (mapped)
        scene_colour(&s->scale, value, rgb);
    else
        memcpy(rgb, s->value ? scene_around : scene_sides[back], 3 * sizeof rgb[0]);
    for (int i = 0; i < 3; i++)
        rgb[i] = fmin(rgb[i] * dark + (s->value ? 0.04 : 0.22) * gleam, 1);
}

static void paint_cell(const painting *p, const mesh_cell *c)
{
    cairo_t *cairo = p->v->cairo;
    double rgb[3];

    if (!p->s->wire) {
        shade_cell(p->s, c, rgb);
        cairo_set_source_rgb(cairo, rgb[0], rgb[1], rgb[2]);
        for (int k = 0; k < 4; k++)
            cairo_line_to(cairo, p->seen[c->corner[k]].x, p->seen[c->corner[k]].y);
        cairo_close_path(cairo);
        cairo_fill_preserve(cairo);
        cairo_set_line_width(cairo, fmax(0.5 * p->v->u, 0.8));  /* no seams */
        cairo_stroke(cairo);
    }
    for (unsigned k = 0; k < 4; k++) {
        const spot *a = &p->seen[c->corner[k]], *b = &p->seen[c->corner[(k + 1) % 4]];
        if (!(c->line >> k & 1) || c->line >> (k + 4) & 1 || p->s->plain)
            continue;
        cairo_set_source_rgba(cairo, 0.10, 0.13, 0.20, p->s->wire ? 0.75 : 0.42);
        cairo_set_line_width(cairo, 0.6 * p->v->u);
        plot_line(p->v, a->x, a->y, b->x, b->y);
    }
}

static void paint_line(const plot_view *v, const item *it)
{
    const double *rgb = scene_pens[it->pen];
    const bool point = it->from.x == it->to.x && it->from.y == it->to.y;

    cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
    if (point && it->pen == SCENE_NET) {
        cairo_set_source_rgb(v->cairo, 0.80, 0.33, 0.05);
        cairo_arc(v->cairo, it->from.x, it->from.y, 2.8 * v->u, 0, 2 * M_PI);
        cairo_fill(v->cairo);
    } else {
        cairo_set_line_width(v->cairo, (it->pen == SCENE_NET       ? 1.0
                                        : it->pen == SCENE_CONTOUR ? 1.4
                                                                   : 1.3) *
                                           v->u);
        plot_line(v, it->from.x, it->from.y, it->to.x, it->to.y);
    }
}

void scene_paint(const scene *s, const plot_view *v)
{
    painting p = { .s = s, .v = v };

    p.seen = memory_grow(NULL, s->m->vertices * sizeof *p.seen);
    for (size_t i = 0; i < s->m->vertices; i++)
        p.seen[i] = canvas_spot(s, v, s->m->vertex[i].p);
    add_cells(&p);
    for (size_t i = 0; i < s->lines; i++)
        add_line(&p, &s->line[i]);
    qsort(p.items, p.count, sizeof *p.items, compare_depths);
    cairo_new_path(v->cairo);               /* text leaves a current point */
    cairo_set_line_join(v->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(v->cairo, CAIRO_LINE_CAP_ROUND);
    for (size_t i = 0; i < p.count; i++)
        if (p.items[i].cell != NULL)
            paint_cell(&p, p.items[i].cell);
        else
            paint_line(v, &p.items[i]);
    cairo_set_line_cap(v->cairo, CAIRO_LINE_CAP_BUTT);
    free(p.items);
    free(p.seen);
}
