/* lib/basis/residue_poly.h -- polynomials modulo a prime: quotients, common factors, resultants
 * SPDX-License-Identifier: MIT
 *
 * What an integer polynomial has modulo one prime says little; what it has modulo enough primes is
 * certain: see num/residue.h. Of a common factor, the degree modulo a prime is never too small.
 *
 *   range   degrees 0..LOFT_RESIDUE_DEGREE; coefficients below the prime
 *   error   none
 */
#ifndef LOFT_BASIS_RESIDUE_POLY_H
#define LOFT_BASIS_RESIDUE_POLY_H

#include "num/residue.h"    /* loft_residue */

LOFT_BEGIN_C

#define LOFT_RESIDUE_DEGREE 16

/* c[0] + c[1] x + .. + c[degree] x^degree */
typedef struct {
    uint32_t c[LOFT_RESIDUE_DEGREE + 2];
    unsigned degree;
} loft_residue_poly;

/* The derivative, 0 of a constant.
 *
 *   error   none
 *   cost    one product per coefficient
 */
loft_residue_poly loft_residue_poly_derivative(const loft_residue *r, const loft_residue_poly *q);

/* The greatest common factor, up to a constant.
 *
 *   range   not both 0
 *   error   none
 *   cost    about the product of the degrees, and an inverse for each step
 */
loft_residue_poly loft_residue_poly_gcd(const loft_residue *r, loft_residue_poly a,
                                        loft_residue_poly b);

/* a / b of coefficients a[0..n] and b[0..d]: the rest is left in a[0..d - 1].
 *
 *   shape   quotient[n - d + 1]
 *   range   d <= n, b[d] not 0
 *   error   none
 *   cost    an inverse and (n - d + 1) (d + 1) products
 */
void loft_residue_divide(const loft_residue *r, uint32_t a[], unsigned n, const uint32_t b[],
                         unsigned d, uint32_t quotient[]);

/* loft_residue_poly_derivative of the coefficients q[0..degree]; out[degree] is 0.
 *
 *   shape   out[degree + 1]
 *   error   none
 *   cost    one product per coefficient
 */
void loft_residue_derive(const loft_residue *r, const uint32_t q[], unsigned degree,
                         uint32_t out[]);

/* loft_residue_poly_gcd of n and m coefficients, the last of which are not 0; n = 0 or m = 0 is the
 * polynomial 0. Both are overwritten; the factor is in one of them.
 *
 *   shape   quotient[n or m, the larger one]
 *   range   not both 0
 *   error   none
 *   cost    as loft_residue_poly_gcd
 */
const uint32_t *loft_residue_gcd(const loft_residue *r, uint32_t a[], unsigned n, uint32_t b[],
                                 unsigned m, uint32_t quotient[], unsigned *degree);

/* Bezout's matrix (q(x) g(y) - q(y) g(x)) / (x - y) = sum B_ij x^i y^j, 0 <= i, j < m, row by row,
 * with rows and columns in reverse order. Its determinant is the resultant if q or g has the degree
 * m.
 *
 *   shape   q[m + 1], g[m + 1], out[m * m]
 *   error   none
 *   cost    2 m^2 products
 */
void loft_residue_bezout(const loft_residue *r, const uint32_t q[], const uint32_t g[], unsigned m,
                         uint32_t out[]);

/* A step of elimination: column i becomes 0 below row i.
 *
 *   shape   a[n * n], a[i * n + i] not 0
 *   error   none
 *   cost    (n - i)^2 products and an inverse
 */
void loft_residue_eliminate(const loft_residue *r, uint32_t a[], unsigned n, unsigned i);

/* The determinant of a matrix, which is overwritten.
 *
 *   shape   a[n * n]
 *   error   none
 *   cost    n^3 / 3 products and n inverses
 */
uint32_t loft_residue_determinant(const loft_residue *r, uint32_t a[], unsigned n);

LOFT_END_C

#endif
