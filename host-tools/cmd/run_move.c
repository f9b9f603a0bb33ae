/* host-tools/cmd/run_move.c
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "base/tool.h"      /* tool_clock */
#include "cmd/keys.h"       /* keys_start */
#include "cmd/run.h"        /* run_until */
#include "cmd/run_move.h"

int run_mover(mover *v, const mover_options *o, bool keys)
{
    keys_start(keys);
    const int code = mover_open(v, tool_host(), o, tool_clock());

    return code ? code : run_until(mover_task(v));
}

int run_told(const mover *v, int code)
{
    char text[96];

    if (code == 0)
        printf("the tool is at %s\n", mover_text(v->at, text));
    fflush(stdout);
    return code;
}
