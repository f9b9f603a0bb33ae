/* lib/motion/step.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/step.h"

/* Bresenham's line, per axis. After slot j = 0..n of a tick with c <= n steps in n slots
 *
 *     pulses = floor((j c + h) / n),    h = floor(n / 2)
 *
 * which is j c / n rounded to nearest: n * pulses lies in j c + h - n + 1 .. j c + h, so pulses - j c / n lies within
 * -(n - 1 - h) / n .. h / n, and both ends are at most 1/2 in size. After slot n it is c + floor(h / n) = c.
 * The remainder (j c + h) mod n is `error`; each slot
 *
 *     error += c;   if (error >= n) { error -= n; pulse }
 *
 * Room: error < n and c <= n <= 32767, so the sum stays below 2^16.
 *
 * Direction: the bits of a tick are put out in its first slot. An axis that turns must not pulse in that slot,
 * which it would do when h + c >= n; then the tick gets one slot in front for the direction alone (`lead`), for all
 * axes, so that they stay together on the line.
 */
enum loft_status loft_step_init(loft_step *s, const int32_t position[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (position[i] < -LOFT_STEP_REACH || position[i] > LOFT_STEP_REACH)
            return LOFT_ERR_RANGE;

    for (int i = 0; i < LOFT_AXES; i++) {
        s->axis[i].position = s->target[i] = position[i];
        s->axis[i].count = s->axis[i].error = 0;
    }
    s->slots = 1;
    s->left = 0;
    s->busy = 0;
    s->dir = s->target_dir = 0;
    s->changes = 0;
    s->full = 0;
    return LOFT_OK;
}

/* The difference of two positions has at most 32 bits: 2^30 + 2^30 = 2^31, taken as unsigned. */
uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots)
{
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
        s->tick.count[i] = (uint16_t)count;
        s->target[i] = target[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        if ((turned & (1u << i)) && slots / 2u + s->tick.count[i] >= slots)
            lead = true;

    s->tick.slots = slots;
    s->tick.dir = s->target_dir = dir;
    s->tick.lead = lead;
    s->full = 1;
    return (uint16_t)(slots + lead);
}

#define ALL_AXES (1u << LOFT_AXES)

static void take_tick(loft_step *s)
{
    const uint16_t slots = s->tick.slots;

    for (int i = 0; i < LOFT_AXES; i++) {
        s->axis[i].count = s->tick.count[i];
        s->axis[i].error = (uint16_t)(slots / 2u);
    }
    s->slots = slots;
    s->left = slots;
    s->busy = 1;
    s->dir = s->tick.dir;
    s->full = 0;
}

loft_pins loft_step_next(loft_step *s)
{
    loft_pins pins = { 0, 0 };

    if (s->left == 0 && s->full) {
        const bool lead = s->tick.lead;
        take_tick(s);
        pins.dir = s->dir;
        if (lead)
            return pins;
    }
    pins.dir = s->dir;
    if (s->left == 0)
        return pins;

    const uint16_t slots = s->slots;
    loft_step_axis *axis = s->axis;
    uint8_t bit = 1;
    do {
        uint16_t error = (uint16_t)(axis->error + axis->count);
        if (error >= slots) {
            error = (uint16_t)(error - slots);
            pins.step |= bit;
            if (pins.dir & bit)
                axis->position--;
            else
                axis->position++;
        }
        axis->error = error;
        axis++;
        bit = (uint8_t)(bit << 1);
    } while (bit != ALL_AXES);
    if (pins.step)
        s->changes++;
    if (--s->left == 0)
        s->busy = 0;
    return pins;
}

void loft_step_position(const loft_step *s, int32_t position[LOFT_AXES])
{
    uint8_t changes;

    do {
        changes = s->changes;
        for (int i = 0; i < LOFT_AXES; i++)
            position[i] = s->axis[i].position;
    } while (changes != s->changes);
}

/* |mm * steps_per_mm| <= 32768^2 = 2^30: within an acc in every number type, and within LOFT_STEP_REACH. */
int32_t loft_steps_of(loft_real mm, loft_real steps_per_mm)
{
    return loft_acc_int(loft_prod(mm, steps_per_mm));
}
