/* host-tools/engine/harmonic_poles.h -- where the poles of a harmonic series lie
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HARMONIC_POLES_H
#define LOFT_HARMONIC_POLES_H

#include "engine/harmonic_basis.h" /* harmonic_shape, harmonic_place */

#define HARMONIC_CUTS 20000

/* A place of the boundary in a plane, the way to the next one, and 1 over its square. */
typedef struct {
    double x, y, dx, dy, inverse;
} harmonic_root;

/* A place for a pole: the corner whose root's plane it lies in, or the number of sides for that of
 * z; how far the polygon is there; how sparse poles may be, 1 for the usual; whether it lies behind
 * an edge. */
typedef struct {
    unsigned plane;
    harmonic_point at;
    long double room, thin;
    bool behind;
} harmonic_cut;

/* The boundary in all planes, and the places for poles, many more than a series takes. */
typedef struct {
    const harmonic_shape *h;
    harmonic_root *root[HARMONIC_SIDES + 1];
    size_t count;
    harmonic_cut *cut;
    unsigned cuts;
} harmonic_planes;

/* `place` are places around the whole boundary in their order; the shape must outlive *p.
 *
 *   cost    some 0.3 s for 8 sides */
void harmonic_planes_of(const harmonic_shape *h, const harmonic_place place[], size_t count,
                        harmonic_planes *p);

/* Nothing when p->cut is null. */
void harmonic_planes_free(harmonic_planes *p);

/* Give a series that has none its poles, whose distances from a corner grow by `ratio`. */
void harmonic_put_poles(const harmonic_planes *p, long double ratio, harmonic_series *s);

#endif
