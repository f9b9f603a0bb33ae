/* tests/support/exact_spline.h -- the reference of interpolating curves: in 113 bits, by other
 * methods than lib/
 * SPDX-License-Identifier: MIT
 *
 * Natural splines by their second derivatives (lib: by slopes), parabolas by divided differences
 * (lib: over one denominator). Coordinates are rounded to the number type first.
 */
#ifndef LOFT_TESTS_EXACT_SPLINE_H
#define LOFT_TESTS_EXACT_SPLINE_H

#include "support/exact.h"              /* exact_of */
#include "geom/vec.h"
#include "num/sci.h"

__extension__ typedef __float128 quad;

#define SPLINE_POINTS 1200

static inline quad quad_of(loft_real x) { return BY_NUM((quad)x / 65536, (quad)x, (quad)x); }

static inline quad quad_sci(loft_sci x)
{
#if LOFT_NUM == LOFT_Q16
    quad q = (quad)x.m;
    for (int e = x.e; e < 0; e++)
        q /= 2;
    for (int e = x.e; e > 0; e--)
        q *= 2;
    return x.minus ? -q : q;
#else
    return (quad)x;
#endif
}

/* The bound of this number type. Unlike BY_NUM this evaluates all three, so that none is left
 * unused. */
static inline long double bound_by_num(long double q16, long double f32, long double f64)
{
    const long double bound[3] = { q16, f32, f64 };
    return bound[BY_NUM(0, 1, 2)];
}

/* Did the function return a result that fits? Is it within `lsb` in q16, or `room` plus 1/2 ulp in
 * floats? Values that barely fit may be refused. */
static inline void check_result(enum loft_status status, const loft_vec *got,
                                const quad want[LOFT_AXES], long double lsb, long double room)
{
    bool inside = true, outside = false;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double w = (long double)want[i], top = BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX);
        const long double bottom = BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
        inside  = inside && w < top - LSB && w > bottom + LSB;
        outside = outside || w > top + LSB || w < bottom - LSB;
    }
    CHECK(status == LOFT_OK || (status == LOFT_ERR_RANGE && !inside));
    CHECK(status != LOFT_OK || !outside);
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++) {
        const long double floats = ulp((long double)want[i]) / 2 + room;
        CHECK_EXACT((long double)(quad_of(got->axis[i]) - want[i]), 0,
                    bound_by_num(lsb * LSB, floats, floats));
    }
}

/* One Newton step doubles the 64 bits of sqrtl. */
static inline quad quad_sqrt(quad x)
{
    const quad r = sqrtl((long double)x);
    return r > 0 ? (r + x / r) / 2 : 0;
}


/* The parabola through f[i] at t[i] in Newton's form f0 + (t - t0) b + (t - t0) (t - t1) c */
typedef struct {
    quad t[2], f, b, c;
} exact_parabola;

static inline exact_parabola exact_parabola_of(const loft_real t[3], const loft_real f[3])
{
    const quad t0 = quad_of(t[0]), t1 = quad_of(t[1]), t2 = quad_of(t[2]);
    const quad f0 = quad_of(f[0]), f1 = quad_of(f[1]), f2 = quad_of(f[2]);
    const exact_parabola p = { { t0, t1 },
                               f0,
                               (f1 - f0) / (t1 - t0),
                               ((f2 - f1) * (t1 - t0) - (f1 - f0) * (t2 - t1)) /
                                   ((t1 - t0) * (t2 - t1) * (t2 - t0)) };
    return p;
}

static inline quad exact_parabola_blossom(const exact_parabola *p, quad u, quad v)
{
    return p->f + ((u + v) / 2 - p->t[0]) * p->b +
           ((u - p->t[0]) * (v - p->t[1]) + (v - p->t[0]) * (u - p->t[1])) / 2 * p->c;
}

static inline quad exact_parabola_deriv(const exact_parabola *p, quad t)
{
    return p->b + (t - p->t[0] + t - p->t[1]) * p->c;
}

static inline quad exact_parabola_power(const exact_parabola *p, int k)
{
    return k == 2   ? p->c
           : k == 1 ? p->b - (p->t[0] + p->t[1]) * p->c
                    : p->f - p->t[0] * p->b + p->t[0] * p->t[1] * p->c;
}


/* The natural spline: knot distances, points, second derivatives */
typedef struct {
    unsigned count;
    bool coincide;
    quad h[SPLINE_POINTS], p[LOFT_AXES][SPLINE_POINTS], m[LOFT_AXES][SPLINE_POINTS];
} exact_natural;

static inline void exact_natural_solve(exact_natural *s, int axis)
{
    static quad c[SPLINE_POINTS];
    const quad *h = s->h, *p = s->p[axis];
    quad *m = s->m[axis];
    const unsigned n = s->count - 1;

    m[0] = c[0] = 0;
    for (unsigned i = 1; i < n; i++) {
        const quad den = 2 * (h[i-1] + h[i]) - h[i-1] * c[i-1];
        c[i] = h[i] / den;
        m[i] = (6 * ((p[i + 1] - p[i]) / h[i] - (p[i] - p[i - 1]) / h[i - 1]) -
                h[i - 1] * m[i - 1]) /
               den;
    }
    m[n] = 0;
    for (unsigned i = n; i-- > 1; )
        m[i] -= c[i] * m[i+1];
}

static inline void exact_natural_init(exact_natural *s, const loft_vec p[], unsigned count,
                                      bool chord)
{
    s->count = count;
    s->coincide = false;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        for (unsigned i = 0; i < count; i++)
            s->p[axis][i] = quad_of(p[i].axis[axis]);
    for (unsigned i = 0; i + 1 < count; i++) {
        quad squares = 0;
        for (int axis = 0; axis < LOFT_AXES; axis++)
            squares += (s->p[axis][i+1] - s->p[axis][i]) * (s->p[axis][i+1] - s->p[axis][i]);
        s->h[i] = chord ? quad_sqrt(squares) : 1;
        s->coincide = s->coincide || !(s->h[i] > 0);
    }
    for (int axis = 0; axis < LOFT_AXES && !s->coincide; axis++)
        exact_natural_solve(s, axis);
}

/* The k-th derivative of segment i at t with respect to the spline's parameter, k = 0..2 */
static inline quad exact_natural_deriv(const exact_natural *s, unsigned i, unsigned k, quad t,
                                       int axis)
{
    const quad p0 = s->p[axis][i], p1 = s->p[axis][i + 1], m0 = s->m[axis][i],
               m1 = s->m[axis][i + 1], h = s->h[i], u = 1 - t;

    if (k == 0)
        return u * p0 + t * p1 + h * h / 6 * ((u * u * u - u) * m0 + (t * t * t - t) * m1);
    if (k == 1)
        return (p1 - p0) / h + h / 6 * ((1 - 3 * u * u) * m0 + (3 * t * t - 1) * m1);
    return u * m0 + t * m1;
}

/* Control point k of segment i: its ends, and a third of the slope there */
static inline quad exact_natural_point(const exact_natural *s, unsigned i, unsigned k, int axis)
{
    const quad t = k < 2 ? 0 : 1, p = exact_natural_deriv(s, i, 0, t, axis);
    const quad third = s->h[i] * exact_natural_deriv(s, i, 1, t, axis) / 3;
    return k == 1 ? p + third : k == 2 ? p - third : p;
}

#endif
