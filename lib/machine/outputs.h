/* lib/machine/outputs.h -- outputs: a laser, a spindle, relays, in step with the path
 * SPDX-License-Identifier: MIT
 *
 * An action among the spans (action_code.h) sets the level of an output from its tick on. The level
 * is constant, or in proportion to the speed of the machine as it moves, whatever slows it down: a
 * laser then gives the same energy to each mm of the path. Time that stands still gives none.
 *
 *     loft_outputs_begin, _take, _aim, _prepare   a tick is prepared
 *     loft_outputs_run                            the prepared tick begins
 */
#ifndef LOFT_MACHINE_OUTPUTS_H
#define LOFT_MACHINE_OUTPUTS_H

#include "wire/action_code.h"   /* loft_action */

LOFT_BEGIN_C

#if LOFT_MACHINE_OUTPUTS

/* The struct is complete so that it can be static; the fields may change without notice. */
typedef struct {
    struct {
        uint32_t order;             /* the level, or that for a mm in a tick */
        uint16_t next;              /* level of the prepared tick */
        volatile uint16_t now;      /* of the running tick */
        uint8_t  mode;              /* see outputs.c */
    } output[LOFT_MACHINE_OUTPUTS];
    uint8_t runs;                   /* ticks that began to run, modulo 256 */
    int32_t place[LOFT_AXES];       /* raw mm, at the end of the prepared tick */
    int32_t by[LOFT_AXES];          /* raw mm, in that tick */
} loft_outputs;

/* All off; the machine is at `place`, raw Q16.16 mm. */
void loft_outputs_init(loft_outputs *o, const int32_t place[LOFT_AXES]);

/* All off. */
void loft_outputs_clear(loft_outputs *o);

/* Obey the action of an output.
 *
 *   range   1 <= action->output <= LOFT_MACHINE_OUTPUTS
 *   error   a level in proportion to speed: one part in level * 60 tick_hz / feed */
void loft_outputs_take(loft_outputs *o, const loft_action *action, uint16_t tick_hz);

/* A tick is prepared: no axis moves in it, but for those that are aimed. */
void loft_outputs_begin(loft_outputs *o);

/* The tick that is prepared ends at `place` on this axis, raw Q16.16 mm. */
static inline void loft_outputs_aim(loft_outputs *o, int axis, int32_t place)
{
    o->by[axis]    = (int32_t)((uint32_t)place - (uint32_t)o->place[axis]);
    o->place[axis] = place;
}

/* A tick is prepared that lasts `lasts` slots, and `slots` at pace 1.
 *
 *   error   of a level in proportion to speed: that of its length, 2^-9 of itself, for 1/16 raw
 *   cost    a square root of 32 bits, and for each such output a product and a quotient */
void loft_outputs_prepare(loft_outputs *o, uint16_t slots, uint16_t lasts);

/* The prepared tick runs. */
void loft_outputs_run(loft_outputs *o);

/* Time stands still. */
void loft_outputs_rest(loft_outputs *o);

/* The level of output number `output`, from 1, in the running tick; 0 if there is none. */
static inline uint16_t loft_outputs_now(const loft_outputs *o, int output)
{
    return output > 0 && output <= LOFT_MACHINE_OUTPUTS ? o->output[output - 1].now : 0;
}

/* True if it is off while time stands still, as a laser is. */
bool loft_outputs_moving(const loft_outputs *o, int output);

#else       /* a machine without outputs takes no actions */

typedef struct {
    uint8_t none;
} loft_outputs;

static inline void loft_outputs_init(loft_outputs *o, const int32_t place[LOFT_AXES])
{
    (void)o;
    (void)place;
}
static inline void loft_outputs_clear(loft_outputs *o)      { (void)o; }
static inline void loft_outputs_begin(loft_outputs *o)      { (void)o; }
static inline void loft_outputs_run(loft_outputs *o)        { (void)o; }
static inline void loft_outputs_rest(loft_outputs *o)       { (void)o; }
static inline void loft_outputs_take(loft_outputs *o, const loft_action *action, uint16_t tick_hz)
{
    (void)o;
    (void)action;
    (void)tick_hz;
}
static inline void loft_outputs_aim(loft_outputs *o, int axis, int32_t place)
{
    (void)o;
    (void)axis;
    (void)place;
}
static inline void loft_outputs_prepare(loft_outputs *o, uint16_t slots, uint16_t lasts)
{
    (void)o;
    (void)slots;
    (void)lasts;
}
static inline uint16_t loft_outputs_now(const loft_outputs *o, int output)
{
    (void)o;
    (void)output;
    return 0;
}

static inline bool loft_outputs_moving(const loft_outputs *o, int output)
{
    (void)o;
    (void)output;
    return false;
}

#endif

LOFT_END_C

#endif
