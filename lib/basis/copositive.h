/* lib/basis/copositive.h -- whether a quadratic form is >= 0 for nonnegative variables, exactly
 * SPDX-License-Identifier: MIT
 *
 * A symmetric matrix M is copositive if x^T M x >= 0 for all x >= 0. Every positive semidefinite
 * matrix is copositive, every matrix without negative entries is, and many others are. Whether a
 * quadratic polynomial is nonnegative on an interval, a triangle or a tetrahedron is this question
 * with 2, 3 and 4 variables.
 */
#ifndef LOFT_BASIS_COPOSITIVE_H
#define LOFT_BASIS_COPOSITIVE_H

#include "num/num.h"    /* loft_real */

LOFT_BEGIN_C

#define LOFT_COPOSITIVE_MAX 6

/* True if the matrix of order n is copositive.
 *
 *   shape   m: the upper triangle by rows, m11 m12 .. m1n m22 .. mnn: n (n + 1) / 2 numbers
 *   range   n = 1..6, otherwise LOFT_ERR_ARG; f32, f64: numbers that pass loft_exact_valid,
 *           otherwise LOFT_ERR_RANGE. *copositive is untouched after an error
 *   error   none
 *   cost    192 exact products for the determinant of order 6, 80 for each of its 21 cofactors,
 *           which are needed where it is negative; less for the 62 submatrices; not for an ISR
 *   stack   Cortex-M4 4,304   Cortex-M0+ 4,372   ATmega328P 4,282
 *   see     Hadeler, On copositive matrices, Linear Algebra and its Applications 49 (1983)
 */
enum loft_status loft_matrix_copositive(const loft_real m[], unsigned n,
                                        bool *copositive) LOFT_CHECKED;

LOFT_END_C

#endif
