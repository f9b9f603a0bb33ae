/* lib/machine/outputs.c
 * SPDX-License-Identifier: MIT
 *
 * Let a tick move the machine by s and last T slots, where the plan has N. Its speed is s N / T per
 * tick of the plan, so the level of an output of level L at the feed f is
 *
 *     L s N / (T f)       s, f in mm per tick
 *
 * The sum of level * T over ticks is then L N / f times the way, for any T: pace, override and
 * starvation do not change the energy of a mm.
 */
#include "machine/outputs.h"

#if LOFT_MACHINE_OUTPUTS

#define FULL 0xFFFFu

/* Bits of a mode: what changes the level besides actions. */
enum {
    STANDING = 1, /* off while time stands still */
    SPEED = 2
}; /* in proportion to it: `order` is for a mm in a tick */

void loft_outputs_clear(loft_outputs *o)
{
    for (int k = 0; k < LOFT_MACHINE_OUTPUTS; k++) {
        o->output[k].order = 0;
        o->output[k].next = o->output[k].now = 0;
        o->output[k].mode                    = 0;
    }
}

void loft_outputs_init(loft_outputs *o, const int32_t place[LOFT_AXES])
{
    loft_outputs_clear(o);
    loft_outputs_begin(o);
    for (int i = 0; i < LOFT_AXES; i++)
        o->place[i] = place[i];
}

void loft_outputs_begin(loft_outputs *o)
{
    for (int i = 0; i < LOFT_AXES; i++)
        o->by[i] = 0;
}

void loft_outputs_take(loft_outputs *o, const loft_action *action, uint16_t tick_hz)
{
    const int k = action->output - 1;

    o->output[k].mode  = action->moving ? STANDING : 0;
    o->output[k].order = action->level;
    if (action->feed > 0) {
        const uint64_t per = (uint64_t)action->level * 60u * tick_hz / action->feed;
        o->output[k].order = per > UINT32_MAX ? UINT32_MAX : (uint32_t)per;
        o->output[k].mode  = STANDING | SPEED;
    }
}

bool loft_outputs_moving(const loft_outputs *o, int output)
{
    return o->output[output - 1].mode & STANDING;
}

/* A metre in a tick counts as more than any machine moves. */
#define FAR ((uint32_t)1 << 26)

static uint32_t size_of(int32_t v)
{
    const uint32_t size = v < 0 ? 0 - (uint32_t)v : (uint32_t)v;

    return size < FAR ? size : FAR;
}

/* The largest r with r * r <= x. */
static uint32_t root_of(uint32_t x)
{
    uint32_t r = 0;

    for (uint32_t bit = (uint32_t)1 << 30; bit; bit >>= 2) {
        const uint32_t trial = r + bit;
        r >>= 1;
        if (x >= trial) {
            x -= trial;
            r += bit;
        }
    }
    return r;
}

/* The way in raw mm times 16. The largest part is scaled to 11..14 bits if it is that large, so
 * that up to six squares have a sum below 2^31. */
static uint32_t way_of(const int32_t by[LOFT_AXES])
{
    uint32_t most = 0, sum = 0;
    uint8_t up = 4, down = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        if (size_of(by[i]) > most)
            most = size_of(by[i]);
    while (up && most << up >= (uint32_t)1 << 14)
        up--;
    while (most >> down >= (uint32_t)1 << 14)
        down++;
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t part = size_of(by[i]) << up >> down;
        sum += part * part;
    }
    return root_of(sum) << (4 - up) << down;
}

void loft_outputs_prepare(loft_outputs *o, uint16_t slots, uint16_t lasts)
{
    uint32_t way = 0;
    bool known   = false;

    for (int k = 0; k < LOFT_MACHINE_OUTPUTS; k++) {
        if (!(o->output[k].mode & SPEED)) {
            o->output[k].next = (uint16_t)o->output[k].order;
            continue;
        }
        if (!known)
            way = way_of(o->by);
        known = true;
        /* 2^32 * 2^36 / 2^20, of which levels up to 16 times full count */
        const uint64_t at_one = (uint64_t)o->output[k].order * way >> 20;
        uint32_t level        = at_one > 16 * FULL ? 16 * FULL : (uint32_t)at_one;
        if (lasts != slots)
            level = level * slots / lasts;
        o->output[k].next     = (uint16_t)(level > FULL ? FULL : level);
    }
}

void loft_outputs_run(loft_outputs *o)
{
    o->runs = (uint8_t)(o->runs + 1);
    for (int k = 0; k < LOFT_MACHINE_OUTPUTS; k++)
        o->output[k].now = o->output[k].next;
}

void loft_outputs_rest(loft_outputs *o)
{
    for (int k = 0; k < LOFT_MACHINE_OUTPUTS; k++)
        if (o->output[k].mode & STANDING)
            o->output[k].now = o->output[k].next = 0;
}

#endif
