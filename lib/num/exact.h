/* lib/num/exact.h -- integers wide enough that no decision depends on rounding
 * SPDX-License-Identifier: MIT
 *
 * Whether three points turn left, whether a curve has a cusp, whether two edges are parallel: such
 * answers are signs of sums of products of coordinates. Here they are exact in every number type. A
 * coordinate x becomes the integer x * 2^LOFT_EXACT_REAL, a parameter t the integer t *
 * 2^LOFT_EXACT_UNIT:
 *
 *     const loft_exact ax = loft_exact_sub(loft_exact_from_real(p1.axis[0]),
 *                                          loft_exact_from_real(p0.axis[0]));
 *     ...
 *     const int turn = loft_exact_sign(loft_exact_det(ax, ay, bx, by));
 *
 * No number may exceed LOFT_EXACT_BITS; the caller of a product proves that it does not. With
 * coordinates below 2^R (R = 31 in q16, 128 in floats) a sum of m products of d differences each is
 * below m * 2^(d (R + 1)): thirteen factors fit in q16, eight in floats.
 *
 *   range   q16: any coordinate
 *           f32, f64: 0, and multiples of 2^-108 below 2^20 in magnitude: these are all doubles
 *           from 1.4e-17 and all floats from 2.6e-26 to 1048575; loft_exact_valid checks a number
 *   error   none unless stated
 *   cost    56 bytes per number in q16, 136 in floats. A product takes about 100 32-bit products in
 *           q16 and 600 in floats, fewer if the first factor is small and >= 0; a sum takes one
 *           pass. Stack in q16: up to 1 kB for a quotient, 0.5 kB for anything else. Not for an ISR
 *   see     Knuth, The Art of Computer Programming, vol. 2, 4.3.1: the classical algorithms
 */
#ifndef LOFT_NUM_EXACT_H
#define LOFT_NUM_EXACT_H

#include "num/num.h"    /* loft_real, loft_unit, loft_acc */

LOFT_BEGIN_C

#if LOFT_NUM == LOFT_Q16
#  define LOFT_EXACT_LIMBS 14
#  define LOFT_EXACT_REAL  16
#  define LOFT_EXACT_UNIT  24
#else
#  define LOFT_EXACT_LIMBS 34
#  define LOFT_EXACT_REAL  108
#  define LOFT_EXACT_UNIT  53
#endif

#define LOFT_EXACT_BITS (32 * LOFT_EXACT_LIMBS - 1)     /* |x| < 2^LOFT_EXACT_BITS */

/* An integer in two's complement, lowest limb first. */
typedef struct {
    uint32_t limb[LOFT_EXACT_LIMBS];
} loft_exact;

/* True if this coordinate is represented exactly: always in q16, never for nan. */
bool       loft_exact_valid(loft_real a);

/* x * 2^LOFT_EXACT_REAL of a valid coordinate; an integer unchanged. */
loft_exact loft_exact_from_real(loft_real a);
loft_exact loft_exact_from_int(int32_t i);

/* t * 2^LOFT_EXACT_UNIT.
 *
 *   range   q16: any   f32, f64: -1024..1024
 *   error   q16: none   f32, f64: none for multiples of 2^-53; any other t is rounded to one
 */
loft_exact loft_exact_from_unit(loft_unit t);

/* -a, a + b, a - b, a b. */
loft_exact loft_exact_neg(loft_exact a);
loft_exact loft_exact_add(loft_exact a, loft_exact b);
loft_exact loft_exact_sub(loft_exact a, loft_exact b);
loft_exact loft_exact_mul(loft_exact a, loft_exact b);

/* a d - b c, the determinant of the rows (a, b) and (c, d). */
loft_exact loft_exact_det(loft_exact a, loft_exact b, loft_exact c, loft_exact d);

/* The sign -1, 0 or 1 of a, and of a - b. */
int        loft_exact_sign(loft_exact a);
int        loft_exact_compare(loft_exact a, loft_exact b);

/* The smallest k with |a| < 2^k. */
int        loft_exact_bits(loft_exact a);

/* a * 2^s; a negative s rounds to nearest, ties upward.
 *
 *   range   loft_exact_bits(a) + s <= LOFT_EXACT_BITS
 */
loft_exact loft_exact_shift(loft_exact a, int s);

/* a / b rounded to nearest, ties away from 0.
 *
 *   range   b != 0, |b| < 2^(LOFT_EXACT_BITS - 1)
 *   cost    one pass over the limbs for each bit of the result
 */
loft_exact loft_exact_div(loft_exact a, loft_exact b);

/* The largest r with r^2 <= a; 0 for a <= 0.
 *
 *   cost    two passes over the limbs for each bit of the result
 */
loft_exact loft_exact_root(loft_exact a);

#define LOFT_EXACT_HYPOT 64

/* The length of the vector x[0..n-1], times 2^LOFT_EXACT_HYPOT, rounded down.
 *
 *   range   n = 0..6; 2 * (bits of the largest) + 131 <= LOFT_EXACT_BITS
 *   error   2^-64 of the result: less than 1, and a nonzero result is at least 2^64
 *   cost    n products and a root
 */
loft_exact loft_exact_hypot(const loft_exact x[], int n);

/* a / b * 2^s as a loft_acc. Returns false, and leaves *out untouched, if it does not fit.
 *
 *   range   b != 0; every result below 2^30 (q16) or 2^999 (floats) fits; below 2^-1000 it is 0
 *   error   q16: 2^-33 + 2^-60   f32, f64: 0.51 ulp of double
 *   cost    about 64 rounds of loft_exact_div
 */
bool       loft_exact_quot(loft_exact a, loft_exact b, int s, loft_acc *out) LOFT_CHECKED;

/* The same as a coordinate. Returns false, and leaves *out untouched, if it does not fit one.
 *
 *   range   b != 0
 *   error   that of loft_exact_quot, and q16: 1/2 LSB   f32: 1/2 ulp   f64: none
 *   cost    as loft_exact_quot
 */
bool       loft_exact_quot_real(loft_exact a, loft_exact b, int s, loft_real *out) LOFT_CHECKED;

LOFT_END_C

#endif
