/* host-tools/cmd/cmd_zero.c -- loft zero: tells a machine at rest where it stands
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "cmd/run_move.h"       /* run_mover, run_place */
#include "cmd/run_settings.h"

/* Let the machine keep where on its table the zero lies: as much farther as the tool's place
 * changes. */
static int keep_zero(mover *v, const double was[ENGINE_AXES], const double is[ENGINE_AXES])
{
    settings s;

    if (v->p.file != NULL || !settings_kept(&v->t))
        return tool_error(EX_CONFIG,
                          v->p.file ? "%s: --keep changes the settings of the machine: give x.zero "
                                      "in this file"
                                    : "%s: this machine keeps no settings: give x.zero in a "
                                      "--machine FILE",
                          v->p.file ? v->p.file : v->o.line.port);
    int code = run_settings_read(&s, &v->t);
    for (int i = 0; i < ENGINE_AXES; i++)
        s.m.zero[i] += was[i] - is[i];
    if (code == 0)
        code = run_settings_write(&s, &v->t, v->o.line.wait);
    return code ? code : run_ready(v);
}

static int zero_axes(mover *v, const bool axis[ENGINE_AXES], double at, bool keep)
{
    double was[ENGINE_AXES], is[ENGINE_AXES];
    char before[96], after[96];

    memcpy(was, v->at, sizeof was);
    unsigned axes = 0;
    for (int i = 0; i < ENGINE_AXES; i++) {
        is[i] = axis[i] ? at : was[i];
        axes |= (unsigned)axis[i] << i;
    }
    int code = keep ? keep_zero(v, was, is) : 0;
    if (code == 0)
        code = run_place(v, axes, is);
    if (code == 0)
        printf("the tool was at %s, and is now at %s\n", mover_text(was, before),
               mover_text(v->at, after));
    return code;
}

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

static int run_zero(void *options)
{
    const zero_options *o  = options;
    bool axis[ENGINE_AXES] = { false };
    mover v                = { .at = { 0 } };
    int code               = mover_axes(tool_host(), o->axes, axis);

    if (code == 0)
        code = run_mover(&v, &o->move, false);
    if (code == 0)
        code = zero_axes(&v, axis, o->at, o->keep);
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
