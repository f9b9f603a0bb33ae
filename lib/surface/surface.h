/* lib/surface/surface.h -- a surface of any kind as a function of two parameters
 * SPDX-License-Identifier: MIT
 *
 * contour.h and loft_trace below work on any surface through a loft_surface, as coons.h works on
 * any curve through a loft_side:
 *
 *     const loft_surface s = loft_surface_from_tensor(&patch);
 *     loft_trace w;
 *     if (loft_trace_init(&w, s, LOFT_UNIT(0.25), LOFT_UNIT(0), LOFT_UNIT(0.25), LOFT_UNIT(1),
 *                         64) == LOFT_OK)
 *         while (loft_trace_next(&w, &p))         // the line u = 1/4
 *             ..
 *
 * polygon/disk.h makes a loft_surface of a patch with n sides.
 */
#ifndef LOFT_SURFACE_SURFACE_H
#define LOFT_SURFACE_SURFACE_H

#include "surface/differential.h"                   /* loft_differential */
#include "surface/tensor/bicubic.h"                 /* loft_bicubic */
#include "surface/tensor/coons.h"                   /* loft_coons_bezier */
#include "surface/sphere.h"                         /* loft_sphere */
#include "surface/tensor/tensor.h"                  /* loft_tensor */
#include "surface/tensor/tensor_rational.h"         /* loft_tensor_rational */
#include "surface/triangle/triangle.h"              /* loft_triangle */
#include "surface/triangle/triangle_rational.h"     /* loft_triangle_rational */

LOFT_BEGIN_C

/* The parameter domain. */
enum loft_surface_over {
    LOFT_SURFACE_SQUARE,          /* u and v in 0..1 */
    LOFT_SURFACE_TRIANGLE,        /* u, v: coordinates of corners 2 and 3; u + v <= 1 */
    LOFT_SURFACE_DISK            /* u and v in 0..1; v = 1 is v = 0; u = 0 is one point */
};

typedef struct {
    enum loft_status (*eval)(const void *surface, loft_unit u, loft_unit v, loft_vec *out);
    const void *surface;
    enum loft_surface_over over;
    /* Derivatives there, for its normal; NULL if the kind has none. */
    enum loft_status (*differential)(const void *surface, loft_unit u, loft_unit v,
                                     loft_differential *out);
} loft_surface;

/* Make a loft_surface of a surface, which must outlive it. On a sphere u runs from the pole down, v
 * around.
 *
 *   error   a point: that of the surface's eval; on a sphere also that of rounding the angles:
 *           2^-16 degrees (f32: 2^-16) of arc
 *   cost    two pointers copied; a point: that of the surface's eval
 */
loft_surface loft_surface_from_tensor(const loft_tensor *s);
loft_surface loft_surface_from_tensor_rational(const loft_tensor_rational *s);
loft_surface loft_surface_from_triangle(const loft_triangle *s);
loft_surface loft_surface_from_triangle_rational(const loft_triangle_rational *s);
loft_surface loft_surface_from_bicubic(const loft_bicubic *s);
loft_surface loft_surface_from_coons(const loft_coons_bezier *s);
loft_surface loft_surface_from_sphere(const loft_sphere *s);


/* Lines
 * ----- */

/* A walk along a straight line in the parameter domain. Where u or v is constant it is an
 * isoparametric line. */
typedef struct {
    loft_surface surface;
    loft_unit from[2], to[2];
    uint32_t n, at;
} loft_trace;

/* Prepare to give n + 1 points at equal steps from one pair of parameters to another, both ends
 * included.
 *
 *   range   n >= 1, parameters in 0..1, in a triangle also u + v <= 1, otherwise LOFT_ERR_ARG; the
 *           status of the surface when it has no point at an end; *w is then untouched
 *   error   none
 *   cost    two points of the surface
 */
enum loft_status loft_trace_init(loft_trace *w, loft_surface surface, loft_unit u0, loft_unit v0,
                                 loft_unit u1, loft_unit v1, uint32_t n) LOFT_CHECKED;

/* Give the next point. Returns false, and leaves *out alone, when the walk is over. Points that the
 * surface does not have are skipped.
 *
 *   error   that of the surface, at parameters rounded once: q16: 2^-25   f32, f64: 1 ulp; none for
 *           a constant parameter
 *   cost    a point of the surface and two lerps; each step is independent, so nothing drifts
 */
bool loft_trace_next(loft_trace *w, loft_vec *out);

LOFT_END_C

#endif
