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

/* The same as below for a cubic, where code may take room. */
#if !defined(__AVR__) && !defined(__thumb__)
static void cut_cubic(const loft_acc c[4], loft_unit from, loft_unit to, loft_acc out[4])
{
    const loft_acc f0 = loft_acc_lerp(c[0], c[1], from), f1 = loft_acc_lerp(c[1], c[2], from),
                   f2 = loft_acc_lerp(c[2], c[3], from), g0 = loft_acc_lerp(f0, f1, from),
                   g1 = loft_acc_lerp(f1, f2, from);
    const loft_acc t0 = loft_acc_lerp(c[0], c[1], to), t1 = loft_acc_lerp(c[1], c[2], to),
                   t2 = loft_acc_lerp(c[2], c[3], to), u0 = loft_acc_lerp(t0, t1, to),
                   u1 = loft_acc_lerp(t1, t2, to);

    out[0] = loft_acc_lerp(g0, g1, from);
    out[1] = loft_acc_lerp(g0, g1, to);
    out[2] = loft_acc_lerp(loft_acc_lerp(f0, f1, to), loft_acc_lerp(f1, f2, to), to);
    out[3] = loft_acc_lerp(u0, u1, to);
}
#  define CUBIC 3
#else
#  define cut_cubic(c, from, to, out)
#  define CUBIC (LOFT_DEGREE_MAX + 1)
#endif

/* degree - k rows at `from`, then k rows at `to` in a copy. */
void loft_bernstein_sub(const loft_acc c[], unsigned degree, loft_unit from, loft_unit to,
                        loft_acc out[])
{
    loft_acc row[LOFT_DEGREE_MAX + 1], copy[LOFT_DEGREE_MAX + 1];

    if (degree == CUBIC) {
        cut_cubic(c, from, to, out);
        return;
    }
    for (unsigned k = 0; k <= degree; k++)
        row[k] = c[k];
    for (unsigned k = degree + 1; k-- > 0; ) {
        for (unsigned j = 0; j <= k; j++)
            copy[j] = row[j];
        out[k] = loft_bernstein_eval(copy, k, to);
        loft_bernstein_step(row, k, from);
    }
}

void loft_dyad_box_start(loft_dyad_box *box)
{
    for (unsigned k = 0; k < LOFT_DYAD_PARAMETERS; k++)
        box->n[k].k = box->n[k].level = 0;
    box->depth = 0;
}

void loft_dyad_box_halve(loft_dyad_box *box, unsigned along)
{
    box->by[box->depth++] = (uint8_t)along;
    box->n[along] = loft_dyad_half(box->n[along], 0);
}

bool loft_dyad_box_next(loft_dyad_box *box)
{
    for (; box->depth; box->depth--) {
        loft_dyad *n = &box->n[box->by[box->depth - 1]];
        if (n->k % 2 == 0) {
            n->k++;
            return true;
        }
        n->k /= 2;
        n->level--;
    }
    return false;
}
