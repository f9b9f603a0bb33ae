/* lib/surface/net_field.h -- the normal of a net as one polynomial, and its integrals over parts
 * SPDX-License-Identifier: MIT
 *
 * What area.h computes with. With X the point times the weight w, the normal of a net is M / w^3
 * and the determinant of X, X_u, X_v is D: M and D are polynomials of u and v. A part of the net
 * has them too, and the integral of M / w^3 over it is known within a bound of the second order:
 *
 *     loft_net_field_load(net, apex, LOFT_NET_NORMAL, memory, &x);
 *     loft_net_field_cut(&x, &part);
 *     by = loft_net_field_weighing(&x);
 *     loft_net_field_integral(&x, &by, sum);          // over 0..1 x 0..1 of the part
 */
#ifndef LOFT_SURFACE_NET_FIELD_H
#define LOFT_SURFACE_NET_FIELD_H

#include "basis/dyadic.h"       /* loft_dyad_box */
#include "surface/net.h"        /* loft_net */

LOFT_BEGIN_C

enum loft_net_field_of {
    LOFT_NET_NORMAL,            /* M: 3 components, over w^3                           */
    LOFT_NET_CONE,              /* D: 1 component, over w^3                            */
    LOFT_NET_MOMENT             /* D X: 3 components, over w^4                         */
};

/* The polynomial, of degrees p, q, and the weight, of degrees m, n: of the whole net and of a part.
 * Do not fill it yourself: call load. */
typedef struct {
    unsigned p, q, each, m, n, power;
    bool weighted;
    loft_sci *whole, *c, *w_whole, *w;
    loft_sci *same[2];          /* integrals of products of B_k, along u and v: of normals */
    loft_sci *with[2];          /* of B_k and those of the weight              */
} loft_net_field;

/* The polynomial of a net of degrees 1 or more, seen from the apex.
 *
 *   shape   memory[LOFT_NET_AREA_MEMORY(m, n)] (area.h), of LOFT_NET_MOMENT
 *           [LOFT_NET_MOMENT_MEMORY(m, n)]
 *   range   three axes or more but for LOFT_NET_NORMAL
 *   error   about m n roundings of num/sci.h of the largest product of two steps of the net and,
 *           but for LOFT_NET_NORMAL, a distance from the apex (twice that distance: a moment)
 *   cost    up to m^3 n^3 products of num/sci.h; LOFT_NET_MOMENT 27 m^2 n^2 more; 7.5 kB of stack
 *           in q16
 */
void loft_net_field_load(loft_net s, loft_vec apex, enum loft_net_field_of of, loft_sci memory[],
                         loft_net_field *out);

/* Take a part of the net. Its parameters are changed so that the weights at opposite edges are
 * nearly equal.
 *
 *   error   a rounding per halving and degree
 *   cost    about p q (p + q) sums for each halving
 */
void loft_net_field_cut(loft_net_field *x, const loft_dyad_box *part);

/* The parameter along which the part changes more. 0: u, 1: v.
 *
 *   error   none: any answer is right
 *   cost    2 p q dot products
 */
unsigned loft_net_field_longer(const loft_net_field *x);

/* How w^-3 (w^-4) is replaced on the part: by h = first + slope w, within `rest`; most and least of
 * w^-3 itself. */
typedef struct {
    loft_sci first, slope, most, least, rest;
} loft_net_weighing;

/* That of the part.
 *
 *   error   a few roundings
 *   cost    2 comparisons of each weight, 10 products
 */
loft_net_weighing loft_net_field_weighing(const loft_net_field *x);

/* The integral of the polynomial times h over the part, by components: out[each].
 *
 *   error   about p q roundings of the largest coefficient
 *   cost    p m n + p q (n + each) products
 */
void loft_net_field_integral(const loft_net_field *x, const loft_net_weighing *by, loft_sci out[3]);

LOFT_END_C

#endif
