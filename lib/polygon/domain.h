/* lib/polygon/domain.h -- the polygon that is the parameter domain of a patch with n sides
 * SPDX-License-Identifier: MIT
 *
 * Vertices are counter-clockwise. Edge i runs from vertex i to vertex i + 1; indices begin at 0 and
 * are cyclic. Three decisions are exact in every number type: whether the polygon is simple,
 * whether it is convex, and where a point lies.
 *
 *     static const loft_spot v[5] = { .. };
 *     loft_domain d;
 *     if (loft_domain_init(&d, v, 5) == LOFT_OK && loft_wachspress_eval(&d, p, phi) == LOFT_OK) ..
 *
 *   range   q16: any coordinates   f32, f64: those that loft_exact_valid accepts
 */
#ifndef LOFT_POLYGON_DOMAIN_H
#define LOFT_POLYGON_DOMAIN_H

#include "num/sci.h"    /* loft_sci: areas, and coordinates with respect to the vertices */

LOFT_BEGIN_C

#define LOFT_SIDES_MAX 8

/* A point in the plane of the polygon. */
typedef struct {
    loft_real at[2];
} loft_spot;

/* A simple polygon. The vertices are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_spot *v;
    loft_sci corner[LOFT_SIDES_MAX];    /* twice the area of vertices i - 1, i, i + 1 */
    uint8_t sides;
    bool convex;                        /* strictly: every inner angle is below half a turn */
} loft_domain;

/* The side of the line from a to b on which c is: 1 left, -1 right, 0 on it.
 *
 *   range   f32, f64: points that loft_spot_valid accepts
 *   error   none: exact
 *   cost    a cross product
 */
int loft_spot_turn(const loft_spot *a, const loft_spot *b, const loft_spot *c);

/* The kind of a closed chain of points. */
enum loft_outline {
    LOFT_OUTLINE_CONVEX,        /* counter-clockwise, every corner turns left */
    LOFT_OUTLINE_SIMPLE,        /* counter-clockwise, not convex; no two edges touch */
    LOFT_OUTLINE_CLOCKWISE,     /* simple, but in reversed order */
    LOFT_OUTLINE_BROKEN         /* edges cross, touch or have no length */
};

/* Classify `sides` points, 3..8, in any order.
 *
 *   error   none: exact
 *   cost    sides * (sides + 1) * 2 cross products at most
 */
enum loft_outline loft_outline_of(const loft_spot v[], unsigned sides);

/* Find two edges that make a chain of 3..8 points broken: they cross or touch, one of them has no
 * length, or the second follows the first and folds back onto it. False when there are none.
 *
 *   shape   edge[2], undefined when there are none
 *   error   none: exact
 *   cost    as loft_outline_of
 */
bool loft_outline_fault(const loft_spot v[], unsigned sides, unsigned edge[2]);

/* Make a domain of `sides` vertices, which must outlive it.
 *
 *   range   3..8 vertices, simple and counter-clockwise; LOFT_ERR_ARG for other counts or
 *           clockwise, LOFT_SINGULAR for a broken outline, LOFT_ERR_RANGE for coordinates beyond
 *           the range; *d is then untouched
 *   error   that of loft_sci_cross in corner[], otherwise none: the vertices are borrowed
 *   cost    as loft_outline_of and `sides` cross products more; the domain takes 136 bytes in q16
 *           on a 32-bit core, 72 in floats
 */
enum loft_status loft_domain_init(loft_domain *d, const loft_spot v[], unsigned sides) LOFT_CHECKED;

/* The place of a point. */
enum loft_place {
    LOFT_OUTSIDE,
    LOFT_INSIDE,
    LOFT_ON_EDGE,               /* *index is the edge, p not one of its ends */
    LOFT_AT_VERTEX              /* *index is the vertex                      */
};

/* Find where p lies, and the areas it makes: area[i] is twice the signed area of p, vertex i,
 * vertex i + 1.
 *
 *   shape   area[sides]; *index is written only for an edge or a vertex
 *   range   f32, f64: p that loft_spot_valid accepts
 *   error   none: exact; areas: that of loft_sci_cross
 *   cost    `sides` cross products
 */
enum loft_place loft_domain_place(const loft_domain *d, loft_spot p, loft_sci area[],
                                  unsigned *index);

/* The coordinates of a point on an edge or at a vertex: linear on the edge, 0 for every other
 * vertex.
 *
 *   shape   phi[d->sides]
 *   error   q16: 2^-60 of each   f32, f64: 2^-51; none at a vertex, and none where the number type
 *           holds the quotient exactly
 *   cost    2 divisions
 */
void loft_domain_edge(const loft_domain *d, loft_spot p, unsigned edge, loft_sci phi[]);
void loft_domain_vertex(const loft_domain *d, unsigned vertex, loft_sci phi[]);

/* The coordinates of the point of the boundary that is nearest to p, for points that rounding has
 * moved outside.
 *
 *   shape   phi[d->sides]
 *   error   q16: 2^-56 of each   f32, f64: 2^-48; either edge may be taken when two distances
 *           differ by less than that part of the polygon's size
 *   cost    9 products and a division per side
 */
void loft_domain_nearest(const loft_domain *d, loft_spot p, loft_sci phi[]);

/* True if this point has exact coordinates: always in q16.
 *
 *   error   none
 *   cost    floats: that of loft_exact_valid twice
 */
bool loft_spot_valid(loft_spot p);

LOFT_END_C

#endif
