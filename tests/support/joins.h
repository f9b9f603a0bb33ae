/* tests/support/joins.h -- the reference of joins: decided on whole numbers by residues
 * SPDX-License-Identifier: MIT
 *
 * Coordinates are multiples of 2^-16 below 2^15 here. The condition of G2 is that whole numbers
 * below 2^135 are 0. They are 0 if and only if they are multiples of three primes above 2^60.
 */
#ifndef LOFT_TESTS_JOINS_H
#define LOFT_TESTS_JOINS_H

#include "curve/join.h"
#include "support/exact.h"

__extension__ typedef __int128 joins_wide;

static inline int64_t joins_raw(loft_real x) { return (int64_t)(exact_of(x) * 65536); }

static inline joins_wide joins_residue(joins_wide x, joins_wide prime)
{
    return (x % prime + prime) % prime;
}

/* v^2 b + u^2 a1 of one axis */
static inline joins_wide joins_term(int64_t u, int64_t v, int64_t b, int64_t a1, joins_wide prime)
{
    const joins_wide uu = joins_residue((joins_wide)u * u, prime),
                     vv = joins_residue((joins_wide)v * v, prime);
    return joins_residue(vv * b % prime + uu * a1 % prime, prime);
}

typedef struct {
    int64_t a[LOFT_AXES], a1[LOFT_AXES], b1[LOFT_AXES], b2[LOFT_AXES];
} joins_edges;

static inline bool joins_is_g2(const joins_edges *e, int m)
{
    const int64_t primes[3] = { 2305843009213693951, 2305843009213693921, 2305843009213693907 };

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            for (int j = 0; j < i; j++) {
                const joins_wide wi = joins_term(e->b1[m], e->a[m], e->b2[i], e->a1[i], primes[k]);
                const joins_wide wj = joins_term(e->b1[m], e->a[m], e->b2[j], e->a1[j], primes[k]);
                if (joins_residue(wi * e->a[j] - wj * e->a[i], primes[k]) != 0)
                    return false;
            }
    return true;
}

/* The flags, with alpha and eta in long double. *pivot is the largest of |a|. */
static inline loft_join joins_flags(const loft_vec p[], const loft_vec q[], unsigned n,
                                    long double *alpha, long double *eta)
{
    loft_join j = { true, true, true, true, true, true, true, 0, 0 };
    joins_edges e;
    bool null_a = true, null_b = true;
    int m = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        e.a[i]  = joins_raw(p[n].axis[i]) - joins_raw(p[n-1].axis[i]);
        e.b1[i] = joins_raw(q[1].axis[i]) - joins_raw(q[0].axis[i]);
        e.a1[i] = n > 1 ? joins_raw(p[n-1].axis[i]) - joins_raw(p[n-2].axis[i]) : e.a[i];
        e.b2[i] = n > 1 ? joins_raw(q[2].axis[i]) - joins_raw(q[1].axis[i]) : e.b1[i];
        j.c0 = j.c0 && joins_raw(p[n].axis[i]) == joins_raw(q[0].axis[i]);
        j.c1 = j.c1 && e.a[i] == e.b1[i];
        j.c2 = j.c2 && e.b2[i] - e.b1[i] == e.a[i] - e.a1[i];
        null_a = null_a && e.a[i] == 0;
        null_b = null_b && e.b1[i] == 0;
        if (llabs(e.a[i]) > llabs(e.a[m]))
            m = i;
    }
    j.g0 = j.c0;
    j.c1 = j.c1 && j.c0;
    j.c2 = j.c2 && j.c1;
    j.regular = !null_a && !null_b;
    j.g1 = j.c0 && j.regular && (e.b1[m] > 0) == (e.a[m] > 0) && e.b1[m] != 0;
    for (int i = 0; i < LOFT_AXES; i++)
        j.g1 = j.g1 && (joins_wide)e.b1[i] * e.a[m] == (joins_wide)e.b1[m] * e.a[i];
    j.g2 = j.g1 && joins_is_g2(&e, m);
    *alpha = j.g1 ? (long double)e.b1[m] / (long double)e.a[m] : 0;
    *eta = j.g2 ? ((long double)e.b2[m] + *alpha * *alpha * (long double)e.a1[m]) /
                      (long double)e.a[m]
                : 0;
    return j;
}

#endif
