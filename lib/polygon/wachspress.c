/* lib/polygon/wachspress.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/wachspress.h"

static unsigned next_vertex(unsigned i, unsigned sides)   { return i + 1 < sides ? i + 1 : 0; }
static unsigned vertex_before(unsigned i, unsigned sides) { return i ? i - 1 : sides - 1; }

static unsigned largest_of(const loft_sci area[], unsigned sides)
{
    unsigned largest = 0;

    for (unsigned j = 1; j < sides; j++)
        if (loft_sci_less(area[largest], area[j]))
            largest = j;
    return largest;
}

/* Let A_j be the area of p, v_j, v_(j+1) and C_i that of v_(i-1), v_i, v_(i+1). Then
 *
 *     w_i = C_i prod A_j, j not i - 1 or i        phi_i = w_i / sum w
 *
 * All factors are positive inside, so nothing cancels: n - 1 products, n sums and one quotient of
 * factors that err by 2^-61 (floats: 2^-47) each. In floats an area is at least 2^-216 and at most
 * 2^43. Divided by the largest of them, areas are 2^-259 to 1. The product of those that do not
 * belong to the nearest vertex stays a normal number unless three of them are that small. */
enum loft_status loft_wachspress_eval(const loft_domain *d, loft_spot p, loft_sci phi[])
{
    loft_sci area[LOFT_SIDES_MAX], sum = loft_sci_zero();
    const unsigned n = d->sides;
    unsigned index = 0;

    if (!d->convex)
        return LOFT_ERR_ARG;
    if (!loft_spot_valid(p))
        return LOFT_ERR_RANGE;
    const enum loft_place place = loft_domain_place(d, p, area, &index);
    if (place == LOFT_OUTSIDE)
        return LOFT_ERR_RANGE;
    if (place == LOFT_AT_VERTEX)
        loft_domain_vertex(d, index, phi);
    if (place == LOFT_ON_EDGE)
        loft_domain_edge(d, p, index, phi);
    if (place != LOFT_INSIDE)
        return LOFT_OK;

    const loft_sci unit = area[largest_of(area, n)];
    for (unsigned j = 0; j < n; j++)
        area[j] = loft_sci_div(area[j], unit);
    for (unsigned i = 0; i < n; i++) {
        phi[i] = d->corner[i];
        for (unsigned j = 0; j < n; j++)
            if (j != i && j != vertex_before(i, n))
                phi[i] = loft_sci_mul(phi[i], area[j]);
        sum = loft_sci_add(sum, phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_div(phi[i], sum);
    return LOFT_OK;
}

/* A_j = (v_j - p) x (v_(j+1) - p) has the derivatives y_j - y_(j+1) and x_(j+1) - x_j. The same
 * products are valid on an edge and at a vertex, where one or two areas are 0. */
static loft_jet area_at(const loft_domain *d, unsigned j, loft_sci area, loft_sci unit)
{
    const loft_spot *a = &d->v[j], *b = &d->v[next_vertex(j, d->sides)];
    loft_jet r = loft_jet_of(loft_sci_div(area, unit));

    r.x = loft_sci_div(loft_sci_sub(loft_sci_from_real(a->at[1]), loft_sci_from_real(b->at[1])),
                       unit);
    r.y = loft_sci_div(loft_sci_sub(loft_sci_from_real(b->at[0]), loft_sci_from_real(a->at[0])),
                       unit);
    return r;
}

enum loft_status loft_wachspress_jet(const loft_domain *d, loft_spot p, loft_jet phi[])
{
    loft_sci area[LOFT_SIDES_MAX];
    loft_jet factor[LOFT_SIDES_MAX], sum = loft_jet_of(loft_sci_zero());
    const unsigned n = d->sides;
    unsigned index = 0;

    if (!d->convex)
        return LOFT_ERR_ARG;
    if (!loft_spot_valid(p) || loft_domain_place(d, p, area, &index) == LOFT_OUTSIDE)
        return LOFT_ERR_RANGE;
    const loft_sci unit = area[largest_of(area, n)];
    for (unsigned j = 0; j < n; j++)
        factor[j] = area_at(d, j, area[j], unit);
    for (unsigned i = 0; i < n; i++) {
        phi[i] = loft_jet_of(d->corner[i]);
        for (unsigned j = 0; j < n; j++)
            if (j != i && j != vertex_before(i, n))
                phi[i] = loft_jet_mul(&phi[i], &factor[j]);
        sum = loft_jet_add(&sum, &phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_jet_div(&phi[i], &sum);
    return LOFT_OK;
}
