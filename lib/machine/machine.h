/* lib/machine/machine.h -- the machine: bytes from the line become pulses, and answers
 * SPDX-License-Identifier: MIT
 *
 * This is the controller of every firmware and of the simulated machine. A firmware calls
 *
 *     loft_machine_init       once
 *     loft_machine_push       in the main loop, with the received bytes
 *     loft_machine_poll       in the main loop, for the next frame to send, when the line is free
 *     loft_machine_inputs     in the main loop, with the closed inputs
 *     loft_machine_sample     in the main loop or with the ticks, each ms, with the inputs as they
 *                             are, and
 *     loft_machine_sense      in each slot: for guards
 *     loft_machine_slot       in a timer interrupt, tick_hz * slots times per second, for the pins
 *     loft_machine_tick       at least once per tick, interruptible by the slots
 *
 * ports/firmware.c does so, and ports/port.h lists what it needs of a board.
 */
#ifndef LOFT_MACHINE_MACHINE_H
#define LOFT_MACHINE_MACHINE_H

#include "machine/drive.h"      /* loft_drive                    */
#include "machine/latch.h"      /* loft_latch                    */
#include "machine/planner.h"    /* loft_planner              */
#include "machine/settings.h"   /* loft_settings             */
#include "wire/receiver.h"      /* loft_receiver, loft_machine_info    */

LOFT_BEGIN_C

/* A positive constant as raw Q16.16, for the machine info. */
#define LOFT_RAW(x) ((int32_t)((x) * 65536.0 + 0.5))

typedef struct {
    loft_machine_info info;             /* init fills in `queue`, `points`, `curves`, `kinds` and
                                         * `columns` */
    int32_t  position[LOFT_AXES];       /* steps: the position at the start */
    uint16_t ramp;                      /* ticks from full pace to a stop in a hold */
    volatile loft_cell *cell;           /* the queue: LOFT_MACHINE_QUEUE cells, or any number */
    uint16_t cells;
#if LOFT_MACHINE_SQUARES
    uint16_t squares;                   /* the ends (LOFT_INPUT_ENDS) of axes that have two motors:
                                         * the low one is the switch of the first, the high one that
                                         * of the second; the port obeys loft_machine_gated */
#endif
    bool     senses;                    /* jobs may carry guards: the port calls loft_machine_sample
                                         * and loft_machine_sense */
    loft_settings settings;             /* `get` NULL: it keeps none; otherwise init puts them in
                                         * force */
#if LOFT_MACHINE_PLANS
    loft_planner *planner;              /* borrowed; NULL: none */
    loft_planner_memory plan;           /* its memory */
#endif
} loft_machine_config;

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_drive    drive;
    loft_receiver receiver;
    loft_machine_config *config;
    struct {
        uint32_t id;
        uint16_t away;                  /* the rest of it: inputs that have not opened since */
        uint8_t  kind;
    } job;                              /* under way or over */
    loft_latch    latch;                /* the guard of this job or of the last one */
    struct {
        uint16_t at;
        uint8_t  session;               /* who asked; 0: nobody */
        uint8_t  wrote;                 /* bytes; LOFT_KEPT_MOST + 1: none, there was a job */
    } set;                              /* the last SET, to be answered */
#if LOFT_MACHINE_PLANS
    loft_planner *planner;
#endif
    uint16_t      closed, ended_by;     /* closed inputs; inputs that have ended the job */
#if LOFT_MACHINE_SQUARES
    volatile uint16_t gated;            /* of a guard that squares: inputs that have closed */
#endif
    volatile uint8_t  lost;             /* bit i: the place of axis i is in doubt till LOFT_PLACE */
    uint16_t      guarded;              /* inputs that have made the guard true, */
    volatile uint8_t guard_ended;       /* 1: and the main loop has not seen it */
} loft_machine;

/* Prepare, idle and listening.
 *
 *   shape   config stays borrowed; its `queue`, `points`, `curves`, `kinds` and `columns` are
 *           filled in, and its axes and wiring are those of the settings that are kept
 *   range   that of loft_receiver_init (LOFT_ERR_ARG), of loft_drive_init (LOFT_ERR_RANGE) and of
 *           loft_planner_init (LOFT_ERR_SPACE)
 *   stack   Cortex-M4 112   Cortex-M0+ 136   ATmega328P 75   + callback */
enum loft_status loft_machine_init(loft_machine *m, loft_machine_config *config) LOFT_CHECKED;


// Main loop
// ---------

/* Take bytes from the line, and act on the frames they complete.
 *
 *   range   any bytes
 *   stack   Cortex-M4 2,344   Cortex-M0+ 2,764   ATmega328P 303   + callback */
void loft_machine_push(loft_machine *m, const uint8_t byte[], size_t count);

/* Give the next frame for the line; 0 when there is none. Call it whenever the line is free.
 *
 *   stack   Cortex-M4 2,232   Cortex-M0+ 2,652   ATmega328P 231   + callback */
size_t loft_machine_poll(loft_machine *m, uint8_t wire[LOFT_FRAME_MAX]);

/* Plan one span, or do a part of the work, if the job has curves, the queue has room and the next
 * span is certain; otherwise return false. loft_machine_push and loft_machine_poll do this once for
 * each item and frame. A main loop with spare time may call it until it returns false.
 *
 *   cost    as loft_plan_part
 *   stack   Cortex-M4 2,168   Cortex-M0+ 2,588   ATmega328P 2   + callback */
bool loft_machine_plan(loft_machine *m);

/* Set the inputs that are closed now, a sum of LOFT_INPUT_, debounced. Call it whenever they are
 * read. A closed limit switch ends the job, on its path, and the emergency stop at once; while
 * closed they let no job begin.
 * The exception is a job whose JOB names the input in `away`: it continues while the input stays
 * closed, and ends when the input opens and closes again. An input of the job's guard does neither:
 * the guard decides. A button acts when it closes. */
void loft_machine_inputs(loft_machine *m, uint16_t closed);

/* Sample the inputs for a guard: `inputs` are those that are closed in this moment, as they bounce.
 * Call it about once per millisecond, in the main loop or in the context of loft_machine_tick. The
 * job ends, on its path or at once, when its guard has come true: see latch.h.
 *
 *   stack   Cortex-M4 24   Cortex-M0+ 36   ATmega328P 6 */
void loft_machine_sample(loft_machine *m, uint16_t inputs);

/* The action of a button on the machine, as if the host had sent it. */
void loft_machine_control(loft_machine *m, enum loft_verb verb);

/* The action of a knob on the machine: see loft_drive_override. */
static inline void loft_machine_override(loft_machine *m, unsigned percent)
{
    loft_drive_override(&m->drive, percent);
}

// Interrupts
// ----------

/* See loft_drive_tick and loft_drive_slot. */
static inline void      loft_machine_tick(loft_machine *m)      { loft_drive_tick(&m->drive); }
static inline loft_pins loft_machine_slot(loft_machine *m) { return loft_drive_slot(&m->drive); }

#if LOFT_MACHINE_SQUARES

/* The inputs of motors that stand while the others of their axes go on: no step for the first motor
 * of axis i with LOFT_INPUT_LOW(i), none for the second with LOFT_INPUT_HIGH(i). Such steps count;
 * the axis is placed afterwards. */
static inline uint16_t loft_machine_gated(const loft_machine *m)
{
    return m->drive.active ? m->gated : 0;
}

/* What a guard sees of these inputs. When it squares, a motor stops at the first touch, since a
 * contact bounces, and the guard sees nothing before the last one. */
static inline uint16_t loft_machine_squared(loft_machine *m, uint16_t inputs)
{
    const loft_guard *g = &m->latch.guard;

    if (!(g->how & LOFT_GUARD_SQUARE))
        return inputs;
    m->gated = (uint16_t)(m->gated | (inputs & g->inputs));
    return m->gated == g->inputs ? m->gated : 0;
}

#else

static inline uint16_t loft_machine_gated(const loft_machine *m)
{
    (void)m;
    return 0;
}
static inline uint16_t loft_machine_squared(loft_machine *m, uint16_t inputs)
{
    (void)m;
    return inputs;
}

#endif

/* Latch the position when an input of a guard changes. `inputs` are those that are closed in this
 * slot, as they bounce. Call it after loft_machine_slot. It has an effect only while
 * loft_machine_senses. */
static inline bool loft_machine_senses(const loft_machine *m)
{
    return loft_latch_waits(&m->latch);
}
static inline void loft_machine_sense(loft_machine *m, uint16_t inputs)
{
    int32_t position[LOFT_AXES];

    if (!loft_latch_waits(&m->latch))
        return;
    inputs = loft_machine_squared(m, inputs);
    if (!loft_latch_wanted(&m->latch, inputs))
        return;
    loft_step_position(&m->drive.step, position);
    loft_latch_keep(&m->latch, position);
}

LOFT_END_C

#endif
