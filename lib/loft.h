/* lib/loft.h -- include this: the whole of loft, room by room
 * SPDX-License-Identifier: MIT
 *
 *   num/      what a number is       loft_real loft_unit loft_acc; one source for Q16.16, float and double
 *   geom/     what a point is        loft_vec, loft_box
 *   basis/    weights                Bernstein polynomials, power form, Horner; sign: positive, convex
 *   curve/    one parameter          bezier: point, derivative, pieces   forward: exact walking   measure: flatten, length
 *                                    bounds, nearest, intersect, overlap, offset: where it is   shape: cusps, curvature   join: C0 to G2
 *                                    hermite, cardinal, natural, parabola: through given points   bspline, nurbs
 *                                    rational, circle: conics and arcs   cubics: all of them as cubics
 *   surface/  two parameters         tensor, tensor_rational, tensor_join: patches over a square
 *                                    grid: whole patches by exact differences   local, area: normals, curvatures, area
 *                                    barycentric, triangle: Bezier triangles   tetra: tetrahedra   triangle_shape: positive, convex
 *                                    triangle_pieces, _join, _rational, _curvature   octant: of a sphere   pn: from normals
 *                                    coons, bicubic: from curves and corners   sphere, flat: elementary
 *   polygon/  n sides                domain: convex and simple polygons   wachspress, meanvalue: coordinates
 *                                    spatch, toric, basepoint, ring, gb: Bezier surfaces over them
 *   motion/   time                   plan: look-ahead   span: a cubic in time   pace: hold and resume   step: pulses
 *   wire/     bytes                  frame, codec, message, session: curves over a serial line (WIRE.md)
 *   machine/  the controller         wire -> queue -> span -> step
 *
 * A file includes its own room and rooms above it. DESIGN.md says why it is so.
 */
#ifndef LOFT_H
#define LOFT_H

#define LOFT_VERSION_MAJOR 0
#define LOFT_VERSION_MINOR 1
#define LOFT_VERSION_PATCH 0
#define LOFT_VERSION "0.1.0"

#include "num/num.h"
#include "num/accs.h"
#include "num/angle.h"
#include "num/deep.h"
#include "num/exact.h"
#include "num/power.h"
#include "num/sci.h"
#include "geom/normal.h"
#include "geom/vec.h"
#include "basis/bernstein.h"
#include "basis/copositive.h"
#include "basis/interp.h"
#include "basis/knots.h"
#include "basis/operator.h"
#include "basis/sign.h"
#include "basis/steps.h"
#include "curve/bezier.h"
#include "curve/bounds.h"
#include "curve/bspline.h"
#include "curve/cardinal.h"
#include "curve/circle.h"
#include "curve/cubics.h"
#include "curve/forward.h"
#include "curve/hermite.h"
#include "curve/intersect.h"
#include "curve/overlap.h"
#include "curve/join.h"
#include "curve/measure.h"
#include "curve/natural.h"
#include "curve/nearest.h"
#include "curve/nurbs.h"
#include "curve/offset.h"
#include "curve/parabola.h"
#include "curve/rational.h"
#include "curve/rational_walk.h"
#include "curve/shape.h"
#include "surface/area.h"
#include "surface/barycentric.h"
#include "surface/bicubic.h"
#include "surface/coons.h"
#include "surface/flat.h"
#include "surface/sphere.h"
#include "surface/octant.h"
#include "surface/pn.h"
#include "surface/tetra.h"
#include "surface/triangle.h"
#include "surface/triangle_curvature.h"
#include "surface/triangle_join.h"
#include "surface/triangle_operator.h"
#include "surface/triangle_pieces.h"
#include "surface/triangle_rational.h"
#include "surface/triangle_shape.h"
#include "surface/grid.h"
#include "surface/deficit.h"
#include "surface/local.h"
#include "surface/tensor.h"
#include "surface/tensor_join.h"
#include "surface/tensor_rational.h"
#include "polygon/basepoint.h"
#include "polygon/blend.h"
#include "polygon/domain.h"
#include "polygon/gb.h"
#include "polygon/harmonic.h"
#include "polygon/jet.h"
#include "polygon/jet_blend.h"
#include "polygon/lattice.h"
#include "polygon/meanvalue.h"
#include "polygon/multi.h"
#include "polygon/ring.h"
#include "polygon/spatch.h"
#include "polygon/toric.h"
#include "polygon/wachspress.h"
#include "motion/plan.h"
#include "motion/kinematics.h"
#include "motion/span.h"
#include "motion/pace.h"
#include "motion/step.h"
#include "wire/frame.h"
#include "wire/codec.h"
#include "wire/message.h"
#include "wire/session.h"
#include "machine/machine.h"

#endif
