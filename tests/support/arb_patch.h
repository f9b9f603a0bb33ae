/* tests/support/arb_patch.h -- control points, weights and coordinates for patches with n sides
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_ARB_PATCH_H
#define LOFT_TESTS_ARB_PATCH_H

#include "support/arb_polygon.h"            /* arb_domain */

#define PATCH_POINTS 800

/* The data of a patch, and its largest coordinate. */
typedef struct {
    loft_vec p[PATCH_POINTS];
    loft_real w[PATCH_POINTS];
    long double largest;
} net;

/* 1/16..16, or 1/256..256. */
static inline loft_real arb_factor(arb *a, bool wild)
{
    const int32_t least = wild ? 256 : 4096, most = wild ? 16777216 : 1048576;
    const uint32_t kind = arb_below(a, 6);
    const int32_t raw = kind == 0   ? least
                        : kind == 1 ? most
                        : kind == 2 ? 65536
                                    : least + (int32_t)(arb_below(a, (uint32_t)(most - least)) >>
                                                        arb_below(a, 12));

    return loft_real_from_raw(raw);
}

static inline void arb_net(arb *a, net *s, unsigned count)
{
    const int32_t limit = arb_below(a, 3) ? 100 : 32767;

    s->largest = 0;
    for (unsigned k = 0; k < count; k++) {
        s->p[k] = arb_vec(a, limit);
        s->w[k] = arb_factor(a, limit > 100);
        for (int i = 0; i < LOFT_AXES; i++)
            s->largest = fmaxl(s->largest, fabsl(exact_of(s->p[k].axis[i])));
    }
}

/* Compare with long double. Bound: in q16 1/2 LSB plus `lsb`; in floats half an ulp plus `ulps`
 * ulps of double at the largest coordinate. */
static inline void check_axis(loft_real got, long double want, long double largest, long double lsb,
                              long double ulps)
{
    const long double bound[2] = { (0.5L + lsb) * LSB, ulp(want) / 2 + ulps * ulp_double(largest) };
    CHECK_EXACT(exact_of(got), want, bound[BY_NUM(0, 1, 1)]);
}

static inline void check_same(loft_vec u, loft_vec v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(u.axis[i]), exact_of(v.axis[i]), 0);
}

static inline long double power(long double x, unsigned k)
{
    long double r = 1;
    while (k-- > 0)
        r *= x;
    return r;
}

#endif
