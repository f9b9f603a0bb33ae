/* lib/basis/residue_poly.c
 * SPDX-License-Identifier: MIT
 */
#include "basis/residue_poly.h"

void loft_residue_derive(const loft_residue *r, const uint32_t q[], unsigned degree, uint32_t out[])
{
    for (unsigned j = 1; j <= degree; j++)
        out[j - 1] = loft_residue_mul(r, q[j], j);
    out[degree] = 0;
}

loft_residue_poly loft_residue_poly_derivative(const loft_residue *r, const loft_residue_poly *q)
{
    loft_residue_poly d = { { 0 }, q->degree > 0 ? q->degree - 1 : 0 };

    loft_residue_derive(r, q->c, q->degree, d.c);
    return d;
}

void loft_residue_divide(const loft_residue *r, uint32_t a[], unsigned n, const uint32_t b[],
                         unsigned d, uint32_t quotient[])
{
    const uint32_t inverse = loft_residue_inverse(r, b[d]);

    for (unsigned k = n - d + 1; k-- > 0; ) {
        const uint32_t f = loft_residue_mul(r, a[k + d], inverse);
        quotient[k] = f;
        for (unsigned j = 0; j <= d; j++)
            a[k + j] = loft_residue_sub(r, a[k + j], loft_residue_mul(r, f, b[j]));
    }
}

/* How many of the coefficients are left without the highest ones that are 0. */
static unsigned trimmed(const uint32_t a[], unsigned count)
{
    while (count > 0 && a[count - 1] == 0)
        count--;
    return count;
}

const uint32_t *loft_residue_gcd(const loft_residue *r, uint32_t a[], unsigned n, uint32_t b[],
                                 unsigned m, uint32_t quotient[], unsigned *degree)
{
    for (;;) {
        if (n > 0 && n >= m) {
            if (m == 0)
                break;
            loft_residue_divide(r, a, n - 1, b, m - 1, quotient);
            n = trimmed(a, m - 1);
        }
        uint32_t *const swap = a;
        const unsigned count = n;
        a = b;
        b = swap;
        n = m;
        m = count;
    }
    *degree = n - 1;
    return a;
}

loft_residue_poly loft_residue_poly_gcd(const loft_residue *r, loft_residue_poly a,
                                        loft_residue_poly b)
{
    uint32_t quotient[LOFT_RESIDUE_DEGREE + 2];
    unsigned degree;
    const unsigned n = trimmed(a.c, a.degree + 1), m = trimmed(b.c, b.degree + 1);
    const bool first = loft_residue_gcd(r, a.c, n, b.c, m, quotient, &degree) == a.c;
    loft_residue_poly *const out = first ? &a : &b;

    out->degree = degree;
    return *out;
}

void loft_residue_bezout(const loft_residue *r, const uint32_t q[], const uint32_t g[], unsigned m,
                         uint32_t out[])
{
    for (unsigned i = 0; i < m; i++)        /* B_ij = B_(i-1)(j+1) + q_(j+1) g_i - q_i g_(j+1) */
        for (unsigned j = 0; j < m; j++) {
            const uint32_t one = loft_residue_mul(r, q[j + 1], g[i]),
                           two = loft_residue_mul(r, q[i], g[j + 1]);
            uint32_t *const b = &out[(m - 1 - i) * m + m - 1 - j];
            *b = loft_residue_sub(r, one, two);
            if (i > 0 && j + 1 < m)
                *b = loft_residue_add(r, *b, out[(m - i) * m + m - 2 - j]);
        }
}

void loft_residue_eliminate(const loft_residue *r, uint32_t a[], unsigned n, unsigned i)
{
    const uint32_t inverse = loft_residue_inverse(r, a[i * n + i]);

    for (unsigned l = i + 1; l < n; l++) {
        const uint32_t f = loft_residue_mul(r, a[l * n + i], inverse),
                       minus = loft_residue_sub(r, 0, f);
        for (unsigned j = i; j < n; j++)    /* below 2^62 + 2^31 */
            a[l * n + j] = (uint32_t)((a[l * n + j] + (uint64_t)minus * a[i * n + j]) % r->prime);
    }
}

uint32_t loft_residue_determinant(const loft_residue *r, uint32_t a[], unsigned n)
{
    uint32_t det = 1;

    for (unsigned i = 0; i < n; i++) {
        unsigned pivot = i;
        while (pivot < n && a[pivot * n + i] == 0)
            pivot++;
        if (pivot == n)
            return 0;
        for (unsigned j = i; j < n && pivot != i; j++) {
            const uint32_t swap = a[i * n + j];
            a[i * n + j] = a[pivot * n + j];
            a[pivot * n + j] = swap;
        }
        det = loft_residue_mul(r, pivot == i ? det : loft_residue_sub(r, 0, det), a[i * n + i]);
        loft_residue_eliminate(r, a, n, i);
    }
    return det;
}
