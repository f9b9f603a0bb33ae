/* tests/bench/bench_motion_moves.c -- prints a drawing as the chain of moves that would be
 * streamed: one move per line, control points and feed
 * SPDX-License-Identifier: MIT
 * usage: moves FILE FEED > list     (feed with the pen up: twice that)
 */
#include <stdio.h>
#include <stdlib.h>

#include "base/tool.h"           /* what host tools share */
#include "cmd/terminal.h"
#include "plan/toolpath.h"       /* toolpath_make */
#include "readers.h"

int main(int count, char **word)
{
    const toolpath_options how = { .feed = count > 2 ? atof(word[2]) : 50,
                                   .travel = count > 2 ? 2 * atof(word[2]) : 100,
                                   .lift = 1 };
    drawing d = { 0 };
    toolpath t = { 0 };
    terminal screen = { .doing = NULL };
    host h          = terminal_host(&screen);

    tool_use(&h);
    const int code = count > 1 ? drawing_read(&h, &d, word[1]) : 64;

    if (code)
        return code;
    toolpath_make(&t, &d, &how);
    for (size_t m = 0; m < t.count; m++) {
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < ENGINE_AXES; i++)
                printf("%.9f ", t.move[m].p[k][i]);
        printf("%g\n", t.move[m].feed);
    }
    toolpath_free(&t);
    drawing_free(&d);
    return 0;
}
