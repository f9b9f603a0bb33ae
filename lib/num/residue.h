/* lib/num/residue.h -- whether a polynomial of the given numbers is exactly 0, by remainders in 32
 * bits SPDX-License-Identifier: MIT
 *
 * Whether a surface has a normal at a point is a determinant of values of high degree: thousands of
 * bits. An integer below 2^bits is 0 if and only if its remainders are, for primes whose product is
 * 2^bits or more. So the same formula is evaluated modulo one prime after the other, until one
 * remainder is not 0; in most cases that is the first.
 *
 *     loft_residue r;
 *     for (loft_residue_start(&r, bits); loft_residue_next(&r); )
 *         if (formula(&r) != 0)
 *             return false;                   // not 0
 *     return true;                            // exactly 0
 *
 * Numbers are those of num/exact.h: a coordinate times 2^LOFT_EXACT_REAL, a parameter times
 * 2^LOFT_EXACT_UNIT. A formula must be homogeneous in them, so 1 - t is loft_residue_one - t. It
 * may divide where the divisor is not 0 modulo this prime; otherwise call loft_residue_skip.
 *
 *   range   num/exact.h
 *   error   none
 *   cost    a product of 32 bits and a remainder of 64 by 32 per operation
 */
#ifndef LOFT_NUM_RESIDUE_H
#define LOFT_NUM_RESIDUE_H

#include "num/exact.h"      /* loft_exact */

LOFT_BEGIN_C

/* Bits of a coordinate and of a parameter in 0..1, for the bound of a formula. */
#define LOFT_RESIDUE_REAL (LOFT_EXACT_REAL == 16 ? 32 : 129)
#define LOFT_RESIDUE_UNIT (LOFT_EXACT_UNIT + 1)

typedef struct {
    uint32_t prime;             /* between 2^30 and 2^31 */
    unsigned left;              /* primes to come */
} loft_residue;

/* Before the first prime, for integers below 2^bits in magnitude. */
void loft_residue_start(loft_residue *r, uint32_t bits);

/* The next prime, the first one included. False after the last one. */
bool loft_residue_next(loft_residue *r);

/* This prime does not count; there will be one more. */
void loft_residue_skip(loft_residue *r);

/* The remainder of a coordinate, a parameter, the parameter 1, and any exact number. */
uint32_t loft_residue_real(const loft_residue *r, loft_real a);
uint32_t loft_residue_unit(const loft_residue *r, loft_unit t);
uint32_t loft_residue_one(const loft_residue *r);
uint32_t loft_residue_exact(const loft_residue *r, const loft_exact *x);

/* a + b, a - b, a b. */
uint32_t loft_residue_add(const loft_residue *r, uint32_t a, uint32_t b);
uint32_t loft_residue_sub(const loft_residue *r, uint32_t a, uint32_t b);
uint32_t loft_residue_mul(const loft_residue *r, uint32_t a, uint32_t b);

/* 1 / a, a != 0. */
uint32_t loft_residue_inverse(const loft_residue *r, uint32_t a);

/* An integer by its remainders, prime after prime: digits in the radices prime[0], prime[1] ..
 *
 *     radix = loft_residue_radix(&r, prime, at);
 *     digit[at] = loft_residue_digit(&r, prime, digit, at, radix, remainder);
 *     prime[at++] = r.prime;
 *     ..
 *     sign = loft_residue_sign(prime, digit, at);
 *
 *   range   twice the magnitude of the integer is below the product of the primes
 *   error   none
 *   cost    radix: `at` products and an inverse; digit: 2 at products
 *   see     Knuth, The Art of Computer Programming, vol. 2, 4.3.2
 */
uint32_t loft_residue_radix(const loft_residue *r, const uint32_t prime[], unsigned at);
uint32_t loft_residue_digit(const loft_residue *r, const uint32_t prime[], const uint32_t digit[],
                            unsigned at, uint32_t radix, uint32_t remainder);
int      loft_residue_sign(const uint32_t prime[], const uint32_t digit[], unsigned primes);

/* True if the three vectors of `size` numbers are linearly dependent: all minors of order 3 are
 * 0. */
bool loft_residue_dependent(const loft_residue *r, uint32_t v[][3], unsigned size);

LOFT_END_C

#endif
