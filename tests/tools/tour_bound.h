/* tests/tools/tour_bound.h -- a lower bound of the way between open strokes
 * SPDX-License-Identifier: MIT
 *
 * Each end of a stroke has one connection, and all strokes hang together. Without the first
 * condition the shortest connection of all strokes is a spanning tree, one edge from the beginning
 * and a free one to the end of the way. The conditions come back as prices of the ends (Held and
 * Karp, The traveling-salesman problem and minimum spanning trees, Operations Research 18, 1970):
 * for any prices the tree, less the sum of the prices, is at most the shortest way. Prices are
 * raised where an end has too many connections, and lowered where it has none.
 */
#ifndef LOFT_TESTS_TOUR_BOUND_H
#define LOFT_TESTS_TOUR_BOUND_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const double (*end)[2];     /* 2 i and 2 i + 1 of stroke i */
    const double *from;
    size_t count;
    double *price, *step;       /* of an end */
    int *degree;
    double *to_tree;            /* of a stroke that is not in the tree: the cheapest edge, */
    size_t *near, *own;         /* and its ends */
    size_t *rest;
} bounding;

static inline double bound_apart(const double a[2], const double b[2])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

/* Prim's algorithm over strokes; counts the connections of each end. */
static inline double bound_tree(bounding *b)
{
    size_t left = b->count - 1, last = 0;
    double sum  = 0;

    for (size_t s = 0; s < b->count; s++) {
        b->to_tree[s] = HUGE_VAL;
        if (s > 0)
            b->rest[s - 1] = s;
    }
    while (left > 0) {
        size_t best = 0;
        for (size_t k = 0; k < left; k++) {
            const size_t s = b->rest[k];
            for (size_t e = 2 * last; e < 2 * last + 2; e++)
                for (size_t f = 2 * s; f < 2 * s + 2; f++) {
                    const double cost = bound_apart(b->end[e], b->end[f]) + b->price[e] +
                                        b->price[f];
                    if (cost < b->to_tree[s]) {
                        b->to_tree[s] = cost;
                        b->near[s]    = e;
                        b->own[s]     = f;
                    }
                }
            if (b->to_tree[s] < b->to_tree[b->rest[best]])
                best = k;
        }
        last = b->rest[best];
        sum += b->to_tree[last];
        b->degree[b->near[last]]++;
        b->degree[b->own[last]]++;
        b->rest[best] = b->rest[--left];
    }
    return sum;
}

/* The bound for the present prices. */
static inline double bound_now(bounding *b)
{
    size_t first = 0, final = 0;

    memset(b->degree, 0, 2 * b->count * sizeof *b->degree);
    double sum = bound_tree(b);
    for (size_t e = 1; e < 2 * b->count; e++) {
        if (bound_apart(b->from, b->end[e]) + b->price[e] <
            bound_apart(b->from, b->end[first]) + b->price[first])
            first = e;
        if (b->price[e] < b->price[final])
            final = e;
    }
    b->degree[first]++;
    b->degree[final]++;
    sum += bound_apart(b->from, b->end[first]) + b->price[first] + b->price[final];
    for (size_t e = 0; e < 2 * b->count; e++)
        sum -= b->price[e];
    return sum;
}

/* A lower bound of the way from `from` over all strokes, none of them closed, that ends anywhere.
 * `way` is the length of some way; more rounds give a better bound. */
static inline double tour_bound(const double (*end)[2], size_t count, const double from[2],
                                double way, unsigned rounds)
{
    bounding b = { .end     = end,
                   .from    = from,
                   .count   = count,
                   .price   = calloc(2 * count, sizeof(double)),
                   .step    = calloc(2 * count, sizeof(double)),
                   .degree  = calloc(2 * count, sizeof(int)),
                   .to_tree = calloc(count, sizeof(double)),
                   .near    = calloc(count, sizeof(size_t)),
                   .own     = calloc(count, sizeof(size_t)),
                   .rest    = calloc(count, sizeof(size_t)) };
    double best = 0, pace = 1;
    unsigned idle = 0;

    for (unsigned round = 0; round < rounds; round++) {
        const double now = bound_now(&b);
        double off       = 0;
        idle = now > best ? 0 : idle + 1;
        best = fmax(best, now);
        if (idle > 8) {
            pace *= 0.75;
            idle = 0;
        }
        for (size_t e = 0; e < 2 * count; e++)
            off += (b.degree[e] - 1) * (b.degree[e] - 1);
        if (off == 0)               /* the tree is a way: the bound is reached */
            break;
        for (size_t e = 0; e < 2 * count; e++) {
            b.price[e] += pace * fmax(way - now, 0) / off *
                          (0.7 * (b.degree[e] - 1) + 0.3 * b.step[e]);
            b.step[e] = b.degree[e] - 1;
        }
    }
    free(b.price);
    free(b.step);
    free(b.degree);
    free(b.to_tree);
    free(b.near);
    free(b.own);
    free(b.rest);
    return best;
}

#endif
