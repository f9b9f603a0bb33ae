/* lib/polygon/partition.h -- a simple polygon divided along diagonals into convex pieces
 * SPDX-License-Identifier: MIT
 *
 * No vertex is added. Every piece has vertices of the polygon, counter-clockwise, and turns left at
 * each. Two pieces that touch share a whole diagonal. A strictly convex polygon is its only piece.
 *
 *     loft_partition cut;
 *     loft_partition_init(&cut, &domain);
 *     for (k = 0; k < cut.count; k++)
 *         ..                  // vertices domain.v[cut.vertex[k][0 .. cut.sides[k] - 1]]
 */
#ifndef LOFT_POLYGON_PARTITION_H
#define LOFT_POLYGON_PARTITION_H

#include "polygon/domain.h"     /* loft_domain */

LOFT_BEGIN_C

#define LOFT_PARTS_MAX (LOFT_SIDES_MAX - 2)

/* The pieces. Do not fill it yourself: call init. */
typedef struct {
    uint8_t count, sides[LOFT_PARTS_MAX];
    uint8_t vertex[LOFT_PARTS_MAX][LOFT_SIDES_MAX];
} loft_partition;

/* Divide a polygon: repeatedly cut off the largest convex piece behind one diagonal.
 *
 *   shape   count <= sides - 2; the sum of (sides - 2) over all pieces is that of the polygon
 *   error   none: every decision is a sign of a cross product, every piece is strictly convex
 *   cost    convex: sides (sides - 2) cross products; others with 8 sides: 40 to 622; 55
 *           bytes
 *   see     Meisters, Polygons have ears (1975)
 */
void loft_partition_init(loft_partition *p, const loft_domain *d);

LOFT_END_C

#endif
