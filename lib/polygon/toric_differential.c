/* lib/polygon/toric_differential.c -- derivatives of toric patches
 * SPDX-License-Identifier: MIT
 *
 * The sum of toric.c, as functions of the point. Points are relative to the point itself. The
 * heights are linear, so their derivatives are the normals.
 */
#include "polygon/toric.h"
#include "polygon/jet_weighted_sum.h"  /* loft_jet_weighted_sum */

static void height_jets(const loft_lattice_polygon *l, loft_spot p, loft_jet h[])
{
    for (unsigned i = 0; i < l->sides; i++) {
        const loft_sci x = loft_sci_from_int(l->edge[i].normal.at[0]),
                       y = loft_sci_from_int(l->edge[i].normal.at[1]);
        const loft_sci by_x = loft_sci_mul(x, loft_sci_from_real(p.at[0])),
                       by_y = loft_sci_mul(y, loft_sci_from_real(p.at[1]));

        h[i] = loft_jet_of(
            loft_sci_add(loft_sci_add(by_x, by_y), loft_sci_from_int(l->edge[i].offset)));
        h[i].x = x;
        h[i].y = y;
    }
}

static loft_jet point_weight(const loft_toric *t, const loft_jet h[], loft_whole l, unsigned k)
{
    loft_jet weight = loft_jet_of(loft_toric_factor(t, k));

    for (unsigned i = 0; i < t->lattice->sides; i++) {
        const loft_jet power = loft_jet_pow(
            &h[i], (unsigned)loft_lattice_polygon_height(t->lattice, i, l));
        weight = loft_jet_mul(&weight, &power);
    }
    return weight;
}

enum loft_status loft_toric_differential(const loft_toric *t, loft_spot p, loft_differential *out)
{
    loft_jet h[LOFT_SIDES_MAX];
    loft_jet_weighted_sum sum;
    loft_vec here;
    loft_whole l;
    unsigned k = 0;

    const enum loft_status status = loft_toric_eval(t, p, &here);
    if (status != LOFT_OK)
        return status;
    height_jets(t->lattice, p, h);
    loft_jet_weighted_sum_start(&sum, here);
    loft_lattice_polygon_first(t->lattice, &l);
    do {
        const loft_jet weight = point_weight(t, h, l, k);
        loft_jet_weighted_sum_add(&sum, &t->p[k++], &weight);
    } while (loft_lattice_polygon_next(t->lattice, &l));
    return loft_jet_weighted_sum_project(&sum, out);
}
