/* host-tools/draw/gallery.c -- several pictures of surfaces in one
 * SPDX-License-Identifier: MIT
 *
 * All panels share one scale of lengths, that of the largest panel, and one scale of colours.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/gallery.h"
#include "draw/scene.h"
#include "draw/surface_plot.h"   /* surface_axes */
#include "base/host.h"
#include "base/memory.h"

#define PT_PER_MM (72 / 25.4)
#define SPACE     22            /* between panels, in thousandths of the width */

typedef struct {
    const gallery *g;
    const gallery_panel *panel;
    size_t count;
    scene *scene;
    plot_view v;
} hanging;

static bool has_map(const hanging *h)
{
    for (size_t i = 0; i < h->count; i++)
        if (h->panel[i].value != NULL)
            return true;
    return false;
}

static void look_at(hanging *h)
{
    for (size_t i = 0; i < h->count; i++) {
        const gallery_panel *p = &h->panel[i];
        scene *s = &h->scene[i];
        *s = (scene){ .m = p->m,
                      .value = p->value,
                      .plain = true,
                      .azimuth = h->g->azimuth,
                      .elevation = h->g->elevation,
                      .distance = h->g->distance };
        if (p->net != NULL)
            scene_net(s, p->net);
        for (size_t k = 0; k < p->levels; k++)
            scene_contour(s, p->level[k]);
        scene_look(s);
    }
}

/* Use one colour scale for the values of all panels. */
static void agree_on_colours(hanging *h)
{
    scene_scale scale = { .limit = h->g->limit, .signs = h->g->signs };
    size_t count = 0, at = 0;

    for (size_t i = 0; i < h->count; i++)
        count += h->panel[i].value ? h->panel[i].m->vertices : 0;
    double *all = memory_grow(NULL, (count + 1) * sizeof *all);
    for (size_t i = 0; i < h->count; i++)
        for (size_t k = 0; h->panel[i].value != NULL && k < h->panel[i].m->vertices; k++)
            all[at++] = h->panel[i].value[k];
    if (count > 0 && h->g->limit <= 0)
        scene_scale_of(&scale, all, count, 1e-12);
    for (size_t k = 0; k < count && h->g->limit > 0; k++)
        scale.clipped = scale.clipped || fabs(all[k]) > scale.limit * 1.001;
    for (size_t i = 0; i < h->count; i++)
        h->scene[i].scale = scale;
    free(all);
}

/* The frame of panel i, below its title. */
static plot_view frame_of(const hanging *h, size_t i, double wide, double high)
{
    const double u = h->v.u;
    plot_view v = h->v;

    v.left   = (30 + (double)(i % h->g->columns) * (wide + SPACE)) * u;
    v.right  = v.left + wide * u;
    v.top    = (84 + (double)(i / h->g->columns) * (high + SPACE + 30)) * u;
    v.bottom = v.top + high * u;
    return v;
}

static void paint_panel(const hanging *h, size_t i, double wide, double high, double scale)
{
    plot_view v = frame_of(h, i, wide, high);

    scene_fit(&h->scene[i], &v);
    v.x0 += (v.right - v.left) / 2 * (1 / v.scale - 1 / scale);
    v.y0 += (v.bottom - v.top) / 2 * (1 / v.scale - 1 / scale);
    v.scale = scale;
    scene_paint(&h->scene[i], &v);
    if (h->panel[i].title != NULL) {
        plot_ink(&v, 0.1);
        plot_text(&v, PLOT_SMALL, (v.left + v.right) / 2, v.top - 9 * v.u, 0.5, h->panel[i].title);
    }
}

static void paint_frame(const hanging *h)
{
    const plot_view *v = &h->v;

    plot_ink(v, 0.1);
    plot_text(v, PLOT_LARGE, 30 * v->u, 34 * v->u, 0, h->g->title);
    if (h->g->note != NULL)
        plot_text(v, PLOT_SMALL, 110 * v->u, v->height - 20 * v->u, 0, h->g->note);
    surface_axes(v, &h->scene[0], 42 * v->u, v->height - 30 * v->u);
    if (has_map(h))
        scene_bar(v, &h->scene[0].scale, h->g->values, 884 * v->u, 66 * v->u,
                  fmin(400 * v->u, v->height - 150 * v->u));
}

/* A row is as high as its highest panel, when all panels have the scale of the widest one. */
static int hang_panels(host *told, hanging *h, bool vector)
{
    const gallery *g = h->g;
    const double room = (has_map(h) ? 840 : 940) - SPACE * (g->columns - 1.0),
                 each = room / g->columns;
    const size_t rows = (h->count + g->columns - 1) / g->columns;
    double wide = 0, high = 0;

    for (size_t i = 0; i < h->count; i++) {
        wide = fmax(wide, h->scene[i].seen[1][0] - h->scene[i].seen[0][0]);
        high = fmax(high, h->scene[i].seen[1][1] - h->scene[i].seen[0][1]);
    }
    const double tall = each * high / wide;
    h->v.width = g->size > 0 ? g->size * (vector ? PT_PER_MM : 1) : vector ? 160 * PT_PER_MM : 1600;
    h->v.u      = h->v.width / 1000;
    h->v.height = (84 + (double)rows * (tall + SPACE + 30) + 50) * h->v.u;
    if (!vector && (h->v.width > 30000 || h->v.height > 30000))
        return host_error(told, EX_USAGE, "picture.too-large", (host_place){ g->output, 0 },
                          "give a smaller size", "%.0f x %.0f px are too many", h->v.width,
                          h->v.height);
    cairo_surface_t *canvas = plot_begin(&h->v, g->output);
    cairo_set_source_rgb(h->v.cairo, 1, 1, 1);
    cairo_paint(h->v.cairo);
    cairo_select_font_face(h->v.cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    for (size_t i = 0; i < h->count; i++)
        paint_panel(h, i, each, tall, each * h->v.u / wide);
    paint_frame(h);
    return plot_end(told, &h->v, canvas, g->output);
}

int gallery_draw(host *told, const gallery *g, const gallery_panel panel[], size_t count)
{
    hanging h = { .g = g, .panel = panel, .count = count };
    bool png;

    if (!plot_known(g->output, &png))
        return host_error(told, EX_USAGE, "picture.name", (host_place){ g->output, 0 }, NULL,
                          "give a name that ends with .png, .svg or .pdf");
    h.scene = memory_grow(NULL, count * sizeof *h.scene);
    look_at(&h);
    agree_on_colours(&h);
    const int code = hang_panels(told, &h, !png);
    for (size_t i = 0; i < count; i++)
        scene_free(&h.scene[i]);
    free(h.scene);
    return code;
}
