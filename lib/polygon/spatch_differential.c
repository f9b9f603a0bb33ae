/* lib/polygon/spatch_differential.c -- derivatives of S-patches
 * SPDX-License-Identifier: MIT
 *
 * The sum of spatch.c, as functions of the point. Points are relative to the point itself.
 */
#include "polygon/spatch.h"
#include "polygon/jet_weighted_sum.h"  /* loft_jet_weighted_sum */

static loft_jet point_weight(const loft_spatch *s, const loft_jet phi[], const uint8_t l[],
                             unsigned rank)
{
    const loft_sci ways = loft_sci_from_int(loft_multiindex_multinomial(l, s->sides));
    loft_jet weight = loft_jet_of(s->w ? loft_sci_mul(ways, loft_sci_from_real(s->w[rank])) : ways);

    for (unsigned i = 0; i < s->sides; i++)
        if (l[i]) {
            const loft_jet power = loft_jet_pow(&phi[i], l[i]);
            weight = loft_jet_mul(&weight, &power);
        }
    return weight;
}

enum loft_status loft_spatch_differential(const loft_spatch *s, const loft_jet phi[],
                                          loft_differential *out)
{
    loft_sci value[LOFT_SIDES_MAX];
    uint8_t l[LOFT_SIDES_MAX];
    loft_vec here;
    loft_jet_weighted_sum sum;
    unsigned rank = 0;

    for (unsigned i = 0; i < s->sides; i++)
        value[i] = phi[i].f;
    const enum loft_status status = loft_spatch_eval(s, value, &here);
    if (status != LOFT_OK)
        return status;
    loft_jet_weighted_sum_start(&sum, here);
    loft_multiindex_first(l, s->sides, s->depth);
    do {
        const loft_jet weight = point_weight(s, phi, l, rank);
        loft_jet_weighted_sum_add(&sum, &s->p[rank++], &weight);
    } while (loft_multiindex_next(l, s->sides));
    if (s->w)
        return loft_jet_weighted_sum_project(&sum, out);
    loft_jet_weighted_sum_end(&sum, out);
    return LOFT_OK;
}
