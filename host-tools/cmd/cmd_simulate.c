/* host-tools/cmd/cmd_simulate.c -- loft simulate: the machine as a program, on a pseudo terminal
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "host/host.h"          /* loft_host_simulate_q16x3 */
#include "read/machine_file.h"  /* machine_read */

static void tool_of(const void *k, const double motors[LOFT_AXES], double out[LOFT_AXES])
{
    if (!kinematics_tool(k, motors, out))
        memcpy(out, motors, LOFT_AXES * sizeof *out);
}

/* `x-=-5,y+=200`: there is something at -5 mm at the low end of x. `opens`: a switch may be wired
 * the other way, `x-=-5nc`. */
static int take_ends(const char *name, const char *text, bool opens,
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
                              name, text, opens ? ", or x-=-5nc if it opens there" : "");
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

#define FROM_FILE 4294967295.0      /* not given: the number of the machine */

typedef struct {
    const char *machine, *link, *kept, *record, *limits, *gantry, *walls, *probe;
    int speed;                  /* of real|fast */
    option_list halt, steps, fastest, accel;
    unsigned line_baud, tick_hz, slots, ramp, curves, columns, queue;
    bool once, quiet, shared;
    double bounce, noise;
    const engine *e;
} simulate_options;

static const option simulate_rows[] = {
    { "machine", OPTION_FILE(simulate_options, machine), .value = "FILE",
      .help = "a machine as text, see host-tools/MACHINE.md; the options below are stronger" },
    { "link", OPTION_FILE(simulate_options, link), .value = "PATH",
      .help = "make PATH a symbolic link to the pseudo terminal" },
    { "keep", OPTION_FILE(simulate_options, kept), .value = "FILE",
      .help = "keep the settings in FILE, as an EEPROM does (while it runs)" },
    { "record", OPTION_FILE(simulate_options, record), .value = "FILE",
      .help = "write every pulse with its time to FILE (CSV)" },
    { "speed", OPTION_CHOICE(simulate_options, speed), .choices = "real|fast", .standard = "fast",
      .help = "real time, or fast: as fast as it goes" },
    { "halt", OPTION_LIST(simulate_options, halt), .least = 0, .most = 4e9, .value = "TICK,..",
      .help = "time stops at these ticks of jobs, one after the other, each until kill -USR2 "
              "(none)" },
    { "line-baud", OPTION_INTEGER(simulate_options, line_baud), .least = 0, .most = 4000000,
      .value = "RATE", .standard = "0",
      .help = "the line brings its bytes in simulated time; 0: at once" },
    { "once", OPTION_FLAG(simulate_options, once), .help = "end after one job" },
    { "quiet", OPTION_FLAG(simulate_options, quiet),
      .help = "print only the name of the pseudo terminal, and errors" },
    { "steps", OPTION_LIST(simulate_options, steps), .least = 0.01, .most = 30000, .value = "N,..",
      .counts = "1|3", .remedy = "give one number, or 3 with commas between",
      .help = "steps per mm, for all axes or each (80)" },
    { "max-speed", OPTION_LIST(simulate_options, fastest), .least = 1 / 64.0, .most = 16383,
      .value = "MM/S,..", .counts = "1|3", .remedy = "give one number, or 3 with commas between",
      .help = "of the axes (500)" },
    { "accel", OPTION_LIST(simulate_options, accel), .least = 1, .most = 16383, .value = "MM/S2,..",
      .counts = "1|3", .remedy = "give one number, or 3 with commas between",
      .help = "of the axes (2000)" },
    { "tick-hz", OPTION_INTEGER(simulate_options, tick_hz), .least = 50, .most = 50000,
      .unit = "Hz", .unset = FROM_FILE, .help = "ticks per second (1000)" },
    { "slots", OPTION_INTEGER(simulate_options, slots), .least = 1, .most = 4096, .value = "N",
      .unset = FROM_FILE, .help = "chances to step per tick (40)" },
    { "ramp", OPTION_INTEGER(simulate_options, ramp), .least = 1, .most = 32767, .value = "TICKS",
      .unset = FROM_FILE, .help = "from full pace to a stop in a hold (100)" },
    { "curves", OPTION_INTEGER(simulate_options, curves), .least = 0, .most = 4096, .value = "N",
      .unset = FROM_FILE, .help = "curves that fit its plan; 0: it does not plan (64)" },
    { "columns", OPTION_INTEGER(simulate_options, columns), .least = 0, .most = 1024, .value = "N",
      .standard = "64", .help = "curves of a line of a patch; 0: it takes no patches" },
    { "queue", OPTION_INTEGER(simulate_options, queue), .least = 2, .most = 32768, .value = "N",
      .unset = FROM_FILE, .help = "items that fit the queue (256)" },
    { "limits", OPTION_TEXT(simulate_options, limits), .value = "x-=MM,..",
      .help = "limit switches: axis, - or + end, and mm from the start, where it closes; x-=MMnc: "
              "it opens there (none)" },
    { "shared", OPTION_FLAG(simulate_options, shared),
      .help = "the switches of both ends of an axis share one input, as on an Uno" },
    { "gantry", OPTION_TEXT(simulate_options, gantry), .value = "y=MM",
      .help = "an axis with two motors, the second so far ahead; each has the switches of --limits "
              "(none)" },
    { "walls", OPTION_TEXT(simulate_options, walls), .value = "x-=MM,..",
      .help = "where the table ends: steps that run into a wall are lost (none)" },
    { "probe", OPTION_TEXT(simulate_options, probe), .value = "z-=MM,..",
      .help = "where the probe touches something (none)" },
    { "bounce", OPTION_NUMBER(simulate_options, bounce), .least = 0, .most = 100, .unit = "ms",
      .standard = "0", .help = "how long the contacts of switches and probe bounce" },
    { "noise", OPTION_NUMBER(simulate_options, noise), .least = 0, .most = 100000, .unit = "ppm",
      .standard = "0", .help = "flipped bits per million on the line" },
    ENGINE_ROW(simulate_options, e, "q16", "number type of the machine"),
    OPTION_NO_WORDS("simulate takes no file"),
    OPTION_EXCLUDES("speed=real", "halt|line-baud",
                    "they are of simulated time: give --speed fast"),
    { 0 }
};

/* One number for all axes, or one for each, or those of the machine. */
static void spread(const option_list *list, const double machine[], double out[LOFT_AXES])
{
    for (size_t i = 0; i < LOFT_AXES; i++)
        out[i] = list->count == 0 ? machine[i] : list->value[list->count == 1 ? 0 : i];
}

static unsigned given(unsigned option_of, double machine)
{
    return option_of == (unsigned)FROM_FILE ? (unsigned)machine : option_of;
}

/* The numbers of the file are the defaults of the options. */
static void take_machine(const simulate_options *w, const machine_file *m,
                         struct loft_host_options *o)
{
    spread(&w->steps, m->steps_per_mm, o->steps_per_mm);
    spread(&w->fastest, m->max_speed, o->max_speed);
    spread(&w->accel, m->max_accel, o->max_accel);
    for (int i = 0; i < LOFT_AXES; i++)
        o->max_jerk[i] = m->max_jerk[i];
    o->tick_hz = given(w->tick_hz, m->tick_hz);
    o->slots   = given(w->slots, m->slots);
    o->ramp    = given(w->ramp, m->ramp);
    o->queue   = given(w->queue, m->queue);
    o->curves  = given(w->curves, m->curves);
    o->columns = w->columns;
}

static int take_surroundings(const simulate_options *w, struct loft_host_options *o)
{
    int code = take_ends("limits", w->limits, true, o->limit);

    if (code == 0)
        code = take_gantry(w->gantry, o);
    if (code == 0)
        code = take_ends("walls", w->walls, false, o->wall);
    if (code == 0)
        code = take_ends("probe", w->probe, false, o->probe);
    o->shared    = w->shared;
    o->bounce_ms = w->bounce;
    o->noise     = w->noise;
    return code;
}

/* How it runs, and what is kept of it. */
static int take_run(const simulate_options *w, struct loft_host_options *o)
{
    o->link      = w->link;
    o->kept      = w->kept;
    o->record    = w->record;
    o->fast      = w->speed == 1;
    o->line_baud = w->line_baud;
    o->once      = w->once;
    o->quiet     = w->quiet;
    o->halts     = (unsigned)w->halt.count;
    for (size_t i = 0; i < w->halt.count && i < LOFT_HOST_HALTS; i++)
        o->halt[i] = w->halt.value[i];
    return w->halt.count <= LOFT_HOST_HALTS
               ? 0
               : tool_error(EX_USAGE, "--halt: give at most %d ticks", LOFT_HOST_HALTS);
}

static int run_simulate(void *options)
{
    const simulate_options *w  = options;
    struct loft_host_options o = loft_host_defaults();
    machine_file m             = machine_usual();
    char text[KINEMATICS_TEXT];
    int code = w->machine ? machine_read(tool_host(), &m, w->machine) : 0;

    if (code != 0)
        return code;
    take_machine(w, &m, &o);
    kinematics_text(&m.k, text);
    o.note       = text;
    o.tool       = m.k.kind->linear && !m.k.kind->direct ? tool_of : NULL;
    o.kinematics = &m.k;
    if (o.curves > 0 && o.curves < 4)
        return tool_error(EX_USAGE, "a plan of %u curves: give 0 for none, or 4 to 4096", o.curves);
    code = take_surroundings(w, &o);
    if (code == 0)
        code = take_run(w, &o);
    return code == 0 ? simulate(&o, w->e) : code;
}

const command command_simulate = {
    .name = "simulate",
    .arguments = "[--link PATH] [--record FILE]",
    .summary = "the machine as a program, behind a pseudo terminal",
    .detail = "Prints the name of the pseudo terminal; give it, or PATH, "
        "to `loft stream --port`. What runs is the code of the\n"
        "firmware, in any number type. Ends with ^C, which stops "
        "the machine on the path, or with --once after one job.\n"
        "kill -USR1 presses its emergency stop, and the next one "
        "frees it. Where --halt stops the time of a machine\n"
        "with a sender it still talks: it prints `job ID halted at "
        "tick N`, a hold or an abort shows at once, and kill\n"
        "-USR2 lets time go on.\n",
    .options = simulate_rows,
    .size = sizeof(simulate_options),
    .run = run_simulate,
    .talks = true,
};
