/* ports/switches.h -- limit switches, the emergency stop and buttons: what counts is a switch that closes and stays closed
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SWITCHES_H
#define LOFT_SWITCHES_H

#include "machine/machine.h"    /* loft_machine_control */

#define LOFT_SWITCH_ABORT   1   /* limits and emergency stop: the job ends, on its path */
#define LOFT_SWITCH_HOLD    2
#define LOFT_SWITCH_RESUME  4

/* Of inputs 0..2 limits, 3 abort, 4 hold, 5 resume, a bit each, 1: closed. */
static inline uint8_t loft_switches_of(uint32_t closed)
{
    return (uint8_t)((closed & 0x0F ? LOFT_SWITCH_ABORT : 0) | (closed & 0x10 ? LOFT_SWITCH_HOLD : 0) | (closed & 0x20 ? LOFT_SWITCH_RESUME : 0));
}

#define LOFT_SWITCHES_SAME  4   /* samples that must agree */

typedef struct {
    uint8_t last, steady, same;
    bool    known;              /* has there been a steady state? What is closed from the start hinders no job. */
} loft_switches;

/* Those of `now` that have just closed for good. Call it about once per millisecond. */
static inline uint8_t loft_switches_closed(loft_switches *s, uint8_t now)
{
    const uint8_t before = s->steady;

    s->same = now == s->last ? (uint8_t)(s->same + (s->same < LOFT_SWITCHES_SAME)) : 1;
    s->last = now;
    if (s->same < LOFT_SWITCHES_SAME)
        return 0;
    s->steady = now;
    if (!s->known) {
        s->known = true;
        return 0;
    }
    return (uint8_t)(now & ~before);
}

/* Do what they ask for. */
static inline void loft_switches_act(loft_machine *m, uint8_t closed)
{
    if (closed & LOFT_SWITCH_ABORT)
        loft_machine_control(m, LOFT_ABORT);
    else if (closed & LOFT_SWITCH_HOLD)
        loft_machine_control(m, LOFT_HOLD);
    else if (closed & LOFT_SWITCH_RESUME)
        loft_machine_control(m, LOFT_RESUME);
}

#endif
