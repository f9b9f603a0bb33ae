/* host-tools/engine/engine_points.c -- surfaces that remember their points; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_points.h"

#define PLACES ((size_t)1 << 17)

typedef struct {
    const void *surface;        /* NULL: nothing is remembered */
    loft_unit u, v;
    loft_vec point;
} memory;

typedef struct {
    loft_surface of;
    memory *all;
} remembering;

struct engine_points {
    memory *all;
    remembering *surface;
};

/* Neighbours are at different places, and so are the same parameters of different surfaces. In
 * floats only the upper bits of parameters differ, so the upper bits of products count. */
static size_t place_of(const void *surface, loft_unit u, loft_unit v)
{
    uint64_t a = 0, b = 0;

    memcpy(&a, &u, sizeof u);
    memcpy(&b, &v, sizeof v);
    uint64_t mixed = (a ^ (uint64_t)(uintptr_t)surface) * 0x9E3779B97F4A7C15u;
    mixed = ((mixed ^ mixed >> 32) + b) * 0xD6E8FEB86659FD93u;
    mixed = (mixed ^ mixed >> 32) * 0x9E3779B97F4A7C15u;
    return (size_t)(mixed >> 32) & (PLACES - 1);
}

static enum loft_status recall(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    const remembering *const r = surface;
    memory *const m = &r->all[place_of(surface, u, v)];

    if (m->surface != surface || m->u != u || m->v != v) {
        const enum loft_status status = r->of.eval(r->of.surface, u, v, out);
        if (status == LOFT_OK)
            *m = (memory){ surface, u, v, *out };
        return status;
    }
    *out = m->point;
    return LOFT_OK;
}

engine_points *ENGINE_OF(engine_points_of)(loft_sheet sheet[], size_t count)
{
    engine_points *const p = tool_grow(NULL, sizeof *p);
    remembering *now = NULL;

    p->all = tool_grow(NULL, PLACES * sizeof *p->all);
    memset(p->all, 0, PLACES * sizeof *p->all);
    p->surface = tool_grow(NULL, count * sizeof *p->surface);
    for (size_t k = 0; k < count; k++) {
        if (!now || now->of.surface != sheet[k].surface.surface) {
            now = now ? now + 1 : p->surface;
            *now = (remembering){ sheet[k].surface, p->all };
        }
        sheet[k].surface.eval = recall;
        sheet[k].surface.surface = now;
    }
    return p;
}

void ENGINE_OF(engine_points_free)(engine_points *p)
{
    if (!p)
        return;
    free(p->all);
    free(p->surface);
    free(p);
}
