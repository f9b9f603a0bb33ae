/* host-tools/svg/svg_clip.c -- cuts what is outside of a clip path, or of a viewport
 * SPDX-License-Identifier: MIT
 *
 * The library intersects each curve with the outline of the clip path. Between two crossings a
 * curve is on one side, so the middle of a piece decides about all of it, by the winding number of
 * the outline there. A piece along the outline stays: half of its stroke is seen.
 *   see  CSS Masking Level 1, 6: Clipping Paths
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "engine/engine.h"   /* engine_f64: where two pieces meet */
#include "engine/piece.h"
#include "svg/svg.h"

#define MEET_TOL 5e-5           /* mm */
#define ALONG    1e-3           /* mm: so near to the outline, a piece stays */
#define LEAST    1e-9           /* of the parameter, between two cuts */

#define MEETING  200u           /* boxes: what it takes to find where two curves meet, 4 us */
#define WORK_MAX 500000000ull   /* boxes: ten seconds */

drawing_curve svg_within(const drawing_curve *c, const svg_matrix *m)
{
    const double area = m->a * m->d - m->b * m->c;
    drawing_curve in = *c;

    for (int k = 0; k < 4; k++) {
        const double x = c->p[k][0] - m->e, y = c->p[k][1] - m->f;
        in.p[k][0] = (m->d * x - m->c * y) / area;
        in.p[k][1] = (m->a * y - m->b * x) / area;
    }
    return in;
}
typedef struct {
    double *at;
    size_t count, room;
} cuts;

static void add_cut(cuts *c, double t)
{
    if (c->count == c->room) {
        c->room = c->room ? 2 * c->room : 32;
        c->at   = memory_grow(c->at, c->room * sizeof *c->at);
    }
    c->at[c->count++] = t;
}

static int compare_cuts(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void set_piece(piece *out, const drawing_curve *c)
{
    *out = (piece){ .degree = 3 };
    for (int k = 0; k < 4; k++) {
        memcpy(out->p[k], c->p[k], sizeof c->p[k]);
        out->w[k] = 1;
    }
}

/* May they meet? Their control points bound them. */
static bool are_near(const drawing_curve *a, const drawing_curve *b)
{
    for (int i = 0; i < 2; i++) {
        double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
        for (int k = 0; k < 4; k++) {
            low[0]  = fmin(low[0], a->p[k][i]);
            high[0] = fmax(high[0], a->p[k][i]);
            low[1]  = fmin(low[1], b->p[k][i]);
            high[1] = fmax(high[1], b->p[k][i]);
        }
        if (low[0] > high[1] + ALONG || low[1] > high[0] + ALONG)
            return false;
    }
    return true;
}

static bool is_inside(const drawing *outline, const double at[2]);

/* Is it in the area number `clip` of the outline, and in those around it? */
static bool is_in_area(const drawing *outline, unsigned clip, const double at[2])
{
    for (; clip > 0; clip = outline->clip[clip - 1].up)
        if (!is_inside(&outline->clip[clip - 1].outline, at))
            return false;
    return true;
}

/* The winding number of each shape of the outline decides by its rule; one of them is enough. */
static bool is_inside(const drawing *outline, const double at[2])
{
    for (size_t first = 0, last; first < outline->count; first = last) {
        const unsigned shape = outline->curve[first].fill;
        int winding          = 0;
        for (last = first; last < outline->count && outline->curve[last].fill == shape; last++)
            winding += drawing_winding(&outline->curve[last], at);
        if ((shape & DRAWING_EVENODD ? winding & 1 : winding) &&
            is_in_area(outline, outline->curve[first].clip, at))
            return true;
    }
    return false;
}

static bool is_kept(const drawing *outline, const double at[2])
{
    static const double by[5][2] = { { 0, 0 }, { 1, 0.3 }, { -1, -0.3 }, { -0.3, 1 }, { 0.3, -1 } };

    for (int k = 0; k < 5; k++) {
        const double near[2] = { at[0] + ALONG * by[k][0], at[1] + ALONG * by[k][1] };
        if (is_inside(outline, near))
            return true;
    }
    return false;
}

/* Where a curve meets an outline, and the areas at which that is cut. */
static bool add_cuts(svg_reader *r, const drawing *outline, const drawing_curve *c, cuts *out)
{
    engine_meeting meeting[ENGINE_MEETINGS];
    piece whole, edge;

    set_piece(&whole, c);
    r->compared += outline->count + 1;
    if (r->compared > WORK_MAX)
        return svg_fail(r, "svg.clip-too-long",
                        "clipping takes too long: clip in the editor, or by simpler paths");
    for (size_t k = 0; k < outline->count; k++) {
        size_t found;
        if (!are_near(&outline->curve[k], c))
            continue;
        set_piece(&edge, &outline->curve[k]);
        r->compared += MEETING;
        const int status = engine_f64.measure->meet(&whole, &edge, MEET_TOL, meeting, &found);
        if (status != 0)
            return svg_fail(r, "svg.clip-path", "clip-path: %s", engine_status(status, NULL));
        for (size_t i = 0; i < found; i++)
            for (int j = 0; j < 3; j++)
                if (meeting[i].overlap || j == 1)
                    add_cut(out, meeting[i].s[j]);
    }
    for (size_t k = 0; k < outline->clips; k++)
        if (!add_cuts(r, &outline->clip[k].outline, c, out))
            return false;
    return true;
}

static bool find_cuts(svg_reader *r, const drawing *outline, const drawing_curve *c, cuts *out)
{
    out->count = 0;
    add_cut(out, 0);
    if (!add_cuts(r, outline, c, out))
        return false;
    add_cut(out, 1);
    qsort(out->at, out->count, sizeof *out->at, compare_cuts);
    return true;
}

/* Append the parts of a curve that are inside. *drawn: it goes on where the one before ended. */
static void keep_parts(svg_reader *r, const drawing *outline, const drawing_curve *c,
                       const cuts *at, bool fresh, bool *drawn, drawing *out)
{
    double begin = 0;
    bool in      = false;

    for (size_t k = 0; k + 1 < at->count; k++) {
        const double from = at->at[k], to = at->at[k + 1];
        double middle[2];
        if (to - from < LEAST && to < 1)
            continue;
        drawing_eval(c, (from + to) / 2, middle);
        r->compared += 5 * outline->count;
        const bool now = is_kept(outline, middle);
        if (now && !in)
            begin = from;
        if (in && !now) {
            drawing_curve one = *c;
            drawing_cut(&one, begin, from);
            drawing_add_like(out, &one, fresh || begin > 0 || !*drawn);
        }
        *drawn = now ? *drawn : false;
        in     = now;
    }
    if (in) {
        drawing_curve one = *c;
        if (begin > 0)
            drawing_cut(&one, begin, 1);
        drawing_add_like(out, &one, fresh || begin > 0 || !*drawn);
    }
    *drawn = in;
}

/* The area of an outline within another area; one for all shapes that have this one around them. */
static unsigned area_within(drawing *d, const drawing *outline, unsigned up, size_t first_clip)
{
    for (size_t k = first_clip; k < d->clips; k++)
        if (d->clip[k].up == up)
            return (unsigned)k + 1;
    return drawing_add_clip(d, outline, up);
}

/* What is itself an outline stays whole, and is told its area: cut, it would not be closed. */
static void mark_area(drawing *d, const drawing *outline, size_t first)
{
    const size_t clips = d->clips;

    for (size_t i = first; i < d->count; i++)
        d->curve[i].clip = area_within(d, outline, d->curve[i].clip, clips);
}

/* What is filled keeps its whole outline for that. */
static void keep_areas(drawing *d, const drawing *outline, size_t first, drawing *out)
{
    const size_t clips = d->clips;

    for (size_t i = first; i < d->count && d->areas; i++) {
        drawing_curve whole = d->curve[i];
        const bool fresh    = i == first || whole.path != d->curve[i - 1].path;
        if (!(whole.fill & DRAWING_FILLED))
            continue;
        whole.fill |= DRAWING_HIDDEN;
        whole.clip = area_within(d, outline, whole.clip, clips);
        drawing_add_like(out, &whole, fresh);
    }
}

/* Where a curve only touches the outline, a speck is left, which a pen would draw as a dot. */
static bool is_speck(const drawing *d, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        for (int k = 0; k < 4; k++)
            if (hypot(d->curve[i].p[k][0] - d->curve[first].p[0][0],
                      d->curve[i].p[k][1] - d->curve[first].p[0][1]) > ALONG)
                return false;
    return true;
}

/* Append the paths that are not specks. */
static void add_paths(drawing *d, const drawing *from)
{
    for (size_t first = 0, end; first < from->count; first = end) {
        for (end = first + 1; end < from->count; end++)
            if (from->curve[end].path != from->curve[first].path)
                break;
        const bool speck = is_speck(from, first, end);
        for (size_t i = first; i < end && !speck; i++)
            drawing_add_like(d, &from->curve[i], i == first);
    }
}

bool svg_cut(svg_reader *r, const drawing *outline, size_t first)
{
    drawing *d  = r->d;
    drawing out = { .count = 0 };
    cuts at     = { .at = NULL };
    bool good = true, drawn = false;

    if (r->clipping) {
        mark_area(d, outline, first);
        return true;
    }
    keep_areas(d, outline, first, &out);
    for (size_t i = first; i < d->count && good; i++) {
        const drawing_curve *c = &d->curve[i];
        const bool fresh       = i == first || c->path != c[-1].path;
        good                   = svg_goes_on(r, "clipping");
        if (c->fill & DRAWING_HIDDEN)
            continue;
        drawing_curve seen = *c;
        if (d->areas && seen.fill & DRAWING_FILLED)
            seen.fill &= ~(unsigned)DRAWING_FILLED;
        good = good && find_cuts(r, outline, c, &at);
        if (good)
            keep_parts(r, outline, &seen, &at, fresh, &drawn, &out);
    }
    if (good) {
        d->count = first;
        add_paths(d, &out);
    }
    free(at.at);
    drawing_free(&out);
    return good;
}
