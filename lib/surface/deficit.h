/* lib/surface/deficit.h -- Gaussian curvature of a mesh at a vertex, from the angle deficit
 * SPDX-License-Identifier: MIT
 *
 *     K = (2 pi - sum of the angles at the vertex) / mixed area
 *
 * The mixed area counts, of each triangle around the vertex, the part that is nearer to this vertex
 * than to the other two. It counts half of a triangle that is obtuse at this vertex, and a quarter
 * of one that is obtuse elsewhere.
 *
 * As a measure of the mesh K is exact: over all vertices of a closed mesh without holes, K times
 * the area sums to 4 pi. As an estimate of the curvature of the underlying surface K does NOT
 * converge when the mesh is refined. Deficit and area both shrink as h^2, so their quotient still
 * depends on the shape of the ring of neighbours. K converges to the curvature for four neighbours
 * at equal distances along the lines of curvature. On a sphere, four neighbours along lines that
 * cross at 60 degrees give 1.6 times the curvature, at 45 degrees 2.5 times. Four neighbours along
 * the straight lines of a saddle give 0, however fine the mesh. For the curvature of a known
 * surface use loft_differential_curvatures (surface/differential.h).
 *
 *   see     Meyer, Desbrun, Schroeder, Barr, Discrete differential-geometry operators for
 *           triangulated 2-manifolds (2002); Xu, Convergence of discrete Laplace-Beltrami operators
 *           and Gaussian curvature over triangular surfaces (2004)
 */
#ifndef LOFT_SURFACE_DEFICIT_H
#define LOFT_SURFACE_DEFICIT_H

#include "geom/vec.h"   /* loft_vec */
#include "num/sci.h"    /* loft_sci */

LOFT_BEGIN_C

typedef struct {
    loft_sci angles, area, gauss;       /* sum of the angles, mixed area, Gaussian curvature */
} loft_deficit;

/* Compute them at a vertex with a closed ring of `count` neighbours, in order around it, in the
 * first three axes.
 *
 *   shape   ring[count]
 *   range   3..255 neighbours, otherwise LOFT_ERR_ARG; f32, f64: coordinates that
 *           loft_exact_valid, otherwise LOFT_ERR_RANGE; LOFT_SINGULAR for a neighbour at the
 *           vertex or an area of 0; *out is then untouched. A triangle without area has an angle of
 *           0 or a half turn
 *   error   angles: q16: count * 2^-54   f32, f64: count * 2^-48; area: q16: 2^-55   f32, f64:
 *           2^-46 of the sum of the squared distances of the neighbours; gauss: the error of the
 *           angles over the area, plus the relative error of the area times gauss
 *   cost    count times 20 products, 2 quotients, a root and an angle; no table
 */
enum loft_status loft_deficit_eval(const loft_vec *vertex, const loft_vec ring[], unsigned count,
                                   loft_deficit *out) LOFT_CHECKED;

LOFT_END_C

#endif
