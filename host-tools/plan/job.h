/* host-tools/plan/job.h -- a job: items for the machine, planned while it draws
 * SPDX-License-Identifier: MIT
 *
 * A job is made in portions: job_open makes the first one, job_plan the next ones while the machine
 * draws. Spans and points are kept as long as they may be asked for, so memory does not grow with
 * the drawing. Curves, for a machine that plans, are all there at once; what is planned here of
 * them is when each is due.
 */
#ifndef LOFT_JOB_H
#define LOFT_JOB_H

#include "wire/codec.h"     /* loft_item */
#include "wire/job_id.h"    /* LOFT_ITEMS_OPEN */
#include "wire/message.h"   /* loft_job */

#include "engine/engine.h"         /* engine, engine_limits */
#include "plan/joints.h"         /* joints */

typedef struct {
    loft_item item;
    uint64_t due;               /* the ticks before it, if it is below job.timed */
} job_entry;

typedef struct {
    loft_job head;
    const kinematics *k;
    unsigned tick_hz;
    bool whole;                 /* all is planned: `count` and `ticks` are those of the job */
    size_t count;               /* items that are planned                       */
    uint64_t ticks;             /* of them; of curves those of the plan         */
    int32_t last[ENGINE_AXES];  /* where the last of them ends: raw Q16.16 mm, steps of points */
    /* ---- */
    int32_t start[ENGINE_AXES], end[ENGINE_AXES];   /* of the spans, raw        */
    job_entry *entry;           /* of items low .. count - 1                    */
    size_t low, room, timed;
    size_t first;               /* the first item that this run of the program sent, and */
    uint64_t first_due;
    joints_planning plan;
    size_t passed;              /* moves                                        */
    double done, all;           /* s of moves at their feeds: those that are passed, and all */
    int32_t steps_per_mm[ENGINE_AXES];
    loft_job_limits limits;     /* of curves; head.limits points to them        */
} job;

typedef struct {
    const engine *e;
    engine_limits limits;       /* of the motors, with tolerance and corner of the tool */
    enum loft_kind kind;
    int32_t steps_per_mm[ENGINE_AXES];      /* raw Q16.16; of points            */
} job_options;

/* Begin a job along the path as the motors go it, which must stay where it is, as must *j. Looks at
 * all moves, and plans the first portion. The id is a CRC of the path as the motors go it, limits,
 * number type and version of this program, from which the same items are planned again, and of the
 * first items themselves. Gives enum loft_status. Free with job_free in any case. */
int  job_open(job *j, joints *of, const job_options *o);
void job_free(job *j);

/* Plan on for some `seconds`, until the job is whole, or until enough is planned ahead of item
 * `kept`; those before it will not be asked for again. Gives enum loft_status. */
int  job_plan(job *j, size_t kept, double seconds);

/* Plan all that is left and keep nothing of it; shows a bar. Gives enum loft_status. */
int  job_finish(job *j);

/* How many items there are in all; LOFT_ITEMS_OPEN until that is known. */
uint32_t job_items(const job *j);

/* Is there something to be planned now? */
bool job_waits(const job *j, size_t kept);

/* How much of the path is planned, 0..1, and the ticks that there will be in all: an estimate until
 * the job is whole. */
double job_part(const job *j);
double job_ticks(const job *j);

/* " of 812", " of about 800" or "": how many items there are in all. */
const char *job_of(const job *j, char text[32]);

/* The first item that is sent is `first`. */
void job_sent_from(job *j, size_t first);

/* What the items are called: "spans", "points", "curves". */
const char *job_words(const job *j);

/* The items, as loft_sender asks for them. `context` is the job. */
void job_source(void *context, uint32_t index, loft_item *out);

/* The item that is due at a tick, of those that are kept, and the mean speed of the tool over it in
 * mm/s (0 for points and items that are not kept; of a curve its feed, where motors and tool are
 * one). */
size_t job_item_at(const job *j, uint64_t tick);
double job_feed(const job *j, size_t item);

/* Of all that is planned. */
double job_seconds(const job *j);

#endif
