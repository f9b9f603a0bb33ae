/* host-tools/job.h -- a planned job: the items that go to the machine, and when each is due
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_JOB_H
#define LOFT_JOB_H

#include "wire/codec.h"     /* loft_item */
#include "wire/message.h"   /* loft_job */

#include "engine.h"         /* engine, engine_limits */
#include "joints.h"         /* joints */

typedef struct {
    loft_job head;
    loft_item *item;
    size_t count, room;
    uint64_t *tick;         /* count + 1 of them: the ticks before item i        */
    unsigned tick_hz;
    size_t first;           /* the first item that this run of the program sent  */
    int32_t start[ENGINE_AXES], end[ENGINE_AXES];       /* raw Q16.16 mm of the motors */
    const kinematics *k;
    loft_job_limits limits; /* of curves; head.limits points to them             */
} job;

/* Plan the path as the motors go it, within limits of the motors, with tolerance and corner of the tool. Gives enum loft_status. Free with
 * job_free. */
int  job_plan(job *j, const engine *e, const engine_limits *limits, const toolpath *path, const joints *of);
void job_free(job *j);

/* Turn the spans into points: one place in steps per tick. steps_per_mm is raw Q16.16. Gives enum loft_status. */
int  job_points(job *j, const int32_t steps_per_mm[ENGINE_AXES]);

/* The curves themselves, for a machine that plans; when each is due is what a plan here says. *j must stay where it is. Gives enum
 * loft_status. */
int  job_curves(job *j, const engine *e, const engine_limits *limits, const toolpath *path, const joints *of);

/* What the items are called: "spans", "points", "curves". */
const char *job_words(const job *j);

/* The items, as loft_sender asks for them. `context` is the job. */
void job_source(void *context, uint32_t index, loft_item *out);

/* The item that is due at a tick, and the mean speed of the tool over it in mm/s (0 for points; of a curve its feed,
 * where motors and tool are one). */
size_t job_item_at(const job *j, uint64_t tick);
double job_feed(const job *j, size_t item);

double job_seconds(const job *j);

#endif
