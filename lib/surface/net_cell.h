/* lib/surface/net_cell.h -- one part of two surfaces: whether they meet in it, and how often
 * SPDX-License-Identifier: MIT
 *
 * The steps of net_meet.h. A cell is a part of both surfaces: four parameters, 0..1 each in the
 * cell. A curve is a surface of degree 0 by y, whose parameter y means nothing.
 */
#ifndef LOFT_SURFACE_NET_CELL_H
#define LOFT_SURFACE_NET_CELL_H

#include "surface/net.h"    /* loft_net_form */

LOFT_BEGIN_C

/* What is known of a cell. */
enum loft_net_known {
    LOFT_NET_APART,             /* the surfaces do not meet in it */
    LOFT_NET_ONCE,              /* for each value of the parameter `loose` they meet at most once:
                                 * surely for those in sure_from..sure_to, if that is not empty,
                                 * and for none outside from..to */
    LOFT_NET_OPEN               /* not decided: halve it along `longest` */
};

typedef struct {
    unsigned loose, longest;
    loft_sci from, to, sure_from, sure_to, start[4], slope[4];
    loft_sci size;              /* the longest leg of both nets: at least their extents */
    loft_sci spread;            /* of the places from their line start + slope f, in space:
                                 * 2 size times the errors of the parameters, above sqrt(3) */
    loft_sci speed;             /* of the place where they meet, by `loose`, in the middle */
} loft_net_cell;

/* Decide a cell of the surfaces a and b, seen from the same origin. With ONCE the places are near
 * start[i] + slope[i] f, all in the parameters of the cell, for the value f of the free one.
 *
 *   range   three axes; a weighted surface has positive weights
 *   error   APART and ONCE are proved, and the limits of `from` to `to` contain all places. They
 *           count places up to 2^-30 of the cell beyond its border as within
 *   cost    twice loft_net_form_sub and 12 times as many products as there are control points
 *   stack   Cortex-M4 35,204   Cortex-M0+ 35,160   ATmega328P 24,261
 *   see     Krawczyk; Kearfott, Rigorous Global Search, ch. 1: preconditioned Jacobians
 */
enum loft_net_known loft_net_cell_decide(const loft_net_form *a, const loft_net_form *b,
                                         const loft_dyad_box *pair, loft_net_cell *out);

/* Solve p x + q y + r z = d. False if the columns depend on each other to 2^-30.
 *
 *   error   3 roundings over the determinant of the normed columns
 *   cost    4 determinants
 */
bool loft_sci_solve3(loft_sci column[3][3], const loft_sci d[3], loft_sci out[3]);

LOFT_END_C

#endif
