/* host-tools/draw/surface_plot.c -- a picture of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/mesh_contour.h"    /* contour_heights */
#include "base/source.h"     /* source_name */
#include "draw/surface_plot.h"
#include "base/host.h"
#include "base/memory.h"

#define PT_PER_MM (72 / 25.4)
#define CELLS     60000         /* of the whole picture, about */

static double value_of(const surface_options *o, const mesh_vertex *v)
{
    const enum surface_map map = o->map;

    if (map == MAP_GIVEN)
        return o->value(o->context, v);
    return map == MAP_GAUSS ? v->gauss : map == MAP_MEAN ? v->mean : mesh_bend(v);
}

/* The values of the map, to be freed. */
static double *make_map(surface_view *s)
{
    const mesh *m = s->scene.m;
    const double diameter = s->scene.diameter,
                 flat = 1e-7 / (s->o->map == MAP_GAUSS ? diameter * diameter : diameter);
    double *value;

    if (s->o->map == MAP_NONE)
        return NULL;
    value = memory_grow(NULL, m->mapped * sizeof *value);
    for (size_t i = 0; i < m->mapped; i++)
        value[i] = value_of(s->o, &m->vertex[i]);
    s->scene.value = value;
    s->scene.scale.signs = s->o->map != MAP_LARGEST;
    scene_scale_of(&s->scene.scale, value, m->mapped, flat);
    return value;
}

static void add_lines(surface_view *s)
{
    const surface_options *o = s->o;

    if (o->control)
        scene_net(&s->scene, o->all);
    if (o->contours > 0)
        s->heights = contour_heights(s->scene.m, o->contours, s->height, SURFACE_HEIGHTS);
    for (size_t i = 0; i < o->heights && i < SURFACE_HEIGHTS; i++)
        s->height[s->heights++] = o->height[i];
    for (size_t i = 0; i < s->heights; i++)
        scene_contour(&s->scene, s->height[i]);
    s->scene.plain = o->contours > 0 || o->heights > 0;
}

/* Margins in thousandths of the width; the height of the picture follows, within limits. */
static void lay_out_picture(surface_view *s, bool vector)
{
    const double left = 40, right = s->o->map != MAP_NONE ? 150 : 40, above = 58, below = 104,
                 room = 1000 - left - right;
    const double wide = s->scene.seen[1][0] - s->scene.seen[0][0],
                 high = s->scene.seen[1][1] - s->scene.seen[0][1];
    plot_view *v = &s->v;

    v->width = s->o->size > 0 ? s->o->size * (vector ? PT_PER_MM : 1)
               : vector       ? 160 * PT_PER_MM
                              : 1600;
    v->u      = v->width / 1000;
    v->left   = left * v->u;
    v->right  = (left + room) * v->u;
    v->top    = above * v->u;
    v->bottom = v->top + fmax(high * fmin(room / wide, 620 / high), 260) * v->u;
    v->height = v->bottom + below * v->u;
    scene_fit(&s->scene, v);
}

static int draw_scene(host *h, surface_view *s, bool png)
{
    lay_out_picture(s, !png);
    if (png && (s->v.width > 30000 || s->v.height > 30000))
        return host_error(h, EX_USAGE, "picture.too-large", (host_place){ s->o->output, 0 },
                          "give a smaller --size", "%.0f x %.0f px are too many", s->v.width,
                          s->v.height);
    cairo_surface_t *canvas = plot_begin(&s->v, s->o->output);
    cairo_set_source_rgb(s->v.cairo, 1, 1, 1);
    cairo_paint(s->v.cairo);
    scene_paint(&s->scene, &s->v);
    scene_label(&s->scene, &s->v);
    surface_frame(s);
    return plot_end(h, &s->v, canvas, s->o->output);
}

int surface_plot(host *h, const surface_options *o)
{
    const double fair = sqrt((double)CELLS / (double)o->all->count);
    const unsigned n = fair > 96 ? 96 : fair < 16 ? 16 : (unsigned)fair / 8 * 8;
    mesh m = { 0 };
    surface_view s = { .o = o,
                       .scene = { .m = &m,
                                  .wire = o->wire,
                                  .azimuth = o->azimuth,
                                  .elevation = o->elevation,
                                  .distance = o->distance } };
    bool png;

    if (!plot_known(o->output, &png))
        return host_error(h, EX_USAGE, "picture.name", (host_place){ o->output, 0 }, NULL,
                          "give a name that ends with .png, .svg or .pdf");
    int code = mesh_make(h, &m, o->all, source_name(o->name), o->e, n, n / 8);
    if (code == 0) {
        if (o->around != NULL)
            o->around(o->context, &m);
        add_lines(&s);
        scene_look(&s.scene);
        double *value = make_map(&s);
        code = draw_scene(h, &s, png);
        free(value);
    }
    scene_free(&s.scene);
    mesh_free(&m);
    return code;
}
