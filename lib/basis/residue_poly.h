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
#define LOFT_RESIDUE_ORDER  9

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

/* Lower the degree until the coefficient of the highest power is not 0.
 *
 *   error   none
 *   cost    one test per coefficient
 */
void loft_residue_poly_trim(loft_residue_poly *q);

/* a / b; what remains is left in a.
 *
 *   range   b->c[b->degree] not 0
 *   error   none
 *   cost    an inverse and (degree of a - degree of b + 1) (degree of b + 1) products
 */
loft_residue_poly loft_residue_poly_divide(const loft_residue *r, loft_residue_poly *a,
                                           const loft_residue_poly *b);

/* The greatest common factor, up to a constant.
 *
 *   range   both trimmed, not both 0
 *   error   none
 *   cost    about the product of the degrees, and an inverse for each step
 */
loft_residue_poly loft_residue_poly_gcd(const loft_residue *r, loft_residue_poly a,
                                        loft_residue_poly b);

/* a b.
 *
 *   range   the degree of the product is at most LOFT_RESIDUE_DEGREE + 1
 *   error   none
 *   cost    one product per pair of coefficients
 */
loft_residue_poly loft_residue_poly_product(const loft_residue *r, const loft_residue_poly *a,
                                            const loft_residue_poly *b);

/* Bezout's matrix (q(x) g(y) - q(y) g(x)) / (x - y) = sum B_ij x^i y^j, 0 <= i, j < m, with rows
 * and columns in reverse order. Its determinant is the resultant if q or g has the degree m.
 *
 *   range   both degrees <= m = 1..LOFT_RESIDUE_ORDER; coefficients up to c[m] are read
 *   error   none
 *   cost    2 m^3 / 3 products
 */
void loft_residue_bezout(const loft_residue *r, const loft_residue_poly *q,
                         const loft_residue_poly *g, unsigned m,
                         uint32_t out[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER]);

/* The determinant of the first k rows and columns.
 *
 *   range   k = 0..LOFT_RESIDUE_ORDER
 *   error   none
 *   cost    k^3 / 3 products and k inverses
 */
uint32_t loft_residue_minor(const loft_residue *r,
                            uint32_t matrix[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER], unsigned k);

LOFT_END_C

#endif
