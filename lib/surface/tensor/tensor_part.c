/* lib/surface/tensor/tensor_part.c
 * SPDX-License-Identifier: MIT
 */
#include "surface/tensor/tensor_part.h"

#define SIDE (LOFT_DEGREE_MAX + 1)

void loft_tensor_part_start(loft_tensor_part *part)
{
    part->u.k = part->v.k = 0;
    part->u.level = part->v.level = 0;
    part->depth = 0;
}

void loft_tensor_part_halve(loft_tensor_part *part, bool along_u)
{
    loft_dyad *n = along_u ? &part->u : &part->v;

    part->halved_u[part->depth++] = along_u;
    *n = loft_dyad_half(*n, 0);
}

bool loft_tensor_part_next(loft_tensor_part *part)
{
    for (; part->depth; part->depth--) {
        loft_dyad *n = part->halved_u[part->depth - 1] ? &part->u : &part->v;
        if (n->k % 2 == 0) {
            n->k++;
            return true;
        }
        n->k /= 2;
        n->level--;
    }
    return false;
}

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

void loft_sci_net_sub(const loft_sci_net *x, const loft_tensor_part *part, loft_sci_net *out)
{
    const loft_sci u = loft_sci_from_unit(loft_dyad_from(part->u)),
                   u_to = loft_sci_from_unit(loft_dyad_to(part->u)),
                   v = loft_sci_from_unit(loft_dyad_from(part->v)),
                   v_to = loft_sci_from_unit(loft_dyad_to(part->v));
    loft_sci column[SIDE];

    *out = *x;
    for (unsigned i = 0; i <= x->m && part->v.level > 0; i++)
        sub_row(out->c[i], x->n, v, v_to);
    for (unsigned j = 0; j <= x->n && part->u.level > 0; j++) {
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
