/* host-tools/library/inside.h -- what stands behind the types of library/host.h
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_INSIDE_H
#define LOFT_HOST_INSIDE_H

#include "base/host.h"
#include "library/host.h"
#include "plan/job.h"           /* job_work */
#include "plan/planning.h"      /* planning */
#include "read/drawing.h"       /* drawing */

struct loft_host {
    host h;
    loft_host_calls calls;
};

struct loft_host_drawing {
    drawing d;
    char *file;
};

/* A drawing, prepared for planning with its options, and the job that is planned of it. */
typedef struct {
    planning p;
    const char *file;
    drawing smooth;
    job_work w;
} host_plan;

/* Read the machine and smooth the drawing. Call host_plan_free in any case; *k must not move. */
int  host_plan_start(loft_host *h, host_plan *k, loft_host_drawing *d,
                    const loft_host_plan_options *o);
void host_plan_free(host_plan *k);

/* Plan the first portion of a job from there; `as` has the limits of the motors, the steps and what
 * the machine does. */
int host_plan_job(loft_host *h, host_plan *k, const double start[ENGINE_AXES], job_options *as);

#endif
