/* host-tools/fit/smooth.c
 * SPDX-License-Identifier: MIT
 *
 * A chain is sampled at its vertices and on long lines. A cubic B-spline over the length along the
 * chain is fitted (spline_fit.h). Where a vertex proves to be a corner the chain is cut, and both
 * parts are tried.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "fit/smooth.h"
#include "fit/spline_fit.h"
#include "base/space.h"          /* space_distance */
#include "base/tool.h"           /* tool_grow */

#define STRAIGHT    1e-6    /* mm: control points this close to the thirds of a line */
#define TURN        0.86    /* the smallest cosine between lines that may be one curve */
#define LEAST       4       /* lines, at least, to fit a curve */
#define APART       0.25    /* mm: between samples on a long line; at most MANY of them */
#define MANY        200
#define CHAIN       4096    /* lines; longer chains are cut, so that memory is bounded */

/* Samples of a chain, and the spline through them. */
typedef struct fit {
    spline_fit s;
    size_t *vertex;         /* of each sample: the line that starts there, or that it lies on */
    size_t room;
} fit;


// Chains
// ------

static void place_of(const drawing_curve *c, int k, double out[3])
{
    out[0] = c->p[k][0];
    out[1] = c->p[k][1];
    out[2] = c->z[k];
}

static bool is_line(const drawing_curve *c)
{
    double p[4][3];

    for (int k = 0; k < 4; k++)
        place_of(c, k, p[k]);
    for (int i = 0; i < 3; i++) {
        const double a = p[0][i], b = p[3][i];
        if (fabs(p[1][i] - (2 * a + b) / 3) > STRAIGHT ||
            fabs(p[2][i] - (a + 2 * b) / 3) > STRAIGHT)
            return false;
    }
    /* travels of a program stay as they are, and so does its way from where the machine stands */
    return c->feed >= 0 && c->loose[0] == c->loose[1];
}

/* Can the vertex between two lines lie on a curve? It must turn little, and not rise high above the
 * line between its neighbours. */
static bool vertex_is_smooth(const drawing_curve *a, const drawing_curve *b, double within)
{
    double p[3], q[3], r[3], by[2][3], cross[3], along = 0;

    place_of(a, 0, p);
    place_of(a, 3, q);
    place_of(b, 3, r);
    for (int i = 0; i < 3; i++) {
        by[0][i] = q[i] - p[i];
        by[1][i] = r[i] - q[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        cross[i] = by[0][j] * by[1][k] - by[0][k] * by[1][j];
        along += by[0][i] * by[1][i];
    }
    const double length = space_distance(p, q) * space_distance(q, r),
                 across = hypot(hypot(cross[0], cross[1]), cross[2]);
    const bool alike = a->tool == b->tool && a->loose[1] == b->loose[0] && !(a->feed < b->feed) &&
                       !(a->feed > b->feed);
    return alike && length > 0 && along > TURN * length &&
           across <= 4 * within * space_distance(p, r);
}

static void add_sample(fit *f, const double p[3], size_t vertex)
{
    if (f->s.count == f->room) {
        f->room   = f->room ? 2 * f->room : 1024;
        f->vertex = tool_grow(f->vertex, f->room * sizeof *f->vertex);
    }
    f->vertex[f->s.count] = vertex;
    spline_fit_add(&f->s, p);
}

/* Sample lines from..to-1 of `d`. */
static void sample_lines(fit *f, const drawing *d, size_t from, size_t to)
{
    double a[3], b[3] = { 0 };

    spline_fit_begin(&f->s);
    for (size_t i = from; i < to; i++) {
        place_of(&d->curve[i], 0, a);
        place_of(&d->curve[i], 3, b);
        const int pieces = (int)fmin(fmax(ceil(space_distance(a, b) / APART), 1), MANY);
        for (int j = 0; j < pieces; j++) {
            const double part = (double)j / pieces;
            const double at[3] = { a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]),
                                   a[2] + part * (b[2] - a[2]) };
            add_sample(f, at, i);
        }
    }
    add_sample(f, b, to);
}

/* Returns `to`, or the line before which the chain must be cut. */
static size_t fit_lines(fit *f, const drawing *d, size_t from, size_t to, double within)
{
    size_t where;

    sample_lines(f, d, from, to);
    if (spline_fit_within(&f->s, within, &where))
        return to;
    const size_t at = f->vertex[where] +
                      (where + 1 < f->s.count && f->vertex[where + 1] != f->vertex[where]);
    return at <= from ? from + 1 : at >= to ? to - 1 : at;
}

static void give_spline(drawing *to, const spline_fit *f, bool fresh, const drawing_curve *like)
{
    double p[4][3], slope[2][3];

    memcpy(p[3], f->p[0], sizeof p[3]);
    for (size_t k = 0; k < f->intervals; k++) {
        const double third = (f->knot[k + 1] - f->knot[k]) / 3;
        memcpy(p[0], p[3], sizeof p[0]);
        spline_fit_eval(f, k, f->knot[k], p[1], slope[0]);
        spline_fit_eval(f, k, f->knot[k + 1], p[3], slope[1]);
        for (int i = 0; i < 3; i++) {
            p[1][i] = p[0][i] + third * slope[0][i];
            p[2][i] = p[3][i] - third * slope[1][i];
        }
        if (k + 1 == f->intervals)
            memcpy(p[3], f->p[f->count - 1], sizeof p[3]);
        drawing_add_space(to, p, like->feed, fresh && k == 0, like->line);
        memcpy(to->curve[to->count - 1].loose, like->loose, sizeof like->loose);
        to->curve[to->count - 1].tool = like->tool;
    }
}

static void copy_curve(drawing *to, const drawing *from, size_t i)
{
    double p[4][3];

    for (int k = 0; k < 4; k++)
        place_of(&from->curve[i], k, p[k]);
    drawing_add_space(to, p, from->curve[i].feed,
                      i == 0 || from->curve[i].path != from->curve[i - 1].path,
                      from->curve[i].line);
    memcpy(to->curve[to->count - 1].loose, from->curve[i].loose, sizeof from->curve[i].loose);
    to->curve[to->count - 1].tool = from->curve[i].tool;
}

/* Replace the chain from..to-1 by as few curves as are found. Returns how many lines were
 * replaced. */
static size_t smooth_chain(drawing *to, const drawing *d, fit *f, size_t from, size_t end,
                           double within)
{
    size_t replaced = 0, stop = end;

    while (from < end) {
        if (stop - from < LEAST) {
            while (from < stop)
                copy_curve(to, d, from++);
            stop = end;
            continue;
        }
        const size_t cut = fit_lines(f, d, from, stop, within);
        if (cut < stop) {
            stop = cut;
            continue;
        }
        give_spline(to, &f->s, from == 0 || d->curve[from].path != d->curve[from - 1].path,
                    &d->curve[from]);
        replaced += stop - from;
        from = stop;
        stop = end;
    }
    return replaced;
}

/* The end of the chain that begins at i; `open`: it may go on beyond the drawing. */
static size_t chain_end(const drawing *d, size_t i, double within, bool *open)
{
    size_t end = i + 1;

    *open = false;
    if (!(within > 0) || !is_line(&d->curve[i]))
        return end;
    while (end < d->count && end - i < CHAIN && is_line(&d->curve[end]) &&
           d->curve[end].path == d->curve[end - 1].path &&
           vertex_is_smooth(&d->curve[end - 1], &d->curve[end], within))
        end++;
    *open = end == d->count && end - i < CHAIN;
    return end;
}


// Rows of a raster
// ----------------

/* The way from the start of line i to that of line `end`, or the end of the last one. */
typedef struct {
    double from[3], unit[3], length;
} row_line;

static row_line line_of(const drawing *d, size_t i, size_t end)
{
    row_line l;
    double to[3];

    place_of(&d->curve[i], 0, l.from);
    place_of(&d->curve[end - 1], 3, to);
    l.length = space_distance(l.from, to);
    for (int k = 0; k < 3; k++)
        l.unit[k] = l.length > 0 ? (to[k] - l.from[k]) / l.length : 0;
    return l;
}

/* How far along the line a place is, and how far from it. */
static double along_line(const row_line *l, const double at[3], double *off)
{
    double along = 0, square = 0;

    for (int k = 0; k < 3; k++)
        along += (at[k] - l->from[k]) * l->unit[k];
    for (int k = 0; k < 3; k++) {
        const double by = at[k] - l->from[k] - along * l->unit[k];
        square += by * by;
    }
    *off = sqrt(square);
    return along;
}

/* The line before whose start the row i .. end - 1 must be cut; `end`: it is straight, and goes on
 * along it. */
static size_t bent_at(const drawing *d, size_t i, size_t end, double within)
{
    const row_line l = line_of(d, i, end);
    double worst = within, before = 0;
    size_t where = end;

    for (size_t j = i + 1; j < end; j++) {
        double at[3], off;
        place_of(&d->curve[j], 0, at);
        const double along = along_line(&l, at, &off);
        if (off > worst || along <= before) {
            worst = along <= before ? HUGE_VAL : off;
            where = j;
        }
        before = along;
    }
    return where;
}

/* Does only the level change before line `end`? *k: the first event there or later. */
static bool only_levels(const smoothing *s, const drawing *d, size_t end, size_t *k)
{
    for (; *k < d->events && d->event[*k].before == d->taken + end; ++*k)
        if (d->event[*k].doing != DRAWING_SPINS || d->event[*k].way != s->way)
            return false;
    return true;
}

static bool lines_meet(const drawing_curve *a, const drawing_curve *b)
{
    double p[3], q[3];

    place_of(a, 3, p);
    place_of(b, 0, q);
    return space_distance(p, q) < STRAIGHT;
}

/* The end of the straight row that begins at i, if the level changes in it; i: it does not. The
 * events before i are copied. */
static size_t row_end(const smoothing *s, const drawing *d, size_t i, bool *open)
{
    const double within = fmax(s->within, STRAIGHT);
    size_t end = i + 1, k = s->events;

    *open = false;
    if (!s->laser || s->way == 0 || !is_line(&d->curve[i]))
        return i;
    while (end < d->count && end - i < CHAIN && is_line(&d->curve[end]) &&
           lines_meet(&d->curve[end - 1], &d->curve[end]) &&
           vertex_is_smooth(&d->curve[end - 1], &d->curve[end], within) &&
           only_levels(s, d, end, &k))
        end++;
    *open = end == d->count && end - i < CHAIN;
    for (size_t cut = 0; cut != end;) {
        cut = end;
        end = bent_at(d, i, end, within);
    }
    return s->events < d->events && d->event[s->events].before < d->taken + end ? end : i;
}

static void give_row(smoothing *s, drawing *to, const drawing *from, size_t i, size_t end)
{
    const row_line l = line_of(from, i, end);
    double p[4][3], at[3], off;

    for (; s->events < from->events && from->event[s->events].before < from->taken + end;
         s->events++) {
        place_of(&from->curve[from->event[s->events].before - from->taken], 0, at);
        drawing_add_event(to, &from->event[s->events]);
        to->event[to->events - 1].along = along_line(&l, at, &off);
    }
    copy_curve(to, from, i);
    drawing_curve *c = &to->curve[to->count - 1];
    place_of(&from->curve[i], 0, p[0]);
    place_of(&from->curve[end - 1], 3, p[3]);
    for (int n = 0; n < 3; n++) {
        p[1][n] = p[0][n] + (p[3][n] - p[0][n]) / 3;
        p[2][n] = p[3][n] - (p[3][n] - p[0][n]) / 3;
    }
    for (int k = 0; k < 4; k++) {
        c->p[k][0] = p[k][0];
        c->p[k][1] = p[k][1];
        c->z[k]    = p[k][2];
    }
    s->replaced += end - i;
}


// All of it
// ---------

/* Copy the events that come before curve i: chains do not lead past one. */
static void copy_events(smoothing *s, drawing *to, const drawing *from, size_t i)
{
    for (; s->events < from->events && from->event[s->events].before <= from->taken + i;
         s->events++) {
        if (from->event[s->events].doing == DRAWING_SPINS)
            s->way = from->event[s->events].way;
        drawing_add_event(to, &from->event[s->events]);
    }
}

void smooth_more(smoothing *s, drawing *to, drawing *from, bool last)
{
    size_t i = s->given;
    bool open;

    if (s->fit == NULL)
        *(s->fit = tool_grow(NULL, sizeof *s->fit)) =
            (fit){ .s = { .e = &engine_f64, .degree = 3, .between = true, .by_length = true } };
    for (size_t end; i < from->count; i = end) {
        copy_events(s, to, from, i);
        end = row_end(s, from, i, &open);
        const bool row = end > i;
        if (!row && (!open || last))
            end = chain_end(from, i, s->within, &open);
        if (open && !last)
            break;
        if (row)
            give_row(s, to, from, i, end);
        else
            s->replaced += smooth_chain(to, from, s->fit, i, end, s->within);
    }
    if (last)
        copy_events(s, to, from, from->count);
    s->given = i;
}

void smooth_end(smoothing *s)
{
    fit *f = s->fit;

    if (f == NULL)
        return;
    spline_fit_free(&f->s);
    free(f->vertex);
    free(f);
    s->fit = NULL;
}

size_t drawing_smooth(drawing *to, drawing *from, double within)
{
    smoothing s = { .within = within };

    drawing_like(to, from);
    smooth_more(&s, to, from, true);
    smooth_end(&s);
    return s.replaced;
}
