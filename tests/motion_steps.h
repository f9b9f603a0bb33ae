/* tests/motion_steps.h -- spans become pulses, slot by slot, and the pulses are counted
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_STEPS_H
#define LOFT_TESTS_MOTION_STEPS_H

#include "motion/step.h"    /* loft_step, loft_steps_of */
#include "motion_spans.h"   /* spans, count             */

typedef struct {
    loft_step step;
    int32_t   pulses[LOFT_AXES];    /* counted at the pins */
} stepping;

/* All slots of a tick that ends at `target`. */
static inline void step_tick(stepping *s, const int32_t target[LOFT_AXES], uint16_t slots)
{
    uint16_t left = loft_step_load(&s->step, target, slots);

    while (left > 0) {
        uint8_t bits[64], dir;
        const uint8_t got = loft_step_run(&s->step, bits, left < 64 ? (uint8_t)left : 64, &dir);
        for (uint8_t n = 0; n < got; n++)
            for (int i = 0; bits[n] && i < LOFT_AXES; i++)
                if (bits[n] & 1u << i)
                    s->pulses[i] += dir & 1u << i ? -1 : 1;
        left = (uint16_t)(left - got);
    }
}

static inline void steps_at(loft_vec at, loft_real per_mm, int32_t target[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        target[i] = loft_steps_of(at.axis[i], per_mm);
}

/* Step through all spans with `slots` in a tick, more in some of them when `pace` draws it. Gives the number of ticks after which
 * the pulses are not those of the place, at most 1/2 step off; with those of the end 0. */
static inline unsigned steps_arrive(double steps_per_mm, uint16_t slots, arb *pace)
{
    const loft_real per_mm = real_of(steps_per_mm);
    int32_t target[LOFT_AXES];
    unsigned wrong = 0;
    loft_forward walk;
    loft_vec at = spans[0].p[0];
    stepping s = { .pulses = { 0 } };

    steps_at(at, per_mm, target);
    wrong += loft_step_init(&s.step, target) != LOFT_OK;
    for (int i = 0; i < LOFT_AXES; i++)
        s.pulses[i] = target[i];
    for (unsigned k = 0; k < count; k++) {
        wrong += loft_span_walk(&walk, &spans[k]) != LOFT_OK;
        while (loft_forward_next(&walk, &at)) {
            steps_at(at, per_mm, target);
            step_tick(&s, target, pace && arb_below(pace, 4) == 0 ? (uint16_t)(slots + arb_below(pace, 3 * slots)) : slots);
            for (int i = 0; i < LOFT_AXES; i++)
                wrong += s.pulses[i] != target[i];
        }
    }
    steps_at(chain[curves - 1].curve.p[3], per_mm, target);
    for (int i = 0; i < LOFT_AXES; i++)
        wrong += s.pulses[i] != target[i] || !loft_step_done(&s.step);
    return wrong;
}

#endif
