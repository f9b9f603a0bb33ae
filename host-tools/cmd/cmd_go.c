/* host-tools/cmd/cmd_go.c -- loft go, park, pen: straight moves to a place
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"           /* scan_number */
#include "base/tool.h"
#include "send/mover.h"

#define FEED "mm/s, or as 1200mm/min (100)"

/* `10,20`, `,,5`: an axis without a number stays. */
static int take_place(const char *text, double to[ENGINE_AXES])
{
    const char *s = text;

    to[0] = to[1] = to[2] = NAN;
    for (int i = 0; i < ENGINE_AXES; i++) {
        if (*s != ',' && *s != '\0' && (!scan_number(&s, &to[i]) || !(fabs(to[i]) <= 16383)))
            break;
        if (*s == '\0' && s != text)
            return 0;
        if (*s++ != ',')
            break;
    }
    return tool_error(EX_USAGE, "%s: give a place in mm as X,Y or X,Y,Z: ,,5 moves z alone", text);
}

/* A place that begins with a minus is no option; it comes first. */
static const char *negative_place(int *argc, char ***argv)
{
    char **at = *argv;

    if (*argc < 2 || at[1][0] != '-' || at[1][1] == '\0' || !strchr("0123456789.", at[1][1]))
        return NULL;
    const char *place = at[1];
    at[1] = at[0];
    (*argc)--;
    (*argv)++;
    return place;
}

static int run_go(const tool_command *self, int argc, char **argv)
{
    const char *place = negative_place(&argc, &argv);
    double to[ENGINE_AXES];
    bool by = false;
    mover v;
    int first, code = mover_start(&v, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = { MOVER_OPTIONS(v),
        TOOL_SPEED("feed", &v.p.travel, 0.016, 1000, FEED),
        TOOL_SWITCH("by", &by, "by so much from where the tool is"),
                                    TOOL_OPTIONS_END };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if ((place == NULL) != (first + 1 == argc))
        return tool_error(EX_USAGE, "name one place, as 10,20: see `loft go --help`");
    code = take_place(place ? place : argv[first], to);
    if (code == 0)
        code = mover_open(&v);
    for (int i = 0; i < ENGINE_AXES; i++)
        to[i] = isnan(to[i]) ? v.at[i] : to[i] + (by ? v.at[i] : 0);
    if (code == 0)
        code = mover_told(&v, mover_to(&v, to, v.p.travel));
    mover_close(&v);
    return code;
}

const tool_command command_go = {
    "go", "X,Y[,Z] --port PORT", "move the tool straight to a place",
    "Places are in mm, as of the drawing; an axis without a number stays: ,,5 moves z alone. A\n"
    "place that begins with a minus comes first: loft go -5,3 --port PORT. Nothing lifts the pen:\n"
    "see `loft pen up`. A place beyond the table of the machine file is refused, and so is a move\n"
    "that does not lead away from a closed limit switch.\n",
    run_go
};


// Pen and park
// ------------

static int lift_pen(mover *v, double z)
{
    const double to[ENGINE_AXES] = { v->at[0], v->at[1], z };

    return mover_to(v, to, v->p.travel);
}

/* Read the options of a command that moves z or parks: argv[*first] is what follows them. */
static int begin(const tool_command *self, int argc, char **argv, mover *v, int *first)
{
    const int code              = mover_start(v, argc, argv);
    const tool_option options[] = { MOVER_OPTIONS(*v),
                                    TOOL_SPEED("feed", &v->p.travel, 0.016, 1000, FEED),
                                    TOOL_OPTIONS_END };

    return code ? code : tool_options(self, options, argc, argv, first);
}

static int run_pen(const tool_command *self, int argc, char **argv)
{
    mover v;
    int first, code = begin(self, argc, argv, &v, &first);

    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    const bool up = first + 1 == argc && strcmp(argv[first], "up") == 0;
    if (!up && (first + 1 != argc || strcmp(argv[first], "down") != 0))
        return tool_error(EX_USAGE, "give up or down: see `loft pen --help`");
    code = mover_open(&v);
    if (code == 0)
        code = mover_told(&v, lift_pen(&v, up ? v.p.machine.pen_up : v.p.machine.pen_down));
    mover_close(&v);
    return code;
}

const tool_command command_pen = {
    "pen", "up|down --port PORT", "lift the pen, or put it down",
    "It moves z to pen_up or pen_down of the machine file: 1 and 0 mm without one.\n", run_pen
};

static int park(mover *v)
{
    const machine_file *m        = &v->p.machine;
    const double to[ENGINE_AXES] = { m->park[0], m->park[1], fmax(v->at[2], m->pen_up) };
    const int code               = lift_pen(v, to[2]);

    return code ? code : mover_to(v, to, v->p.travel);
}

static int run_park(const tool_command *self, int argc, char **argv)
{
    mover v;
    int first, code = begin(self, argc, argv, &v, &first);

    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc)
        return tool_error(EX_USAGE,
                          "%s: park takes no place: give x.park and y.park in the machine "
                          "file",
                          argv[first]);
    code = mover_open(&v);
    if (code == 0)
        code = mover_told(&v, park(&v));
    mover_close(&v);
    return code;
}

const tool_command command_park = {
    "park", "--port PORT", "lift the pen and go to the place for resting",
    "First z goes up to pen_up, if it is below; then x and y go to x.park and y.park of the\n"
    "machine file: 0,0 without one.\n",
    run_park
};
