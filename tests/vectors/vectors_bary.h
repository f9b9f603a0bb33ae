/* tests/vectors/vectors_bary.h -- points and directions in a triangle, as a CSV gives them: three
 * coordinates
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_VECTORS_BARY_H
#define LOFT_TESTS_VECTORS_BARY_H

#include "vectors/vectors.h"        /* row */
#include "surface/barycentric.h"    /* loft_bary */

/* `count` points or directions of three coordinates each, separated by `;`; they do not count as
 * coordinates. */
static inline void row_barys(row *r, const char *column, unsigned count, bool direction,
                             loft_bary out[])
{
    const long double largest = r->largest, inexact = r->inexact;
    loft_vec x[3];

    row_points(r, column, count, 3, x);
    for (unsigned k = 0; k < count; k++) {
        const loft_real *u = x[k].axis;
        if (fabsl(exact_of(u[0]) + exact_of(u[1]) + exact_of(u[2]) - !direction) > 0 ||
            !(fabsl(exact_of(u[1])) < 128 && fabsl(exact_of(u[2])) < 128))
            row_complain(r, "column %s: not three coordinates of a triangle", column);
        else
            out[k] = (loft_bary) { loft_unit_from(u[1]), loft_unit_from(u[2]) };
    }
    r->largest = largest;
    r->inexact = inexact;
}

static inline loft_bary row_bary(row *r, const char *column, bool direction)
{
    loft_bary u = { 0, 0 };
    row_barys(r, column, 1, direction, &u);
    return u;
}

#endif
