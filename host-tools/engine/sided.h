/* host-tools/engine/sided.h -- surfaces with n sides: their polygons, their nets, and grids over
 * all of them
 * SPDX-License-Identifier: MIT
 *
 * Whatever its kind, such a patch is cut into kites: each runs from a corner, s along the side that
 * begins there and t along the one that ends there to the middles of both; s = t = 1 is the middle.
 * The line s = 1 of one kite is t = 1 of the next. A polygon is cut along diagonals into convex
 * parts, if it is not one, and each part has a middle and as many kites as sides. They are counted
 * part by part; kite k of a patch of one part is that of corner k.
 */
#ifndef LOFT_HOST_SIDED_H
#define LOFT_HOST_SIDED_H

#include "engine/surface.h"

/* Where a point of such a patch is. */
enum sided_how {
    SIDED_OWN,                  /* its own parameters: LOFT.md */
    SIDED_WITHIN,               /* the same, in a polygon for certain: rounded to a point outside,
                                 * the nearest of its boundary */
    SIDED_SIDE,                 /* spatch, toric, gb: u of the way along side k */
    SIDED_CORNER                /* ring: u of side k - 1, v of side k (three sides: the shares of
                                 * corners k + 1 and k - 1); basepoint: blown up at corner k of the
                                 * triangle, the parameters of loft_basepoint_corner */
};

typedef struct {
    enum sided_how how;
    unsigned k;
    double u, v;
} sided_place;

/* Where (s, t) of kite k is; and, of patches over a polygon, the point of the polygon (0, 0 of
 * others). */
sided_place sided_kite(const surface *patch, unsigned k, double s, double t);
void        sided_spot(const surface *patch, sided_place at, double out[2]);

/* Corner (i, j) of the grid of half x half cells over a kite. Kites share corners: which one of its
 * names is used. */
typedef struct {
    unsigned kite, i, j;
} sided_node;

sided_node sided_owner(const surface *patch, sided_node at, unsigned half);

/* Is the side along which s of a kite runs (t: `before`) one of the patch, no diagonal? */
bool sided_is_border(const surface *patch, unsigned kite, bool before);

/* Is a point in the polygon of such a patch, up to rounding? True where there is no polygon. */
bool sided_has(const surface *patch, double x, double y);

/* Its own parameters in the middle, that of the first part. */
sided_place sided_middle(const surface *patch);

/* Make its polygon what nothing else was said about: regular, in the unit circle, vertex 0 at the
 * top, counterclockwise. */
void sided_regular(surface *patch);

/* Is the polygon one of whole numbers, -32..32, convex, counterclockwise? */
bool sided_is_lattice(const surface *patch);

/* How many sides it has, and points: those that LOFT.md lists, so without those that base points
 * cut off; 0: no polygon. */
unsigned sided_count(const surface *patch);
unsigned sided_points(const surface *patch);

/* Every edge of its net, between two of its points. */
typedef void sided_edge(void *context, const surface_point *from, const surface_point *to);
void sided_net(const surface *patch, sided_edge *each, void *context);

#endif
