/* host-tools/arrange/fill.c -- the parts of parallel lines that are inside a shape
 * SPDX-License-Identifier: MIT
 *
 * The shape is turned until the lines are level. The sum of the directions of all crossings to the
 * left is the winding number.
 *   see  Foley, van Dam, Feiner, Hughes: Computer Graphics, 3.6
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"
#include "base/scan.h"          /* scan_number */
#include "base/source.h"        /* source_name */
#include "arrange/contour_fill.h"       /* contour_fill */
#include "arrange/fill.h"

#define DEGREE 0.017453292519943295769

/* What may follow `contour`: ":0.8", ":0.8,spiral", ",spiral" or nothing. */
static bool parse_contour(const char *at, fill_options *set)
{
    if (*at == ':') {
        at++;
        if (!scan_number(&at, &set->distance))
            return false;
    }
    set->spiral = strcmp(at, ",spiral") == 0;
    return set->spiral || *at == '\0';
}

static bool parse_fill(const char *text, void *out)
{
    fill_options *f  = out;
    const char *at   = text + strcspn(text, ":");
    fill_options set = { .degrees = 45, .distance = 1, .outline = f->outline };
    bool good        = true;

    set.cross   = strncmp(text, "cross", 5) == 0 && at == text + 5;
    set.contour = strncmp(text, "contour", 7) == 0;
    if (strcmp(text, "none") == 0)
        set.distance = 0;
    else if (set.contour)
        good = parse_contour(text + 7, &set);
    else
        good = set.cross || (strncmp(text, "hatch", 5) == 0 && at == text + 5);
    if (good && !set.contour && *at == ':') {
        at++;
        good = scan_number(&at, &set.degrees) && *at++ == ',' && scan_number(&at, &set.distance) &&
               *at == '\0' && fabs(set.degrees) <= 360;
    }
    good = good && (strcmp(text, "none") == 0 || (set.distance >= 0.02 && set.distance <= 1000));
    if (good)
        *f = set;
    return good;
}

const option fill_rows[] = {
    { "fill", OPTION_IS_PARSED, 0, .value = "HOW", .parse = parse_fill,
      .remedy = "give hatch:ANGLE,MM or cross:ANGLE,MM, the angle within +-360, contour:MM or "
                "contour:MM,spiral, lines 0.02 to 1000 mm apart, as hatch:45,0.8; or none",
      .help = "of SVG: painted shapes, by lines: hatch:ANGLE,MM, cross:ANGLE,MM, contour:MM or "
              "contour:MM,spiral (none)" },
    { "outline", OPTION_TEXT(fill_options, outline), .value = "WHICH", .choices = "all|stroke|none",
      .help = "with --fill: all, stroke (of shapes with a stroke) or none (all)" },
    { 0 }
};

typedef struct {
    double level, x;            /* which line, and where on it */
    int turn;                   /* 1: the outline rises there, -1: it falls */
} crossing;

typedef struct {
    host *host;
    const fill_options *f;
    double c, s;                /* of the turn */
    crossing *all;
    size_t count, room;
    drawing *to;
    const char *file;
    const drawing_curve *of;    /* the first one of the shape */
} filling;


// Crossings
// ---------

static double value_at(const double p[4], double t)
{
    const double s = 1 - t;

    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

static void add_crossing(filling *g, double level, double x, int turn)
{
    if (g->count == g->room) {
        g->room = g->room ? 2 * g->room : 256;
        g->all  = memory_grow(g->all, g->room * sizeof *g->all);
    }
    g->all[g->count++] = (crossing){ level, x, turn };
}

static void cross_curve(filling *g, const double p[4][2])
{
    const double step = g->f->distance;
    double x[4], y[4], low = HUGE_VAL, high = -HUGE_VAL;

    for (int k = 0; k < 4; k++) {
        x[k] = g->c * p[k][0] + g->s * p[k][1];
        y[k] = g->c * p[k][1] - g->s * p[k][0];
        low  = fmin(low, y[k]);
        high = fmax(high, y[k]);
    }
    for (double level = ceil(low / step - 0.5); (level + 0.5) * step < high; level++) {
        double t[3];
        int turn[3];
        const int count = drawing_crossings(y, (level + 0.5) * step, t, turn);
        for (int k = 0; k < count; k++)
            add_crossing(g, level, value_at(x, t[k]), turn[k]);
    }
}

static void set_line(double p[4][2], const double from[2], const double to[2])
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            p[k][i] = k == 3 ? to[i] : from[i] + (to[i] - from[i]) * k / 3;
}


// Lines
// -----

static int compare_crossings(const void *a, const void *b)
{
    const crossing *x = a, *y = b;

    if (x->level < y->level || x->level > y->level)
        return x->level > y->level ? 1 : -1;
    return (x->x > y->x) - (x->x < y->x);
}

/* Draw a line from x0 to x1, every second one back. */
static int draw_line(filling *g, double level, double x0, double x1, unsigned fill)
{
    const double y    = (level + 0.5) * g->f->distance;
    const bool back   = fmod(level, 2) != 0;
    const double at[] = { back ? x1 : x0, back ? x0 : x1 };
    double ends[2][2], p[4][2];

    if (x1 - x0 < FILL_LEAST)
        return 0;
    if (g->to->count >= DRAWING_CURVES_MAX)
        return host_error(g->host, EX_DATAERR, "fill.too-many-curves",
                          (host_place){ g->file, g->of->line }, "give lines further apart",
                          "--fill: more than %u curves", DRAWING_CURVES_MAX);
    for (int k = 0; k < 2; k++) {
        ends[k][0] = g->c * at[k] - g->s * y;
        ends[k][1] = g->s * at[k] + g->c * y;
    }
    set_line(p, ends[0], ends[1]);
    drawing_add(g->to, p, true, g->of->line);
    g->to->curve[g->to->count - 1].fill = fill & ~(DRAWING_FILLED | DRAWING_HIDDEN);
    g->to->curve[g->to->count - 1].tool  = g->of->tool;
    g->to->curve[g->to->count - 1].layer = g->of->layer;
    return 0;
}

static int draw_lines(filling *g, bool evenodd, unsigned fill)
{
    int winding = 0, code = 0;

    if (g->count > 0)
        qsort(g->all, g->count, sizeof *g->all, compare_crossings);
    for (size_t i = 0; i + 1 < g->count && code == 0; i++) {
        const crossing *a = &g->all[i];
        winding = i > 0 && a[-1].level == a->level ? winding + a->turn : a->turn;
        size_t next = i + 1;
        if (a[1].level != a->level || !(evenodd ? winding & 1 : winding))
            continue;
        /* inside until the next crossing that leads out */
        int inner = winding;
        while (next < g->count && g->all[next].level == a->level) {
            inner += g->all[next].turn;
            if (!(evenodd ? inner & 1 : inner))
                break;
            next++;
        }
        if (next == g->count || g->all[next].level != a->level)
            next--;             /* of what does not close, nothing is drawn */
        else
            code = draw_line(g, a->level, a->x, g->all[next].x, fill);
        winding = inner;
        i       = next;
    }
    return code;
}

/* The lines of the shape of curves first .. last - 1, in one direction. */
static int hatch_shape(filling *g, const drawing *d, size_t first, size_t last, double degrees)
{
    const double quarter = degrees / 90;
    const bool exact     = quarter == floor(quarter);
    static const double sine[4] = { 0, 1, 0, -1 };
    const int q = exact ? (int)(quarter - 4 * floor(quarter / 4)) : 0;

    g->c     = exact ? sine[(q + 1) % 4] : cos(degrees * DEGREE);
    g->s     = exact ? sine[q] : sin(degrees * DEGREE);
    g->count = 0;
    g->of    = &d->curve[first];
    for (size_t i = first, begin = first; i < last; i++) {
        const drawing_curve *c = &d->curve[i];
        cross_curve(g, c->p);
        if (i + 1 == last || c[1].path != c->path) {
            double back[4][2];
            set_line(back, c->p[3], d->curve[begin].p[0]);
            cross_curve(g, (const double (*)[2])back);
            begin = i + 1;
        }
    }
    return draw_lines(g, d->curve[first].fill & DRAWING_EVENODD, d->curve[first].fill);
}

static int draw_contours(filling *g, const drawing *d, size_t first, size_t last)
{
    const contour_options o = { .distance = g->f->distance, .spiral = g->f->spiral };
    const drawing_curve *of = &d->curve[first];
    const drawing_curve like = { .line  = of->line,
                                 .tool  = of->tool,
                                 .layer = of->layer,
                                 .fill  = of->fill & ~(DRAWING_FILLED | DRAWING_HIDDEN) };

    return contour_fill(g->host, &o, d, first, last, &like, g->to, g->file);
}

static bool outline_stays(const fill_options *f, const drawing_curve *c)
{
    if (c->fill & DRAWING_HIDDEN)
        return false;
    if (f->outline == NULL || strcmp(f->outline, "all") == 0 || !(c->fill & DRAWING_FILLED))
        return true;
    return strcmp(f->outline, "stroke") == 0 && c->fill & DRAWING_STROKED;
}

static int check_fill(host *h, const drawing *d, const char *file)
{
    for (size_t i = 0; i < d->count; i++)
        if (d->curve[i].fill & DRAWING_FILLED)
            return 0;
    return host_error(h, EX_DATAERR, "fill.nothing", (host_place){ source_name(file), 0 },
                      "leave --fill out, or fill shapes of an SVG",
                      "--fill: nothing in it is filled");
}

int fill_apply(host *h, const fill_options *f, drawing *d, const char *file)
{
    drawing filled = { .width = d->width, .height = d->height };
    filling g      = { .host = h, .f = f, .to = &filled, .file = source_name(file) };
    int code       = f->distance > 0 ? check_fill(h, d, file) : 0;

    if (!(f->distance > 0) || code != 0)
        return code;
    for (size_t first = 0, last; first < d->count && code == 0; first = last) {
        const unsigned shape  = d->curve[first].fill;
        const host_progress p = { "filling", (double)first, (double)d->count, true };
        if (!host_goes_on(h, &p))
            code = EX_TEMPFAIL;
        for (last = first; last < d->count && d->curve[last].fill == shape; last++)
            if (outline_stays(f, &d->curve[last]))
                drawing_add_like(&filled, &d->curve[last],
                                 last == first || d->curve[last].path != d->curve[last - 1].path);
        if (!(shape & DRAWING_FILLED) || code != 0)
            continue;
        code = f->contour ? draw_contours(&g, d, first, last)
                          : hatch_shape(&g, d, first, last, f->degrees);
        if (code == 0 && f->cross)
            code = hatch_shape(&g, d, first, last, f->degrees + 90);
    }
    host_has_done(h);
    free(g.all);
    drawing_free(d);
    *d = filled;
    return code;
}
