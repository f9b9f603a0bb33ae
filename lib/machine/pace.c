/* lib/machine/pace.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/pace.h"

/* Even deceleration from pace 1 to 0 in `ramp` ticks of real time covers ramp / 2 ticks of the
 * plan, rounded up. Let j of J levels be left, u levels per tick. "Speed squared is proportional to
 * the distance" gives the pace
 *
 *     s(j) = sqrt(j / J),        level j = 0..4 J,      J = u ceil(ramp / 2), the field `full`
 *
 * The tick between the levels i and j passes with even acceleration. It lasts its length divided by
 * the mean of the two paces:
 *
 *     T = slots / ((s(i) + s(j)) / 2) = 2 slots sqrt(J) / (sqrt(i) + sqrt(j)),      |i - j| <= u
 *
 * So the state of the pace is a whole number that changes by at most u each tick. Mean speeds of
 * neighbouring ticks, taken at the middles of the ticks, differ by at most the acceleration 1 /
 * ramp. From a stop and to a stop no other rule is needed. More levels than one per tick allow
 * slower paces and finer aims.
 *
 * u is such that J is near 10^4: then p percent is level p^2. J is off by at most ceil(ramp / 2) /
 * 2, a steady pace by half as large a part, and the level's rounding adds no more. Where
 * ceil(ramp / 2) divides 10^4 it is exact.
 *
 * In numbers: roots in Q8, first = 2 slots sqrt(J) in Q16, T in Q8. Range: first / 2^16 <= 32767 by
 * init, so first < 2^31; a level is at most 4 * 16383, so its root is below 2^16 in Q8. Error: a
 * root is rounded by at most 1/2 in Q8 and exact for 0 and 1. This is a relative error of at most
 * 2^-9 / sqrt(J) + 2^-8 / (sqrt(i) + sqrt(j)) <= 0.3 %, with the worst case J = j = 2, u = 1. The
 * division drops at most 2^-8 slot, which is not carried.
 */
#define FULL 10000u

/* sqrt(x) rounded to nearest; x <= 65532 * 2^16. The trial below stays within 32 bits for any x. */
static uint16_t square_root(uint32_t x)
{
    uint32_t r = 0, bit = (uint32_t)1 << 30;

    while (bit > x)
        bit >>= 2;
    for (; bit; bit >>= 2) {
        const uint32_t trial = r + bit;
        r >>= 1;
        if (x >= trial) {
            x -= trial;
            r += bit;
        }
    }
    return (uint16_t)(x > r ? r + 1 : r);
}

static uint16_t level_root(uint16_t level) { return square_root((uint32_t)level << 16); }

enum loft_status loft_pace_init(loft_pace *p, uint16_t slots, uint16_t ramp)
{
    if (slots < 1 || slots > LOFT_PACE_SLOTS_MAX || ramp < 1 || ramp > LOFT_PACE_RAMP_MAX)
        return LOFT_ERR_RANGE;

    const uint32_t ticks = ramp / 2u + ramp % 2u;
    uint16_t unit = (uint16_t)((FULL + ticks / 2) / ticks);     /* 1 or more; J <= 16383 */
    uint32_t first;
    for (;; unit /= 2) {
        /* Q8; <= 2^12 * 2^15 * 2 = 2^28 */
        first = (uint32_t)slots * level_root((uint16_t)(ticks * unit)) * 2;
        if (first <= (uint32_t)32767 << 8)
            break;
        if (unit == 1)
            return LOFT_ERR_RANGE;
    }

    p->first = first << 8;
    p->full = (uint16_t)(ticks * unit);
    p->unit = unit;
    p->level = p->aim = 0;
    p->root = 0;
    p->slots = slots;
    p->carry = 0;
    return LOFT_OK;
}

/* Pace percent / 100 is the level J (percent / 100)^2; J * 4 * 10^4 < 2^30. */
uint16_t loft_pace_level(const loft_pace *p, unsigned percent)
{
    if (percent > LOFT_PACE_MAX)
        percent = LOFT_PACE_MAX;
    const uint32_t level = ((uint32_t)p->full * percent * percent + 5000) / 10000;
    return (uint16_t)(level == 0 && percent ? 1 : level);
}

uint16_t loft_pace_next(loft_pace *p)
{
    const uint16_t before = p->root;

    if (p->level == p->aim && p->level == p->full)
        return p->slots;
    if (p->level == p->aim && p->level == 0) {
        p->carry = 0;
        return 0;
    }
    if (p->level != p->aim) {
        if (p->level < p->aim)
            p->level = p->aim - p->level > p->unit ? (uint16_t)(p->level + p->unit) : p->aim;
        else
            p->level = p->level - p->aim > p->unit ? (uint16_t)(p->level - p->unit) : p->aim;
        p->root = level_root(p->level);
    }
    const uint32_t lasts = p->first / ((uint32_t)before + p->root) + p->carry;      /* Q8 */
    p->carry = (uint8_t)(lasts & 255u);
    return lasts < 256 ? 1 : (uint16_t)(lasts >> 8);
}
