/* host-tools/engine/engine_cells.h -- how fine a grid shows all lines of a level; part of
 * engine_surface.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_CELLS_H
#define LOFT_HOST_ENGINE_CELLS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/surface.h"         /* engine_surface */

/* Raise *n, at most to `most`, until its grid shows the lines of a height or a plane as they are:
 * each part of the surface as large as two cells (as one, of the finest grid) has no line, or one
 * that is a graph over some direction. *doubt has the parts for which `most` does not suffice.
 * Angles, and surfaces without nets, leave *n alone. Returns enum loft_status. */
int ENGINE_OF(engine_cells)(engine_surface *e, const engine_level *of, unsigned most, unsigned *n,
                            engine_doubt *doubt);

#endif
