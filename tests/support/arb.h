/* tests/support/arb.h -- arbitrary values from a seed, extremes over-represented
 * SPDX-License-Identifier: MIT
 *
 * arb_real gives any coordinate of the number type within +-32767; one in eight is an extreme or
 * next to an extreme. In float builds coordinates are multiples of 2^-16 rounded to the type, so
 * the same seed draws the same shape in every build.
 */
#ifndef LOFT_TESTS_ARB_H
#define LOFT_TESTS_ARB_H

#include "curve/bezier.h"

typedef struct {
    uint64_t state;
} arb;

static inline uint64_t arb_next(arb *a)                 /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (a->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline arb arb_start(uint64_t seed)
{
    arb a = { seed };
    arb_next(&a);
    return a;
}
static inline uint32_t arb_below(arb *a, uint32_t n)
{
    return (uint32_t)(((arb_next(a) >> 32) * n) >> 32);
}

/* A raw Q16.16 coordinate, |raw| <= limit, extremes included. */
static inline int32_t arb_raw(arb *a, int32_t limit)
{
    const int32_t edge[8] = { 0, 1, -1, limit, -limit, limit - 1, 1 - limit, limit / 2 };
    if (arb_below(a, 8) == 0)
        return edge[arb_below(a, 8)];
    return (int32_t)((int64_t)(arb_next(a) >> 1) % (2 * (int64_t)limit + 1) - limit);
}

/* A coordinate, |x| <= limit (whole units, 1..32767). */
static inline loft_real arb_real(arb *a, int32_t limit)
{
    const int32_t raw = arb_raw(a, limit * 65536);
#if LOFT_NUM == LOFT_Q16
    return raw;
#else
    return (loft_real)(raw / 65536.0);
#endif
}

static inline loft_vec arb_vec(arb *a, int32_t limit)
{
    loft_vec v;
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = arb_real(a, limit);
    return v;
}

static inline loft_cubic arb_cubic(arb *a, int32_t limit)
{
    loft_cubic c;
    for (int k = 0; k < 4; k++)
        c.p[k] = arb_vec(a, limit);
    return c;
}

/* A parameter in 0..1, the ends included. */
static inline loft_unit arb_unit(arb *a)
{
    const uint32_t n = (uint32_t)1 << arb_below(a, 25);
    return loft_unit_of(arb_below(a, n + 1), n);
}

/* A coordinate as an exact double, in units (not raw). */
static inline double arb_value(loft_real x)
{
#if LOFT_NUM == LOFT_Q16
    return x / 65536.0;
#else
    return (double)x;
#endif
}

#endif
