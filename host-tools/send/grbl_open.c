/* host-tools/send/grbl_open.c -- finds out which controller of grbl's kind answers
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "send/grbl_talk.h"
#include "base/memory.h"         /* memory_grow */

#define OFFSET_TOLD 64      /* statuses: it tells its offset with each 10th or 30th */

static const char *const questions[GRBL_QUESTIONS] = { "$I\n", "$$\n" };

/* Explain, from the received bytes, why the controller is not ready. */
static int report_unready(const grbl *g)
{
    const char *name = g->name[0] != '\0' ? g->name : "the controller";

    if (g->received == 0)
        return host_error(g->host, EX_UNAVAILABLE, "grbl.no-answer",
                          (host_place){ .file = g->line.text },
                          "look at its power, cable and --baud; one that takes longer to start "
                          "needs --wait; or is it a loft machine? Then without --grbl",
                          "no answer in %g s", g->wait);
    if (!g->answered)
        return host_error(g->host, EX_PROTOCOL, "grbl.no-word",
                          (host_place){ .file = g->line.text },
                          "is --baud right, and is it a controller of that kind?",
                          "%lu bytes came, but no word of grbl's", g->received);
    if (g->unread[0] != '\0')
        return host_error(
            g->host, EX_PROTOCOL, "grbl.no-meaning", (host_place){ .file = g->line.text },
            "look at the line, --baud and its settings",
            "%s answers, but its report `%s` has no place with a meaning", name, g->unread);
    if (g->machined)
        return host_error(g->host, EX_CONFIG, "grbl.no-work-place",
                          (host_place){ .file = g->line.text },
                          "set $10=0 with a terminal, so that it reports WPos",
                          "%s answers, but reports its position as MPos without WCO", name);
    return host_error(g->host, EX_PROTOCOL, "grbl.no-place", (host_place){ .file = g->line.text },
                      "reset it, or give it firmware that speaks grbl 1.1",
                      "%s answers, but does not report its position when asked by `?`", name);
}

static int refuse_busy(const grbl *g)
{
    if (strncmp(g->word, "Alarm", 5) == 0)
        return host_error(g->host, EX_CONFIG, "grbl.locked", (host_place){ .file = g->port },
                          "home it ($H) or unlock it ($X) with a terminal, then run this again",
                          "the controller is locked after an alarm");
    return host_error(g->host, EX_UNAVAILABLE, "grbl.not-idle", (host_place){ .file = g->port },
                      "let it finish, or reset it", "the controller is not idle but says %s%s%s",
                      g->word, *g->state->text ? ": " : "", g->state->text);
}

/* With soft limits, the offset tells where the table is in work coordinates. One that never tells
 * it has no table that is known. */
static int await_offset(grbl *g, double now, task_wants *w)
{
    if (grbl_settings_number(&g->settings, 20, 0) <= 0 || g->offsetted || g->idles >= OFFSET_TOLD ||
        now >= g->until)
        return host_code(g->host, g->warned, 0);
    if (!grbl_step(g, now, w))
        return grbl_report_vanished(g);
    task_wake(w, g->offsetted ? now : g->until);
    return TASK_GOES;
}

static bool is_known(const grbl *g)
{
    return g->placed && g->inquired == GRBL_QUESTIONS && !g->asking;
}

static void ask_next(grbl *g)
{
    const char *question = questions[g->inquired++];

    g->asking = true;
    grbl_put(g, question, strlen(question));
}

/* A board that is reset when its port is opened, or whose boot loader listens first, answers late:
 * from its first word on it has the same time again. */
static int greet_controller(grbl *g, double now, task_wants *w)
{
    const bool answered = g->answered;

    if (g->stop)
        return host_error(g->host, EX_TEMPFAIL, "grbl.stopped", (host_place){ .file = NULL }, NULL,
                          "stopped before the controller answered: nothing was sent");
    if (!grbl_step(g, now, w))
        return grbl_report_vanished(g);
    if (g->answered && !answered)
        g->until = now + g->wait;
    if (g->answered && !g->asking && g->inquired < GRBL_QUESTIONS) {
        ask_next(g);
        task_wake(w, now);
    }
    if (!is_known(g) && now < g->until) {
        task_wake(w, g->until);
        if (!g->answered)
            snprintf(w->awaits, sizeof w->awaits,
                     "no controller has answered at %s yet: it is asked for %g s", g->line.text,
                     g->wait);
        return TASK_GOES;
    }
    if (!g->placed)                     /* a question may be unknown: do without the answer */
        return report_unready(g);
    if (g->state->doing != GRBL_IDLE)
        return refuse_busy(g);
    g->until = now + GRBL_DEAF;
    g->stage = await_offset;
    return await_offset(g, now, w);
}

static int begin_greeting(grbl *g, double now, task_wants *w)
{
    const int code = g->stop ? 0 : transport_step(&g->line, now, w);

    if (code != 0)
        return code;
    g->until = now + g->wait;
    g->stage = greet_controller;
    return greet_controller(g, now, w);
}

int grbl_open(grbl **out, host *h, const char *port, unsigned baud, double seconds)
{
    grbl *g = memory_grow(NULL, sizeof *g);

    *g = (grbl){ .host = h,
                 .warned = h->warnings,
                 .port = port,
                 .buffer = GRBL_BUFFER,
                 .rate = 100,
                 .unit = 1,
                 .wait = seconds,
                 .stage = begin_greeting };
    const int code = transport_open(&g->line, h, port, baud);
    if (code != 0) {
        free(g);
        g = NULL;
    }
    *out = g;
    return code;
}

static int step(void *context, double now, task_wants *w)
{
    grbl *g = context;

    return g->stage(g, now, w);
}

task grbl_task(grbl *g) { return (task){ step, g, &g->stop }; }

void grbl_close(grbl *g)
{
    if (g == NULL)
        return;
    g->line.kind->close(&g->line);
    free(g);
}

const double *grbl_place(const grbl *g) { return g->place; }
const char   *grbl_name(const grbl *g) { return g->name; }

int grbl_machine(const grbl *g, machine_file *m)
{
    const int code = machine_text(g->host, m, g->port, g->settings.text);

    if (code == 0 && !grbl_table(g, m))
        for (int i = 0; i < ENGINE_AXES; i++)
            m->travel[i] = m->min[i] = 0;
    return code;
}

bool grbl_table(const grbl *g, machine_file *m)
{
    return g->offsetted && grbl_settings_table(&g->settings, g->offset, m);
}
