/* host-tools/draw/plot_frame.c -- axes in mm, title with numbers, legend, scale bar and colour bar
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "engine/curve.h"
#include "draw/plot.h"
#include "base/source.h"     /* source_name */
#include "host/duration.h"   /* host_duration */

#define SMALL PLOT_SMALL
#define LARGE PLOT_LARGE

void plot_ink(const plot_view *v, double grey) { cairo_set_source_rgb(v->cairo, grey, grey, grey); }

double plot_text(const plot_view *v, double size, double x, double y, double align,
                 const char *words)
{
    cairo_text_extents_t extents;

    cairo_set_font_size(v->cairo, size * v->u);
    cairo_text_extents(v->cairo, words, &extents);
    cairo_move_to(v->cairo, x - align * extents.x_advance, y);
    cairo_show_text(v->cairo, words);
    return extents.x_advance;
}

void plot_line(const plot_view *v, double x0, double y0, double x1, double y1)
{
    cairo_move_to(v->cairo, x0, y0);
    cairo_line_to(v->cairo, x1, y1);
    cairo_stroke(v->cairo);
}

void plot_number(char *out, size_t size, double value, double step)
{
    const int digits = step < 1 ? (int)ceil(-log10(step) - 1e-9) : 0;

    snprintf(out, size, "%.*f", digits, fabs(value) < step / 2 ? 0 : value);
}

void plot_axes(const plot_view *v)
{
    const double wide = (v->right - v->left) / v->scale, high = (v->bottom - v->top) / v->scale;
    const double step = plot_step(fmax(wide, high), 14);
    char label[32];

    plot_ink(v, 0.35);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    cairo_rectangle(v->cairo, v->left, v->top, v->right - v->left, v->bottom - v->top);
    cairo_stroke(v->cairo);
    for (double x = ceil(v->x0 / step - 1e-9) * step; x <= v->x0 + wide * (1 + 1e-9); x += step) {
        const double at = v->left + (x - v->x0) * v->scale;
        plot_line(v, at, v->bottom, at, v->bottom + 5 * v->u);
        plot_number(label, sizeof label, x, step);
        plot_text(v, SMALL, at, v->bottom + 18 * v->u, 0.5, label);
    }
    for (double y = ceil(v->y0 / step - 1e-9) * step; y <= v->y0 + high * (1 + 1e-9); y += step) {
        const double at = v->bottom - (y - v->y0) * v->scale;
        plot_line(v, v->left, at, v->left - 5 * v->u, at);
        plot_number(label, sizeof label, y, step);
        plot_text(v, SMALL, v->left - 9 * v->u, at + 4.5 * v->u, 1, label);
    }
    plot_text(v, SMALL, v->right, v->bottom + 34 * v->u, 1, "x, y in mm");
}

const char *plot_base_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

/* Print a length of the order of an error. */
static void small_length(char *out, size_t size, double mm)
{
    snprintf(out, size, mm < 0.1 ? "%.2f um" : "%.4f mm", mm < 0.1 ? mm * 1000 : mm);
}

static void draw_title(const plot_view *v)
{
    const drawing *d = v->o->d;
    const record *r = v->o->r;
    char words[256], worst[32], mean[32], time[HOST_DURATION], took[40] = "";

    plot_ink(v, 0.1);
    snprintf(words, sizeof words, "%.80s: %zu curves in %u paths, %.3f m",
             plot_base_name(source_name(v->o->name)), d->of ? d->of->count : d->count,
             d->count ? d->curve[d->count - 1].path + 1 : 0, drawing_length(d) / 1000);
    plot_text(v, LARGE, v->left, 30 * v->u, 0, words);
    if (r == NULL)
        return;
    small_length(worst, sizeof worst, v->found.worst);
    small_length(mean, sizeof mean, v->found.mean);
    if (r->slot_hz > 0)
        snprintf(took, sizeof took, "%s, ", host_duration(time, record_seconds(r), 1));
    snprintf(words, sizeof words,
             "machine: %s%zu pulses, %zu with the pen down; path error %s at worst (at %.2f, "
             "%.2f), %s on average",
             took, r->count, v->found.drawing_pulses, worst, v->found.worst_point[0],
             v->found.worst_point[1], mean);
    plot_ink(v, 0.3);
    plot_text(v, SMALL, v->left, 54 * v->u, 0, words);
}

/* Draw a sample of the line and its meaning. */
void plot_entry(const plot_view *v, double *x, double y, const double rgb[3], double wide,
                bool dashed, const char *words)
{
    const double dash[2] = { 4 * v->u, 3 * v->u };

    cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
    cairo_set_line_width(v->cairo, wide * v->u);
    cairo_set_dash(v->cairo, dash, dashed ? 2 : 0, 0);
    plot_line(v, *x, y, *x + 30 * v->u, y);
    cairo_set_dash(v->cairo, NULL, 0, 0);
    plot_ink(v, 0.1);
    *x += 36 * v->u;
    *x += plot_text(v, SMALL, *x, y + 4.5 * v->u, 0, words) + 22 * v->u;
}

static void legend_entry(const plot_view *v, double *x, double r, double g, double b, double wide,
                         bool dashed, const char *words)
{
    const double rgb[3] = { r, g, b };

    plot_entry(v, x, v->bottom + 58 * v->u, rgb, wide, dashed, words);
}

static void draw_legend(const plot_view *v)
{
    const plot_options *o = v->o;
    double x = v->left, rgb[3];
    char words[64];

    if (o->r != NULL && v->magnified == 0)
        legend_entry(v, &x, 0.72, 0.79, 0.88, 2.6, false, "drawing");
    else
        legend_entry(v, &x, 0.13, 0.20, 0.34, 1.3, false, "drawing");
    if (o->control)
        legend_entry(v, &x, 0.90, 0.55, 0.10, 0.8, false, "control polygons");
    if (v->comb > 0) {
        snprintf(words, sizeof words, "curvature, 1/mm = %g mm", v->comb);
        legend_entry(v, &x, 0.10, 0.55, 0.50, 0.8, false, words);
    }
    if (o->r == NULL)
        return;
    if (v->magnified == 0) {
        legend_entry(v, &x, 0.80, 0.12, 0.16, 0.8, false, "machine");
    } else {
        plot_colour(0.6, rgb);
        snprintf(words, sizeof words, "machine, error magnified %g times", v->magnified);
        legend_entry(v, &x, rgb[0], rgb[1], rgb[2], 1.6, false, words);
    }
    legend_entry(v, &x, 0.45, 0.62, 0.80, 0.8, true, "travel");
}

void plot_scale_bar(const plot_view *v, double y, double parts)
{
    const double mm = plot_step((v->right - v->left) / v->scale, parts), x1 = v->right,
                 x0 = x1 - mm * v->scale;
    char label[32];

    plot_ink(v, 0.1);
    cairo_set_line_width(v->cairo, 2 * v->u);
    plot_line(v, x0, y, x1, y);
    cairo_set_line_width(v->cairo, 1 * v->u);
    plot_line(v, x0, y - 4 * v->u, x0, y + 4 * v->u);
    plot_line(v, x1, y - 4 * v->u, x1, y + 4 * v->u);
    snprintf(label, sizeof label, "%g mm", mm);
    plot_text(v, SMALL, x0 - 8 * v->u, y + 4.5 * v->u, 1, label);
}

/* Dark blue over purple and red to yellow: the brightness increases, so the scale survives grey
 * printing. */
void plot_colour(double share, double rgb[3])
{
    static const double stops[5][3] = { { 0.10, 0.15, 0.55 },
                                        { 0.45, 0.10, 0.62 },
                                        { 0.80, 0.16, 0.40 },
                                        { 0.95, 0.45, 0.15 },
                                        { 0.98, 0.80, 0.15 } };
    const double at = fmin(fmax(share, 0), 1) * 4;
    const int i = at < 4 ? (int)at : 3;

    for (int k = 0; k < 3; k++)
        rgb[k] = stops[i][k] + (at - i) * (stops[i + 1][k] - stops[i][k]);
}

void plot_bar(const plot_view *v, double most, const char *words)
{
    const double x = v->right + 18 * v->u, wide = 14 * v->u,
                 room = v->bottom - v->top - (v->inset ? PLOT_INSET + PLOT_BELOW : 0) * v->u,
                 high = fmin(room, 420 * v->u);
    const double step = plot_step(most, 7);
    char label[32];
    double rgb[3];

    for (int i = 0; i < 120; i++) {
        plot_colour((i + 0.5) / 120, rgb);
        cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
        cairo_rectangle(v->cairo, x, v->bottom - high * (i + 1) / 120, wide, high / 120 * 1.1);
        cairo_fill(v->cairo);
    }
    plot_ink(v, 0.1);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    for (int i = 0; i * step <= most * (1 + 1e-9); i++) {
        const double y = v->bottom - high * i * step / most;
        plot_line(v, x + wide, y, x + wide + 4 * v->u, y);
        plot_number(label, sizeof label, i * step, step);
        plot_text(v, SMALL, x + wide + 8 * v->u, y + 4.5 * v->u, 0, label);
    }
    plot_text(v, SMALL, x, v->bottom + 18 * v->u, 0, words);
}

void plot_frame(plot_view *v)
{
    cairo_select_font_face(v->cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_cap(v->cairo, CAIRO_LINE_CAP_BUTT);
    plot_axes(v);
    draw_title(v);
    draw_legend(v);
    plot_scale_bar(v, v->bottom + 58 * v->u, v->inset ? 20 : 8);
    if (v->magnified > 0 && v->found.worst > 0)
        plot_bar(v, v->found.worst * 1000, "error, um");
}
