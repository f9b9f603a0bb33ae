/* lib/surface/net_field.h -- the normal of a net as one polynomial, and its integrals over parts
 * SPDX-License-Identifier: MIT
 *
 * What area.h computes with. With X the point times the weight w, the normal of a net is M / w^3
 * and the determinant of X, X_u, X_v is D: M and D are polynomials of u and v. A part of the net
 * has them too. The integral of M / w^3 over it is known within a bound of the second order, and
 * values at nodes of Gauss's formula give it within the 8th:
 *
 *     loft_net_field_load(net, apex, LOFT_NET_NORMAL, memory, &x);
 *     loft_net_field_cut(&x, &part);
 *     by = loft_net_field_weighing(&x);
 *     loft_net_field_integral(&x, &by, sum);          // over 0..1 x 0..1 of the part
 *     loft_net_field_value(&x, row, h, value, &weight);       // row: loft_net_field_row
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

#define LOFT_NET_NODES 4                                /* along u and along v               */
#define LOFT_NET_LINE  (4 * LOFT_DEGREE_MAX - 1)        /* coefficients along a parameter    */

/* The polynomial, of degrees p, q, and the weight, of degrees m, n: of the whole net and of a part.
 * Do not fill it yourself: call load. */
typedef struct {
    unsigned p, q, each, m, n, power;
    bool weighted;
    loft_sci *whole, *c, *w_whole, *w;
    loft_sci *with[2];          /* integrals of products of B_k and those of the weight, by u, v  */
    loft_sci *node[2];          /* B_k at the nodes, k for each node, by u and v                  */
    loft_sci *w_node[2];        /* the same of the weight                                         */
    loft_sci share[2];          /* of the outer and the inner nodes in an integral over 0..1      */
} loft_net_field;

/* The polynomial of a net of degrees 1 or more, seen from the apex.
 *
 *   shape   memory[LOFT_NET_AREA_MEMORY(m, n)] (area.h), of LOFT_NET_MOMENT
 *           [LOFT_NET_MOMENT_MEMORY(m, n)]
 *   range   three axes or more but for LOFT_NET_NORMAL
 *   error   about m n roundings of num/sci.h of the largest product of two steps of the net and,
 *           but for LOFT_NET_NORMAL, a distance from the apex (twice that distance: a moment)
 *   cost    up to m^3 n^3 products of num/sci.h; LOFT_NET_MOMENT 27 m^2 n^2 more
 *   stack   Cortex-M4 8,012   Cortex-M0+ 8,040   ATmega328P 5,636
 */
void loft_net_field_load(loft_net s, loft_vec apex, enum loft_net_field_of of, loft_sci memory[],
                         loft_net_field *out);

/* Take a part of the net. Its parameters are changed so that the weights at opposite edges are
 * nearly equal.
 *
 *   error   4 roundings per degree
 *   cost    about p q (p + q) each, 4 times at most
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

/* The polynomial and the weight as those of v alone, at one node along u. */
typedef struct {
    loft_sci c[LOFT_NET_LINE][3], w[LOFT_DEGREE_MAX + 1];
} loft_net_row;

/* The row of the part at node g along u, and its value at node h along v: value[each], and the
 * weight, 1 if there are none.
 *
 *   range   g, h < LOFT_NET_NODES
 *   error   about p + q roundings of the largest coefficient
 *   cost    a row p q each + m n products, a value q each + n
 */
void loft_net_field_row(const loft_net_field *x, unsigned g, loft_net_row *out);
void loft_net_field_value(const loft_net_field *x, const loft_net_row *row, unsigned h,
                          loft_sci value[3], loft_sci *weight);

/* The orders up to which a Taylor series is known, twice the nodes. */
#define LOFT_NET_ORDER (2 * LOFT_NET_NODES)

/* Bounds of the Taylor coefficients of the part along u or v, of the polynomial (its length) or of
 * the weight, at every place of it: C(p, k) times the largest k-th difference of coefficients.
 *
 *   error   a few roundings for each order
 *   cost    LOFT_NET_ORDER p q each sums and comparisons
 */
void loft_net_field_taylor(const loft_net_field *x, bool of_weight, unsigned along,
                           loft_sci out[LOFT_NET_ORDER + 1]);

LOFT_END_C

#endif
