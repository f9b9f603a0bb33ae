/* host-tools/cmd/cmd_zero.c -- loft zero: tells a machine at rest where it stands
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/tool.h"
#include "send/mover.h"
#include "send/settings.h"       /* settings_write */

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
                          v->p.file ? v->p.file : v->port);
    int code = settings_read(&s, &v->t);
    for (int i = 0; i < ENGINE_AXES; i++)
        s.m.zero[i] += was[i] - is[i];
    if (code == 0)
        code = settings_write(&s, &v->t, v->wait);
    return code ? code : mover_ready(v);
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
        code = mover_place(v, axes, is);
    if (code == 0)
        printf("the tool was at %s, and is now at %s\n", mover_text(was, before),
               mover_text(v->at, after));
    return code;
}

static int run_zero(const tool_command *self, int argc, char **argv)
{
    bool axis[ENGINE_AXES] = { false };
    double at              = 0;
    bool keep              = false;
    mover v;
    int first, code = mover_start(&v, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = { MOVER_OPTIONS(v),
                                    TOOL_NUMBER("at", "MM", &at, -16383, 16383,
                                                "the axes are here, not at 0 (0)"),
                                    TOOL_SWITCH("keep", &keep,
                                                "a homed machine keeps it in its settings: it is "
                                                "there again after `loft home`"),
                                    TOOL_OPTIONS_END };
    code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (v.port != NULL && first + 1 < argc)
        return tool_error(EX_USAGE, "%s: name the axes in one word, as xy", argv[first + 1]);
    code = mover_axes(first < argc ? argv[first] : "xyz", axis);
    if (code == 0)
        code = mover_open(&v);
    if (code == 0)
        code = zero_axes(&v, axis, at, keep);
    mover_close(&v);
    return code;
}

const tool_command command_zero = {
    "zero", "[AXES] --port PORT", "the machine stands at 0 now: tell it so",
    "AXES are letters, as xy or z; without them all of x, y and z. Nothing moves. Put the pen\n"
    "where 0,0 of the drawing is to be, then run it. The machine keeps this until it restarts,\n"
    "with --keep for good: as x.zero, where on its table the zero lies.\n",
    run_zero
};
