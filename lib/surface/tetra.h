/* lib/surface/tetra.h -- Bezier tetrahedra of degree 0..9: fields and deformations of space
 * SPDX-License-Identifier: MIT
 *
 * A point u T1 + v T2 + w T3 + x T4 with u + v + w + x = 1 is given by the last three coordinates.
 * A net of degree n has LOFT_TETRA_POINTS(n) control points b_ijkl, i + j + k + l = n. i descends,
 * then j, then k: layers of triangles from the corner T1 down to the face T2 T3 T4. With control
 * points in the plane or in space a tetrahedron is a free-form deformation. One coordinate alone is
 * a field, such as a temperature or a stiffness.
 */
#ifndef LOFT_SURFACE_TETRA_H
#define LOFT_SURFACE_TETRA_H

#include "curve/bezier.h"       /* LOFT_DEGREE_MAX, LOFT_ELEVATE_MAX */
#include "geom/vec.h"           /* loft_vec */

LOFT_BEGIN_C

#define LOFT_TETRA_POINTS(degree) (((degree) + 1u) * ((degree) + 2u) * ((degree) + 3u) / 6u)
#define LOFT_TETRA_MAX LOFT_TETRA_POINTS(LOFT_DEGREE_MAX)

/* A point in a tetrahedron. */
typedef struct {
    loft_unit v, w, x;
} loft_volume;

/* The index of b_ijkl, for every degree. */
static inline unsigned loft_tetra_place(unsigned j, unsigned k, unsigned l)
{
    const unsigned m = j + k + l, n = k + l;
    return m * (m + 1) * (m + 2) / 6 + n * (n + 1) / 2 + l;
}

/* The point itself if it is inside, otherwise a point on a face. NaN counts as 0.
 *
 *   error   none
 *   cost    nine comparisons
 */
loft_volume loft_volume_clamp(loft_volume u);

/* u, v, w, x of the point p in the first three axes. The results are wide, because a point far from
 * a flat tetrahedron has large coordinates.
 *
 *   range   LOFT_SINGULAR for four corners in a plane; LOFT_ERR_RANGE when a coordinate is 2^30 or
 *           more, or when loft_exact_valid refuses a number; `out` is then untouched
 *   error   q16: 2^-33 + 2^-60   f32, f64: 0.51 ulp of double
 *   cost    4 determinants of three rows and 4 quotients of exact numbers; not for an ISR
 *   stack   Cortex-M4 2,296   Cortex-M0+ 2,296   ATmega328P 2,651
 */
enum loft_status loft_volume_from_point(const loft_vec corner[4], loft_vec p,
                                        loft_acc out[4]) LOFT_CHECKED;

/* The Bernstein polynomials n!/(i! j! k! l!) u^i v^j w^k x^l: the weights of the control points.
 *
 *   shape   w[LOFT_TETRA_POINTS(degree)]; q16: they sum to exactly 1 (2^32)
 *   range   degree 0..9, inside the tetrahedron
 *   error   q16: 3 * degree * 2^-32   f32, f64: 8 * degree ulp of double of 1
 *   cost    3 LOFT_TETRA_POINTS(degree - 1) wide products for each degree up to that
 */
void loft_volume_weights(unsigned degree, loft_volume u, loft_acc w[]);

/* A tetrahedron of any degree. The control points are borrowed. Do not fill it yourself: call
 * init. */
typedef struct {
    const loft_vec *p;
    uint8_t degree;
} loft_tetra;

/* Make a tetrahedron of LOFT_TETRA_POINTS(degree) control points, which must outlive it.
 *
 *   range   degree 0..9, otherwise LOFT_ERR_ARG; finite coordinates, otherwise LOFT_ERR_RANGE; *t
 *           is then untouched
 *   error   none: the points are borrowed
 *   cost    two comparisons a coordinate
 */
enum loft_status loft_tetra_init(loft_tetra *t, const loft_vec p[], unsigned degree) LOFT_CHECKED;

/* The point at u, by de Casteljau's algorithm.
 *
 *   range   u is clamped to the tetrahedron: cannot fail
 *   error   q16: 1/2 LSB + degree * 2^-16 LSB   f32: 1 ulp   f64: 6 * degree ulp, of the largest
 *           control value
 *   cost    3 LOFT_TETRA_POINTS(degree - 1) wide products per axis for each degree up to that: not
 *           for machines with 2 kB of memory
 *   stack   Cortex-M4 1,920   Cortex-M0+ 1,964   ATmega328P 1,932
 *   see     Farin, Curves and Surfaces for CAGD, ch. 17: tetrahedra, whose faces are triangles
 */
loft_vec loft_tetra_eval(const loft_tetra *t, loft_volume u);

/* The same polynomial with a degree higher by `times`: LOFT_TETRA_POINTS(degree + times) control
 * points, in memory other than those of t.
 *
 *   range   degree + times <= LOFT_ELEVATE_MAX, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-17 LSB   f32: 1 ulp   f64: degree^2 + 3 ulp, of the largest control
 *           value
 *   cost    per control point of the result: at most one small product per point of the net, and
 *           one division
 */
enum loft_status loft_tetra_elevate(const loft_tetra *t, unsigned times,
                                    loft_vec out[]) LOFT_CHECKED;

LOFT_END_C

#endif
