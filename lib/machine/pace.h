/* lib/machine/pace.h -- pace: time is stretched, the path is never left
 * SPDX-License-Identifier: MIT
 *
 * Time runs at a pace r of 0 (standing) to 1 (as planned) and on to 2. A tick that lasts `slots`
 * step slots at pace 1 lasts slots / r of them; the sequence of positions is the same. Hold,
 * resume, override and starvation are nothing but an aim for the pace.
 *
 * The law: the pace changes by 1 in `ramp` ticks of real time, evenly. Where the plan moves with
 * speed v, acceleration a and jerk j, the machine moves with r v and r^3 j, and with r^2 a and,
 * while the pace changes, v / ramp (per tick) more. From pace 1 the machine stands after ceil(ramp
 * / 2) ticks of the plan, from pace 2 after four times as many, exactly at the end of a tick.
 *
 * The state is the level, from which follows how many ticks of the plan pass until time stands
 * still if that is the aim from now on: level / unit, rounded up. The level changes by at most
 * `unit` per tick; r^2 is level / full, where `full` is the level of pace 1. The slowest pace is
 * sqrt(1 / full).
 *
 * loft_pace_next belongs to the context that prepares ticks (span.h has the order of calls), and
 * only it changes the level; loft_pace_aim may be called from any, where 16 bits are stored at
 * once. 16 bytes.
 */
#ifndef LOFT_MACHINE_PACE_H
#define LOFT_MACHINE_PACE_H

#include "num/num.h"    /* loft_status */

LOFT_BEGIN_C

#define LOFT_PACE_SLOTS_MAX 4096
#define LOFT_PACE_RAMP_MAX  32766
#define LOFT_PACE_MOST      200     /* percent */

/* Complete so that it can be static; the fields may change without notice. */
typedef struct {
    uint32_t first;                 /* slots of the tick from standing to level 1, Q16          */
    uint16_t level, aim, full;      /* pace = sqrt(level / full)                                */
    uint16_t root;                  /* sqrt(level), Q8                                          */
    uint16_t slots;
    uint8_t unit;                   /* levels per tick: 1, 2, 4, 8 or 16, as many as there is room
                                     * for */
    uint8_t carry;                  /* slots owed by the ticks before, Q8 */
} loft_pace;

/* Stand still, with the aim 0.
 *
 *   range   slots per tick at pace 1: 1..LOFT_PACE_SLOTS_MAX; ramp, ticks from pace 1 to 0:
 *           1..LOFT_PACE_RAMP_MAX; slots * sqrt(2 ramp) < 32767 (the slowest tick must not exceed
 *           that), otherwise LOFT_ERR_RANGE */
enum loft_status loft_pace_init(loft_pace *p, uint16_t slots, uint16_t ramp) LOFT_CHECKED;

/* The level of the pace percent / 100.
 *
 *   cost    a 32-bit division
 *   range   percent 0..LOFT_PACE_MOST; what is more counts as that. Any percent above 0 moves at
 *           least a little. */
uint16_t loft_pace_level(const loft_pace *p, unsigned percent);

/* Aim for a level; 0 is a hold. The next tick is one level nearer.
 *
 *   range   level 0..4 loft_pace_full(p) */
static inline void loft_pace_aim(loft_pace *p, uint16_t level)  { p->aim = level; }

/* Slots that the next tick lasts; 0 while time stands still.
 *
 *   error   1 slot and 0.3 % of the law above; fractions are carried to the next tick; at pace 1
 *           none; never below 1 slot
 *   cost    steady at pace 0 and 1 nothing, else one 32-bit division and one 32-bit square root: at
 *           most 1,500 cycles of an ATmega328P, 170 instructions of a Cortex-M4 */
uint16_t loft_pace_next(loft_pace *p);

/* Ticks of the plan that pass until time stands still if the aim is 0 from now on, exactly. */
static inline uint16_t loft_pace_distance(const loft_pace *p)
{
    return (uint16_t)(((uint32_t)p->level + p->unit - 1) / p->unit);
}

/* The level of pace 1, and by how much the level may change in a tick. */
static inline uint16_t loft_pace_full(const loft_pace *p)       { return p->full; }
static inline uint8_t  loft_pace_unit(const loft_pace *p)       { return p->unit; }

LOFT_END_C

#endif
