/* host-tools/plan/job.h -- a job: the items for the machine, planned while it draws
 * SPDX-License-Identifier: MIT
 *
 * A job is planned in portions: job_open plans the first one, job_plan the next ones while the
 * machine draws. Spans and points are kept only while the machine may ask for them, so memory does
 * not grow with the drawing. Curves, for a machine that plans, are complete from the start; only
 * their due times are planned here.
 */
#ifndef LOFT_JOB_H
#define LOFT_JOB_H

#include "wire/codec.h"     /* loft_item */
#include "wire/job_id.h"    /* LOFT_ITEMS_OPEN */
#include "wire/message.h"   /* loft_job */

#include "engine/engine.h"  /* engine, engine_limits */
#include "plan/certify_along.h" /* certify_along */
#include "plan/joints.h"    /* joints */
#include "plan/levels.h"    /* levels */
#include "plan/toolpath.h"  /* toolpath */

struct host;                /* base/host.h */

/* What a machine does beside motion. */
struct job_does {
    bool actions;               /* it pauses and waits; only a job of spans */
    unsigned outputs;           /* 1: spindle or laser, 2: coolant */
    double s_max, spin_up;      /* S of full power; s until the spindle turns */
};

typedef struct {
    loft_item item;
    uint64_t due;               /* the ticks before it, if its index is below job.timed */
    size_t span;                /* the planned span that it is of, or that comes next */
} job_entry;

typedef struct {
    loft_job head;
    const kinematics *k;
    unsigned tick_hz;
    bool whole;                 /* planning is complete: `count` and `ticks` are those of the job */
    size_t count;               /* planned items, see job_ready */
    uint64_t ticks;             /* their ticks; for curves, those of the plan */
    int32_t last[ENGINE_AXES];  /* the end of the last item: raw Q16.16 mm, or steps for points */
    /* ---- */
    int32_t start[ENGINE_AXES], end[ENGINE_AXES];   /* of the spans, raw        */
    job_entry *entry;           /* of items low .. count - 1                    */
    size_t low, room, timed;
    size_t first;               /* the first item that this run of the program sent, and */
    uint64_t first_due;
    joints_planning plan;       /* of moves up to `stop`, where an event comes */
    certify_along along;        /* judges them, */
    certify judged;             /* and judged those before */
    size_t spans;               /* planned */
    size_t ready;               /* see job_ready */
    joints *of;
    const engine *e;
    engine_limits motors;
    size_t stop, event;         /* the next event */
    struct job_does does;
    bool spins;
    bool begun;                 /* the plan up to `stop` has given spans */
    levels levels;              /* of the line that is planned */
    double feed;                /* of a laser, at its level; as in toolpath_event */
    struct {
        size_t item;
        const char *text;
    } * pause;
    size_t pauses;
    size_t passed;              /* moves, and */
    uint32_t *ends;             /* of each of them: the items up to its end */
    double done, all;           /* s of moves at their feeds: passed moves, all moves */
    int32_t steps_per_mm[ENGINE_AXES];
    loft_job_limits limits;     /* of curves; head.limits points to them        */
    bool patch;                 /* the items are parts of a patch, whose moves the plan has: then
                                 * `ends` are ticks */
} job;

typedef struct {
    const engine *e;
    engine_limits limits;       /* of the motors; tolerance and corner of the tool */
    enum loft_kind kind;
    int32_t steps_per_mm[ENGINE_AXES];      /* raw Q16.16; of points            */
    struct job_does does;
    const loft_item *patch;     /* these items instead of curves: a patch that becomes the path on
                                 * the machine; NULL: none */
    unsigned parts;
} job_options;

/* A job, and the path that it is planned from. Begin with { .path = { 0 } }; it must not move while
 * it has a job. */
typedef struct {
    toolpath path;
    joints of;
    job j;
} job_work;

/* True if a job can do this on a machine with these outputs. */
bool job_can(const struct job_does *does, const drawing_event *e);

/* Begin a job along the path of the motors; the path and *j must not move. Checks all moves, and
 * plans the first portion. The id is a CRC of the path of the motors, the limits, the number type
 * and version of this program, and the first items: so the same items are planned again. Returns
 * enum loft_status. Call job_free in any case. */
int  job_open(job *j, joints *of, const job_options *o);
void job_free(job *j);

/* Free the job and its path; *w is empty then. */
void job_work_free(job_work *w);

/* A plan is judged while it is made, span after span: all but that of a machine that plans. This
 * status says that something is beyond its bound. */
#define JOB_OUTSIDE (-100)

/* And this one, that the host has stopped planning. */
#define JOB_STOPPED (-101)

/* What to say about that, or about another status that ended planning, and `then`. Returns the exit
 * code. */
int job_refuse(struct host *h, const job *j, const char *file, int status, const char *then);

/* The items that are within their bounds, with all of the path up to them: no other may be sent. */
size_t job_ready(job *j);

/* The worst so far. */
certify job_judged(const job *j);

/* How far the motion is from the drawing at most, and how far it may be there, mm; `tol` is what it
 * may be without corners. */
double job_distance(const job *j, double tol, double *of);

/* "path within 0.0036 of 0.0050 mm, 100 % of speed, 99 % of acceleration, 98 % of jerk" */
const char *job_words_of_plan(const job *j, double tol, char text[160]);

/* Continue planning for about `seconds`, until the job is complete, or until enough items after
 * `kept` are planned. Items before `kept` will not be asked for again. Returns enum loft_status. */
int  job_plan(job *j, size_t kept, double seconds);

/* Plan the rest and keep none of it; the host is told how far it is, and may stop it:
 * JOB_STOPPED. Returns enum loft_status. */
int  job_finish(struct host *h, job *j);

/* The total number of items; LOFT_ITEMS_OPEN until it is known. */
uint32_t job_items(const job *j);

/* True if planning should continue now. */
bool job_waits(const job *j, size_t kept);

/* The planned fraction of the path, 0..1, and the total number of ticks: an estimate until the job
 * is complete. */
double job_part(const job *j);
double job_ticks(const job *j);

/* The total number of items in words: " of 812", " of about 800" or "". */
const char *job_of(const job *j, char text[32]);

/* Set the first item that is sent. */
void job_sent_from(job *j, size_t first);

/* The name of the items: "spans", "points", "curves", "parts of a patch". */
const char *job_words(const job *j);

/* Give an item to loft_sender. `context` is the job. */
void job_source(void *context, uint32_t index, loft_item *out);

/* The item that is due at a tick, among those that are kept, and its mean tool speed in mm/s. The
 * speed is 0 for points and for items that are not kept; for a curve it is the feed, if motors and
 * tool coincide. Of a patch it is the move that is due. */
size_t job_item_at(const job *j, uint64_t tick);
double job_feed(const job *j, size_t item);

/* What to tell in the pause after so many items; NULL: there is none. It needs a plan up to it. */
const char *job_pause(const job *j, size_t executed);

/* The number of moves of the tool that are over after so many items; it may lag a little. */
size_t job_moves(const job *j, size_t executed);

/* The duration of everything planned. */
double job_seconds(const job *j);

#endif
