/* tests/lib/surface/tensor/test_tensor_part.c -- properties of lib/surface/tensor/tensor_part.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_acc; CHECK, PROPERTY */
#include "surface/tensor/tensor_part.h"

/* Parts at any level have the values of the whole. */
static void parts_are_those_of_the_patch(arb *a)
{
    loft_sci_net x = { .m = arb_below(a, 4), .n = arb_below(a, 4) }, y;
    loft_dyad_box part;

    for (unsigned i = 0; i <= x.m; i++)
        for (unsigned j = 0; j <= x.n; j++)
            x.c[i][j] = loft_sci_from_real(arb_real(a, 100));
    loft_dyad_box_start(&part);
    for (unsigned k = 1 + arb_below(a, 12); k > 0; k--) {
        loft_dyad_box_halve(&part, arb_below(a, 2));
        if (arb_below(a, 2))
            CHECK(loft_dyad_box_next(&part));
    }
    loft_sci_net_sub(&x, part.n, &y);
    const loft_sci u = loft_sci_power2(-2), v = loft_sci_power2(-1);
    const loft_sci got = loft_sci_net_deriv(&y, 0, 0, u, v);
    const loft_sci want = loft_sci_net_deriv(&x, 0, 0, loft_dyad_place(part.n[0], u),
                                             loft_dyad_place(part.n[1], v));
    loft_acc off = 0;
    CHECK(loft_sci_to_acc(loft_sci_sub(got, want), &off));
    CHECK(fabsl(exact_acc(off)) <= 100 * 0x1p-30L);
    unsigned more = 0;
    while (loft_dyad_box_next(&part) && more < 100)
        more++;
    CHECK(more < 100);
}

int main(void)
{
    PROPERTY(parts_are_those_of_the_patch, 200);
    return check_failures();
}
