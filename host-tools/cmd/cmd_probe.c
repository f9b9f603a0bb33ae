/* host-tools/cmd/cmd_probe.c -- loft probe: moves until the probe touches something
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "cmd/commands.h"
#include "cmd/run.h"            /* run_until */
#include "cmd/run_drawing.h"    /* run_teller */
#include "cmd/run_move.h"       /* run_mover, run_told */
#include "send/probe.h"

typedef struct {
    mover_options move;
    const char *way;
    double within, feed, back, at;      /* at NAN: it only says where */
} probe_options;

static const option probe_rows[] = {
    { "way", OPTION_WORD(probe_options, way), .value = "AXIS+", .choices = "x-|x+|y-|y+|z-|z+",
      .standard = "z-", .remedy = "name one direction, as z- or x+" },
    OPTION_GROUP(probe_options, move, mover_rows),
    { "within", OPTION_NUMBER(probe_options, within), .least = 0.01, .most = 16383, .unit = "mm",
      .standard = "10", .help = "how far to look" },
    { "feed", OPTION_NUMBER(probe_options, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "2", .help = "mm/s, or as 60mm/min" },
    { "back", OPTION_NUMBER(probe_options, back), .least = 0, .most = 1000, .unit = "mm",
      .standard = "2", .help = "to leave the surface again" },
    { "at", OPTION_NUMBER(probe_options, at), .least = -16383, .most = 16383, .unit = "mm",
      .unset = NAN,
      .help = "the axis is there where it touches: tell the machine (it only says where)" },
    { 0 }
};

static int run_probe(void *options)
{
    const probe_options *o = options;
    const probe_way way    = { .axis   = o->way[0] - 'x',
                               .sign   = o->way[1] == '+' ? 1 : -1,
                               .within = o->within,
                               .feed   = o->feed,
                               .back   = o->back,
                               .at     = o->at };
    const send_teller to   = run_teller();
    mover v                = { .at = { 0 } };
    probe p;
    int code = run_mover(&v, &o->move, false);

    if (code == 0) {
        probe_begin(&p, &v, &way, &to);
        code = run_told(&v, run_until(probe_task(&p)));
    }
    mover_close(&v);
    return code;
}

const command command_probe = {
    .name = "probe",
    .arguments = "[AXIS+|AXIS-] --port PORT",
    .summary = "move until the probe touches something, and say where",
    .detail =
        "Without a direction it is z-. The place is that of the slot in which the contact first\n"
        "closed, whatever the speed; then the tool backs off. With --at, the place becomes that "
        "number:\n"
        "loft probe --at 0 makes the surface z = 0, and --at 15 takes a plate of 15 mm off.\n",
    .options = probe_rows,
    .size = sizeof(probe_options),
    .run = run_probe,
    .talks = true,
};
