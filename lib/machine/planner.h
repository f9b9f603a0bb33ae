/* lib/machine/planner.h -- the planner: curves of a job become the spans that the drive executes
 * SPDX-License-Identifier: MIT
 *
 * It runs in the main loop. The machine pushes curves as they arrive and takes spans while the
 * drive has room:
 *
 *     curves -> loft_plan (a ring of the caller's memory) -> spans -> queue of the drive
 *
 * A span that depends on curves yet to come is not given. Then the queue runs low and the drive
 * slows down on the path, as with a slow sender. So late curves cost time, but no stop is planned
 * for them, unless the ring is too short to brake in.
 */
#ifndef LOFT_MACHINE_PLANNER_H
#define LOFT_MACHINE_PLANNER_H

#include "motion/plan.h"    /* loft_plan                                            */
#include "wire/receiver.h"  /* loft_machine_info, loft_item, loft_job_limits              */

LOFT_BEGIN_C

#if LOFT_MACHINE_PLANS && LOFT_FRAME_MAX < 31 + 16 * LOFT_AXES
#error "a machine that plans takes a JOB of curves: LOFT_FRAME_MAX must be >= 31 + 16 * LOFT_AXES"
#endif

/* Spans that the drive may hold unexecuted outside its queue: the running one, and the one whose
 * first tick is prepared. */
#define LOFT_PLANNER_AHEAD 3

enum loft_patch_state {
    LOFT_PATCH_NONE,            /* the job has none so far */
    LOFT_PATCH_GATHERED,        /* parts are missing */
    LOFT_PATCH_CUT,             /* it has curves to give */
    LOFT_PATCH_OVER             /* all are given, or it was refused */
};

/* What makes curves of a patch, whose parts are the last items of a job (toolpath/patches.h). */
typedef struct loft_patch_source loft_patch_source;
struct loft_patch_source {
    /* Take the next part of a patch that begins and ends at `at`.
     *
     *   shape   LOFT_REFUSAL_NONE: taken, and cut from now on if it was the last one
     *   range   LOFT_REFUSAL_ITEM: it is no part that may come now; LOFT_REFUSAL_PATCH: it cannot
     *           be cut so, or has more columns than there is memory for
     *   cost    of the last part that of loft_lines_init */
    enum loft_refusal (*take)(loft_patch_source *source, const loft_item *part, const loft_vec *at);
    /* Give the next curve and its feed, mm/min. Returns false when there is none.
     *
     *   cost    that of loft_lines_next */
    bool (*next)(loft_patch_source *source, loft_cubic *out, uint16_t *feed);
    uint16_t columns;           /* curves of a line, at most */
    uint8_t  state;             /* enum loft_patch_state; a job begins with LOFT_PATCH_NONE */
};

/* Memory of the caller. Half of the moves should be longer than the braking distance; otherwise the
 * speed is reduced. */
typedef struct {
    loft_move *moves;
    loft_knot *knots;                   /* all but 52 of them look ahead, a period each */
    uint16_t  *passed;                  /* cells of the queue + LOFT_PLANNER_AHEAD      */
    uint16_t   move_room, knot_room;
    loft_patch_source *patches;         /* NULL: it takes none */
} loft_planner_memory;

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_plan plan;
    loft_planner_memory memory;
    loft_vec at;                        /* where the last curve ends */
    uint32_t taken, executed, spans;    /* items pushed; curves known as executed; spans given */
    uint32_t parts;                     /* of a patch, among the items */
    uint16_t marks, mark;               /* places in `passed`; the place of the next span */
    bool closed, ended;                 /* no more items follow; no more curves */
    bool rests, busy, failed;           /* all are planned; a part of that has been done; a patch
                                         * led out of what can be planned */
} loft_planner;

/* Prepare, with memory for a queue of `cells` spans. A job must begin before any other call.
 *
 *   range   at least 4 moves and LOFT_PLAN_KNOTS_MIN knots; otherwise LOFT_ERR_SPACE */
enum loft_status loft_planner_init(loft_planner *p, const loft_planner_memory *memory,
                                   uint16_t cells) LOFT_CHECKED;

/* Begin a job at `start` (raw Q16.16 mm), within the lower of the machine's limits and those of the
 * job.
 *
 *   range   as loft_plan_init */
enum loft_status loft_planner_begin(loft_planner *p, const loft_machine_info *machine,
                                    const loft_job_limits *asked,
                                    const int32_t start[LOFT_AXES]) LOFT_CHECKED;

/* Append a curve, or a part of a patch: the patch is the last in its job.
 *
 *   shape   LOFT_REFUSAL_NONE: taken
 *   range   as loft_plan_push and take of the patches, and loft_planner_room is not 0; otherwise
 *           LOFT_REFUSAL_ITEM, LOFT_REFUSAL_PATCH, or LOFT_REFUSAL_KIND: it takes no patches
 *   cost    as these
 *   stack   Cortex-M4 572   Cortex-M0+ 640   ATmega328P 499   + callback */
enum loft_refusal loft_planner_push(loft_planner *p, const loft_item *item) LOFT_CHECKED;

/* No more items follow. LOFT_REFUSAL_ITEM: parts of the patch are missing. */
enum loft_refusal loft_planner_end(loft_planner *p) LOFT_CHECKED;

/* Give the next span; the drive's queue must have room for it. Returns false when there is none
 * now.
 *
 *   shape   hurry: the queue runs low. The next span may then depend on curves to come while the
 *           ring is so full that the host may be waiting too (it sends a quarter at a time, and is
 *           told of a quarter at a time). In that case the plan stops where the known curves end.
 *           A patch gives the ring one curve with each call
 *   error   rounded to 2^-16 mm, see lib/wire/codec.h
 *   cost    as loft_plan_part and next of the patches
 *   stack   Cortex-M4 2,112   Cortex-M0+ 2,524   ATmega328P 1,904   + callback */
bool loft_planner_next(loft_planner *p, bool hurry, loft_item *span);

/* True if all curves are planned, and no more follow. */
static inline bool loft_planner_done(const loft_planner *p)     { return p->ended && p->rests; }

/* True if there was no span because that takes more work: the next call goes on with it. */
static inline bool loft_planner_busy(const loft_planner *p)     { return p->busy; }

/* True if a patch has led beyond LOFT_PLAN_REACH: the job must end. */
static inline bool loft_planner_failed(const loft_planner *p)   { return p->failed; }

/* The number of items that can be pushed now; no more after a patch. */
uint16_t loft_planner_room(const loft_planner *p);

/* The number of items executed when `spans` spans are executed; parts of a patch are with the end
 * of the job. */
uint32_t loft_planner_executed(loft_planner *p, uint32_t spans);

LOFT_END_C

#endif
