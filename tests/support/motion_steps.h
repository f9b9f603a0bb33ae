/* tests/support/motion_steps.h -- converts spans to pulses, slot by slot, and counts the pulses
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_STEPS_H
#define LOFT_TESTS_MOTION_STEPS_H

#include "machine/pace.h"           /* loft_pace                */
#include "machine/step.h"           /* loft_step, loft_steps_of */
#include "support/motion_spans.h"   /* spans, count             */

typedef struct {
    loft_step step;
    int32_t   pulses[LOFT_AXES];    /* counted at the pins */
} stepping;

/* All slots of a tick that ends at `target`. */
static inline void step_tick(stepping *s, const int32_t target[LOFT_AXES], uint16_t slots)
{
    uint16_t left = loft_step_load(&s->step, target, slots);

    while (left > 0) {
        uint8_t bits[64] = { 0 }, dir, got = left < 64 ? (uint8_t)left : 64;
        loft_step_tick *taken = loft_step_take(&s->step, &got, &dir);
        if (taken)
            loft_step_give(taken, bits, got);
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

/* The pace of a machine that is overridden, held, resumed and starved whenever `a` draws it. */
typedef struct {
    loft_pace pace;
    arb      *a;
} pacing;

static inline bool pacing_start(pacing *p, uint16_t slots, arb *a)
{
    p->a = a;
    if (loft_pace_init(&p->pace, slots, (uint16_t)(1 + arb_below(a, 100))) != LOFT_OK)
        return false;
    loft_pace_aim(&p->pace, loft_pace_level(&p->pace, 100));
    return true;
}

/* The slots of the next tick; `left` more are known to come. 0 is a deadlock, since a held pace is
 * resumed. */
static inline uint16_t pacing_next(pacing *p, unsigned left)
{
    if (arb_below(p->a, 40) == 0)
        loft_pace_aim(&p->pace, loft_pace_level(
                                    &p->pace, arb_below(p->a, 3) ? 25 + arb_below(p->a, 176) : 0));
    if (left <= loft_pace_distance(&p->pace))
        loft_pace_aim(&p->pace, 0);
    const uint16_t slots = loft_pace_next(&p->pace);
    if (slots > 0)
        return slots;
    loft_pace_aim(&p->pace, loft_pace_level(&p->pace, 25 + arb_below(p->a, 176)));
    return loft_pace_next(&p->pace);
}

/* Step through all spans with `slots` in a tick, at a pace that `a` draws (NULL: as planned).
 * Returns the number of faults: a pulse count after a tick, or at the end, that differs from the
 * rounded position, or a deadlock. */
static inline unsigned steps_arrive(double steps_per_mm, uint16_t slots, arb *a)
{
    const loft_real per_mm = real_of(steps_per_mm);
    int32_t target[LOFT_AXES];
    unsigned wrong = 0;
    loft_forward walk;
    loft_vec at = spans[0].p[0];
    stepping s = { .pulses = { 0 } };
    pacing pace = { .a = a };

    steps_at(at, per_mm, target);
    wrong += loft_step_init(&s.step, target) != LOFT_OK;
    for (int i = 0; i < LOFT_AXES; i++)
        s.pulses[i] = target[i];
    wrong += a && !pacing_start(&pace, slots, a);
    for (unsigned k = 0; k < count; k++) {
        unsigned left = spans[k].ticks;
        wrong += loft_span_walk(&walk, &spans[k]) != LOFT_OK;
        for (; loft_forward_next(&walk, &at); left--) {
            const uint16_t now =
                a ? pacing_next(&pace, k + 1 < count && arb_below(a, 50) ? 0xffff : left) : slots;
            wrong += now == 0;
            steps_at(at, per_mm, target);
            step_tick(&s, target, now);
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
