/* host-tools/plan/parts.h -- the parts of a drawing, by the tools that draw it, and the job of each
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PARTS_H
#define LOFT_PARTS_H

#include "arrange/tools.h"      /* tools_part */
#include "plan/job.h"           /* job_work */
#include "plan/planning.h"      /* planning */

/* From which of them on it is drawn: the first one, unless a tool was asked for. */
typedef struct {
    const char *file;
    tools_part part[TOOLS_PARTS];
    size_t count, first;
} plan_parts;

/* Split a drawing that planning_read gave, which stays. Returns 0, or an exit code after one
 * message. */
int parts_find(struct host *h, const planning *p, const char *file, const drawing *d,
               const drawing *smooth, plan_parts *all);

/* How part k is drawn: before a pause the tool goes to its parking place, and stays lifted. */
toolpath_options parts_way(const planning *p, const plan_parts *all, size_t k);

/* Plan the first portion of part k, from motors at `start` of the machine `port`, for a machine
 * that plans itself (`chip`) or not. Returns 0, or an exit code after one message; call
 * job_work_free in any case. */
int parts_plan(struct host *h, const planning *p, const plan_parts *all, size_t k, const char *port,
               const double start[ENGINE_AXES], bool chip, const job_options *as, job_work *w);

#endif
