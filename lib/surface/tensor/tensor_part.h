/* lib/surface/tensor/tensor_part.h -- polynomials of two parameters, and their dyadic parts
 * SPDX-License-Identifier: MIT
 *
 * A search examines a part of 0..1 x 0..1 and drops it, or halves it along u (0) or v (1). The
 * parts are visited without a stack (basis/dyadic.h).
 *
 *     loft_dyad_box part;
 *     loft_dyad_box_start(&part);
 *     do {
 *         while (!is_done(part.n))
 *             loft_dyad_box_halve(&part, longer_along_u(&part) ? 0 : 1);
 *     } while (loft_dyad_box_next(&part));
 */
#ifndef LOFT_SURFACE_TENSOR_TENSOR_PART_H
#define LOFT_SURFACE_TENSOR_TENSOR_PART_H

#include "basis/dyadic.h"           /* loft_dyad_box */
#include "num/sci.h"                /* loft_sci */
#include "surface/tensor/tensor.h"  /* loft_tensor */

LOFT_BEGIN_C

/* The Bernstein coefficients of one coordinate, or of any polynomial of both parameters. */
typedef struct {
    unsigned m, n;
    loft_sci c[LOFT_DEGREE_MAX + 1][LOFT_DEGREE_MAX + 1];
} loft_sci_net;

/* The coefficients of a part, by u and by v.
 *
 *   error   (m + n) 3 roundings of num/sci.h, of the largest coefficient
 *   cost    (n + 1) m (m + 1) (m + 5) / 6 + (m + 1) n (n + 1) (n + 5) / 6 lerps
 *   see     Ramshaw, blossoming, as loft_bernstein_sub
 */
void loft_sci_net_sub(const loft_sci_net *x, const loft_dyad part[2], loft_sci_net *out);

/* The derivative of order a by u and b by v.
 *
 *   error   as loft_sci_deriv, twice
 *   cost    (m + 1) n (n + 1) / 2 + m (m + 1) / 2 lerps
 */
loft_sci loft_sci_net_deriv(const loft_sci_net *x, unsigned a, unsigned b, loft_sci u, loft_sci v);

/* The place in the whole patch of x (0..1) in a part: k + x over 2^level.
 *
 *   error   2 roundings
 *   cost    a sum and a quotient of num/sci.h
 */
loft_sci loft_dyad_place(loft_dyad n, loft_sci x);

LOFT_END_C

#endif
