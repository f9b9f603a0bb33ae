/* tests/support/exact_polygon.h -- coordinates with respect to polygons in long double, by formulas
 * that differ from the library's
 * SPDX-License-Identifier: MIT
 *
 * Vertices and points are multiples of 2^-16, so cross products are exact in 128 bits.
 */
#ifndef LOFT_TESTS_EXACT_POLYGON_H
#define LOFT_TESTS_EXACT_POLYGON_H

#include "support/exact.h"                  /* exact_of */
#include "polygon/domain.h"

__extension__ typedef __int128 exact_wide;

static inline int64_t exact_raw(loft_real x) { return (int64_t)llroundl(exact_of(x) * 65536); }

/* Times 2^32. */
static inline exact_wide exact_cross(const loft_spot *o, const loft_spot *a, const loft_spot *b)
{
    const int64_t ux = exact_raw(a->at[0]) - exact_raw(o->at[0]),
                  uy = exact_raw(a->at[1]) - exact_raw(o->at[1]);
    const int64_t vx = exact_raw(b->at[0]) - exact_raw(o->at[0]),
                  vy = exact_raw(b->at[1]) - exact_raw(o->at[1]);

    return (exact_wide)ux * vy - (exact_wide)uy * vx;
}

static inline long double exact_dot(const loft_spot *o, const loft_spot *a, const loft_spot *b)
{
    return (exact_of(a->at[0]) - exact_of(o->at[0])) * (exact_of(b->at[0]) - exact_of(o->at[0])) +
           (exact_of(a->at[1]) - exact_of(o->at[1])) * (exact_of(b->at[1]) - exact_of(o->at[1]));
}

/* The formula with one quotient per vertex, C_i / (A_(i-1) A_i): valid only inside. */
static inline void exact_wachspress(const loft_spot v[], unsigned n, loft_spot p, long double phi[])
{
    long double sum = 0;

    for (unsigned i = 0; i < n; i++) {
        const loft_spot *before = &v[(i + n - 1) % n], *after = &v[(i + 1) % n];
        phi[i] = (long double)exact_cross(before, &v[i], after) /
                 (long double)exact_cross(&p, before, &v[i]) /
                 (long double)exact_cross(&p, &v[i], after);
        sum += phi[i];
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] /= sum;
}

/* By angles; neither on an edge nor at a vertex. The result is K of polygon/meanvalue.h. */
static inline long double exact_meanvalue(const loft_spot v[], unsigned n, loft_spot p,
                                          long double phi[])
{
    long double tangent[LOFT_SIDES_MAX], sum = 0, sizes = 0;

    for (unsigned i = 0; i < n; i++) {
        const loft_spot *a = &v[i], *b = &v[(i + 1) % n];
        const long double cross = (long double)exact_cross(&p, a, b) / 4294967296.0L,
                          dot = exact_dot(&p, a, b);
        tangent[i] = dot < 0 ? 1 / tanl(atan2l(cross, -dot) / 2) : tanl(atan2l(cross, dot) / 2);
    }
    for (unsigned i = 0; i < n; i++) {
        const long double r = sqrtl(exact_dot(&p, &v[i], &v[i])), t = tangent[(i + n - 1) % n];
        phi[i] = (t + tangent[i]) / r;
        sizes += (fabsl(t) + fabsl(tangent[i])) / r;
        sum += phi[i];
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] /= sum;
    return sizes / fabsl(sum);
}

#endif
