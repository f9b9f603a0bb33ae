/* tests/lib/basis/test_residue_poly.c -- properties of lib/basis/residue_poly.h
 * SPDX-License-Identifier: MIT
 */
#include "basis/residue_poly.h"
#include "check.h"

/* Modulo a prime, a = q b + rest, and the factor in common divides both. */
static void quotients_and_common_factors_agree(arb *a)
{
    loft_residue r;
    loft_residue_poly f[3];

    loft_residue_start(&r, 30);
    CHECK(loft_residue_next(&r));
    for (unsigned k = 0; k < 3; k++) {
        f[k].degree = arb_below(a, 5);
        for (unsigned j = 0; j <= f[k].degree; j++)
            f[k].c[j] = arb_below(a, 1u << 15) + 1;
    }
    const loft_residue_poly u = loft_residue_poly_product(&r, &f[0], &f[2]),
                            v = loft_residue_poly_product(&r, &f[1], &f[2]);
    loft_residue_poly rest = u;
    const loft_residue_poly quotient = loft_residue_poly_divide(&r, &rest, &f[2]);
    CHECK(rest.degree == 0 && rest.c[0] == 0 && quotient.degree == f[0].degree);
    for (unsigned j = 0; j <= quotient.degree; j++)
        CHECK(quotient.c[j] == f[0].c[j]);
    const loft_residue_poly h = loft_residue_poly_gcd(&r, u, v);
    rest = f[2];
    CHECK(h.degree >= f[2].degree);
    rest = h;
    (void)loft_residue_poly_divide(&r, &rest, &f[2]);
    CHECK(rest.degree == 0 && rest.c[0] == 0);
}

/* The resultant of products of x - root is the product of all differences of roots. */
static void the_resultant_is_the_product_of_differences(arb *a)
{
    uint32_t matrix[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER], root[2][4], product = 1;
    const unsigned n = 1 + arb_below(a, 4);
    loft_residue r;
    loft_residue_poly f[2];

    loft_residue_start(&r, 30);
    CHECK(loft_residue_next(&r));
    for (unsigned k = 0; k < 2; k++) {
        f[k] = (loft_residue_poly) { { 1 }, 0 };
        for (unsigned j = 0; j < n; j++) {
            root[k][j] = arb_below(a, 40);
            const loft_residue_poly factor = { { loft_residue_sub(&r, 0, root[k][j]), 1 }, 1 };
            f[k] = loft_residue_poly_product(&r, &f[k], &factor);
        }
    }
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++)
            product = loft_residue_mul(&r, product, loft_residue_sub(&r, root[0][i], root[1][j]));
    loft_residue_bezout(&r, &f[0], &f[1], n, matrix);
    const uint32_t got = loft_residue_minor(&r, matrix, n);
    CHECK(got == product || got == loft_residue_sub(&r, 0, product));
}

int main(void)
{
    PROPERTY(quotients_and_common_factors_agree, 300);
    PROPERTY(the_resultant_is_the_product_of_differences, 300);
    return check_failures();
}
