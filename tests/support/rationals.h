/* tests/support/rationals.h -- arbitrary rational curves of every kind, and the reference in long
 * double
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_RATIONALS_H
#define LOFT_TESTS_RATIONALS_H

#include "support/exact.h"              /* exact_eval, ulp */
#include "curve/rational.h"

#define POINTS (LOFT_DEGREE_MAX + 1)

typedef struct {
    loft_weighted p[LOFT_ELEVATE_MAX + 1];
    unsigned n;
    loft_rational r;
    long double x[LOFT_AXES][POINTS], w[POINTS], largest, ratio;
} sample;

/* 1/256..256: equal, of two values, of any size, or alternating extremes. */
static inline loft_real arb_weight(arb *a, uint32_t kind, unsigned k)
{
    const double extreme[2] = { 0.00390625, 256 };
    const uint32_t shift = arb_below(a, 17);
    double w = (65536 + arb_below(a, 65536)) / (double)(1 << shift) / 512;

    if (kind == 0)
        w = 1;
    if (kind == 1)
        w = extreme[k & 1];
    if (kind == 2)
        w = extreme[arb_below(a, 2)];
    if (kind == 3)
        w = 1 + arb_below(a, 65536) / 65536.0;
    w = w < extreme[0] ? extreme[0] : w;
    return (loft_real)BY_NUM((int32_t)(w * 65536), (float)w, w);
}

static inline void measure(sample *s)
{
    long double least = 256, most = 0;

    s->largest = 0;
    for (unsigned k = 0; k <= s->n; k++) {
        s->w[k] = exact_of(s->p[k].w);
        least = fminl(least, s->w[k]);
        most = fmaxl(most, s->w[k]);
        for (int i = 0; i < LOFT_AXES; i++) {
            const long double p = exact_of(s->p[k].p.axis[i]);
            s->x[i][k] = p * s->w[k];
            s->largest = fmaxl(s->largest, fabsl(p));
        }
    }
    s->ratio = most / least;
}

/* A curve of degree 0..top; one in four consists of extremes of the number type. */
static inline sample *arb_rational(arb *a, unsigned top)
{
    static sample s;
    const loft_real high = BY_NUM(INT32_MAX, 32767, 32767), low = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8), weights = arb_below(a, 6),
                   limit = (uint32_t)1 << arb_below(a, 15);

    s.n = arb_below(a, top + 1);
    for (unsigned k = 0; k <= s.n; k++) {
        s.p[k].w = arb_weight(a, weights, k);
        for (int i = 0; i < LOFT_AXES; i++)
            s.p[k].p.axis[i] = kind == 0   ? (k & 1 ? high : low)
                               : kind == 1 ? (arb_below(a, 2) ? high : low)
                                           : arb_real(a, (int32_t)limit);
    }
    CHECK(loft_rational_init(&s.r, s.p, s.n) == LOFT_OK);
    measure(&s);
    return &s;
}

/* sum C(n,k) (m-j)^(n-k) j^k c_k, the polynomial at j/m times m^n: no parameter is rounded. */
static inline long double exact_at(const long double c[], unsigned n, long double j, long double m)
{
    long double v[POINTS];

    for (unsigned k = 0; k <= n; k++)
        v[k] = c[k];
    for (unsigned rows = n; rows > 0; rows--)
        for (unsigned k = 0; k < rows; k++)
            v[k] = (m - j) * v[k] + j * v[k + 1];
    return v[0];
}

static inline long double rational_at(const sample *s, int axis, long double j, long double m)
{
    return exact_at(s->x[axis], s->n, j, m) / exact_at(s->w, s->n, j, m);
}

#endif
