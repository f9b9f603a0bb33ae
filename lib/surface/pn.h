/* lib/surface/pn.h -- curved triangles from the points and normals of a mesh
 * SPDX-License-Identifier: MIT
 *
 * A cubic triangle goes through the three points and is at a right angle to their normals. Its
 * edges depend only on the points and normals at their ends, so neighbours in a mesh meet without a
 * gap. A quadratic field of normals serves for shading. Between the corners it differs from the
 * geometric normal.
 *
 *     loft_pn t;
 *     if (loft_pn_init(&t, corner, normal) == LOFT_OK)
 *         p = loft_pn_eval(&t, u);
 */
#ifndef LOFT_SURFACE_PN_H
#define LOFT_SURFACE_PN_H

#include "surface/barycentric.h"    /* loft_bary */

LOFT_BEGIN_C

/* Control points are wide, so that a point is rounded once. Do not fill it yourself: call init. */
typedef struct {
    loft_acc b[LOFT_AXES][10];
    loft_vec n[6];
} loft_pn;

/* Make the triangle of three points and normals of any length.
 *
 *   range   LOFT_SINGULAR for a normal of 0; finite coordinates, and control points that fit,
 *           otherwise LOFT_ERR_RANGE; *t is then undefined
 *   error   control points q16: 2^-32   f32, f64: 2^-49 of the largest coordinate
 *   cost    in numbers of num/sci.h about 50 products and 12 quotients; a triangle takes 240 bytes
 *           in three axes; not for an ISR
 *   see     Vlachos, Peters, Boyd, Mitchell, Curved PN triangles (2001)
 */
enum loft_status loft_pn_init(loft_pn *t, const loft_vec corner[3],
                              const loft_vec normal[3]) LOFT_CHECKED;

/* The point at u.
 *
 *   range   u is clamped to the triangle: cannot fail
 *   error   q16: 1/2 LSB + 2^-14 LSB   f32: 1/2 ulp + 2^-48   f64: 2^-48, of the largest
 *           coordinate; exact at the corners
 *   cost    20 wide products per axis
 */
loft_vec loft_pn_eval(const loft_pn *t, loft_bary u);

/* The point at u, outside the triangle as well; L = |u| + |v| + |w|.
 *
 *   range   LOFT_ERR_RANGE when the point does not fit, for L above 27, |v| or |w| above 32; *out
 *           is then untouched
 *   error   q16: 1/2 LSB + (2 L^3 + L^2 + L + 1) * 2^-17 LSB   f32: 1/2 ulp of the result and
 *           L^3 2^-48   f64: L^3 2^-48, of the largest coordinate
 *   cost    as eval
 */
enum loft_status loft_pn_extrapolate(const loft_pn *t, loft_bary u, loft_vec *out) LOFT_CHECKED;

/* The unit shading normal at u. At a corner it is the given normal of that corner.
 *
 *   range   u is clamped; LOFT_SINGULAR where the field vanishes, between opposite normals; *out is
 *           then untouched
 *   error   with h the length of the sum before normalization: q16: 2^-15 / h   f32: 2^-21 / h
 *           f64: 2^-48 / h
 *   cost    8 wide products per axis, loft_vec_unit
 */
enum loft_status loft_pn_normal(const loft_pn *t, loft_bary u, loft_vec *out) LOFT_CHECKED;

/* The ten control points, for loft_triangle_init with degree 3.
 *
 *   error   1/2 LSB (floats 1/2 ulp) and that of init
 *   cost    one rounding a coordinate
 */
void loft_pn_net(const loft_pn *t, loft_vec out[10]);

LOFT_END_C

#endif
