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
 * A whole percentage p lies up to half a level beside its own. At that level, steady, a tick lasts
 * exactly slots 100 / p, and the ticks before and behind follow the levels. So the mean pace
 * changes between them by at most 0.7 of what the ramp allows if u >= 16, and 1.03 of it if u = 1:
 * at level 1 and 1.5 levels, on the way to a stop.
 *
 * In numbers: roots in Q8, first = 2 slots sqrt(J) in Q16, T in Q8. Range: first / 2^16 <= 32767 by
 * init, so first < 2^31; a level is at most 4 * 16383, so its root is below 2^16 in Q8. Error: a
 * root is rounded by at most 1/2 in Q8 and exact for 0 and 1. This is a relative error of at most
 * 2^-9 / sqrt(J) + 2^-8 / (sqrt(i) + sqrt(j)) <= 0.3 %, with the worst case J = j = 2, u = 1. The
 * division drops at most 2^-8 slot, which is not carried.
 */
#define ROOT_MAX 32767u     /* Q8: J <= 16383 */
#define NO_PERCENT 255u

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

    /* the slowest tick, 2 slots sqrt(J), lasts 32767 slots at most */
    const uint32_t ticks = ramp / 2u + ramp % 2u, longest = ((uint32_t)32767 << 8) / (2u * slots),
                   root = longest < ROOT_MAX ? longest : ROOT_MAX,
                   unit = (root * root >> 16) / ticks;
    if (unit == 0)
        return LOFT_ERR_RANGE;

    p->full = (uint16_t)(ticks * unit);
    p->first = ((uint32_t)slots * level_root(p->full) * 2) << 8;     /* <= 32767 << 16 */
    p->unit = (uint16_t)unit;
    p->level = p->aim = 0;
    p->root = 0;
    p->slots = slots;
    p->percent = p->carry = 0;
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

/* The whole percentage that has this level, at which a tick lasts so long, Q8: that of this
 * duration, or the next one, as half a level is less than 1 %. Without a division more. */
static uint8_t whole_percent(const loft_pace *p, uint32_t lasts)
{
    const uint32_t near = ((uint32_t)p->slots * 25600u + lasts / 2) / lasts,
                   above = p->level * (uint32_t)10000 + 5000;

    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t percent = near + (k == 0   ? 0
                                         : k == 1 ? ~(uint32_t)0
                                                  : 1),
                       x = p->full * percent * percent;
        if (percent && x < above && (x >= above - 10000 || p->level == 1))
            return (uint8_t)percent;
    }
    return NO_PERCENT;
}

uint16_t loft_pace_next(loft_pace *p)
{
    const bool steady = p->level == p->aim;
    const uint16_t before = p->root;
    uint32_t lasts;                                                                 /* Q8 */

    if (steady && p->level == p->full)
        return p->slots;
    if (steady && p->level == 0) {
        p->carry = 0;
        return 0;
    }
    if (!steady) {
        if (p->level < p->aim)
            p->level = p->aim - p->level > p->unit ? (uint16_t)(p->level + p->unit) : p->aim;
        else
            p->level = p->level - p->aim > p->unit ? (uint16_t)(p->level - p->unit) : p->aim;
        p->root = level_root(p->level);
        p->percent = 0;
    }
    if (p->percent == 0 || p->percent == NO_PERCENT) {
        lasts = p->first / ((uint32_t)before + p->root);
        if (steady && p->percent == 0)
            p->percent = whole_percent(p, lasts);
    } else {
        lasts = (uint32_t)p->slots * 25600u / p->percent;
    }
    lasts += p->carry;
    p->carry = (uint8_t)(lasts & 255u);
    return lasts < 256 ? 1 : (uint16_t)(lasts >> 8);
}
