/* host-tools/cmd/run_drawing.c
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <unistd.h>             /* isatty */

#include "base/say.h"
#include "base/tool.h"          /* tool_host */
#include "cmd/keys.h"           /* keys_next, keys_answer */
#include "cmd/report.h"         /* report_show */
#include "cmd/run.h"            /* run_until */
#include "cmd/run_drawing.h"
#include "cmd/waits.h"          /* waits_due */
#include "send/change.h"        /* change_step */

typedef struct {
    stream r;
    waits waiting;
    bool answered;              /* by a pipe, and the machine has not told so yet */
    bool deaf;                  /* standard input, which is no terminal, has ended */
    bool closed;                /* the report has ended */
} drawing_shown;

/* A key of the terminal; in a pause of the program also what a pipe says, until it ends. */
static int next_key(drawing_shown *x)
{
    if (isatty(STDIN_FILENO) || x->r.pause == NULL || x->answered || x->deaf)
        return report_key(keys_next());
    const int key = keys_answer(0);
    x->deaf       = key == KEYS_END;
    x->answered   = key == '\n' || key == '\r' || key == 'a';
    return x->answered ? key : 0;
}

static void obey_key(drawing_shown *x, double now, task_wants *w)
{
    const int key = next_key(x);

    if (key == 0)
        return;
    stream_key(&x->r, key);
    task_wake(w, now);
}

static void show(drawing_shown *x, double now, const task_wants *w)
{
    send_facts f;
    char words[160];

    if (stream_facts(&x->r, &f, words))
        report_show(&f, words);
    if (waits_due(&x->waiting, w->awaits, now))
        report_line("waiting: %s", x->waiting.what);
}

static int step_shown(void *context, double now, task_wants *w)
{
    drawing_shown *x  = context;
    const char *pause = x->r.pause;
    const int code    = stream_step(&x->r, now, w);

    x->answered = x->answered && x->r.pause == pause;
    if (code == TASK_GOES && !x->r.over) {
        obey_key(x, now, w);
        show(x, now, w);
    } else if (!x->closed) {
        report_end();
        x->closed = true;
    }
    w->awaits[0] = '\0';
    return code;
}

static void tell_line(void *context, enum send_line what, const char *line)
{
    (void)context;
    if (what == SEND_EVENT)
        report_line("%s", line);
    else
        (void)say(what == SEND_NOTE ? stderr : stdout, "%s\n", line);
    fflush(stdout);
}

send_teller run_teller(void) { return (send_teller){ .tell = tell_line, .shown = report_shown() }; }

int run_drawing(talk *t, job *j, const stream_subject *about)
{
    const report_job told = { about->file, about->port, about->tool,
                              about->path, about->tol,  j->head.id };
    drawing_shown x = { .waiting = { .told = false } };

    report_begin(&told);
    const send_teller to = run_teller();
    stream_begin(&x.r, t, j, about, &to);
    return run_until((task){ step_shown, &x, &t->stop });
}

int run_control(talk *t, enum loft_verb verb, const kinematics *k)
{
    const send_teller to = run_teller();
    stream_control c;

    stream_control_begin(&c, t, verb, k, &to);
    return run_until(stream_control_task(&c));
}


// Between two tools
// -----------------

static int step_asking(void *context, double now, task_wants *w)
{
    change *c      = context;
    const int key  = c->state == CHANGE_ASKS ? keys_answer(0) : 0;
    const bool yes = key == '\n' || key == '\r' || (key == ' ' && isatty(STDIN_FILENO));

    if (yes || key == 'q' || key == 'a' || key == KEYS_END)
        change_answer(c, yes);
    return change_step(c, now, w);
}

int run_change(const machine_tool *tool, bool asks)
{
    change c;

    change_begin(&c, tool_host(), tool, asks);
    if (c.state == CHANGE_ASKS)
        (void)say(stderr, "tool %s: %s: Enter goes on, q leaves\n", tool->name, tool->pause);
    return run_until((task){ step_asking, &c, &c.stop });
}
