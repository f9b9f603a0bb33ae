/* host-tools/base/least.h -- least squares, for systems whose columns are nearly
 * dependent
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_LEAST_H
#define LOFT_LEAST_H

#include <stddef.h>

/* Find the x that minimizes |A x - b|, for several b at once, by Householder reflections, with the
 * longest remaining column first. Columns are scaled to a largest entry of 1. Columns that are then
 * shorter than `share` of the first one are left out (x = 0). So nearly dependent columns do not
 * get large coefficients that cancel.
 *
 *   shape   a[(columns + rights) * rows], column after column, the right-hand sides last:
 *           overwritten; x[rights * columns]
 *   cost    2 rows (columns + rights) columns products; the number of columns used is the result
 *   see     Golub, Van Loan, Matrix Computations, 5.4.2 */
size_t least_squares(long double a[], size_t rows, size_t columns, size_t rights, long double share,
                     long double x[]);

/* Find the x that minimizes |A x - b|^2 + damping^2 |x|^2, for several b at once, in double. The
 * damping, above 0, keeps x small where columns are nearly dependent.
 *
 *   shape   a[(columns + rights) * (rows + columns)], column after column, the right-hand sides
 *           last; each is followed by `columns` zeros; overwritten; x[rights * columns]
 *   cost    2 rows (columns + rights) columns products, some twenty times as fast as in long double
 *   see     Golub, Van Loan, Matrix Computations, 5.2.2, 6.1.4 */
void least_damped(double a[], size_t rows, size_t columns, size_t rights, double damping,
                  double x[]);

#endif
