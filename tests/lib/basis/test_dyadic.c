/* tests/lib/basis/test_dyadic.c -- properties of lib/basis/dyadic.h
 * SPDX-License-Identifier: MIT
 */
#include "basis/bernstein.h"
#include "basis/dyadic.h"
#include "support/exact.h"          /* exact_blossom, exact_unit, CHECK_EXACT */

/* For any choice of halvings, the leaves lie end to end from 0 to 1. */
static void leaves_lie_end_to_end(arb *a)
{
    loft_dyad n = { 0, 0 };
    loft_unit end = 0;
    uint32_t left = 200;

    do {
        while (left && n.level < LOFT_DYAD_LEVELS && arb_below(a, 5) < 3) {
            n = loft_dyad_half(n, 0);
            left--;
        }
        CHECK(!(loft_dyad_from(n) < end) && !(end < loft_dyad_from(n)));
        CHECK(loft_dyad_from(n) < loft_dyad_to(n));
        end = loft_dyad_to(n);
    } while (loft_dyad_next(&n));
    CHECK_EXACT(exact_unit(end), 1, 0);
}

static void halves_make_the_whole(arb *a)
{
    const uint8_t level = (uint8_t)arb_below(a, LOFT_DYAD_LEVELS);
    const loft_dyad n = { arb_below(a, (uint32_t)1 << level), level };
    const loft_dyad left = loft_dyad_half(n, 0), right = loft_dyad_half(n, 1);

    CHECK_EXACT(exact_unit(loft_dyad_from(left)), exact_unit(loft_dyad_from(n)), 0);
    CHECK_EXACT(exact_unit(loft_dyad_to(left)), exact_unit(loft_dyad_from(right)), 0);
    CHECK_EXACT(exact_unit(loft_dyad_to(right)), exact_unit(loft_dyad_to(n)), 0);
    CHECK_EXACT(exact_unit(loft_dyad_at(left, LOFT_UNIT(1))), exact_unit(loft_dyad_to(left)), 0);
}

static void a_parameter_of_a_piece_is_rounded_once(arb *a)
{
    const uint8_t level = (uint8_t)arb_below(a, LOFT_DYAD_LEVELS + 1);
    const loft_dyad n = { arb_below(a, (uint32_t)1 << level), level };
    const loft_unit t = arb_unit(a);

    CHECK_EXACT(exact_unit(loft_dyad_at(n, t)), (n.k + exact_unit(t)) / ((uint32_t)1 << level),
                BY_NUM(0x1.01p-25L, 0x1.01p-25L, 0x1p-51L));
}

static void a_part_is_the_blossoms(arb *a)
{
    const unsigned degree = arb_below(a, LOFT_DEGREE_MAX + 1);
    const loft_unit from = arb_unit(a), to = arb_unit(a);
    loft_acc c[LOFT_DEGREE_MAX + 1], out[LOFT_DEGREE_MAX + 1];
    long double x[LOFT_DEGREE_MAX + 1], at[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= degree; k++) {
        c[k] = loft_to_acc(arb_real(a, 32767));
        x[k] = exact_acc(c[k]);
    }
    loft_bernstein_sub(c, degree, from, to, out);
    for (unsigned k = 0; k <= degree; k++) {
        for (unsigned j = 0; j < degree; j++)
            at[j] = exact_unit(j < degree - k ? from : to);
        CHECK_EXACT(exact_acc(out[k]), exact_blossom(x, degree, at),
                    degree * BY_NUM(0x1p-33L, 3 * 0x1p-37L, 3 * 0x1p-37L));
    }
}

/* Whatever was there before. */
static void a_box_starts_whole(arb *a)
{
    loft_dyad_box box;
    uint8_t *byte = (uint8_t *)&box;

    for (unsigned n = 0; n < sizeof box; n++)
        byte[n] = (uint8_t)arb_next(a);
    loft_dyad_box_start(&box);
    CHECK(box.depth == 0);
    for (unsigned k = 0; k < LOFT_DYAD_PARAMETERS; k++)
        CHECK(box.n[k].k == 0 && box.n[k].level == 0);
}

int main(void)
{
    PROPERTY(leaves_lie_end_to_end,                  2000);
    PROPERTY(halves_make_the_whole,                  2000);
    PROPERTY(a_parameter_of_a_piece_is_rounded_once, 2000);
    PROPERTY(a_part_is_the_blossoms,                 2000);
    PROPERTY(a_box_starts_whole, 20);
    return check_failures();
}
