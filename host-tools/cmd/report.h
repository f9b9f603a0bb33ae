/* host-tools/cmd/report.h -- tells how a job goes: a bar, the whole terminal, or lines of JSON
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_REPORT_H
#define LOFT_REPORT_H

#include <stddef.h>
#include <stdint.h>

#include "base/progress.h"      /* progress */
#include "plan/certify.h"       /* certify */
#include "plan/toolpath.h"      /* toolpath */
#include "send/facts.h"         /* send_facts */

enum report_form { REPORT_BAR, REPORT_VIEW, REPORT_JSON };

/* What does not change in a job. */
typedef struct {
    const char *file, *port;
    const char *tool;               /* NULL: the drawing has no tools */
    const toolpath *path;           /* NULL: unknown */
    double tol;                     /* mm, planned */
    uint32_t id;                    /* 0: the machine keeps none */
} report_job;

/* True if the pen is down in this move of the path. */
static inline bool report_draws(const report_job *of, size_t move)
{
    return of->path != NULL && move < of->path->count && of->path->curve[move] != TOOLPATH_TRAVEL;
}

/* Prepare this form. From then on, standard output is that of a program that reads JSON: what is
 * printed for people goes to standard error. Returns 0, or an exit code after printing one line. */
int report_start(enum report_form form);

/* A job begins: `job` must stay. */
void report_begin(const report_job *job);

/* Tell of a job that is planned and not sent. */
void report_planned(const report_job *job, double seconds, uint32_t items);

/* Show this, at most ten times a second. The bar is a line of standard error, as `words`. */
void report_show(const send_facts *f, const char *words);

/* True if the state is shown, so that a line about it would repeat it. */
bool report_shown(void);

/* Take a key of the terminal: ^L paints the whole screen anew. Returns the key, or 0 if it is none
 * of the job. */
int report_key(int key);

/* Tell an event in one line. */
void report_line(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The job is over, or its terminal is needed for a line. */
void report_end(void);

/* Take what a job holds: the last line of JSON has the worst of all jobs. `distance` is that of the
 * motion from the drawing, mm, and `of` what it may be there. */
void report_certified(const certify *c, double distance, double of);

/* The last line of JSON: the exit code, and what is certified. Returns the code. */
int report_exit(int code);

#endif
