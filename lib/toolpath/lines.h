/* lib/toolpath/lines.h -- a ball over a patch, line by line, as cubics: walked by exact forward
 * differences
 * SPDX-License-Identifier: MIT
 *
 * For a controller: no memory but the caller's, a bounded cost per curve. The ball touches the
 * patch P(u, v) along lines of constant u; n is its normal, upward, and the place of the tool
 *
 *     T(u, v) = P + radius (n - z)
 *
 *     static loft_lines l;
 *     static loft_tip   row[COLUMNS + 1];
 *     if (loft_lines_init(&l, &patch, &way, &here, row, COLUMNS + 1) == LOFT_OK)
 *         while (loft_lines_next(&l, &curve, &cuts))
 *             ..                      // from `here`, over the patch, and back to `here`
 *
 * Five grids (surface/tensor/grid.h) walk the patch and the nets of its differences: P, P_u and P_v
 * give T, P_uv and P_vv its derivative. A curve is the cubic of Hermite between two such points.
 */
#ifndef LOFT_TOOLPATH_LINES_H
#define LOFT_TOOLPATH_LINES_H

#include "surface/tensor/grid.h"        /* loft_grid */

LOFT_BEGIN_C

#define LOFT_LINES_DEGREE   3       /* the highest degree along u and along v */
#define LOFT_LINES_REACH    1024    /* the largest coordinate */
#define LOFT_LINES_RADIUS   64      /* the largest radius */
#define LOFT_LINES_LEVELS   4       /* how often a patch is halved to prove that it can be cut */

/* How a patch is cut. */
typedef struct {
    loft_real radius;           /* of the ball */
    loft_real tol;              /* the largest distance of a curve from the line of T */
    loft_real safe;             /* the height of ways over the patch */
    uint16_t rows;              /* steps from line to line: rows + 1 lines */
    uint16_t columns;           /* curves of a line */
    bool one_way;               /* all lines along v, otherwise there and back */
} loft_lines_way;

/* Why a patch cannot be cut so. */
enum loft_lines_fault {
    LOFT_LINES_FINE,
    LOFT_LINES_NORMAL,          /* it has no normal somewhere */
    LOFT_LINES_OVERHANG,        /* its normal is not above the horizon everywhere */
    LOFT_LINES_GOUGE,           /* it curves more than the ball: take a smaller one */
    LOFT_LINES_COARSE,          /* the curves leave the tolerance: take more columns */
    LOFT_LINES_LOW              /* the safe height is below the patch */
};

/* A place of a line, and a third of the derivative there to the next one. */
typedef struct {
    loft_vec tip, handle;
} loft_tip;

/* Lines in progress. The struct is complete so that it can be static; do not rely on its fields. */
typedef struct {
    loft_lines_way way;
    loft_vec u[12], v[12], uv[9], vv[8];        /* differences, those of u and v scaled */
    loft_grid walk[5];
    loft_state memory[LOFT_AXES * 57];
    loft_tip *row;
    loft_vec at, start;
    int32_t scale;              /* of v */
    uint16_t line, place;       /* this line; curves of it that are given */
    uint8_t n, phase;           /* the degree along v */
    bool down;                  /* P_u x P_v looks down */
    bool near;                  /* lines are joined along the edge */
    bool back, mirrored;        /* this line is cut backward; lies backward in `row` */
    bool leaving;
} loft_lines;

/* True if a patch can be cut so. *near: a straight curve may join the ends of two lines.
 *
 *   shape   with the patch below the ball, P_u x P_v may look up or down, everywhere the same way
 *   range   degrees 1..LOFT_LINES_DEGREE, three axes, coordinates within LOFT_LINES_REACH, radius
 *           1/64..LOFT_LINES_RADIUS, tol 1/1024..1, rows and columns 1..1024, otherwise it is not
 *           LOFT_LINES_FINE: LOFT_LINES_COARSE
 *   error   never FINE without a proof, which parts of 1 / 2^LOFT_LINES_LEVELS may fail to give:
 *           the normal is upward; no curvature toward the ball exceeds 1 / radius; the cubics keep
 *           tol, their rounding included. A ball that no part of the patch forces away cuts nothing
 *           of a patch whose outline, from above, is convex
 *   cost    bounds of each part that is looked at, 1 to 341: about 60 lengths and 100 products
 *   stack   Cortex-M4 3,156   Cortex-M0+ 3,264   ATmega328P 2,419
 *   see     lines_check.c
 */
enum loft_lines_fault loft_lines_check(const loft_tensor *s, const loft_lines_way *way, bool *near);

/* Prepare to cut a patch, from `start` and back to it. The net and `row` must outlive the walk.
 *
 *   range   a patch and a way that are LOFT_LINES_FINE, otherwise LOFT_SINGULAR: loft_lines_check
 *           says why; `count` > columns, otherwise LOFT_ERR_SPACE; rows and columns within the law
 *           of loft_grid, otherwise LOFT_ERR_RANGE. *l is then undefined
 *   error   that of loft_lines_next
 *   cost    loft_lines_check, five loft_grid_init, columns + 1 points
 */
enum loft_status loft_lines_init(loft_lines *l, const loft_tensor *s, const loft_lines_way *way,
                                 const loft_vec *start, loft_tip row[], size_t count) LOFT_CHECKED;

/* Give the next curve; it begins where the last one ended. Returns false, and leaves *out alone,
 * when the tool is back at the start.
 *
 *   shape   *cuts: along the patch, down to it, or from line to line along its edge; otherwise a
 *           way up or at the safe height
 *   error   within tol of T, along a line and along its edge. Tips: q16: 2 LSB + radius 2^-24, and
 *           that of a direction of 2^-26 |P_u| |P_v| / |P_u x P_v|   f32: 4 ulp, 2^-20   f64: 2^-24
 *           of the radius
 *   cost    two points of loft_grid_next in five grids, two roots, 24 quotients
 *   see     Farouki, Pythagorean-Hodograph Curves (2008): offsets; de Boor, A Practical Guide to
 *           Splines: cubic Hermite interpolation
 */
bool loft_lines_next(loft_lines *l, loft_cubic *out, bool *cuts);

LOFT_END_C

#endif
