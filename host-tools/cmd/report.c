/* host-tools/cmd/report.c -- tells how a job goes
 * SPDX-License-Identifier: MIT
 */
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/say.h"
#include "cmd/screen.h"         /* screen_check */
#include "base/tool.h"
#include "cmd/report.h"
#include "cmd/view.h"

#define OFTEN   0.1             /* s between two reports */
#define REPAINT ('L' & 0x1f)    /* ^L */

/* Of all jobs: the distance from the drawing and what it may be there, mm; parts of the limits of
 * each motor. */
typedef struct {
    double distance, of;
    double speed[ENGINE_AXES], accel[ENGINE_AXES], jerk[ENGINE_AXES];
} report_worst;

/* The program sends one job at a time. */
static struct {
    enum report_form form;
    const report_job *job;
    progress bar;
    bool plans;                 /* the bar counts planned items, not ticks */
    double last;                /* the clock of the last report */
    send_facts facts;         /* the last, and */
    char line[256];             /* the last event */
    FILE *out;                  /* of JSON */
    report_worst worst;         /* of 0 is none */
} now;


// JSON
// ----

static void put_event(const char *event) { fprintf(now.out, "{\"event\":\"%s\"", event); }

static void put_pair(const char *key, const char *text)
{
    fprintf(now.out, ",\"%s\":", key);
    if (text != NULL)
        say_quoted(now.out, text);
    else
        fputs("null", now.out);
}

static void end_line(void)
{
    fputs("}\n", now.out);
    fflush(now.out);
}

static void put_job(const report_job *job)
{
    char id[16];

    put_event("job");
    put_pair("file", job->file);
    put_pair("port", job->port);
    put_pair("tool", job->tool);
    snprintf(id, sizeof id, "%08" PRIx32, job->id);
    put_pair("id", job->id != 0 ? id : NULL);
    fprintf(now.out, ",\"tol\":%.6g", job->tol);
    if (job->path != NULL)
        fprintf(now.out, ",\"curves\":%zu,\"drawn\":%.3f,\"travelled\":%.3f", job->path->curves,
                job->path->drawn, job->path->travelled);
}

static void put_state(const send_facts *f)
{
    put_event("state");
    put_pair("state", f->state);
    put_pair("tool", now.job->tool);
    fprintf(now.out, ",\"pen\":\"%s\",\"item\":%" PRIu32 ",\"items\":",
            report_draws(now.job, f->moves) ? "down" : "up", f->item);
    if (f->items > 0)
        fprintf(now.out, "%" PRIu32, f->items);
    else
        fputs("null", now.out);
    fprintf(now.out, ",\"part\":%.4f,\"left\":", f->total > 0 ? fmin(f->done / f->total, 1) : 1);
    if (now.bar.left < 1e9)
        fprintf(now.out, "%.1f", now.bar.left);
    else
        fputs("null", now.out);
    fprintf(now.out,
            ",\"queued\":%" PRIu32 ",\"feed\":%.2f,\"override\":%u,\"at\":[%.4f,%.4f,%.4f]",
            f->queued, f->feed, f->override, f->at[0], f->at[1], f->at[2]);
    end_line();
}


// All forms
// ---------

int report_start(enum report_form form)
{
    const int code = form == REPORT_VIEW ? screen_check("view") : 0;

    now.form = form;
    if (code != 0 || form != REPORT_JSON)
        return code;
    fflush(stdout);
    const int copy = dup(STDOUT_FILENO);
    now.out        = copy < 0 ? NULL : fdopen(copy, "w");
    if (now.out == NULL || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return tool_error(EX_OSERR, "--json: no second standard output: close some files");
    return 0;
}

static void start_bar(bool plans)
{
    progress_start(&now.bar, 0);
    now.bar.shown = now.bar.shown && now.form == REPORT_BAR;
    now.plans     = plans;
}

void report_begin(const report_job *job)
{
    now.job     = job;
    now.last    = -1;
    now.line[0] = '\0';
    start_bar(false);
    if (now.form != REPORT_JSON)
        return;
    put_job(job);
    end_line();
}

void report_planned(const report_job *job, double seconds, uint32_t items)
{
    if (now.form != REPORT_JSON)
        return;
    put_job(job);
    fprintf(now.out, ",\"seconds\":%.3f,\"items\":%" PRIu32, seconds, items);
    end_line();
}

int report_key(int key)
{
    if (key != REPAINT)
        return key;
    screen_paint();
    return 0;
}

bool report_shown(void) { return now.form != REPORT_BAR || now.bar.shown; }

void report_show(const send_facts *f, const char *words)
{
    const double clock = tool_clock();
    const bool plans   = strcmp(f->state, "plans") == 0;

    if (plans != now.plans)
        start_bar(plans);
    now.bar.total = f->total;
    if (f->rests)
        progress_rest(&now.bar);
    progress_show(&now.bar, f->done, words);
    if (now.form == REPORT_BAR || clock - now.last < OFTEN)
        return;
    now.last  = clock;
    now.facts = *f;
    if (now.form == REPORT_JSON)
        put_state(f);
    else
        view_show(now.job, f, now.bar.left, now.line);
}

void report_line(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    vsnprintf(now.line, sizeof now.line, format, values);
    va_end(values);
    if (now.form == REPORT_BAR) {
        progress_clear(&now.bar);
        (void)say(stderr, "%s\n", now.line);
    } else if (now.form == REPORT_JSON) {
        put_event("line");
        put_pair("text", now.line);
        end_line();
    } else if (now.last >= 0) {
        view_show(now.job, &now.facts, now.bar.left, now.line);
    }
}

void report_end(void)
{
    if (now.form == REPORT_VIEW)
        view_end();
    else
        progress_clear(&now.bar);
}

void report_certified(const certify *c, double distance, double of)
{
    report_worst *sum = &now.worst;

    if (distance * sum->of >= sum->distance * of) {
        sum->distance = distance;
        sum->of       = of;
    }
    for (int i = 0; i < ENGINE_AXES; i++) {
        sum->speed[i] = fmax(sum->speed[i], c->speed[i].worst);
        sum->accel[i] = fmax(sum->accel[i], c->accel[i].worst);
        sum->jerk[i]  = fmax(sum->jerk[i], c->jerk[i].worst);
    }
}

static void put_parts(const char *of, const double part[ENGINE_AXES])
{
    fprintf(now.out, ",\"%s\":[%.4f,%.4f,%.4f]", of, part[0], part[1], part[2]);
}

static void put_worst(const report_worst *w)
{
    fprintf(now.out, ",\"distance\":%.6f,\"of\":%.6g", w->distance, w->of);
    put_parts("speed", w->speed);
    put_parts("acceleration", w->accel);
    put_parts("jerk", w->jerk);
}

int report_exit(int code)
{
    if (now.form == REPORT_JSON && now.out != NULL) {
        put_event("end");
        fprintf(now.out, ",\"code\":%d", code);
        if (now.worst.of > 0)
            put_worst(&now.worst);
        end_line();
    }
    return code;
}
