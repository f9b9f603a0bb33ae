/* host-tools/engine/engine_pencils.h -- the valleys of surfaces; part of engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_PENCILS_H
#define LOFT_HOST_ENGINE_PENCILS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_cuts */
#include "toolpath/drop.h"          /* loft_drop */

/* Find the valleys in which a ball touches twice, each as a cut of chords that are proved clear.
 * Returns enum loft_status. */
int ENGINE_OF(engine_pencils)(const loft_drop *d, const loft_box *area, const mill_order *o,
                              mill_cuts *out);

#endif
