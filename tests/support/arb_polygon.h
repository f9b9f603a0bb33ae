/* tests/support/arb_polygon.h -- arbitrary polygons, nearly degenerate ones over-represented, and
 * points in, on and beside them
 * SPDX-License-Identifier: MIT
 *
 * All coordinates are multiples of 2^-16, exact in every number type.
 */
#ifndef LOFT_TESTS_ARB_POLYGON_H
#define LOFT_TESTS_ARB_POLYGON_H

#include "support/exact_polygon.h"          /* exact_cross, exact_raw */
#include "support/exact_sci.h"              /* exact_sci */

typedef struct {
    loft_spot v[LOFT_SIDES_MAX];
    unsigned n;
    loft_domain d;
} arb_domain;

static inline loft_spot spot_raw(int64_t x, int64_t y)
{
    loft_spot p;
    p.at[0] = loft_real_from_raw((int32_t)x);
    p.at[1] = loft_real_from_raw((int32_t)y);
    return p;
}

/* Fits in 24 bits in f32. */
static inline int32_t arb_size(arb *a)
{
    const int32_t sizes[6] = {
        40, 3000, 65536, 65536, 100 * 65536, BY_NUM(30000 * 65536, 255 * 65536, 30000 * 65536)
    };
    return sizes[arb_below(a, 6)];
}

static inline int sign_at(const arb_domain *p, unsigned i)
{
    const exact_wide c = exact_cross(&p->v[(i + p->n - 1) % p->n], &p->v[i], &p->v[(i + 1) % p->n]);
    return (c > 0) - (c < 0);
}

/* All turns are to the left, and their sum is one revolution. A polygon that turns left everywhere
 * but goes round twice has a vertex right of some edge. */
static inline bool is_convex(const arb_domain *p)
{
    for (unsigned i = 0; i < p->n; i++)
        for (unsigned k = 0; k < p->n; k++)
            if (k != i && k != (i + 1) % p->n &&
                exact_cross(&p->v[i], &p->v[(i + 1) % p->n], &p->v[k]) <= 0)
                return false;
    return true;
}

static inline void polygon_around(arb *a, arb_domain *p, bool star)
{
    const int32_t size = arb_size(a);
    double angle[LOFT_SIDES_MAX];

    for (unsigned i = 0; i < p->n; i++) {
        angle[i] = arb_below(a, 1u << 20) * (6.283185307179586 / (1 << 20));
        for (unsigned k = i; k > 0 && angle[k] < angle[k - 1]; k--) {
            const double swap = angle[k];
            angle[k] = angle[k - 1];
            angle[k - 1] = swap;
        }
    }
    for (unsigned i = 0; i < p->n; i++) {
        const double r = star ? size * (0.05 + 0.95 * arb_below(a, 1000) / 1000) : size;
        p->v[i] = spot_raw(lround(r * cos(angle[i])), lround(r * sin(angle[i])));
    }
}

/* Vertices on a parabola, starting at any of them: as flat as the grid allows. */
static inline void flat_polygon(arb *a, arb_domain *p)
{
    const int32_t step = 1 + (int32_t)arb_below(a, 1u << arb_below(a, 20)),
                  start = (int32_t)arb_below(a, p->n);

    for (int32_t i = 0; i < (int32_t)p->n; i++) {
        const int32_t x = i - (int32_t)p->n / 2;
        p->v[(i + start) % (int32_t)p->n] = spot_raw((int64_t)x * step, (int64_t)x * x);
    }
}

static inline arb_domain arb_convex(arb *a)
{
    arb_domain p = { .n = 3 + arb_below(a, 6) };

    do
        if (arb_below(a, 4) == 0)
            flat_polygon(a, &p);
        else
            polygon_around(a, &p, false);
    while (!is_convex(&p));
    CHECK(loft_domain_init(&p.d, p.v, p.n) == LOFT_OK && p.d.convex);
    return p;
}

/* The vertices are in angular order about the origin: the polygon is simple if the origin is
 * inside. */
static inline bool is_star(const arb_domain *p)
{
    const loft_spot o = spot_raw(0, 0);

    for (unsigned i = 0; i < p->n; i++)
        if (exact_cross(&o, &p->v[i], &p->v[(i + 1) % p->n]) <= 0)
            return false;
    return true;
}

static inline arb_domain arb_simple(arb *a)
{
    arb_domain p = { .n = 3 + arb_below(a, 6) };

    do
        polygon_around(a, &p, true);
    while (!is_star(&p));
    CHECK(loft_domain_init(&p.d, p.v, p.n) == LOFT_OK && p.d.convex == is_convex(&p));
    return p;
}

/* Polygons that are not convex; most have no point inside that sees all of them. Notch, L, U,
 * spiral, comb, star, dart, a notch one unit wide, straight angles, two slivers. They start at any
 * vertex, are rotated by right angles, and have any size; some have vertices moved by one unit. */
static inline arb_domain arb_winding(arb *a)
{
    static const struct {
        unsigned n;
        int v[LOFT_SIDES_MAX][2];
    } shapes[] = {
        { 5, { { 0, 0 }, { 40, 0 }, { 40, 30 }, { 20, 10 }, { 0, 30 } } },
        { 6, { { 0, 0 }, { 40, 0 }, { 40, 20 }, { 20, 20 }, { 20, 40 }, { 0, 40 } } },
        { 8,
          { { 0, 0 },
            { 40, 0 },
            { 40, 40 },
            { 30, 40 },
            { 30, 10 },
            { 10, 10 },
            { 10, 40 },
            { 0, 40 } } },
        { 8,
          { { 0, 0 },
            { 40, 0 },
            { 40, 40 },
            { 10, 40 },
            { 10, 30 },
            { 30, 30 },
            { 30, 10 },
            { 0, 10 } } },
        { 7, { { 0, 0 }, { 10, 0 }, { 20, 30 }, { 30, 0 }, { 40, 0 }, { 25, 40 }, { 15, 40 } } },
        { 8,
          { { 40, 20 },
            { 25, 25 },
            { 20, 40 },
            { 15, 25 },
            { 0, 20 },
            { 15, 15 },
            { 20, 0 },
            { 25, 15 } } },
        { 4, { { 0, 0 }, { 40, 0 }, { 10, 10 }, { 0, 40 } } },
        { 7, { { 0, 0 }, { 40, 0 }, { 40, 30 }, { 21, 30 }, { 20, 1 }, { 20, 30 }, { 0, 30 } } },
        { 8,
          { { 0, 0 },
            { 20, 0 },
            { 40, 0 },
            { 40, 20 },
            { 20, 20 },
            { 20, 30 },
            { 20, 40 },
            { 0, 40 } } },
        { 4, { { 0, 0 }, { 3000, -1000 }, { 2, 0 }, { 3000, 1000 } } }
    };
    const unsigned which = arb_below(a, 10), turns = arb_below(a, 4), moved = arb_below(a, 2);
    arb_domain p = { .n = shapes[which].n };
    const unsigned start = arb_below(a, p.n);
    const int32_t size = 1 << arb_below(a, which < 9 ? 19 : 13);

    for (unsigned i = 0; i < p.n; i++) {
        const int *v = shapes[which].v[(i + start) % p.n];
        int32_t x = v[0] * size, y = v[1] * size;
        for (unsigned k = 0; k < turns; k++) {
            const int32_t swap = x;
            x = -y;
            y = swap;
        }
        p.v[i] = spot_raw(x + (int32_t)(size > 1 ? arb_below(a, 1 + moved) : 0),
                          y - (int32_t)(size > 1 ? arb_below(a, 1 + moved) : 0));
    }
    CHECK(loft_domain_init(&p.d, p.v, p.n) == LOFT_OK && !p.d.convex);
    return p;
}

/* A domain points to its vertices: after a copy it must point to the copied ones. */
static inline void settle(arb_domain *p) { p->d.v = p->v; }

/* A grid point on edge i if there is one between its ends; otherwise an end. */
static inline loft_spot arb_on_edge(arb *a, const arb_domain *p, unsigned i)
{
    const loft_spot *from = &p->v[i], *to = &p->v[(i + 1) % p->n];
    const int64_t x = exact_raw(to->at[0]) - exact_raw(from->at[0]),
                  y = exact_raw(to->at[1]) - exact_raw(from->at[1]);
    int64_t g = llabs(x), h = llabs(y);

    while (h) {
        const int64_t rest = g % h;
        g = h;
        h = rest;
    }
    const int64_t k = (int64_t)(arb_next(a) >> 2) % (g + 1);
    return spot_raw(exact_raw(from->at[0]) + x / g * k, exact_raw(from->at[1]) + y / g * k);
}

/* A point nearby: at random in the box of three vertices, or within one LSB of an edge. */
static inline loft_spot arb_near(arb *a, const arb_domain *p)
{
    const loft_spot on = arb_on_edge(a, p, arb_below(a, p->n));

    if (arb_below(a, 3) == 0)
        return spot_raw(exact_raw(on.at[0]) + (int)arb_below(a, 3) - 1,
                        exact_raw(on.at[1]) + (int)arb_below(a, 3) - 1);
    const loft_spot *q = &p->v[arb_below(a, p->n)], *s = &p->v[arb_below(a, p->n)];
    const double t = arb_below(a, 1001) / 1000.0, u = arb_below(a, 1001) / 1000.0;
    return spot_raw(
        llround((1 - t) * (double)exact_raw(q->at[0]) +
                t * ((1 - u) * (double)exact_raw(s->at[0]) + u * (double)exact_raw(on.at[0]))),
        llround((1 - t) * (double)exact_raw(q->at[1]) +
                t * ((1 - u) * (double)exact_raw(s->at[1]) + u * (double)exact_raw(on.at[1]))));
}

#endif
