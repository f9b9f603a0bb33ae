/* lib/polygon/jet.h -- the value, first and second derivatives of a function of a point in the
 * plane
 * SPDX-License-Identifier: MIT
 *
 * Sums, products and quotients of jets give those of their derivatives (automatic differentiation).
 * So a formula in the coordinates of a point also gives its derivatives, exact up to rounding.
 */
#ifndef LOFT_POLYGON_JET_H
#define LOFT_POLYGON_JET_H

#include "num/sci.h"    /* loft_sci */

LOFT_BEGIN_C

/* f and its derivatives by x and y. */
typedef struct {
    loft_sci f, x, y, xx, xy, yy;
} loft_jet;

/* A constant: all derivatives are 0.
 *
 *   error   none
 *   cost    96 bytes written in q16, 48 in floats
 */
loft_jet loft_jet_of(loft_sci c);

/* a + b, a - b, a b, a / b where b is not 0, the root of a > 0.
 *
 *   error   each component: that of its sums and products of loft_sci
 *   cost    sum and difference 6 sums; product 15 products and 11 sums; quotient 9, 11 and 6
 *           quotients; root 8, 3, 5 and a root
 */
loft_jet loft_jet_add(const loft_jet *a, const loft_jet *b);
loft_jet loft_jet_sub(const loft_jet *a, const loft_jet *b);
loft_jet loft_jet_mul(const loft_jet *a, const loft_jet *b);
loft_jet loft_jet_div(const loft_jet *a, const loft_jet *b);
loft_jet loft_jet_sqrt(const loft_jet *a);

/* c a.
 *
 *   error   one rounding of each component
 *   cost    6 products
 */
loft_jet loft_jet_scale(const loft_jet *a, loft_sci c);

/* a^k; 1 for k = 0.
 *
 *   error   as mul, 2 k times
 *   cost    at most 2 log2 k + 1 of mul
 */
loft_jet loft_jet_pow(const loft_jet *a, unsigned k);

LOFT_END_C

#endif
