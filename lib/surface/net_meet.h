/* lib/surface/net_meet.h -- where two surfaces meet, or a curve meets a surface
 * SPDX-License-Identifier: MIT
 *
 *     static loft_net_meeting out[4096];
 *     unsigned                count;
 *     if (loft_net_meet(loft_net_from_tensor(&s), loft_net_from_triangle(&t), LOFT_REAL(0.001),
 *                       out, 4096, &count) == LOFT_OK)
 *         for (unsigned k = 0; k < count; k++)
 *             out[k].start ? move_to(out[k].point) : line_to(out[k].point);
 *
 * Surfaces meet in branches: a curve from border to border of either surface, or a closed one,
 * whose last point is its first. A curve meets a surface in places; each is a branch of one point.
 */
#ifndef LOFT_SURFACE_NET_MEET_H
#define LOFT_SURFACE_NET_MEET_H

#include "curve/bezier.h"       /* loft_bezier */
#include "curve/rational.h"     /* loft_rational */
#include "surface/net.h"        /* loft_net */

LOFT_BEGIN_C

#define LOFT_NET_MEET_PARTS ((uint32_t)1 << 19)

/* A curve as a surface whose second parameter means nothing; its points must outlive it.
 *
 *   error   none
 *   cost    a pointer copied
 */
loft_net loft_net_from_bezier(const loft_bezier *b);
loft_net loft_net_from_rational(const loft_rational *r);

typedef struct {
    loft_unit at[4];            /* u and v of the first, then of the second surface; of a curve t
                                 * and nothing */
    loft_vec  point;
    bool      start;            /* a branch begins here */
    bool      touch;            /* not decided: within about `tol` of this one point the surfaces
                                 * are nearly tangent, folded or collapsed, and meet there or not */
} loft_net_meeting;

/* Find all branches of a and b, point by point: out[room]. LOFT_SINGULAR: there are touches.
 * LOFT_MORE: there are more than `room` points, or more than LOFT_NET_MEET_PARTS parts were
 * examined, as where the surfaces overlap; out[] then holds those found.
 *
 *   range   three axes, tol > 0, b not a curve, otherwise LOFT_ERR_ARG; tol >= q16: 32 LSB   f32:
 *           2^-18 of the largest coordinate, otherwise LOFT_ERR_RANGE. *count is 0 after an error
 *   error   each place where they meet is within 2 tol of a branch or a touch, except in branches
 *           that are shorter than tol. Where the surfaces cross within 2 tol of themselves, or two
 *           branches run closer than tol, one branch stands for both
 *           point: on both surfaces, 1/2 LSB (ulp) per axis and 2^-38 of the size of the surfaces
 *           over the sine of their angle;  u, v: as point over the speed, and q16, f32: 2^-25
 *           chords: within tol / 2 of the branch, as measured in their middles
 *   cost    some 2000 to 7000 parts for two bicubic patches, each once loft_net_cell_decide; not
 *           for small chips
 *   stack   Cortex-M4 49,132   Cortex-M0+ 49,080   ATmega328P 33,842
 *   see     Barnhill and Kersey, A marching method for parametric surface/surface intersection,
 *           CAGD 7 (1990); Kearfott, Rigorous Global Search (1996)
 */
enum loft_status loft_net_meet(loft_net a, loft_net b, loft_real tol, loft_net_meeting out[],
                               unsigned room, unsigned *count) LOFT_CHECKED;

LOFT_END_C

#endif
