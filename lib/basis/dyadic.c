/* lib/basis/dyadic.c
 * SPDX-License-Identifier: MIT
 */
#include "basis/dyadic.h"
#include "basis/bernstein.h"    /* loft_bernstein_step, loft_bernstein_eval */

loft_unit loft_dyad_at(loft_dyad n, loft_unit t)
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1));
    const loft_acc from = loft_acc_scale(one, loft_dyad_from(n)),
                   to = loft_acc_scale(one, loft_dyad_to(n));

    return loft_unit_ratio(loft_acc_lerp(from, to, t), one);
}

/* degree - k rows at `from`, then k rows at `to` in a copy. */
void loft_bernstein_sub(const loft_acc c[], unsigned degree, loft_unit from, loft_unit to,
                        loft_acc out[])
{
    loft_acc row[LOFT_DEGREE_MAX + 1], copy[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= degree; k++)
        row[k] = c[k];
    for (unsigned k = degree + 1; k-- > 0; ) {
        for (unsigned j = 0; j <= k; j++)
            copy[j] = row[j];
        out[k] = loft_bernstein_eval(copy, k, to);
        loft_bernstein_step(row, k, from);
    }
}
