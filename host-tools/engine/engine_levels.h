/* host-tools/engine/engine_levels.h -- surfaces milled level by level; part of engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_LEVELS_H
#define LOFT_HOST_ENGINE_LEVELS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_report */
#include "toolpath/drop.h"          /* loft_drop */

/* Give the points of the waterlines, from `top` down to the floor of the drop in even steps of at
 * most `step`. Between lines the tool rises as far as it must. Returns enum loft_status. */
int ENGINE_OF(engine_levels)(const loft_drop *d, const loft_box *area, double top, double step,
                             engine_point_sink *sink, void *context, mill_report *out);

#endif
