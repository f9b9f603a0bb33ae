/* tests/support/exact_sign.h -- positivity and convexity of quadratics and quartics: a reference
 * for tests
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_EXACT_SIGN_H
#define LOFT_TESTS_EXACT_SIGN_H

#include "support/exact_whole.h"        /* wide: 2^31 coordinates, products of two, no overflow */

typedef struct {
    bool nonnegative, positive;
    int elevations;
    long double min;
} exact_sign;

/* The minimum of the quadratic a on 0..1 as a fraction of whole numbers; the denominator is
 * positive. */
static inline void exact_least(const wide a[3], wide *top, wide *bottom)
{
    *top = a[0] < a[2] ? a[0] : a[2];
    *bottom = 1;
    const wide d = a[0] - 2 * a[1] + a[2];
    if (d > 0 && a[0] - a[1] > 0 && a[0] - a[1] < d) {         /* the vertex (a0 - a1) / d */
        *top = a[0] * a[2] - a[1] * a[1];
        *bottom = d;
    }
}

/* Are all coefficients positive after `times` degree elevations, one by one? An elevation to degree
 * m multiplies by m. */
static inline bool exact_all_positive(const wide a[3], int times)
{
    wide c[80];

    for (int k = 0; k < 3; k++)
        c[k] = a[k];
    for (int m = 3; m <= times + 2; m++) {
        long double scale = 0;
        c[m] = m * c[m - 1];
        for (int k = m - 1; k > 0; k--)
            c[k] = k * c[k - 1] + (m - k) * c[k];
        c[0] = m * c[0];
        for (int k = 0; k <= m; k++)
            scale = fmaxl(scale, fabsl((long double)c[k]));
        if (scale > 0x1p100L)
            return false;                               /* the caller does not get here */
    }
    for (int k = 0; k <= times + 2; k++)
        if (c[k] <= 0)
            return false;
    return true;
}

/* The sign of b_k of degree m: a formula for many elevations, where the products above would
 * overflow. */
static inline bool exact_formula_positive(const wide a[3], int m)
{
    for (int k = 0; k <= m; k++)
        if ((m - k) * (m - k - 1) * a[0] + 2 * k * (m - k) * a[1] + k * (k - 1) * a[2] <= 0)
            return false;
    return true;
}

static inline exact_sign exact_sign_of(const loft_real x[3])
{
    const wide a[3] = { whole_of(x[0]), whole_of(x[1]), whole_of(x[2]) };
    exact_sign s = { false, false, -1, 0 };
    wide top, bottom;

    exact_least(a, &top, &bottom);
    s.nonnegative = top >= 0;
    s.positive = top > 0;
    s.min = (long double)top / (long double)bottom / 65536;
    for (int r = 0; r <= 60 && s.elevations < 0; r++)
        if (r <= 12 ? exact_all_positive(a, r) : exact_formula_positive(a, r + 2))
            s.elevations = r;
    return s;
}

static inline void exact_second(const loft_real b[], unsigned n, wide d[3])
{
    for (unsigned k = 0; k + 2 <= n; k++)
        d[k] = whole_of(b[k]) - 2 * whole_of(b[k + 1]) + whole_of(b[k + 2]);
}

static inline bool exact_net_convex(const loft_real b[], unsigned n)
{
    wide d[3];
    exact_second(b, n, d);
    for (unsigned k = 0; k + 2 <= n; k++)
        if (d[k] < 0)
            return false;
    return true;
}

/* Decided by the minimum of the second derivative. */
static inline bool exact_convex(const loft_real b[], unsigned n)
{
    wide d[3], top, bottom;
    if (n < 4)
        return exact_net_convex(b, n);
    exact_second(b, n, d);
    exact_least(d, &top, &bottom);
    return top >= 0;
}

#endif
