/* lib/machine/planner.h -- the planner: curves of a job become the spans that the drive executes
 * SPDX-License-Identifier: MIT
 *
 * All of it belongs to the main loop. The machine pushes curves as they come and takes spans while
 * the drive has room:
 *
 *     curves -> loft_plan (a ring of the caller's memory) -> spans -> queue of the drive
 *
 * A span that depends on curves yet to come is not given; then the queue runs low and the drive
 * slows down on the path, as with a slow sender. So curves that come late cost time, but no stop is
 * planned for them, unless the ring is too short to brake in.
 */
#ifndef LOFT_MACHINE_PLANNER_H
#define LOFT_MACHINE_PLANNER_H

#include "motion/plan.h"    /* loft_plan                                            */
#include "wire/receiver.h"  /* loft_machine_info, loft_item, loft_job_limits              */

LOFT_BEGIN_C

#if LOFT_MACHINE_PLANS && LOFT_FRAME_MAX < 27 + 16 * LOFT_AXES
#error "a machine that plans takes a JOB of curves: LOFT_FRAME_MAX must be >= 27 + 16 * LOFT_AXES"
#endif

/* Spans that the drive may hold without having executed them, beside those in its queue: the one
 * that runs, the one whose first tick is prepared. */
#define LOFT_PLANNER_AHEAD 3

/* Memory of the caller. Half of the moves must be longer than the way to stop, or the speed is held
 * down. */
typedef struct {
    loft_move       *moves;
    loft_plan_piece *pieces;            /* LOFT_PLAN_PIECES for each move, or less      */
    uint16_t        *passed;            /* cells of the queue + LOFT_PLANNER_AHEAD      */
    uint16_t move_room, piece_room;
} loft_planner_memory;

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_plan plan;
    loft_planner_memory memory;
    loft_vec at;                        /* where the last curve ends */
    uint32_t taken, told, spans;        /* curves pushed, and known to be executed; spans given */
    uint16_t marks, mark;               /* places in `passed`; the one of the next span */
    bool ended, rests;                  /* no more curves follow; all are planned */
} loft_planner;

/* Prepare, with memory for a queue of `cells` spans; a job must begin before anything else is
 * asked.
 *
 *   range   4 moves, 12 pieces at least; otherwise LOFT_ERR_SPACE */
enum loft_status loft_planner_init(loft_planner *p, const loft_planner_memory *memory,
                                   uint16_t cells) LOFT_CHECKED;

/* Begin a job at `start` (raw Q16.16 mm), within the limits of the machine and those asked for,
 * whichever are lower.
 *
 *   range   as loft_plan_init */
enum loft_status loft_planner_begin(loft_planner *p, const loft_machine_info *machine,
                                    const loft_job_limits *asked,
                                    const int32_t start[LOFT_AXES]) LOFT_CHECKED;

/* Append a curve.
 *
 *   range   as loft_plan_push; LOFT_ERR_SPACE while loft_planner_room is 0
 *   cost    as loft_plan_push */
enum loft_status loft_planner_push(loft_planner *p, const loft_item *item) LOFT_CHECKED;

/* No more curves follow. */
void loft_planner_end(loft_planner *p);

/* Give the next span, for which the drive's queue has room. Returns false when there is none now.
 *
 *   shape   hurry: the queue runs low. If then the next span depends on what comes, and so little
 *           of the ring is free that the host may be waiting too (it sends a quarter at a time, and
 *           is told of a quarter at a time), the plan stops where the known curves end
 *   error   rounded to 2^-16 mm, as lib/wire/codec.h says
 *   cost    as loft_plan_next */
bool loft_planner_next(loft_planner *p, bool hurry, loft_item *span);

/* Have all curves been planned, and do no more follow? */
static inline bool loft_planner_done(const loft_planner *p)     { return p->ended && p->rests; }

/* Curves that can be pushed now. */
static inline uint16_t loft_planner_room(const loft_planner *p) { return loft_plan_room(&p->plan); }

/* Curves executed, when so many spans are. */
uint32_t loft_planner_executed(loft_planner *p, uint32_t spans);

LOFT_END_C

#endif
