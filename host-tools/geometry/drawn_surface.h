/* host-tools/geometry/drawn_surface.h -- surfaces in pictures whose degrees are above those of the
 * library, in double
 * SPDX-License-Identifier: MIT
 *
 * `tensor` and `triangle` may have degrees up to SURFACE_DRAWN_MAX here, such as nets of a surface
 * that was raised: the host computes with them. drawn.h does the same for curves.
 */
#ifndef LOFT_HOST_DRAWN_SURFACE_H
#define LOFT_HOST_DRAWN_SURFACE_H

#include "engine/engine.h"      /* engine_look */
#include "engine/surface.h"

/* The point at u, v of a surface for which surface_is_high, with its normal, Gaussian and mean
 * curvature; out->derived and the rest stay as they are. Where there is no normal it is that of a
 * place 2^-20 of the way to the middle. Returns enum loft_status: LOFT_SINGULAR if there is none
 * either; the point is there. */
int drawn_surface(const surface *s, double u, double v, double point[SURFACE_AXES],
                  engine_look *out);

#endif
