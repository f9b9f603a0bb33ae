/* host-tools/engine/engine_left.h -- what a path of a mill leaves on surfaces, at most; part of
 * engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_LEFT_H
#define LOFT_HOST_ENGINE_LEFT_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_order */
#include "toolpath/drop.h"          /* loft_drop */

/* Set left, hollow and reached of *out: bounds for every point of the surfaces.
 *
 *   error   none: they are never too small. How near they come: mill.h
 *   cost    less than that of a path over all of them; it has 2 points at least
 */
void ENGINE_OF(engine_left)(const loft_drop *d, const mill_order *o, const mill_cut *path,
                            mill_report *out);

#endif
