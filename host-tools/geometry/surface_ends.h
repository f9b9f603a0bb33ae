/* host-tools/geometry/surface_ends.h -- knots and polygons of a surface that was read
 * SPDX-License-Identifier: MIT
 *
 * Both print one line for `at` and return an exit code if it is not valid, else 0.
 */
#ifndef LOFT_HOST_SURFACE_ENDS_H
#define LOFT_HOST_SURFACE_ENDS_H

#include "base/text_lines.h"         /* lines */
#include "engine/surface.h"

/* Knots of a NURBS surface. Without knots: 0 .. 0 1 2 .. m .. m, as for curves. */
int surface_end_knots(const lines *at, surface *s);

/* A patch with n sides has a polygon: the regular one if none was given. */
int surface_end_domain(const lines *at, surface *s);

#endif
