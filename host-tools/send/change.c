/* host-tools/send/change.c -- asks for another tool, and waits until it is in
 * SPDX-License-Identifier: MIT
 */
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

#include "cmd/keys.h"              /* keys_answer, keys_interrupted */
#include "base/say.h"
#include "base/tool.h"              /* tool_error, tool_clock */
#include "send/change.h"

enum answer { WAITS, GOES_ON, LEAVES };

static enum answer answer_of(int key, bool line)
{
    if (key == '\n' || key == '\r' || (!line && key == ' '))
        return GOES_ON;
    return key == 'q' || key == 'a' ? LEAVES : WAITS;
}

static enum answer next_answer(void)
{
    const int key = keys_answer(20);

    return key == KEYS_END ? LEAVES : answer_of(key, !isatty(STDIN_FILENO));
}

static void wait_delay(double seconds)
{
    const double until = tool_clock() + seconds;

    while (tool_clock() < until && !keys_interrupted())
        (void)poll(NULL, 0, 20);
}

int change_tool(const machine_tool *tool, bool asks)
{
    enum answer now = *tool->pause == '\0' ? GOES_ON : asks ? WAITS : LEAVES;

    if (now == WAITS)
        (void)say(stderr, "tool %s: %s: Enter goes on, q leaves\n", tool->name, tool->pause);
    while (now == WAITS && !keys_interrupted())
        now = next_answer();
    if (now == GOES_ON)
        wait_delay(tool->delay);
    if (now == GOES_ON && !keys_interrupted())
        return 0;
    return tool_error(EX_TEMPFAIL,
                      "tool %s is next: %s%sthe same command with --from-tool %s goes on",
                      tool->name, tool->pause, *tool->pause ? "; then " : "", tool->name);
}
