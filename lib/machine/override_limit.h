/* lib/machine/override_limit.h -- override limits: how much faster than planned an item may pass
 * SPDX-License-Identifier: MIT
 *
 * At a pace r a span is r times as fast. Its acceleration grows with r^2 and its jerk with r^3. The
 * override limit of a span is the largest r^2 at which no axis exceeds the limits of the machine.
 * It is never below 1: the plan is trusted.
 */
#ifndef LOFT_MACHINE_OVERRIDE_LIMIT_H
#define LOFT_MACHINE_OVERRIDE_LIMIT_H

#include "wire/receiver.h"  /* loft_axis_config, loft_item */

LOFT_BEGIN_C

/* As planned; also for points, whose acceleration is not known. */
#define LOFT_OVERRIDE_LIMIT_ONE  63
#define LOFT_OVERRIDE_LIMIT_MAX 255       /* twice as fast */

/* The override limit of a span: 63..255 means r^2 = 64/64 .. 256/64.
 *
 *   shape   from: where it begins; before: the span that ends there, NULL at rest. Speeds are those
 *           of the hull of the cubic's derivative, acceleration that at both ends, where it is
 *           largest. The result is r^2 = 1 if the velocity jumps at the beginning, and for a
 *           span that stands still: it waits, and no wait becomes shorter
 *   units   raw Q16.16 mm
 *   range   ticks 1..LOFT_SPAN_TICKS_MAX; any coordinates; a limit of 0 does not limit
 *   error   never above the exact limit, except for the rounding of the points to 2^-16 mm, which
 *           is not counted; at most 4/64 and 1.2 % below it where the limit alone (V s, A s^2, J
 *           s^3 with s seconds) would move the axis by 2^-8 mm or more, if J s < 65536 mm/s^2
 *   cost    per axis that moves three divisions and eight products of 32 bits */
uint8_t loft_override_limit_of(const loft_item *item, const int32_t from[LOFT_AXES],
                               const volatile loft_item *before,
                               const loft_axis_config axis[LOFT_AXES], uint16_t tick_hz);

/* The limit as a level of the pace: full times r^2, rounded down. `full` is the level of pace 1. */
static inline uint16_t loft_override_limit_level(uint8_t limit, uint16_t full)
{
    return (uint16_t)((uint32_t)full * ((uint16_t)limit + 1u) >> 6);
}

LOFT_END_C

#endif
