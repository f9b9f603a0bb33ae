/* tests/target/arm_stream.c
 * SPDX-License-Identifier: MIT
 */
#include "arm_stream.h"


// Pins
// ----

static void least(uint64_t *is, uint64_t x)
{
    if (x < *is)
        *is = x;
}

static void change_step(struct arm_pins *p, int axis, bool high, uint64_t when)
{
    if (!high) {
        least(&p->pulse_least, when - p->rose[axis]);
        if (when - p->rose[axis] > p->pulse_most)
            p->pulse_most = when - p->rose[axis];
        p->fell[axis] = when;
        return;
    }
    if (p->turned[axis])
        least(&p->setup_least, when - p->turned[axis]);
    if (p->pulses[axis]++) {
        least(&p->between_least, when - p->rose[axis]);
        least(&p->low_least, when - p->fell[axis]);
    }
    p->rose[axis] = p->last = when;
    if (p->first == 0)
        p->first = when;
}

void arm_pins_write(struct arm_stream *s, uint32_t word, uint64_t when)
{
    struct arm_pins *p = &s->pins;
    const uint16_t now = (uint16_t)((p->now & ~(word >> 16)) | (word & 0xFFFF));
    const unsigned changed = now ^ p->now, risen = changed & now & 7;

    p->now = now;
    for (int i = 0; i < LOFT_AXES; i++) {
        if (changed & 8u << i) {
            p->turned[i] = when;
            if (p->pulses[i])
                least(&p->hold_least, when - p->rose[i]);
        }
        if (changed & 1u << i)
            change_step(p, i, now >> i & 1, when);
    }
    if (risen) {
        host_record_slot(&p->record, when,
                         (loft_pins){ .step = (uint8_t)risen, .dir = (uint8_t)(now >> 3 & 7) });
        if (s->pulse)
            s->pulse(s->context);
    }
}


// Transfers
// ---------

static uint32_t fetch(const struct arm_stream *s, const struct arm_transfer *t)
{
    const uint32_t k = t->increments ? t->count - t->left : 0;

    return arm_core_word(s->core, t->from + 4 * k);
}

void arm_stream_enable(struct arm_stream *s, int which, bool enabled)
{
    struct arm_transfer *t = &s->transfer[which];

    if (enabled && !t->enabled) {
        t->left = t->count;
        t->flags = 0;
        if (s->preloads)
            t->fetched = fetch(s, t);
    }
    t->enabled = enabled && t->count > 0;
}

static void give_word(struct arm_stream *s, struct arm_transfer *t, uint64_t when)
{
    if (!t->enabled)
        return;
    const uint32_t word = s->preloads ? t->fetched : fetch(s, t);
    if (t->to == s->bsrr)
        arm_pins_write(s, word, when);
    if (--t->left == 0)
        t->left = t->count;
    if (s->preloads)
        t->fetched = fetch(s, t);
    if (t->left == t->count) {
        t->flags |= 2;
        if (t->end_asks)
            arm_core_raise(s->core, s->irq);
    } else if (t->left == t->count / 2) {
        t->flags |= 1;
        if (t->half_asks)
            arm_core_raise(s->core, s->irq);
    }
}


// The timer
// ---------

void arm_stream_init(struct arm_stream *s, struct arm_core *core)
{
    struct arm_pins *p = &s->pins;

    s->core = core;
    p->pulse_least = p->setup_least = p->hold_least = UINT64_MAX;
    p->low_least = p->between_least = UINT64_MAX;
}

void arm_stream_run(struct arm_stream *s, bool runs, uint64_t now)
{
    if (runs && !s->runs)
        s->begun = now - s->stands;
    if (!runs && s->runs) {
        s->stands = (uint32_t)(now - s->begun);
        s->waits++;
    }
    s->runs = runs;
}

/* The compare of a period comes before its update. */
void arm_stream_advance(struct arm_stream *s, uint64_t now)
{
    while (s->runs) {
        if (s->interrupts && s->updated)
            arm_core_raise(s->core, s->irq);
        if (!s->compared && s->begun + s->compare <= now && s->compare <= s->reload) {
            s->compared = true;
            if (s->requests & 1u << COMPARE)
                give_word(s, &s->transfer[COMPARE], s->begun + s->compare);
        }
        if (s->begun + s->reload + 1 > now)
            return;
        s->begun += s->reload + 1;
        s->compared = false;
        s->updated = true;
        if (s->requests & 1u << UPDATE)
            give_word(s, &s->transfer[UPDATE], s->begun);
    }
}

uint64_t arm_stream_next(const struct arm_stream *s)
{
    const struct arm_transfer *t = &s->transfer[UPDATE];

    if (s->runs && s->interrupts)
        return s->begun + s->reload + 1;
    if (!s->runs || !t->enabled || !(s->requests & 1u << UPDATE))
        return ARM_NEVER;
    const uint32_t half = t->count / 2, left = t->left > half ? t->left - half : t->left;
    return s->begun + (uint64_t)left * (s->reload + 1);
}
