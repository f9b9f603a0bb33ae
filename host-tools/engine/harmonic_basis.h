/* host-tools/engine/harmonic_basis.h -- the terms of a harmonic series, and how narrow a polygon is
 * along its edges
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HARMONIC_BASIS_H
#define LOFT_HARMONIC_BASIS_H

#include <complex.h>

#include "engine/harmonic.h"       /* harmonic_series */

#define HARMONIC_PI 3.14159265358979323846264338327950288L

typedef long double complex harmonic_point;

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
} harmonic_shape;

void harmonic_shape_of(double v[][2], unsigned sides, harmonic_shape *out);

/* All terms of the series at z, in its order. `edge` is the one that z lies on, or -1 for a point
 * inside. */
void harmonic_terms(const harmonic_shape *h, const harmonic_series *s, harmonic_point z, int edge,
                    long double out[]);

/* A place on the boundary: its distance along the edge, how narrow the polygon is there. */
typedef struct {
    unsigned edge;
    long double along, narrow;
    harmonic_point at;
} harmonic_place;

/* Walk along the edges in steps of `step` times the narrowness, which near a vertex is the distance
 * from it, at least 2^-depth
 * of the edge, but `least` of them on every edge. Gives how many places there are, `most` at most
 * are written.
 *
 *   shape   out[most] */
size_t harmonic_walk(const harmonic_shape *h, long double step, unsigned least, int depth,
                     harmonic_place out[], size_t most);

/* Is z outside? And how far from the boundary? */
bool harmonic_outside(const harmonic_shape *h, harmonic_point z);
long double harmonic_distance(const harmonic_shape *h, harmonic_point z);

/* How far one can go from a place of the boundary straight out until the boundary is met again; at
 * most `most`. */
long double harmonic_clearance(const harmonic_shape *h, const harmonic_place *from,
                               long double most);

#endif
