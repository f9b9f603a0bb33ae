/* host-tools/surface_plot.c -- a picture of surfaces, from far to near
 * SPDX-License-Identifier: MIT
 *
 * Cells, pieces of control nets and control points are sorted by their distance from the eye and painted over each
 * other. Cells are small, so that none of them hides what lies before it.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sided.h"      /* sided_net */
#include "source.h"     /* source_name */
#include "surface_plot.h"
#include "tool.h"       /* tool_error, tool_grow, sysexits */

#define PT_PER_MM   (72 / 25.4)
#define CELLS       60000       /* of the whole picture, about */
#define NET_PIECES  24          /* of an edge of a control net */

const double surface_sides[2][3] = { { 0.53, 0.68, 0.86 }, { 0.90, 0.74, 0.50 } };

/* A point as it is seen: on the canvas, and how near. */
typedef struct {
    double x, y, near;
} spot;

/* What is painted at once: a cell, or (cell NULL) a piece of a net, or its point (ends in one place). */
typedef struct {
    const mesh_cell *cell;
    spot from, to;
    double near;
} item;

typedef struct {
    surface_view *s;
    const mesh *m;
    spot *seen;                 /* of each vertex */
    item *items;
    size_t count;
} painting;


// The view
// --------

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void look_from(surface_view *s)
{
    const double a = s->o->azimuth * M_PI / 180, e = s->o->elevation * M_PI / 180;
    const double axis[3][3] = { { -sin(a), cos(a), 0 }, { -sin(e) * cos(a), -sin(e) * sin(a), cos(e) }, { cos(e) * cos(a), cos(e) * sin(a), sin(e) } };

    memcpy(s->axis, axis, sizeof axis);
}

/* In mm from the centre, before scaling. */
static spot project(const surface_view *s, const double p[3])
{
    const double from[3] = { p[0] - s->centre[0], p[1] - s->centre[1], p[2] - s->centre[2] };
    const double near = dot(from, s->axis[2]), eye = s->o->distance * s->diameter;
    const double grow = eye > 0 ? eye / fmax(eye - near, 0.05 * eye) : 1;

    return (spot){ dot(from, s->axis[0]) * grow, dot(from, s->axis[1]) * grow, near };
}

static spot on_canvas(const surface_view *s, const double p[3])
{
    const spot at = project(s, p);

    return (spot){ s->v.left + (at.x - s->v.x0) * s->v.scale, s->v.bottom - (at.y - s->v.y0) * s->v.scale, at.near };
}

typedef void point_visit(void *context, const double p[3]);

/* All that must be seen. */
static void visit(const painting *p, point_visit *each, void *context)
{
    for (size_t i = 0; i < p->m->vertices; i++)
        each(context, p->m->vertex[i].p);
    for (size_t i = 0; p->s->o->control && i < p->s->o->all->count; i++) {
        const surface *s = &p->s->o->all->surface[i];
        for (unsigned k = 0; k < s->count && s->kind != SURFACE_BICUBIC && s->kind != SURFACE_SPHERE && s->kind != SURFACE_OCTANT; k++)
            each(context, s->point[k].p);
    }
}

typedef struct {
    const surface_view *s;
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
    const spot at = project(e->s, p);
    const double seen[3] = { at.x, at.y, at.near };

    widen_space(e, seen);
}

/* Margins in thousandths of the width; the picture is as high as it must, within limits. */
static void lay_out(painting *p, bool vector)
{
    surface_view *s = p->s;
    plot_view *v = &s->v;
    extent space = { s, { INFINITY, INFINITY, INFINITY }, { -INFINITY, -INFINITY, -INFINITY } }, seen = space;
    const double left = 40, right = s->o->map != MAP_NONE ? 150 : 40, above = 58, below = 104;

    visit(p, widen_space, &space);
    for (int i = 0; i < 3; i++)
        s->centre[i] = (space.least[i] + space.most[i]) / 2;
    s->diameter = fmax(hypot(hypot(space.most[0] - space.least[0], space.most[1] - space.least[1]), space.most[2] - space.least[2]), 1e-9);
    look_from(s);
    visit(p, widen_view, &seen);
    const double wide = fmax(seen.most[0] - seen.least[0], 1e-3 * s->diameter), high = fmax(seen.most[1] - seen.least[1], 1e-3 * s->diameter);
    const double room = 1000 - left - right, thousandths = fmin(room / wide, 620 / high), tall = fmax(high * thousandths, 260);

    v->width  = s->o->size > 0 ? s->o->size * (vector ? PT_PER_MM : 1) : vector ? 160 * PT_PER_MM : 1600;
    v->u      = v->width / 1000;
    v->scale  = thousandths * v->u;
    v->left   = left * v->u;
    v->right  = (left + room) * v->u;
    v->top    = above * v->u;
    v->bottom = v->top + tall * v->u;
    v->height = v->bottom + below * v->u;
    v->x0     = (seen.least[0] + seen.most[0]) / 2 - room / 2 / thousandths;
    v->y0     = (seen.least[1] + seen.most[1]) / 2 - tall / 2 / thousandths;
}


// What is painted
// ---------------

static void add_item(painting *p, item it)
{
    if ((p->count & (p->count - 1)) == 0)
        p->items = tool_grow(p->items, (p->count ? 2 * p->count : 1) * sizeof *p->items);
    p->items[p->count++] = it;
}

static void add_cells(painting *p)
{
    for (size_t i = 0; i < p->m->cells; i++) {
        const mesh_cell *c = &p->m->cell[i];
        double near = 0;
        for (int k = 0; k < 4; k++)
            near += p->seen[c->corner[k]].near / 4;
        add_item(p, (item){ .cell = c, .near = near });
    }
}

/* A little nearer than it is: a net that touches the surface is seen. */
static void add_net_edge(painting *p, const double from[3], const double to[3])
{
    const double lift = 0.004 * p->s->diameter;
    double a[3], b[3];

    for (int n = 0; n < NET_PIECES; n++) {
        for (int i = 0; i < 3; i++) {
            a[i] = from[i] + (to[i] - from[i]) * n / NET_PIECES;
            b[i] = from[i] + (to[i] - from[i]) * (n + 1) / NET_PIECES;
        }
        const spot first = on_canvas(p->s, a), last = on_canvas(p->s, b);
        add_item(p, (item){ .from = first, .to = last, .near = (first.near + last.near) / 2 + lift });
    }
}

static void add_net_point(painting *p, const double at[3])
{
    const spot s = on_canvas(p->s, at);
    add_item(p, (item){ .from = s, .to = s, .near = s.near + 0.006 * p->s->diameter });
}

static void sided_net_edge(void *context, const surface_point *from, const surface_point *to)
{
    add_net_edge(context, from->p, to->p);
}

/* Rows and columns of a tensor product, the mesh of a triangle, the polygons of the boundaries. */
static void add_net(painting *p, const surface *s)
{
    const surface_point *q = s->point;

    if (surface_is_sided(s))
        sided_net(s, sided_net_edge, p);
    if (s->kind == SURFACE_TENSOR)
        for (unsigned i = 0; i <= s->m; i++)
            for (unsigned j = 0; j <= s->n; j++) {
                const unsigned at = i * (s->n + 1) + j;
                if (i < s->m) add_net_edge(p, q[at].p, q[at + s->n + 1].p);
                if (j < s->n) add_net_edge(p, q[at].p, q[at + 1].p);
            }
    if (s->kind == SURFACE_TRIANGLE)
        for (unsigned i = 0; i < s->m; i++)
            for (unsigned j = 0; j <= i; j++) {
                const unsigned at = i * (i + 1) / 2 + j, below = at + i + 1;
                add_net_edge(p, q[at].p, q[below].p);
                add_net_edge(p, q[at].p, q[below + 1].p);
                add_net_edge(p, q[below].p, q[below + 1].p);
            }
    const unsigned of_u = 2 * (s->m + 1), of_v = 2 * (s->n + 1), skip = 2 * s->orders * (s->m + 1);
    for (unsigned k = 0; s->kind == SURFACE_COONS && k + 1 < of_u; k++)
        if (k % (s->m + 1) != s->m) add_net_edge(p, q[k].p, q[k + 1].p);
    for (unsigned k = 0; s->kind == SURFACE_COONS && k + 1 < of_v; k++)
        if (k % (s->n + 1) != s->n) add_net_edge(p, q[skip + k].p, q[skip + k + 1].p);
    const unsigned points = s->kind == SURFACE_COONS ? of_u : s->kind == SURFACE_TENSOR || s->kind == SURFACE_TRIANGLE || s->kind == SURFACE_PN || surface_is_sided(s) ? s->count : 0;
    for (unsigned k = 0; k < points; k++)
        add_net_point(p, q[k].p);
    for (unsigned k = 0; s->kind == SURFACE_COONS && k < of_v; k++)
        add_net_point(p, q[skip + k].p);
}

static int by_depth(const void *a, const void *b)
{
    const double x = ((const item *)a)->near, y = ((const item *)b)->near;
    return x < y ? -1 : x > y;
}


// Colours
// -------

static double value_of(const surface_view *s, const mesh_vertex *v)
{
    return s->o->map == MAP_GAUSS ? v->gauss : s->o->map == MAP_MEAN ? v->mean : mesh_bend(v);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* The ends of the map: what 98 of 100 places keep within. */
static void choose_limit(surface_view *s, const mesh *m)
{
    double *size = tool_grow(NULL, m->vertices * sizeof *size);

    for (size_t i = 0; i < m->vertices; i++)
        size[i] = fabs(value_of(s, &m->vertex[i]));
    qsort(size, m->vertices, sizeof *size, ascending);
    const double most = size[m->vertices - 1], common = size[(m->vertices - 1) * 98 / 100];
    const double flat = 1e-7 / (s->o->map == MAP_GAUSS ? s->diameter * s->diameter : s->diameter);
    s->limit   = most <= flat ? 0 : most <= 1.5 * common ? most : common;
    s->clipped = most > s->limit * 1.001 && s->limit > 0;
    free(size);
}

/* Blue for negative, white for 0, red for positive; of sizes from dark to bright. */
void surface_colour(const surface_view *s, double value, double rgb[3])
{
    static const double ends[2][3] = { { 0.13, 0.35, 0.72 }, { 0.78, 0.13, 0.17 } };
    const double share = s->limit > 0 ? fmin(fmax(value / s->limit, -1), 1) : 0, size = pow(fabs(share), 0.8);

    if (s->o->map == MAP_LARGEST)
        plot_colour(share, rgb);
    else
        for (int i = 0; i < 3; i++)
            rgb[i] = 0.96 + size * (ends[share > 0][i] - 0.96);
}

/* Light from the upper left, before the surface; both sides are lit. */
static void shade(const surface_view *s, const mesh *m, const mesh_cell *c, double rgb[3])
{
    static const double light[3] = { -0.42, 0.56, 0.71 };
    double n[3] = { 0, 0, 0 }, value = 0, at[3];

    for (int k = 0; k < 4; k++) {
        const mesh_vertex *v = &m->vertex[c->corner[k]];
        value += value_of(s, v) / 4;
        for (int i = 0; i < 3; i++)
            n[i] += v->normal[i];
    }
    const double length = sqrt(dot(n, n));
    for (int i = 0; i < 3; i++)
        at[i] = length > 0 ? dot(n, s->axis[i]) / length : i == 2;
    const bool back = at[2] < 0;
    const double lit = fmax((back ? -1 : 1) * dot(at, light), 0), gleam = pow(lit, 24);
    const double dark = s->o->map != MAP_NONE ? 0.68 + 0.32 * lit : 0.42 + 0.58 * lit;
    if (s->o->map != MAP_NONE)
        surface_colour(s, value, rgb);
    else
        memcpy(rgb, surface_sides[back], 3 * sizeof rgb[0]);
    for (int i = 0; i < 3; i++)
        rgb[i] = fmin(rgb[i] * dark + (s->o->map != MAP_NONE ? 0.04 : 0.22) * gleam, 1);
}

static void paint_cell(const painting *p, const mesh_cell *c)
{
    cairo_t *cairo = p->s->v.cairo;
    double rgb[3];

    if (!p->s->o->wire) {
        shade(p->s, p->m, c, rgb);
        cairo_set_source_rgb(cairo, rgb[0], rgb[1], rgb[2]);
        for (int k = 0; k < 4; k++)
            cairo_line_to(cairo, p->seen[c->corner[k]].x, p->seen[c->corner[k]].y);
        cairo_close_path(cairo);
        cairo_fill_preserve(cairo);
        cairo_set_line_width(cairo, 0.5 * p->s->v.u);       /* no seams */
        cairo_stroke(cairo);
    }
    for (unsigned k = 0; k < 4; k++) {
        const spot *a = &p->seen[c->corner[k]], *b = &p->seen[c->corner[(k + 1) % 4]];
        if (!(c->line >> k & 1))
            continue;
        const bool edge = c->line >> (k + 4) & 1;
        cairo_set_source_rgba(cairo, 0.10, 0.13, 0.20, edge ? 0.95 : p->s->o->wire ? 0.75 : 0.42);
        cairo_set_line_width(cairo, (edge ? 1.3 : 0.6) * p->s->v.u);
        plot_line(&p->s->v, a->x, a->y, b->x, b->y);
    }
}

static void paint(const painting *p)
{
    cairo_t *cairo = p->s->v.cairo;

    for (size_t i = 0; i < p->count; i++) {
        const item *it = &p->items[i];
        if (it->cell != NULL) {
            paint_cell(p, it->cell);
        } else if (it->from.x == it->to.x && it->from.y == it->to.y) {
            cairo_set_source_rgb(cairo, 0.80, 0.33, 0.05);
            cairo_arc(cairo, it->from.x, it->from.y, 2.8 * p->s->v.u, 0, 2 * M_PI);
            cairo_fill(cairo);
        } else {
            cairo_set_source_rgb(cairo, 0.90, 0.45, 0.10);
            cairo_set_line_width(cairo, 1.0 * p->s->v.u);
            plot_line(&p->s->v, it->from.x, it->from.y, it->to.x, it->to.y);
        }
    }
}

static int draw(painting *p, bool png)
{
    surface_view *s = p->s;

    lay_out(p, !png);
    if (png && (s->v.width > 30000 || s->v.height > 30000))
        return tool_error(EX_USAGE, "%s: %.0f x %.0f px are too many: give a smaller --size", s->o->output, s->v.width, s->v.height);
    if (s->o->map != MAP_NONE)
        choose_limit(s, p->m);
    p->seen = tool_grow(NULL, p->m->vertices * sizeof *p->seen);
    for (size_t i = 0; i < p->m->vertices; i++)
        p->seen[i] = on_canvas(s, p->m->vertex[i].p);
    add_cells(p);
    for (size_t i = 0; s->o->control && i < s->o->all->count; i++)
        add_net(p, &s->o->all->surface[i]);
    qsort(p->items, p->count, sizeof *p->items, by_depth);

    cairo_surface_t *canvas = plot_begin(&s->v, s->o->output);
    cairo_set_source_rgb(s->v.cairo, 1, 1, 1);
    cairo_paint(s->v.cairo);
    cairo_set_line_join(s->v.cairo, CAIRO_LINE_JOIN_ROUND);
    paint(p);
    surface_frame(s);
    return plot_end(&s->v, canvas, s->o->output);
}

int surface_plot(const surface_options *o)
{
    const double fair = sqrt((double)CELLS / (double)o->all->count);
    const unsigned n = fair > 96 ? 96 : fair < 16 ? 16 : (unsigned)fair / 8 * 8;
    surface_view s = { .o = o };
    mesh m = { 0 };
    painting p = { .s = &s, .m = &m };
    bool png;

    if (!plot_known(o->output, &png))
        return tool_error(EX_USAGE, "%s: give a name that ends with .png, .svg or .pdf", o->output);
    int code = mesh_make(&m, o->all, source_name(o->name), o->e, n, n / 8);
    if (code == 0)
        code = draw(&p, png);
    free(p.items);
    free(p.seen);
    mesh_free(&m);
    return code;
}
