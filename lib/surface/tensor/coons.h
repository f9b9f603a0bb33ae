/* lib/surface/tensor/coons.h -- Coons patches: the surface between four curves, also with slopes
 * and curvatures across them
 * SPDX-License-Identifier: MIT
 *
 * Four curves meet at four corners. u[0] at v = 0 and u[1] at v = 1 run along u. v[0] at u = 0 and
 * v[1] at u = 1 run along v. The patch is the ruled surface between one pair plus the ruled surface
 * between the other pair, minus the bilinear surface of the corners:
 *
 *     loft_coons c;
 *     const loft_side u[2] = { loft_side_from_bezier(&front), loft_side_from_rational(&rim) };
 *     const loft_side v[2] = { loft_side_from_bspline(&left), loft_side_from_bspline(&right) };
 *     if (loft_coons_init(&c, u, v, 0) == LOFT_OK && loft_coons_eval(&c, s, t, &p) == LOFT_OK) ..
 *
 * Patches with slopes (tangent plane continuity with their neighbours) and with curvatures are made
 * of Bezier curves: loft_coons_bezier. The curves are borrowed. A point may lie beyond the
 * coordinate range although all curves are within it. That is reported, never wrapped. In the
 * `error` lines ulp is that of the largest control value.
 */
#ifndef LOFT_SURFACE_TENSOR_COONS_H
#define LOFT_SURFACE_TENSOR_COONS_H

#include "curve/bezier.h"       /* loft_bezier */
#include "curve/bspline.h"      /* loft_bspline */
#include "curve/nurbs.h"        /* loft_nurbs */
#include "curve/rational.h"     /* loft_rational */

LOFT_BEGIN_C


/* Curves of any kind
 * ------------------ */

/* A boundary: a function that gives a wide point, within the coordinates, for t in 0..1. */
typedef struct {
    void (*eval)(const void *curve, loft_unit t, loft_acc out[LOFT_AXES]);
    const void *curve;
} loft_side;

/* Make a boundary of a curve, which must outlive it. B-splines run over their domain. The parameter
 * there is rounded, which moves the point by at most 1/2 LSB (q16) or 3 ulp of the larger end of
 * the domain times the derivative.
 *
 *   error   of a point q16: bezier degree * 2^-33, the others as their eval, which rounds by 1/2
 *           LSB f32: bezier none, the others 1 ulp   f64: as their eval
 *   cost    two pointers copied; a point: that of the curve's eval
 */
loft_side loft_side_from_bezier(const loft_bezier *b);
loft_side loft_side_from_rational(const loft_rational *r);
loft_side loft_side_from_bspline(const loft_bspline *b);
loft_side loft_side_from_nurbs(const loft_nurbs *n);

/* The bilinearly blended patch. Do not fill it yourself: call init. */
typedef struct {
    loft_side u[2], v[2];
    loft_acc  corner[2][2][LOFT_AXES];      /* [at u][at v] */
} loft_coons;

/* Take four boundaries.
 *
 *   range   they meet: at each corner all coordinates of both curves agree within tol >= 0,
 *           otherwise LOFT_ERR_ARG; *c is then untouched. The corners are those of u. Where v
 *           misses them by d, the patch follows both curves within d
 *   error   the corners: that of the boundaries
 *   cost    8 points of the boundaries
 */
enum loft_status loft_coons_init(loft_coons *c, const loft_side u[2], const loft_side v[2],
                                 loft_real tol) LOFT_CHECKED;

/* The point at (s, t).
 *
 *   range   s, t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the point does not fit; *out
 *           is then untouched
 *   error   q16: 1/2 LSB + 4 * 2^-17 LSB and the error of each pair of curves: for Bezier curves
 *           1/2 LSB + (2 degree + 4) * 2^-17 LSB, for others 1.6 LSB   f32: 1/2 ulp of the result +
 *           1/2 ulp and that of the curves   f64: 16 ulp and that of the curves. On the boundary it
 *           is the curve's own point (exactly in q16, within 4 ulp of double in floats)
 *   cost    a point of each of the four curves, 5 wide lerps per axis
 *   see     Coons (1967); Farin, Curves and Surfaces for CAGD, ch. 21
 */
enum loft_status loft_coons_eval(const loft_coons *c, loft_unit s, loft_unit t,
                                 loft_vec *out) LOFT_CHECKED;

/* Bezier curves, slopes, curvatures
 * --------------------------------- */

#define LOFT_COONS_ORDERS 3

/* u[k][0], u[k][1] run along u at v = 0 and v = 1. k = 0 is the boundary, k = 1 its derivative by
 * v, k = 2 its second derivative. v[k][..] likewise at u = 0 and u = 1. Only the first `orders` of
 * each are used: 1 for a bilinearly blended patch, 2 with slopes (cubic blending), 3 with
 * curvatures (quintic blending). Do not fill it yourself: call init. */
typedef struct {
    loft_bezier u[LOFT_COONS_ORDERS][2], v[LOFT_COONS_ORDERS][2];
    uint8_t orders;
} loft_coons_bezier;

/* Take 4 * orders curves of any degrees. Their control points must outlive the patch.
 *
 *   range   orders 1..3, the boundaries meet at their corners within tol >= 0, otherwise
 *           LOFT_ERR_ARG; *c is then untouched
 *   error   none: nothing is rounded
 *   cost    8 comparisons per axis; copies of the curves' descriptions
 */
enum loft_status loft_coons_bezier_init(loft_coons_bezier *c, const loft_bezier u[][2],
                                        const loft_bezier v[][2], unsigned orders,
                                        loft_real tol) LOFT_CHECKED;

/* True if u and v agree on all data that both give at the corners: slopes along the boundaries,
 * twists, curvatures. Then the patch follows all curves. Otherwise it follows the curves along v,
 * and misses the data of u by the difference.
 *
 *   error   q16: none   f32, f64: the compared numbers err by 8 n^2 ulp of double, n the highest
 *           degree: give a tol
 *   cost    4 orders^2 differences per axis
 *   see     Farin, ch. 21: the twist problem
 */
bool loft_coons_bezier_meets(const loft_coons_bezier *c, loft_real tol);

/* The point at (s, t), and its derivative by s (j = 1), by t (k = 1), or by both.
 *
 *   range   s, t in 0..1, j, k in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the result does
 *           not fit; *out is then untouched
 *   error   with n the highest degree, q16: eval 1/2 LSB + (3 n + 20) * 2^-17 LSB, deriv 1/2 LSB +
 *           (14 n^2 + 120) * 2^-17 LSB
 *           f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: eval 64 (n + 1)^2 ulp, deriv 512 (n + 1)^3 ulp
 *   cost    a point of each of the curves, 2 orders + 2 of Hermite's polynomials per axis
 *   stack   Cortex-M4 384   Cortex-M0+ 484   ATmega328P 296
 *   see     Coons (1967); Gordon, Blending-function methods (1971); Chang, Mathematics of Surfaces,
 *           ch. 9: (19), (20)
 */
enum loft_status loft_coons_bezier_eval(const loft_coons_bezier *c, loft_unit s, loft_unit t,
                                        loft_vec *out) LOFT_CHECKED;
enum loft_status loft_coons_bezier_deriv(const loft_coons_bezier *c, unsigned j, unsigned k,
                                         loft_unit s, loft_unit t, loft_vec *out) LOFT_CHECKED;

/* The bilinearly blended patch of the boundaries as a tensor product, whatever `orders` is. A grid
 * walks this patch.
 *
 *   shape   with the degrees m of u and n of v: net[(m + 1) (n + 1)], row by row: (n + 1) i + j for
 *           b_ij, i along u
 *   range   the curves of a pair have one degree, 1..9, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when
 *           a point does not fit; net[] is then undefined
 *   error   q16: 1/2 LSB + 2^-17 LSB, none on the boundary   f32: 1/2 ulp of the result + 1/2 ulp
 *           f64: 24 ulp
 *   cost    8 small products and a division per point and axis
 *   see     Farin, ch. 21: the net is the Coons patch of the boundary polygons
 */
enum loft_status loft_tensor_from_coons(const loft_coons_bezier *c, loft_vec net[]) LOFT_CHECKED;

/* The patch itself as a tensor product, with slopes and curvatures if it has them: of the highest
 * degree of the curves along u and of the blending, 2 orders - 1; along v likewise.
 *
 *   shape   net[(*m + 1) (*n + 1)], row by row, at most 100 points
 *   range   LOFT_ERR_RANGE when a point does not fit; net[] is then undefined
 *   error   q16: 1/2 LSB + 2^-18 LSB   f32: 1/2 ulp of the result + 1/2 ulp   f64: 64 (n + 1)^2
 *           ulp, n the highest degree of a curve
 *   cost    orders (2 orders + 4) products of num/sci.h per point and axis
 *   stack   Cortex-M4 5,172   Cortex-M0+ 5,320   ATmega328P 3,620
 *   see     Farin, ch. 22: the bicubically blended Coons patch
 */
enum loft_status loft_tensor_from_coons_blended(const loft_coons_bezier *c, unsigned *m,
                                                unsigned *n, loft_vec net[]) LOFT_CHECKED;

LOFT_END_C

#endif
