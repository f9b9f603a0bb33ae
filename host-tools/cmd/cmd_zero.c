/* host-tools/cmd/cmd_zero.c -- loft zero: tells a machine at rest where it stands
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/commands.h"
#include "base/tool.h"          /* tool_host */
#include "cmd/run.h"            /* run_until */
#include "cmd/run_move.h"       /* run_mover */
#include "send/hand.h"

typedef struct {
    mover_options move;
    const char *axes;
    double at;
    bool keep;
} zero_options;

static const option zero_rows[] = {
    { "axes", OPTION_WORD(zero_options, axes), .value = "AXES", .standard = "xyz",
      .remedy = "name the axes in one word, as xy" },
    OPTION_GROUP(zero_options, move, mover_rows),
    { "at", OPTION_NUMBER(zero_options, at), .least = -16383, .most = 16383, .unit = "mm",
      .standard = "0", .help = "the axes are here, not at 0" },
    { "keep", OPTION_FLAG(zero_options, keep),
      .help = "a homed machine keeps it in its settings: it is there again after `loft home`" },
    { 0 }
};

static void print_change(const hand *m)
{
    char before[96], after[96];

    printf("the tool was at %s, and is now at %s\n", mover_text(m->was, before),
           mover_text(m->v->at, after));
}

static int run_zero(void *options)
{
    const zero_options *o        = options;
    const double at[ENGINE_AXES] = { o->at, o->at, o->at };
    bool axis[ENGINE_AXES]       = { false };
    mover v                      = { .at = { 0 } };
    int code                     = mover_axes(tool_host(), o->axes, axis);
    hand m;

    if (code == 0)
        code = run_mover(&v, &o->move, false);
    if (code == 0) {
        hand_zero(&m, &v, (unsigned)(axis[0] | axis[1] << 1 | axis[2] << 2), at, o->keep);
        code = run_until(hand_task(&m));
    }
    if (code == 0)
        print_change(&m);
    mover_close(&v);
    return code;
}

const command command_zero = {
    .name = "zero",
    .arguments = "[AXES] --port PORT",
    .summary = "the machine stands at 0 now: tell it so",
    .detail =
        "AXES are letters, as xy or z; without them all of x, y and z. Nothing moves. Put the pen\n"
        "where 0,0 of the drawing is to be, then run it. The machine keeps this until it "
        "restarts,\n"
        "with --keep for good: as x.zero, where on its table the zero lies.\n",
    .options = zero_rows,
    .size = sizeof(zero_options),
    .run = run_zero,
    .talks = true,
};
