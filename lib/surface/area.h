/* lib/surface/area.h -- area of a net, volume and moments of a cone over it, within a proven
 * tolerance
 * SPDX-License-Identifier: MIT
 *
 * Of patches and triangles, with weights or without. Cones from one apex over nets that close a
 * body give its volume; without weights loft_net_volume gives it exactly. Their moments over that
 * volume are its centroid, seen from the apex.
 *
 *     loft_sci memory[LOFT_NET_AREA_MEMORY(2, 1)];
 *     status = loft_net_area(loft_net_from_tensor_rational(&s), LOFT_REAL(0.01), memory, &area);
 *
 * In the `error` lines A is m n R^3 s t: s, t the largest distances of two control points that are
 * neighbours by the first and by the second parameter (a triangle: of its form, net.h), R the
 * largest weight over the smallest.
 */
#ifndef LOFT_SURFACE_AREA_H
#define LOFT_SURFACE_AREA_H

#include "surface/net.h"    /* loft_net */

LOFT_BEGIN_C

/* What is spent on a net, after which its tolerance counts as not provable: halvings at degrees
 * m = n = 1, at higher ones fewer. */
#define LOFT_NET_AREA_HALVINGS 100000u

/* Numbers that nets of degrees m, n need, 16 bytes each in q16, 8 in floats. */
#define LOFT_NET_AREA_MEMORY(m, n)                                                                 \
    (6u * (3u * (m)) * (3u * (n)) + 2u * ((m) + 1) * ((n) + 1) +                                   \
     3u * (m) * ((m) + 5) + 4u * ((m) + 1) + 3u * (n) * ((n) + 5) + 4u * ((n) + 1))

/* The same for loft_net_cone_moment. */
#define LOFT_NET_MOMENT_MEMORY(m, n)                                                               \
    (6u * (4u * (m) - 1) * (4u * (n) - 1) + 2u * ((m) + 1) * ((n) + 1) +                           \
     (4u * (m) - 1) * ((m) + 5) + 4u * ((m) + 1) + (4u * (n) - 1) * ((n) + 5) + 4u * ((n) + 1))

/* The area, in the first three axes. Folds count more than once.
 *
 *   shape   memory[LOFT_NET_AREA_MEMORY(m, n)]
 *   range   tol > 0, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the area does not fit a loft_acc
 *           (q16: 2^31), in f32 and f64 when loft_exact_valid refuses a coordinate, or when `tol`
 *           is not proved by 24 halvings along a parameter, or by LOFT_NET_AREA_HALVINGS over
 *           m n (m + n) / 2 in all; *out is then untouched
 *   error   tol, in units squared, plus q16: 2^-32 + 2^-48 A   f32, f64: 2^-40 A. A plane patch
 *           without weights and folds has only the second part
 *   cost    once up to m^3 n^3 products of num/sci.h; per piece about 100 m n (m + n) of them, and
 *           300 m n (m + n) with weights. The number of pieces grows with tol^(-1/4), along a fold
 *           with tol^(-1/2); not for an ISR
 *   stack   Cortex-M4 9,452   Cortex-M0+ 9,448   ATmega328P 5,818
 *   see     Davis, Rabinowitz: Methods of Numerical Integration, 2.7: the error of Gauss's formula
 */
enum loft_status loft_net_area(loft_net s, loft_real tol, loft_sci memory[],
                               loft_acc *out) LOFT_CHECKED;

/* The volume of the cone from `apex` over the net: positive where P_x x P_y points away from it.
 *
 *   shape   memory[LOFT_NET_AREA_MEMORY(m, n)]
 *   range   three axes or more; otherwise as loft_net_area
 *   error   tol, in units cubed, plus q16: 2^-32 + 2^-48 A L   f32, f64: 2^-40 A L, L the largest
 *           distance from the apex. Without weights only the second part
 *   cost    as loft_net_area, a third of that per piece
 *   see     the divergence theorem, as volume.h
 */
enum loft_status loft_net_cone_volume(loft_net s, loft_vec apex, loft_real tol, loft_sci memory[],
                                      loft_acc *out) LOFT_CHECKED;

/* The first moments of that cone: the integrals of x, y, z, seen from the apex. Positive and
 * negative parts as for the volume.
 *
 *   shape   memory[LOFT_NET_MOMENT_MEMORY(m, n)]; degrees 1 or more
 *   range   three axes or more; otherwise as loft_net_area, but any moments fit
 *   error   tol, in units to the 4th power, plus q16: 2^-48 A L^2   f32, f64: 2^-40 A L^2. Without
 *           weights only the second part
 *   cost    four times loft_net_cone_volume per piece, and 27 m^2 n^2 products once
 *   see     the divergence theorem; Gonzalez-Ochoa, McCammon, Peters (1998), as volume.h
 */
enum loft_status loft_net_cone_moment(loft_net s, loft_vec apex, loft_real tol, loft_sci memory[],
                                      loft_sci out[3]) LOFT_CHECKED;

LOFT_END_C

#endif
