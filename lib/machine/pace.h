/* lib/machine/pace.h -- pace: time is stretched, the path is never left
 * SPDX-License-Identifier: MIT
 *
 * Time runs at a pace r from 0 (stopped) over 1 (as planned) to 2. A tick that lasts `slots` step
 * slots at pace 1 lasts slots / r of them. The sequence of positions is the same. Hold, resume,
 * override and starvation only set an aim for the pace.
 *
 * The law: the pace changes by 1 in `ramp` ticks of real time, evenly. Where the plan moves with
 * speed v, acceleration a and jerk j, the machine moves with r v, r^2 a and r^3 j. While the pace
 * changes, the acceleration is v / ramp (per tick) larger. From pace 1 the machine stops after
 * ceil(ramp / 2) ticks of the plan, from pace 2 after four times as many, exactly at the end of a
 * tick.
 *
 * The state is the level. If the aim is 0 from now on, time stops after level / unit ticks of the
 * plan, rounded up. The level changes by at most `unit` per tick. r^2 is level / full, where `full`
 * is the level of pace 1: near 10^4 up to 163 slots, so that each percentage has a level. The
 * slowest pace is sqrt(1 / full).
 *
 * Only the context that prepares ticks may call loft_pace_next, which changes the level (span.h has
 * the order of calls). Any context may call loft_pace_aim, if 16 bits are stored at once. 20 bytes.
 */
#ifndef LOFT_MACHINE_PACE_H
#define LOFT_MACHINE_PACE_H

#include "num/num.h"    /* loft_status */

LOFT_BEGIN_C

#define LOFT_PACE_SLOTS_MAX 4096
#define LOFT_PACE_RAMP_MAX  32766
#define LOFT_PACE_MAX      200     /* percent */

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    uint32_t first;                 /* slots of the tick from a stop to level 1, Q16            */
    uint16_t level, aim, full;      /* pace = sqrt(level / full)                                */
    uint16_t root;                  /* sqrt(level), Q8                                          */
    uint16_t slots;
    uint16_t unit;                  /* levels per tick                                          */
    uint8_t carry;                  /* slots carried from the ticks before, Q8                  */
} loft_pace;

/* Prepare, stopped, with the aim 0.
 *
 *   range   slots per tick at pace 1: 1..LOFT_PACE_SLOTS_MAX; ramp, ticks from pace 1 to 0:
 *           1..LOFT_PACE_RAMP_MAX; slots * sqrt(2 ramp) < 32767, the slots of the slowest tick;
 *           otherwise LOFT_ERR_RANGE */
enum loft_status loft_pace_init(loft_pace *p, uint16_t slots, uint16_t ramp) LOFT_CHECKED;

/* The level of the pace percent / 100.
 *
 *   error   up to 163 slots none if ceil(ramp / 2) divides 10,000, for other ramps up to 400 one
 *           hundredth of the pace; with more slots half a level
 *   cost    a 32-bit division
 *   range   percent 0..LOFT_PACE_MAX; more counts as that. Any percent above 0 gives at least
 *           level 1 */
uint16_t loft_pace_level(const loft_pace *p, unsigned percent);

/* Set the aim; 0 is a hold. The next tick moves toward it by at most `unit` levels.
 *
 *   range   level 0..4 loft_pace_full(p) */
static inline void loft_pace_aim(loft_pace *p, uint16_t level)  { p->aim = level; }

/* Stop at once, with the aim 0. Only where the plan stands still does no motion stop with it. */
static inline void loft_pace_stop(loft_pace *p)     { p->level = p->aim = p->root = 0; }

/* The slots that the next tick lasts; 0 while time is stopped.
 *
 *   error   1 slot and 0.3 % of the law above; fractions are carried to the next tick; at pace 1
 *           none; never below 1 slot
 *   cost    none at a steady pace of 0 or 1; otherwise one 32-bit division and one 32-bit square
 *           root: at most 1,500 cycles of an ATmega328P, 170 instructions of a Cortex-M4
 *   stack   Cortex-M4 16   Cortex-M0+ 24   ATmega328P 16 */
uint16_t loft_pace_next(loft_pace *p);

/* The exact number of ticks of the plan until time stops if the aim is 0 from now on. */
static inline uint16_t loft_pace_distance(const loft_pace *p)
{
    return (uint16_t)(((uint32_t)p->level + p->unit - 1) / p->unit);
}

/* The level of pace 1, and the largest change of the level per tick. */
static inline uint16_t loft_pace_full(const loft_pace *p)       { return p->full; }
static inline uint16_t loft_pace_unit(const loft_pace *p)       { return p->unit; }

LOFT_END_C

#endif
