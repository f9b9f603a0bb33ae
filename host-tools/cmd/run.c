/* host-tools/cmd/run.c
 * SPDX-License-Identifier: MIT
 */
#include <poll.h>

#include "base/tool.h"      /* tool_clock */
#include "cmd/keys.h"       /* keys_interrupted */
#include "cmd/run.h"
#include "cmd/waits.h"      /* waits_for */

#define MOST 0.02           /* s between two looks at keys and signals */

/* Until one of its descriptors is ready. A signal that comes just before is seen MOST later. */
static void wait_wanted(const task_wants *w)
{
    struct pollfd p[] = { { .fd = w->in, .events = POLLIN }, { .fd = w->out, .events = POLLOUT } };
    const double left = fmin(w->until - tool_clock(), MOST);

    (void)poll(p, 2, left > 0 ? (int)ceil(1000 * left) : 0);
}

int run_until(task t)
{
    waits waiting = { .told = false };
    task_wants w;

    for (;;) {
        const double now = tool_clock();
        *t.stop          = *t.stop || keys_interrupted();
        const int code   = task_step(&t, now, &w);
        if (code != TASK_GOES)
            return code;
        waits_for(&waiting, w.awaits, now);
        wait_wanted(&w);
    }
}

typedef struct {
    transport *t;
    bool stop;
} opening;

static int step_line(void *context, double now, task_wants *w)
{
    const opening *o = context;

    return o->stop ? tool_error(EX_TEMPFAIL, "stopped before the port was open")
                   : transport_step(o->t, now, w);
}

int run_line(transport *t, const char *name, unsigned baud)
{
    opening o = { .t = t };
    int code  = transport_open(t, tool_host(), name, baud);

    if (code != 0)
        return code;
    code = run_until((task){ step_line, &o, &o.stop });
    if (code != 0)
        t->kind->close(t);
    return code;
}

int run_open(talk *t, const talk_options *o)
{
    int code = talk_open(t, tool_host(), o, tool_clock());

    if (code == 0)
        code = run_until(talk_greets(t));
    if (code != 0)
        talk_close(t);
    return code;
}

int run_again(talk *t, double seconds)
{
    talk_again(t, seconds);
    return run_until(talk_greets(t));
}

int run_controller(grbl **g, const talk_options *o)
{
    int code = grbl_open(g, tool_host(), o->port, o->baud, o->wait);

    if (code == 0)
        code = run_until(grbl_task(*g));
    if (code != 0) {
        grbl_close(*g);
        *g = NULL;
    }
    return code;
}
