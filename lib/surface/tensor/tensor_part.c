/* lib/surface/tensor/tensor_part.c
 * SPDX-License-Identifier: MIT
 */
#include "surface/tensor/tensor_part.h"

#define SIDE (LOFT_DEGREE_MAX + 1)

/* degree - k rows at `from`, then k rows at `to` in a copy; in place. */
static void sub_row(loft_sci c[], unsigned degree, loft_sci from, loft_sci to)
{
    loft_sci row[SIDE], copy[SIDE];

    for (unsigned k = 0; k <= degree; k++)
        row[k] = c[k];
    for (unsigned k = degree + 1; k-- > 0; ) {
        for (unsigned j = 0; j <= k; j++)
            copy[j] = row[j];
        c[k] = loft_sci_deriv(copy, k, 0, to);
        for (unsigned j = 0; j < k; j++)
            row[j] = loft_sci_lerp(row[j], row[j + 1], from);
    }
}

void loft_sci_net_sub(const loft_sci_net *x, const loft_dyad part[2], loft_sci_net *out)
{
    const loft_sci u = loft_sci_from_unit(loft_dyad_from(part[0])),
                   u_to = loft_sci_from_unit(loft_dyad_to(part[0])),
                   v = loft_sci_from_unit(loft_dyad_from(part[1])),
                   v_to = loft_sci_from_unit(loft_dyad_to(part[1]));
    loft_sci column[SIDE];

    *out = *x;
    for (unsigned i = 0; i <= x->m && part[1].level > 0; i++)
        sub_row(out->c[i], x->n, v, v_to);
    for (unsigned j = 0; j <= x->n && part[0].level > 0; j++) {
        for (unsigned i = 0; i <= x->m; i++)
            column[i] = out->c[i][j];
        sub_row(column, x->m, u, u_to);
        for (unsigned i = 0; i <= x->m; i++)
            out->c[i][j] = column[i];
    }
}

loft_sci loft_sci_net_deriv(const loft_sci_net *x, unsigned a, unsigned b, loft_sci u, loft_sci v)
{
    loft_sci row[SIDE], column[SIDE];

    for (unsigned i = 0; i <= x->m; i++) {
        for (unsigned j = 0; j <= x->n; j++)
            row[j] = x->c[i][j];
        column[i] = loft_sci_deriv(row, x->n, b, v);
    }
    return loft_sci_deriv(column, x->m, a, u);
}

loft_sci loft_dyad_place(loft_dyad n, loft_sci x)
{
    const loft_sci k = loft_sci_from_int((int32_t)n.k);
    return loft_sci_mul(loft_sci_add(k, x), loft_sci_power2(-(int)n.level));
}
