/* lib/machine/step.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/step.h"

/* Bresenham's line, per axis. After slot j = 0..n of a tick with c <= n steps in n slots
 *
 *     pulses = floor((j c + h) / n),    h = floor(n / 2)
 *
 * This is j c / n rounded to nearest: n * pulses lies in j c + h - n + 1 .. j c + h. So pulses - j
 * c / n lies within -(n - 1 - h) / n .. h / n, and both ends are at most 1/2 in absolute value.
 * After slot n it is c + floor(h / n) = c. `error` is the remainder (j c + h) mod n, minus n,
 * modulo 2^16. So a pulse is due when a 16-bit sum wraps. Each slot does
 *
 *     error += c;   if (it has wrapped) { error -= n; pulse }
 *
 * Range: the remainder is below n, and c <= n <= 32767, so a sum wraps at most once.
 *
 * Direction: the direction bits of a tick are set in its first slot. An axis that reverses must not
 * pulse in that slot, which it would do if h + c >= n. Then the tick gets one more slot in front
 * for the direction alone (`lead`). It is for all axes, so that they stay together on the line.
 */
enum loft_status loft_step_place(loft_step *s, const int32_t position[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (position[i] < -LOFT_STEP_REACH || position[i] > LOFT_STEP_REACH)
            return LOFT_ERR_RANGE;

    for (int i = 0; i < LOFT_AXES; i++)
        s->position[i] = s->target[i] = position[i];
    return LOFT_OK;
}

enum loft_status loft_step_init(loft_step *s, const int32_t position[LOFT_AXES])
{
    if (loft_step_place(s, position) != LOFT_OK)
        return LOFT_ERR_RANGE;
    s->which = 0;
    s->busy = 0;
    s->dir = s->target_dir = 0;
    s->changes = 0;
    s->full = 0;
    return LOFT_OK;
}

/* The difference of two positions has at most 32 bits: 2^30 + 2^30 = 2^31, as unsigned. */
uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots)
{
    volatile loft_step_tick *t = &s->tick[!s->which];   /* the slot ignores it until `full` */
    uint8_t dir = s->target_dir, turned = 0;
    bool lead = false;

    for (int i = 0; i < LOFT_AXES; i++) {
        const bool back = target[i] < s->target[i];
        const uint32_t count = back ? (uint32_t)s->target[i] - (uint32_t)target[i]
                                    : (uint32_t)target[i] - (uint32_t)s->target[i];
        const uint8_t bit = (uint8_t)(1u << i);

        if (count && back != ((dir & bit) != 0)) {
            dir ^= bit;
            turned |= bit;
        }
        if (count > slots)
            slots = (uint16_t)count;
        t->axis[i].count = (uint16_t)count;
        s->target[i] = target[i];
    }
    const uint16_t half = (uint16_t)(slots / 2u), error = (uint16_t)(half - slots);
    for (int i = 0; i < LOFT_AXES; i++) {
        t->axis[i].error = error;
        if ((turned & (1u << i)) && (uint16_t)(half + t->axis[i].count) >= slots)
            lead = true;
    }
    t->slots = t->left = slots;
    t->dir = s->target_dir = dir;
    t->lead = lead;
    s->full = 1;
    return (uint16_t)(slots + lead);
}

#define ALL_AXES (1u << LOFT_AXES)

/* Begin the prepared tick. Gives false in the slot for its direction alone. */
static bool take_tick(loft_step *s)
{
    s->which ^= 1;
    s->busy = 1;
    s->full = 0;
    s->dir = s->tick[s->which].dir;
    return !s->tick[s->which].lead;
}

static void use_slots(loft_step *s, volatile loft_step_tick *t, uint8_t count)
{
    const uint16_t left = (uint16_t)(t->left - count);

    t->left = left;
    if (left == 0)
        s->busy = 0;
}

loft_pins loft_step_next(loft_step *s)
{
    loft_pins pins = { 0, 0 };

    const bool now = s->busy || (s->full && take_tick(s));
    pins.dir = s->dir;
    if (!now)
        return pins;

    volatile loft_step_tick *t = &s->tick[s->which];
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint16_t count = t->axis[i].count, sum = (uint16_t)(t->axis[i].error + count);
        const uint8_t bit = (uint8_t)(1u << i);
        t->axis[i].error = sum;
        if (sum >= count)
            continue;
        t->axis[i].error = (uint16_t)(sum - t->slots);
        pins.step |= bit;
        s->position[i] += pins.dir & bit ? -1 : 1;
    }
    if (pins.step)
        s->changes++;
    use_slots(s, t, 1);
    return pins;
}

/* Run one axis for `count` slots, all in registers. The bits go to `step`. Gives its pulses. */
static uint8_t run_axis(volatile loft_step_axis *axis, uint16_t slots, uint8_t bit, uint8_t step[],
                        uint8_t count)
{
    const uint16_t add = axis->count;
    uint16_t error = axis->error;
    uint8_t pulses = 0;

#if defined(__AVR__)
    uint8_t byte;       /* the carry of the sum is the pulse, which C cannot express */
    __asm__ volatile(
        "1: add %A[error], %A[add]\n adc %B[error], %B[add]\n brcc 2f\n sub %A[error], %A[slots]\n "
        "sbc %B[error], %B[slots]\n"
        "   ld %[byte], %a[step]\n or %[byte], %[bit]\n st %a[step], %[byte]\n inc %[pulses]\n"
        "2: adiw %[step], 1\n dec %[count]\n brne 1b\n"
        : [error] "+&r"(error), [step] "+&e"(step), [count] "+&r"(count), [pulses] "+&r"(pulses),
          [byte] "=&r"(byte)
        : [add] "r"(add), [slots] "r"(slots), [bit] "r"(bit)
        : "memory");
#else
    for (; count; count--, step++) {
        error = (uint16_t)(error + add);
        if (error < add) {
            error = (uint16_t)(error - slots);
            *step |= bit;
            pulses++;
        }
    }
#endif
    axis->error = error;
    return pulses;
}

uint8_t loft_step_run(loft_step *s, uint8_t step[], uint8_t count, uint8_t *dir)
{
    const bool now = s->busy || (s->full && take_tick(s));

    volatile loft_step_tick *t = &s->tick[s->which];
    if (!now && s->busy)                            /* the slot for the direction */
        count = 1;
    if (now && count > t->left)
        count = (uint8_t)t->left;
    for (uint8_t k = 0; k < count; k++)
        step[k] = 0;
    *dir = s->dir;
    if (!now)
        return count;
    volatile loft_step_axis *axis = t->axis;
    volatile int32_t *position = s->position;
    for (uint8_t bit = 1; bit != ALL_AXES; bit = (uint8_t)(bit << 1), axis++, position++) {
        if (axis->count == 0)
            continue;
        const int32_t pulses = run_axis(axis, t->slots, bit, step, count);
        *position += *dir & bit ? -pulses : pulses;
    }
    s->changes++;
    use_slots(s, t, count);
    return count;
}

void loft_step_position(const loft_step *s, int32_t position[LOFT_AXES])
{
    uint8_t changes;

    do {
        changes = s->changes;
        for (int i = 0; i < LOFT_AXES; i++)
            position[i] = s->position[i];
    } while (changes != s->changes);
}

/* |mm * steps_per_mm| <= 32768^2 = 2^30: within an acc in every number type, and within
 * LOFT_STEP_REACH. */
int32_t loft_steps_of(loft_real mm, loft_real steps_per_mm)
{
    return loft_acc_int(loft_prod(mm, steps_per_mm));
}
