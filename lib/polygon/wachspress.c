/* lib/polygon/wachspress.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/wachspress.h"

/* With A_j the area of p, v_j, v_(j+1) and C_i that of v_(i-1), v_i, v_(i+1),
 *
 *     w_i = C_i prod A_j, j not i - 1 or i        phi_i = w_i / sum w
 *
 * All factors are positive inside, so nothing cancels: n - 1 products, n sums and one quotient of factors that err by
 * 2^-61 (floats: 2^-47) each. In floats an area is at least 2^-216 and at most 2^43; divided by the largest of them
 * they are 2^-259 to 1, and the product of those that do not belong to the nearest vertex stays a normal number
 * unless three of them are that small. */
enum loft_status loft_wachspress_eval(const loft_domain *d, loft_spot p, loft_sci phi[])
{
    loft_sci area[LOFT_SIDES_MAX], sum = loft_sci_zero();
    const unsigned n = d->sides;
    unsigned index = 0, largest = 0;

    if (!d->convex)
        return LOFT_ERR_ARG;
    if (!loft_spot_admits(p))
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

    for (unsigned j = 1; j < n; j++)
        if (loft_sci_less(area[largest], area[j]))
            largest = j;
    const loft_sci unit = area[largest];
    for (unsigned j = 0; j < n; j++)
        area[j] = loft_sci_div(area[j], unit);
    for (unsigned i = 0; i < n; i++) {
        phi[i] = d->corner[i];
        for (unsigned j = 0; j < n; j++)
            if (j != i && j != (i ? i - 1 : n - 1))
                phi[i] = loft_sci_mul(phi[i], area[j]);
        sum = loft_sci_add(sum, phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_div(phi[i], sum);
    return LOFT_OK;
}
