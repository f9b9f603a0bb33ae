/* lib/surface/contour.h -- waterlines: the curves in which a surface has one height, point by point
 * in their order
 * SPDX-License-Identifier: MIT
 *
 *     static uint8_t memory[LOFT_CONTOUR_BYTES(32, 32)];
 *     loft_contour c;
 *     if (loft_contour_init(&c, loft_surface_from_tensor(&patch), 2, height, tol, 32, 32, memory,
 *     sizeof memory) == LOFT_OK)
 *         while ((step = loft_contour_next(&c, &p)) != LOFT_CONTOUR_OVER)
 *             ..                                  // LOFT_CONTOUR_START: the pen travels there;
 *                                                 LOFT_CONTOUR_ON: it draws
 *
 * The parameters are cut into rows x columns cells of two triangles each. A triangle whose corners
 * are not all on one side of the height is crossed once, from edge to edge; the points are those
 * where contours cross edges, found on the surface itself. So every curve is complete: it begins
 * and ends on the border of the sheet or closes, its last point being the first again, and it runs
 * once through every triangle whose corners it separates. What lies between the corners of the
 * grid, a peak within one cell, is not seen: take more rows. Seen with u to the right and v upward
 * the higher side is to the left.
 */
#ifndef LOFT_SURFACE_CONTOUR_H
#define LOFT_SURFACE_CONTOUR_H

#include "surface/surface.h"      /* loft_surface */

LOFT_BEGIN_C

#define LOFT_CONTOUR_MOST 1024  /* rows, columns */

/* The memory that a contour needs, in bytes: one bit a corner, two bits a cell. */
#define LOFT_CONTOUR_BYTES(rows, columns)                                                          \
    ((((rows) + 1ul) * ((columns) + 1ul) + 2ul * (rows) * (columns) + 7) / 8)

/* One of the two triangles of cell (i, j): that at its corner (i, j), or the upper one. */
typedef struct {
    uint16_t i, j;
    bool upper;
} loft_contour_cell;

/* State of one search. Complete so that it can be static; only u and v are to be read: where the
 * last point lies. */
typedef struct {
    loft_unit u, v;
    loft_surface sheet;
    loft_real height, tol;
    uint8_t *memory;
    uint16_t rows, columns;
    uint8_t axis;
    bool walking, closed;       /* on a curve; all that begin on the border are done    */
    uint32_t next;              /* the triangle to be looked at next for a start        */
    loft_contour_cell at;
} loft_contour;

/* Look at every corner of the grid, for the curves where coordinate `axis` is `height`.
 *
 *   shape   a triangle: columns = rows; a surface of n sides, or one of pieces: multiples of n, of
 *           the pieces, find the corners
 *   range   rows, columns 1..LOFT_CONTOUR_MOST, round sheets from 3 columns on, axis < LOFT_AXES,
 *           tol >= 0, otherwise LOFT_ERR_ARG; `count` >= LOFT_CONTOUR_BYTES(rows, columns),
 *           otherwise LOFT_ERR_SPACE; what the sheet gives when it has no point at a corner of the
 *           grid; *c is undefined then. The memory must outlive the search
 *   error   none: a corner at the height counts as higher
 *   cost    (rows + 1) (columns + 1) points of the sheet
 */
enum loft_status loft_contour_init(loft_contour *c, loft_surface sheet, unsigned axis,
                                   loft_real height, loft_real tol, unsigned rows, unsigned columns,
                                   uint8_t memory[], size_t count) LOFT_CHECKED;

enum loft_contour_step {
    LOFT_CONTOUR_OVER,          /* there is no more                 */
    LOFT_CONTOUR_START,         /* the first point of a curve       */
    LOFT_CONTOUR_ON             /* the next one of it               */
};

/* Give the next point; *out, u and v are untouched when all is over.
 *
 *   error   the point is that of the sheet at (u, v); its height is within tol, or, where the
 *           surface is too steep for that, that of one of two neighbouring parameters (q16: 2^-24
 *           apart   f32: 2^-24   f64: 2^-53) between which the height lies
 *   cost    2 points of the sheet and one more for each guess, by turns a chord and the middle:
 *           mostly 2 to 5, at most 50 (f64: 108); where a curve begins a look at 2 triangles a cell
 *   see     Lorensen, Cline, Marching cubes (1987), in two dimensions on triangles, which have no
 *           ambiguous case
 */
enum loft_contour_step loft_contour_next(loft_contour *c, loft_vec *out);

LOFT_END_C

#endif
