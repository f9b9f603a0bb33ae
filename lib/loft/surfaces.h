/* lib/loft/surfaces.h -- include this for surfaces: the library libloft-surfaces, room by room
 * SPDX-License-Identifier: MIT
 *
 *   surface/     two parameters
 *                  tensor/                               patches over a square; grid, area; coons
 *                  ... nurbs_surface, ruled, revolve, skin   B-splines; made from curves
 *                  triangle/                             Bezier triangles: pieces, joins, shape
 *                  barycentric, tetra                    coordinates, tetrahedra
 *                  octant, pn, sphere, plane             given by normals, elementary
 *                  differential, deficit                 normals and curvatures
 *                  surface, contour                      any surface as a function, waterlines
 *   polygon/     n sides
 *                  domain, partition                     polygons and their convex parts
 *                  wachspress, meanvalue, harmonic       coordinates in them
 *                  spatch, toric, basepoint, zheng_ball, gb   Bezier patches over them
 *                  disk                                  such a patch as one surface
 *   toolpath/    surfaces as the path of a tool
 *                  patches                               ... that a machine takes from the line
 *
 * It needs libloft, and includes loft.h. Link libloft-surfaces before libloft.
 */
#ifndef LOFT_SURFACES_H
#define LOFT_SURFACES_H

#include "loft.h"
#include "surface/barycentric.h"
#include "surface/tensor/bicubic.h"
#include "surface/contour.h"
#include "surface/tensor/coons.h"
#include "surface/plane.h"
#include "surface/surface.h"
#include "surface/sphere.h"
#include "surface/area.h"
#include "surface/net_field.h"
#include "surface/level.h"
#include "surface/net.h"
#include "surface/net_branch.h"
#include "surface/net_cell.h"
#include "surface/net_meet.h"
#include "surface/net_nearest.h"
#include "surface/net_ray.h"
#include "surface/octant.h"
#include "surface/volume.h"
#include "surface/pn.h"
#include "surface/tetra.h"
#include "surface/triangle/triangle.h"
#include "surface/triangle/triangle_curvature.h"
#include "surface/triangle/triangle_join.h"
#include "surface/triangle/triangle_operator.h"
#include "surface/triangle/triangle_pieces.h"
#include "surface/triangle/triangle_rational.h"
#include "surface/triangle/triangle_shape.h"
#include "surface/tensor/gordon.h"
#include "surface/tensor/gregory.h"
#include "surface/tensor/ferguson.h"
#include "surface/tensor/grid.h"
#include "surface/deficit.h"
#include "surface/differential.h"
#include "surface/tensor/nurbs_surface.h"
#include "surface/tensor/revolve.h"
#include "surface/tensor/ruled.h"
#include "surface/tensor/skin.h"
#include "surface/tensor/surface_fit.h"
#include "surface/tensor/sweep.h"
#include "surface/tensor/tensor.h"
#include "surface/triangle/triangle_integral.h"
#include "surface/tensor/tensor_join.h"
#include "surface/tensor/tensor_part.h"
#include "surface/tensor/tensor_rational.h"
#include "polygon/basepoint.h"
#include "polygon/weighted_sum.h"
#include "polygon/domain.h"
#include "polygon/gb.h"
#include "polygon/harmonic.h"
#include "polygon/hole.h"
#include "polygon/jet.h"
#include "polygon/jet_ball.h"
#include "polygon/jet_ball_sum.h"
#include "polygon/jet_weighted_sum.h"
#include "polygon/lattice.h"
#include "polygon/meanvalue.h"
#include "polygon/multiindex.h"
#include "polygon/partition.h"
#include "polygon/patch_ball.h"
#include "polygon/zheng_ball.h"
#include "polygon/disk.h"
#include "polygon/disk_part.h"
#include "polygon/spatch.h"
#include "polygon/spatch_triangle.h"
#include "polygon/toric.h"
#include "polygon/toric_tensor.h"
#include "polygon/wachspress.h"
#include "toolpath/cutter.h"
#include "toolpath/drop.h"
#include "toolpath/lines.h"
#include "toolpath/pencil.h"
#include "toolpath/tip_place.h"
#include "toolpath/raster.h"
#include "toolpath/region.h"
#include "toolpath/sector.h"
#include "toolpath/waterline.h"
#include "toolpath/sheet.h"
#include "toolpath/patches.h"

#endif
