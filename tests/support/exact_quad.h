/* tests/support/exact_quad.h -- coordinates in polygons and generalized Bezier patches in 113 bits
 * SPDX-License-Identifier: MIT
 *
 * At any point, by their definitions. Derivatives are differences over a very small step; with 113
 * bits, 50 bits of them are correct.
 */
#ifndef LOFT_TESTS_EXACT_QUAD_H
#define LOFT_TESTS_EXACT_QUAD_H

#include "support/arb_polygon.h"            /* arb_domain */
#include "polygon/gb.h"

__extension__ typedef __float128 quad;

typedef struct {
    quad x, y;
} quad_spot;

static inline quad_spot quad_of(loft_spot p)
{
    const quad_spot r = { exact_of(p.at[0]), exact_of(p.at[1]) };
    return r;
}

static inline quad quad_size(quad x) { return x < 0 ? -x : x; }

static inline quad quad_sqrt(quad x)
{
    quad r = sqrtl((long double)x);

    if (!(r > 0))
        return 0;
    for (int k = 0; k < 2; k++)
        r = (r + x / r) / 2;
    return r;
}

static inline quad quad_cross(quad_spot o, quad_spot a, quad_spot b)
{
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

static inline quad quad_dot(quad_spot o, quad_spot a, quad_spot b)
{
    return (a.x - o.x) * (b.x - o.x) + (a.y - o.y) * (b.y - o.y);
}

static inline quad_spot quad_vertex(const arb_domain *p, unsigned i)
{
    return quad_of(p->v[i % p->n]);
}

static inline void quad_normalize(quad phi[], unsigned n)
{
    quad sum = 0;

    for (unsigned i = 0; i < n; i++)
        sum += phi[i];
    for (unsigned i = 0; i < n; i++)
        phi[i] /= sum;
}

static inline void quad_wachspress(const arb_domain *p, quad_spot at, quad phi[])
{
    const unsigned n = p->n;

    for (unsigned i = 0; i < n; i++) {
        phi[i] = quad_cross(quad_vertex(p, i + n - 1), quad_vertex(p, i), quad_vertex(p, i + 1));
        for (unsigned j = 0; j < n; j++)
            if (j != i && j != (i + n - 1) % n)
                phi[i] *= quad_cross(at, quad_vertex(p, j), quad_vertex(p, j + 1));
    }
    quad_normalize(phi, n);
}

/* Also valid on the edge between the two ends. */
static inline bool quad_linear(unsigned n, unsigned i, const quad r[], quad phi[])
{
    for (unsigned k = 0; k < n; k++)
        phi[k] = k == i ? r[(i + 1) % n] : k == (i + 1) % n ? r[i] : 0;
    quad_normalize(phi, n);
    return true;
}

static inline void quad_meanvalue(const arb_domain *p, quad_spot at, quad phi[])
{
    const unsigned n = p->n;
    quad t[LOFT_SIDES_MAX], r[LOFT_SIDES_MAX];

    for (unsigned i = 0; i < n; i++)
        r[i] = quad_sqrt(quad_dot(at, quad_vertex(p, i), quad_vertex(p, i)));
    for (unsigned i = 0; i < n; i++) {
        const quad cross = quad_cross(at, quad_vertex(p, i), quad_vertex(p, i + 1));
        const quad dot = quad_dot(at, quad_vertex(p, i), quad_vertex(p, i + 1)),
                   rr = r[i] * r[(i + 1) % n];
        if (cross == 0 && dot < 0 && quad_linear(n, i, r, phi))
            return;
        t[i] = dot < 0 ? (rr - dot) / cross : cross / (rr + dot);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = (t[(i + n - 1) % n] + t[i]) / r[i];
    quad_normalize(phi, n);
}

static inline void quad_bernstein(quad out[], unsigned d, quad x, quad y)
{
    for (unsigned k = 0; k <= d; k++) {
        out[k] = loft_binomial(d, k);
        for (unsigned m = 0; m < d; m++)
            out[k] *= m < k ? x : y;
    }
}

/* mu, from alpha and beta. */
static inline quad quad_mu(unsigned d, unsigned j, unsigned k, quad alpha, quad beta)
{
    if (k < 2)
        return j < 2 ? alpha : j > d - 2 ? beta : 1;
    if (j < k || j > d - k)
        return 0;
    return j == k || j == d - k ? (quad)0.5 : 1;
}

/* All weights by definition; 0/0 becomes 1/2. With `split` corners those of their second points. */
static inline void quad_weights(unsigned n, unsigned d, const quad phi[], quad out[], quad split[])
{
    const unsigned last = loft_gb_count(n, d) - 1;
    quad h[LOFT_SIDES_MAX], along[LOFT_DEGREE_MAX + 1], across[LOFT_DEGREE_MAX + 1];

    for (unsigned p = 0; p < last; p++)
        out[p] = 0;
    out[last] = 1;
    for (unsigned i = 0; i < n; i++)
        h[i] = 1 - phi[i] - phi[(i + 1) % n];
    for (unsigned i = 0; i < n; i++) {
        const quad below = phi[i] + phi[(i + 1) % n], left = h[(i + n - 1) % n],
                   right = h[(i + 1) % n];
        const quad alpha = left + h[i] != 0 ? left / (left + h[i]) : (quad)0.5,
                   beta = right + h[i] != 0 ? right / (right + h[i]) : (quad)0.5;

        if (below == 0)
            continue;
        quad_bernstein(along, d, phi[(i + 1) % n] / below, phi[i] / below);
        quad_bernstein(across, d, h[i], below);
        for (unsigned k = 0; k < (d + 1) / 2; k++)
            for (unsigned j = 0; j <= d; j++) {
                const quad w = quad_mu(d, j, k, alpha, beta) * along[j] * across[k];
                if (split && j == d - 1 && k == 1)
                    split[(i + 1) % n] += w;
                else
                    out[loft_gb_place(n, d, i, j, k)] += w;
                out[last] -= w;
            }
    }
}

static inline void quad_point(const loft_gb *g, const quad phi[], quad out[LOFT_AXES])
{
    quad w[201], split[LOFT_SIDES_MAX] = { 0 };
    const unsigned count = loft_gb_count(g->sides, g->degree);

    quad_weights(g->sides, g->degree, phi, w, g->split ? split : NULL);
    for (int i = 0; i < LOFT_AXES; i++) {
        out[i] = 0;
        for (unsigned k = 0; k < count; k++)
            out[i] += w[k] * (quad)exact_of(g->p[k].axis[i]);
        for (unsigned k = 0; k < g->sides && g->split; k++)
            out[i] += split[k] * (quad)exact_of(g->split[k].axis[i]);
    }
}

/* The five derivatives of `count` functions at a point: u, v, uu, uv, vv. */
typedef void (*quad_functions)(const void *of, quad_spot at, quad out[]);

static inline void quad_stencil(quad_functions f, const void *of, unsigned count, quad_spot at,
                                quad step, quad share, quad out[][5])
{
    quad v[3][3][LOFT_SIDES_MAX];

    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            const quad_spot q = { at.x + (a - 1) * step, at.y + (b - 1) * step };
            f(of, q, v[a][b]);
        }
    for (unsigned k = 0; k < count; k++) {
        out[k][0] += share * (v[2][1][k] - v[0][1][k]) / (2 * step);
        out[k][1] += share * (v[1][2][k] - v[1][0][k]) / (2 * step);
        out[k][2] += share * (v[2][1][k] - 2 * v[1][1][k] + v[0][1][k]) / (step * step);
        out[k][3] += share * (v[2][2][k] - v[2][0][k] - v[0][2][k] + v[0][0][k]) /
                     (4 * step * step);
        out[k][4] += share * (v[1][2][k] - 2 * v[1][1][k] + v[1][0][k]) / (step * step);
    }
}

/* Two steps give fourth-order differences. Their error is about step^4 plus 2^-113 / step^2, for
 * functions that change over lengths of 1. */
static inline void quad_differences(quad_functions f, const void *of, unsigned count, quad_spot at,
                                    quad step, quad out[][5])
{
    for (unsigned k = 0; k < count; k++)
        for (int m = 0; m < 5; m++)
            out[k][m] = 0;
    quad_stencil(f, of, count, at, step, (quad)4 / 3, out);
    quad_stencil(f, of, count, at, 2 * step, -(quad)1 / 3, out);
}

static inline quad quad_less(quad a, quad b) { return a < b ? a : b; }

/* The length scale of derivatives of coordinates: the smallest distance of a vertex from an edge
 * that does not end there. For mean values also the distance of the point from a vertex. */
static inline quad quad_scale(const arb_domain *p, quad_spot at, bool mean)
{
    quad least = 1e30L;

    for (unsigned i = 0; i < p->n; i++) {
        const quad_spot a = quad_vertex(p, i), b = quad_vertex(p, i + 1);
        for (unsigned k = 2; k < p->n; k++)
            least = quad_less(least, quad_size(quad_cross(quad_vertex(p, i + k), a, b)) /
                                         quad_sqrt(quad_dot(a, b, b)));
        if (mean)
            least = quad_less(least, quad_sqrt(quad_dot(at, a, a)));
    }
    return least;
}

/* A patch over a polygon, with mean value or Wachspress coordinates. */
typedef struct {
    const loft_gb *g;
    const arb_domain *p;
    bool mean;
} quad_surface;

static inline void quad_surface_at(const void *of, quad_spot at, quad out[])
{
    const quad_surface *s = (const quad_surface *)of;
    quad phi[LOFT_SIDES_MAX];

    if (s->mean)
        quad_meanvalue(s->p, at, phi);
    else
        quad_wachspress(s->p, at, phi);
    quad_point(s->g, phi, out);
}

/* (L N - M^2) / (E G - F^2)^2 with cross products of length D = E G - F^2 in place of unit
 * normals. */
static inline quad quad_gauss(quad s[][5])
{
    quad n[3], dot[5] = { 0 }, square = 0;

    for (int i = 0; i < 3; i++) {
        n[i] = s[(i + 1) % 3][0] * s[(i + 2) % 3][1] - s[(i + 2) % 3][0] * s[(i + 1) % 3][1];
        square += n[i] * n[i];
    }
    for (int k = 2; k < 5; k++)
        for (int i = 0; i < 3; i++)
            dot[k] += n[i] * s[i][k];
    return (dot[2] * dot[4] - dot[3] * dot[3]) / (square * square);
}

#endif
