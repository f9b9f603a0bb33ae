/* tests/support/exact.h -- the reference of curve tests: long double, and the meaning of a bound in
 * each number type
 * SPDX-License-Identifier: MIT
 *
 * long double has 64 bits of mantissa on x86: 2^-63 relative, against bounds of 2^-33 (q16) and
 * 2^-53 (f64).
 */
#ifndef LOFT_TESTS_EXACT_H
#define LOFT_TESTS_EXACT_H

#include <math.h>

#include "check.h"

#define LSB (1.0L / 65536)

static inline long double exact_of(loft_real x)  { return BY_NUM((long double)x / 65536, x, x); }
static inline long double exact_unit(loft_unit t)
{
    return BY_NUM((long double)t / 16777216, t, t);
}
static inline long double exact_acc(loft_acc x)
{
    return BY_NUM((long double)x / 4294967296.0L, x, x);
}

/* The distance from |x| to the next larger number of the type; in q16 it is always one LSB. */
static inline long double ulp(long double x)
{
    x = fabsl(x);
    return BY_NUM(LSB, (long double)nextafterf((float)x, INFINITY) - (float)x,
                  (long double)nextafter((double)x, INFINITY) - (double)x);
}

static inline long double ulp_double(long double x)
{
    x = fabsl(x);
    return (long double)nextafter((double)x, INFINITY) - (double)x;
}

/* |got - want| <= bound, compared in long double */
#define CHECK_EXACT(got, want, bound)                                                              \
    check_near((double)((got) - (want)), 0, (double)(bound), __FILE__, __LINE__, #got)

/* A polynomial with Bernstein coefficients c[0..n]: the blossom at t[0..n-1]. */
static inline long double exact_blossom(const long double c[], unsigned n, const long double t[])
{
    long double w[32];
    for (unsigned k = 0; k <= n; k++)
        w[k] = c[k];
    for (unsigned j = 0; j < n; j++)
        for (unsigned k = 0; k + j < n; k++)
            w[k] = (1 - t[j]) * w[k] + t[j] * w[k+1];
    return w[0];
}

static inline long double exact_eval(const long double c[], unsigned n, long double t)
{
    long double at[32];
    for (unsigned k = 0; k < n; k++)
        at[k] = t;
    return exact_blossom(c, n, at);
}

/* The k-th derivative at t. */
static inline long double exact_deriv(const long double c[], unsigned n, unsigned k, long double t)
{
    long double w[32], factor = 1;
    if (k > n)
        return 0;
    for (unsigned j = 0; j <= n; j++)
        w[j] = c[j];
    for (unsigned m = 0; m < k; m++) {
        factor *= n - m;
        for (unsigned j = 0; j + m < n; j++)
            w[j] = w[j+1] - w[j];
    }
    return factor * exact_eval(w, n - k, t);
}

/* Extrapolation: the growth L = |1 - t| + |t|, and the sum 1 + L + .. + L^(n-1). */
static inline long double growth(long double t) { return fabsl(1 - t) + fabsl(t); }
static inline long double growth_sum(long double t, unsigned n)
{
    long double sum = 0, power = 1;
    for (unsigned k = 0; k < n; k++, power *= growth(t))
        sum += power;
    return sum;
}

#endif
