/* host-tools/gcode/gcode_tool.c -- tools of G-code: T, M6, M61, and what the machine file says
 * SPDX-License-Identifier: MIT
 *
 * Tool 3 is the one whose lines in the machine file begin with `tool.3.`.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/gcode_state.h"
#include "read/machine_tools.h"

#define NUMBER_MOST 1000000000.0

/* The number behind a letter: the tool's. */
static int read_number(const gcode_program *g, char letter, long *out)
{
    const double said = gcode_value(&g->b, letter);
    char what[48];

    if (said >= 0 && said <= NUMBER_MOST && !(said > floor(said))) {
        *out = (long)said;
        return 0;
    }
    snprintf(what, sizeof what, "%c%.10g: no such tool", letter, said);
    return gcode_fails(g, "gcode.tool-number", what, "give a whole number");
}

static const machine_tool *tool_of(const gcode_program *g, long number)
{
    char name[24];

    snprintf(name, sizeof name, "%ld", number);
    return g->tools != NULL ? machine_tools_find(g->tools, name) : NULL;
}

/* The tool that a letter names: 0, and a line without the letter, is the one in the spindle. */
static int named_tool(const gcode_program *g, char letter, const char *key,
                      const machine_tool **out)
{
    long number = g->loaded;
    char what[64], remedy[96];
    int code = 0;

    if (gcode_has(&g->b, letter))
        code = read_number(g, letter, &number);
    number = number == 0 ? g->loaded : number;
    if (code != 0)
        return code;
    if (number <= 0 && gcode_has(&g->b, letter))
        return 0; /* D0, H0 and no tool: as if it were a point */
    if (number <= 0)
        return gcode_fails(g, "gcode.tool-none", "no tool is in the spindle",
                           letter == 'D' ? "give D with its number, or T and M6 before"
                                         : "give H with its number, or T and M6 before");
    *out = tool_of(g, number);
    if (*out != NULL && !(letter == 'D' ? (*out)->diameter <= 0 : isnan((*out)->length)))
        return 0;
    snprintf(what, sizeof what, "tool %ld has no %s", number, key);
    snprintf(remedy, sizeof remedy, "give tool.%ld.%s in the machine file, or %s", number, key,
             letter == 'D' ? "G41.1 D with the diameter" : "G43.1 Z with the length");
    return gcode_fails(g, "gcode.tool-no-value", what, remedy);
}

int gcode_tool_length(const gcode_program *g, double *out)
{
    const machine_tool *tool = NULL;
    const int code           = named_tool(g, 'H', "length", &tool);

    if (code == 0)
        *out = tool != NULL ? tool->length : 0;
    return code;
}

int gcode_tool_side(gcode_program *g, int code)
{
    const int side           = code == 410 || code == 411 ? 1 : -1;
    const machine_tool *tool = NULL;

    if (code == 410 || code == 420) {
        const int status = named_tool(g, 'D', "diameter", &tool);
        return status != 0 ? status : gcode_radius_on(g, side, tool != NULL ? tool->diameter : 0);
    }
    if (!gcode_has(&g->b, 'D') || gcode_value(&g->b, 'D') < 0)
        return gcode_fails(g, "gcode.compensation-no-diameter", "G41.1 and G42.1 want the diameter",
                           "give D of 0 or more");
    if (gcode_has(&g->b, 'L') && fabs(gcode_value(&g->b, 'L')) > 0)
        return gcode_fails(g, "gcode.lathe-tool", "L: lathe tools are not supported",
                           "leave it out");
    return gcode_radius_on(g, side, gcode_value(&g->b, 'D') * g->frame.unit);
}

int gcode_tool_select(gcode_program *g)
{
    return gcode_has(&g->b, 'T') && !g->printer ? read_number(g, 'T', &g->selected) : 0;
}

/* M6: the tool that T named; M61 Q: this one is in already. */
int gcode_tool_change(gcode_program *g, int m)
{
    gcode_event e = { .kind = GCODE_TOOL };

    if (g->radius.side != 0)
        return gcode_fails(g, "gcode.compensation-tool-change",
                           "a change of the tool in G41 or G42", "give G40 before");
    if (m == 61 && !gcode_has(&g->b, 'Q'))
        return gcode_fails(g, "gcode.tool-loaded-number", "M61 without Q",
                           "give the number of the tool");
    if (m == 61)
        return read_number(g, 'Q', &g->loaded);
    if (g->selected < 0)
        return gcode_simple(g, GCODE_STOP);
    g->loaded = e.tool = g->selected;
    return gcode_give(g, &e, 0);
}
