/* lib/surface/tensor/tensor_join.h -- how smoothly one tensor-product patch continues another
 * SPDX-License-Identifier: MIT
 *
 * The patch P ends at u = 1, and the patch Q begins there at u = 0. Across that edge they can meet
 * as
 *
 *     C0   P(1, v) = Q(0, v)
 *     C1   C0, and P_u(1, v) = Q_u(0, v)
 *     G1   C0, and the normals P_u x P_v and Q_u x P_v have the same direction along the whole edge
 *          and are nowhere 0
 *
 *     loft_tensor_join j;
 *     if (loft_tensor_join_init(&j, &first, &second) == LOFT_OK && j.g1)
 *         ...                                         // no crease
 *
 * For other edges apply loft_tensor_transpose and loft_tensor_sub_u (1 to 0 reverses) first.
 */
#ifndef LOFT_SURFACE_TENSOR_TENSOR_JOIN_H
#define LOFT_SURFACE_TENSOR_TENSOR_JOIN_H

#include "surface/tensor/tensor.h"     /* loft_tensor */

LOFT_BEGIN_C

typedef struct {
    bool c0, c1, g1;
} loft_tensor_join;

/* Decide how Q continues P. Normals are those in the first three axes.
 *
 *   range   degrees of at least 1 in u and the same degree n in v, otherwise LOFT_ERR_ARG;
 *           f32, f64: coordinates that loft_exact_valid accepts, otherwise LOFT_ERR_RANGE. All
 *           flags are then false
 *   error   none: the flags are decided on the coordinates as given. One exception: normals that
 *           cannot be told from 0 on a piece of the edge 2^-L long, with L = 24 for n <= 7, 23
 *           for n = 8 and 20 for n = 9 (q16; floats 24), count as 0: G1 is then false
 *   cost    about 60 n^3 exact products (num/exact.h) and 12 n^2 more for each piece of the edge,
 *           mostly one to four; not for an ISR
 *   stack   Cortex-M4 6,872   Cortex-M0+ 6,916   ATmega328P 6,832
 *   see     Farin, Curves and Surfaces for CAGD, ch. 21: geometric continuity of patches
 */
enum loft_status loft_tensor_join_init(loft_tensor_join *j, const loft_tensor *p,
                                       const loft_tensor *q) LOFT_CHECKED;

LOFT_END_C

#endif
