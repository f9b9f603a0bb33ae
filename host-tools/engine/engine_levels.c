/* host-tools/engine/engine_levels.c -- surfaces milled level by level; compiled once per number
 * type
 * SPDX-License-Identifier: MIT
 *
 * Lines are found by rows across the area: between a clear place and a blocked one is a line,
 * unless one that was walked has crossed the row there. Rows and places are half a radius apart,
 * and none is on the border of the area.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "toolpath/waterline.h"     /* loft_waterline */

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_levels.h"

typedef struct {
    loft_waterline line;
    const loft_drop *d;
    double from[2], by;         /* the first place, and the distance of places */
    size_t across, rows;        /* places in a row; rows */
    unsigned char *crossed;     /* one for each step between two places */
    mill_cuts *out;
} levels;

static void give(levels *l, const loft_vec *p)
{
    double point[ENGINE_AXES];

    point_of(*p, point);
    mill_cuts_add(l->out, point);
}

/* A chord was walked: mark the steps where it crosses rows. It may err by the tolerance. */
static void mark(levels *l, const loft_vec *a, const loft_vec *b)
{
    const double x0 = double_of(a->axis[0]), y0 = double_of(a->axis[1]), x1 = double_of(b->axis[0]),
                 y1 = double_of(b->axis[1]), low = fmin(y0, y1) - l->from[1],
                 high = fmax(y0, y1) - l->from[1], tol = double_of(l->d->tol);

    for (double row = fmax(0, ceil((low - tol) / l->by));
         row <= floor((high + tol) / l->by) && row < (double)l->rows; row++) {
        const double y = l->from[1] + row * l->by, t = y1 == y0 ? 0 : (y - y0) / (y1 - y0),
                     x = x0 + fmax(0, fmin(1, t)) * (x1 - x0) - l->from[0];
        for (int side = -1; side <= 1; side++) {
            const double at = floor((x + side * tol) / l->by);
            if (at >= 0 && at < (double)l->across)
                l->crossed[(size_t)row * l->across + (size_t)at] = 1;
        }
    }
}

static loft_vec place_of(const levels *l, size_t row, size_t at)
{
    loft_vec p = l->line.from;

    (void)real_of(l->from[0] + (double)at * l->by, &p.axis[0]);
    (void)real_of(l->from[1] + (double)row * l->by, &p.axis[1]);
    return p;
}

/* A line that is back at the end of its first chord is a ring without that chord. One that is back
 * at the end of another keeps its beginning, which may be in a sharp inner corner. */
static void close_cut(const levels *l, mill_cut *cut)
{
    if (l->line.closed && cut->count > 3 &&
        memcmp(cut->point[1], cut->point[cut->count - 1], sizeof *cut->point) == 0) {
        memmove(cut->point, cut->point + 1, --cut->count * sizeof *cut->point);
        cut->closed = true;
    }
}

static void walk(levels *l, unsigned level)
{
    loft_vec from = l->line.from, to;
    mill_cut *const cut = mill_cuts_begin(l->out, level);

    give(l, &from);
    while (loft_waterline_next(&l->line, &to)) {
        give(l, &to);
        mark(l, &from, &to);
        from = to;
    }
    close_cut(l, cut);
}

static bool is_clear(const levels *l, const loft_vec *p)
{
    return loft_waterline_clear(&l->line, p->axis[0], p->axis[1]);
}

static void walk_row(levels *l, unsigned level, size_t row)
{
    loft_vec p = place_of(l, row, 0);
    bool clear = is_clear(l, &p);

    for (size_t at = 0; at < l->across; at++) {
        const loft_vec next = place_of(l, row, at + 1);
        const bool was = clear;
        clear = is_clear(l, &next);
        if (was != clear && !l->crossed[row * l->across + at] &&
            loft_waterline_begin(&l->line, was ? &p : &next, was ? &next : &p) == LOFT_OK)
            walk(l, level);
        p = next;
    }
}

int ENGINE_OF(engine_levels)(const loft_drop *d, const loft_box *area, double top, double step,
                             const mill_order *o, mill_cuts *out)
{
    const double lowest = double_of(d->floor), count = fmax(1, ceil((top - lowest) / step - 1e-9));
    levels l = { .d = d, .out = out };
    int status = LOFT_OK;

    l.by = double_of(d->cutter.radius) / 2;
    for (int k = 0; k < 2; k++)
        l.from[k] = double_of(area->min.axis[k]) + 0.4 * l.by;
    l.across  = (size_t)fmax(0, (double_of(area->max.axis[0]) - l.from[0]) / l.by);
    l.rows    = (size_t)fmax(0, (double_of(area->max.axis[1]) - l.from[1]) / l.by) + 1;
    l.crossed = tool_grow(NULL, l.rows * (l.across + 1));
    for (double k = 1; k <= count && status == LOFT_OK; k++) {
        loft_real z;
        memset(l.crossed, 0, l.rows * (l.across + 1));
        status = real_of(top + (lowest - top) * k / count, &z)
                     ? (int)loft_waterline_init(&l.line, d, area, z)
                     : LOFT_ERR_RANGE;
        for (size_t row = 0; row < l.rows && status == LOFT_OK; row++)
            walk_row(&l, (unsigned)k - 1, row);
        o->tell(o->context, k / count);
    }
    free(l.crossed);
    return status;
}
