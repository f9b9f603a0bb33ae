/* tests/support/exact_shape.h -- the shape of planar cubics, curvature, convex polygons, signs: a
 * reference for tests
 * SPDX-License-Identifier: MIT
 *
 * Computed from the rounded coordinates, in other ways than in lib/: roots are counted by the signs
 * of Bernstein coefficients, revolutions by angles, and the degree is elevated step by step.
 */
#ifndef LOFT_TESTS_EXACT_SHAPE_H
#define LOFT_TESTS_EXACT_SHAPE_H

#include "curve/shape.h"
#include "support/exact_whole.h"        /* wide, vast: decisions */

typedef struct {
    enum loft_shape_kind kind;
    unsigned inflections, cusps, loops;
    long double inflection[2], cusp, loop[2];
} exact_shape;

static inline void exact_power(const loft_cubic *c, int axis, wide k[3])     /* of t, t^2, t^3 */
{
    wide p[4];
    for (int j = 0; j < 4; j++)
        p[j] = whole_of(c->p[j].axis[axis]);
    k[0] = 3 * (p[1] - p[0]);
    k[1] = 3 * (p[0] - 2 * p[1] + p[2]);
    k[2] = p[3] - 3 * p[2] + 3 * p[1] - p[0];
}

/* The number of roots in the open interval of a quadratic with two real roots and Bernstein
 * coefficients of these signs. */
static inline unsigned exact_open_roots(int s0, int s1, int s2)
{
    if (s0 != 0 && s2 != 0)
        return s0 != s2 ? 1u : s1 == -s0 ? 2u : 0u;
    return s1 * (s0 + s2) < 0;
}

/* (m + sign sqrt(d)) / n by the stable formula: first the root of larger absolute value, then the
 * other one from the product. */
static inline void exact_roots(long double m, long double d, long double n, long double product,
                               long double t[2])
{
    const long double root = sqrtl(d), large = (m + (m < 0 ? -root : root)) / n;
    const long double small = large < 0 || large > 0 ? product / large : 0;
    t[0] = fminl(large, small);
    t[1] = fmaxl(large, small);
}

static inline void exact_serpentine(wide u, wide v, wide w, vast e, exact_shape *s)
{
    long double t[2];
    const unsigned count = exact_open_roots(wide_sign(w), wide_sign(2 * w + 3 * u),
                                            wide_sign(w + 3 * u - 3 * v));

    exact_roots(3 * (long double)u, 3 * vast_value(e), 6 * (long double)v,
                -(long double)w / (3 * (long double)v), t);
    for (unsigned k = 0; k < 2; k++)
        if (count == 2 || (count == 1 && fabsl(t[k] - 0.5L) <= fabsl(t[1 - k] - 0.5L)))
            s->inflection[s->inflections++] = t[k];
}

static inline void exact_loop(wide u, wide v, wide w, vast e, exact_shape *s)
{
    const vast g0 = vast_add(vast_product(u, u), vast_product(v, w)),
               g1 = vast_add(g0, vast_product(v, v - u));
    long double t[2];

    exact_roots((long double)u, -vast_value(e), 2 * (long double)v,
                vast_value(g0) / ((long double)v * (long double)v), t);
    s->loops = vast_sign(g0) >= 0 && vast_sign(g1) >= 0 && wide_sign(u) * wide_sign(v) >= 0 &&
               wide_sign(2 * v - u) * wide_sign(v) >= 0;
    for (unsigned k = 0; k < 2 && s->loops; k++)
        s->loop[k] = t[k];
}

static inline exact_shape exact_shape_of(const loft_cubic *c)
{
    exact_shape s = { LOFT_POINT, 0, 0, 0, { 0 }, 0, { 0 } };
    wide x[3], y[3];

    exact_power(c, 0, x);
    exact_power(c, 1, y);
    const wide u = x[0] * y[2] - y[0] * x[2], v = x[2] * y[1] - y[2] * x[1],
               w = x[0] * y[1] - y[0] * x[1];
    const vast e = vast_add(vast_times(3, vast_product(u, u)), vast_times(4, vast_product(v, w)));

    if (v && vast_sign(e) > 0) {
        s.kind = LOFT_SERPENTINE;
        exact_serpentine(u, v, w, e, &s);
    } else if (v && vast_sign(e) < 0) {
        s.kind = LOFT_LOOP;
        exact_loop(u, v, w, e, &s);
    } else if (v) {
        s.kind = LOFT_CUSP;
        s.cusps = wide_sign(u) * wide_sign(v) >= 0 && wide_sign(2 * v - u) * wide_sign(v) >= 0;
        s.cusp = (long double)u / (2 * (long double)v);
    } else if (u) {
        s.kind = LOFT_CUSP_AT_INFINITY;
        s.inflections = wide_sign(w) * wide_sign(w + 3 * u) < 0;
        s.inflection[0] = -(long double)w / (3 * (long double)u);
    } else if (w)
        s.kind = LOFT_PARABOLA;
    else if (x[0] || x[1] || x[2] || y[0] || y[1] || y[2])
        s.kind = LOFT_LINE;
    return s;
}


/* Curvature: de Casteljau's scheme in 113 bits, and its first derivative also modulo 2^128 */

typedef struct {
    bool singular;
    long double curvature, tangent[LOFT_AXES];
    long double unsure;         /* the error of this curvature: the quads are exact up to degree
                                 * 6 */
} exact_bend;

static inline quad quad_root(quad x)
{
    const long double r = sqrtl((long double)x);
    return r > 0 ? (r + x / r) / 2 : 0;
}

/* Rows of the scheme at t = j / 65536 until `left` values remain; each row is multiplied by
 * 65536. */
static inline void exact_rows(vast c[], unsigned count, unsigned left, int64_t j)
{
    for (unsigned k = count; k > left; k--)
        for (unsigned i = 0; i + 1 < k; i++)
            c[i] = vast_add(vast_times(65536 - j, c[i]), vast_times(j, c[i + 1]));
}

/* One axis of P' / n and of its derivative / (n - 1), times 65536^n and 65536^(n-1). */
static inline bool exact_ends(const loft_bezier *b, int64_t j, int axis, quad *first, quad *second)
{
    const unsigned n = b->degree;
    vast c[LOFT_DEGREE_MAX + 1];

    *first = *second = 0;
    for (unsigned k = 0; k < n; k++)
        c[k] = vast_of(whole_of(b->p[k + 1].axis[axis]) - whole_of(b->p[k].axis[axis]));
    if (n > 1) {
        exact_rows(c, n, 2, j);
        *second = vast_add(c[1], vast_times(-1, c[0])).near;
        exact_rows(c, 2, 1, j);
    }
    if (n > 0 && !(vast_small(c[0]) && c[0].low == 0))
        *first = c[0].near;
    return *first < 0 || *first > 0;
}

/* At t = j / 65536, in the first `axes` axes; signed if there are two. With P' = n q / T^(n-1) and
 * so on the curvature is (n - 1) / n |q x r| / |q|^3 T^n G; T = G = 65536. */
static inline exact_bend exact_bend_at(const loft_bezier *b, int64_t j, int axes)
{
    const unsigned n = b->degree;
    quad q[LOFT_AXES], r[LOFT_AXES], speed = 0, change = 0, area = 0, squares = 0, scale = 65536;
    exact_bend x = { true, 0, { 0 }, 0 };

    for (unsigned k = 0; k < n; k++)
        scale *= 65536;
    for (int a = 0; a < axes; a++) {
        x.singular = !exact_ends(b, j, a, &q[a], &r[a]) && x.singular;
        speed += q[a] * q[a];
        change += r[a] * r[a];
    }
    if (x.singular)
        return x;
    for (int a = 0; a < axes; a++)
        for (int d = a + 1; d < axes; d++) {
            area = q[a] * r[d] - q[d] * r[a];
            squares += area * area;
        }
    if (axes > 2)
        area = quad_root(squares);
    const quad length = quad_root(speed),
               off = (n > 6 ? scale * 0x1p-104L : 0) + length * 0x1p-110L;
    for (int a = 0; a < axes; a++)
        x.tangent[a] = (long double)(q[a] / length);
    if (n > 1) {
        x.curvature = (long double)((n - 1) * area / (n * speed) * scale / length);
        x.unsure = (long double)(quad_root(change) / speed * scale / length * off) +
                   fabsl(x.curvature) * (long double)(8 * off / length);
    }
    return x;
}


/* Polygons: angles */

static inline enum loft_convexity exact_convexity(const loft_vec p[], unsigned count)
{
    wide x[64], y[64];
    unsigned edges = 0;
    bool left = false, right = false, back = false;
    long double angle = 0;

    for (unsigned k = 0; k < count; k++) {
        const loft_vec *from = &p[k], *to = &p[(k + 1) % count];
        x[edges] = whole_of(to->axis[0]) - whole_of(from->axis[0]);
        y[edges] = whole_of(to->axis[1]) - whole_of(from->axis[1]);
        edges += x[edges] || y[edges];
    }
    for (unsigned k = 0; k < edges; k++) {
        const unsigned next = (k + 1) % edges;
        const wide turn = x[k] * y[next] - y[k] * x[next], along = x[k] * x[next] + y[k] * y[next];
        left = left || turn > 0;
        right = right || turn < 0;
        back = back || (turn == 0 && along < 0);
        angle += atan2l((long double)turn, (long double)along);
    }
    if (!left && !right)
        return LOFT_COLLINEAR;
    return (left && right) || back || fabsl(angle) > 7 ? LOFT_NOT_CONVEX : LOFT_CONVEX;
}

#endif
