/* tests/support/tensor_joins.h -- the reference of joins of patches: residues for expressions that
 * must vanish, samples for directions
 * SPDX-License-Identifier: MIT
 *
 * Coordinates are multiples of 2^-16 below 2^15 here. det(A, B, T) is identically zero if it
 * vanishes at 3 n places modulo three primes above 2^60, since its coefficients are below 2^130.
 */
#ifndef LOFT_TESTS_TENSOR_JOINS_H
#define LOFT_TESTS_TENSOR_JOINS_H

#include "support/exact.h"
#include "surface/tensor/tensor_join.h"

__extension__ typedef __int128 tj_wide;

static inline int64_t tj_raw(loft_real x) { return (int64_t)(exact_of(x) * 65536); }

typedef struct {
    int64_t a[LOFT_DEGREE_MAX + 1][3], b[LOFT_DEGREE_MAX + 1][3], t[LOFT_DEGREE_MAX + 1][3];
    unsigned n;
} tj_edge;

static inline int64_t tj_step(const loft_vec *from, const loft_vec *to, int i)
{
    return tj_raw(loft_vec_axis(to, i)) - tj_raw(loft_vec_axis(from, i));
}

static inline tj_edge tj_edge_of(const loft_tensor *p, const loft_tensor *q)
{
    const unsigned w = p->n + 1u;
    const loft_vec *last = p->p + p->m * w;
    tj_edge e = { .n = p->n };

    for (unsigned j = 0; j < w; j++)
        for (int i = 0; i < 3; i++) {
            e.a[j][i] = tj_step(last - w + j, last + j, i);
            e.b[j][i] = tj_step(q->p + j, q->p + w + j, i);
            e.t[j][i] = j < p->n ? tj_step(last + j, last + j + 1, i) : 0;
        }
    return e;
}

static inline tj_wide tj_mod(tj_wide x, tj_wide prime) { return (x % prime + prime) % prime; }

/* sum B_i(v) c_i modulo a prime, v whole */
static inline tj_wide tj_at(const int64_t c[][3], unsigned n, int axis, int64_t v, tj_wide prime)
{
    tj_wide w[LOFT_DEGREE_MAX + 1];
    for (unsigned k = 0; k <= n; k++)
        w[k] = tj_mod(c[k][axis], prime);
    for (unsigned r = 0; r < n; r++)
        for (unsigned k = 0; k < n - r; k++)
            w[k] = tj_mod((1 - v) * w[k] + v * w[k + 1], prime);
    return w[0];
}

static inline bool tj_parallel(const tj_edge *e)
{
    const tj_wide primes[3] = { 2305843009213693951, 2305843009213693921, 2305843009213693907 };

    for (int k = 0; k < 3; k++)
        for (int64_t v = 0; v < 3 * (int64_t)e->n; v++) {
            tj_wide x[3][3], det = 0;
            for (int i = 0; i < 3; i++) {
                x[0][i] = tj_at(e->a, e->n, i, v, primes[k]);
                x[1][i] = tj_at(e->b, e->n, i, v, primes[k]);
                x[2][i] = tj_at(e->t, e->n - 1, i, v, primes[k]);
            }
            for (int i = 0; i < 3; i++) {
                const int j = (i + 1) % 3, l = (i + 2) % 3;
                const tj_wide minor = tj_mod(tj_mod(x[1][j] * x[2][l], primes[k]) -
                                                 tj_mod(x[1][l] * x[2][j], primes[k]),
                                             primes[k]);
                det = tj_mod(det + tj_mod(x[0][i] * minor, primes[k]), primes[k]);
            }
            if (det != 0)
                return false;
        }
    return true;
}

static inline void tj_vector(const int64_t c[][3], unsigned n, long double v, long double out[3])
{
    for (int i = 0; i < 3; i++) {
        long double line[LOFT_DEGREE_MAX + 1];
        for (unsigned k = 0; k <= n; k++)
            line[k] = c[k][i];
        out[i] = exact_eval(line, n, v);
    }
}

static inline long double tj_dot(const long double x[3], const long double y[3])
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
static inline void tj_cross(const long double x[3], const long double y[3], long double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3];
}

/* For parallel normals: 1 one direction, 0 opposite or zero somewhere, -1 too close to zero to tell
 * from samples. */
static inline int tj_one_direction(const tj_edge *e)
{
    int result = 1;

    for (int k = 0; k <= 512; k++) {
        long double a[3], b[3], t[3], x[3], y[3];
        const long double v = k / 512.0L;
        tj_vector(e->a, e->n, v, a);
        tj_vector(e->b, e->n, v, b);
        tj_vector(e->t, e->n - 1, v, t);
        tj_cross(a, t, x);
        tj_cross(b, t, y);
        const long double size_x = tj_dot(x, x), size_y = tj_dot(y, y), dot = tj_dot(x, y);
        if (dot < 0 && dot * dot > 0.25L * size_x * size_y && size_x > 1e4L && size_y > 1e4L)
            return 0;
        if (!(size_x > 1e-6L * tj_dot(a, a) * tj_dot(t, t)) ||
            !(size_y > 1e-6L * tj_dot(b, b) * tj_dot(t, t)) || !(dot > 0))
            result = -1;
    }
    return result;
}

static inline void tj_flags(const loft_tensor *p, const loft_tensor *q, bool *c0, bool *c1, int *g1)
{
    const unsigned w = p->n + 1u;
    const loft_vec *last = p->p + p->m * w;
    const tj_edge e = tj_edge_of(p, q);

    *c0 = *c1 = true;
    for (unsigned j = 0; j < w; j++)
        for (int i = 0; i < LOFT_AXES; i++) {
            *c0 = *c0 && tj_raw(last[j].axis[i]) == tj_raw(q->p[j].axis[i]);
            *c1 = *c1 && p->m * tj_step(last - w + j, last + j, i) ==
                             q->m * tj_step(q->p + j, q->p + w + j, i);
        }
    *c1 = *c0 && *c1;
    *g1 = *c0 && tj_parallel(&e) ? tj_one_direction(&e) : 0;
}

#endif
