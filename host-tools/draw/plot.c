/* host-tools/draw/plot.c -- the layers of the picture
 * SPDX-License-Identifier: MIT
 */
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "draw/plot.h"
#include "base/create.h"      /* create_refused */
#include "base/host.h"
#include "base/memory.h"

#define PT_PER_MM   (72 / 25.4)
/* pieces in one stroke: cairo takes much longer for long ones */
#define BATCH       256

double plot_x(const plot_view *v, double x) { return v->left + (x - v->x0) * v->scale; }
double plot_y(const plot_view *v, double y) { return v->bottom - (y - v->y0) * v->scale; }


// Drawing
// -------

/* The rapids of a program, or all other curves. */
static void stroke_curves(const plot_view *v, bool rapids)
{
    const drawing *d = v->o->d;
    bool on          = false;   /* the last curve was one of them */

    for (size_t i = 0; i < d->count; i++) {
        const double (*p)[2] = (const double (*)[2])d->curve[i].p;
        const bool is = d->curve[i].feed < 0;
        if (i % BATCH == 0)
            cairo_stroke(v->cairo);
        if (is == rapids && (!on || i % BATCH == 0 || d->curve[i].path != d->curve[i - 1].path))
            cairo_move_to(v->cairo, plot_x(v, p[0][0]), plot_y(v, p[0][1]));
        if (is == rapids)
            cairo_curve_to(v->cairo, plot_x(v, p[1][0]), plot_y(v, p[1][1]), plot_x(v, p[2][0]),
                           plot_y(v, p[2][1]), plot_x(v, p[3][0]), plot_y(v, p[3][1]));
        on = is == rapids;
    }
    cairo_stroke(v->cairo);
}

void plot_curves(const plot_view *v, double line, double r, double g, double b)
{
    cairo_set_source_rgb(v->cairo, r, g, b);
    cairo_set_line_width(v->cairo, line * v->u);
    stroke_curves(v, false);
}


// Machine
// -------

/* Pulses are much denser than the picture. Of those on one spot only the last is drawn. */
static bool is_same_spot(const plot_view *v, const double a[2], const double b[2])
{
    return fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1])) * v->scale < 0.15 * v->u;
}

void plot_machine(const plot_view *v, bool drawing_runs)
{
    const record *r = v->o->r;
    const double *last = NULL;          /* drawn so far; NULL: no run is open */
    unsigned pieces = 0;

    for (size_t i = 0; i < r->count; i++) {
        const double *before = i > 0 ? r->pulse[i - 1].at : r->start, *now = r->pulse[i].at;
        const bool moves = now[0] != before[0] || now[1] != before[1];
        if (!moves)
            continue;
        if (record_draws(r, i) != drawing_runs) {
            if (last != NULL) {
                cairo_line_to(v->cairo, plot_x(v, before[0]), plot_y(v, before[1]));
                cairo_stroke(v->cairo);
            }
            last = NULL;
            continue;
        }
        if (last == NULL) {
            cairo_move_to(v->cairo, plot_x(v, before[0]), plot_y(v, before[1]));
            last = before;
        }
        if (!is_same_spot(v, last, now) || i + 1 == r->count ||
            record_draws(r, i + 1) != drawing_runs) {
            cairo_line_to(v->cairo, plot_x(v, now[0]), plot_y(v, now[1]));
            last = now;
            if (drawing_runs && ++pieces % BATCH == 0) {    /* dashes would start anew */
                cairo_stroke(v->cairo);
                cairo_move_to(v->cairo, plot_x(v, now[0]), plot_y(v, now[1]));
            }
        }
    }
    cairo_stroke(v->cairo);
}

/* That of the record; without one, the rapids of the program. */
static void draw_travel(const plot_view *v)
{
    const double dash[2] = { 4 * v->u, 3 * v->u };

    cairo_set_source_rgb(v->cairo, 0.45, 0.62, 0.80);
    cairo_set_line_width(v->cairo, 0.6 * v->u);
    cairo_set_dash(v->cairo, dash, 2, 0);
    if (v->o->r != NULL)
        plot_machine(v, false);
    else
        stroke_curves(v, true);
    cairo_set_dash(v->cairo, NULL, 0, 0);
}


// Error
// -----

static void flush_brush(const plot_brush *b)
{
    double rgb[3];

    plot_colour((b->level + 0.5) / PLOT_LEVELS, rgb);
    cairo_set_source_rgb(b->v->cairo, rgb[0], rgb[1], rgb[2]);
    cairo_stroke(b->v->cairo);
}

void plot_brush_to(plot_brush *b, const double to[2], int level)
{
    if (b->open && level != b->level)
        flush_brush(b);
    if (!b->open || level != b->level) {
        const double *from = b->open ? b->at : to;
        cairo_move_to(b->v->cairo, plot_x(b->v, from[0]), plot_y(b->v, from[1]));
    }
    cairo_line_to(b->v->cairo, plot_x(b->v, to[0]), plot_y(b->v, to[1]));
    memcpy(b->at, to, sizeof b->at);
    b->level = level;
    b->open  = true;
}

void plot_brush_up(plot_brush *b)
{
    if (b->open)
        flush_brush(b);
    b->open = false;
}

/* Draw each position at its error times `magnified` from the nearest point of the drawing. Of the
 * pulses on one spot the worst is drawn: thinning hides no error. */
static void draw_errors(const plot_view *v, double (*point)[2])
{
    const record *r = v->o->r;
    plot_brush b = { .v = v };
    double spot[2] = { 0, 0 }, most = -1, far[2] = { 0, 0 };

    cairo_set_line_width(v->cairo, 1.1 * v->u);
    cairo_set_line_join(v->cairo, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; i < r->count; i++) {
        const bool draws = record_draws(r, i);
        const double *now = r->pulse[i].at;
        if (most >= 0 && (!draws || !is_same_spot(v, spot, now))) {
            const int level = (int)(most / v->found.worst * PLOT_LEVELS);
            plot_brush_to(&b, far, level < PLOT_LEVELS ? level : PLOT_LEVELS - 1);
            most = -1;
        }
        if (!draws) {
            if (i + 1 == r->count || now[2] > r->pen_down)
                plot_brush_up(&b);
            continue;
        }
        if (most < 0)
            memcpy(spot, now, sizeof spot);
        const double off = hypot(now[0] - point[i][0], now[1] - point[i][1]);
        if (off > most) {
            most = off;
            for (int k = 0; k < 2; k++)
                far[k] = point[i][k] + v->magnified * (now[k] - point[i][k]);
        }
    }
    if (most >= 0)
        plot_brush_to(&b, far,
                      PLOT_LEVELS - 1 < (int)(most / v->found.worst * PLOT_LEVELS)
                          ? PLOT_LEVELS - 1
                          : (int)(most / v->found.worst * PLOT_LEVELS));
    plot_brush_up(&b);
}

static void measure_errors(plot_view *v, double (*point)[2])
{
    const record *r = v->o->r;
    size_t where = 0;
    double sum = 0;

    v->found.worst = record_worst_error(v->o->d, r, point, &where);
    memcpy(v->found.worst_point, r->pulse[where].at, sizeof v->found.worst_point);
    for (size_t i = 0; i < r->count; i++)
        if (record_draws(r, i)) {
            sum += hypot(r->pulse[i].at[0] - point[i][0], r->pulse[i].at[1] - point[i][1]);
            v->found.drawing_pulses++;
        }
    v->found.mean = v->found.drawing_pulses ? sum / (double)v->found.drawing_pulses : 0;
}

/* A round factor that shows the worst error as about four thousandths of the picture. */
static double magnification(const plot_view *v)
{
    if (v->o->error > 0 || v->o->error < 0)
        return fmax(v->o->error, 0);
    if (v->found.worst <= 0)
        return 1;
    const double wanted = fmax(4 * v->u / v->scale / v->found.worst, 1),
                 power = pow(10, floor(log10(wanted)));
    return wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
}


// Picture
// -------

void plot_join(double box[2][2], const double p[2])
{
    for (int i = 0; i < 2; i++) {
        box[0][i] = fmin(box[0][i], p[i]);
        box[1][i] = fmax(box[1][i], p[i]);
    }
}

/* The visible box in mm: the requested part, or page, curves and machine with a margin. */
static void choose_box(plot_view *v, double box[2][2])
{
    const plot_options *o = v->o;

    if (o->part[2] > 0) {
        for (int i = 0; i < 2; i++) {
            box[0][i] = o->part[i];
            box[1][i] = o->part[i] + o->part[i + 2];
        }
        plot_make_combs(v, (const double (*)[2])box);
        return;
    }
    const double corner[2] = { 0, 0 }, opposite[2] = { o->d->width, o->d->height };
    drawing_box(o->d, box);
    plot_make_combs(v, (const double (*)[2])box);
    if (o->d->height > 0) {
        plot_join(box, corner);
        plot_join(box, opposite);
    }
    plot_shape_box(v, box);
    for (size_t i = 0; o->r != NULL && i < o->r->count; i++)
        plot_join(box, o->r->pulse[i].at);
    const double air = o->d->height > 0 && o->r == NULL
                           ? 0
                           : 0.02 * fmax(box[1][0] - box[0][0], box[1][1] - box[0][1]);
    for (int i = 0; i < 2; i++) {
        box[0][i] -= air;
        box[1][i] += air;
    }
}

static bool ends_with(const char *text, const char *end)
{
    return strlen(text) >= strlen(end) && strcasecmp(text + strlen(text) - strlen(end), end) == 0;
}

/* Margins in thousandths of the width: labels at the left and below, the title above, the colour
 * bar at the right. */
static void lay_out_picture(plot_view *v, bool vector)
{
    const plot_options *o = v->o;
    const double left = 62,
                 right = o->tol > 0                      ? 254
                         : o->r != NULL && o->error >= 0 ? 105
                                                         : 28,
                 above = o->r != NULL ? 74 : 52, below = 82;
    double box[2][2];

    v->inset = o->tol > 0;
    choose_box(v, box);
    const double wide = fmax(box[1][0] - box[0][0], 1e-6), high = fmax(box[1][1] - box[0][1], 1e-6);
    const double room = 1000 - left - right;
    /* per mm, in thousandths */
    const double by_width = room / wide, by_height = 2.5 * room / high;
    const double thousandths = fmin(by_width, by_height);

    v->width = o->size > 0 ? o->size * (vector ? PT_PER_MM : 1)
               : vector    ? PT_PER_MM * 1000 / thousandths
                           : 1600;
    v->u      = v->width / 1000;
    v->scale  = thousandths * v->u;
    v->x0     = box[0][0];
    v->y0     = box[0][1];
    v->left   = left * v->u;
    v->right  = v->left + wide * v->scale;
    v->top    = above * v->u;
    v->bottom = v->top + fmax(high * v->scale, v->inset ? PLOT_TALL * v->u : 0);
    v->height = v->bottom + below * v->u;
}

static void draw_layers(plot_view *v)
{
    const plot_options *o = v->o;
    double (*point)[2] = o->r ? memory_grow(NULL, o->r->count * sizeof *point) : NULL;

    if (o->r != NULL)
        measure_errors(v, point);
    v->magnified = o->r != NULL ? magnification(v) : 0;

    cairo_set_source_rgb(v->cairo, 1, 1, 1);
    cairo_paint(v->cairo);
    cairo_save(v->cairo);
    cairo_rectangle(v->cairo, v->left, v->top, v->right - v->left, v->bottom - v->top);
    cairo_clip(v->cairo);
    plot_combs(v);
    draw_travel(v);
    if (o->r != NULL && v->magnified == 0) {
        plot_curves(v, 2.6, 0.72, 0.79, 0.88);
        cairo_set_source_rgb(v->cairo, 0.80, 0.12, 0.16);
        cairo_set_line_width(v->cairo, 0.8 * v->u);
        plot_machine(v, true);
    } else {
        plot_curves(v, o->r ? 0.8 : 1.3, 0.13, 0.20, 0.34);
    }
    if (o->control)
        plot_control(v);
    if (v->magnified > 0 && v->found.worst > 0)
        draw_errors(v, point);
    cairo_restore(v->cairo);
    plot_frame(v);
    if (v->inset)
        plot_corner(v);
    free(point);
}

bool plot_known(const char *output, bool *png)
{
    *png = ends_with(output, ".png");
    return *png || ends_with(output, ".svg") || ends_with(output, ".pdf");
}

/* Cairo's own file output does not notice a full disk when it is closed. */
static cairo_status_t write_bytes(void *closure, const unsigned char *data, unsigned length)
{
    plot_view *v = closure;

    if (v->file != NULL && fwrite(data, 1, length, v->file) != length)
        v->failed = errno;
    return v->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

cairo_surface_t *plot_begin(plot_view *v, const char *output)
{
    bool png;

    (void)plot_known(output, &png);
    v->file   = create_file(output);
    v->failed = v->file == NULL ? errno : 0;
    cairo_surface_t *canvas =
        png ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(v->width),
                                         (int)ceil(v->height))
        : ends_with(output, ".svg")
            ? cairo_svg_surface_create_for_stream(write_bytes, v, v->width, v->height)
            : cairo_pdf_surface_create_for_stream(write_bytes, v, v->width, v->height);
    v->cairo = cairo_create(canvas);
    cairo_set_line_cap(v->cairo, CAIRO_LINE_CAP_ROUND);
    return canvas;
}

int plot_end(host *h, plot_view *v, cairo_surface_t *canvas, const char *output)
{
    cairo_status_t status = cairo_status(v->cairo);

    cairo_destroy(v->cairo);
    if (status == CAIRO_STATUS_SUCCESS && ends_with(output, ".png"))
        status = cairo_surface_write_to_png_stream(canvas, write_bytes, v);
    cairo_surface_finish(canvas);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(canvas);
    cairo_surface_destroy(canvas);
    if (v->file != NULL && fclose(v->file) != 0 && v->failed == 0)
        v->failed = errno;
    if (v->failed != 0)
        return create_refused(h, output, v->failed);
    if (status != CAIRO_STATUS_SUCCESS)
        return host_error(h, EX_CANTCREAT, "picture.not-drawn", (host_place){ output, 0 },
                          "try another --size", "the picture cannot be drawn: %s",
                          cairo_status_to_string(status));
    return 0;
}

int plot_draw(host *h, const plot_options *o, plot_result *result)
{
    plot_view v = { .o = o };
    bool png;

    if (!plot_known(o->output, &png))
        return host_error(h, EX_USAGE, "picture.name", (host_place){ o->output, 0 }, NULL,
                          "give a name that ends with .png, .svg or .pdf");
    lay_out_picture(&v, !png);
    if (png && (v.width > 30000 || v.height > 30000))
        return host_error(h, EX_USAGE, "picture.too-large", (host_place){ o->output, 0 },
                          "give a smaller --size", "%.0f x %.0f px are too many", v.width,
                          v.height);

    cairo_surface_t *canvas = plot_begin(&v, o->output);
    draw_layers(&v);
    if (result != NULL)
        *result = v.found;
    free(v.tooth);
    return plot_end(h, &v, canvas, o->output);
}
