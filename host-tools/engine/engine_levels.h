/* host-tools/engine/engine_levels.h -- surfaces milled level by level; part of engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_LEVELS_H
#define LOFT_HOST_ENGINE_LEVELS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_cuts */
#include "toolpath/drop.h"          /* loft_drop */

/* Find the waterlines, from `top` down to the floor of the drop in even steps of at most `step`.
 * Returns enum loft_status. */
int ENGINE_OF(engine_levels)(const loft_drop *d, const loft_box *area, double top, double step,
                             const mill_order *o, mill_cuts *out);

#endif
