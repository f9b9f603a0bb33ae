/* host-tools/engine/engine_pencils.c -- the valleys of surfaces; compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * The ball is looked at over a grid, half a radius apart. Between two neighbours where it touches
 * places that are apart, a valley is looked for, unless one that is known passes there.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "toolpath/pencil.h"        /* loft_pencil */
#include "toolpath/raster.h"        /* loft_pass */

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_pencils.h"

typedef struct {
    loft_pencil line;
    const loft_drop *d;         /* finer: chords are within the tolerance of what it finds */
    double by;                  /* the distance of places */
    loft_vec *point;            /* of one valley */
    size_t points, room;
    mill_cuts *out;
    size_t first;               /* of the cuts that are valleys */
} valleys;

static void keep(valleys *v, const loft_vec *p)
{
    if (v->points == v->room) {
        v->room = v->room ? 2 * v->room : 64;
        v->point = tool_grow(v->point, v->room * sizeof *v->point);
    }
    v->point[v->points++] = *p;
}

static void give(valleys *v, const loft_vec *p)
{
    double point[ENGINE_AXES];

    point_of(*p, point);
    mill_cuts_add(v->out, point);
}

/* True if the middle of two places is near to a valley that is known. */
static bool is_known(const valleys *v, const loft_touch *a, const loft_touch *b)
{
    double at[2];

    for (int k = 0; k < 2; k++)
        at[k] = (double_of(a->tip.axis[k]) + double_of(b->tip.axis[k])) / 2;
    for (size_t i = v->first; i < v->out->count; i++)
        for (size_t j = 0; j < v->out->cut[i].count; j++) {
            const double *const p = v->out->cut[i].point[j];
            if (hypot(p[0] - at[0], p[1] - at[1]) < v->by)
                return true;
        }
    return false;
}

/* From one end to the other: back from the start, and then the other way. */
static bool follow(valleys *v, const loft_touch *a, const loft_touch *b)
{
    loft_vec p;

    v->points = 0;
    for (int back = 1; back >= 0; back--) {
        if (loft_pencil_begin(&v->line, a, b, back) != LOFT_OK)
            return false;
        if (back)
            keep(v, &v->line.from);
        while (loft_pencil_next(&v->line, &p))
            keep(v, &p);
        for (size_t i = 0; back && i < v->points / 2; i++) {
            const loft_vec q = v->point[i];
            v->point[i] = v->point[v->points - 1 - i];
            v->point[v->points - 1 - i] = q;
        }
    }
    return v->points > 1;
}

/* Proved chords over the points. */
static int cut_valley(valleys *v)
{
    loft_pass pass;
    loft_vec p;

    (void)mill_cuts_begin(v->out, 0);
    for (size_t i = 0; i + 1 < v->points; i++) {
        const loft_vec last = pass.from;
        const int status = loft_pass_init(&pass, v->d, &v->point[i], &v->point[i + 1]);
        if (status != LOFT_OK)
            return status;
        if (i == 0)
            give(v, &pass.from);
        else
            pass.from = last;
        while (loft_pass_next(&pass, &p))
            give(v, &p);
    }
    return LOFT_OK;
}

static int look_between(valleys *v, const loft_touch *a, const loft_touch *b)
{
    if (!loft_pencil_apart(&v->line, a, b) || is_known(v, a, b) || !follow(v, a, b))
        return LOFT_OK;
    return cut_valley(v);
}

/* Look at one row, and between it and the one before. */
static int look_row(valleys *v, const loft_box *area, double y, size_t across, loft_touch *row,
                    bool *any)
{
    loft_touch before;
    bool had = false;
    int status = LOFT_OK;

    for (size_t k = 0; k < across && status == LOFT_OK; k++) {
        loft_real at[2];
        loft_touch now;
        if (!real_of(double_of(area->min.axis[0]) + (double)k * v->by, &at[0]) ||
            !real_of(y, &at[1]))
            return LOFT_ERR_RANGE;
        const bool touches = loft_pencil_touch(&v->line, at[0], at[1], &now);
        if (touches && had)
            status = look_between(v, &before, &now);
        if (touches && any[k] && status == LOFT_OK)
            status = look_between(v, &row[k], &now);
        before = row[k] = now;
        had = any[k] = touches;
    }
    return status;
}

int ENGINE_OF(engine_pencils)(const loft_drop *d, const loft_box *area, const mill_order *o,
                              mill_cuts *out)
{
    const double low = double_of(area->min.axis[1]), high = double_of(area->max.axis[1]);
    loft_drop fine = *d;
    valleys v = {
        .d = &fine, .by = double_of(d->cutter.radius) / 2, .out = out, .first = out->count
    };
    const double wide = double_of(area->max.axis[0]) - double_of(area->min.axis[0]);
    const size_t across = (size_t)(wide / v.by) + 1;
    loft_touch *const row = tool_grow(NULL, across * sizeof *row);
    bool *const any = tool_grow(NULL, across * sizeof *any);

    memset(any, 0, across * sizeof *any);
    if (fine.tol / 4 >= loft_drop_tol())        /* as a raster does */
        fine.tol /= 4;
    int status = loft_pencil_init(&v.line, d, area);
    for (double y = low; y <= high && status == LOFT_OK; y += v.by) {
        status = look_row(&v, area, y, across, row, any);
        o->tell(o->context, fmin(1, (y - low) / (high - low)));
    }
    free(row);
    free(any);
    free(v.point);
    return status;
}
