/* host-tools/gcode/gcode_named.c -- parameters of G-code that tell how the program stands
 * SPDX-License-Identifier: MIT
 *
 * LinuxCNC's documentation: G-code, predefined named parameters; #5400 and #5420 to #5428.
 */
#include <math.h>
#include <string.h>

#include "gcode/gcode_number.h"
#include "gcode/gcode_state.h"
#include "read/machine_tools.h"

#define PLACE 5420
#define TOOL  5400

enum named {
    X,
    Y,
    Z,
    OTHERS,             /* axes that the machine has not */
    VALUE,
    RETURNED,
    LEVEL,
    LINE,
    METRIC,
    IMPERIAL,
    ABSOLUTE,
    INCREMENTAL,
    FEED,
    RPM,
    PLANE,
    MOTION,
    SYSTEM,
    LOADED,
    SELECTED,
    SPINDLE,
    CLOCKWISE,
    FLOOD,
    PER_MINUTE,
    PER_TURN,
    INVERSE,
    RETRACT_OLD,
    RETRACT_R,
    CENTRES,
    SIDE,
    LENGTH,
    ZERO,               /* what this machine never has, or nobody asks here */
    ONE,
    VERSION
};

static const struct {
    const char *name;
    enum named is;
} names[] = { { "_X", X },
              { "_Y", Y },
              { "_Z", Z },
              { "_A", OTHERS },
              { "_B", OTHERS },
              { "_C", OTHERS },
              { "_U", OTHERS },
              { "_V", OTHERS },
              { "_W", OTHERS },
              { "_VALUE", VALUE },
              { "_VALUE_RETURNED", RETURNED },
              { "_CALL_LEVEL", LEVEL },
              { "_LINE", LINE },
              { "_METRIC", METRIC },
              { "_IMPERIAL", IMPERIAL },
              { "_ABSOLUTE", ABSOLUTE },
              { "_INCREMENTAL", INCREMENTAL },
              { "_FEED", FEED },
              { "_RPM", RPM },
              { "_PLANE", PLANE },
              { "_MOTION_MODE", MOTION },
              { "_COORD_SYSTEM", SYSTEM },
              { "_CURRENT_TOOL", LOADED },
              { "_CURRENT_POCKET", LOADED },
              { "_SELECTED_TOOL", SELECTED },
              { "_SELECTED_POCKET", SELECTED },
              { "_SPINDLE_ON", SPINDLE },
              { "_SPINDLE_CW", CLOCKWISE },
              { "_FLOOD", FLOOD },
              { "_MIST", ZERO },
              { "_UNITS_PER_MINUTE", PER_MINUTE },
              { "_UNITS_PER_REV", PER_TURN },
              { "_INVERSE_TIME", INVERSE },
              { "_RETRACT_OLD_Z", RETRACT_OLD },
              { "_RETRACT_R_PLANE", RETRACT_R },
              { "_IJK_ABSOLUTE_MODE", CENTRES },
              { "_CCOMP", SIDE },
              { "_TOOL_OFFSET", LENGTH },
              { "_LATHE_DIAMETER_MODE", ZERO },
              { "_LATHE_RADIUS_MODE", ONE },
              { "_SPINDLE_RPM_MODE", ONE },
              { "_SPINDLE_CSS_MODE", ZERO },
              { "_SPEED_OVERRIDE", ONE },
              { "_FEED_OVERRIDE", ONE },
              { "_ADAPTIVE_FEED", ZERO },
              { "_FEED_HOLD", ONE },
              { "_REMAP_LEVEL", ZERO },
              { "_TASK", ZERO },
              { "_VMAJOR", VERSION },
              { "_VMINOR", ZERO } };

static double value_of(const gcode_program *g, enum named is)
{
    switch (is) {
    case X:
    case Y:
    case Z:           return g->at[is - X];
    case VALUE:       return g->all.value;
    case RETURNED:    return g->all.returned;
    case LEVEL:       return g->all.depth;
    case LINE:        return g->b.line;
    case METRIC:      return g->frame.unit < 2;
    case IMPERIAL:    return g->frame.unit > 2;
    case ABSOLUTE:    return !g->incremental;
    case INCREMENTAL: return g->incremental;
    case FEED:        return g->feed;
    case RPM:         return g->speed;
    case PLANE:       return 190 - 10 * g->plane;
    case MOTION:      return g->motion == GCODE_CANCEL ? 800 : g->motion;
    case SYSTEM:      return g->system < 7 ? 530 + 10 * g->system : 584 + g->system;
    case LOADED:      return g->loaded > 0 ? (double)g->loaded : 0;
    case SELECTED:    return (double)g->selected;
    case SPINDLE:     return g->spindle != 0;
    case CLOCKWISE:   return g->spindle == 3;
    case FLOOD:       return g->coolant;
    case PER_MINUTE:  return g->feed_mode == 940;
    case PER_TURN:    return g->feed_mode == 950;
    case INVERSE:     return g->feed_mode == 930;
    case RETRACT_OLD: return !g->retract_to_r;
    case RETRACT_R:   return g->retract_to_r;
    case CENTRES:     return g->centre_absolute;
    case SIDE:        return g->radius.side == 0 ? 400 : g->radius.side > 0 ? 410 : 420;
    case LENGTH:      return fabs(g->tool[0]) + fabs(g->tool[1]) + fabs(g->tool[2]) > 0;
    case OTHERS:
    case ZERO:        break;
    case ONE:         return 1;
    case VERSION:     return 2.9;
    }
    return 0;
}

bool gcode_live_name(const gcode_program *g, const char *name, double *out)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(names[i].name, name) == 0) {
            *out = value_of(g, names[i].is);
            return true;
        }
    return false;
}

double gcode_live_number(const gcode_program *g, int number)
{
    if (number >= PLACE && number < PLACE + 3)
        return g->at[number - PLACE];
    if (number == TOOL)
        return g->loaded > 0 ? (double)g->loaded : 0;
    if (number > TOOL && number <= TOOL + 3)
        return g->tool[number - TOOL - 1] / g->frame.unit;
    return g->all.number[number];
}
