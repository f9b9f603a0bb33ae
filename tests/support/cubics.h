/* tests/support/cubics.h -- cubics in long double, as a reference, and arbitrary cubics of every
 * kind
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_CUBICS_H
#define LOFT_TESTS_CUBICS_H

#include <math.h>           /* sqrtl, fmaxl */

#include "check.h"          /* BY_NUM, arb */

typedef long double real;
typedef struct {
    real x[LOFT_AXES];
} point;
typedef struct {
    point p[4];
} exact;

static inline point point_of(loft_vec v)
{
    point p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.x[i] = arb_value(v.axis[i]);
    return p;
}

static inline exact exact_of(const loft_cubic *c)
{
    exact e;
    for (int k = 0; k < 4; k++)
        e.p[k] = point_of(c->p[k]);
    return e;
}

static inline real  wide(loft_acc x)       { return BY_NUM(0x1p-32L, 1, 1) * (real)x; }
static inline real  parameter(loft_unit t) { return BY_NUM(0x1p-24L, 1, 1) * (real)t; }
static inline loft_real tol_of(int32_t raw)
{
    return BY_NUM(raw, (loft_real)(raw / 65536.0), (loft_real)(raw / 65536.0));
}

/* A length as acc, truncated to its ulp. */
static inline loft_acc acc_of(real x)      { return (loft_acc)(BY_NUM(0x1p32L, 1, 1) * x); }

static inline point between(point a, point b, real t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.x[i] += (b.x[i] - a.x[i]) * t;
    return a;
}

static inline real distance(point a, point b)
{
    real sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += (a.x[i] - b.x[i]) * (a.x[i] - b.x[i]);
    return sqrtl(sum);
}

static inline real distance_from_segment(point w, point a, point b)
{
    real dot = 0, square = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        dot    += (w.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
        square += (b.x[i] - a.x[i]) * (b.x[i] - a.x[i]);
    }
    const real t = square > 0 ? dot / square : 0;
    return distance(w, between(a, b, t < 0 ? 0 : t > 1 ? 1 : t));
}

static inline void split(const exact *c, real t, exact *left, exact *right)
{
    const point q0 = between(c->p[0], c->p[1], t), q1 = between(c->p[1], c->p[2], t),
                q2 = between(c->p[2], c->p[3], t);
    const point r0 = between(q0, q1, t), r1 = between(q1, q2, t), s = between(r0, r1, t);
    const exact l = {{ c->p[0], q0, r0, s }}, r = {{ s, r1, q2, c->p[3] }};
    *left  = l;
    *right = r;
}

static inline point at(const exact *c, real t)
{
    exact left, right;
    split(c, t, &left, &right);
    return left.p[3];
}

static inline real polygon(const exact *c)
{
    return distance(c->p[0], c->p[1]) + distance(c->p[1], c->p[2]) + distance(c->p[2], c->p[3]);
}

/* The length within +-tol, by halving until chord and polygon agree. */
static inline real length(const exact *c, real tol, int depth)
{
    const real p = polygon(c), chord = distance(c->p[0], c->p[3]);
    exact left, right;

    if (p - chord <= 2 * tol || depth == 40)
        return (p + chord) / 2;
    split(c, 0.5L, &left, &right);
    return length(&left, tol / 2, depth + 1) + length(&right, tol / 2, depth + 1);
}

static inline real length_to(const exact *c, real t, real tol)
{
    exact left, right;
    split(c, t, &left, &right);
    return length(&left, tol, 0);
}

static inline uint32_t halvings(const exact *c, real tol)
{
    exact left, right;

    if (distance_from_segment(c->p[1], c->p[0], c->p[3]) <= tol &&
        distance_from_segment(c->p[2], c->p[0], c->p[3]) <= tol)
        return 1;
    split(c, 0.5L, &left, &right);
    return halvings(&left, tol) + halvings(&right, tol);
}

/* between a and b, or beyond */
static inline loft_real part_of(loft_real a, loft_real b, double t)
{
    const double x = arb_value(a) + t * (arb_value(b) - arb_value(a));
    return BY_NUM((loft_real)(x * 65536), (loft_real)x, (loft_real)x);
}

/* Cubics of every kind: arbitrary, closed, with double ends, straight and overshooting, cusped,
 * made of corners, planar, and almost straight with an inflection; from a few LSB to the whole
 * range. */
static inline loft_cubic arb_shape(arb *a)
{
    loft_cubic c = arb_cubic(a, (1 << arb_below(a, 15)));
    const double u = arb_below(a, 4096) / 1024.0 - 1.5, v = arb_below(a, 4096) / 1024.0 - 1.5;

    switch (arb_below(a, 10)) {
    case 0: c.p[3] = c.p[0]; break;
    case 1: c.p[1] = c.p[0]; break;
    case 2:
        c.p[1] = c.p[0];
        c.p[2] = c.p[3];
        break;
    case 3:
    case 4:
        for (int i = 0; i < LOFT_AXES; i++) {
            c.p[0].axis[i] /= 4;
            c.p[3].axis[i] /= 4;
            c.p[1].axis[i] = part_of(c.p[0].axis[i], c.p[3].axis[i], u);
            c.p[2].axis[i] = part_of(c.p[0].axis[i], c.p[3].axis[i], v);
        }
        if (arb_below(a, 2))
            c.p[2].axis[0] += LOFT_REAL(0.01);
        break;
    case 5:                                         /* legs w, w', -w have a cusp if w' is 0 */
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int k = 0; k < 3; k++)
                c.p[k].axis[i] /= 4;
            c.p[2].axis[i] = c.p[1].axis[i] + (arb_below(a, 2) ? c.p[2].axis[i] / 64 : 0);
            c.p[3].axis[i] = c.p[0].axis[i] + (arb_below(a, 2) ? c.p[2].axis[i] / 16 : 0);
        }
        break;
    case 6:                                         /* p0 + p3 - p1 - p2 = -2 (p1 - p2): cusp at
                                                     * 1/2 */
        for (int i = 0; i < LOFT_AXES; i++) {
            for (int k = 0; k < 3; k++)
                c.p[k].axis[i] /= 8;
            c.p[3].axis[i] = c.p[0].axis[i] + c.p[2].axis[i] - c.p[1].axis[i];
            c.p[2].axis[i] = c.p[0].axis[i] + c.p[3].axis[i] - c.p[1].axis[i];
        }
        break;
    case 7:
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                c.p[k].axis[i] = BY_NUM(arb_below(a, 2) ? INT32_MAX : INT32_MIN,
                                        LOFT_REAL(32767) * (arb_below(a, 2) ? 1 : -1),
                                        LOFT_REAL(32767) * (arb_below(a, 2) ? 1 : -1));
        break;
    case 8:
        for (int k = 0; k < 4; k++)
            c.p[k].axis[LOFT_AXES - 1] = 0;
        break;
    }
    return c;
}

static inline real size_of(const exact *c)
{
    real size = 0;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            size = fmaxl(size, fabsl(c->p[k].x[i]));
    return size;
}

/* A tolerance of at least `least` LSB that needs at most a few thousand chords. */
static inline int32_t arb_tol(arb *a, const exact *c, int32_t least)
{
    int64_t raw = least - 1 + ((int32_t)1 << arb_below(a, 20));
    while ((real)raw / 65536 < size_of(c) / (1 << 17))
        raw *= 2;
    return (int32_t)raw;
}

#endif
