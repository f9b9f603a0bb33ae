/* host-tools/sided.h -- surfaces with n sides: their polygons, their nets, and grids over all of them
 * SPDX-License-Identifier: MIT
 *
 * Whatever its kind, such a patch is cut into as many kites as it has sides: kite k runs from corner k, s along side k and
 * t along side k - 1 to the middles of both, s = t = 1 is the middle of the patch. The line s = 1 of one kite is t = 1 of
 * the next.
 */
#ifndef LOFT_HOST_SIDED_H
#define LOFT_HOST_SIDED_H

#include "surface.h"

/* Where a point of such a patch is. */
enum sided_how {
    SIDED_OWN,                  /* its own parameters: LOFT.md                                                      */
    SIDED_SIDE,                 /* spatch, toric, gb: u of the way along side k                                         */
    SIDED_CORNER                /* ring: u of side k - 1, v of side k (three sides: the shares of corners k + 1 and k - 1);
                                 * basepoint: blown up at corner k of the triangle, the parameters of loft_basepoint_corner */
};

typedef struct {
    enum sided_how how;
    unsigned k;
    double u, v;
} sided_place;

/* Where (s, t) of kite k is; and, of patches over a polygon, the point of the polygon (0, 0 of others). */
sided_place sided_kite(const surface *patch, unsigned k, double s, double t);
void        sided_spot(const surface *patch, sided_place at, double out[2]);

/* Its own parameters in the middle. */
sided_place sided_middle(const surface *patch);

/* Make its polygon what nothing else was said about: regular, in the unit circle, vertex 0 at the top, counterclockwise. */
void sided_regular(surface *patch);

/* Is the polygon one of whole numbers, -32..32, convex, counterclockwise? */
bool sided_is_lattice(const surface *patch);

/* How many sides it has, and points: those that LOFT.md lists, so without those that base points cut off; 0: no polygon. */
unsigned sided_count(const surface *patch);
unsigned sided_points(const surface *patch);

/* Every edge of its net, between two of its points. */
typedef void sided_edge(void *context, const surface_point *from, const surface_point *to);
void sided_net(const surface *patch, sided_edge *each, void *context);

#endif
