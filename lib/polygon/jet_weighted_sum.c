/* lib/polygon/jet_weighted_sum.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/jet_weighted_sum.h"


void loft_jet_weighted_sum_start(loft_jet_weighted_sum *b, loft_vec origin)
{
    b->origin = origin;
    b->w = loft_jet_of(loft_sci_zero());
    for (int i = 0; i < LOFT_AXES; i++) {
        b->x[i] = b->w;
        b->wide_x[i] = b->wide_y[i] = loft_sci_zero();
    }
}

void loft_jet_weighted_sum_add(loft_jet_weighted_sum *b, const loft_vec *p, const loft_jet *weight)
{
    b->w = loft_jet_add(&b->w, weight);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci d = loft_sci_of(loft_to_acc(p->axis[i]) - loft_to_acc(b->origin.axis[i]));
        const loft_jet term = loft_jet_scale(weight, d);
        b->x[i] = loft_jet_add(&b->x[i], &term);
        b->wide_x[i] = loft_sci_add(b->wide_x[i], loft_sci_abs(term.x));
        b->wide_y[i] = loft_sci_add(b->wide_y[i], loft_sci_abs(term.y));
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

static void set_axis(loft_differential *out, int i, const loft_jet *x)
{
    out->u[i] = x->x;
    out->v[i] = x->y;
    out->uu[i] = x->xx;
    out->uv[i] = x->xy;
    out->vv[i] = x->yy;
}

void loft_jet_weighted_sum_end(const loft_jet_weighted_sum *b, loft_differential *out)
{
    for (int i = 0; i < LOFT_AXES; i++)
        set_axis(out, i, &b->x[i]);
    out->width_u = largest(b->wide_x);
    out->width_v = largest(b->wide_y);
}

enum loft_status loft_jet_weighted_sum_project(const loft_jet_weighted_sum *b,
                                               loft_differential *out)
{
    if (loft_sci_sign(b->w.f) == 0)
        return LOFT_SINGULAR;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_jet quotient = loft_jet_div(&b->x[i], &b->w);
        set_axis(out, i, &quotient);
    }
    const loft_sci w = loft_sci_abs(b->w.f);
    out->width_u = loft_sci_div(largest(b->wide_x), w);
    out->width_v = loft_sci_div(largest(b->wide_y), w);
    return LOFT_OK;
}
