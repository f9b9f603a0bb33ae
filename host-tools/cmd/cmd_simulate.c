/* host-tools/cmd/cmd_simulate.c -- loft simulate: the machine as a program, on a pseudo terminal
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host/host.h"          /* loft_host_simulate_q16x3 */
#include "read/machine_file.h"  /* machine_option */
#include "base/tool.h"

/* Take one number for all axes, or one for each. */
static int spread(const char *option, const tool_list *list, double out[LOFT_AXES])
{
    if (list->count == 0)
        return 0;
    if (list->count != 1 && list->count != LOFT_AXES)
        return tool_error(EX_USAGE, "--%s: give one number, or %d with commas between", option,
                          LOFT_AXES);
    for (size_t i = 0; i < LOFT_AXES; i++)
        out[i] = list->value[list->count == 1 ? 0 : i];
    return 0;
}

static void tool_of(const void *k, const double motors[LOFT_AXES], double out[LOFT_AXES])
{
    if (!kinematics_tool(k, motors, out))
        memcpy(out, motors, LOFT_AXES * sizeof *out);
}

/* The numbers of the file are the defaults of the options. */
static int take_file(struct loft_host_options *o, kinematics *k, char text[KINEMATICS_TEXT],
                     int argc, char **argv)
{
    machine_file m = machine_usual();
    const int code = machine_option(&m, argc, argv);

    for (int i = 0; i < LOFT_AXES; i++) {
        o->steps_per_mm[i] = m.steps_per_mm[i];
        o->max_speed[i] = m.max_speed[i];
        o->max_accel[i] = m.max_accel[i];
        o->max_jerk[i] = m.max_jerk[i];
    }
    o->tick_hz = (unsigned)m.tick_hz;
    o->slots = (unsigned)m.slots;
    o->ramp = (unsigned)m.ramp;
    o->queue = (unsigned)m.queue;
    o->curves = (unsigned)m.curves;
    *k = m.k;
    kinematics_text(k, text);
    o->note = text;
    o->tool = k->kind == ENGINE_COREXY ? tool_of : NULL;
    o->kinematics = k;
    return code;
}

/* `x-=-5,y+=200`: there is something at -5 mm at the low end of x. `opens`: a switch may be wired
 * the other way, `x-=-5nc`. */
static int take_ends(const char *option, const char *text, bool opens,
                     struct loft_host_end ends[LOFT_AXES][2])
{
    static const char names[] = "xyzabc";

    for (const char *at = text; at && *at;) {
        const char *axis = strchr(names, at[0]);
        char *end = NULL;
        struct loft_host_end e = { 0, false };
        if (axis && axis - names < LOFT_AXES && (at[1] == '-' || at[1] == '+') && at[2] == '=')
            e.at = strtod(at + 3, &end);
        e.opens = opens && end && strncmp(end, "nc", 2) == 0;
        if (!end || end == at + 3 || !(fabs(e.at) < 32768) ||
            (end[e.opens ? 2 : 0] && end[e.opens ? 2 : 0] != ','))
            return tool_error(EX_USAGE, "--%s %s: give axis, end and mm of each, as x-=-5,x+=200%s",
                              option, text, opens ? ", or x-=-5nc if it opens there" : "");
        ends[axis - names][at[1] == '+'] = e;
        end += e.opens ? 2 : 0;
        at = *end ? end + 1 : end;
    }
    return 0;
}

/* `y=0.8`: y has two motors, and the second is 0.8 mm ahead. */
static int take_gantry(const char *text, struct loft_host_options *o)
{
    const char *axis = text ? strchr("xyz", text[0]) : NULL;
    char *end = NULL;

    if (text == NULL)
        return 0;
    if (text[0] && axis && text[1] == '=')
        o->skew = strtod(text + 2, &end);
    if (!end || end == text + 2 || *end || !(fabs(o->skew) <= 100))
        return tool_error(EX_USAGE, "--gantry %s: give an axis and mm, as y=0.8", text);
    o->gantry = (int)(axis - "xyz");
    return 0;
}

static int simulate(const struct loft_host_options *o, const engine *e)
{
    if (e == &engine_f32)
        return loft_host_simulate_f32x3(o);
    if (e == &engine_f64)
        return loft_host_simulate_f64x3(o);
    return loft_host_simulate_q16x3(o);
}

static int run_simulate(const tool_command *self, int argc, char **argv)
{
    struct loft_host_options o = loft_host_defaults();
    const engine *e            = &engine_q16;
    const char *speed          = o.fast ? "fast" : "real";
    tool_list steps = { .count = 0 }, fastest = { .count = 0 }, accel = { .count = 0 };
    const char *machine = NULL, *limits = NULL, *walls = NULL, *probe = NULL;
    const char *gantry = NULL;
    tool_list halt = { .count = 0 };
    kinematics k;
    char text[KINEMATICS_TEXT];
    int first;

    int code = take_file(&o, &k, text, argc, argv);
    if (code != 0)
        return code;
    const tool_option options[] = {
        TOOL_TEXT("machine", "FILE", &machine,
                  "a machine as text, see host-tools/MACHINE.md; the options below are stronger"),
        TOOL_TEXT("link", "PATH", &o.link, "make PATH a symbolic link to the pseudo terminal"),
        TOOL_TEXT("keep", "FILE", &o.kept,
                  "keep the settings in FILE, as an EEPROM does (while it runs)"),
        TOOL_TEXT("record", "FILE", &o.record, "write every pulse with its time to FILE (CSV)"),
        TOOL_TEXT("speed", "real|fast", &speed, "real time, or fast: as fast as it goes (fast)"),
        TOOL_LIST("halt", "TICK,..", &halt, 0, 4e9,
                  "time stops at these ticks of jobs, one after the other, each until kill -USR2 "
                  "(none)"),
        TOOL_COUNT("line-baud", "RATE", &o.line_baud, 0, 4000000,
                   "the line brings its bytes in simulated time; 0: at once (0)"),
        TOOL_SWITCH("once", &o.once, "end after one job"),
        TOOL_SWITCH("quiet", &o.quiet, "print only the name of the pseudo terminal, and errors"),
        TOOL_LIST("steps", "N,..", &steps, 0.01, 30000, "steps per mm, for all axes or each (80)"),
        TOOL_LIST("max-speed", "MM/S,..", &fastest, 1 / 64.0, 16383, "of the axes (500)"),
        TOOL_LIST("accel", "MM/S2,..", &accel, 1, 16383, "of the axes (2000)"),
        TOOL_COUNT("tick-hz", "HZ", &o.tick_hz, 50, 50000, "ticks per second (1000)"),
        TOOL_COUNT("slots", "N", &o.slots, 1, 4096, "chances to step per tick (40)"),
        TOOL_COUNT("ramp", "TICKS", &o.ramp, 1, 32767, "from full pace to a stop in a hold (100)"),
        TOOL_COUNT("curves", "N", &o.curves, 0, 4096,
                   "curves that fit its plan; 0: it does not plan (64)"),
        TOOL_COUNT("columns", "N", &o.columns, 0, 1024,
                   "curves of a line of a patch; 0: it takes no patches (64)"),
        TOOL_COUNT("queue", "N", &o.queue, 2, 32768, "items that fit the queue (256)"),
        TOOL_TEXT("limits", "x-=MM,..", &limits,
                  "limit switches: axis, - or + end, and mm from the start, where it closes; "
                  "x-=MMnc: it opens there (none)"),
        TOOL_SWITCH("shared", &o.shared,
                    "the switches of both ends of an axis share one input, as on an Uno"),
        TOOL_TEXT("gantry", "y=MM", &gantry,
                  "an axis with two motors, the second so far ahead; each has the switches of "
                  "--limits (none)"),
        TOOL_TEXT("walls", "x-=MM,..", &walls,
                  "where the table ends: steps that run into a wall are lost (none)"),
        TOOL_TEXT("probe", "z-=MM,..", &probe, "where the probe touches something (none)"),
        TOOL_NUMBER("bounce", "MS", &o.bounce_ms, 0, 100,
                    "how long the contacts of switches and probe bounce (0)"),
        TOOL_NUMBER("noise", "PPM", &o.noise, 0, 100000,
                    "flipped bits per million on the line (0)"),
        ENGINE_OPTION(&e, "number type of the machine (q16)"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc)
        return tool_error(EX_USAGE, "%s: simulate takes no file: see `loft simulate --help`",
                          argv[first]);
    if (o.curves > 0 && o.curves < 4)
        return tool_error(EX_USAGE, "a plan of %u curves: give 0 for none, or 4 to 4096", o.curves);
    if (strcmp(speed, "fast") != 0 && strcmp(speed, "real") != 0)
        return tool_error(EX_USAGE, "--speed %s: give real or fast", speed);
    if ((code = spread("steps", &steps, o.steps_per_mm)) != 0 ||
        (code = spread("max-speed", &fastest, o.max_speed)) != 0 ||
        (code = spread("accel", &accel, o.max_accel)) != 0 ||
        (code = take_ends("limits", limits, true, o.limit)) != 0 ||
        (code = take_gantry(gantry, &o)) != 0 ||
        (code = take_ends("walls", walls, false, o.wall)) != 0 ||
        (code = take_ends("probe", probe, false, o.probe)) != 0)
        return code;
    o.fast = strcmp(speed, "fast") == 0;
    if (!o.fast && (halt.count > 0 || o.line_baud > 0))
        return tool_error(EX_USAGE,
                          "--halt and --line-baud are of simulated time: give --speed fast");
    if (halt.count > LOFT_HOST_HALTS)
        return tool_error(EX_USAGE, "--halt: give at most %d ticks", LOFT_HOST_HALTS);
    o.halts = (unsigned)halt.count;
    for (size_t i = 0; i < halt.count; i++)
        o.halt[i] = halt.value[i];
    return simulate(&o, e);
}

const tool_command command_simulate = { "simulate", "[--link PATH] [--record FILE]",
                                        "the machine as a program, behind a pseudo terminal",
                                        "Prints the name of the pseudo terminal; give it, or PATH, "
                                        "to `loft stream --port`. What runs is the code of the\n"
                                        "firmware, in any number type. Ends with ^C, which stops "
                                        "the machine on the path, or with --once after one job.\n"
                                        "kill -USR1 presses its emergency stop, and the next one "
                                        "frees it. Where --halt stops the time of a machine\n"
                                        "with a sender it still talks: it prints `job ID halted at "
                                        "tick N`, a hold or an abort shows at once, and kill\n"
                                        "-USR2 lets time go on.\n",
                                        run_simulate };
