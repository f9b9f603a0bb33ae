/* host-tools/svg/svg_dash.c -- cuts outlines into the dashes of stroke-dasharray
 * SPDX-License-Identifier: MIT
 *
 * Dashes are measured along the path in user units, before the transform. A curve is measured by
 * Gauss's rule on 1/PARTS of it, a line at once; the end of a dash is found by Newton's steps, and
 * by halving where these lead away. The pieces are exact pieces of the curves. What is filled too
 * keeps its whole outline for that.
 *   see  SVG 2, 13.5.6: stroke-dasharray
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "svg/svg.h"

#define DASHES_MAX 200000u      /* of a drawing: more are a tone, not dashes */
#define ROOM       256          /* numbers of a list */
#define PARTS      32
#define STEPS      60
#define CLOSE      1e-14        /* of the parameter: the last step */
#define LEAST      1e-12        /* of the parameter: less is rounding */
#define EVEN       1e-9         /* of a line: its points may be so far from the thirds */

typedef struct {
    svg_reader *r;
    double dash[2 * ROOM], sum, offset;
    size_t count;
    drawing out;
    double to_user[4];          /* of vectors */
    double dot;                 /* user units; 0: dashes without length are invisible */
    size_t which;               /* the dash that is under way, and */
    double left;                /* what is left of it */
    bool fresh;
} dashing;

static double speed_at(const dashing *g, const drawing_curve *c, double t)
{
    double v[2];

    drawing_deriv(c, t, v);
    return hypot(g->to_user[0] * v[0] + g->to_user[2] * v[1],
                 g->to_user[1] * v[0] + g->to_user[3] * v[1]);
}

/* A line that is passed evenly is one part. */
static int parts_of(const drawing_curve *c)
{
    const double size = fabs(c->p[3][0] - c->p[0][0]) + fabs(c->p[3][1] - c->p[0][1]);

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            if (fabs(c->p[k][i] - 2 * c->p[k + 1][i] + c->p[k + 2][i]) > EVEN * size)
                return PARTS;
    return 1;
}

/* From a to b, which are at most one part apart: the five-point rule. */
static double part_length(const dashing *g, const drawing_curve *c, double a, double b)
{
    static const double at[3] = { 0, 0.53846931010568309104, 0.90617984593866399280 };
    static const double weight[3] = { 0.56888888888888888889, 0.47862867049936646804,
                                      0.23692688505618908751 };
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double sum = weight[0] * speed_at(g, c, middle);

    for (int k = 1; k < 3; k++)
        sum += weight[k] *
               (speed_at(g, c, middle - half * at[k]) + speed_at(g, c, middle + half * at[k]));
    return sum * half;
}

static double whole_length(const dashing *g, const drawing_curve *c)
{
    const int parts = parts_of(c);
    double sum      = 0;

    for (int k = 0; k < parts; k++)
        sum += part_length(g, c, (double)k / parts, (double)(k + 1) / parts);
    return sum;
}

/* Where `length` is passed from `from` on, which is before `to`. */
static double end_of(const dashing *g, const drawing_curve *c, double from, double to,
                     double length, double guess)
{
    double low = from, high = to, t = guess;

    for (int i = 0; i < STEPS; i++) {
        const double off = part_length(g, c, from, t) - length, speed = speed_at(g, c, t);
        const double by = speed > 0 ? off / speed : 1;
        if (fabs(by) <= CLOSE)
            break;
        *(off <= 0 ? &low : &high) = t;
        t = t - by > low && t - by < high ? t - by : (low + high) / 2;
    }
    return t;
}

/* Where on the curve, from t on, `length` is passed; 1 if the curve ends before, and then *over is
 * what is left of the length. */
static double go_along(const dashing *g, const drawing_curve *c, double t, double length,
                       double *over)
{
    const int parts = parts_of(c);

    for (int k = (int)(t * parts); k < parts; k++) {
        const double from = fmax(t, (double)k / parts), to = (double)(k + 1) / parts;
        const double part = part_length(g, c, from, to);
        if (part <= length) {
            length -= part;
            continue;
        }
        *over = 0;
        return end_of(g, c, from, to, length, from + length / part * (to - from));
    }
    *over = length;
    return 1;
}

static void next_dash(dashing *g)
{
    const double before = g->dash[g->which];

    g->which = (g->which + 1) % g->count;
    g->left  = g->dash[g->which];
    if (g->which % 2 == 0)
        g->left = fmax(g->left, g->dot);
    else if (before < g->dot)
        g->left = fmax(g->left - (g->dot - before), 0);
    g->fresh = true;
}

/* The place in the list where each subpath begins. */
static void start_dashes(dashing *g)
{
    double at = fmod(g->offset, g->sum);

    at       = at < 0 ? at + g->sum : at;
    g->which = 0;
    while (at >= g->dash[g->which] && at + g->dash[g->which] > 0 && g->which + 1 < g->count)
        at -= g->dash[g->which++];
    g->left = g->dash[g->which] - at;
    if (g->which % 2 == 0 && !(at > 0))
        g->left = fmax(g->left, g->dot);
    g->fresh = true;
}

static void dash_curve(dashing *g, const drawing_curve *c)
{
    double t = 0;

    while (1 - t > LEAST) {
        double over;
        const double to = go_along(g, c, t, g->left, &over);
        if (g->which % 2 == 0 && to > t) {
            drawing_curve one = *c;
            drawing_cut(&one, t, to);
            drawing_add_like(&g->out, &one, g->fresh);
            g->fresh = false;
        }
        t       = to;
        g->left = over;
        if (1 - t > LEAST || !(over > 0))
            next_dash(g);
    }
}

/* Read the list. Returns false if lines stay whole. */
static bool read_dashes(dashing *g, const svg_space *space)
{
    const double diagonal = hypot(space->width, space->height) / sqrt(2);
    const double hundred  = space->width > 0 && space->height > 0 ? diagonal : 0;
    char one[40];

    if (space->dashes == NULL)
        return false;
    for (const char *at = space->dashes; *at != '\0' && g->count < ROOM;) {
        const size_t length = strcspn(at, ", \t\r\n\f");
        if (length > 0) {
            if (length >= sizeof one)
                return false;
            memcpy(one, at, length);
            one[length] = '\0';
            if (!svg_css_length(space, one, hundred, &g->dash[g->count]) ||
                !(g->dash[g->count] >= 0))
                return false;           /* as CSS says: the whole value is invalid */
            g->sum += g->dash[g->count++];
        }
        at += length + (at[length] != '\0');
    }
    if (g->count % 2 == 1) {
        memcpy(g->dash + g->count, g->dash, g->count * sizeof *g->dash);
        g->count *= 2;
        g->sum *= 2;
    }
    if (space->dash_offset != NULL)
        (void)svg_css_length(space, space->dash_offset, hundred, &g->offset);
    return g->sum > 0;
}

/* The attribute pathLength says how long the author takes the path to be. */
static void scale_dashes(dashing *g, const svg_space *space, double length)
{
    const double said = svg_length(g->r, space, "pathLength", SVG_DIAGONAL, 0);
    const double by = said > 0 ? length / said : 1;
    for (size_t i = 0; i < g->count; i++)
        g->dash[i] *= by;
    g->sum *= by;
    g->offset *= by;
}

bool svg_dash(svg_reader *r, const svg_space *space, size_t first)
{
    const svg_matrix *m = &space->to_mm;
    const double area   = m->a * m->d - m->b * m->c;
    drawing *d          = r->d;
    const size_t last   = d->count;
    dashing g           = { .r = r,
                            .to_user = { m->d / area, -m->b / area, -m->c / area, m->a / area },
                            .dot = space->cap > 0 ? SVG_DOT / svg_stretch(*m) : 0 };
    double length       = 0;

    if (!(r->fill & DRAWING_STROKED) || first == last || !read_dashes(&g, space))
        return true;
    for (size_t i = first; i < last; i++)
        length += whole_length(&g, &d->curve[i]);
    scale_dashes(&g, space, length);
    r->dashes += length / g.sum * (double)g.count;
    if (!(r->dashes <= DASHES_MAX)) {
        svg_warn(r, SVG_WARN_DASHES,
                 "more than %u dashes: whole lines are drawn from here on: make dashes longer",
                 DASHES_MAX);
        return true;
    }
    for (size_t i = first; i < last; i++) {
        if (i == first || d->curve[i].path != d->curve[i - 1].path)
            start_dashes(&g);
        dash_curve(&g, &d->curve[i]);
    }
    const bool kept = d->areas && r->fill & DRAWING_FILLED;
    for (size_t i = first; i < last && kept; i++)
        d->curve[i].fill |= DRAWING_HIDDEN;
    d->count = kept ? last : first;
    for (size_t i = 0; i < g.out.count; i++) {
        drawing_curve *c = &g.out.curve[i];
        if (kept)
            c->fill = (c->fill / DRAWING_SHAPE + 1) * DRAWING_SHAPE + DRAWING_STROKED;
        drawing_add_like(d, c, i == 0 || c->path != c[-1].path);
    }
    if (kept)
        r->fill += DRAWING_SHAPE;
    drawing_free(&g.out);
    return true;
}
