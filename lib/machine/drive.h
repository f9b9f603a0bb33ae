/* lib/machine/drive.h -- the drive: items of a job become pulses
 * SPDX-License-Identifier: MIT
 *
 *     main loop   begin, push, end; hold, abort, override; poll; prepare: the walk of the next span
 *     tick        loft_drive_tick: queue -> span walker -> steps of the next tick; about 1 kHz
 *     slot        loft_drive_slot: the pins; about 40 kHz
 *
 * Each may interrupt the one above it. The machine never leaves the path and never stops abruptly.
 * A hold, an abort and a queue that runs low all lower the pace (pace.h) to 0. The machine then
 * stops at the end of a tick, and no item is lost. Above 100 percent the pace falls in time before
 * an item that may not pass so fast (override_limit.h).
 *
 * The law of supply: while the end of the job is not known, the pace follows the fill of the queue.
 * Pace 1 needs a quarter of the queue, or sixteen times the ticks from pace 1 to a stop, whichever
 * is less. So a line that is too slow makes the machine as slow as itself, even if items come in
 * portions. After the line is cut, the machine stops before the queue is empty. Spans that a
 * planner of this machine makes need half of that: no line delays them.
 */
#ifndef LOFT_MACHINE_DRIVE_H
#define LOFT_MACHINE_DRIVE_H

#include "machine/override_limit.h"     /* loft_override_limit_of, loft_axis_config       */
#include "machine/outputs.h"            /* loft_outputs                        */
#include "machine/points.h"             /* loft_points                         */
#include "machine/queue.h"              /* loft_queue, loft_item               */
#include "machine/pace.h"               /* loft_pace                           */
#include "machine/step.h"               /* loft_step                           */
#include "num/walk.h"                   /* loft_walk3                          */
#include "wire/message.h"               /* loft_machine_state, loft_kind       */

LOFT_BEGIN_C

#define LOFT_DRIVE_MARGIN 2     /* ticks */

typedef struct {
    const loft_axis_config *axis;       /* LOFT_AXES of them, borrowed; they may change while no
                                         * job is under way */
    int32_t  position[LOFT_AXES];       /* steps: the position at the start */
    uint16_t tick_hz, slots;            /* ticks per second, slots per tick */
    uint16_t ramp;                      /* ticks from full pace to a stop; make the queue longer */
    volatile loft_cell *cell;           /* memory of the queue */
    uint16_t cells;
    uint8_t  outputs;                   /* that actions may set, 0..LOFT_MACHINE_OUTPUTS */
} loft_drive_config;

/* A report of the drive. */
typedef struct {
    uint32_t executed;                  /* items executed entirely: all their pulses are given */
    uint32_t ticks;                     /* ticks of the plan executed */
    uint32_t elapsed;                   /* ticks of time since the job began, stops included */
    uint32_t slowed;                    /* ticks that lasted longer: their steps did not fit */
    int32_t  position[LOFT_AXES];       /* steps: the sum of all pulses */
    uint16_t room;                      /* items of the job's kind that the queue can take */
    uint8_t  state;                     /* enum loft_machine_state */
    bool     starved;                   /* the pace is down because the queue ran low */
} loft_drive_report;

/* The walk of a span. */
typedef struct {
    loft_walk3 axis[LOFT_AXES];
    uint8_t moves;                      /* bit i: axis i moves */
} loft_drive_walk;

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_step  step;                    /* slot and tick */
    uint16_t   slots, slot;             /* per tick; slots of the running tick of time */
    volatile uint32_t elapsed;

    loft_pace    pace;                  /* tick */
    loft_queue   queue;                 /* tick and main loop */
    loft_points  points;                /* in the queue, in a job of points */
    loft_outputs outputs;               /* tick */
    uint8_t      output_count;
    loft_drive_walk walk[2];            /* of this item and, when ready, of the next one */
    uint8_t      which;                 /* walk[which] is the current walk */
    volatile uint8_t ready, ready_item; /* main loop: walk[!which] is prepared, for this item */
    volatile uint8_t item;              /* number of the next item, modulo 256 */
    volatile int32_t from[LOFT_AXES];   /* where the next item begins: raw mm or steps */
    int32_t      target[LOFT_AXES];     /* steps at the end of the last prepared tick */
    uint32_t     ahead;                 /* ticks in the queue, and of the current item */
    uint16_t     left;                  /* ticks of the current item */
    uint8_t      running, prepared;     /* kinds of these two ticks: see drive_tick.c */
    uint8_t      limit;                 /* override limit of the current item */
    uint8_t      obeyed;                /* percent */
    uint16_t     ordered;               /* the level of that percentage */
    uint16_t     supply;                /* the level that the fill of the queue allows */
    volatile uint32_t executed, ticks, slowed;
    volatile uint8_t  state, starved;

    volatile uint8_t active;            /* main loop sets it: a job is under way; tick clears it */
    volatile uint8_t hold, abort, ended, percent;
    volatile uint8_t halt;              /* the abort is one at once */
    uint8_t  kind;                      /* LOFT_CURVES: spans that are made here */
    bool     fresh;                     /* main loop: nothing is pushed yet */
    int32_t  end[LOFT_AXES];            /* main loop: the end of the last pushed item */
    const loft_axis_config *axis;
    uint16_t ramp, tick_hz;
    int32_t  table[2][LOFT_AXES];       /* main loop: its low and its high end, steps */
    uint8_t  tabled;                    /* bit i: axis i has one */
    uint16_t share;                     /* law of supply: ticks that an item is worth */
    uint16_t gain;                      /* law of supply: pace per tick, 2^-20 */
} loft_drive;

/* Steps per mm of an axis. */
static inline loft_real loft_drive_gear(const loft_drive *d, int axis)
{
    return loft_real_from_raw(d->axis[axis].steps_per_mm);
}

/* Prepare, idle.
 *
 *   range   steps_per_mm > 0, |position| <= LOFT_STEP_REACH, cells as in loft_queue_init, slots and
 *           ramp as in loft_pace_init; otherwise LOFT_ERR_RANGE
 *   stack   Cortex-M4 48   Cortex-M0+ 64   ATmega328P 38 */
enum loft_status loft_drive_init(loft_drive *d, const loft_drive_config *config) LOFT_CHECKED;


// Main loop
// ---------

/* Begin a job of items of `kind` at `start` (spans: raw Q16.16 mm; points: steps); LOFT_CURVES: of
 * spans that a planner makes of curves here. The job begins without a hold and at 100 percent.
 *
 *   range   no job is under way, otherwise LOFT_ERR_ARG; `start` equals the machine's position to
 *           the step, otherwise LOFT_ERR_RANGE */
enum loft_status loft_drive_begin(loft_drive *d, enum loft_kind kind,
                                  const int32_t start[LOFT_AXES]) LOFT_CHECKED;

/* Say where the machine stands: axis i, of bit i of `axes`, is at position[i] steps.
 *
 *   range   no job is under way, otherwise LOFT_ERR_ARG; that of loft_step_place */
enum loft_status loft_drive_place(loft_drive *d, uint8_t axes,
                                  const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Say where the table begins (`end` 0) or ends (1), on the axes of `axes`: at position[i] steps.
 * Its begin lifts a table that was there, its end makes it count, until the machine restarts. When
 * the machine is placed, the table stays where it is, and gets other coordinates.
 *
 *   range   no job is under way, otherwise LOFT_ERR_ARG */
enum loft_status loft_drive_table(loft_drive *d, int end, uint8_t axes,
                                  const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* True if the item that is pushed next ends on the table, or leads back to it. Between its ends a
 * span may bend outwards, by at most acceleration * time^2 / 8.
 *
 *   cost    two products per axis that has a table */
bool loft_drive_inside(const loft_drive *d, const loft_item *item);

/* Append an item. An item is ignored when the job is over or being aborted. An action lasts one
 * tick. Before a pause the plan must come to rest: the machine stops there, as in a hold, until it
 * is resumed. All outputs are off before and after a job.
 *
 *   range   no axis goes faster than LOFT_STEP_SLOTS_MAX steps per tick, otherwise LOFT_ERR_RANGE
 *           (for spans the hull of the cubic counts, which may be three times as fast as the
 *           cubic); an action is of an output that is there; room, otherwise LOFT_ERR_SPACE */
enum loft_status loft_drive_push(loft_drive *d, const loft_item *item) LOFT_CHECKED;

/* No more items follow. The job is done when all are executed. */
void loft_drive_end(loft_drive *d);

/* Slow down on the path and stop (true), or continue (false). */
void loft_drive_hold(loft_drive *d, bool hold);

/* Slow down on the path and stop; the job is then over. */
void loft_drive_abort(loft_drive *d);

/* Stop at once: from the next slot on there is no pulse; see LOFT_MACHINE_SLOT_HALTS. The job is
 * then over, and the position is the sum of the pulses; but a fast motor may go on by itself. The
 * tick may call it too, and loft_drive_abort. */
void loft_drive_halt(loft_drive *d);

/* Set the override: 1..200 percent of the plan, until the next job begins. Above 100 the machine
 * goes only so fast that no axis exceeds its limits. That includes queued items. For points there
 * is no pace above 100. */
void loft_drive_override(loft_drive *d, unsigned percent);

/* The report is read: a job that is over becomes LOFT_STATE_IDLE. No effect while a job is under
 * way. */
void loft_drive_close(loft_drive *d);

/* Prepare the walk of the next span, if it is not prepared: 7,800 cycles on an AVR with two moving
 * axes. Otherwise loft_drive_tick spends them at the beginning of the span, or waits: see
 * LOFT_MACHINE_TICK_PREPARES. Spans of one or two ticks need no walk; the function looks past up to
 * 7 of them. Call it repeatedly. */
void loft_drive_prepare(loft_drive *d);

/* True if a short span will soon need a walk that cannot be prepared yet. Then the main loop does
 * nothing long before it calls loft_drive_prepare again. */
bool loft_drive_pressed(const loft_drive *d);

/* Read the report. When state is DONE or ABORTED, it is final. */
loft_drive_report loft_drive_poll(loft_drive *d);


// Tick and slot
// -------------

/* Make the next tick. There must be room for it. */
void loft_drive_next(loft_drive *d);

/* Make the next tick if there is room for it. Call it after every slot, or at least once per tick.
 *
 *   cost    if there is room: LOFT_AXES steps of a walk, LOFT_AXES products and loft_step_load;
 *           while the pace changes, loft_pace_next; at a new span the work of loft_drive_prepare,
 *           if that was not done */
static inline void loft_drive_tick(loft_drive *d)
{
    if (d->active && loft_step_room(&d->step))
        loft_drive_next(d);
}

/* The level of output number `output`, from 1, in the tick that runs. Call it after
 * loft_drive_tick, in its context; 0 if there is no such output. */
static inline uint16_t loft_drive_output(const loft_drive *d, int output)
{
    return loft_outputs_now(&d->outputs, output);
}

/* Give the pins of this slot.
 *
 *   cost    loft_step_next and a 16-bit count
 *   stack   Cortex-M4 88   Cortex-M0+ 148   ATmega328P 55 */
loft_pins loft_drive_slot(loft_drive *d);

/* Take the next slots, for loft_step_give: see loft_step_take.
 *
 *   stack   Cortex-M4 88   Cortex-M0+ 148   ATmega328P 55 */
loft_step_tick *loft_drive_take(loft_drive *d, uint8_t *count, uint8_t *dir);

LOFT_END_C

#endif
