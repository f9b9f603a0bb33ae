/* host-tools/geometry/reference_surface.h -- surfaces by their definitions, in long double
 * SPDX-License-Identifier: MIT
 *
 * This shares no code with the library: sums of Bernstein polynomials, Hermite's cubics, sines.
 */
#ifndef LOFT_REFERENCE_SURFACE_H
#define LOFT_REFERENCE_SURFACE_H

#include "engine/surface.h"

/* The point at u, v. Returns false for kinds without a definition here: Coons patches with slopes,
 * pn, octant, gregory, nurbs-surface, and all with n sides. */
bool reference_surface(const surface *s, long double u, long double v,
                       long double out[SURFACE_AXES]);

#endif
