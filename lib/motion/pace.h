/* lib/motion/pace.h -- pace: time is stretched, the path is never left
 * SPDX-License-Identifier: MIT
 *
 * Time runs at a pace of 0 (standing) to 1 (as planned). A tick that lasts `slots` step slots at pace 1
 * lasts slots / pace of them. The pace itself changes at a bounded rate: from 1 to 0 in `ramp` planned
 * ticks' worth of slots, so that speed v becomes 0 with acceleration v / ramp.
 */
#ifndef LOFT_MOTION_PACE_H
#define LOFT_MOTION_PACE_H

#include "num/num.h"

typedef struct {
    uint32_t pace, target, change;      /* Q16: 65536 = as planned; change per slot, Q32 */
    uint16_t slots;
} loft_pace;

/* slots per tick at pace 1: 1..4096; ramp: ticks from pace 1 to 0, 1..32767 */
enum loft_status loft_pace_init(loft_pace *p, uint16_t slots, uint16_t ramp) LOFT_CHECKED;

/* Aim for pace percent / 100, 0..100. 0 is a hold. */
void loft_pace_aim(loft_pace *p, unsigned percent);

/* Slots that the next tick lasts; 0 when time stands still. ISR-safe. */
uint16_t loft_pace_next(loft_pace *p);

/* Ticks of the plan that pass until time stands still if the aim were 0 from now on. */
uint32_t loft_pace_distance(const loft_pace *p);

#endif
