/* lib/loft.h -- include this for curves, motion and machines: the library libloft, room by room
 * SPDX-License-Identifier: MIT
 *
 *   num/         what a number is: loft_real, loft_unit, loft_acc; Q16.16, float, double
 *   geom/        what a point is: loft_vec, loft_box
 *   basis/       weights: Bernstein polynomials, power form, interpolation, knots; sign, convexity
 *   curve/       one parameter
 *                  bezier, rational, bspline, nurbs      points, derivatives, subsegments
 *                  hermite, cardinal, natural, parabola  through given points
 *                  spline, tcb, catmull                  ... with any ends, tension, uneven knots
 *                  monotone, tween                       functions: y at x
 *                  circle                                arcs of circles and ellipses, helices
 *                  forward, rational_walk                exact walking
 *                  cubics                                any curve as cubics
 *                  measure                               flattening, length
 *                  bounds, nearest, clip, intersect, overlap   where a curve is
 *                  conic, reduce, enclosed               kinds, lower degrees, areas
 *                  tangent                               second derivatives, curvature with weights
 *                  offset, shape, join                   tool paths, cusps, curvature, C0 to G2
 *                  drawing                               a table of curves in flash
 *   kinematics/  motors and tool: CoreXY, delta, polar
 *   motion/      time: plan (look-ahead), span (a cubic in time), scurve (one axis to a target),
 *                  waypoints (through points)
 *   wire/        bytes: frames, codec, messages, sessions (WIRE.md)
 *   machine/     the controller: queue, pace (hold and resume), step (pulses)
 *
 * Surfaces, patches and paths of a mill over them are a library of their own, libloft-surfaces:
 * loft/surfaces.h. A file includes its own room and rooms above it. RECIPES.md names the functions
 * for a task, CATALOGUE.md what exists for which curve and patch. DESIGN.md gives the reasons.
 */
#ifndef LOFT_H
#define LOFT_H

/* The version of library and tools (CHANGELOG.md), here and nowhere else; the wire has its own. */
#define LOFT_VERSION_MAJOR 0
#define LOFT_VERSION_MINOR 2
#define LOFT_VERSION_PATCH 0
#define LOFT_VERSION_TEXT(major, minor, patch) #major "." #minor "." #patch
#define LOFT_VERSION_OF(major, minor, patch) LOFT_VERSION_TEXT(major, minor, patch)
#define LOFT_VERSION LOFT_VERSION_OF(LOFT_VERSION_MAJOR, LOFT_VERSION_MINOR, LOFT_VERSION_PATCH)

#include "num/num.h"
#include "num/accs.h"
#include "num/angle.h"
#include "num/acc2.h"
#include "num/acc128.h"
#include "num/exact.h"
#include "num/muldiv.h"
#include "num/part.h"
#include "num/explog.h"
#include "num/flash.h"
#include "num/sci.h"
#include "num/text.h"
#include "num/walk2.h"
#include "num/residue.h"
#include "geom/chord.h"
#include "geom/chord_pair.h"
#include "geom/normal.h"
#include "geom/vec.h"
#include "geom/vec_exact.h"
#include "basis/bernstein.h"
#include "basis/copositive.h"
#include "basis/interp.h"
#include "basis/knots.h"
#include "basis/knots_basis.h"
#include "basis/bernstein_operator.h"
#include "basis/integral.h"
#include "basis/positivity.h"
#include "basis/residue_poly.h"
#include "basis/sign.h"
#include "basis/whole_roots.h"
#include "basis/differences.h"
#include "curve/bezier.h"
#include "curve/bounds.h"
#include "curve/bspline.h"
#include "curve/conic.h"
#include "curve/crossings.h"
#include "curve/enclosed.h"
#include "curve/reduce.h"
#include "curve/cardinal.h"
#include "curve/catmull.h"
#include "curve/circle.h"
#include "curve/drawing.h"
#include "curve/fit.h"
#include "curve/to_cubics.h"
#include "curve/tween.h"
#include "curve/forward.h"
#include "curve/hermite.h"
#include "curve/clip.h"
#include "curve/inflections.h"
#include "curve/intersect.h"
#include "curve/overlap.h"
#include "curve/join.h"
#include "curve/knot_removal.h"
#include "curve/measure.h"
#include "curve/monotone.h"
#include "curve/moving_frame.h"
#include "curve/natural.h"
#include "curve/nearest.h"
#include "curve/nurbs.h"
#include "curve/offset.h"
#include "curve/parabola.h"
#include "curve/rational.h"
#include "curve/rational_walk.h"
#include "curve/self_crossings.h"
#include "curve/shape.h"
#include "curve/spline.h"
#include "curve/tangent.h"
#include "curve/tcb.h"
#include "kinematics/kinematics.h"
#include "motion/plan.h"
#include "motion/scurve.h"
#include "motion/span.h"
#include "motion/waypoints.h"
#include "machine/pace.h"
#include "machine/step.h"
#include "wire/frame.h"
#include "wire/codec.h"
#include "wire/patch_code.h"
#include "wire/message.h"
#include "wire/session.h"
#include "machine/latch.h"
#include "machine/settings.h"
#include "machine/machine.h"

#endif
