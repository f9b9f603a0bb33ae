/* host-tools/send/change.h -- asks for another tool, and waits until it is in
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CHANGE_H
#define LOFT_CHANGE_H

#include "base/host.h"
#include "read/machine_tools.h"
#include "send/task.h"

typedef struct {
    host *host;
    const machine_tool *tool;
    enum { CHANGE_ASKS, CHANGE_GOES_ON, CHANGE_LEAVES } state;
    bool stop;
    double until;               /* its delay is over; 0: it has not begun */
} change;

/* The pause of a tool begins: while the state is CHANGE_ASKS, the user is to be asked whether it is
 * in. `asks`: he can be. Then its delay passes. Stepped, it ends with 0, or with EX_TEMPFAIL after
 * one message. */
void change_begin(change *c, host *h, const machine_tool *tool, bool asks);
int  change_step(change *c, double now, task_wants *w);

/* The answer of the user. */
void change_answer(change *c, bool goes_on);

#endif
