/* lib/polygon/lattice.h -- lattice polygons: whole-number vertices, and the whole points inside
 * SPDX-License-Identifier: MIT
 *
 * h_i(x, y) = normal . (x, y) + offset is 0 on edge i, 1 on the next line of whole points inside,
 * and so on.
 */
#ifndef LOFT_POLYGON_LATTICE_H
#define LOFT_POLYGON_LATTICE_H

#include "polygon/domain.h"     /* LOFT_SIDES_MAX */

LOFT_BEGIN_C

#define LOFT_LATTICE_MAX 32     /* the largest absolute coordinate of a vertex */

typedef struct {
    int8_t at[2];
} loft_whole;

typedef struct {
    loft_whole from, normal;    /* vertex i; the shortest whole vector across edge i, inward      */
    int16_t offset;
    uint8_t length;             /* the number of whole points on the edge, minus one              */
} loft_lattice_edge;

/* Do not fill it yourself: call init. */
typedef struct {
    loft_lattice_edge edge[LOFT_SIDES_MAX];
    loft_whole low, high;       /* the box around it */
    uint8_t sides;
} loft_lattice_polygon;

/* Make a convex lattice polygon.
 *
 *   range   3..8 vertices within -32..32, otherwise LOFT_ERR_ARG; counter-clockwise and strictly
 *           convex, otherwise LOFT_SINGULAR; *l is then untouched
 *   error   none: exact
 *   cost    only small-integer products; 66 bytes
 */
enum loft_status loft_lattice_polygon_init(loft_lattice_polygon *l, const loft_whole v[],
                                           unsigned sides) LOFT_CHECKED;

/* h_edge of a whole point.
 *
 *   range   edge < l->sides; p within -64..64
 *   error   none: exact
 *   cost    2 products of whole numbers
 */
int loft_lattice_polygon_height(const loft_lattice_polygon *l, unsigned edge, loft_whole p);

/* The whole points of the polygon, edges included, row by row upward, from left to right. There is
 * always a first one. next replaces *p by the one after it, and returns false after the last.
 *
 *   error   none
 *   cost    at most `sides` heights for every whole point of the box low..high on the way
 */
void loft_lattice_polygon_first(const loft_lattice_polygon *l, loft_whole *p);
bool loft_lattice_polygon_next(const loft_lattice_polygon *l, loft_whole *p);

/* The number of whole points.
 *
 *   error   none
 *   cost    at most `sides` heights for every whole point of the box low..high
 */
unsigned loft_lattice_polygon_count(const loft_lattice_polygon *l);

LOFT_END_C

#endif
