/* lib/surface/tensor/ferguson.h -- bicubic patches through a grid of points: estimates of tangents
 * and twists
 * SPDX-License-Identifier: MIT
 *
 * The grid has rows x columns points at whole parameters: row i at u = i, column j at v = j. Each
 * cell becomes a bicubic patch over 0..1 x 0..1 (surface/tensor/bicubic.h). Tangents are those of
 * the parabolas through three neighbours (Bessel). Neighbouring cells have the same data at their
 * corners, so tangents and twists are continuous across them.
 *
 *     loft_bicubic b;
 *     for (i = 0; i + 1 < rows; i++)
 *         for (j = 0; j + 1 < columns; j++)
 *             if (loft_bicubic_from_grid(p, rows, columns, i, j, LOFT_TWIST_ADINI, &b) == LOFT_OK)
 *             ..
 */
#ifndef LOFT_SURFACE_TENSOR_FERGUSON_H
#define LOFT_SURFACE_TENSOR_FERGUSON_H

#include "surface/tensor/bicubic.h"     /* loft_bicubic */

LOFT_BEGIN_C

/* The twist at a point of the grid.
 *
 *   ZERO    0 (Ferguson): flat spots at the points
 *   ADINI   that of the Coons patch over the four cells around the point, between the curves
 *           through its neighbours: right for surfaces of translation, f(u) + g(v)
 *   BESSEL  that of the biquadratic patch through the nine points around
 *
 * At the border the cells and points that there are. */
enum loft_twist { LOFT_TWIST_ZERO, LOFT_TWIST_ADINI, LOFT_TWIST_BESSEL };

/* The patch of the cell between rows i, i + 1 and columns j, j + 1.
 *
 *   range   2 rows and columns or more, i + 1 < rows and j + 1 < columns, a twist of the list,
 *           otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a tangent or a twist does not fit; *out is
 *           then untouched
 *   error   tangents and twists: q16: 1/2 LSB   f32: 1 ulp   f64: 16 ulp of the largest coordinate
 *           of the grid
 *   cost    at most 9 small products per number
 *   see     Farin, Curves and Surfaces for CAGD, ch. 16: twist estimation; Barnhill, Brown and
 *           Klucewicz, A new twist in computer aided geometric design (1978)
 */
enum loft_status loft_bicubic_from_grid(const loft_vec p[], uint32_t rows, uint32_t columns,
                                        uint32_t i, uint32_t j, enum loft_twist twist,
                                        loft_bicubic *out) LOFT_CHECKED;

LOFT_END_C

#endif
