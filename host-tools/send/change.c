/* host-tools/send/change.c -- asks for another tool, and waits until it is in
 * SPDX-License-Identifier: MIT
 */
#include "send/change.h"

static int report_left(const change *c)
{
    const machine_tool *tool = c->tool;

    return host_error(c->host, EX_TEMPFAIL, "tool.next", (host_place){ .file = NULL }, NULL,
                      "tool %s is next: %s%sthe same command with --from-tool %s goes on",
                      tool->name, tool->pause, *tool->pause ? "; then " : "", tool->name);
}

int change_step(change *c, double now, task_wants *w)
{
    if (c->stop || c->state == CHANGE_LEAVES)
        return report_left(c);
    if (c->state == CHANGE_ASKS)
        return TASK_GOES;
    if (c->until <= 0)
        c->until = now + c->tool->delay;
    task_wake(w, c->until);
    return now < c->until ? TASK_GOES : 0;
}

void change_begin(change *c, host *h, const machine_tool *tool, bool asks)
{
    *c = (change){ .host = h,
                   .tool = tool,
                   .state = *tool->pause == '\0' ? CHANGE_GOES_ON
                            : asks               ? CHANGE_ASKS
                                                 : CHANGE_LEAVES };
}

void change_answer(change *c, bool goes_on)
{
    if (c->state == CHANGE_ASKS)
        c->state = goes_on ? CHANGE_GOES_ON : CHANGE_LEAVES;
}
