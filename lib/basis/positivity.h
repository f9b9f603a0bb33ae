/* lib/basis/positivity.h -- where a Bernstein polynomial of any degree is positive, decided exactly
 * SPDX-License-Identifier: MIT
 *
 * Coefficients that are >= 0 suffice, but are not necessary. Here the answer is always found, also
 * where the polynomial touches 0 without crossing it, and where one LSB decides whether it does.
 * sign.h does the same for degree 2, faster, with the minimum.
 */
#ifndef LOFT_BASIS_POSITIVITY_H
#define LOFT_BASIS_POSITIVITY_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */

LOFT_BEGIN_C

typedef struct {
    bool nonnegative;       /* >= 0 on 0..1, ends included                                  */
    bool positive;          /* > 0 on 0..1, ends included                                   */
    int8_t roots;           /* the number of different roots in 0..1; -1: it is 0 everywhere */
} loft_positivity;

/* Decide on the polynomial with the Bernstein coefficients b[0..degree].
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; f32, f64: numbers that pass loft_exact_valid,
 *           otherwise LOFT_ERR_RANGE; *out is untouched after an error
 *   error   none
 *   cost    two determinants of each order up to the degree, modulo 27 primes (floats: 85), twice
 *           as many where roots are multiple: 10^5 products of 32 bits; q16: 6 kB of stack
 *   see     Gantmacher, The theory of matrices, ch. XV.11: the number of roots by Hankel forms;
 *           Knuth, The Art of Computer Programming, vol. 2, 4.3.2: signs by remainders
 */
enum loft_status loft_bernstein_positivity(const loft_real b[], unsigned degree,
                                           loft_positivity *out) LOFT_CHECKED;

LOFT_END_C

#endif
