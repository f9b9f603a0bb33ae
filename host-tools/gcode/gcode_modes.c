/* host-tools/gcode/gcode_modes.c -- M70 to M72: the modes are saved and brought back
 * SPDX-License-Identifier: MIT
 *
 * As in LinuxCNC the kind of motion (G0, G1 ..) is not among them, and the machine does not move.
 */
#include <math.h>
#include <string.h>

#include "gcode/gcode_state.h"

static void save_modes(gcode_program *g)
{
    g->saved = (gcode_modes){ .valid = true,
                              .unit = g->frame.unit,
                              .feed = g->feed,
                              .speed = g->speed,
                              .within = g->within,
                              .timed = g->timed,
                              .incremental = g->incremental,
                              .centre_absolute = g->centre_absolute,
                              .exact = g->exact,
                              .retract_to_r = g->retract_to_r,
                              .shifted = g->shifted,
                              .feed_mode = g->feed_mode,
                              .plane = g->plane,
                              .system = g->system,
                              .spindle = g->spindle,
                              .coolant = g->coolant };
    memcpy(g->saved.tool, g->tool, sizeof g->tool);
}

/* Outputs that are switched differently now. */
static int switch_back(gcode_program *g, const gcode_modes *to)
{
    gcode_event spindle = { .kind = GCODE_SPINDLE, .way = to->spindle, .speed = NAN },
                coolant = { .kind = GCODE_COOLANT, .way = to->coolant };
    const bool spins = to->spindle != g->spindle ||
                       (to->spindle != 0 && fabs(to->speed - g->speed) > 0);
    const bool cools = to->coolant != g->coolant;
    int code = 0;

    g->spindle = to->spindle;
    g->coolant = to->coolant;
    g->speed = to->speed;
    g->timed = to->timed;
    if (to->timed)
        spindle.speed = to->speed;
    if (spins)
        code = gcode_give(g, &spindle, 0);
    return code == 0 && cools ? gcode_give(g, &coolant, 0) : code;
}

static int bring_back(gcode_program *g)
{
    const gcode_modes *to = &g->saved;

    (void)gcode_use_units(g, to->unit);
    g->feed_mode = to->feed_mode;
    g->feed = to->feed;
    g->fed  = to->feed > 0;
    g->plane = to->plane;
    g->incremental = to->incremental;
    g->centre_absolute = to->centre_absolute;
    g->retract_to_r = to->retract_to_r;
    g->exact = to->exact;
    g->within = to->within;
    memcpy(g->tool, to->tool, sizeof g->tool);
    (void)gcode_use_shift(g, to->shifted);
    (void)gcode_use_system(g, to->system);
    return switch_back(g, to);
}

int gcode_modes_word(gcode_program *g, int m)
{
    if (m < 70 || m > 72)
        return 0;
    if (g->radius.side != 0)
        return gcode_fails(g, "gcode.modes-compensated", "M70 to M72 in G41 or G42",
                           "give G40 before");
    if (m == 70)
        save_modes(g);
    else if (m == 71)
        g->saved.valid = false;
    else if (!g->saved.valid)
        return gcode_fails(g, "gcode.modes-not-saved", "M72 without M70",
                           "save the modes by M70 before");
    else
        return bring_back(g);
    return 0;
}
