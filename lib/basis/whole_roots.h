/* lib/basis/whole_roots.h -- all real roots in 0..1 of a polynomial with whole coefficients
 * SPDX-License-Identifier: MIT
 *
 * Roots are counted with their multiplicities and told apart exactly, also where the polynomial
 * touches 0. The coefficients may have thousands of bits, so they are given modulo one prime at a
 * time (num/residue.h): a resultant is then a determinant of small numbers.
 *
 *     loft_whole_poly w = { .degree = 9, .bits = 240, .residues = resultant, .data = &curves };
 *     loft_whole_root root[LOFT_RESIDUE_DEGREE];
 *     unsigned count;
 *     if (loft_whole_roots(&w, root, &count) == LOFT_OK)
 *         for (unsigned k = 0; k < count; k++)
 *             use(loft_whole_root_at(&root[k]), root[k].multiplicity);
 */
#ifndef LOFT_BASIS_WHOLE_ROOTS_H
#define LOFT_BASIS_WHOLE_ROOTS_H

#include "basis/residue_poly.h" /* LOFT_RESIDUE_DEGREE */
#include "num/sci.h"            /* loft_sci */

LOFT_BEGIN_C

#define LOFT_ROOT_LEVELS 52
#define LOFT_WHOLE_BITS  (8 * (LOFT_RESIDUE_REAL + 12))

/* The sum of c[j] t^j. */
typedef struct loft_whole_poly {
    unsigned degree;            /* at most; the highest coefficients may be 0 */
    unsigned bits;              /* every |c[j]| < 2^bits */
    /* The remainders of c[0..degree]. */
    void (*residues)(const struct loft_whole_poly *w, const loft_residue *r, uint32_t c[]);
    const void *data;
} loft_whole_poly;

typedef struct {
    uint64_t at;                /* the root is in at .. at + 1, in units of 2^-LOFT_ROOT_LEVELS */
    bool     exact;             /* it is `at` */
    uint8_t  multiplicity;
} loft_whole_root;

/* All different roots in 0..1, ends included, in increasing order: out[LOFT_RESIDUE_DEGREE].
 * LOFT_SINGULAR: the polynomial is 0 everywhere.
 *
 *   range   degree 1..LOFT_RESIDUE_DEGREE, bits 1..LOFT_WHOLE_BITS, otherwise LOFT_ERR_ARG.
 *           LOFT_ERR_RANGE: two roots, real or a pair near the axis, are closer than about 2^-52
 *   error   number and multiplicities: none   place: 2^-52
 *   cost    for each of up to about 60 parts, degree^2 products modulo each of (bits + 54 degree) /
 *           30 primes; a double root takes the greatest common factor modulo degree (bits + degree)
 *           / 15 primes
 *   stack   Cortex-M4 10,504   Cortex-M0+ 10,532   ATmega328P 10,408   + callback
 *   see     Collins and Akritas, Polynomial real root isolation using Descartes' rule of signs
 *           (1976)
 */
enum loft_status loft_whole_roots(const loft_whole_poly *w, loft_whole_root out[],
                                  unsigned *count) LOFT_CHECKED;

/* The middle of at .. at + 1, or `at` if that is exact.
 *
 *   error   2^-53
 *   cost    two quotients of num/sci.h
 */
loft_sci loft_whole_root_at(const loft_whole_root *x);

LOFT_END_C

#endif
