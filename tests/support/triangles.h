/* tests/support/triangles.h -- the reference of triangle tests: polynomials over a triangle in long
 * double, decisions in whole numbers
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_TRIANGLES_H
#define LOFT_TESTS_TRIANGLES_H

#include <float.h>

#include "support/exact_whole.h"    /* exact_of, wide, vast */
#include "surface/barycentric.h"    /* loft_bary */

/* u, v, w of a point or direction, and the sum of their absolute values. */
static inline void exact_bary(loft_bary u, bool direction, long double x[3])
{
    x[1] = exact_unit(u.v);
    x[2] = exact_unit(u.w);
    x[0] = !direction - x[1] - x[2];
}

static inline long double growth_of(loft_bary u, bool direction)
{
    long double x[3];
    exact_bary(u, direction, x);
    return fabsl(x[0]) + fabsl(x[1]) + fabsl(x[2]);
}

static inline long double growth3(loft_bary u) { return growth_of(u, false); }
static inline long double reach3(loft_bary z)  { return growth_of(z, true); }

/* 1 + l + .. + l^(n-1) */
static inline long double sums(long double l, unsigned n)
{
    long double sum = 0, power = 1;
    for (unsigned k = 0; k < n; k++, power *= l)
        sum += power;
    return sum;
}

static inline long double factorial(unsigned n) { return n < 2 ? 1 : n * factorial(n - 1); }

static inline long double exact_weight(unsigned i, unsigned j, unsigned k, const long double x[3])
{
    return factorial(i + j + k) / (factorial(i) * factorial(j) * factorial(k)) * powl(x[0], i) *
           powl(x[1], j) * powl(x[2], k);
}

/* The polar form of the net c at x[0..n-1], which may be points and directions: rows of de
 * Casteljau's scheme. */
static inline long double exact_polar(const long double c[], unsigned n, long double x[][3])
{
    long double b[LOFT_TRIANGLE_POINTS(18)];

    for (unsigned p = 0; p < LOFT_TRIANGLE_POINTS(n); p++)
        b[p] = c[p];
    for (unsigned r = 0; r < n; r++)
        for (unsigned m = 0, p = 0; m < n - r; m++)
            for (unsigned k = 0; k <= m; k++, p++)
                b[p] = x[r][0] * b[p] + x[r][1] * b[p + m + 1] + x[r][2] * b[p + m + 2];
    return b[0];
}


/* Arbitrary points, directions, nets */

/* Inside, on an edge or at a corner. */
static inline loft_bary arb_bary(arb *a)
{
    const uint32_t n = (uint32_t)1 << arb_below(a, 24), j = arb_below(a, n + 1),
                   k = arb_below(a, n - j + 1);
    loft_bary u = { loft_unit_of(j, n), loft_unit_of(k, n) };

    if (arb_below(a, 8) == 0)
        u.v = 0;
    if (arb_below(a, 8) == 0)
        u.w = LOFT_UNIT(1) - u.v;
    return u;
}

/* Anywhere, |v|, |w| <= far; also used as a direction. */
static inline loft_bary arb_far(arb *a, int32_t far)
{
    return (loft_bary) { loft_unit_from(arb_real(a, far)), loft_unit_from(arb_real(a, far)) };
}

typedef struct {
    loft_vec p[LOFT_TRIANGLE_MAX];
    unsigned n, count;
    long double c[LOFT_AXES][LOFT_TRIANGLE_MAX], largest;
} arb_net;

static inline void measure_net(arb_net *x)
{
    x->largest = 0;
    for (unsigned k = 0; k < x->count; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            x->c[i][k] = exact_of(x->p[k].axis[i]);
            x->largest = fmaxl(x->largest, fabsl(x->c[i][k]));
        }
}

/* A net of degree least..most; one in four consists of extremes of the number type. */
static inline arb_net *arb_net_of(arb *a, unsigned least, unsigned most, int32_t limit)
{
    static arb_net many[2];
    static unsigned turn;
    arb_net *x = &many[turn++ % 2];
    const loft_real high = BY_NUM(INT32_MAX, 32767, 32767), low = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = limit == 32767 ? arb_below(a, 8) : 9;
    const int32_t size = limit >> arb_below(a, 15);

    x->n = least + arb_below(a, most - least + 1);
    x->count = LOFT_TRIANGLE_POINTS(x->n);
    for (unsigned k = 0; k < x->count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            x->p[k].axis[i] = kind == 0   ? (k & 1 ? high : low)
                              : kind == 1 ? (arb_below(a, 2) ? high : low)
                                          : arb_real(a, size > 0 ? size : 1);
    measure_net(x);
    return x;
}

/* The value of one axis at u. */
static inline long double net_at(const arb_net *x, int axis, loft_bary u)
{
    long double at[LOFT_DEGREE_MAX + 1][3];

    for (unsigned k = 0; k < x->n; k++)
        exact_bary(u, false, at[k]);
    return exact_polar(x->c[axis], x->n, at);
}

/* A bound for each kind: q16 or floats. */
static inline long double by_kind(long double q16, long double floats)
{
    return BY_NUM(true, false, false) ? q16 : floats;
}

/* Half a rounding of the result, plus the error of `rows` rows with growth l before it. */
static inline long double rows_bound(const arb_net *x, unsigned rows, long double l,
                                     long double want)
{
    return by_kind(LSB / 2 + (sums(l, rows) / 131072 + 0x1p-20L) * LSB,
                   ulp(want) / 2 + (3 * rows + 1) * powl(l, rows) * ulp_double(x->largest));
}

/* 1: fits, 0: does not fit, -1: too close to tell */
static inline int exact_fits(long double want)
{
    const long double over = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX),
                      under = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    return want < over - LSB && want > under + LSB   ? 1
           : want > over + LSB || want < under - LSB ? 0
                                                     : -1;
}


/* Whole numbers: coordinates and parameters as raw Q16.16 */

static inline wide cross_of(loft_vec o, loft_vec a, loft_vec b)
{
    wide x[2], y[2];
    for (int i = 0; i < 2; i++) {
        x[i] = whole_of(loft_vec_axis(&a, i)) - whole_of(loft_vec_axis(&o, i));
        y[i] = whole_of(loft_vec_axis(&b, i)) - whole_of(loft_vec_axis(&o, i));
    }
    return x[0] * y[1] - x[1] * y[0];
}

/* The coordinates of x in the triangle; the result is twice the area, in units of 2^-32. */
static inline wide exact_point(const loft_vec t[3], loft_vec x, long double u[3])
{
    const wide whole = cross_of(t[0], t[1], t[2]);
    u[0] = (long double)cross_of(x, t[1], t[2]) / (long double)whole;
    u[1] = (long double)cross_of(t[0], x, t[2]) / (long double)whole;
    u[2] = (long double)cross_of(t[0], t[1], x) / (long double)whole;
    return whole;
}

static inline wide exact_vector(const loft_vec t[3], loft_vec z, long double u[3])
{
    const wide whole = cross_of(t[0], t[1], t[2]);
    const wide zx = whole_of(loft_vec_axis(&z, 0)), zy = whole_of(loft_vec_axis(&z, 1));
    for (int k = 0; k < 3; k++) {
        const loft_vec *a = &t[(k + 1) % 3], *b = &t[(k + 2) % 3];
        const wide x = whole_of(loft_vec_axis(b, 0)) - whole_of(loft_vec_axis(a, 0)),
                   y = whole_of(loft_vec_axis(b, 1)) - whole_of(loft_vec_axis(a, 1));
        u[k] = (long double)(zy * x - zx * y) / (long double)whole;
    }
    return whole;
}

static inline wide whole_unit(loft_unit t) { return (wide)(exact_unit(t) * 65536); }

/* 65536^i times the point (i, j, k) beyond the edge, for parameters in raw Q16.16. */
static inline vast beyond_of(const loft_vec p[], int axis, unsigned i, unsigned j, unsigned k,
                             loft_bary star)
{
    const wide x[3] = { 65536 - whole_unit(star.v) - whole_unit(star.w), whole_unit(star.v),
                        whole_unit(star.w) };
    vast sum = vast_of(0);

    for (unsigned b = 0; b <= i; b++)
        for (unsigned c = 0; b + c <= i; c++) {
            vast term = vast_of(whole_of(p[loft_triangle_place(j + b, k + c)].axis[axis]));
            for (unsigned s = 0; s < i; s++)
                term = vast_times(x[s < b ? 1 : s < b + c ? 2 : 0], term);
            const long double ways = factorial(i) /
                                     (factorial(b) * factorial(c) * factorial(i - b - c));
            sum = vast_add(sum, vast_times((wide)(ways + 0.5L), term));
        }
    return sum;
}

/* The order to which two nets of degree n join. */
static inline int order_of(const loft_vec p[], const loft_vec q[], unsigned n, loft_bary star)
{
    for (unsigned i = 0; i <= n; i++)
        for (unsigned k = 0; k <= n - i; k++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                vast own = vast_of(-whole_of(q[loft_triangle_place(n - i - k, k)].axis[axis]));
                for (unsigned s = 0; s < i; s++)
                    own = vast_times(65536, own);
                if (vast_sign(vast_add(beyond_of(p, axis, i, n - i - k, k, star), own)) != 0)
                    return (int)i - 1;
            }
    return (int)n;
}

#endif
