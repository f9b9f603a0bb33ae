/* host-tools/base/least.h -- least squares in long double, for systems whose columns are nearly
 * dependent
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_LEAST_H
#define LOFT_LEAST_H

#include <stddef.h>

/* malloc; on failure, prints one line and ends the program. */
void *least_room(size_t bytes);

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

#endif
