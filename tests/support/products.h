/* tests/support/products.h -- polynomials that are products of known factors
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_PRODUCTS_H
#define LOFT_TESTS_PRODUCTS_H

#include "basis/residue_poly.h"     /* LOFT_RESIDUE_DEGREE */

/* Coefficients, or Bernstein coefficients times binomials: both multiply alike. */
typedef struct {
    unsigned degree;
    int64_t c[LOFT_RESIDUE_DEGREE + 1];
} product;

/* Times a factor of degree n, given the same way. */
static inline void multiply(product *p, const int64_t f[], unsigned n)
{
    int64_t out[LOFT_RESIDUE_DEGREE + 1] = { 0 };

    for (unsigned i = 0; i <= p->degree; i++)
        for (unsigned j = 0; j <= n; j++)
            out[i + j] += p->c[i] * f[j];
    p->degree += n;
    for (unsigned i = 0; i <= p->degree; i++)
        p->c[i] = out[i];
}

#endif
