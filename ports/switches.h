/* ports/switches.h -- limit switches, the emergency stop and buttons, debounced
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SWITCHES_H
#define LOFT_SWITCHES_H

#include "machine/machine.h"    /* LOFT_INPUT_ENDS */

/* The LOFT_INPUT_ bits of seven inputs, one bit each, 1: closed. Bits 0..2 are the limits of x, y,
 * z, one for both ends, 3 is the emergency stop, 4 hold, 5 resume, 6 a probe. */
static inline uint16_t loft_switches_of(uint32_t closed)
{
    return (uint16_t)((closed & 1 ? LOFT_INPUT_ENDS(0) : 0) |
                      (closed & 2 ? LOFT_INPUT_ENDS(1) : 0) |
                      (closed & 4 ? LOFT_INPUT_ENDS(2) : 0) | (closed & 0x78) << 9);
}

#define LOFT_SWITCHES_SAME  4   /* samples that must agree */

typedef struct {
    uint16_t last;
    uint8_t  same;
} loft_switches;

/* True if the state `now` is steady. Call it about once per millisecond. */
static inline bool loft_switches_steady(loft_switches *s, uint16_t now)
{
    s->same = now == s->last ? (uint8_t)(s->same + (s->same < LOFT_SWITCHES_SAME)) : 1;
    s->last = now;
    return s->same == LOFT_SWITCHES_SAME;
}

#endif
