/* host-tools/engine/engine_mill.c -- the path of a cutter over the surfaces of a file; compiled
 * once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "toolpath/raster.h"        /* loft_raster */

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_isolines.h"
#include "engine/engine_left.h"
#include "engine/engine_levels.h"
#include "engine/engine_links.h"
#include "engine/engine_pencils.h"
#include "engine/engine_points.h"
#include "engine/engine_sheet.h"
#include "engine/engine_touch.h"
#include "engine/mill.h"

#define FEW     16      /* so many surfaces are cut into 64 sheets each */
#define NEAR    16      /* of the tolerance: bounds of pieces come so near */
#define BEYOND  0.7     /* radii: at least that far, to round the border */
#define AROUND  1.25    /* radii: there is room to go around */

/* Surfaces stay open, for sheets borrow them. */
typedef struct {
    engine_surface **held;
    size_t count;
    engine_sheet_list of;
    engine_points *points;
    loft_region_edge *edge;
    loft_region region;
} sheet_list;

static void close_sheets(sheet_list *l)
{
    while (l->count > 0)
        ENGINE_OF(engine_surfaces).close(l->held[--l->count]);
    ENGINE_OF(engine_points_free)(l->points);
    free(l->held);
    free(l->edge);
    free(l->of.sheet);
}

static int open_sheets(sheet_list *l, const surfaces *all, double tol, size_t *failed)
{
    const unsigned level = all->count <= FEW ? 3 : 0;
    loft_real near;

    if (!tol_of(tol / NEAR, &near))
        return LOFT_ERR_RANGE;
    l->held = tool_grow(NULL, all->count * sizeof *l->held);
    for (size_t i = 0; i < all->count; i++) {
        *failed = i;
        int status = ENGINE_OF(engine_surfaces).open(&all->surface[i], &l->held[i]);
        if (status != LOFT_OK)
            return status;
        l->count++;
        status = ENGINE_OF(engine_sheets)(l->held[i], level, &l->of);
        if (status != LOFT_OK)
            return status;
    }
    *failed = all->count;
    l->points = ENGINE_OF(engine_points_of)(l->of.sheet, l->of.count);
    for (size_t k = 0; k < l->of.count; k++)
        loft_sheet_measure(&l->of.sheet[k], loft_to_acc(near));
    return LOFT_OK;
}

/* Keep what is inside of the loops. */
static int trim_sheets(sheet_list *l, const mill_trim *t)
{
    size_t kept = 0;

    if (t->count == 0)
        return LOFT_OK;
    l->edge = tool_grow(NULL, t->count * sizeof *l->edge);
    for (size_t k = 0; k < t->count; k++) {
        loft_real at[2][2];
        for (int i = 0; i < 4; i++)
            if (!real_of(t->edge[k][i / 2][i % 2], &at[i / 2][i % 2]))
                return LOFT_ERR_RANGE;
        l->edge[k].from = loft_region_spot(at[0][0], at[0][1]);
        l->edge[k].to = loft_region_spot(at[1][0], at[1][1]);
    }
    l->region = (loft_region){ l->edge, (uint32_t)t->count };
    if (!loft_region_valid(&l->region))
        return LOFT_ERR_RANGE;
    for (size_t k = 0; k < l->of.count; k++)
        if (loft_sheet_trim(&l->of.sheet[k], &l->region, t->plane))
            l->of.sheet[kept++] = l->of.sheet[k];
    l->of.count = kept;
    return kept > 0 ? LOFT_OK : LOFT_SINGULAR;
}

/* Nothing is left of a box outside of the loops. */
static void trim_box(const mill_trim *t, double low[2], double high[2])
{
    for (int k = 0; k < 2 && t->plane && t->count > 0; k++) {
        double least = t->edge[0][0][k], most = least;
        for (size_t i = 0; i < t->count; i++) {
            least = fmin(least, t->edge[i][0][k]);
            most = fmax(most, t->edge[i][0][k]);
        }
        low[k] = fmax(low[k], least);
        high[k] = fmin(high[k], most);
    }
}

/* What the order leaves open is that of the sheets. */
static void complete_order(const sheet_list *l, mill_order *o, mill_report *out)
{
    const loft_sheet *const s = l->of.sheet;
    loft_box box = s[0].box;

    for (size_t k = 0; k < l->of.count; k++)
        box = loft_box_join(loft_box_join(box, s[k].box.min), s[k].box.max);
    out->top = double_of(box.max.axis[2]);
    out->clear = o->stocked ? fmax(out->top, o->stock[1]) : out->top;
    if (!o->floored)
        o->lowest = fmax(double_of(box.min.axis[2]), o->stocked ? o->stock[0] : -INFINITY);
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = double_of(box.min.axis[k]);
        high[k] = double_of(box.max.axis[k]);
    }
    trim_box(&o->trim, low, high);
    for (int k = 0; k < 2 && !o->bounded; k++) {
        const double margin = (o->pattern == MILL_WATERLINE ? AROUND : BEYOND) * o->radius;
        o->area[0][k] = low[k] - margin;
        o->area[1][k] = high[k] + margin;
    }
}

/* Both are the order's, which is completed. */
static int start_drop(const sheet_list *l, mill_order *o, loft_drop *d, loft_box *area)
{
    loft_real radius, corner, tol, lowest;
    loft_cutter cutter;

    if (!real_of(o->radius, &radius) || !real_of(o->corner, &corner) || !tol_of(o->tol, &tol) ||
        !real_of(o->lowest, &lowest))
        return LOFT_ERR_RANGE;
    int status = loft_cutter_init(&cutter, radius, corner);
    if (status == LOFT_OK)
        status = loft_drop_init(d, l->of.sheet, (uint32_t)l->of.count, &cutter, tol, lowest);
    if (status == LOFT_OK && o->pattern != MILL_PENCIL && !o->parametric) {
        ENGINE_OF(engine_touch)(d, o);
        if (o->stocked && !o->floored)
            o->lowest = fmax(o->lowest, o->stock[0]);
    }
    *area = l->of.sheet[0].box;
    for (int k = 0; k < 2; k++)
        if (!real_of(o->area[0][k], &area->min.axis[k]) ||
            !real_of(o->area[1][k], &area->max.axis[k]))
            return LOFT_ERR_RANGE;
    if (!real_of(o->lowest, &lowest))
        return LOFT_ERR_RANGE;
    return status
               ? status
               : (int)loft_drop_init(d, l->of.sheet, (uint32_t)l->of.count, &cutter, tol, lowest);
}

static int mill_raster(const loft_drop *d, const mill_order *o, const loft_box *area,
                       mill_cuts *cuts, mill_report *out)
{
    const bool spiral = o->pattern == MILL_SPIRAL;
    const unsigned across = spiral ? 1 : 1 - o->axis;
    const double from = o->area[0][across], width = o->area[1][across] - from;
    loft_real cusp, step;
    double last[ENGINE_AXES] = { 0 };
    bool linked = false;
    loft_raster r;
    loft_vec tip;

    if (!tol_of(o->cusp, &cusp) || !real_of(o->step, &step))
        return LOFT_ERR_RANGE;
    const int status = spiral ? loft_raster_init_spiral(&r, d, area, cusp, step)
                              : loft_raster_init(&r, d, area, o->axis, cusp, step);
    (void)mill_cuts_begin(cuts, 0);
    while (status == LOFT_OK && loft_raster_next(&r, &tip)) {
        double point[ENGINE_AXES];
        if (o->one_way && !r.linking && linked) {       /* a line begins where the link ended */
            (void)mill_cuts_begin(cuts, 0);
            mill_cuts_add(cuts, last);
        }
        linked = r.linking;
        point_of(tip, point);
        memcpy(last, point, sizeof last);
        if (!o->one_way || !linked)
            mill_cuts_add(cuts, point);
        o->tell(o->context, spiral ? 1 - double_of(r.area.max.axis[1] - r.area.min.axis[1]) / width
                                   : (point[across] - from) / width);
    }
    if (o->one_way)
        mill_cuts_one_way(cuts, o->axis);
    if (status == LOFT_OK) {
        out->lines = r.lines;
        out->cusp = double_of(r.cusp);
        out->depth = out->top - o->lowest;
    }
    return status;
}

/* Over an upright wall levels leave the cusps that lines leave over a level plane. */
static double depth_of(const mill_order *o)
{
    return o->step > 0 ? o->step : 2 * sqrt(o->cusp * (2 * o->radius - o->cusp));
}

static int mill_levels(const loft_drop *d, const mill_order *o, const loft_box *area,
                       mill_cuts *cuts, mill_report *out)
{
    const int status = ENGINE_OF(engine_levels)(d, area, out->top, depth_of(o), o, cuts);

    out->lines = cuts->count;
    out->depth = depth_of(o);
    mill_cuts_order(cuts, o->radius);
    return status;
}

static int mill_valleys(const loft_drop *d, const mill_order *o, const loft_box *area,
                        mill_cuts *cuts, mill_report *out)
{
    const int status = ENGINE_OF(engine_pencils)(d, area, o, cuts);

    out->lines = cuts->count;
    out->depth = out->top - o->lowest;
    mill_cuts_order(cuts, o->radius);
    return status;
}

int ENGINE_OF(engine_mill)(const surfaces *all, mill_order *o, mill_cuts *path, mill_report *out)
{
    mill_cuts cuts = { 0 };
    sheet_list l = { 0 };
    loft_box area;
    loft_drop d;

    *out = (mill_report){ 0 };
    int status = open_sheets(&l, all, o->tol, &out->failed);
    if (status == LOFT_OK)
        status = trim_sheets(&l, &o->trim);
    if (status == LOFT_OK) {
        complete_order(&l, o, out);
        status = start_drop(&l, o, &d, &area);
    }
    if (status == LOFT_OK && o->parametric) {
        status = ENGINE_OF(engine_isolines)(&d, &l.of, o, &cuts, &out->lines);
        out->depth = out->top - o->lowest;
    } else if (status == LOFT_OK)
        status = (o->pattern == MILL_WATERLINE ? mill_levels
                  : o->pattern == MILL_PENCIL  ? mill_valleys
                                               : mill_raster)(&d, o, &area, &cuts, out);
    if (o->stocked)
        out->depth = out->clear - o->lowest;
    if (status == LOFT_OK) {
        ENGINE_OF(engine_links)(&d, o, &cuts, path, out);
        if (path->cut[0].count > 1)
            ENGINE_OF(engine_left)(&d, o, &path->cut[0], out);
    }
    mill_cuts_free(&cuts);
    close_sheets(&l);
    return status;
}
