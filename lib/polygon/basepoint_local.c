/* lib/polygon/basepoint_local.c -- derivatives of surfaces from a rational Bezier triangle with cut corners
 * SPDX-License-Identifier: MIT
 *
 * The sum of basepoint.c, in functions of phi_1 and phi_2, counted from the point itself.
 */
#include "polygon/basepoint.h"
#include "polygon/jet_blend.h"  /* loft_jet_blend */

static void shares(loft_unit phi1, loft_unit phi2, loft_jet phi[3])
{
    const loft_sci one = loft_sci_one();

    phi[0] = loft_jet_of(loft_sci_from_unit(phi1));
    phi[1] = loft_jet_of(loft_sci_from_unit(phi2));
    phi[2] = loft_jet_of(loft_sci_sub(loft_sci_sub(one, phi[0].f), phi[1].f));
    phi[0].x = phi[1].y = one;
    phi[2].x = phi[2].y = loft_sci_neg(one);
}

static bool is_cut(const loft_basepoint *b, const uint8_t l[3])
{
    for (unsigned i = 0; i < 3; i++)
        if (l[i] + b->cut[i] > b->degree)
            return true;
    return false;
}

static loft_jet weight_of(const loft_basepoint *b, const loft_jet phi[3], const uint8_t l[3], unsigned rank)
{
    loft_jet weight = loft_jet_of(loft_sci_mul(loft_sci_from_int(loft_multi_ways(l, 3)), loft_sci_from_real(b->w[rank])));

    for (unsigned i = 0; i < 3; i++) {
        const loft_jet power = loft_jet_pow(&phi[i], l[i]);
        weight = loft_jet_mul(&weight, &power);
    }
    return weight;
}

enum loft_status loft_basepoint_local(const loft_basepoint *b, loft_unit phi1, loft_unit phi2, loft_local *out)
{
    loft_jet phi[3];
    loft_jet_blend sum;
    loft_vec here;
    uint8_t l[3];
    unsigned rank = 0;

    const enum loft_status status = loft_basepoint_eval(b, phi1, phi2, &here);
    if (status != LOFT_OK)
        return status;
    shares(phi1, phi2, phi);
    loft_jet_blend_start(&sum, here);
    loft_multi_first(l, 3, b->degree);
    do {
        if (!is_cut(b, l)) {
            const loft_jet weight = weight_of(b, phi, l, rank);
            loft_jet_blend_add(&sum, &b->p[rank], &weight);
        }
        rank++;
    } while (loft_multi_next(l, 3));
    return loft_jet_blend_project(&sum, out);
}
