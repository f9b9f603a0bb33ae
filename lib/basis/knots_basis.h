/* lib/basis/knots_basis.h -- B-splines and their derivatives at a place, wide, and as remainders
 * SPDX-License-Identifier: MIT
 *
 * knots.h evaluates a piece by lerps, which are rounded once. Derivatives of curves and surfaces
 * with weights multiply and divide: for these the B-splines are computed themselves, in numbers
 * with an exponent of their own (num/sci.h), and modulo a prime, to decide whether such an
 * expression is 0 (num/residue.h).
 */
#ifndef LOFT_BASIS_KNOTS_BASIS_H
#define LOFT_BASIS_KNOTS_BASIS_H

#include "basis/knots.h"    /* loft_knots */
#include "num/residue.h"    /* loft_residue */
#include "num/sci.h"        /* loft_sci */

LOFT_BEGIN_C

/* The k-th derivatives at u of the B-splines that are not 0 on `span`, those of the coefficients
 * span - degree .. span: out[degree + 1]. 0 for k > degree.
 *
 *   range   u within the span
 *   error   k = 0: 4 degree roundings of num/sci.h of each; a derivative that many of the sum of
 *           magnitudes it is the difference of
 *   cost    degree (degree + 1) products and quotients
 *   see     Piegl and Tiller, The NURBS Book, ch. 2: (2.5) and (2.7)
 */
void loft_knots_basis(const loft_knots *knots, unsigned span, loft_real u, unsigned k,
                      loft_sci out[]);

/* The same modulo a prime, times a constant; k = 0 or 1. False if the prime divides a difference of
 * knots.
 *
 *   range   as loft_knots_basis; knots and u pass loft_exact_valid
 *   error   none
 *   cost    degree (degree + 1) inverses modulo the prime
 */
bool loft_knots_basis_residue(const loft_knots *knots, unsigned span, loft_real u, unsigned k,
                              const loft_residue *r, uint32_t out[]) LOFT_CHECKED;

/* The bits of the common numerator of such B-splines, for loft_residue_start.
 *
 *   error   none: an upper bound
 *   cost    two products
 */
unsigned loft_knots_basis_bits(const loft_knots *knots);

LOFT_END_C

#endif
