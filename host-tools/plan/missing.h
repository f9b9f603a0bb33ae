/* host-tools/plan/missing.h -- what a program asks and a machine cannot do
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MISSING_H
#define LOFT_MISSING_H

#include "plan/job.h"            /* struct job_does */
#include "arrange/tools.h"          /* tools_part */

struct host;                /* base/host.h */

typedef struct {
    const char *file;
    const tools_part *part;
    size_t count;
    bool points, chip;          /* the job is of such items: then it has no actions */
} missing_job;

/* Tell what will not be done, each kind once, with its first line. Returns 0, or what --strict
 * makes of it. */
int missing_tell(struct host *h, const missing_job *j, const struct job_does *does);

/* Refuse a program for a laser on a machine without one: it would only scan the work. Returns 0, or
 * an exit code after printing one line. */
int missing_laser(struct host *h, const missing_job *j, const struct job_does *does);

#endif
