/* host-tools/geometry/reference_surface.c -- surfaces by their definitions, in long double
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "geometry/reference_surface.h"

#define MOST (SURFACE_DEGREE_MAX + 1)

static long double power(long double x, unsigned n)
{
    long double y = 1;

    while (n-- > 0)
        y *= x;
    return y;
}

static long double factorial(unsigned n)
{
    long double y = 1;

    for (; n > 1; n--)
        y *= n;
    return y;
}

static void bernstein(unsigned n, long double t, long double out[MOST])
{
    for (unsigned i = 0; i <= n; i++)
        out[i] = factorial(n) / factorial(i) / factorial(n - i) * power(t, i) * power(1 - t, n - i);
}

/* A weighted sum of points, divided by the sum of the weights. */
typedef struct {
    long double p[SURFACE_AXES], w;
} sum;

static void add(sum *to, const surface_point *p, long double b)
{
    for (int i = 0; i < SURFACE_AXES; i++)
        to->p[i] += b * (long double)p->w * (long double)p->p[i];
    to->w += b * (long double)p->w;
}

static void tensor_sum(const surface *s, long double u, long double v, sum *out)
{
    long double bu[MOST], bv[MOST];

    bernstein(s->m, u, bu);
    bernstein(s->n, v, bv);
    for (unsigned i = 0; i <= s->m; i++)
        for (unsigned j = 0; j <= s->n; j++)
            add(out, &s->point[i * (s->n + 1) + j], bu[i] * bv[j]);
}

/* The order of the points: i of the first corner descends, then j of the second. */
static void triangle_sum(const surface *s, long double u, long double v, sum *out)
{
    const surface_point *p = s->point;

    for (unsigned row = 0; row <= s->m; row++)
        for (unsigned k = 0; k <= row; k++, p++) {
            const unsigned i = s->m - row, j = row - k;
            add(out, p,
                factorial(s->m) / factorial(i) / factorial(j) / factorial(k) * power(1 - u - v, i) *
                    power(u, j) * power(v, k));
        }
}

static void hermite(long double t, long double out[4])
{
    out[0] = (1 + 2 * t) * (1 - t) * (1 - t);
    out[1] = t * t * (3 - 2 * t);
    out[2] = t * (1 - t) * (1 - t);
    out[3] = t * t * (t - 1);
}

/* The matrix of corners and derivatives; derivatives have no weight. */
static void bicubic_sum(const surface *s, long double u, long double v, sum *out)
{
    long double fu[4], fv[4];

    hermite(u, fu);
    hermite(v, fv);
    for (unsigned i = 0; i < 4; i++)
        for (unsigned j = 0; j < 4; j++)
            for (int k = 0; k < SURFACE_AXES; k++)
                out->p[k] += fu[i] * fv[j] * (long double)s->point[4 * i + j].p[k];
    out->w = 1;
}

/* Both ruled surfaces less the bilinear one. */
static void coons_sum(const surface *s, long double u, long double v, sum *out)
{
    const surface_point *along = s->point, *across = along + 2 * (s->m + 1);
    long double bu[MOST], bv[MOST];

    bernstein(s->m, u, bu);
    bernstein(s->n, v, bv);
    for (unsigned i = 0; i <= s->m; i++) {
        add(out, &along[i], bu[i] * (1 - v));
        add(out, &along[s->m + 1 + i], bu[i] * v);
    }
    for (unsigned j = 0; j <= s->n; j++) {
        add(out, &across[j], bv[j] * (1 - u));
        add(out, &across[s->n + 1 + j], bv[j] * u);
    }
    add(out, &along[0], -(1 - u) * (1 - v));
    add(out, &along[s->m], -u * (1 - v));
    add(out, &along[s->m + 1], -(1 - u) * v);
    add(out, &along[2 * s->m + 1], -u * v);
}

static void sphere_sum(const surface *s, long double u, long double v, sum *out)
{
    const long double pi = acosl(-1), r = (long double)s->radius;
    const long double across = r * sinl(pi * u);

    out->p[0] = across * cosl(2 * pi * v);
    out->p[1] = across * sinl(2 * pi * v);
    out->p[2] = r * cosl(pi * u);
    for (int i = 0; i < SURFACE_AXES && s->count > 0; i++)
        out->p[i] += (long double)s->point[0].p[i];
    out->w = 1;
}

bool reference_surface(const surface *s, long double u, long double v,
                       long double out[SURFACE_AXES])
{
    sum all = { { 0, 0, 0 }, 0 };

    if (s->kind == SURFACE_TENSOR)
        tensor_sum(s, u, v, &all);
    else if (s->kind == SURFACE_TRIANGLE)
        triangle_sum(s, u, v, &all);
    else if (s->kind == SURFACE_BICUBIC)
        bicubic_sum(s, u, v, &all);
    else if (s->kind == SURFACE_COONS && s->orders == 1)
        coons_sum(s, u, v, &all);
    else if (s->kind == SURFACE_SPHERE)
        sphere_sum(s, u, v, &all);
    else
        return false;
    for (int i = 0; i < SURFACE_AXES; i++)
        out[i] = all.p[i] / all.w;
    return true;
}
