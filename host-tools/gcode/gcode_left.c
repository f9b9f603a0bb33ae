/* host-tools/gcode/gcode_left.c -- words that this machine has no use for: told once, at the end
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/tool.h"       /* tool_error */
#include "gcode/gcode_state.h"

static void leave_out(gcode_program *g, char letter, int code, const char *name)
{
    for (unsigned i = 0; i < g->lefts; i++)
        if (g->left[i].letter == letter && g->left[i].code == code &&
            strcmp(g->left[i].name, name) == 0) {
            g->left[i].count++;
            return;
        }
    if (g->lefts < sizeof g->left / sizeof g->left[0]) {
        g->left[g->lefts].letter  = letter;
        g->left[g->lefts].code    = code;
        g->left[g->lefts].line    = g->main_line;
        snprintf(g->left[g->lefts].name, sizeof g->left[0].name, "%s", name);
        g->left[g->lefts++].count = 1;
    }
}

void gcode_leave_out(gcode_program *g, char letter, int code) { leave_out(g, letter, code, ""); }

void gcode_leave_name(gcode_program *g, const char *name) { leave_out(g, ' ', 0, name); }

static const char *reason_of(char letter, int code)
{
    const int m = code / 10;

    if (letter == 'E')
        return "there is no extruder: its words are left out";
    if (letter == '$')
        return "commands of a controller are left out: give them to it yourself";
    if (letter == 'M' && m >= 3 && m <= 5)
        return "no spindle or laser follows it yet: switch it by hand";
    if (letter == 'M' && m >= 7 && m <= 9)
        return "there is no coolant: it is left out";
    return "has no meaning for this machine: it is left out";
}

void gcode_tell_left(gcode_program *g)
{
    for (unsigned i = 0; i < g->lefts; i++) {
        char word[32] = "", times[32] = "";
        if (g->left[i].letter == ' ')
            snprintf(word, sizeof word, "%s", g->left[i].name);
        else if (g->left[i].letter == '$' || g->left[i].letter == 'E')
            snprintf(word, sizeof word, "%c", g->left[i].letter);
        else
            snprintf(word, sizeof word, "%c%g", g->left[i].letter, g->left[i].code / 10.0);
        if (g->left[i].count > 1)
            snprintf(times, sizeof times, " (%u times)", g->left[i].count);
        (void)tool_error(EX_OK, "%s:%u: %s%s: %s", g->file, g->left[i].line, word, times,
                         reason_of(g->left[i].letter, g->left[i].code));
    }
    g->lefts = 0;
}
