/* lib/surface/net.h -- surfaces with control nets, as polynomials of x and y for searches
 * SPDX-License-Identifier: MIT
 *
 * net_nearest.h and net_ray.h work on any surface with a net:
 *
 *     loft_net_near near;
 *     status = loft_net_nearest(loft_net_from_triangle(&t), probe, tol, &near);
 *
 * A triangle is a tensor-product patch with the edge x = 0 in its corner T1: T2 has the share
 * x (1 - y), T3 the share x y. Row i of its net is a curve of degree i, raised to that of the
 * triangle. A weighted surface is a quotient of polynomials.
 */
#ifndef LOFT_SURFACE_NET_H
#define LOFT_SURFACE_NET_H

#include "surface/tensor/tensor_part.h"             /* loft_sci_net */
#include "surface/tensor/tensor_rational.h"         /* loft_tensor_rational */
#include "surface/triangle/triangle.h"              /* loft_triangle */
#include "surface/triangle/triangle_rational.h"     /* loft_triangle_rational */

LOFT_BEGIN_C

/* The control points of a surface, without or with weights. The other pointer is NULL. */
typedef struct {
    const loft_vec *p;
    const loft_weighted *weighted;
    uint8_t m, n;               /* degrees by x and y */
    bool triangle;
} loft_net;

/* The net of a surface, whose points must outlive it.
 *
 *   error   none
 *   cost    a pointer copied
 */
loft_net loft_net_from_tensor(const loft_tensor *s);
loft_net loft_net_from_tensor_rational(const loft_tensor_rational *s);
loft_net loft_net_from_triangle(const loft_triangle *s);
loft_net loft_net_from_triangle_rational(const loft_triangle_rational *s);

/* True if two nets have the same control points and weights, with the parameters of one turned
 * round, exchanged or permuted. Then they are one surface. Others may be too, for example after
 * raising the degree: false says nothing.
 *
 *   error   none
 *   cost    up to 8 comparisons of all points
 */
bool loft_net_same(loft_net a, loft_net b);

/* Coordinates times the weight, and the weight, as polynomials of x and y. */
typedef struct {
    loft_sci_net axis[LOFT_AXES], w;
    bool weighted, triangle;
} loft_net_form;

/* The polynomials of a surface, seen from `origin`.
 *
 *   error   a coefficient: without weights none in q16, 1 rounding of num/sci.h otherwise; with
 *           weights one more; a triangle of degree n 3 n more; of the largest coefficient
 *   cost    one difference per coordinate; a triangle (n + 1) n (n - 1) / 6 lerps per axis
 */
void loft_net_load(loft_net s, loft_vec origin, loft_net_form *out);

/* The polynomials of a part.
 *
 *   error   as loft_sci_net_sub
 *   cost    LOFT_AXES times loft_sci_net_sub; with weights once more
 */
void loft_net_form_sub(const loft_net_form *x, const loft_dyad part[2], loft_net_form *out);

/* Which derivative by x and y. */
enum loft_net_by {
    LOFT_NET_POINT,
    LOFT_NET_BY_X,
    LOFT_NET_BY_Y,
    LOFT_NET_BY_XX,
    LOFT_NET_BY_XY,
    LOFT_NET_BY_YY,
    LOFT_NET_JET
};

/* The point at x, y and its derivatives up to `order` 0, 1, 2; the rest of out[] is untouched.
 *
 *   range   x and y in 0..1
 *   error   as loft_sci_net_deriv; with weights that of a quotient: 2 R times as much, R the
 *           largest weight over the smallest, for each order
 *   cost    per axis 1, 3 or 6 times loft_sci_net_deriv; with weights as for one axis more
 */
void loft_net_form_jet(const loft_net_form *f, unsigned order, loft_sci x, loft_sci y,
                       loft_sci out[LOFT_NET_JET][LOFT_AXES]);

/* Divide by the weights: the control points themselves. The surface lies in their hull.
 *
 *   error   1 rounding
 *   cost    a quotient per coordinate; nothing without weights
 */
void loft_net_form_points(loft_net_form *f);

/* The parameters of the surface at x, y: u and v, or the shares of T2 and T3.
 *
 *   error   q16: 2^-25   f32, f64: 1 ulp   a triangle: the sum of the shares is at most 1
 *   cost    2 products
 */
void loft_net_form_place(const loft_net_form *f, loft_sci x, loft_sci y, loft_unit out[2]);

LOFT_END_C

#endif
