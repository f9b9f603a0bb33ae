/* host-tools/engine/engine_isolines.h -- lines of constant parameters as a mill's path; part of
 * engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_ISOLINES_H
#define LOFT_HOST_ENGINE_ISOLINES_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/engine_sheet.h"    /* engine_sheet_list */
#include "engine/mill.h"            /* mill_cuts */
#include "toolpath/drop.h"          /* loft_drop */

/* Lead the axis of the tool over lines of constant v (o->axis 0) or u (1) of each surface, there
 * and back, o->step apart: one cut per surface, of chords that are proved clear. Returns enum
 * loft_status. */
int ENGINE_OF(engine_isolines)(const loft_drop *d, const engine_sheet_list *sheets,
                               const mill_order *o, mill_cuts *out, size_t *lines);

#endif
