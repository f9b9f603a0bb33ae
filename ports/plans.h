/* ports/plans.h -- the planner of a board and its memory, for LOFT_PORT_CURVES curves
 * SPDX-License-Identifier: MIT
 *
 * Include it after `CELLS`, the size of the queue, is defined. Call loft_port_plans before the
 * configuration is returned. Half of the curves should be longer than the braking distance. Cost:
 * about 15 kB of RAM, 52 bytes of them for each knot, 52 more bytes for each curve, and 33 to 37 kB
 * of flash on a Cortex-M. It takes patches, too, with LOFT_PORT_COLUMNS curves of a line, unless
 * LOFT_PORT_PATCHES is 0: 5.4 kB more of RAM, 24 bytes of them for each column, and 19 kB of flash
 * (-Os: 15 kB).
 */
#ifndef LOFT_PLANS_H
#define LOFT_PLANS_H

#include "machine/machine.h"    /* loft_machine_config */

#ifndef LOFT_PORT_CURVES
#  define LOFT_PORT_CURVES 64
#endif
#ifndef LOFT_PORT_KNOTS
#  define LOFT_PORT_KNOTS 176
#endif

#ifndef LOFT_PORT_PATCHES
#  define LOFT_PORT_PATCHES (LOFT_AXES >= 3)
#endif
#ifndef LOFT_PORT_COLUMNS
#  define LOFT_PORT_COLUMNS 64
#endif
#if LOFT_PORT_PATCHES
#  include "toolpath/patches.h"
#endif

static void loft_port_plans(loft_machine_config *config)
{
    static loft_planner planner;
    static loft_move moves[LOFT_PORT_CURVES];
    static loft_knot knots[LOFT_PORT_KNOTS];
    static uint16_t passed[CELLS + LOFT_PLANNER_AHEAD];

    config->planner = &planner;
    config->plan = (loft_planner_memory){ .moves = moves,
                                          .knots = knots,
                                          .passed = passed,
                                          .move_room = LOFT_PORT_CURVES,
                                          .knot_room = LOFT_PORT_KNOTS };
#if LOFT_PORT_PATCHES
    static loft_patches patches;
    static loft_tip row[LOFT_PORT_COLUMNS + 1];

    config->plan.patches = loft_patches_init(&patches, row, LOFT_PORT_COLUMNS);
#endif
}

#endif
