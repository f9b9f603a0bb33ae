/* tests/lib/basis/test_residue_poly.c -- properties of lib/basis/residue_poly.h
 * SPDX-License-Identifier: MIT
 */
#include "basis/residue_poly.h"
#include "check.h"

static loft_residue_poly product_of(const loft_residue *r, const loft_residue_poly *a,
                                    const loft_residue_poly *b)
{
    loft_residue_poly c = { { 0 }, a->degree + b->degree };

    for (unsigned i = 0; i <= a->degree; i++)
        for (unsigned j = 0; j <= b->degree; j++)
            c.c[i + j] = loft_residue_add(r, c.c[i + j], loft_residue_mul(r, a->c[i], b->c[j]));
    return c;
}

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
    const loft_residue_poly u = product_of(&r, &f[0], &f[2]), v = product_of(&r, &f[1], &f[2]);
    loft_residue_poly rest = u, quotient;
    loft_residue_divide(&r, rest.c, rest.degree, f[2].c, f[2].degree, quotient.c);
    for (unsigned j = 0; j < f[2].degree; j++)
        CHECK(rest.c[j] == 0);
    for (unsigned j = 0; j <= f[0].degree; j++)
        CHECK(quotient.c[j] == f[0].c[j]);
    loft_residue_poly h = loft_residue_poly_gcd(&r, u, v);
    CHECK(h.degree >= f[2].degree);
    loft_residue_divide(&r, h.c, h.degree, f[2].c, f[2].degree, quotient.c);
    for (unsigned j = 0; j < f[2].degree; j++)
        CHECK(h.c[j] == 0);
}

/* The resultant of products of x - root is the product of all differences of roots. */
static void the_resultant_is_the_product_of_differences(arb *a)
{
    uint32_t matrix[4 * 4], root[2][4], product = 1;
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
            f[k] = product_of(&r, &f[k], &factor);
        }
    }
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++)
            product = loft_residue_mul(&r, product, loft_residue_sub(&r, root[0][i], root[1][j]));
    loft_residue_bezout(&r, f[0].c, f[1].c, n, matrix);
    const uint32_t got = loft_residue_determinant(&r, matrix, n);
    CHECK(got == product || got == loft_residue_sub(&r, 0, product));
}

int main(void)
{
    PROPERTY(quotients_and_common_factors_agree, 300);
    PROPERTY(the_resultant_is_the_product_of_differences, 300);
    return check_failures();
}
