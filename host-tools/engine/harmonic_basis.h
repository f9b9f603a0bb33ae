/* host-tools/engine/harmonic_basis.h -- the terms of a harmonic series, and how narrow a polygon is
 * along its edges
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HARMONIC_BASIS_H
#define LOFT_HARMONIC_BASIS_H

#include <complex.h>

#include "engine/harmonic_solver.h"       /* harmonic_series */

#define HARMONIC_PI 3.14159265358979323846264338327950288L

typedef long double complex harmonic_point;

/* What the solution, continued over an edge, is singular at: the point of the edge that is nearest
 * to it, how far along, how near, and where it is. Mostly this is the mirror image, in the edge's
 * line, of a vertex or of such an image; or it is a vertex that is hidden behind other edges. */
typedef struct {
    unsigned edge;
    long double along, room;
    harmonic_point at, image;
    bool hidden;
} harmonic_foot;

/* Vertices before or behind an edge, and images of images in the other edges. */
#define HARMONIC_FEET (HARMONIC_SIDES * HARMONIC_SIDES * (HARMONIC_SIDES - 2))

/* A polygon as the terms see it. */
typedef struct {
    unsigned sides;
    harmonic_point v[HARMONIC_SIDES], middle;
    long double reach,
        far[HARMONIC_SIDES]; /* from the middle, from each corner, to the farthest vertex */
    long double angle[HARMONIC_SIDES],
        start[HARMONIC_SIDES]; /* at the corner; the direction of the edge that leaves */
    long double turn[HARMONIC_SIDES]
                    [HARMONIC_SIDES]; /* as in loft_harmonic_corner                           */
    long double room[HARMONIC_SIDES]; /* of a corner: how near the next edge is */
    harmonic_foot foot[HARMONIC_FEET];
    unsigned feet;
} harmonic_shape;

void harmonic_shape_of(double v[][2], unsigned sides, harmonic_shape *out);

/* All terms of the series at z, in its order. `edge` is the one that z lies on, or -1 for a point
 * inside. */
void harmonic_terms(const harmonic_shape *h, const harmonic_series *s, harmonic_point z, int edge,
                    long double out[]);

/* ln((z - v) / far) at a corner, with the angle followed along the boundary. */
harmonic_point harmonic_log(const harmonic_shape *h, unsigned at, harmonic_point z, int edge);

/* The edge that z lies on within the rounding of doubles, or -1. */
int harmonic_edge_at(const harmonic_shape *h, harmonic_point z);

/* A place on the boundary, and its distance along the edge. */
typedef struct {
    unsigned edge;
    long double along;
    harmonic_point at;
} harmonic_place;

/* Walk along the edges, from each vertex, in steps of `step` times the distance from the nearest
 * vertex or foot, or twice that from a pole of the series, but `least` of them on every edge. Gives
 * how many places there are, `most` at most are written.
 *
 *   shape   out[most]; s may be null */
size_t harmonic_walk(const harmonic_shape *h, const harmonic_series *s, long double step,
                     unsigned least, harmonic_place out[], size_t most);

/* A bound of the error on the whole boundary, at most about 1.5 times the largest error there when
 * `sampled` is about that one. Infinite when there is none. Sets s->points. */
long double harmonic_bound(const harmonic_shape *h, harmonic_series *s, long double sampled);

#endif
