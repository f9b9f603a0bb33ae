/* host-tools/engine/harmonic_bound.c -- the error of a harmonic series on the whole boundary
 * SPDX-License-Identifier: MIT
 *
 * An edge is cut into intervals, on each of which the error e is an analytic function of the
 * distance t along the edge; next to a vertex, of the root of t. Let C bound e on the ellipse with
 * foci at the interval's ends and semi-axes of sum rho half lengths. Then a polynomial of degree N
 * is within E = 2 C rho^-N / (rho - 1) of e. Let S be the largest |e| at the M Chebyshev points. A
 * polynomial of degree N is at most 1 / cos(pi N / 2 M) times as large between them, so
 *
 *     |e| <= (S + E) / cos(pi N / 2 M) + E
 *
 * C comes from the sizes of the terms in a disk around the ellipse. A power of a corner counts
 * nothing on that corner's own edges: its imaginary part is 0 there. Products of sizes and of
 * coefficients are summed in double: none is negative, so the sum errs by 2^-52 of it for each.
 *
 *   see     Ehlich, Zeller, Schwankung von Polynomen zwischen Gitterpunkten (1964); Trefethen,
 *           Approximation Theory and Approximation Practice (2013), theorem 8.2
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/harmonic_basis.h"
#include "base/memory.h"   /* memory_grow */

#define DEGREE  20
#define SAMPLES 40 /* so that the cosine is that of 45 degrees */
#define BETWEEN 1.41421356237309504880168872420969808L

/* A disk that lies on an edge. `vertex` is the corner whose interval it is about, or -1. */
typedef struct {
    harmonic_point middle;
    long double radius;
    unsigned edge;
    int vertex;
} disk;

typedef struct {
    const harmonic_shape *h;
    const harmonic_series *s;
    long double enough; /* an E that does not matter */
    long double *term;
    double (*size)[HARMONIC_SIDES]; /* of the coefficients, term by term; 0 beyond the sides */
    unsigned points;
} proof;

static bool is_own_edge(const harmonic_shape *h, unsigned corner, unsigned edge)
{
    return edge == corner || (edge + 1) % h->sides == corner;
}

/* The largest |Re f|, |Im f| of the two terms of a pole whose distance from the disk is known. */
static long double *put_pole_sizes(long double size, long double distance, long double *out)
{
    const long double most = distance > 0 ? size / distance : INFINITY;

    *out++ = most;
    *out++ = most;
    return out;
}

static long double *corner_sizes(const proof *p, const disk *d, unsigned i,
                                 const long double (*pole)[3], long double *out)
{
    const harmonic_shape *h = p->h;
    const harmonic_series *s = p->s;
    const bool own = is_own_edge(h, i, d->edge), centre = d->vertex == (int)i;
    const long double a = HARMONIC_PI / h->angle[i], off = centre ? 0 : cabsl(d->middle - h->v[i]),
                      far = h->far[i], near = (off - d->radius) / far,
                      most = (off + d->radius) / far;
    harmonic_point l = 0, root = 0;
    long double moved = sqrtl(most); /* of the root, in the disk */

    if (!centre && near > 0) {
        l = harmonic_log(h, i, d->middle, (int)d->edge);
        root = cexpl(l / 2);
        moved = d->radius / far / (2 * sqrtl(near));
    } else if (!centre) {
        moved = INFINITY;
    }
    const long double log_most = fmaxl(fabsl(logl(near > 0 ? near : most)), fabsl(logl(most))) +
                                 fabsl(cimagl(l)) + HARMONIC_PI / 2;
    for (unsigned k = 1; k <= s->powers[i]; k++) {
        if (k == 1 && s->straight >> i & 1)
            *out++ = own ? 4.2L * most : most * log_most * expl(fabsl(a - 1) * log_most);
        else
            *out++ = own ? 0 : powl(most, a * k);
        if (!own && !(near > 0))
            out[-1] = INFINITY;
    }
    for (unsigned k = 0; k < s->corner_poles[i]; k++)
        out = put_pole_sizes(pole[k][2], cabsl(root - (pole[k][0] + I * pole[k][1])) - moved, out);
    return out;
}

/* The largest sum, over the coordinates, of coefficients times sizes of terms. */
static double largest_sum(const proof *p)
{
    double sum[HARMONIC_SIDES] = { 0 }, most = 0;

    for (unsigned k = 0; k < p->s->terms; k++) {
        const double term = (double)p->term[k], *size = p->size[k];
        if (isfinite(term))
            for (unsigned i = 0; i < HARMONIC_SIDES; i++)
                sum[i] += term * size[i];
        else
            for (unsigned i = 0; i < HARMONIC_SIDES; i++)
                sum[i] += size[i] > 0 ? INFINITY : 0;
    }
    for (unsigned i = 0; i < HARMONIC_SIDES; i++)
        most = fmax(most, sum[i]);
    return most * (1 + 0x1p-40);
}

/* C */
static long double size_in_disk(const proof *p, const disk *d)
{
    const harmonic_series *s = p->s;
    const long double(*pole)[3] = s->pole;
    long double *out = p->term;

    for (unsigned i = 0; i < s->sides; pole += s->corner_poles[i++])
        out = corner_sizes(p, d, i, pole, out);
    for (unsigned i = 0; i < s->poles; i++, pole++)
        out = put_pole_sizes((*pole)[2],
                             cabsl(d->middle - ((*pole)[0] + I * (*pole)[1])) - d->radius, out);
    const long double t = (cabsl(d->middle - p->h->middle) + d->radius) / p->h->reach;
    *out++ = 1;
    for (unsigned k = 1; k <= s->degree; k++, out += 2)
        out[0] = out[1] = powl(t, k);
    return largest_sum(p);
}

/* E of an interval of distances from the edge's start, or, for a vertex, of that length from it:
 * the least one of some ellipses. */
static long double interval_rest(const proof *p, unsigned edge, int vertex, long double from,
                                 long double length)
{
    const harmonic_point a = p->h->v[edge], d = p->h->v[(edge + 1) % p->h->sides] - a;
    long double best = INFINITY;

    for (long double rho = 2.5L; rho < 30; rho *= 2) {
        const long double axis = (rho + 1 / rho) / 2, root = (1 + axis) / 2;
        const disk in = { vertex < 0 ? a + d / cabsl(d) * (from + length / 2) : p->h->v[vertex],
                          vertex < 0 ? axis * length / 2 : root * root * length, edge, vertex };
        best = fminl(best, 2 * size_in_disk(p, &in) * powl(rho, -DEGREE) / (rho - 1));
    }
    return best;
}

static long double error_at(proof *p, unsigned edge, long double along)
{
    const harmonic_shape *h = p->h;
    const harmonic_series *s = p->s;
    const unsigned after = (edge + 1) % h->sides;
    const harmonic_point d = h->v[after] - h->v[edge];
    const long double share = along / cabsl(d);
    long double most = 0;

    harmonic_terms(h, s, share < 0.5L ? h->v[edge] + d * share : h->v[after] - d * (1 - share),
                   (int)edge, p->term);
    for (unsigned i = 0; i < s->sides; i++) {
        long double sum = i == edge ? share - 1 : i == after ? -share : 0;
        for (unsigned k = 0; k < s->terms; k++)
            sum += p->term[k] * s->coefficient[k * s->sides + i];
        most = fmaxl(most, fabsl(sum));
    }
    p->points++;
    return most;
}

static long double interval_bound(proof *p, unsigned edge, int vertex, long double from,
                                  long double length, long double rest)
{
    const long double whole = cabsl(p->h->v[(edge + 1) % p->h->sides] - p->h->v[edge]);
    long double most = 0;

    for (int k = 0; k < SAMPLES; k++) {
        const long double x = (1 - cosl(HARMONIC_PI * (k + 0.5L) / SAMPLES)) / 2,
                          t = vertex < 0            ? from + length * x
                              : vertex == (int)edge ? length * x * x
                                                    : whole - length * x * x;
        most = fmaxl(most, error_at(p, edge, t));
    }
    return (most + rest) * BETWEEN + rest;
}

/* The interval next to a vertex; *length is what it takes. */
static long double vertex_bound(proof *p, unsigned edge, unsigned vertex, long double *length)
{
    long double rest = 0;

    for (*length = p->h->room[vertex] / 8; *length > p->h->room[vertex] * 0x1p-60L; *length /= 2) {
        rest = interval_rest(p, edge, (int)vertex, 0, *length);
        if (rest <= p->enough)
            return interval_bound(p, edge, (int)vertex, 0, *length, rest);
    }
    return INFINITY;
}

static long double edge_bound(proof *p, unsigned edge)
{
    const unsigned after = (edge + 1) % p->h->sides;
    const long double whole = cabsl(p->h->v[after] - p->h->v[edge]);
    long double first, last, bound = vertex_bound(p, edge, edge, &first);

    bound = fmaxl(bound, vertex_bound(p, edge, after, &last));
    /* The last interval overlaps, so that rounding leaves no gap. */
    for (long double from = first, length = first; from < whole - last && bound < INFINITY;) {
        length = fminl(length, whole - 0.99L * last - from);
        const long double rest = interval_rest(p, edge, -1, from, length);
        if (rest <= p->enough) {
            bound = fmaxl(bound, interval_bound(p, edge, -1, from, length, rest));
            from += length;
            length *= 2;
        } else if ((length /= 1.5L) < whole * 0x1p-50L) {
            return INFINITY;
        }
    }
    return bound;
}

long double harmonic_bound(const harmonic_shape *h, harmonic_series *s, long double sampled)
{
    const long double rounding = s->weight * 0x1p-58L; /* of the samples themselves */
    proof p = { h,
                s,
                fmaxl(sampled / 32, rounding),
                memory_grow(NULL, s->terms * sizeof *p.term),
                memory_grow(NULL, s->terms * sizeof *p.size),
                0 };
    long double bound = 0;

    for (unsigned k = 0; k < s->terms; k++)
        for (unsigned i = 0; i < HARMONIC_SIDES; i++)
            p.size[k][i] = i < s->sides ? (double)fabsl(s->coefficient[k * s->sides + i]) : 0;

    for (unsigned e = 0; e < h->sides; e++)
        bound = fmaxl(bound, edge_bound(&p, e));
    free(p.term);
    free(p.size);
    s->points = p.points;
    return bound + rounding;
}
