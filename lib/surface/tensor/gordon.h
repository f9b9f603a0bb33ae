/* lib/surface/tensor/gordon.h -- Gordon surfaces: through a whole network of curves
 * SPDX-License-Identifier: MIT
 *
 * `columns` curves run along u at the parameters v[0] = 0 .. v[columns - 1] = 1, and `rows` curves
 * along v at u[0] = 0 .. u[rows - 1] = 1. Every curve meets every curve of the other family there.
 * The surface is the Boolean sum of the surfaces through either family
 *
 *     S(s, t) = sum f_j(t) U_j(s) + sum g_i(s) V_i(t) - sum sum g_i(s) f_j(t) P_ij
 *
 * f_j and g_i are the natural cubic splines that are 1 at their own parameter and 0 at the others.
 * Two curves each way make the bilinear Coons patch (surface/tensor/coons.h). Curves are of any
 * kind:
 *
 *     loft_gordon g;
 *     loft_gordon_point memory[ROWS * COLUMNS];
 *     if (loft_gordon_init(&g, along_u, v, COLUMNS, along_v, u, ROWS, tol, memory) == LOFT_OK &&
 *         loft_gordon_eval(&g, s, t, &p) == LOFT_OK) ..
 *
 * Between curves that are Bezier curves in each cell of the network it consists of tensor patches.
 * In the `error` lines L is the largest sum of |f_j| plus that of |g_i| plus their product: 3 for
 * two curves each way, below 8 for evenly spaced ones.
 */
#ifndef LOFT_SURFACE_TENSOR_GORDON_H
#define LOFT_SURFACE_TENSOR_GORDON_H

#include "surface/tensor/coons.h"       /* loft_side */

LOFT_BEGIN_C

#define LOFT_GORDON_MAX 16      /* curves each way */

/* A crossing of two curves. */
typedef struct {
    loft_acc axis[LOFT_AXES];
} loft_gordon_point;

/* A surface. Everything is borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_side *along_u, *along_v;
    const loft_unit *u, *v;
    const loft_gordon_point *crossing;      /* row by row: columns i + j */
    uint8_t rows, columns;
} loft_gordon;

/* Take a network; all arrays must outlive it.
 *
 *   shape   along_u[columns] at v[columns]; along_v[rows] at u[rows]; memory[rows columns]
 *   range   2..LOFT_GORDON_MAX curves each way; parameters that ascend from 0 to 1; curves that
 *           meet within tol >= 0 in every coordinate, otherwise LOFT_ERR_ARG. *g is untouched after
 *           an error, memory undefined. Crossings are those of the curves along u. Where curves
 *           along v miss them by d, the surface follows the curves along u within d times the sum
 *           of |g_i|
 *   error   the crossings: that of the curves
 *   cost    2 rows columns points of curves
 */
enum loft_status loft_gordon_init(loft_gordon *g, const loft_side along_u[], const loft_unit v[],
                                  unsigned columns, const loft_side along_v[], const loft_unit u[],
                                  unsigned rows, loft_real tol,
                                  loft_gordon_point memory[]) LOFT_CHECKED;

/* The point at (s, t).
 *
 *   range   s, t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the point does not fit; *out is
 *           then untouched
 *   error   L times that of the curves, and q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp of the result +
 *           L 2^-20 ulp   f64: 64 L ulp, of the largest coordinate
 *   cost    a point of each curve, 40 (rows + columns) and per axis 2 (rows + columns) + rows
 *           columns operations of num/sci.h
 *   stack   Cortex-M4 3,452   Cortex-M0+ 3,472   ATmega328P 2,486   + callback
 *   see     Gordon, Spline-blended surface interpolation through curve networks (1969); Farin,
 *           Curves and Surfaces for CAGD, ch. 23
 */
enum loft_status loft_gordon_eval(const loft_gordon *g, loft_unit s, loft_unit t,
                                  loft_vec *out) LOFT_CHECKED;

/* The part of the surface over from[0]..to[0] along u and from[1]..to[1] along v, as a tensor patch
 * of the degrees m and n. The curves are given by their pieces there: Bezier curves
 * along_u[columns] and along_v[rows].
 *
 *   shape   out[(m + 1) (n + 1)], rows along u
 *   range   a part within one cell of the network, from < to; pieces along u of degree m or less,
 *           along v of degree n or less, m and n in 3..9; otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if
 *           a point does not fit; out[] is then undefined
 *   error   L times that of the pieces and crossings, and q16: 1/2 LSB + 2^-16 LSB   f32: 1/2 ulp +
 *           L 2^-20 ulp   f64: 64 L ulp, of the largest coordinate
 *   cost    in operations of num/sci.h 80 (rows + columns)^2, and per point and axis 2 (rows +
 *           columns) + rows columns
 *   stack   Cortex-M4 13,396   Cortex-M0+ 13,408   ATmega328P 9,308
 */
enum loft_status loft_tensor_from_gordon(const loft_gordon *g, const loft_bezier along_u[],
                                         const loft_bezier along_v[], const loft_unit from[2],
                                         const loft_unit to[2], unsigned m, unsigned n,
                                         loft_vec out[]) LOFT_CHECKED;

LOFT_END_C

#endif
