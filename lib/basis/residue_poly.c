/* lib/basis/residue_poly.c
 * SPDX-License-Identifier: MIT
 */
#include "basis/residue_poly.h"

loft_residue_poly loft_residue_poly_derivative(const loft_residue *r, const loft_residue_poly *q)
{
    loft_residue_poly d = { { 0 }, q->degree > 0 ? q->degree - 1 : 0 };

    for (unsigned j = 1; j <= q->degree; j++)
        d.c[j - 1] = loft_residue_mul(r, q->c[j], j);
    return d;
}

static bool poly_is_zero(const loft_residue_poly *q) { return q->degree == 0 && q->c[0] == 0; }

void loft_residue_poly_trim(loft_residue_poly *q)
{
    while (q->degree > 0 && q->c[q->degree] == 0)
        q->degree--;
}

loft_residue_poly loft_residue_poly_divide(const loft_residue *r, loft_residue_poly *a,
                                           const loft_residue_poly *b)
{
    loft_residue_poly quotient = { { 0 }, 0 };
    const uint32_t inverse = loft_residue_inverse(r, b->c[b->degree]);

    if (a->degree < b->degree)
        return quotient;
    quotient.degree = a->degree - b->degree;
    for (unsigned k = quotient.degree + 1; k-- > 0; ) {
        const uint32_t f = loft_residue_mul(r, a->c[k + b->degree], inverse);
        quotient.c[k] = f;
        for (unsigned j = 0; j <= b->degree; j++)
            a->c[k + j] = loft_residue_sub(r, a->c[k + j], loft_residue_mul(r, f, b->c[j]));
    }
    loft_residue_poly_trim(a);
    return quotient;
}

loft_residue_poly loft_residue_poly_gcd(const loft_residue *r, loft_residue_poly a,
                                        loft_residue_poly b)
{
    while (!poly_is_zero(&b)) {
        (void)loft_residue_poly_divide(r, &a, &b);
        const loft_residue_poly swap = a;
        a = b;
        b = swap;
    }
    return a;
}

loft_residue_poly loft_residue_poly_product(const loft_residue *r, const loft_residue_poly *a,
                                            const loft_residue_poly *b)
{
    loft_residue_poly c = { { 0 }, a->degree + b->degree };

    for (unsigned i = 0; i <= a->degree; i++)
        for (unsigned j = 0; j <= b->degree; j++)
            c.c[i + j] = loft_residue_add(r, c.c[i + j], loft_residue_mul(r, a->c[i], b->c[j]));
    return c;
}

void loft_residue_bezout(const loft_residue *r, const loft_residue_poly *q,
                         const loft_residue_poly *g, unsigned m,
                         uint32_t out[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER])
{
    for (unsigned i = 0; i < m; i++)
        for (unsigned j = 0; j < m; j++) {
            uint32_t sum = 0;
            for (unsigned k = 0; k <= i && j + k + 1 <= m; k++) {
                const uint32_t one = loft_residue_mul(r, q->c[j + k + 1], g->c[i - k]);
                const uint32_t two = loft_residue_mul(r, q->c[i - k], g->c[j + k + 1]);
                sum = loft_residue_add(r, sum, loft_residue_sub(r, one, two));
            }
            out[m - 1 - i][m - 1 - j] = sum;
        }
}

uint32_t loft_residue_minor(const loft_residue *r,
                            uint32_t matrix[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER], unsigned k)
{
    uint32_t a[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER], det = 1;

    for (unsigned i = 0; i < k; i++)
        for (unsigned j = 0; j < k; j++)
            a[i][j] = matrix[i][j];
    for (unsigned i = 0; i < k; i++) {
        unsigned pivot = i;
        while (pivot < k && a[pivot][i] == 0)
            pivot++;
        if (pivot == k)
            return 0;
        for (unsigned j = i; j < k && pivot != i; j++) {
            const uint32_t swap = a[i][j];
            a[i][j] = a[pivot][j];
            a[pivot][j] = swap;
        }
        det = loft_residue_mul(r, pivot == i ? det : loft_residue_sub(r, 0, det), a[i][i]);
        const uint32_t inverse = loft_residue_inverse(r, a[i][i]);
        for (unsigned l = i + 1; l < k; l++) {
            const uint32_t f = loft_residue_mul(r, a[l][i], inverse);
            for (unsigned j = i; j < k; j++)
                a[l][j] = loft_residue_sub(r, a[l][j], loft_residue_mul(r, f, a[i][j]));
        }
    }
    return det;
}
