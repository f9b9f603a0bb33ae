/* lib/basis/positivity.h -- where a Bernstein polynomial of degree 0 to 128 is positive or convex,
 * decided exactly
 * SPDX-License-Identifier: MIT
 *
 * Coefficients that are >= 0 suffice, but are not necessary. Here the answer is always found, also
 * where the polynomial touches 0 without crossing it, and where one LSB decides whether it does.
 * sign.h does the same for degree 2, faster, with the minimum, and for convexity to degree 4.
 *
 *     static uint32_t work[LOFT_POSITIVITY_WORK(20)];
 *     loft_positivity p;
 *     status = loft_bernstein_positivity_in(b, 20, work, &p);
 */
#ifndef LOFT_BASIS_POSITIVITY_H
#define LOFT_BASIS_POSITIVITY_H

#include "basis/bernstein.h"    /* LOFT_DEGREE_MAX */
#include "num/residue.h"        /* LOFT_RESIDUE_REAL */

LOFT_BEGIN_C

#define LOFT_POSITIVITY_DEGREE 128

/* Bits of a degree n, of the coefficients of the first and the second polynomial, and of minors of
 * a polynomial with coefficients of c bits; the number of primes (positivity.c has the proof). */
#define LOFT_POSITIVITY_LOG(n)                                                                     \
    ((n) < 8 ? 3u : (n) < 16 ? 4u : (n) < 32 ? 5u : (n) < 64 ? 6u : (n) < 128 ? 7u : 8u)
#define LOFT_POSITIVITY_FIRST(n)   ((unsigned)LOFT_RESIDUE_REAL + (n) + 1u)
#define LOFT_POSITIVITY_SECOND(n)                                                                  \
    (LOFT_POSITIVITY_FIRST(n) + (n) + (LOFT_POSITIVITY_LOG(n) + 1u) / 2u)
#define LOFT_POSITIVITY_BITS(n, c)                                                                 \
    ((uint32_t)(n) * (2u * (c) + 2u * LOFT_POSITIVITY_LOG(n) + 1u +                                \
                      (LOFT_POSITIVITY_LOG(n) + 1u) / 2u) + 2u)
#define LOFT_POSITIVITY_ROOM(n) (LOFT_POSITIVITY_BITS(n, LOFT_POSITIVITY_SECOND(n)) / 30u + 1u)

/* The numbers of memory that a polynomial of degree n takes, n = 0..128: in q16 3.6 kB at degree 9,
 * 69 kB at 32, 418 kB at 64 and 2.8 MB at 128, in floats 8, 123 and 633 kB and 3.6 MB. */
#define LOFT_POSITIVITY_WORK(n)                                                                    \
    (LOFT_POSITIVITY_ROOM(n) * (2u * (n) + 1u) + 2u * (uint32_t)(n) * (n) + 6u * ((n) + 1u))

typedef struct {
    bool nonnegative;       /* >= 0 on 0..1, ends included                                  */
    bool positive;          /* > 0 on 0..1, ends included                                   */
    int16_t roots;          /* the number of different roots in 0..1; -1: it is 0 everywhere */
} loft_positivity;

/* Decide on the polynomial with the Bernstein coefficients b[0..degree].
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; f32, f64: numbers that pass loft_exact_valid,
 *           otherwise LOFT_ERR_RANGE; *out is untouched after an error
 *   error   none
 *   cost    for each of 29 primes (floats: 87), where roots are multiple of 36 (94) more: two
 *           eliminations, degree^3 / 3 products of 32 bits each, and n^4 / 12 more where n minors
 *           in a row are 0
 *   stack   Cortex-M4 4,384   Cortex-M0+ 4,360   ATmega328P 4,074
 *   see     Gantmacher, The theory of matrices, ch. XV.11: the number of roots by Hankel forms;
 *           Knuth, The Art of Computer Programming, vol. 2, 4.3.2: signs by remainders
 */
enum loft_status loft_bernstein_positivity(const loft_real b[], unsigned degree,
                                           loft_positivity *out) LOFT_CHECKED;

/* The same to degree 128, in memory of the caller.
 *
 *   shape   work[LOFT_POSITIVITY_WORK(degree)]
 *   range   degree 0..128; otherwise as loft_bernstein_positivity
 *   error   none
 *   cost    primes at degrees 32, 64, 128: 156, 455, 1464 (floats: 363, 869, 2292), where roots
 *           are multiple 231, 745, 2590 (438, 1159, 3418) more; on a host 0.04, 0.7, 13 s in q16
 *           and 0.12, 1.4, 22 s in floats, with multiple roots three times that
 */
enum loft_status loft_bernstein_positivity_in(const loft_real b[], unsigned degree, uint32_t work[],
                                              loft_positivity *out) LOFT_CHECKED;

/* Decide whether the polynomial is convex on 0..1, and whether its control polygon (`net`) is,
 * which is sufficient. To degree 4, loft_bernstein_convex of sign.h is faster.
 *
 *   shape   work[LOFT_POSITIVITY_WORK(degree)]
 *   range   as loft_bernstein_positivity_in; *net, *polynomial are untouched after an error
 *   error   none
 *   cost    `degree` exact sums; if `net` is false, that of loft_bernstein_positivity_in
 */
enum loft_status loft_bernstein_convex_in(const loft_real b[], unsigned degree, uint32_t work[],
                                          bool *net, bool *polynomial) LOFT_CHECKED;

LOFT_END_C

#endif
