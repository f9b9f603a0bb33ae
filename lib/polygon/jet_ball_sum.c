/* lib/polygon/jet_ball_sum.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/jet_ball_sum.h"

void loft_jet_ball_sum_start(loft_jet_ball_sum *s, loft_vec origin)
{
    s->w = loft_jet_ball_of(loft_sci_zero());
    for (int k = 0; k < 3; k++)
        s->x[k] = s->w;
    s->wide = s->w.off;
    s->origin = origin;
}

void loft_jet_ball_sum_add(loft_jet_ball_sum *s, const loft_vec *p, const loft_jet_ball *weight)
{
    s->w = loft_jet_ball_add(&s->w, weight);
    for (int k = 0; k < 3; k++) {
        const loft_sci d = loft_sci_of(loft_to_acc(loft_vec_axis(p, k)) -
                                       loft_to_acc(loft_vec_axis(&s->origin, k)));
        const loft_jet_ball term = loft_jet_ball_scale(weight, d);
        const loft_jet size = loft_jet_ball_most(&term);
        s->x[k] = loft_jet_ball_add(&s->x[k], &term);
        s->wide = loft_jet_add(&s->wide, &size);
    }
}

bool loft_jet_ball_sum_project(loft_jet_ball_sum *s)
{
    const loft_jet_ball wide = { loft_jet_of(loft_sci_zero()), s->wide };
    loft_jet_ball quotient;

    for (int k = 0; k < 3; k++)
        if (!loft_jet_ball_div(&s->x[k], &s->w, &s->x[k]))
            return false;
    if (!loft_jet_ball_div(&wide, &s->w, &quotient))
        return false;
    s->wide = quotient.off;
    return true;
}
