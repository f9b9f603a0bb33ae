/* lib/polygon/basepoint_differential.c -- derivatives of Bezier triangles with cut corners
 * SPDX-License-Identifier: MIT
 *
 * The sums of basepoint.c, as functions of phi_1 and phi_2, or of u and v at a corner. Points are
 * relative to the point itself.
 */
#include "polygon/basepoint.h"
#include "polygon/jet_weighted_sum.h"  /* loft_jet_weighted_sum */

static void phi_jets(loft_unit phi1, loft_unit phi2, loft_jet phi[3])
{
    const loft_sci one = loft_sci_one();

    phi[0] = loft_jet_of(loft_sci_from_unit(phi1));
    phi[1] = loft_jet_of(loft_sci_from_unit(phi2));
    phi[2] = loft_jet_of(loft_sci_sub(loft_sci_sub(one, phi[0].f), phi[1].f));
    phi[0].x = phi[1].y = one;
    phi[2].x = phi[2].y = loft_sci_neg(one);
}

static bool point_is_cut(const loft_basepoint *b, const uint8_t l[3])
{
    for (unsigned i = 0; i < 3; i++)
        if (l[i] + b->cut[i] > b->degree)
            return true;
    return false;
}

/* The factors of the three indices, and the factor of power degree - index - cut of a corner. */
typedef struct {
    loft_jet factor[3], shared;
    unsigned corner;
} powers;

static loft_jet point_weight(const loft_basepoint *b, const powers *f, const uint8_t l[3],
                             unsigned rank)
{
    const loft_sci ways = loft_sci_from_int(loft_multiindex_multinomial(l, 3));
    const unsigned shared = (unsigned)b->degree - l[f->corner] - b->cut[f->corner];
    loft_jet weight = loft_jet_of(loft_sci_mul(ways, loft_sci_from_real(b->w[rank])));

    for (unsigned i = 0; i < 3; i++) {
        const loft_jet power = loft_jet_pow(&f->factor[i], l[i]);
        weight = loft_jet_mul(&weight, &power);
    }
    const loft_jet power = loft_jet_pow(&f->shared, shared);
    return loft_jet_mul(&weight, &power);
}

static enum loft_status sum_jets(const loft_basepoint *b, const powers *f, loft_vec here,
                                 loft_differential *out)
{
    loft_jet_weighted_sum sum;
    uint8_t l[3];
    unsigned rank = 0;

    loft_jet_weighted_sum_start(&sum, here);
    loft_multiindex_first(l, 3, b->degree);
    do {
        if (!point_is_cut(b, l)) {
            const loft_jet weight = point_weight(b, f, l, rank);
            loft_jet_weighted_sum_add(&sum, &b->p[rank], &weight);
        }
        rank++;
    } while (loft_multiindex_next(l, 3));
    return loft_jet_weighted_sum_project(&sum, out);
}

enum loft_status loft_basepoint_differential(const loft_basepoint *b, loft_unit phi1,
                                             loft_unit phi2, loft_differential *out)
{
    loft_vec here;
    powers f;

    const enum loft_status status = loft_basepoint_eval(b, phi1, phi2, &here);
    if (status != LOFT_OK)
        return status;
    phi_jets(phi1, phi2, f.factor);
    f.shared = loft_jet_of(loft_sci_one());
    f.corner = 2;
    return sum_jets(b, &f, here, out);
}

enum loft_status loft_basepoint_corner_differential(const loft_basepoint *b, unsigned corner,
                                                    loft_unit u, loft_unit v,
                                                    loft_differential *out)
{
    const loft_jet one = loft_jet_of(loft_sci_one());
    loft_vec here;
    powers f;

    const enum loft_status status = loft_basepoint_corner(b, corner, u, v, &here);
    if (status != LOFT_OK)
        return status;
    loft_jet *across = &f.factor[(corner + 2) % 3];
    *across = loft_jet_of(loft_sci_from_unit(u));
    f.shared = loft_jet_of(loft_sci_from_unit(v));
    across->x = f.shared.y = loft_sci_one();
    f.factor[(corner + 1) % 3] = loft_jet_sub(&one, across);
    f.factor[corner] = loft_jet_sub(&one, &f.shared);
    f.corner = corner;
    return sum_jets(b, &f, here, out);
}
