/* host-tools/engine/engine_points.h -- surfaces that remember their points; part of engine_mill.c
 * SPDX-License-Identifier: MIT
 *
 * A search of loft_drop asks for the same points again and again, since places that follow each
 * other lie over the same parts of a surface.
 */
#ifndef LOFT_HOST_ENGINE_POINTS_H
#define LOFT_HOST_ENGINE_POINTS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "toolpath/sheet.h"         /* loft_sheet */

typedef struct engine_points engine_points;

/* Let sheets remember the points of their surfaces, until they are freed. */
engine_points *ENGINE_OF(engine_points_of)(loft_sheet sheet[], size_t count);
void ENGINE_OF(engine_points_free)(engine_points *p);

#endif
