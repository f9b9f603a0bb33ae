/* host-tools/engine/engine_touch.h -- where a tool must be to touch all of the surfaces; part of
 * engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_TOUCH_H
#define LOFT_HOST_ENGINE_TOUCH_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_order */
#include "toolpath/drop.h"          /* loft_drop */

/* Widen o->area and lower o->lowest, which are not given, until they hold each place where the tool
 * touches a surface from above. Beside a steep border that is up to a radius outside, and below the
 * border. The half of a step farther out, where the last line may be, is low enough too. */
void ENGINE_OF(engine_touch)(const loft_drop *d, mill_order *o);

#endif
