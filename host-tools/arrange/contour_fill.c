/* host-tools/arrange/contour_fill.c -- fills an area with lines parallel to its outline
 * SPDX-License-Identifier: MIT
 *
 * An area is made smaller by one distance after the other, until nothing is left. Each outline is
 * followed by the nearest one of the next size, and begins where that is nearest; an outline that
 * has several inside is followed by one of them, and the others begin anew. A spiral moves each
 * point of an outline towards the next one, by the part of the way round that lies behind it.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/source.h"        /* source_name */
#include "base/host.h"
#include "base/memory.h"
#include "arrange/contour_fill.h"
#include "arrange/region.h"

#define REACH 3.0               /* distances: the next outline is nearer than this, everywhere */
#define NONE  SIZE_MAX         /* no outline */
#define TOLD  16                /* sizes from one word of progress to the next */
#define LEAST 0.001             /* mm: shorter lines are left out */

typedef struct {
    host *host;
    const contour_options *o;
    const drawing_curve *like;
    drawing *to;
    const char *file;
    bool fresh;                 /* the next line begins a path */
    double at[2];
} drawer;

/* The boxes of the lines of an outline, and of pairs of them, and of pairs of those: number 1 is
 * around all, 2 k and 2 k + 1 are in number k, and those of lines come last. */
typedef struct {
    double (*box)[2][2];
    size_t leaves;
} tree;

/* The outlines of one size, and which of them are drawn; their trees, if they were needed. */
typedef struct {
    region_rings rings;
    bool *drawn;
    tree *trees;
} layer;

static double apart(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static void join_boxes(double to[2][2], const double a[2][2], const double b[2][2])
{
    for (int i = 0; i < 2; i++) {
        to[0][i] = fmin(a[0][i], b[0][i]);
        to[1][i] = fmax(a[1][i], b[1][i]);
    }
}

static void plant(tree *t, const region_ring *r)
{
    for (t->leaves = 1; t->leaves < r->count;)
        t->leaves *= 2;
    t->box = memory_grow(NULL, 2 * t->leaves * sizeof *t->box);
    for (size_t i = 0; i < t->leaves; i++) {
        const size_t k = i < r->count ? i : 0;
        const double *a = r->point[k], *b = r->point[(k + 1) % r->count];
        const double ends[2][2][2] = { { { a[0], a[1] }, { a[0], a[1] } },
                                       { { b[0], b[1] }, { b[0], b[1] } } };
        join_boxes(t->box[t->leaves + i], ends[0], ends[1]);
    }
    for (size_t k = t->leaves - 1; k > 0; k--)
        join_boxes(t->box[k], (const double(*)[2])t->box[2 * k],
                   (const double(*)[2])t->box[2 * k + 1]);
}

static double away_from(const double (*box)[2], const double at[2])
{
    const double x = fmax(fmax(box[0][0] - at[0], at[0] - box[1][0]), 0),
                 y = fmax(fmax(box[0][1] - at[1], at[1] - box[1][1]), 0);

    return hypot(x, y);
}

/* The nearest point of a line of an outline. Returns the distance. */
static double nearest_on_line(const region_ring *r, size_t i, const double at[2], double out[2])
{
    const double *a = r->point[i], *b = r->point[(i + 1) % r->count],
                 by[2] = { b[0] - a[0], b[1] - a[1] }, square = by[0] * by[0] + by[1] * by[1];
    const double along = (at[0] - a[0]) * by[0] + (at[1] - a[1]) * by[1],
                 t     = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;

    out[0] = a[0] + t * by[0];
    out[1] = a[1] + t * by[1];
    return apart(out, at);
}

/* The nearest point of an outline, and the corner before it, the first of equal ones. Returns the
 * distance. */
static double nearest_on(layer *of, size_t which, const double at[2], double out[2], size_t *corner)
{
    const region_ring *r = &of->rings.ring[which];
    tree *t              = &of->trees[which];
    size_t stack[2 * 64], n = 0;
    double least = HUGE_VAL, p[2];

    if (t->box == NULL)
        plant(t, r);
    stack[n++] = 1;
    while (n > 0) {
        const size_t k = stack[--n];
        if (away_from((const double(*)[2])t->box[k], at) > least * (1 + 1e-12))
            continue;
        if (k < t->leaves) {
            const size_t near = 2 * k + (away_from((const double(*)[2])t->box[2 * k + 1], at) <
                                         away_from((const double(*)[2])t->box[2 * k], at));
            stack[n++] = near ^ 1;
            stack[n++] = near;
            continue;
        }
        const size_t i = k - t->leaves;
        const double way = i < r->count ? nearest_on_line(r, i, at, p) : HUGE_VAL;
        if (way < least || (way <= least && i < *corner)) {
            least = way;
            memcpy(out, p, sizeof p);
            *corner = i;
        }
    }
    return least;
}

static void begin_at(drawer *w, const double at[2])
{
    w->fresh = true;
    memcpy(w->at, at, sizeof w->at);
}

static int line_to(drawer *w, const double to[2])
{
    drawing_curve c = *w->like;

    if (apart(w->at, to) < LEAST)
        return 0;
    if (w->to->count >= DRAWING_CURVES_MAX)
        return host_error(w->host, EX_DATAERR, "fill.too-many-curves",
                          (host_place){ source_name(w->file), w->like->line },
                          "give lines further apart", "--fill: more than %u curves",
                          DRAWING_CURVES_MAX);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            c.p[k][i] = k == 3 ? to[i] : w->at[i] + (to[i] - w->at[i]) * k / 3;
    drawing_add_like(w->to, &c, w->fresh);
    w->fresh = false;
    memcpy(w->at, to, sizeof w->at);
    return 0;
}

/* Once round from `from`, which lies behind `corner`. With a next outline the way bends towards it;
 * it then ends there, and `from` is that place. */
static int draw_ring(drawer *w, const region_ring *r, double from[2], size_t corner, layer *inner,
                     size_t next)
{
    double all = 0, way = 0, before[2], end[2];
    size_t any;
    int code = 0;

    memcpy(before, from, sizeof before);
    for (size_t i = 0; i < r->count; i++)
        all += apart(r->point[i], r->point[(i + 1) % r->count]);
    for (size_t k = 1; k <= r->count + 1 && code == 0; k++) {
        const double *p = k <= r->count ? r->point[(corner + k) % r->count] : from;
        double to[2]    = { p[0], p[1] };
        way += apart(before, p);
        memcpy(before, p, sizeof before);
        if (next != NONE) {
            (void)nearest_on(inner, next, p, end, &any);
            const double part = k <= r->count ? fmin(way / all, 1) : 1;
            to[0] += part * (end[0] - p[0]);
            to[1] += part * (end[1] - p[1]);
        }
        code = line_to(w, to);
    }
    memcpy(from, w->at, sizeof w->at);
    return code;
}

/* The outline of the next size that follows this one, or NONE. */
static size_t follower(const contour_options *o, layer *now, size_t which, layer *next)
{
    const region_ring *r = &now->rings.ring[which];

    for (size_t i = 0; i < next->rings.count; i++) {
        const region_ring *other = &next->rings.ring[i];
        double most = 0, at[2];
        size_t corner;
        if (next->drawn[i] || other->hole != r->hole)
            continue;
        for (size_t k = 0; k < other->count && most <= REACH * o->distance; k++)
            most = fmax(most, nearest_on(now, which, other->point[k], at, &corner));
        for (size_t k = 0; k < r->count && o->spiral && most <= REACH * o->distance; k++)
            most = fmax(most, nearest_on(next, i, r->point[k], at, &corner));
        if (most <= REACH * o->distance) {
            next->drawn[i] = true;
            return i;
        }
    }
    return NONE;
}

/* Draw outline number i of a size, and what follows it inwards. */
static int draw_chain(drawer *w, layer all[], size_t layers, size_t k, size_t i)
{
    double from[2];
    size_t corner = 0;
    int code      = 0;
    bool first    = true;

    begin_at(w, all[k].rings.ring[i].point[0]);
    memcpy(from, w->at, sizeof from);
    while (i != NONE && code == 0) {
        const region_ring *r = &all[k].rings.ring[i];
        layer *inner         = &all[k + 1];
        const size_t next    = k + 1 < layers ? follower(w->o, &all[k], i, inner) : NONE;
        if (w->o->spiral && first)                  /* the outermost is drawn whole */
            code = draw_ring(w, r, from, corner, NULL, NONE);
        if (code == 0 && (!w->o->spiral || next != NONE || !first))
            code = draw_ring(w, r, from, corner, inner, w->o->spiral ? next : NONE);
        if (next != NONE) {
            (void)nearest_on(inner, next, w->at, from, &corner);
            if (!w->o->spiral)
                begin_at(w, from);
        }
        first = false;
        i     = next;
        k++;
    }
    return code;
}

static void *zeroed(size_t bytes) { return memset(memory_grow(NULL, bytes), 0, bytes); }

/* How many sizes there are at most: half of the smaller side of the box holds them. */
static double sizes_at_most(const region_rings *outer, double distance)
{
    double box[2][2] = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };

    for (size_t i = 0; i < outer->count; i++)
        for (size_t k = 0; k < outer->ring[i].count; k++) {
            const double *p = outer->ring[i].point[k];
            const double at[2][2] = { { p[0], p[1] }, { p[0], p[1] } };
            join_boxes(box, (const double(*)[2])box, at);
        }
    return fmin(box[1][0] - box[0][0], box[1][1] - box[0][1]) / 2 / distance;
}

static int shrink_all(host *h, const contour_options *o, region *area, layer **all, size_t *layers,
                      const char *file)
{
    for (double by = o->distance / 2;; by = o->distance) {
        layer one;
        if (*layers % TOLD == TOLD - 1) {
            const double most = sizes_at_most(&(*all)[0].rings, o->distance);
            const host_progress p = { "filling", (double)*layers, fmax(most, (double)*layers),
                                      true };
            if (!host_goes_on(h, &p))
                return EX_TEMPFAIL;
        }
        if (!region_shrink(h, area, by, file))
            return region_error();
        region_outlines(area, &one.rings);
        if (one.rings.count == 0)
            return 0;
        one.drawn       = zeroed(one.rings.count);
        one.trees       = zeroed(one.rings.count * sizeof *one.trees);
        *all             = memory_grow(*all, (*layers + 1) * sizeof **all);
        (*all)[*layers] = one;
        ++*layers;
    }
}

int contour_fill(host *h, const contour_options *o, const drawing *d, size_t first, size_t last,
                 const drawing_curve *like, drawing *to, const char *file)
{
    drawer w       = { .host = h, .o = o, .like = like, .to = to, .file = file };
    layer *all     = NULL;
    size_t layers  = 0;
    region *area   = region_inside(h, d, first, last, d->curve[first].fill & DRAWING_EVENODD, file);
    int code       = area ? shrink_all(h, o, area, &all, &layers, file) : region_error();

    region_free(area);
    for (size_t k = 0; k < layers; k++)
        for (size_t i = 0; i < all[k].rings.count && code == 0; i++)
            if (!all[k].drawn[i]) {
                all[k].drawn[i] = true;
                code = draw_chain(&w, all, layers, k, i);
            }
    for (size_t k = 0; k < layers; k++) {
        for (size_t i = 0; i < all[k].rings.count; i++)
            free(all[k].trees[i].box);
        region_rings_free(&all[k].rings);
        free(all[k].trees);
        free(all[k].drawn);
    }
    free(all);
    return code;
}
