/* host-tools/gcode/gcode_left.c -- words that this machine has no use for: reported at the end
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/host.h"       /* host_warn */
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

/* Why it is left out. */
typedef struct {
    const char *name, *what, *remedy;
} reason;

static reason reason_of(char letter, int code)
{
    const int m = code / 10;

    if (letter == 'E')
        return (reason){ "gcode.left-extruder", "there is no extruder", "its words are left out" };
    if (letter == '$')
        return (reason){ "gcode.left-command", "commands of a controller are left out",
                         "give them to it yourself" };
    if (letter == 'M' && m >= 3 && m <= 5)
        return (reason){ "gcode.left-spindle", "no spindle or laser follows it yet",
                         "switch it by hand" };
    if (letter == 'M' && m >= 7 && m <= 9)
        return (reason){ "gcode.left-coolant", "there is no coolant", "it is left out" };
    return (reason){ "gcode.left-word", "has no meaning for this machine", "it is left out" };
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
        const reason why = reason_of(g->left[i].letter, g->left[i].code);
        host_warn(g->b.host, why.name, (host_place){ g->file, g->left[i].line }, why.remedy,
                  "%s%s: %s", word, times, why.what);
    }
    g->lefts = 0;
}
