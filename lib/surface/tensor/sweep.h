/* lib/surface/tensor/sweep.h -- a section swept along a path, without a twist about it
 * SPDX-License-Identifier: MIT
 *
 * Stations at equal steps of the parameter divide a path of Bezier curves. At each station the
 * section stands in a frame that does not twist (curve/moving_frame.h): its x across the path, its
 * y at a right angle to both. A skin (surface/tensor/skin.h) over these sections is the surface.
 *
 *     if (loft_sweep_sections(path, pieces, STATIONS, up, section, DEGREE, placed) == LOFT_OK &&
 *         loft_skin_init(&s, placed, DEGREE, STATIONS, v, LOFT_ENDS_NATURAL, memory) == LOFT_OK) ..
 */
#ifndef LOFT_SURFACE_TENSOR_SWEEP_H
#define LOFT_SURFACE_TENSOR_SWEEP_H

#include "curve/bezier.h"       /* loft_bezier */

LOFT_BEGIN_C

/* The control points of the section at all stations: out[stations (degree + 1)], the first station
 * first. The curves of the path follow each other; `up` is where x of the section points at the
 * start (curve/moving_frame.h).
 *
 *   range   three axes or more, 1 piece or more, 2..65535 stations, degree 0..9, otherwise
 *           LOFT_ERR_ARG; LOFT_SINGULAR as the functions of moving_frame.h, for example where the
 *           path has a cusp; LOFT_ERR_RANGE if a point or a derivative of the path does not fit.
 *           *out is undefined after an error
 *   error   that of loft_moving_frame_point; the frames are those of the points and derivatives of
 *           the path as loft_bezier_eval and loft_bezier_deriv round them, at parameters rounded
 *           once: q16, f32: 2^-25   f64: 2^-54. Between stations the skin errs by the fourth power
 *           of their distance
 *   cost    per station a point and a derivative of the path, loft_moving_frame_move, and degree +
 *           1 times loft_moving_frame_point
 *   see     Wang, Juettler, Zheng and Liu, Computation of rotation minimizing frames (2008); The
 *           NURBS Book, ch. 10.4: swept surfaces
 */
enum loft_status loft_sweep_sections(const loft_bezier path[], unsigned pieces, uint32_t stations,
                                     loft_vec up, const loft_vec section[], unsigned degree,
                                     loft_vec out[]) LOFT_CHECKED;

LOFT_END_C

#endif
