/* lib/polygon/jet_blend.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/jet_blend.h"


void loft_jet_blend_start(loft_jet_blend *b, loft_vec origin)
{
    b->origin = origin;
    b->w = loft_jet_of(loft_sci_zero());
    for (int i = 0; i < LOFT_AXES; i++) {
        b->x[i] = b->w;
        b->wide_x[i] = b->wide_y[i] = loft_sci_zero();
    }
}

void loft_jet_blend_add(loft_jet_blend *b, const loft_vec *p, const loft_jet *weight)
{
    b->w = loft_jet_add(&b->w, weight);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci d = loft_sci_of(loft_wide(p->axis[i]) - loft_wide(b->origin.axis[i]));
        const loft_jet term = loft_jet_scale(weight, d);
        b->x[i] = loft_jet_add(&b->x[i], &term);
        b->wide_x[i] = loft_sci_add(b->wide_x[i], loft_sci_size(term.x));
        b->wide_y[i] = loft_sci_add(b->wide_y[i], loft_sci_size(term.y));
    }
}

static loft_sci largest(const loft_sci x[LOFT_AXES])
{
    loft_sci most = x[0];

    for (int i = 1; i < LOFT_AXES; i++)
        if (loft_sci_less(most, x[i]))
            most = x[i];
    return most;
}

static void take(loft_local *out, int i, const loft_jet *x)
{
    out->u[i] = x->x;
    out->v[i] = x->y;
    out->uu[i] = x->xx;
    out->uv[i] = x->xy;
    out->vv[i] = x->yy;
}

void loft_jet_blend_end(const loft_jet_blend *b, loft_local *out)
{
    for (int i = 0; i < LOFT_AXES; i++)
        take(out, i, &b->x[i]);
    out->width_u = largest(b->wide_x);
    out->width_v = largest(b->wide_y);
}

enum loft_status loft_jet_blend_project(const loft_jet_blend *b, loft_local *out)
{
    if (loft_sci_sign(b->w.f) == 0)
        return LOFT_SINGULAR;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_jet quotient = loft_jet_div(&b->x[i], &b->w);
        take(out, i, &quotient);
    }
    const loft_sci w = loft_sci_size(b->w.f);
    out->width_u = loft_sci_div(largest(b->wide_x), w);
    out->width_v = loft_sci_div(largest(b->wide_y), w);
    return LOFT_OK;
}
