/* lib/surface/plane.h -- lines in the plane and planes in space: points, equations, normals
 * SPDX-License-Identifier: MIT
 *
 * A line goes through two points of the plane of the first two axes. A facet is the plane through
 * three points of the first three axes. Axes beyond LOFT_AXES are 0. Plain data, no init.
 *
 *     const loft_facet f = { { p0, p1, p2 } };
 *     if (loft_facet_distance(&f, x, &d) == LOFT_OK && d > 0)     // x is on the side of the normal
 *
 * Everything but a point is computed from whole numbers (num/exact.h) and rounded once. Two equal
 * points define no line, and three points on a line define no plane. Then the equation is 0, and
 * normal and distance return LOFT_SINGULAR. A result that does not fit a coordinate is
 * LOFT_ERR_RANGE. In floats so is a number that loft_exact_valid refuses. Results are untouched
 * after both errors.
 */
#ifndef LOFT_SURFACE_PLANE_H
#define LOFT_SURFACE_PLANE_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

typedef struct {
    loft_vec p[2];
} loft_line;

typedef struct {
    loft_vec p[3];
} loft_facet;

/* The point p0 + s (p1 - p0), and p0 + s (p1 - p0) + t (p2 - p0), in all axes.
 *
 *   range   s, t in -1..2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the point does not fit
 *   error   q16: 1/2 LSB + 2 * 2^-17 LSB   f32: 1/2 ulp of the result + 1/2 ulp   f64: 16 ulp of
 *           the largest coordinate given
 *   cost    one or two wide products per axis; safe in an ISR
 */
enum loft_status loft_line_eval(const loft_line *l, loft_unit s, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_facet_eval(const loft_facet *f, loft_unit s, loft_unit t,
                                 loft_vec *out) LOFT_CHECKED;

/* The coefficients of the equation: a x + b y + c = 0 with (a, b) = (y0 - y1, x1 - x0), c = -(a x0
 * + b y0), and a x + b y + c z + d = 0 with (a, b, c) = (p1 - p0) x (p2 - p0), d = -(a, b, c) p0.
 *
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32: 0.5001 ulp   f64: 1 ulp
 *   cost    3 or 9 exact products, 3 or 4 quotients; not for an ISR
 *   stack   Cortex-M4 1,712   Cortex-M0+ 1,712   ATmega328P 2,075
 */
enum loft_status loft_line_equation(const loft_line *l, loft_real abc[3]) LOFT_CHECKED;
enum loft_status loft_facet_equation(const loft_facet *f, loft_real abcd[4]) LOFT_CHECKED;

/* The left side of the equation at x: the signed distance times the length of (a, b) or (a, b, c).
 *
 *   error   as above
 *   cost    as above, and 2 or 3 exact products more
 */
enum loft_status loft_line_value(const loft_line *l, loft_vec x, loft_real *out) LOFT_CHECKED;
enum loft_status loft_facet_value(const loft_facet *f, loft_vec x, loft_real *out) LOFT_CHECKED;

/* The signed distance of x, positive on the side of the normal: to the left of a line.
 *
 *   range   LOFT_SINGULAR where there is no line or plane
 *   error   as above
 *   cost    as above, and an exact square root
 */
enum loft_status loft_line_distance(const loft_line *l, loft_vec x, loft_real *out) LOFT_CHECKED;
enum loft_status loft_facet_distance(const loft_facet *f, loft_vec x, loft_real *out) LOFT_CHECKED;

/* The unit normal; 0 in the axes that are not used.
 *
 *   range   LOFT_SINGULAR where there is no line or plane
 *   error   q16: 1/2 LSB + 2^-16 LSB, far below 2^-14   f32: 0.5001 ulp   f64: 1 ulp
 *   cost    2 or 9 exact products, an exact root, 2 or 3 quotients; not for an ISR
 */
enum loft_status loft_line_normal(const loft_line *l, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_facet_normal(const loft_facet *f, loft_vec *out) LOFT_CHECKED;

LOFT_END_C

#endif
