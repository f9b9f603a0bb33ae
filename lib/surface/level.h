/* lib/surface/level.h -- a number at each place of a surface: a coordinate, a distance from a
 * plane, the angle of the normal
 * SPDX-License-Identifier: MIT
 *
 * contour.h finds the lines where it has a given value: waterlines, sections by planes at any
 * angle, isophotes and silhouettes.
 *
 *     loft_level level;
 *     if (loft_level_plane(&level, direction, LOFT_REAL(12)) == LOFT_OK &&
 *         loft_contour_init_level(&c, surface, &level, tol, 32, 32, memory, sizeof memory) == ..
 */
#ifndef LOFT_SURFACE_LEVEL_H
#define LOFT_SURFACE_LEVEL_H

#include "surface/surface.h"    /* loft_surface */

LOFT_BEGIN_C

enum loft_level_kind { LOFT_LEVEL_AXIS, LOFT_LEVEL_PLANE, LOFT_LEVEL_LIGHT };

/* Do not fill it yourself: call one of the functions below. */
typedef struct {
    enum loft_level_kind kind;
    unsigned axis;
    loft_vec direction;
    loft_sci length;            /* of the direction */
    loft_real height;           /* or distance, or cosine */
} loft_level;

/* The level where a coordinate has this value; where a plane at a right angle to `direction` is at
 * this distance from 0, on its side; where the normal and `direction` have this cosine: 0 is the
 * silhouette.
 *
 *   range   axis < LOFT_AXES; a direction that is not 0, in the first three axes; cosine -1..1;
 *           otherwise LOFT_ERR_ARG; numbers that are not valid: LOFT_ERR_RANGE; *l is then
 *           untouched
 *   error   the length of the direction: 4 roundings of num/sci.h
 *   cost    a root of num/sci.h; the first one none
 */
enum loft_status loft_level_axis(loft_level *l, unsigned axis, loft_real height) LOFT_CHECKED;
enum loft_status loft_level_plane(loft_level *l, loft_vec direction,
                                  loft_real distance) LOFT_CHECKED;
enum loft_status loft_level_light(loft_level *l, loft_vec direction, loft_real cosine) LOFT_CHECKED;

/* The point at (u, v), and its number less that of the level. Where an edge is one point, as a
 * pole, the normal is its limit from inside. Where a surface has no normal the number is 0.
 *
 *   range   the status of the surface when it has no point there; LOFT_ERR_ARG for the normal of a
 *           surface without `differential`
 *   error   a coordinate: none beyond that of the point. A distance: of the point, and 2^-48 of the
 *           largest coordinate. A cosine: 2^-46 (q16: 2^-32 more) over W of differential.h
 *   cost    a point; a distance 3 products and a quotient of num/sci.h; a cosine also that of the
 *           differential, 9 products, a root
 */
enum loft_status loft_level_at(const loft_level *l, const loft_surface *s, loft_unit u, loft_unit v,
                               loft_vec *point, loft_acc *off) LOFT_CHECKED;

LOFT_END_C

#endif
