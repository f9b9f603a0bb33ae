/* host-tools/engine/engine_fit.c -- B-splines near points through the library; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "curve/fit.h"              /* loft_bspline_fit */

#include "base/tool.h"              /* tool_grow */
#include "engine/engine_fit.h"

typedef struct {
    loft_vec *p, *out;
    loft_real *u, *weight, *knot;
    loft_sci *memory;
} held_fit;

static void take_room(const engine_fit *f, held_fit *h)
{
    h->p      = tool_grow(NULL, f->count * sizeof *h->p);
    h->u      = tool_grow(NULL, f->count * sizeof *h->u);
    h->weight = tool_grow(NULL, f->count * sizeof *h->weight);
    h->knot   = tool_grow(NULL, (f->points + f->degree + 1) * sizeof *h->knot);
    h->out    = tool_grow(NULL, f->points * sizeof *h->out);
    h->memory = tool_grow(NULL, LOFT_FIT_MEMORY(f->points, f->degree) * sizeof *h->memory);
}

static void give_back(held_fit *h)
{
    free(h->p);
    free(h->u);
    free(h->weight);
    free(h->knot);
    free(h->out);
    free(h->memory);
}

static bool hold_fit(const engine_fit *f, held_fit *h)
{
    for (size_t k = 0; k < f->count; k++)
        if (!vec_of(f->p[k], &h->p[k]) || !real_of(f->u[k], &h->u[k]) ||
            (f->weight && !real_of(f->weight[k], &h->weight[k])))
            return false;
    for (unsigned k = 0; k <= f->points + f->degree; k++)
        if (!real_of(f->knot[k], &h->knot[k]))
            return false;
    return true;
}

int ENGINE_OF(engine_fit_spline)(const engine_fit *f, double out[][ENGINE_AXES])
{
    held_fit h;
    int status = LOFT_ERR_RANGE;

    take_room(f, &h);
    if (hold_fit(f, &h)) {
        const loft_fit_points data = { h.p, h.u, f->weight ? h.weight : NULL, (uint32_t)f->count };
        status = loft_bspline_fit(&data, h.knot, f->points, f->degree, f->closed, h.out, h.memory);
    }
    for (unsigned k = 0; k < f->points && status == LOFT_OK; k++)
        point_of(h.out[k], out[k]);
    give_back(&h);
    return status;
}
