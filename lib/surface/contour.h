/* lib/surface/contour.h -- contour lines: curves of equal height, distance or light on a surface
 * SPDX-License-Identifier: MIT
 *
 *     static uint8_t memory[LOFT_CONTOUR_BYTES(32, 32)];
 *     loft_contour c;
 *     if (loft_contour_init(&c, loft_surface_from_tensor(&patch), 2, height, tol, 32, 32, memory,
 *                           sizeof memory) == LOFT_OK)
 *         while ((step = loft_contour_next(&c, &p)) != LOFT_CONTOUR_OVER)
 *             ..              // LOFT_CONTOUR_START: move with the pen up; LOFT_CONTOUR_ON: draw
 *
 * The parameter domain is divided into rows x columns cells of two triangles each. A triangle with
 * corners on both sides of the height is crossed once, from edge to edge. The points are the places
 * where contours cross edges, found on the surface itself. So every curve is complete. It begins
 * and ends on the border, or it is closed and its last point equals its first. It crosses every
 * triangle whose corners it separates exactly once. Details between the corners of the grid, such
 * as a peak within one cell, are not seen: take more rows. With u to the right and v upward, the
 * higher side is to the left of the curve.
 */
#ifndef LOFT_SURFACE_CONTOUR_H
#define LOFT_SURFACE_CONTOUR_H

#include "surface/level.h"        /* loft_level, loft_surface */

LOFT_BEGIN_C

#define LOFT_CONTOUR_MAX 1024  /* rows, columns */

/* The memory that a contour needs, in bytes: one bit per corner, two bits per cell. */
#define LOFT_CONTOUR_BYTES(rows, columns)                                                          \
    ((((rows) + 1ul) * ((columns) + 1ul) + 2ul * (rows) * (columns) + 7) / 8)

/* One of the two triangles of cell (i, j): the one at its corner (i, j), or the upper one. */
typedef struct {
    uint16_t i, j;
    bool upper;
} loft_contour_cell;

/* The state of one search. The struct is complete so that it can be static. Read only u and v: the
 * parameters of the last point. */
typedef struct {
    loft_unit u, v;
    loft_surface surface;
    loft_level level;
    loft_real tol;
    uint8_t *memory;
    uint16_t rows, columns;
    bool walking, closed;       /* on a curve; all curves from the border are done      */
    uint32_t next;              /* the next triangle to search for a start              */
    loft_contour_cell at;
} loft_contour;

/* Evaluate every corner of the grid, to find the curves where coordinate `axis` is `height`.
 *
 *   shape   a triangle: columns = rows; a surface with n sides or n pieces: take multiples of n, so
 *           that grid corners lie on the corners of the surface
 *   range   rows, columns 1..LOFT_CONTOUR_MAX, at least 3 columns on a disk, axis < LOFT_AXES,
 *           tol >= 0, otherwise LOFT_ERR_ARG; `count` >= LOFT_CONTOUR_BYTES(rows, columns),
 *           otherwise LOFT_ERR_SPACE; the status of the surface when it has no point at a corner of
 *           the grid; *c is then undefined. The memory must outlive the search
 *   error   none: a corner exactly at the height counts as higher
 *   cost    (rows + 1) (columns + 1) points of the surface
 */
enum loft_status loft_contour_init(loft_contour *c, loft_surface surface, unsigned axis,
                                   loft_real height, loft_real tol, unsigned rows, unsigned columns,
                                   uint8_t memory[], size_t count) LOFT_CHECKED;

/* The same for any level: a section by a plane, an isophote, a silhouette (level.h). tol is in its
 * unit; the higher side is that of larger distances or cosines.
 *
 *   range   as above; also the status of loft_level_at
 *   error   none, but for that of loft_level_at: a corner closer than that may count as higher
 *   cost    (rows + 1) (columns + 1) times loft_level_at
 */
enum loft_status loft_contour_init_level(loft_contour *c, loft_surface surface,
                                         const loft_level *level, loft_real tol, unsigned rows,
                                         unsigned columns, uint8_t memory[],
                                         size_t count) LOFT_CHECKED;

enum loft_contour_step {
    LOFT_CONTOUR_OVER,          /* there are no more points         */
    LOFT_CONTOUR_START,         /* the first point of a curve       */
    LOFT_CONTOUR_ON             /* the next point of the curve      */
};

/* Give the next point. *out, u and v are untouched when there are no more points.
 *
 *   error   the point is exactly that of the surface at (u, v). Its height is within tol. Where the
 *           surface is too steep for that, (u, v) is one of two neighbouring parameters that
 *           enclose the height (q16: 2^-24 apart   f32: 2^-24   f64: 2^-53)
 *   cost    2 points of the surface and one more per step of the search: mostly 2 to 5, at most 50
 *           (f64: 108); at the start of a curve a test of 2 triangles per cell
 *   see     Lorensen, Cline, Marching cubes (1987), in two dimensions on triangles, which have no
 *           ambiguous case
 */
enum loft_contour_step loft_contour_next(loft_contour *c, loft_vec *out);

LOFT_END_C

#endif
