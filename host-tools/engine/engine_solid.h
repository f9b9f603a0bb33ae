/* host-tools/engine/engine_solid.h -- tetrahedra through the library
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SOLID_H
#define LOFT_HOST_ENGINE_SOLID_H

#include "surface/tetra.h"          /* loft_tetra */

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/surface.h"         /* surface */

/* The control points in the number type, and the tetrahedron of them. enum loft_status */
int ENGINE_OF(engine_solid_open)(const surface *s, loft_vec p[LOFT_TETRA_MAX], loft_tetra *out);

/* As `solid` of an engine. */
int ENGINE_OF(engine_solid_eval)(const surface *s, const double at[3], double out[ENGINE_AXES]);

#endif
