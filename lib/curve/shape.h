/* lib/curve/shape.h -- the shape of a curve: its kind, its inflections and its curvature, decided
 * exactly
 * SPDX-License-Identifier: MIT
 *
 * Every decision here is a sign of integers (num/exact.h). It is exact for the given control
 * points, even if they are one LSB away from another answer. `In the plane` means in the first two
 * axes.
 *
 *     loft_shape s;
 *     if (loft_cubic_shape(&c, &s) == LOFT_OK && s.kind == LOFT_LOOP)
 *         ...
 *
 * In f32 and f64 coordinates must pass loft_exact_valid: 0, or from 1.4e-17 to 1048575 in
 * magnitude. Otherwise the result is LOFT_ERR_RANGE, and nothing is written.
 */
#ifndef LOFT_CURVE_SHAPE_H
#define LOFT_CURVE_SHAPE_H

#include "curve/bezier.h"       /* loft_cubic, loft_bezier */

LOFT_BEGIN_C

/* The kinds of a planar cubic as a whole: for all t, not only 0..1. */
enum loft_shape_kind {
    LOFT_POINT,             /* all four control points coincide                                 */
    LOFT_LINE,              /* the control points lie on a line, and so does the curve          */
    LOFT_PARABOLA,          /* the degree is 2                                                  */
    LOFT_SERPENTINE,        /* two inflections                                                  */
    LOFT_CUSP,              /* one point where it stops and turns back                          */
    LOFT_LOOP,              /* it crosses itself; no inflection                                 */
    LOFT_CUSP_AT_INFINITY   /* one inflection; as a graph y = x^3 + a x over a line             */
};

typedef struct {
    enum loft_shape_kind kind;
    uint8_t inflections, cusps, loops;  /* the numbers within the ranges below: 0..2, 0..1, 0..1 */
    loft_unit inflection[2];            /* where the curvature changes sign, t in 0..1 without the
                                         * ends (rounding may return them), ascending */
    loft_unit cusp;                     /* t in 0..1 with the ends */
    loft_unit loop[2];                  /* the two parameters of the crossing, both in 0..1 with the
                                         * ends, ascending */
} loft_shape;

/* The kind of a planar cubic, its inflections, cusp or crossing.
 *
 *   error   none in the kind and the counts; parameters q16: 2^-25 + 2^-33   f32, f64: 1 ulp +
 *           2^-65
 *   cost    q16: about 30 exact products, a root and 2 quotients
 *   stack   Cortex-M4 3,160   Cortex-M0+ 3,536   ATmega328P 4,169
 *   see     Stone, DeRose, A geometric characterization of parametric cubic curves (ACM TOG 8,
 *           1989); Su, Liu, Computational Geometry
 */
enum loft_status loft_cubic_shape(const loft_cubic *c, loft_shape *out) LOFT_CHECKED;

/* The curvature at t, never negative, and the direction of the curve as a unit vector.
 *
 *   range   t in -1..2, otherwise LOFT_ERR_ARG; LOFT_SINGULAR if the first derivative vanishes;
 *           LOFT_ERR_RANGE if the curvature does not fit. Nothing is written after an error. In
 *           floats t is rounded to a multiple of 2^-53
 *   units   1 / length: the radius is 1 / curvature
 *   error   q16: 1/2 LSB + 2^-16 LSB   f32, f64: 1 ulp, of both results, for any condition of the
 *           curve
 *   cost    q16, degree n: 6 n exact products per axis, then one per axis, two roots
 *   stack   Cortex-M4 2,752   Cortex-M0+ 2,760   ATmega328P 3,091
 *   see     |P' x P''| / |P'|^3
 */
enum loft_status loft_bezier_curvature(const loft_bezier *b, loft_unit t, loft_real *curvature,
                                       loft_vec *tangent) LOFT_CHECKED;

/* The same in the plane, with a sign: > 0 where the curve turns left, from the first axis to the
 * second. The tangent is 0 in all other axes.
 *
 *   range   as loft_bezier_curvature
 *   error   as loft_bezier_curvature
 *   cost    as loft_bezier_curvature with two axes
 */
enum loft_status loft_bezier_curvature_vec(const loft_bezier *b, loft_unit t, loft_real *curvature,
                                           loft_vec *tangent) LOFT_CHECKED;

/* Whether a planar polygon is the boundary of a convex region, traversed once. An edge from the
 * last point to the first closes it. Points may coincide with their predecessor, and edges may
 * continue straight. */
enum loft_convexity {
    LOFT_COLLINEAR  = -1,   /* all points are on a line, or coincide                            */
    LOFT_NOT_CONVEX =  0,
    LOFT_CONVEX     =  1
};

/* If the control polygon of a Bezier curve is LOFT_CONVEX then the curve over 0..1 is convex. It
 * has no inflection, no cusp inside and no crossing, and it lies on the boundary of its own hull.
 * The chord closes it to a convex region inside the polygon, because no line cuts the closed curve
 * more often than the closed polygon, that is twice. The converse is false: LOFT_NOT_CONVEX proves
 * nothing about the curve. LOFT_COLLINEAR proves that the curve lies on that line.
 *
 *   range   any number of points
 *   error   none
 *   cost    2 exact products per point
 *   stack   Cortex-M4 984   Cortex-M0+ 1,044   ATmega328P 1,092
 *   see     Liu Dingyuan (1984): a planar Bezier curve with a convex polygon is convex; Schoenberg,
 *           variation diminishing
 */
enum loft_status loft_polygon_convex(const loft_vec p[], unsigned count,
                                     enum loft_convexity *out) LOFT_CHECKED;

LOFT_END_C

#endif
