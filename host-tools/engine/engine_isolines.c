/* host-tools/engine/engine_isolines.c -- lines of constant parameters as a mill's path; compiled
 * once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "toolpath/raster.h"        /* loft_pass */

#include "engine/engine_isolines.h"

#define POINTS 128              /* steps of a line; chords between them are straight from above */

typedef struct {
    const loft_drop *d;
    loft_pass pass;
    loft_vec from;
    bool begun;
    mill_cuts *out;
} walk;

static void give(walk *w, const loft_vec *p)
{
    double point[ENGINE_AXES];

    point_of(*p, point);
    mill_cuts_add(w->out, point);
}

/* Go to above a point, by proved chords. */
static int go_to(walk *w, const loft_vec *to)
{
    loft_vec p;

    if (!w->begun) {
        const int status = loft_pass_init(&w->pass, w->d, to, to);
        w->begun = true;
        w->from = *to;
        if (status == LOFT_OK)
            give(w, &w->pass.from);
        return status;
    }
    const loft_vec last = w->pass.from;
    const int status = loft_pass_init(&w->pass, w->d, &w->from, to);
    if (status != LOFT_OK)
        return status;
    w->pass.from = last;
    while (loft_pass_next(&w->pass, &p))
        give(w, &p);
    w->from = *to;
    return LOFT_OK;
}

static int walk_line(walk *w, loft_surface s, unsigned axis, double at, bool back)
{
    const double end = s.over == LOFT_SURFACE_TRIANGLE ? 1 - at : 1, from[2] = { 0, at },
                 to[2] = { end, at };
    const double *const a = back ? to : from, *const b = back ? from : to;
    loft_trace t;
    loft_vec p;

    if (!(end > 0))
        return LOFT_OK;
    int status = loft_trace_init(&t, s, LOFT_UNIT(a[axis]), LOFT_UNIT(a[1 - axis]),
                                 LOFT_UNIT(b[axis]), LOFT_UNIT(b[1 - axis]), POINTS);
    while (status == LOFT_OK && loft_trace_next(&t, &p))
        status = go_to(w, &p);
    return status;
}

static int walk_surface(const loft_drop *d, loft_surface s, const mill_order *o, mill_cuts *out,
                        size_t *lines)
{
    const unsigned count = (unsigned)ceil(1 / o->step - 1e-9);
    walk w = { .d = d, .out = out };
    int status = LOFT_OK;

    (void)mill_cuts_begin(out, 0);
    for (unsigned k = 0; k <= count && status == LOFT_OK; k++) {
        status = walk_line(&w, s, o->axis, (double)k / count, k % 2);
        ++*lines;
    }
    return status;
}

int ENGINE_OF(engine_isolines)(const loft_drop *d, const engine_sheet_list *sheets,
                               const mill_order *o, mill_cuts *out, size_t *lines)
{
    loft_drop fine = *d;
    int status = LOFT_OK;

    if (fine.tol / 4 >= loft_drop_tol())        /* as a raster does */
        fine.tol /= 4;
    for (size_t k = 0; k < sheets->count && status == LOFT_OK; k++) {
        const loft_surface s = sheets->sheet[k].surface;
        if (k > 0 && s.surface == sheets->sheet[k - 1].surface.surface)
            continue;
        status = walk_surface(&fine, s, o, out, lines);
        o->tell(o->context, (double)k / (double)sheets->count);
    }
    return status;
}
