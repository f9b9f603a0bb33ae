/* lib/motion/step.h -- steps: positions at ticks become step and direction bits per slot
 * SPDX-License-Identifier: MIT
 *
 * A tick lasts a number of slots; a slot is one chance to pulse each axis. The steps of a tick are spread evenly
 * over its slots. Position is the sum of the pulses: no step is lost or doubled.
 *
 * Two contexts share a loft_step: loft_step_next runs in the timer interrupt, once per slot, and is short;
 * loft_step_load prepares the tick after the running one, in the main loop or in an interrupt that may itself be
 * interrupted. They meet in one byte (`full`), so no lock is needed on any machine with one core.
 */
#ifndef LOFT_MOTION_STEP_H
#define LOFT_MOTION_STEP_H

#include "num/num.h"    /* loft_real */

#define LOFT_STEP_SLOTS_MAX 32767               /* slots of one tick, and steps of one axis in it    */
#define LOFT_STEP_REACH ((int32_t)1 << 30)      /* positions lie within +-LOFT_STEP_REACH steps      */

/* What the pins do in one slot: bit i is axis i. */
typedef struct {
    uint8_t step;       /* pulse now                                                                  */
    uint8_t dir;        /* 1: towards minus; changes at least one slot before the pulse that needs it */
} loft_pins;

/* A tick. */
typedef struct {
    struct {
        uint16_t count;                 /* pulses, at most `slots`                                    */
        uint16_t error;                 /* of Bresenham's line, see step.c                            */
    } axis[LOFT_AXES];
    uint16_t slots, left;               /* left: slots still to come                                  */
    uint8_t dir;
    bool lead;                          /* one slot before the first for the direction bits alone     */
} loft_step_tick;

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    volatile int32_t position[LOFT_AXES];       /* steps: the sum of all pulses so far                */
    volatile loft_step_tick tick[2];
    volatile uint8_t which;                     /* tick[which] is running, the other being prepared   */
    volatile uint8_t busy;                      /* slots are left of the running tick                 */
    volatile uint8_t full;                      /* the other tick is prepared                         */
    volatile uint8_t changes;                   /* counts slots with pulses, for loft_step_position   */
    uint8_t dir;

    int32_t target[LOFT_AXES];                  /* where the prepared tick ends                       */
    uint8_t target_dir;
} loft_step;

/* Stand at `position` with nothing prepared.
 *
 *   range   |position| <= LOFT_STEP_REACH, otherwise LOFT_ERR_RANGE */
enum loft_status loft_step_init(loft_step *s, const int32_t position[LOFT_AXES]) LOFT_CHECKED;

/* Prepare the tick that follows the running one: at least `slots` slots, at its end the position is `target`.
 *
 *   shape   gives the slots that it really lasts: more when the steps do not fit, or when an axis turns and has to
 *           pulse at once; the machine is then slower than planned, and nothing is lost
 *   range   loft_step_room(s); slots 1..LOFT_STEP_SLOTS_MAX; |target| <= LOFT_STEP_REACH; no axis moves more than
 *           LOFT_STEP_SLOTS_MAX steps
 *   error   within 1/2 step of the straight line from the last target to this one, after every slot
 *   cost    no multiplication; called from one context only */
uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots);

/* May a tick be prepared? */
static inline bool loft_step_room(const loft_step *s)       { return !s->full; }

/* Have all pulses been given? Position is then the last target. */
static inline bool loft_step_done(const loft_step *s)       { return !s->full && !s->busy; }

/* What to do in the next slot.
 *
 *   cost    per axis a 16-bit addition, comparison and subtraction and, with a pulse, a 32-bit count; no division,
 *           no multiplication; meant for the timer interrupt */
loft_pins loft_step_next(loft_step *s);

/* The same inline, for an interrupt that is not to save more registers than it uses. */
static inline loft_pins loft_step_slot(loft_step *s);

/* The position, read while the interrupt runs: all axes of the same slot.
 *
 *   cost    repeats when a pulse came in between */
void loft_step_position(const loft_step *s, int32_t position[LOFT_AXES]);

/* mm to the nearest step: the same rounding in sender and machine.
 *
 *   range   |mm| <= 32768, 0 < steps_per_mm < 32768: the result is within +-LOFT_STEP_REACH
 *   error   q16: nearest, ties upward, exactly   f32, f64: of the product as a double */
int32_t loft_steps_of(loft_real mm, loft_real steps_per_mm);


// Inline
// ------

/* One pulse counted. Most end in the lowest byte, which is why AVR has a road of its own. */
static inline void loft_step_count(volatile int32_t *position, bool back)
{
#if defined(__AVR__)
#  define LOFT_STEP_COUNT(one, upper, carry) \
        "ld %0, X\n subi %0, " one "\n st X+, %0\n " carry " 1f\n ld %0, X\n sbci %0, " upper "\n st X+, %0\n" \
        "ld %0, X\n sbci %0, " upper "\n st X+, %0\n ld %0, X\n sbci %0, " upper "\n st X+, %0\n1:"
    uint8_t byte;
    if (back)
        __asm__ volatile (LOFT_STEP_COUNT("1", "0", "brcc") : "=&d" (byte), "+x" (position) : : "memory");
    else
        __asm__ volatile (LOFT_STEP_COUNT("0xFF", "0xFF", "brcs") : "=&d" (byte), "+x" (position) : : "memory");
#  undef LOFT_STEP_COUNT
#else
    *position += back ? -1 : 1;
#endif
}

/* Axis `i` in one slot: its bit if it is to pulse. */
static inline uint8_t loft_step_axis(loft_step *s, volatile loft_step_tick *t, int i, uint8_t dir)
{
    const uint8_t bit = (uint8_t)(1u << i);
    const uint16_t count = t->axis[i].count, sum = (uint16_t)(t->axis[i].error + count);

    if (sum >= count) {
        t->axis[i].error = sum;
        return 0;
    }
    t->axis[i].error = (uint16_t)(sum - t->slots);
    loft_step_count(&s->position[i], (dir & bit) != 0);
    return bit;
}

static inline loft_pins loft_step_slot(loft_step *s)
{
    loft_pins pins = { 0, s->dir };

    if (!s->busy) {
        if (!s->full)
            return pins;
        s->which ^= 1;
        s->busy = 1;
        s->full = 0;
        pins.dir = s->dir = s->tick[s->which].dir;
        if (s->tick[s->which].lead)
            return pins;
    }
    volatile loft_step_tick *t = s->which ? &s->tick[1] : &s->tick[0];
    for (int i = 0; i < LOFT_AXES; i++)
        pins.step |= loft_step_axis(s, t, i, pins.dir);
    if (pins.step)
        s->changes++;
    const uint16_t left = (uint16_t)(t->left - 1);
    t->left = left;
    if (left == 0)
        s->busy = 0;
    return pins;
}

#endif
