/* tests/support/exact_basis.h -- B-splines and their derivatives in 113 bits, by the definition
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_EXACT_BASIS_H
#define LOFT_TESTS_EXACT_BASIS_H

#include "support/exact_spline.h"       /* quad, quad_of */

/* The k-th derivative at u of B-spline i of degree d, of the piece on `span`; 0/0 = 0. */
static inline quad quad_basis(const loft_real knot[], unsigned i, unsigned d, quad u, unsigned k,
                              unsigned span)
{
    if (d == 0)
        return i == span && k == 0;
    const quad low = quad_of(knot[i]), high = quad_of(knot[i + d + 1]);
    const quad a = quad_of(knot[i + d]) - low, b = high - quad_of(knot[i + 1]);
    const quad one = a > 0 ? quad_basis(knot, i, d - 1, u, k ? k - 1 : 0, span) / a : 0,
               two = b > 0 ? quad_basis(knot, i + 1, d - 1, u, k ? k - 1 : 0, span) / b : 0;

    return k ? d * (one - two) : (u - low) * one + (high - u) * two;
}

/* `points` + degree + 1 knots with multiple ones, within +-range. */
static inline void arb_knots(arb *a, unsigned points, unsigned degree, loft_real knot[])
{
    const unsigned count = points + degree + 1;
    int32_t at = -(int32_t)arb_below(a, 100) * 65536, step = (int32_t)1 << arb_below(a, 18);
    unsigned same = 1;

    for (unsigned i = 0; i < count; i++) {
        const bool repeat = i > 0 && same <= degree && arb_below(a, 3) == 0;
        same = repeat ? same + 1 : 1;
        if (i > 0 && !repeat)
            at += 1 + (int32_t)arb_below(a, (uint32_t)step);
        knot[i] = loft_real_from_raw(at);
    }
}

#endif
