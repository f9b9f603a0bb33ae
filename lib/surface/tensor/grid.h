/* lib/surface/tensor/grid.h -- walk a whole patch at equal parameter steps, row by row, by exact
 * forward differences
 * SPDX-License-Identifier: MIT
 *
 * A walk needs only additions: per axis and point as many as the degree along the row, and per row
 * as many as there are differences, and no multiplication. In q16 nothing is rounded for powers of
 * two (the law of ranges below), so there is no drift. For other numbers of steps the differences
 * are rounded once, at the start; in f32 and f64 the roundings of additions add up. loft_grid_next
 * states how far. The caller provides the memory:
 *
 *     static loft_state memory[LOFT_GRID_STATES(3, 3)];
 *     loft_grid g;
 *     loft_vec  p;
 *     if (loft_grid_init(&g, &patch, 16, 16, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
 *         while (loft_grid_next(&g, &p))
 *             vertex(p);                          // 17 rows of 17 points, edges included
 *
 * The first and the last point of each row, and all points of the first and the last row, equal
 * those of a walk along the edge curve (curve/forward.h), bit for bit. So patches that share an
 * edge share its points.
 *
 * The law of ranges. In 64 bits, 32 of them below the LSB, no value is ever rounded for powers of
 * two with
 *
 *     tensor    m log2 rows + n log2 columns <= 32      bicubic: 32 x 32, 16 x 64
 *     triangle  degree log2 rows <= 32                  cubic: 1024 rows
 *     Coons     m log2 rows + log2 columns <= 32        cubic edges: 256 x 256
 *               and log2 rows + n log2 columns <= 32
 *
 * Other numbers of steps are accepted while S <= 2^32 - 2^22. In the tensor S is (1 + S_m) (1 +
 * S_n) - 1 with S_m = C(rows,1) + .. + C(rows,m) and S_n likewise (bicubic: 73 x 73). In the
 * triangle S is C(2 rows,1) + .. + C(2 rows,degree) (cubic: 1476 rows). The law is the same in
 * every number type.
 */
#ifndef LOFT_SURFACE_TENSOR_GRID_H
#define LOFT_SURFACE_TENSOR_GRID_H

#include "num/walk2.h"                  /* loft_state, loft_walk2 */
#include "surface/tensor/coons.h"       /* loft_coons_bezier */
#include "surface/tensor/tensor.h"      /* loft_tensor */
#include "surface/triangle/triangle.h"  /* loft_triangle */

LOFT_BEGIN_C

/* The memory that a grid needs, in loft_state (8 bytes each). */
#define LOFT_GRID_STATES(m, n)          (LOFT_AXES * ((m) + 1) * ((n) + 1))
#define LOFT_GRID_TRIANGLE_STATES(d)    (LOFT_AXES * ((d) + 1) * ((d) + 2) / 2)

/* The state of one walk. The struct is complete so that it can be static; do not rely on its
 * fields. */
typedef struct {
    loft_walk row[LOFT_AXES], edge[LOFT_AXES];  /* along the current row; along its last points */
    loft_real end[LOFT_AXES];                   /* the last point of this row */
    loft_state *memory;                         /* the differences from row to row, axis by axis */
    size_t states;                              /* the number of states of one axis */
    const loft_vec *last;                       /* the control points of the last row */
    loft_walk2 shape;
    uint32_t at, left;                          /* this row, and its remaining points */
} loft_grid;

/* Prepare to walk a patch in `rows` steps along u and `columns` steps along v.
 *
 *   shape   gives (rows + 1) (columns + 1) points, row by row; v varies within a row
 *   range   degrees 0..5, rows, columns >= 1, otherwise LOFT_ERR_ARG; the law of ranges, any
 *           control points (f32, f64: to LOFT_REAL_MAX / 2^32), otherwise LOFT_ERR_RANGE; `count`
 *           >= LOFT_GRID_STATES(m, n), otherwise LOFT_ERR_SPACE. *g is then untouched. The control
 *           points of the last row and the memory must outlive the walk
 *   error   that of loft_grid_next
 *   cost    that of num/walk2.h per axis
 *   stack   Cortex-M4 716   Cortex-M0+ 828   ATmega328P 671
 */
enum loft_status loft_grid_init(loft_grid *g, const loft_tensor *s, uint32_t rows, uint32_t columns,
                                loft_state memory[], size_t count) LOFT_CHECKED;

/* Prepare to walk a triangle in `rows` rows from the corner T1 to the edge T2 T3.
 *
 *   shape   gives (rows + 1) (rows + 2) / 2 points in the order of a net: row r has r + 1, from the
 *           edge T1 T2 to the edge T1 T3
 *   range   as above, with LOFT_GRID_TRIANGLE_STATES(degree)
 *   error   that of loft_grid_next
 *   cost    as above
 */
enum loft_status loft_grid_triangle_init(loft_grid *g, const loft_triangle *t, uint32_t rows,
                                         loft_state memory[], size_t count) LOFT_CHECKED;

/* Prepare to walk the bilinearly blended Coons patch of the boundaries of `c`.
 *
 *   range   as above, with LOFT_GRID_STATES(m, n); degrees 1..5, one in each pair, and curves that
 *           meet exactly, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE also when a control point of
 *           loft_tensor_from_coons does not fit
 *   error   that of loft_grid_next
 *   cost    as above, plus loft_tensor_from_coons
 *   stack   Cortex-M4 1,188   Cortex-M0+ 1,308   ATmega328P 1,141
 */
enum loft_status loft_grid_coons_init(loft_grid *g, const loft_coons_bezier *c, uint32_t rows,
                                      uint32_t columns, loft_state memory[],
                                      size_t count) LOFT_CHECKED;

/* Give the next point. Returns false, and leaves *out alone, when the walk is over.
 *
 *   error   q16: 1/2 LSB where the law above rounds nothing, otherwise 1/2 LSB + S (2^-33 + 2^-44);
 *           corners: none
 *           f32, f64: with m and n the degrees (triangle: both) (m rows + n columns + 8) 2^(m + n)
 *           / 2^53 of the largest control value, and f32 1/2 ulp more; corners: none
 *   cost    per axis as many additions as the degree along the row; at the start of a row m (n + 1)
 *           + m; safe in an ISR, except for the start of the last row, which initializes a walk
 *   see     Foley, van Dam, Feiner, Hughes: Computer Graphics, ch. 11; Lien, Shantz, Pratt:
 *           Adaptive forward differencing for rendering curves and surfaces, SIGGRAPH 1987
 */
bool loft_grid_next(loft_grid *g, loft_vec *out);

/* Give the next `count` points at once, but at most the rest of this row, so that a row begins with
 * the first point of a call. Returns their number, 0 when the walk is over. The points equal those
 * of loft_grid_next, and come faster.
 *
 *   error   as loft_grid_next
 *   cost    as loft_grid_next, without its calls
 */
uint32_t loft_grid_run(loft_grid *g, loft_vec out[], uint32_t count);

LOFT_END_C

#endif
