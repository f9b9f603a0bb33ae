/* lib/surface/surface.h -- a surface of any kind as a function of two parameters, for what walks
 * over
 * surfaces
 * SPDX-License-Identifier: MIT
 *
 * As loft_side is any curve for coons.h, a sheet is any surface for contour.h and for loft_trace
 * below:
 *
 *     const loft_surface s = loft_surface_from_tensor(&patch);
 *     loft_trace w;
 *     if (loft_trace_init(&w, s, LOFT_UNIT(0.25), LOFT_UNIT(0), LOFT_UNIT(0.25), LOFT_UNIT(1), 64)
 *     == LOFT_OK)
 *         while (loft_trace_next(&w, &p))         // the line u = 1/4
 *             ..
 *
 * Surfaces with n sides become sheets in polygon/disk.h.
 */
#ifndef LOFT_SURFACE_SURFACE_H
#define LOFT_SURFACE_SURFACE_H

#include "surface/tensor/bicubic.h"            /* loft_bicubic */
#include "surface/tensor/coons.h"              /* loft_coons_bezier */
#include "surface/sphere.h"             /* loft_sphere */
#include "surface/tensor/tensor.h"             /* loft_tensor */
#include "surface/tensor/tensor_rational.h"    /* loft_tensor_rational */
#include "surface/triangle/triangle.h"           /* loft_triangle */
#include "surface/triangle/triangle_rational.h"  /* loft_triangle_rational */

LOFT_BEGIN_C

/* What u and v run over. */
enum loft_surface_over {
    LOFT_SURFACE_SQUARE,          /* 0..1 both */
    LOFT_SURFACE_TRIANGLE,        /* u the share of the second corner, v that of the third, u + v <=
                                 * 1 */
    LOFT_SURFACE_DISK            /* 0..1 both, and v = 1 is v = 0; u = 0 is one point */
};

typedef struct {
    enum loft_status (*eval)(const void *surface, loft_unit u, loft_unit v, loft_vec *out);
    const void *surface;
    enum loft_surface_over over;
} loft_surface;

/* A surface as sheet, which must outlive it. A sphere: u from the pole down, v around.
 *
 *   error   of a point that of the surface's eval; of a sphere also what rounding the angles does:
 *           2^-16 degrees (f32: 2^-16) of arc
 *   cost    two pointers copied; each point that of the surface's eval
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

/* A walk along a straight line of the parameters: an iso-parametric line where u or v does not
 * change. */
typedef struct {
    loft_surface sheet;
    loft_unit from[2], to[2];
    uint32_t n, at;
} loft_trace;

/* Prepare to give n + 1 points at equal steps from one pair of parameters to another, both ends
 * included.
 *
 *   range   n >= 1, parameters in 0..1, in a triangle u + v <= 1 too, otherwise LOFT_ERR_ARG; when
 *           the sheet gives no point at an end what it gives; *w is untouched then
 *   error   none
 *   cost    a point of each end
 */
enum loft_status loft_trace_init(loft_trace *w, loft_surface sheet, loft_unit u0, loft_unit v0,
                                 loft_unit u1, loft_unit v1, uint32_t n) LOFT_CHECKED;

/* Give the next point; false, and *out is left alone, when the walk is over. Points that the sheet
 * does not give are left out.
 *
 *   error   that of the sheet, at parameters rounded once: q16: 2^-25   f32, f64: 1 ulp; none where
 *           they do not change
 *   cost    a point of the sheet and two lerps; no memory of the steps before: nothing drifts
 */
bool loft_trace_next(loft_trace *w, loft_vec *out);

LOFT_END_C

#endif
