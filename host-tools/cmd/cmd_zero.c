/* host-tools/cmd/cmd_zero.c -- loft zero: tells a machine at rest where it stands
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/tool.h"
#include "read/machine_file.h"   /* machine_option */
#include "send/stream_end.h"     /* stream_place */
#include "send/talk.h"           /* talk_open */

#define OBEYS 5.0                /* s to obey */

typedef struct {
    const char *port, *machine, *log;
    unsigned baud;
    double wait, at;
    machine_file m;
    bool axis[ENGINE_AXES];      /* that are zeroed */
} zero_options;

/* `xy`: each axis once. */
static int take_axes(zero_options *o, const char *text)
{
    for (const char *s = text; *s; s++) {
        const char *known = strchr("xyz", *s);
        if (known == NULL || o->axis[known - "xyz"])
            return tool_error(EX_USAGE, "%s: give each axis once, as xy or z", text);
        o->axis[known - "xyz"] = true;
    }
    return 0;
}

static int check_machine(const zero_options *o, const loft_sender *s)
{
    if (loft_state_busy(s->ack.state))
        return tool_error(EX_TEMPFAIL,
                          "%s: a job is running: wait for its end, or `loft stream --abort --port "
                          "%s`",
                          o->port, o->port);
    if (s->ack.state == LOFT_STATE_FAULT)
        return tool_error(EX_TEMPFAIL, "%s: the machine has a fault: restart it", o->port);
    if (!(s->machine.kinds & LOFT_TAKES_PLACES))
        return tool_error(EX_CONFIG,
                          "%s: this machine cannot be told where it stands: give it a newer "
                          "firmware",
                          o->port);
    return 0;
}

/* The steps of all motors for the tool's new place. */
static int steps_there(const zero_options *o, const loft_sender *s, double tool[ENGINE_AXES],
                       int32_t steps[LOFT_AXES])
{
    double near[ENGINE_AXES], motors[ENGINE_AXES];
    char why[160];

    for (int i = 0; i < LOFT_AXES; i++) {
        near[i] = (double)s->axis[i].position * 65536 / (double)s->axis[i].steps_per_mm;
        tool[i] = o->axis[i] ? o->at : tool[i];
    }
    if (kinematics_beyond(&o->m.k, tool, why))
        return tool_error(EX_DATAERR, "%.6g,%.6g,%.6g: %s: give another --at", tool[0], tool[1],
                          tool[2], why);
    kinematics_motors(&o->m.k, tool, near, motors);
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = (int32_t)lround(motors[i] * (double)s->axis[i].steps_per_mm / 65536);
    return 0;
}

static int place_machine(const zero_options *o, talk *t, const int32_t steps[LOFT_AXES])
{
    const double until = tool_clock() + OBEYS;
    loft_sender *s     = &t->sender;

    if (loft_sender_place(s, (1u << LOFT_AXES) - 1, steps) != LOFT_OK)
        return tool_error(EX_SOFTWARE, "the place could not be sent: please report this");
    while (s->verb != 0) {
        if (!talk_pump(t, 20))
            return talk_vanished(t, "before the machine obeyed ");
        if (tool_clock() > until)
            return tool_error(EX_IOERR,
                              "%s: the machine did not obey in %g s: run the same command again",
                              o->port, OBEYS);
    }
    return s->ack.refusal == LOFT_REFUSAL_NONE
               ? 0
               : tool_error(EX_TEMPFAIL, "%s: the machine refused: a job has begun meanwhile",
                            o->port);
}

static int zero_axes(const zero_options *o, talk *t)
{
    loft_sender *s = &t->sender;
    double was[LOFT_AXES], is[LOFT_AXES];
    int32_t steps[LOFT_AXES];
    int code = check_machine(o, s);

    if (code != 0)
        return code;
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = s->axis[i].position;
    stream_place(s, &o->m.k, steps, was);
    memcpy(is, was, sizeof is);
    code = steps_there(o, s, is, steps);
    if (code == 0)
        code = place_machine(o, t, steps);
    if (code != 0)
        return code;
    stream_place(s, &o->m.k, steps, is);
    printf("the tool was at %.3f %.3f %.3f, and is now at %.3f %.3f %.3f\n", was[0], was[1], was[2],
           is[0], is[1], is[2]);
    return 0;
}

static int run_zero(const tool_command *self, int argc, char **argv)
{
    zero_options o = { .baud = 115200, .wait = 5, .m = machine_usual() };
    int first, code = machine_option(&o.m, argc, argv);
    talk t;

    if (code != 0)
        return code;
    const tool_option options[] = {
        TALK_OPTIONS(o),
        TOOL_NUMBER("at", "MM", &o.at, -16383, 16383, "the axes are here, not at 0 (0)"),
        TOOL_TEXT("machine", "FILE", &o.machine,
                  "a machine as text, see host-tools/MACHINE.md: if its motors are not axes"),
        TOOL_TEXT("log", "FILE", &o.log, "write what passes on the line, in words"),
        TOOL_OPTIONS_END
    };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (o.port == NULL)
        return tool_error(EX_USAGE, "no --port: name the machine's port");
    if (first + 1 < argc)
        return tool_error(EX_USAGE, "%s: name the axes in one word, as xy", argv[first + 1]);
    code = take_axes(&o, first < argc ? argv[first] : "xyz");
    if (code == 0)
        code = talk_open(&t, o.port, o.baud, o.wait, o.log);
    if (code != 0)
        return code;
    code = zero_axes(&o, &t);
    talk_close(&t);
    return code;
}

const tool_command command_zero = {
    "zero", "[AXES] --port PORT", "the machine stands at 0 now: tell it so",
    "AXES are letters, as xy or z; without them all of x, y and z. Nothing moves. Put the pen\n"
    "where 0,0 of the drawing is to be, then run it. The machine keeps this until it restarts.\n",
    run_zero
};
