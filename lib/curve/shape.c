/* lib/curve/shape.c -- the kind of a planar cubic
 * SPDX-License-Identifier: MIT
 *
 * P = p0 + 3 c t + 3 b t^2 + a t^3 with c = p1 - p0, b = p0 - 2 p1 + p2, a = p3 - 3 p2 + 3 p1 - p0.
 * There are three integers (x is the planar product):
 *
 *     u = c x a      v = a x b      w = 3 c x b
 *
 * Inflections: P' x P'' = 18 (w/3 + u t - v t^2), so they are the roots of
 *
 *     3 v t^2 - 3 u t - w = 0        t = (3 u -+ sqrt(3 E)) / (6 v),     E = 3 u^2 + 4 v w
 *
 * Crossing: P(t1) = P(t2) divided by t1 - t2 is a (s^2 - p) + 3 b s + 3 c = 0 with s = t1 + t2, p =
 * t1 t2. Times a: s = u / v. Times b: p = s^2 + w / v. So t1, t2 are the roots of
 *
 *     v^2 t^2 - u v t + u^2 + v w = 0        t = (u -+ sqrt(-E)) / (2 v)
 *
 * The sign of E decides: two inflections, or a crossing, or for E = 0 both in one, a cusp at u / (2
 * v). For v = 0 one inflection is at infinity. For u = v = 0 and w != 0, a = 0 (otherwise b and c
 * are multiples of a, and w = 0), and the curve is a parabola.
 *
 * Which roots lie inside is decided without the roots: by the signs of the polynomial at 0 and 1,
 * and the side of its vertex. Bits, for coordinates of R bits (31, in floats 128): c R + 1, b R +
 * 2, a R + 3; u 2 R + 5, v 2 R + 6, w 2 R + 6; E 4 R + 15; the radicand with 128 more bits 4 R +
 * 145: 269 in q16, 657 in floats.
 */
#include "curve/shape.h"
#include "num/exact.h"  /* loft_exact: exact decisions */

#define GUARD 64        /* a root is an integer: these extra bits make it exact to 2^-64 */

typedef struct {
    loft_exact u, v, w;
} invariants;

static bool points_valid(const loft_cubic *c)
{
    for (int k = 0; k < 4; k++)
        for (int axis = 0; axis < 2; axis++)
            if (!loft_exact_valid(loft_vec_axis(&c->p[k], axis)))
                return false;
    return true;
}

/* c, b, a in d[0..2]: the first differences at p0. */
static void differences(const loft_cubic *cubic, int axis, loft_exact d[3])
{
    loft_exact p[4];

    for (int k = 0; k < 4; k++)
        p[k] = loft_exact_from_real(loft_vec_axis(&cubic->p[k], axis));
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3 - k; j++)
            p[j] = loft_exact_sub(p[j + 1], p[j]);
        d[k] = p[0];
    }
}

static int sum_sign(loft_exact a, loft_exact b) { return loft_exact_sign(loft_exact_add(a, b)); }
static loft_exact times(int32_t k, loft_exact a)
{
    return loft_exact_mul(loft_exact_from_int(k), a);
}

/* Compute u, v, w. True if it is one point. The sign is such that v > 0, or v = 0 and u >= 0. */
static bool find_invariants(const loft_cubic *c, invariants *i)
{
    loft_exact x[3], y[3];
    bool point = true;

    differences(c, 0, x);
    differences(c, 1, y);
    for (int k = 0; k < 3; k++)
        point = point && loft_exact_sign(x[k]) == 0 && loft_exact_sign(y[k]) == 0;
    i->u = loft_exact_det(x[0], y[0], x[2], y[2]);
    i->v = loft_exact_det(x[2], y[2], x[1], y[1]);
    i->w = times(3, loft_exact_det(x[0], y[0], x[1], y[1]));

    const int sign = loft_exact_sign(i->v);
    if (sign < 0 || (sign == 0 && loft_exact_sign(i->u) < 0)) {
        i->u = loft_exact_neg(i->u);
        i->v = loft_exact_neg(i->v);
        i->w = loft_exact_neg(i->w);
    }
    return point;
}

static loft_unit ratio(loft_exact x, loft_exact y)
{
    loft_acc t = 0;

    if (!loft_exact_quot(x, y, 0, &t))
        t = 0;                                  /* never: t lies in 0..1 */
    return loft_unit_ratio(t, loft_to_acc(LOFT_REAL(1)));
}

/* (m + sign sqrt(d)) / n */
static loft_unit root(loft_exact m, int sign, loft_exact d, loft_exact n)
{
    const loft_exact r = loft_exact_root(loft_exact_shift(d, 2 * GUARD)),
                     wide = loft_exact_shift(m, GUARD);

    return ratio(sign < 0 ? loft_exact_sub(wide, r) : loft_exact_add(wide, r),
                 loft_exact_shift(n, GUARD));
}

/* f(t) = 3 v t^2 - 3 u t - w with v > 0 and two roots; its vertex is u / (2 v). A root is right of
 * 0 unless f(0) and the vertex exclude it, and likewise for 1. */
static void find_inflections(const invariants *i, loft_exact e, loft_shape *s)
{
    const int at_0 = -loft_exact_sign(i->w);
    const int at_1 = loft_exact_sign(loft_exact_sub(times(3, loft_exact_sub(i->v, i->u)), i->w));
    const int vertex_to_0 = loft_exact_sign(i->u),
              vertex_to_1 = loft_exact_compare(i->u, times(2, i->v));
    const bool first  = at_0 > 0 && vertex_to_0 > 0 && (at_1 < 0 || vertex_to_1 <= 0);
    const bool second = at_1 > 0 && vertex_to_1 < 0 && (at_0 < 0 || vertex_to_0 >= 0);
    const loft_exact m = times(3, i->u), d = times(3, e), n = times(6, i->v);

    if (first)
        s->inflection[s->inflections++] = root(m, -1, d, n);
    if (second)
        s->inflection[s->inflections++] = root(m, 1, d, n);
}

/* v = 0, u > 0: f(t) = - 3 u t - w */
static void find_only_inflection(const invariants *i, loft_shape *s)
{
    const loft_exact n = times(3, i->u);

    if (loft_exact_sign(i->w) < 0 && sum_sign(n, i->w) > 0) {
        s->inflections = 1;
        s->inflection[0] = ratio(loft_exact_neg(i->w), n);
    }
}

/* 0 <= u <= 2 v */
static bool vertex_inside(const invariants *i)
{
    return loft_exact_sign(i->u) >= 0 && loft_exact_compare(i->u, times(2, i->v)) <= 0;
}

/* g(t) = v^2 t^2 - u v t + u^2 + v w: both roots are in 0..1 if the vertex is, and g(0), g(1) >=
 * 0. */
static void find_crossing(const invariants *i, loft_exact e, loft_shape *s)
{
    const loft_exact at_0 = loft_exact_add(loft_exact_mul(i->u, i->u), loft_exact_mul(i->v, i->w));
    const loft_exact rise = loft_exact_mul(i->v, loft_exact_sub(i->v, i->u));

    if (!vertex_inside(i) || loft_exact_sign(at_0) < 0 || sum_sign(at_0, rise) < 0)
        return;
    s->loops = 1;
    s->loop[0] = root(i->u, -1, loft_exact_neg(e), times(2, i->v));
    s->loop[1] = root(i->u, 1, loft_exact_neg(e), times(2, i->v));
}

static void find_true_cubic(const invariants *i, loft_shape *s)
{
    const loft_exact e = loft_exact_add(times(3, loft_exact_mul(i->u, i->u)),
                                        times(4, loft_exact_mul(i->v, i->w)));
    const int sign = loft_exact_sign(e);

    s->kind = sign > 0 ? LOFT_SERPENTINE : sign < 0 ? LOFT_LOOP : LOFT_CUSP;
    if (sign > 0)
        find_inflections(i, e, s);
    else if (sign < 0)
        find_crossing(i, e, s);
    else if (vertex_inside(i)) {
        s->cusps = 1;
        s->cusp = ratio(i->u, times(2, i->v));
    }
}

enum loft_status loft_cubic_shape(const loft_cubic *c, loft_shape *out)
{
    const loft_shape none = { LOFT_POINT, 0, 0, 0, { 0, 0 }, 0, { 0, 0 } };
    invariants i;

    if (!points_valid(c))
        return LOFT_ERR_RANGE;
    const bool point = find_invariants(c, &i);

    *out = none;
    if (loft_exact_sign(i.v))
        find_true_cubic(&i, out);
    else if (loft_exact_sign(i.u)) {
        out->kind = LOFT_CUSP_AT_INFINITY;
        find_only_inflection(&i, out);
    } else if (!point)
        out->kind = loft_exact_sign(i.w) ? LOFT_PARABOLA : LOFT_LINE;
    return LOFT_OK;
}
