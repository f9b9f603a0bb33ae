/* lib/machine/step.h -- steps: positions at ticks become step and direction bits per slot
 * SPDX-License-Identifier: MIT
 *
 * A tick lasts a number of slots. A slot is one chance to pulse each axis. The steps of a tick are
 * spread evenly over its slots. Position is the sum of the pulses: no step is lost or doubled.
 *
 * Two contexts share a loft_step. loft_step_next runs in the timer interrupt, once per slot, and is
 * short. loft_step_load prepares the tick after the running one, in the main loop or in an
 * interrupt that may itself be interrupted. They share one byte (`full`), so no lock is needed on
 * any machine with one core. span.h has the order of calls and the worst cost of each.
 */
#ifndef LOFT_MACHINE_STEP_H
#define LOFT_MACHINE_STEP_H

#include <limits.h>     /* UINT_MAX */

#include "num/num.h"    /* loft_real */

LOFT_BEGIN_C

#define LOFT_STEP_SLOTS_MAX 32767               /* slots of one tick, and steps of one axis in it */
#define LOFT_STEP_SHORT (UINT_MAX == 65535u ? 255u : 1625u)     /* slots of one that is short */
#define LOFT_STEP_REACH ((int32_t)1 << 30)      /* positions lie within +-LOFT_STEP_REACH steps */

/* The pins in one slot: bit i is axis i. */
typedef struct {
    uint8_t step;       /* pulse now */
    uint8_t dir;        /* 1: toward minus; changes at least one slot before a pulse */
} loft_pins;

/* One axis in a tick. It pulses in a slot in which phase + rate exceeds an unsigned. */
typedef struct {
    unsigned phase, rate;
    uint16_t count;                     /* pulses, at most `slots` */
    int32_t to;                         /* steps: the position at the end of the tick */
} loft_step_axis;

/* A tick. */
typedef struct {
    loft_step_axis axis[LOFT_AXES];
    unsigned first;                     /* the phase at the beginning: see step.c */
    uint16_t slots;
    uint16_t left;                      /* remaining; slots + 1: one in front for `dir` alone */
    uint8_t dir;
} loft_step_tick;

/* True if it is short: a pulse is the carry of phase + rate, and nothing is taken off the phase. */
static inline bool loft_step_short(const loft_step_tick *t) { return t->slots <= LOFT_STEP_SHORT; }

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    loft_step_tick tick[2];
    volatile uint8_t which;                     /* tick[which] runs, the other is being prepared */
    volatile uint8_t busy;                      /* the running tick has slots left */
    volatile uint8_t full;                      /* the other tick is prepared */
    volatile uint8_t changes;                   /* counts changes, for loft_step_position */
    uint32_t share;                             /* of a step in the last tick prepared: step.c */
} loft_step;

/* Prepare at `position`, with no tick.
 *
 *   range   |position| <= LOFT_STEP_REACH, otherwise LOFT_ERR_RANGE */
enum loft_status loft_step_init(loft_step *s, const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Say where the motors stand: they do not move. No tick may be prepared or running.
 *
 *   range   |position| <= LOFT_STEP_REACH, otherwise LOFT_ERR_RANGE */
enum loft_status loft_step_place(loft_step *s, const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Drop the rest of the running tick, and the prepared one: the motors stand at `position`, which is
 * within reach. In the context of loft_step_next, or while nothing calls it. */
void loft_step_halt(loft_step *s, const int32_t position[LOFT_AXES]);

/* Prepare the tick after the running one: at least `slots` slots, with the position `target` at its
 * end.
 *
 *   shape   gives the number of slots that it really lasts. This is more when the steps do not fit,
 *           or when an axis reverses and has to pulse at once. The machine is then slower than
 *           planned, and nothing is lost: the steps are spread over the slots that it lasts
 *   range   loft_step_room(s); slots 1..LOFT_STEP_SLOTS_MAX; |target| <= LOFT_STEP_REACH; no axis
 *           moves more than LOFT_STEP_SLOTS_MAX steps
 *   error   within 1/2 step of the straight line from the last target to this one, after every slot
 *   cost    a multiplication per axis, and a division where `slots` differs from that of the
 *           tick before; called from one context only
 *   stack   Cortex-M4 36   Cortex-M0+ 56   ATmega328P 39 */
uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots);

/* True if a tick may be prepared. */
static inline bool loft_step_room(const loft_step *s)       { return !s->full; }

/* True if all pulses have been given: position is then the last target. */
static inline bool loft_step_done(const loft_step *s)       { return !s->full && !s->busy; }

/* Give the pins of the next slot.
 *
 *   cost    per axis an addition and, with a pulse, a subtraction; no division, no multiplication;
 *           meant for the timer interrupt
 *   stack   Cortex-M4 40   Cortex-M0+ 56   ATmega328P 9 */
loft_pins loft_step_next(loft_step *s);

/* Take the next *count slots at once, or fewer, up to the end of a tick: *count becomes their
 * number, at least 1, and *dir the direction bits of all of them. They then count as given. Returns
 * the tick of which they are, for loft_step_give or a loop of the port's own. NULL: no pulse is in
 * them. For a port with a buffer of slots, which an interrupt of few instructions, or none, empties
 *
 *   range   *count 1..255 */
loft_step_tick *loft_step_take(loft_step *s, uint8_t *count, uint8_t *dir);

/* Give the slots that were taken: step[k] are the step bits of slot k. The state afterwards equals
 * that after as many calls of loft_step_next.
 *
 *   cost    a tenth of loft_step_next per slot and axis; an axis without steps costs nothing */
void loft_step_give(loft_step_tick *taken, uint8_t step[], uint8_t count);

/* The position: the sum of all pulses that were given, all axes of the same slot. It may be read in
 * any context.
 *
 *   cost    a multiplication per axis, in a tick of more than 255 slots (1625 where `unsigned` has
 *           32 bits) also a division; repeats the read when a slot came in between */
void loft_step_position(const loft_step *s, int32_t position[LOFT_AXES]);

/* mm to the nearest step. Sender and machine use the same rounding.
 *
 *   range   |mm| <= 32768, 0 < steps_per_mm < 32768: the result is within +-LOFT_STEP_REACH
 *   error   q16: nearest, ties upward, exactly   f32, f64: of the product as a double */
static inline int32_t loft_steps_of(loft_real mm, loft_real steps_per_mm)
{
    return loft_prod_int(mm, steps_per_mm);
}

LOFT_END_C

#endif
