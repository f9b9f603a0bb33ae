/* host-tools/gcode/gcode_offset.c -- coordinate systems, home, units and tool lengths of G-code
 * SPDX-License-Identifier: MIT
 *
 * machine = origin of the system + rotation (program + G92's shift) + tool, as in LinuxCNC. After a
 * change the program's coordinates of the place where the machine stands are computed anew.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/gcode_state.h"

#define HOME   5161
#define HOME_2 5181
#define SHIFT  5210             /* 1 if it is in force, then its numbers */
#define SYSTEM 5220             /* its number; those of system n begin at 5201 + 20 n */
#define RADIANS (3.14159265358979323846 / 180)

static double *system_of(gcode_program *g, int system)
{
    return &g->all.number[5201 + 20 * system];
}

/* A place of the program in the machine's coordinates, in units of the program. */
void gcode_machine_place(const gcode_program *g, const double at[3], double out[3])
{
    gcode_place(&g->frame, at, out);
    for (int i = 0; i < 3; i++)
        out[i] /= g->frame.unit;
}

/* From the machine's coordinates to those of the program, in its units. */
void gcode_program_place(const gcode_program *g, const double machine[3], double out[3])
{
    const gcode_frame *f = &g->frame;
    const double x = machine[0] - f->origin[0], y = machine[1] - f->origin[1],
                 c = cos(f->degrees * RADIANS), s = sin(f->degrees * RADIANS);

    out[0] = (fabs(f->degrees) > 0 ? c * x + s * y : x) - f->shift[0];
    out[1] = (fabs(f->degrees) > 0 ? c * y - s * x : y) - f->shift[1];
    out[2] = machine[2] - f->origin[2] - f->shift[2];
}

void gcode_use_offsets(gcode_program *g)
{
    const double *system = system_of(g, g->system);

    for (int i = 0; i < 3; i++) {
        g->frame.origin[i] = (system[i] + g->tool[i]) / g->frame.unit;
        g->frame.shift[i]  = g->shifted ? g->all.number[SHIFT + 1 + i] / g->frame.unit : 0;
    }
    g->frame.degrees = system[9];
}

/* Use changed offsets; the machine stays where it is. */
static void stay(gcode_program *g)
{
    double machine[3], place[3];

    gcode_machine_place(g, g->at, machine);
    gcode_machine_place(g, g->place, place);
    gcode_use_offsets(g);
    gcode_program_place(g, machine, g->at);
    gcode_program_place(g, place, g->place);
}

int gcode_use_units(gcode_program *g, double unit)
{
    const double by = g->frame.unit / unit;

    for (int i = 0; i < 3; i++) {
        g->at[i] *= by;
        g->place[i] *= by;
    }
    g->feed *= g->feed_mode == 930 ? 1 : by;
    g->cycle.r *= by;
    g->cycle.z *= by;
    g->cycle.q *= by;
    g->cycle.initial *= by;
    for (int i = 0; i < 3; i++)
        g->cycle.aside[i] *= by;
    g->frame.unit = unit;
    gcode_use_offsets(g);
    return 0;
}

int gcode_use_shift(gcode_program *g, bool shifted)
{
    g->shifted = shifted;
    g->all.number[SHIFT] = shifted;
    stay(g);
    return 0;
}

int gcode_use_system(gcode_program *g, int system)
{
    g->system = system;
    g->all.number[SYSTEM] = system;
    stay(g);
    return 0;
}

/* G43 takes the length of a tool, G43.2 adds one, G43.1 takes the line's offset, G49 none. */
int gcode_use_tool(gcode_program *g, int code)
{
    double length    = 0;
    const int status = code == 430 || code == 432 ? gcode_tool_length(g, &length) : 0;

    if (status != 0)
        return status;
    if (code == 430)
        g->tool[0] = g->tool[1] = g->tool[2] = 0;
    g->tool[2] += length;
    for (int i = 0; i < 3; i++)
        if (code == 490)
            g->tool[i] = 0;
        else if (code == 431 && gcode_has(&g->b, (char)('X' + i)))
            g->tool[i] = gcode_value(&g->b, (char)('X' + i)) * g->frame.unit;
    if (code == 431)
        g->b.has &= ~(GCODE_BIT('X') | GCODE_BIT('Y') | GCODE_BIT('Z'));
    stay(g);
    return 0;
}

/* The program's numbers of an axis count from this place, wherever that is. */
static void tie_axis(gcode_program *g, int axis)
{
    g->tied = (unsigned char)((g->tied & ~(1 << axis)) | (g->loose & 1 << axis));
}

/* The coordinates of a place of the machine in a system, with the shift. */
static void place_in_system(const gcode_program *g, const double system[], const double machine[3],
                            double out[3])
{
    const double c = cos(system[9] * RADIANS), s = sin(system[9] * RADIANS);
    double away[3];

    for (int i = 0; i < 3; i++)
        away[i] = machine[i] - (system[i] + g->tool[i]) / g->frame.unit;
    out[0] = c * away[0] + s * away[1];
    out[1] = c * away[1] - s * away[0];
    out[2] = away[2];
}

/* G10 L2 sets the origin of a system, L20 so that the machine stands at the given numbers. */
static int set_system(gcode_program *g)
{
    const gcode_block *b = &g->b;
    const double l = gcode_has(b, 'L') ? gcode_value(b, 'L') : 0,
                 p = gcode_has(b, 'P') ? gcode_value(b, 'P') : 0;
    double machine[3];

    if (!(l >= 2 && l <= 2) && !(l >= 20 && l <= 20))
        return gcode_fails(g, "gcode.system-set", "G10 without L2 or L20",
                           "only origins of coordinate systems are set");
    if (!gcode_has(b, 'P') || !(p >= 0 && p <= GCODE_SYSTEMS) || p > floor(p))
        return gcode_fails(g, "gcode.system-unknown", "G10: no such coordinate system",
                           "give P1 to P9, or P0 for this one");
    double *system = system_of(g, p > 0 ? (int)p : g->system);
    gcode_machine_place(g, g->at, machine);
    if (l < 3 && gcode_has(b, 'R'))
        system[9] = gcode_value(b, 'R');
    const double c = cos(system[9] * RADIANS), s = sin(system[9] * RADIANS);
    double want[3];
    place_in_system(g, system, machine, want);
    for (int i = 0; i < 3; i++)
        want[i] = gcode_has(b, (char)('X' + i))
                      ? gcode_value(b, (char)('X' + i)) + g->frame.shift[i]
                      : want[i];
    const double turned[3] = { c * want[0] - s * want[1], s * want[0] + c * want[1], want[2] };
    for (int i = 0; i < 3; i++)
        if (gcode_has(b, (char)('X' + i)) && l > 3)
            tie_axis(g, i);
    const bool turns = l > 3 && s * s > 0 && (gcode_has(b, 'X') || gcode_has(b, 'Y'));
    for (int i = 0; i < 3; i++)         /* where axes are turned, one number moves both origins */
        if (gcode_has(b, (char)('X' + i)) || (turns && i < 2))
            system[i] = l < 3 ? gcode_value(b, (char)('X' + i)) * g->frame.unit
                              : (machine[i] - turned[i]) * g->frame.unit - g->tool[i];
    stay(g);
    return 0;
}

/* G92: the machine stands at the given numbers from now on. G52 (`local`): they are the shift. */
static int set_shift(gcode_program *g, bool local)
{
    double *held = &g->all.number[SHIFT + 1];
    bool any     = false;

    for (int i = 0; i < 3; i++) {
        held[i] = g->frame.shift[i] * g->frame.unit;
        if (!gcode_has(&g->b, (char)('X' + i)))
            continue;
        const double said = gcode_value(&g->b, (char)('X' + i)),
                     place = g->at[i] + g->frame.shift[i], shift = local ? said : place - said;
        held[i]  = shift * g->frame.unit;
        if (!local)
            tie_axis(g, i);
        const double to = local ? place - said : said;
        g->place[i] += to - g->at[i];
        g->at[i] = to;
        any = true;
    }
    if (!any && !g->printer)
        return gcode_fails(g, "gcode.shift-no-axis", "G92 without X, Y or Z",
                           "give the coordinates of this place");
    g->shifted = true;
    g->all.number[SHIFT] = 1;
    gcode_use_offsets(g);
    return 0;
}

/* G92.1 forgets the shift, G92.2 keeps it for G92.3. */
static int switch_shift(gcode_program *g, int code)
{
    g->tied = code == 923 ? g->tied : 0;
    for (int i = 1; i <= 3 && code == 921; i++)
        g->all.number[SHIFT + i] = 0;
    return gcode_use_shift(g, code == 923);
}

/* G28.1, G30.1: this is the place to which G28 or G30 leads. */
static int store_home(gcode_program *g, double stored[3])
{
    double machine[3];

    gcode_machine_place(g, g->at, machine);
    for (int i = 0; i < 3; i++)
        stored[i] = machine[i] * g->frame.unit;
    return 0;
}

/* G28, G30: over the given place, if there is one, to the stored place of the machine; with axes
 * given only these. */
static int go_home(gcode_program *g, const double stored[3])
{
    double over[3], home[3], machine[3], to[3];
    bool any = false;

    for (int i = 0; i < 3; i++)
        any = any || gcode_has(&g->b, (char)('X' + i));
    gcode_target(g, over);
    for (int i = 0; i < 3; i++)
        machine[i] = stored[i] / g->frame.unit;
    if (!g->printer) {
        const int code = gcode_go(g, GCODE_RAPID, over);
        if (code != 0)
            return code;
    }
    gcode_program_place(g, machine, home);
    g->homing = true;
    g->homed  = g->loose;
    for (int i = 0; i < 3; i++) {
        const bool goes = !any || gcode_has(&g->b, (char)('X' + i));
        to[i] = goes ? home[i] : g->at[i];
        if (goes)
            g->homed &= (unsigned char)~(1 << i);
    }
    const int code = gcode_go(g, GCODE_RAPID, to);
    g->homing = false;
    return code;
}

int gcode_nonmodal(gcode_program *g, int code)
{
    switch (code) {
    case 100: return g->printer ? 0 : set_system(g);
    case 280: return go_home(g, &g->all.number[HOME]);
    case 300: return go_home(g, &g->all.number[HOME_2]);
    case 281: return store_home(g, &g->all.number[HOME]);
    case 301: return store_home(g, &g->all.number[HOME_2]);
    case 920: return set_shift(g, false);
    case 520: return set_shift(g, true);
    default:  return switch_shift(g, code);
    }
}
