/* lib/geom/vec_exact.h -- differences of points as vectors of exact numbers, their dot and cross
 * products
 * SPDX-License-Identifier: MIT
 *
 * Which side of a plane a point lies on is the sign of a sum of products of differences of
 * coordinates. These are the steps to it, without rounding:
 *
 *     loft_exact a[3], b[3], n[3], x[3];
 *     loft_vec_exact_sub(&p1, &p0, 3, a);
 *     loft_vec_exact_sub(&p2, &p0, 3, b);
 *     loft_vec_exact_cross(a, b, n);
 *     loft_vec_exact_sub(&point, &p0, 3, x);
 *     const int side = loft_exact_sign(loft_vec_exact_dot(n, x, 3));
 *
 * Axes beyond LOFT_AXES are 0. Differences carry the factor 2^LOFT_EXACT_REAL, products the product
 * of their factors. The caller of a product proves that the bits suffice (num/exact.h).
 */
#ifndef LOFT_GEOM_VEC_EXACT_H
#define LOFT_GEOM_VEC_EXACT_H

#include "geom/vec.h"   /* loft_vec */
#include "num/exact.h"  /* loft_exact */

LOFT_BEGIN_C

/* True if the first `axes` coordinates of all points are represented exactly: always in q16, never
 * for nan. */
bool loft_vec_exact_valid(const loft_vec p[], unsigned count, int axes);

/* One coordinate of a - b.
 *
 *   range   valid points, any axis from 0
 *   error   none
 *   cost    one pass over the limbs
 */
loft_exact loft_vec_exact_sub_axis(const loft_vec *a, const loft_vec *b, int axis);

/* The first `axes` coordinates of a - b.
 *
 *   range   as sub_axis
 *   error   none
 *   cost    one pass over the limbs per axis
 */
void loft_vec_exact_sub(const loft_vec *a, const loft_vec *b, int axes, loft_exact out[]);

/* The dot product of the first `axes` components.
 *
 *   error   none
 *   cost    one product per axis
 */
loft_exact loft_vec_exact_dot(const loft_exact a[], const loft_exact b[], int axes);

/* The cross product; `out` must be neither a nor b.
 *
 *   error   none
 *   cost    6 products
 */
void loft_vec_exact_cross(const loft_exact a[3], const loft_exact b[3], loft_exact out[3]);

LOFT_END_C

#endif
