/* host-tools/draw/surface_frame.c -- title, axes, legend and scale of a picture of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "base/source.h"     /* source_name */
#include "draw/surface_plot.h"

static void draw_title(const surface_view *s)
{
    const surface_options *o = s->o;
    char words[256];

    plot_ink(&s->v, 0.1);
    if (o->all->count == 1)
        snprintf(words, sizeof words, "%.80s: %s", plot_base_name(source_name(o->name)),
                 surface_name(o->all->surface[0].kind));
    else
        snprintf(words, sizeof words, "%.80s: %zu surfaces", plot_base_name(source_name(o->name)),
                 o->all->count);
    const double x = s->v.left + plot_text(&s->v, PLOT_LARGE, s->v.left, 34 * s->v.u, 0, words);
    snprintf(words, sizeof words, "seen from %g\302\260 around, %g\302\260 up%s", o->azimuth,
             o->elevation, o->distance > 0 ? ", in perspective" : "");
    plot_ink(&s->v, 0.4);
    plot_text(&s->v, PLOT_SMALL, x + 18 * s->v.u, 34 * s->v.u, 0, words);
}

void surface_axes(const plot_view *v, const scene *s, double x, double y)
{
    static const double colour[3][3] = { { 0.75, 0.20, 0.20 },
                                         { 0.15, 0.55, 0.25 },
                                         { 0.20, 0.35, 0.75 } };
    static const char *const names[3] = { "x", "y", "z" };
    const double length = 30 * v->u;

    for (int i = 0; i < 3; i++) {
        const double dx = s->axis[0][i] * length, dy = -s->axis[1][i] * length,
                     seen = hypot(dx, dy);
        cairo_set_source_rgb(v->cairo, colour[i][0], colour[i][1], colour[i][2]);
        cairo_set_line_width(v->cairo, 1.6 * v->u);
        if (seen < 0.12 * length)                       /* it points at the eye or away from it */
            continue;
        plot_line(v, x, y, x + dx, y + dy);
        plot_text(v, PLOT_SMALL, x + dx + 9 * v->u * dx / seen,
                  y + dy + 9 * v->u * dy / seen + 4 * v->u, 0.5, names[i]);
    }
}

/* Describe the heights in words; equal steps are named as such. */
void surface_heights(char *out, size_t size, const double height[], size_t count)
{
    const double step = count > 1 ? height[1] - height[0] : 0;
    bool equal = count > 2;
    size_t at = 0;

    for (size_t i = 1; i < count; i++)
        equal = equal && fabs(height[i] - height[i - 1] - step) < 1e-6 * fabs(step);
    if (equal) {
        snprintf(out, size, "z from %.6g to %.6g by %.6g mm", height[0], height[count - 1], step);
        return;
    }
    at = (size_t)snprintf(out, size, "z =");
    for (size_t i = 0; i < count && at + 24 < size; i++)
        at += (size_t)snprintf(out + at, size - at, "%s %.6g", i > 0 ? "," : "", height[i]);
    if (at + 4 < size)
        snprintf(out + at, size - at, " mm");
}

static void swatch(const surface_view *s, double *x, const double rgb[3], bool line,
                   const char *words)
{
    const plot_view *v = &s->v;
    const double y = v->bottom + 74 * v->u;

    cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
    if (line) {
        cairo_set_line_width(v->cairo, 1.2 * v->u);
        plot_line(v, *x, y, *x + 24 * v->u, y);
    } else {
        cairo_rectangle(v->cairo, *x, y - 6 * v->u, 24 * v->u, 12 * v->u);
        cairo_fill(v->cairo);
    }
    plot_ink(v, 0.1);
    *x += 30 * v->u;
    *x += plot_text(v, PLOT_SMALL, *x, y + 4.5 * v->u, 0, words) + 24 * v->u;
}

static void draw_legend(const surface_view *s)
{
    static const double lines[3] = { 0.35, 0.38, 0.45 };
    double x = s->v.left + 110 * s->v.u;
    char words[120];

    if (s->o->map == MAP_NONE && !s->o->wire) {
        swatch(s, &x, scene_sides[0], false, "side of the normal");
        swatch(s, &x, scene_sides[1], false, "other side");
    }
    if (!s->scene.plain)
        swatch(s, &x, lines, true, "u, v at eighths");
    if (s->o->around)
        swatch(s, &x, scene_around, false, s->o->around_words);
    if (s->o->control)
        swatch(s, &x, scene_pens[SCENE_NET], true, "control net");
    if (s->heights > 0) {
        surface_heights(words, sizeof words, s->height, s->heights);
        swatch(s, &x, scene_pens[SCENE_CONTOUR], true, words);
    }
}

/* There is one scale only without perspective. */
static void scale_bar(const surface_view *s)
{
    const plot_view *v = &s->v;

    if (!(s->o->distance > 0))
        plot_scale_bar(v, v->bottom + 74 * v->u, 12);
}

void surface_frame(const surface_view *s)
{
    static const char *const maps[] = { [MAP_NONE] = "",
                                        [MAP_GAUSS] = "Gaussian curvature, 1/mm\302\262",
                                        [MAP_MEAN] = "mean curvature, 1/mm",
                                        [MAP_LARGEST] = "largest curvature, 1/mm",
                                        [MAP_GIVEN] = "" };
    const plot_view *v = &s->v;

    cairo_select_font_face(v->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    draw_title(s);
    surface_axes(v, &s->scene, v->left + 34 * v->u, v->bottom + 52 * v->u);
    draw_legend(s);
    scale_bar(s);
    if (s->o->map != MAP_NONE)
        scene_bar(v, &s->scene.scale, s->o->map == MAP_GIVEN ? s->o->words : maps[s->o->map],
                  v->right + 34 * v->u, v->top + 6 * v->u,
                  fmin(v->bottom - v->top - 40 * v->u, 400 * v->u));
}
