/* host-tools/cmd/cmd_zero.c -- loft zero: tells a machine at rest where it stands
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/tool.h"
#include "send/mover.h"

static int zero_axes(mover *v, const bool axis[ENGINE_AXES], double at)
{
    double was[ENGINE_AXES], is[ENGINE_AXES];
    char before[96], after[96];

    memcpy(was, v->at, sizeof was);
    for (int i = 0; i < ENGINE_AXES; i++)
        is[i] = axis[i] ? at : was[i];
    const int code = mover_place(v, is);
    if (code == 0)
        printf("the tool was at %s, and is now at %s\n", mover_text(was, before),
               mover_text(v->at, after));
    return code;
}

static int run_zero(const tool_command *self, int argc, char **argv)
{
    bool axis[ENGINE_AXES] = { false };
    double at              = 0;
    mover v;
    int first, code = mover_start(&v, argc, argv);

    if (code != 0)
        return code;
    const tool_option options[] = { MOVER_OPTIONS(v),
                                    TOOL_NUMBER("at", "MM", &at, -16383, 16383,
                                                "the axes are here, not at 0 (0)"),
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
        code = zero_axes(&v, axis, at);
    mover_close(&v);
    return code;
}

const tool_command command_zero = {
    "zero", "[AXES] --port PORT", "the machine stands at 0 now: tell it so",
    "AXES are letters, as xy or z; without them all of x, y and z. Nothing moves. Put the pen\n"
    "where 0,0 of the drawing is to be, then run it. The machine keeps this until it restarts.\n",
    run_zero
};
