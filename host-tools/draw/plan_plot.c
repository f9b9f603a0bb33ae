/* host-tools/draw/plan_plot.c -- a picture of a plan
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/plan_plot.h"
#include "base/host.h"
#include "base/memory.h"
#include "base/tool.h"
#include "host/duration.h"      /* host_duration */

#define COLUMNS 1100        /* of a strip: motion within one column is drawn as a vertical line */
#define LOOKS   400         /* samples in a column at most */
#define LOOK    0.001       /* s                                                               */
#define CHANGE  0.016       /* s; a change of acceleration over this time is drawn as jerk */
#define FAR     2.2         /* a limit this many times as large as the data is not in the strip */

enum signal { SPEED, VX, VY, VZ, ALONG, AX, AY, AZ, JX, JY, JZ, SIGNALS };

/* Smallest and largest value of each signal in each column. */
typedef struct {
    float least[SIGNALS][COLUMNS], most[SIGNALS][COLUMNS];
} columns;

/* One diagram over time; the margins of v give its place. */
typedef struct {
    const plan_picture *p;
    const columns *c;
    plot_view v;
    double low, high;       /* values at its lower and upper edge */
    double x;               /* where its legend continues */
} strip;

static const double ink[4][3] = {
    { 0.13, 0.20, 0.34 }, { 0.84, 0.22, 0.20 }, { 0.13, 0.58, 0.28 }, { 0.25, 0.45, 0.90 }
};
static const double grey[3]   = { 0.45, 0.45, 0.45 };


// Path
// ----

/* The current move, and whether the pen is down. */
static bool pen_is_down(const plan_picture *p, double seconds, size_t *move)
{
    for (size_t k = *move + 1; k < p->path->count; k++)
        if (p->t->part[k].seconds > 0) {
            if (p->t->part[k].from > seconds)
                break;
            *move = k;
        }
    return p->path->curve[*move] != TOOLPATH_TRAVEL;
}

static double top_speed(const plan_picture *p)
{
    double drawn = 0, all = 0;

    for (size_t k = 0; k < p->path->count; k++) {
        all   = fmax(all, p->t->part[k].top);
        drawn = p->path->curve[k] != TOOLPATH_TRAVEL ? fmax(drawn, p->t->part[k].top) : drawn;
    }
    return drawn > 0 ? drawn : all;
}

static void path_travel(const plot_view *v, const plan_picture *p)
{
    const double dash[2] = { 4 * v->u, 3 * v->u };

    cairo_set_source_rgb(v->cairo, 0.45, 0.62, 0.80);
    cairo_set_line_width(v->cairo, 0.6 * v->u);
    cairo_set_dash(v->cairo, dash, 2, 0);
    for (size_t k = 0; k < p->path->count; k++) {
        const engine_move *m = &p->path->move[k];
        if (p->path->curve[k] == TOOLPATH_TRAVEL)
            plot_line(v, plot_x(v, m->p[0][0]), plot_y(v, m->p[0][1]), plot_x(v, m->p[3][0]),
                      plot_y(v, m->p[3][1]));
    }
    cairo_set_dash(v->cairo, NULL, 0, 0);
}

/* Points on the same spot are drawn once, the slowest of them. */
static void path_by_speed(const plot_view *v, const plan_picture *p, double top)
{
    plot_brush b = { .v = v };
    size_t near = 0, move = 0;
    double slow = HUGE_VAL;

    cairo_set_line_width(v->cairo, 1.8 * v->u);
    cairo_set_line_join(v->cairo, CAIRO_LINE_JOIN_ROUND);
    for (double k = 0; k * LOOK < p->t->seconds; k++) {
        trace_motion m;
        if (!pen_is_down(p, k * LOOK, &move)) {
            plot_brush_up(&b);
            continue;
        }
        trace_at(p->t, k * LOOK, &near, &m);
        slow = fmin(slow, m.speed);
        if (b.open && hypot(m.tool.x[0] - b.at[0], m.tool.x[1] - b.at[1]) * v->scale < 0.4 * v->u)
            continue;
        const int level = (int)(slow / top * PLOT_LEVELS);
        plot_brush_to(&b, m.tool.x, level < PLOT_LEVELS ? level : PLOT_LEVELS - 1);
        slow = HUGE_VAL;
    }
    plot_brush_up(&b);
}

static void path_picture(const plot_view *v, const plan_picture *p)
{
    const double top = top_speed(p), y = v->bottom + 34 * v->u;
    const double dash[3] = { 0.45, 0.62, 0.80 };
    double rgb[3], x = v->left;

    cairo_save(v->cairo);
    cairo_rectangle(v->cairo, v->left, v->top, v->right - v->left, v->bottom - v->top);
    cairo_clip(v->cairo);
    path_travel(v, p);
    path_by_speed(v, p, top);
    cairo_restore(v->cairo);
    plot_axes(v);
    plot_bar(v, top, "mm/s");
    plot_colour(0.6, rgb);
    plot_entry(v, &x, y, rgb, 1.8, false, "drawn, by its speed");
    plot_entry(v, &x, y, dash, 0.6, true, "travel");
}


// What is drawn over time
// -----------------------

/* Jerk is drawn as the change of acceleration over 16 ms. Control points are rounded to 1/65536 mm,
 * which in a span of 2 ms is up to 45,000 mm/s^3 that nobody planned and no machine feels. */
static void see_jerk(const trace *t, double seconds, size_t near[2], trace_motion *m)
{
    trace_motion before, after;

    trace_at(t, fmax(seconds - CHANGE / 2, 0), &near[0], &before);
    trace_at(t, fmin(seconds + CHANGE / 2, t->seconds), &near[1], &after);
    for (int i = 0; i < ENGINE_AXES; i++)
        m->j[i] = (after.a[i] - before.a[i]) / CHANGE;
}

static void take_motion(columns *c, int column, const trace_motion *m)
{
    const double value[SIGNALS] = { m->speed, fabs(m->v[0]), fabs(m->v[1]), fabs(m->v[2]),
                                    m->along, m->a[0],       m->a[1],       m->a[2],
                                    m->j[0],  m->j[1],       m->j[2] };

    for (int s = 0; s < SIGNALS; s++) {
        c->least[s][column] = fminf(c->least[s][column], (float)value[s]);
        c->most[s][column]  = fmaxf(c->most[s][column], (float)value[s]);
    }
}

static void fill_columns(columns *c, const trace *t)
{
    const double wide = t->seconds / COLUMNS;
    const int looks   = (int)fmin(fmax(ceil(wide / LOOK), 3), LOOKS);
    size_t near = 0, around[2] = { 0, 0 };

    for (int k = 0; k < COLUMNS; k++) {
        for (int s = 0; s < SIGNALS; s++) {
            c->least[s][k] = HUGE_VALF;
            c->most[s][k]  = -HUGE_VALF;
        }
        for (int n = 0; n < looks; n++) {
            trace_motion m;
            trace_at(t, wide * (k + (n + 0.5) / looks), &near, &m);
            see_jerk(t, wide * (k + (n + 0.5) / looks), around, &m);
            take_motion(c, k, &m);
        }
    }
}

static double peak_of(const columns *c, enum signal first, enum signal last)
{
    float most = 0;

    for (unsigned s = first; s <= last; s++)
        for (int k = 0; k < COLUMNS; k++)
            most = fmaxf(most, fmaxf(-c->least[s][k], c->most[s][k]));
    return (double)most;
}


// Strips
// ------

static double strip_x(const strip *s, double seconds)
{
    return s->v.left + (s->v.right - s->v.left) * seconds / s->p->t->seconds;
}
static double strip_y(const strip *s, double value)
{
    return s->v.bottom - (s->v.bottom - s->v.top) * (value - s->low) / (s->high - s->low);
}

static void strip_axes(strip *s, const char *words, bool last)
{
    const plot_view *v = &s->v;
    const double step  = plot_step(s->p->t->seconds, 14), rise = plot_step(s->high - s->low, 5);
    char label[32];

    plot_ink(v, 0.88);
    cairo_set_line_width(v->cairo, 0.6 * v->u);
    plot_line(v, v->left, strip_y(s, 0), v->right, strip_y(s, 0));
    plot_ink(v, 0.35);
    cairo_set_line_width(v->cairo, 0.8 * v->u);
    cairo_rectangle(v->cairo, v->left, v->top, v->right - v->left, v->bottom - v->top);
    cairo_stroke(v->cairo);
    for (double x = 0; x <= s->p->t->seconds * (1 + 1e-9); x += step) {
        plot_line(v, strip_x(s, x), v->bottom, strip_x(s, x), v->bottom + 5 * v->u);
        plot_number(label, sizeof label, x, step);
        if (last)
            plot_text(v, PLOT_SMALL, strip_x(s, x), v->bottom + 18 * v->u, 0.5, label);
    }
    for (double y = ceil(s->low / rise - 1e-9) * rise; y <= s->high * (1 + 1e-9); y += rise) {
        plot_line(v, v->left, strip_y(s, y), v->left - 5 * v->u, strip_y(s, y));
        plot_number(label, sizeof label, y, rise);
        plot_text(v, PLOT_SMALL, v->left - 9 * v->u, strip_y(s, y) + 4.5 * v->u, 1, label);
    }
    if (last)
        plot_text(v, PLOT_SMALL, v->right, v->bottom + 34 * v->u, 1, "time in s");
    plot_ink(v, 0.1);
    s->x += plot_text(v, PLOT_SMALL, s->x, v->top - 9 * v->u, 0, words) + 22 * v->u;
}

static void strip_entry(strip *s, const double rgb[3], double wide, bool dashed, const char *words)
{
    plot_entry(&s->v, &s->x, s->v.top - 13.5 * s->v.u, rgb, wide, dashed, words);
}

/* Draw each column from the end that is nearer to the column before. */
static void strip_signal(strip *s, enum signal which, const double rgb[3], double wide,
                         const char *words)
{
    const plot_view *v = &s->v;
    double at = 0;

    cairo_set_source_rgb(v->cairo, rgb[0], rgb[1], rgb[2]);
    cairo_set_line_width(v->cairo, wide * v->u);
    cairo_new_path(v->cairo);
    for (int k = 0; k < COLUMNS; k++) {
        const double x = strip_x(s, s->p->t->seconds * (k + 0.5) / COLUMNS),
                     low = (double)s->c->least[which][k], high = (double)s->c->most[which][k];
        const bool up  = at - low < high - at;
        cairo_line_to(v->cairo, x, strip_y(s, up ? low : high));
        cairo_line_to(v->cairo, x, strip_y(s, up ? high : low));
        at = up ? high : low;
    }
    cairo_stroke(v->cairo);
    strip_entry(s, rgb, wide, false, words);
}

static void dash_lines(const strip *s, const double rgb[3])
{
    const double dashes[2] = { 4 * s->v.u, 3 * s->v.u };

    cairo_set_source_rgb(s->v.cairo, rgb[0], rgb[1], rgb[2]);
    cairo_set_line_width(s->v.cairo, 0.9 * s->v.u);
    cairo_set_dash(s->v.cairo, dashes, 2, 0);
}

static void strip_limit(strip *s, double limit, const double rgb[3], const char *of)
{
    char words[64];

    snprintf(words, sizeof words, limit > s->high ? "limit%s %g (above)" : "limit%s %g", of, limit);
    if (limit <= s->high) {
        dash_lines(s, rgb);
        plot_line(&s->v, s->v.left, strip_y(s, limit), s->v.right, strip_y(s, limit));
        if (s->low < 0)
            plot_line(&s->v, s->v.left, strip_y(s, -limit), s->v.right, strip_y(s, -limit));
        cairo_set_dash(s->v.cairo, NULL, 0, 0);
    }
    strip_entry(s, rgb, 0.9, true, words);
}

static const char *strip_times(const strip *s)     { return kinematics_axes(s->p->t->joints->k); }

/* Draw one line for all axes if they agree. */
static void strip_limits(strip *s, const double limit[ENGINE_AXES])
{
    bool same = true;

    for (int i = 1; i < ENGINE_AXES; i++)
        same = same && !(limit[i] < limit[0]) && !(limit[i] > limit[0]);
    for (int i = 0; i < (same ? 1 : ENGINE_AXES); i++)
        if (limit[i] > 0)
            strip_limit(s, limit[i], same ? grey : ink[i + 1],
                        same ? " of an axis" : (const char[]){ ' ', strip_times(s)[i], '\0' });
}

/* Draw the feed of the current move. */
static void strip_feed(strip *s)
{
    const trace *t = s->p->t;
    double y = s->v.bottom;

    dash_lines(s, ink[0]);
    cairo_new_path(s->v.cairo);
    for (size_t k = 0; k < t->moves; k++)
        if (t->part[k].seconds > 0) {
            cairo_line_to(s->v.cairo, strip_x(s, t->part[k].from), y);
            y = strip_y(s, fmin(t->move[k].feed, s->high));
            cairo_line_to(s->v.cairo, strip_x(s, t->part[k].from), y);
        }
    cairo_line_to(s->v.cairo, s->v.right, y);
    cairo_stroke(s->v.cairo);
    cairo_set_dash(s->v.cairo, NULL, 0, 0);
    strip_entry(s, ink[0], 0.9, true, "feed");
}

/* Choose a range for the data, and for limits that are not far from it. */
static void strip_range(strip *s, double most, const double limit[ENGINE_AXES], bool both)
{
    double range = most;

    for (int i = 0; i < ENGINE_AXES; i++)
        range = limit[i] <= FAR * most ? fmax(range, limit[i]) : range;
    s->high = range > 0 ? 1.08 * range : 1;
    s->low  = both ? -s->high : 0;
}

/* Begin a strip below the last one; `first` and `last` are its signals. */
static strip strip_begin(const plan_picture *p, const columns *c, const plot_view *v, double top,
                         double high)
{
    strip s = { .p = p, .c = c, .v = *v };

    s.v.top    = top;
    s.v.bottom = top + high;
    s.v.right  = v->width - 62 * v->u;
    s.x        = s.v.left;
    return s;
}

static void strip_axis_signals(strip *s, enum signal first)
{
    for (unsigned i = 0; i < ENGINE_AXES; i++)
        strip_signal(s, first + i, ink[i + 1], 0.9, (const char[]){ strip_times(s)[i], '\0' });
}

static void speed_strip(strip s)
{
    const engine_limits *l = &s.p->t->limits;
    double feed = 0;

    for (size_t k = 0; k < s.p->t->moves; k++)
        feed = fmax(feed, s.p->t->move[k].feed);
    strip_range(&s, fmax(peak_of(s.c, SPEED, VZ), feed), l->max_speed, false);
    strip_axes(&s, "speed, mm/s", false);
    strip_axis_signals(&s, VX);
    strip_signal(&s, SPEED, ink[0], 1.3, "along the path");
    strip_feed(&s);
    strip_limits(&s, l->max_speed);
}

static void accel_strip(strip s)
{
    strip_range(&s, peak_of(s.c, ALONG, AZ), s.p->t->limits.max_accel, true);
    strip_axes(&s, "acceleration, mm/s\302\262", false);
    strip_axis_signals(&s, AX);
    strip_signal(&s, ALONG, ink[0], 1.3, "along the path");
    strip_limits(&s, s.p->t->limits.max_accel);
}

static void jerk_strip(strip s)
{
    double limit[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        limit[i] = s.p->t->limits.max_jerk[i];
    strip_range(&s, peak_of(s.c, JX, JZ), limit, true);
    strip_axes(&s, "jerk over 16 ms, mm/s\302\263", true);
    strip_axis_signals(&s, JX);
    strip_limits(&s, limit);
    if (!(limit[0] > 0 || limit[1] > 0 || limit[2] > 0)) {
        plot_ink(&s.v, 0.1);
        plot_text(&s.v, PLOT_SMALL, s.x, s.v.top - 9 * s.v.u, 0, "not limited");
    }
}


// Picture
// -------

static void draw_title(const plot_view *v, const plan_picture *p)
{
    trace_part all = { .length = 0 };
    char words[400], limits[200], time[HOST_DURATION];

    for (size_t k = 0; k < p->t->moves; k++)
        trace_add(&all, &p->t->part[k]);
    plot_ink(v, 0.1);
    snprintf(words, sizeof words, "%.80s: %zu curve%s, %.3f m drawn, %.3f m travelled, %s",
             plot_base_name(p->name), p->path->curves, tool_s(p->path->curves),
             p->path->drawn / 1000, p->path->travelled / 1000, host_duration(time, all.seconds, 1));
    plot_text(v, PLOT_LARGE, v->left, 30 * v->u, 0, words);
    trace_words(p->t, &all, limits, sizeof limits);
    snprintf(words, sizeof words, "limited, of the time, by %s", limits);
    plot_ink(v, 0.3);
    plot_text(v, PLOT_SMALL, v->left, 54 * v->u, 0, words);
}

/* Margins are in thousandths of the width. The path is at most half as high as the picture is
 * wide. */
static void lay_out_picture(plot_view *v, const plan_picture *p)
{
    const double left = 70, right = 105, above = 74, most = 420;
    double box[2][2] = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };

    for (size_t k = 0; k < p->path->count; k++) {
        plot_join(box, p->path->move[k].p[0]);
        plot_join(box, p->path->move[k].p[3]);
    }
    double curves[2][2];
    if (drawing_box(p->d, curves)) {
        plot_join(box, curves[0]);
        plot_join(box, curves[1]);
    }
    const double air = 0.03 * fmax(fmax(box[1][0] - box[0][0], box[1][1] - box[0][1]), 1e-3);
    const double wide = box[1][0] - box[0][0] + 2 * air, high = box[1][1] - box[0][1] + 2 * air;

    v->width  = p->size;
    v->u      = v->width / 1000;
    v->scale  = fmin((1000 - left - right) / wide, most / high) * v->u;
    v->x0     = box[0][0] - air;
    v->y0     = box[0][1] - air;
    v->left   = left * v->u;
    v->right  = v->left + wide * v->scale;
    v->top    = above * v->u;
    v->bottom = v->top + high * v->scale;
    v->height = v->bottom + (62 + 3 * (150 + 40) + 16) * v->u;
}

int plan_plot(host *h, const plan_picture *p)
{
    columns *c  = memory_grow(NULL, sizeof *c);
    plot_view v = { .magnified = 0 };

    lay_out_picture(&v, p);
    cairo_surface_t *canvas = plot_begin(&v, p->output);
    cairo_set_source_rgb(v.cairo, 1, 1, 1);
    cairo_paint(v.cairo);
    cairo_select_font_face(v.cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_cap(v.cairo, CAIRO_LINE_CAP_BUTT);
    fill_columns(c, p->t);
    draw_title(&v, p);
    path_picture(&v, p);

    const double top = v.bottom + 80 * v.u, step = 190 * v.u, high = 150 * v.u;
    speed_strip(strip_begin(p, c, &v, top, high));
    accel_strip(strip_begin(p, c, &v, top + step, high));
    jerk_strip(strip_begin(p, c, &v, top + 2 * step, high));
    free(c);
    return plot_end(h, &v, canvas, p->output);
}
