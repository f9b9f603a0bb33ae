/* host-tools/surface_frame.c -- title, axes, legend, scale and colour bar of a picture of surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "source.h"     /* source_name */
#include "surface_plot.h"

static void title(const surface_view *s)
{
    const surface_options *o = s->o;
    char words[256];

    plot_ink(&s->v, 0.1);
    if (o->all->count == 1)
        snprintf(words, sizeof words, "%.80s: %s", plot_base_name(source_name(o->name)), surface_name(o->all->surface[0].kind));
    else
        snprintf(words, sizeof words, "%.80s: %zu surfaces", plot_base_name(source_name(o->name)), o->all->count);
    const double x = s->v.left + plot_text(&s->v, PLOT_LARGE, s->v.left, 34 * s->v.u, 0, words);
    snprintf(words, sizeof words, "seen from %g\302\260 around, %g\302\260 up%s", o->azimuth, o->elevation, o->distance > 0 ? ", in perspective" : "");
    plot_ink(&s->v, 0.4);
    plot_text(&s->v, PLOT_SMALL, x + 18 * s->v.u, 34 * s->v.u, 0, words);
}

/* The three directions as they are seen, in the lower left corner. */
static void axes(const surface_view *s)
{
    static const double colour[3][3] = { { 0.75, 0.20, 0.20 }, { 0.15, 0.55, 0.25 }, { 0.20, 0.35, 0.75 } };
    static const char *const names[3] = { "x", "y", "z" };
    const plot_view *v = &s->v;
    const double x = v->left + 34 * v->u, y = v->bottom + 52 * v->u, length = 30 * v->u;

    for (int i = 0; i < 3; i++) {
        const double dx = s->axis[0][i] * length, dy = -s->axis[1][i] * length, seen = hypot(dx, dy);
        cairo_set_source_rgb(v->cairo, colour[i][0], colour[i][1], colour[i][2]);
        cairo_set_line_width(v->cairo, 1.6 * v->u);
        if (seen < 0.12 * length)                           /* it points at the eye or away from it */
            continue;
        plot_line(v, x, y, x + dx, y + dy);
        plot_text(v, PLOT_SMALL, x + dx + 9 * v->u * dx / seen, y + dy + 9 * v->u * dy / seen + 4 * v->u, 0.5, names[i]);
    }
}

static void swatch(const surface_view *s, double *x, const double rgb[3], bool line, const char *words)
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

static void legend(const surface_view *s)
{
    static const double net[3] = { 0.90, 0.45, 0.10 }, lines[3] = { 0.35, 0.38, 0.45 };
    double x = s->v.left + 110 * s->v.u;

    if (s->o->map == MAP_NONE && !s->o->wire) {
        swatch(s, &x, surface_sides[0], false, "side of the normal");
        swatch(s, &x, surface_sides[1], false, "other side");
    }
    swatch(s, &x, lines, true, "u, v at eighths");
    if (s->o->control)
        swatch(s, &x, net, true, "control net");
}

/* Only without perspective is there one scale. */
static void scale_bar(const surface_view *s)
{
    const plot_view *v = &s->v;
    const double mm = plot_step((v->right - v->left) / v->scale, 8), y = v->bottom + 74 * v->u, x1 = v->right, x0 = x1 - mm * v->scale;
    char label[32];

    if (s->o->distance > 0)
        return;
    plot_ink(v, 0.1);
    cairo_set_line_width(v->cairo, 2 * v->u);
    plot_line(v, x0, y, x1, y);
    cairo_set_line_width(v->cairo, 1 * v->u);
    plot_line(v, x0, y - 4 * v->u, x0, y + 4 * v->u);
    plot_line(v, x1, y - 4 * v->u, x1, y + 4 * v->u);
    snprintf(label, sizeof label, "%g mm", mm);
    plot_text(v, PLOT_SMALL, x0 - 8 * v->u, y + 4.5 * v->u, 1, label);
}

static void label_of(char *out, size_t size, double value, double step)
{
    if (step >= 1e-3 && fabs(value) < 1e4)
        plot_number(out, size, value, step);
    else
        snprintf(out, size, "%.2g", fabs(value) < step / 2 ? 0 : value);
}

static void colour_bar(const surface_view *s)
{
    static const char *const names[] = { [MAP_NONE] = "", [MAP_GAUSS] = "Gaussian curvature, 1/mm\302\262", [MAP_MEAN] = "mean curvature, 1/mm",
                                         [MAP_LARGEST] = "largest curvature, 1/mm" };
    const plot_view *v = &s->v;
    const double x = v->right + 34 * v->u, wide = 16 * v->u, high = fmin(v->bottom - v->top - 40 * v->u, 400 * v->u);
    const double low = v->top + 30 * v->u + high, from = s->o->map == MAP_LARGEST ? 0 : -s->limit, range = s->limit - from;
    char label[40];
    double rgb[3];

    plot_ink(v, 0.1);
    plot_text(v, PLOT_SMALL, v->width - 14 * v->u, v->top + 6 * v->u, 1, names[s->o->map]);
    if (!(range > 0)) {
        plot_text(v, PLOT_SMALL, x, v->top + 34 * v->u, 0, "0 everywhere");
        return;
    }
    cairo_set_antialias(v->cairo, CAIRO_ANTIALIAS_NONE);     /* no seams */
    for (int i = 0; i < 128; i++) {
        surface_colour(s, from + range * (i + 0.5) / 128, rgb);
        cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
        cairo_rectangle(v->cairo, x, low - high * (i + 1) / 128, wide, high / 128 * 1.1);
        cairo_fill(v->cairo);
    }
    const double step = plot_step(range, 7);
    cairo_set_antialias(v->cairo, CAIRO_ANTIALIAS_DEFAULT);
    plot_ink(v, 0.1);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    cairo_rectangle(v->cairo, x, low - high, wide, high);
    cairo_stroke(v->cairo);
    for (double value = ceil(from / step - 1e-9) * step; value <= s->limit * (1 + 1e-9); value += step) {
        const double y = low - high * (value - from) / range;
        plot_line(v, x + wide, y, x + wide + 4 * v->u, y);
        label_of(label, sizeof label, value, step);
        plot_text(v, PLOT_SMALL, x + wide + 9 * v->u, y + 4.5 * v->u, 0, label);
    }
    if (s->clipped)
        plot_text(v, PLOT_SMALL, v->width - 14 * v->u, low + 24 * v->u, 1, "and beyond");
}

void surface_frame(surface_view *s)
{
    cairo_select_font_face(s->v.cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    title(s);
    axes(s);
    cairo_set_line_cap(s->v.cairo, CAIRO_LINE_CAP_BUTT);
    legend(s);
    scale_bar(s);
    if (s->o->map != MAP_NONE)
        colour_bar(s);
}
