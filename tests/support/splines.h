/* tests/support/splines.h -- arbitrary knots of every kind, and the reference: Cox and de Boor's
 * recursion in long double
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_SPLINES_H
#define LOFT_TESTS_SPLINES_H

#include "support/exact.h"              /* exact_of, ulp */
#include "basis/knots.h"

#define POINTS       (LOFT_DEGREE_MAX + 1)
#define POINTS_MOST  (POINTS + 12)
#define KNOTS_MOST   (POINTS_MOST + POINTS)

typedef struct {
    unsigned p, points;         /* the degree, the number of coefficients */
    loft_real k[KNOTS_MOST];
    loft_knots knots;
    unsigned kind;
} grid;

static inline loft_real real_of_raw(int64_t raw)
{
    return (loft_real)BY_NUM(raw, (double)raw / 65536, (double)raw / 65536);
}

/* One knot, unsorted: whole numbers, neighbours by one LSB, anything, the extremes, many equal,
 * thirds. */
static inline loft_real arb_knot(arb *a, unsigned kind)
{
    switch (kind) {
    case 0:  return real_of_raw(65536 * (int64_t)arb_below(a, 20));
    case 1:  return real_of_raw(7 + (int64_t)arb_below(a, 24));
    case 2:  return real_of_raw(arb_raw(a, INT32_MAX));
    case 3:
        return real_of_raw(arb_below(a, 2) ? INT32_MAX - (int64_t)arb_below(a, 6)
                                           : INT32_MIN + (int64_t)arb_below(a, 6));
    case 4:  return real_of_raw(12345 * (int64_t)arb_below(a, 6));
    default: return arb_real(a, 1000) / 3;
    }
}

static inline void sort(loft_real k[], unsigned count)
{
    for (unsigned i = 1; i < count; i++)
        for (unsigned j = i; j > 0 && k[j] < k[j - 1]; j--) {
            const loft_real larger = k[j - 1];
            k[j - 1] = k[j];
            k[j] = larger;
        }
}

/* The conditions of the header, counted in another way than init does. */
static inline bool good(const grid *g)
{
    const unsigned last = g->points + g->p;
    for (unsigned i = 0; i <= last; i++) {
        unsigned times = 0;
        for (unsigned j = 0; j <= last; j++)
            times += !(g->k[i] < g->k[j]) && !(g->k[j] < g->k[i]);
        if (times > g->p + 1 || (i > 0 && g->k[i] < g->k[i - 1]))
            return false;
    }
    return g->k[g->p] < g->k[g->points];
}

static inline grid arb_grid(arb *a)
{
    grid g;

    do {
        g.p = 1 + arb_below(a, LOFT_DEGREE_MAX);
        g.points = g.p + 1 + arb_below(a, POINTS_MOST - g.p);
        g.kind = arb_below(a, 6);
        const bool clamped = arb_below(a, 2);
        const unsigned count = g.points + g.p + 1;
        for (unsigned i = 0; i < count; i++)
            g.k[i] = arb_knot(a, g.kind);
        sort(g.k, count);
        for (unsigned i = 0; i <= g.p && clamped; i++) {
            g.k[i] = g.k[0];
            g.k[count - 1 - i] = g.k[count - 1];
        }
    } while (!good(&g));
    return g;
}

/* A parameter of the domain: a knot, its neighbour, or between two knots. */
static inline loft_real arb_u(arb *a, const grid *g)
{
    const unsigned i = g->p + arb_below(a, g->points - g->p);
    const double lo = arb_value(g->k[i]), hi = arb_value(g->k[i + 1]),
                 u = lo + (hi - lo) * (arb_below(a, 65537) / 65536.0);
    const loft_real between = (loft_real)BY_NUM(floor(u * 65536), u, u);

    if (arb_below(a, 4) == 0)
        return g->k[i + arb_below(a, 2)];
    return between < g->k[i] ? g->k[i] : between > g->k[i + 1] ? g->k[i + 1] : between;
}

/* The span of u, by counting. */
static inline unsigned exact_span(const grid *g, loft_real u)
{
    unsigned s = 0;
    for (unsigned i = g->p; i < g->points; i++)
        if (g->k[i] < g->k[i + 1] && (s == 0 || g->k[i] <= u))
            s = i;
    return s;
}

/* N_i of degree r at u, for the half-open span s */
static inline long double share(const grid *g, unsigned i, unsigned r, long double u)
{
    const long double lo = exact_of(g->k[i]), hi = exact_of(g->k[i + r]);
    return hi > lo ? (u - lo) / (hi - lo) : 0;
}

static inline long double left_of(const grid *g, unsigned i, unsigned r, long double u)
{
    const long double lo = exact_of(g->k[i]), hi = exact_of(g->k[i + r]);
    return hi > lo ? (hi - u) / (hi - lo) : 0;
}

/* All B-splines of degree r over all knots: n[i], i = 0 .. points + p - r - 1. */
static inline void exact_weights(const grid *g, unsigned r, unsigned s, long double u,
                                 long double n[KNOTS_MOST])
{
    const unsigned last = g->points + g->p;

    for (unsigned i = 0; i < last; i++)
        n[i] = i == s;
    for (unsigned q = 1; q <= r; q++)
        for (unsigned i = 0; i + q < last; i++)
            n[i] = share(g, i, q, u) * n[i] + left_of(g, i + 1, q, u) * n[i + 1];
}

#endif
