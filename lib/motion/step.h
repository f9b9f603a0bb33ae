/* lib/motion/step.h -- steps: positions at ticks become step and direction bits per slot
 * SPDX-License-Identifier: MIT
 *
 * A tick lasts a number of slots; a slot is one chance to pulse. The steps of a tick are spread evenly over
 * its slots. Position is the sum of the pulses: no step is lost or doubled.
 */
#ifndef LOFT_MOTION_STEP_H
#define LOFT_MOTION_STEP_H

#include "geom/vec.h"

/* What the pins do in one slot: bit i is axis i. */
typedef struct {
    uint8_t step;       /* pulse now                                                                */
    uint8_t dir;        /* 1: towards minus; changes at least one slot before the pulse that needs it */
} loft_pins;

typedef struct {
    int32_t position[LOFT_AXES];        /* steps, the sum of all pulses so far     */
    uint16_t count[LOFT_AXES];          /* pulses of this tick                     */
    uint16_t error[LOFT_AXES];
    uint16_t slots, slot;
    uint8_t dir;
} loft_step;

void loft_step_init(loft_step *s);

/* Begin a tick of at least `slots` slots that ends at `target` steps; gives the slots that it really lasts:
 * more if the steps (and a direction change) do not fit. Call when loft_step_done. ISR-safe. */
uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots);
bool     loft_step_done(const loft_step *s);

/* What to do in the next slot. ISR-safe. */
loft_pins loft_step_next(loft_step *s);

/* mm to the nearest step: the same rounding in sender and machine. */
int32_t loft_steps_of(loft_real mm, loft_real steps_per_mm);

#endif
