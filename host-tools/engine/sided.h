/* host-tools/engine/sided.h -- surfaces with n sides: their polygons, their nets, and grids over
 * them
 * SPDX-License-Identifier: MIT
 *
 * Every kind of patch is cut into kites. Each kite starts at a corner: s runs along the side that
 * begins there, and t along the side that ends there, to the middles of both sides. s = t = 1 is
 * the middle of the patch. The line s = 1 of one kite is t = 1 of the next. A polygon that is not
 * convex is cut along diagonals into convex parts; each part has a middle and as many kites as
 * sides. Kites are numbered part by part: kite k of a patch of one part is that of corner k.
 */
#ifndef LOFT_HOST_SIDED_H
#define LOFT_HOST_SIDED_H

#include "polygon/lattice.h"        /* loft_lattice_polygon */

#include "engine/surface.h"

/* How a place on such a patch is given. */
enum sided_how {
    SIDED_OWN,                  /* its own parameters: LOFT.md */
    SIDED_WITHIN,               /* the same, but certainly in the polygon: a point that rounding
                                 * moves outside becomes the nearest point of the boundary */
    SIDED_SIDE,                 /* spatch, toric, gb: fraction u of the way along side k */
    SIDED_CORNER                /* ring: u of side k - 1, v of side k (three sides: the shares of
                                 * corners k + 1 and k - 1); basepoint: blown up at corner k of the
                                 * triangle, the parameters of loft_basepoint_corner */
};

typedef struct {
    enum sided_how how;
    unsigned k;
    double u, v;
} sided_place;

/* The place (s, t) of kite k. For patches over a polygon also the point of the polygon; (0, 0) for
 * others. */
sided_place sided_kite(const surface *patch, unsigned k, double s, double t);
void        sided_spot(const surface *patch, sided_place at, double out[2]);

/* Corner (i, j) of the grid of half x half cells over a kite. Kites share corners: this finds the
 * one name that is used. */
typedef struct {
    unsigned kite, i, j;
} sided_node;

sided_node sided_owner(const surface *patch, sided_node at, unsigned half);

/* True if the side along which s of a kite runs (t: `before`) is one of the patch, no diagonal. */
bool sided_is_border(const surface *patch, unsigned kite, bool before);

/* True if a point is in the polygon of the patch, up to rounding, or if there is no polygon. */
bool sided_has(const surface *patch, double x, double y);

/* The patch's own parameters in the middle of its first part. */
sided_place sided_middle(const surface *patch);

/* Set the default polygon: regular, in the unit circle, vertex 0 at the top, counterclockwise. */
void sided_regular(surface *patch);

/* True if the polygon is convex and counterclockwise, with integer vertices from -32 to 32. */
bool sided_is_lattice(const surface *patch);

/* The parameters that a patch has at the place s, t of its quarter at a vertex: the point of the
 * polygon of a toric one, the shares of one with base points (polygon/toric_tensor.h). */
void sided_quarter(const surface *patch, const loft_lattice_polygon *lattice, unsigned vertex,
                   double s, double t, double out[2]);

/* The number of sides, and of points: those that LOFT.md lists, without those that base points cut
 * off. 0: the polygon is invalid. */
unsigned sided_count(const surface *patch);
unsigned sided_points(const surface *patch);

/* Visit every edge of the net; each joins two of its points. */
typedef void sided_edge(void *context, const surface_point *from, const surface_point *to);
void sided_net(const surface *patch, sided_edge *each, void *context);

#endif
