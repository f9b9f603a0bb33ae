/* lib/machine/drive.h -- the drive: items of a job become pulses
 * SPDX-License-Identifier: MIT
 *
 *     main loop   begin, push, end; hold, abort, override; poll; prepare: the walk of the next span
 *     tick        loft_drive_tick: queue -> span walker -> steps of the next tick; about 1 kHz
 *     slot        loft_drive_slot: the pins; about 40 kHz
 *
 * Each may interrupt the one above it. The machine never leaves the path and never stops abruptly.
 * A hold, an abort and a queue that runs low all lower the pace (pace.h) to 0, at the end of a
 * tick,
 * and no item is lost. Above 100 percent the pace comes down in time where an item may not pass so
 * fast (override_limit.h).
 *
 * The law of supply: while the end of the job is not known, the pace follows how full the queue is.
 * Pace 1 needs a quarter of the queue, or sixteen times the ticks from pace 1 to a stop, whichever
 * is less. So a line that is too slow makes the machine as slow as itself, also where items come in
 * portions. After a line was cut, the machine stops before the queue is empty.
 */
#ifndef LOFT_MACHINE_DRIVE_H
#define LOFT_MACHINE_DRIVE_H

#include "machine/override_limit.h"    /* loft_override_limit_of, loft_axis_config       */
#include "machine/points.h" /* loft_points                         */
#include "machine/queue.h"  /* loft_queue, loft_item               */
#include "machine/pace.h"    /* loft_pace                           */
#include "machine/step.h"    /* loft_step                           */
#include "num/walk.h"       /* loft_walk3                          */
#include "wire/message.h"   /* loft_machine_state, loft_kind       */

LOFT_BEGIN_C

#define LOFT_DRIVE_MARGIN 2     /* ticks */

typedef struct {
    const loft_axis_config *axis;       /* LOFT_AXES of them, borrowed */
    int32_t  position[LOFT_AXES];       /* steps: where the machine stands */
    uint16_t tick_hz, slots;            /* ticks per second, slots per tick */
    uint16_t ramp;                      /* ticks from full pace to standing; the queue should hold
                                         * more */
    volatile loft_cell *cell;           /* memory of the queue */
    uint16_t cells;
} loft_drive_config;

/* How things stand. */
typedef struct {
    uint32_t executed;                  /* items executed entirely: all pulses of all their ticks
                                         * given */
    uint32_t ticks;                     /* ticks of the plan executed */
    uint32_t elapsed;                   /* ticks of time since the job began, standing included */
    uint32_t slowed;                    /* ticks that lasted longer because their steps did not
                                         * fit */
    int32_t  position[LOFT_AXES];       /* steps: the sum of all pulses */
    uint16_t room;                      /* items of the job's kind that the queue can take */
    uint8_t  state;                     /* enum loft_machine_state */
    bool     starved;                   /* the pace is down because the queue ran low */
} loft_drive_report;

/* The walk of a span. */
typedef struct {
    loft_walk3 axis[LOFT_AXES];
    uint8_t moves;                      /* bit i: axis i does not stand still */
} loft_drive_walk;

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_step  step;                    /* slot and tick */
    uint16_t   slots, slot;             /* per tick; slots of the running tick of time */
    volatile uint32_t elapsed;

    loft_pace    pace;                  /* tick */
    loft_queue   queue;                 /* tick and main loop */
    loft_points  points;                /* in it, in a job of points */
    loft_drive_walk walk[2];            /* of this item and, when it is ready, of the next one */
    uint8_t      which;                 /* walk[which] is being walked */
    volatile uint8_t ready, ready_item; /* main loop: walk[!which] is prepared, for this item */
    volatile uint8_t item;              /* number of the item that is taken next, modulo 256 */
    volatile int32_t from[LOFT_AXES];   /* where the next item begins: raw mm or steps */
    int32_t      target[LOFT_AXES];     /* steps at the end of the last prepared tick */
    uint32_t     ahead;                 /* ticks in the queue, and of the item being walked */
    uint16_t     left;                  /* ticks of the item being walked */
    uint8_t      running, prepared;     /* what the running and the prepared tick are: see
                                         * drive_tick.c */
    uint8_t      cap;                   /* of the item being walked */
    uint8_t      obeyed;                /* percent */
    uint16_t     ordered;               /* the level that belongs to it */
    uint16_t     supply;                /* the level that the queue is good for */
    volatile uint32_t executed, ticks, slowed;
    volatile uint8_t  state, starved;

    volatile uint8_t active;            /* main loop -> tick: a job is under way; tick -> main loop:
                                         * over */
    volatile uint8_t hold, abort, ended, percent;
    uint8_t  kind;
    bool     fresh;                     /* main loop: nothing was pushed yet */
    int32_t  end[LOFT_AXES];            /* main loop: where the last pushed item ends */
    loft_real steps_per_mm[LOFT_AXES];
    const loft_axis_config *axis;
    uint16_t ramp, tick_hz;
    uint16_t share;                     /* of the law of supply: ticks that an item is worth */
    uint16_t gain;                      /* and pace per tick, 2^-20 */
} loft_drive;

/* Stand idle.
 *
 *   range   steps_per_mm > 0, |position| <= LOFT_STEP_REACH, cells as in loft_queue_init, slots and
 *           ramp as in loft_pace_init; otherwise LOFT_ERR_RANGE */
enum loft_status loft_drive_init(loft_drive *d, const loft_drive_config *config) LOFT_CHECKED;


// Main loop
// ---------

/* Begin a job whose items are of `kind` and begin at `start` (spans: raw Q16.16 mm; points: steps).
 *
 *   range   no job is under way, otherwise LOFT_ERR_ARG; `start` is where the machine stands, to
 *           the step, otherwise LOFT_ERR_RANGE. A hold from before the job is over: it begins free,
 *           at 100 percent. */
enum loft_status loft_drive_begin(loft_drive *d, enum loft_kind kind,
                                  const int32_t start[LOFT_AXES]) LOFT_CHECKED;

/* Append an item. What comes when the job is over or being aborted is forgotten.
 *
 *   range   no axis goes faster than LOFT_STEP_SLOTS_MAX steps per tick (spans: by the hull of the
 *           cubic, which is up to three times as fast as the cubic), otherwise LOFT_ERR_RANGE;
 *           room, otherwise LOFT_ERR_SPACE */
enum loft_status loft_drive_push(loft_drive *d, const loft_item *item) LOFT_CHECKED;

/* No more items follow: the job is done when all are executed. */
void loft_drive_end(loft_drive *d);

/* Slow down on the path and stand (true), or go on (false). */
void loft_drive_hold(loft_drive *d, bool hold);

/* Slow down on the path and stand; then the job is over. */
void loft_drive_abort(loft_drive *d);

/* The pace that is aimed for when nothing is in the way: 1..200 percent of the plan, in force until
 * the next job begins. Above 100 the machine goes only as fast as no axis exceeds its limits (those
 * of a job of points are not known), for queued items too. */
void loft_drive_override(loft_drive *d, unsigned percent);

/* The job is over and its report read: LOFT_STATE_IDLE. Nothing happens while a job is under
 * way. */
void loft_drive_close(loft_drive *d);

/* Prepare the walk of the next span, if that is not done: 20,000 cycles on an AVR with two axes
 * that move, which loft_drive_tick would have to spend at the beginning of the span, or for which
 * it waits: see LOFT_MACHINE_TICK_PREPARES. Spans of one or two ticks need none: it looks behind up
 * to 7 of them. Call it again and again. */
void loft_drive_prepare(loft_drive *d);

/* How things stand; when state is DONE or ABORTED, all of it is final. */
loft_drive_report loft_drive_poll(loft_drive *d);


// Tick and slot
// -------------

/* Make the next tick, for which there is room. */
void loft_drive_next(loft_drive *d);

/* Make the next tick if there is room for it. Call it behind every slot, or at least once per tick.
 *
 *   cost    when there is room: LOFT_AXES steps of a walk, LOFT_AXES products and loft_step_load;
 *           while the pace changes, loft_pace_next; with a new span that loft_drive_prepare has not
 *           prepared, that too */
static inline void loft_drive_tick(loft_drive *d)
{
    if (d->active && loft_step_room(&d->step))
        loft_drive_next(d);
}

/* What the pins do in this slot.
 *
 *   cost    loft_step_next and a 16-bit count */
loft_pins loft_drive_slot(loft_drive *d);

/* The same for the next `count` slots at once, or fewer: see loft_step_run. */
uint8_t loft_drive_run(loft_drive *d, uint8_t step[], uint8_t count, uint8_t *dir);

LOFT_END_C

#endif
