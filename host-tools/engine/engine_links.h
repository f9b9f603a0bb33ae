/* host-tools/engine/engine_links.h -- the ways of a mill between lines, and into the material; part
 * of engine_mill.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_LINKS_H
#define LOFT_HOST_ENGINE_LINKS_H

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/mill.h"            /* mill_cuts */
#include "toolpath/drop.h"          /* loft_drop */

/* Join the cuts, in their order, to one path from the safe height to the safe height. Between them
 * the tool rises as far as it must. Every chord is proved clear; where a ramp or a helix is not, it
 * goes straight down. */
void ENGINE_OF(engine_links)(const loft_drop *d, const mill_order *o, mill_cuts *cuts,
                             mill_cuts *path, mill_report *out);

#endif
