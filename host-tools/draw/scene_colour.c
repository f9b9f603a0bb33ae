/* host-tools/draw/scene_colour.c -- the colours of maps, and the colour bar
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "draw/scene.h"
#include "base/memory.h"

const double scene_sides[2][3] = { { 0.53, 0.68, 0.86 }, { 0.90, 0.74, 0.50 } };
const double scene_around[3] = { 0.83, 0.76, 0.63 };
const double scene_pens[3][3] = { [SCENE_NET] = { 0.90, 0.45, 0.10 },
                                  [SCENE_CONTOUR] = { 0.42, 0.05, 0.36 },
                                  [SCENE_EDGE] = { 0.12, 0.15, 0.22 } };

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

void scene_scale_of(scene_scale *s, const double value[], size_t count, double flat)
{
    double *size = memory_grow(NULL, count * sizeof *size);

    for (size_t i = 0; i < count; i++)
        size[i] = fabs(value[i]);
    qsort(size, count, sizeof *size, ascending);
    const double most = size[count - 1], common = size[(count - 1) * 98 / 100];
    s->limit   = most <= flat ? 0 : most <= 1.5 * common ? most : common;
    s->clipped = most > s->limit * 1.001 && s->limit > 0;
    free(size);
}

void scene_colour(const scene_scale *s, double value, double rgb[3])
{
    static const double ends[2][3] = { { 0.13, 0.35, 0.72 }, { 0.78, 0.13, 0.17 } };
    const double share = s->limit > 0 ? fmin(fmax(value / s->limit, -1), 1) : 0,
                 size = pow(fabs(share), 0.8);

    if (!s->signs)
        plot_colour(share, rgb);
    else
        for (int i = 0; i < 3; i++)
            rgb[i] = 0.96 + size * (ends[share > 0][i] - 0.96);
}

static void label_of(char *out, size_t size, double value, double step)
{
    if (step >= 1e-3 && fabs(value) < 1e4)
        plot_number(out, size, value, step);
    else
        snprintf(out, size, "%.2g", fabs(value) < step / 2 ? 0 : value);
}

static void bar(const plot_view *v, const scene_scale *s, double x, double low, double wide,
                double high)
{
    const double from = s->signs ? -s->limit : 0, range = s->limit - from;
    double rgb[3];

    cairo_set_antialias(v->cairo, CAIRO_ANTIALIAS_NONE);     /* no seams */
    for (int i = 0; i < 128; i++) {
        scene_colour(s, from + range * (i + 0.5) / 128, rgb);
        cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
        cairo_rectangle(v->cairo, x, low - high * (i + 1) / 128, wide, high / 128 * 1.1);
        cairo_fill(v->cairo);
    }
    cairo_set_antialias(v->cairo, CAIRO_ANTIALIAS_DEFAULT);
    plot_ink(v, 0.1);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    cairo_rectangle(v->cairo, x, low - high, wide, high);
    cairo_stroke(v->cairo);
}

void scene_bar(const plot_view *v, const scene_scale *s, const char *words, double x, double top,
               double high)
{
    const double from = s->signs ? -s->limit : 0, range = s->limit - from,
                 step = plot_step(range, 7);
    const double wide = 16 * v->u, low = top + 24 * v->u + high, end = v->width - 14 * v->u;
    char label[40];

    plot_ink(v, 0.1);
    plot_text(v, PLOT_SMALL, end, top, 1, words);
    if (!(range > 0)) {
        plot_text(v, PLOT_SMALL, x, top + 28 * v->u, 0, "0 everywhere");
        return;
    }
    bar(v, s, x, low, wide, high);
    for (double value = ceil(from / step - 1e-9) * step; value <= s->limit * (1 + 1e-9);
         value += step) {
        const double y = low - high * (value - from) / range;
        plot_line(v, x + wide, y, x + wide + 4 * v->u, y);
        label_of(label, sizeof label, value, step);
        plot_text(v, PLOT_SMALL, x + wide + 9 * v->u, y + 4.5 * v->u, 0, label);
    }
    if (s->clipped)
        plot_text(v, PLOT_SMALL, end, low + 24 * v->u, 1, "and beyond");
}
