/* tests/target/avr_meter.h -- measures an emulated chip: cycles of its interrupts, edges of its
 * pins
 * SPDX-License-Identifier: MIT
 *
 * Each cycle belongs to the innermost active context: an interrupt that is itself interrupted does
 * not count the cycles of the other.
 */
#ifndef TARGET_METER_H
#define TARGET_METER_H

#include <simavr/sim_avr.h>
#include <stdbool.h>
#include <stdint.h>

#include "avr_servo.h"
#include "host/record.h"    /* struct host_record */

enum { MAIN, SLOT, TICK, RECEIVE, CONTEXTS };

struct meter_context {
    uint64_t cycles, calls;
    uint32_t most;
};

struct meter {
    avr_t *avr;
    uint32_t tick_pc;                               /* the address where the tick begins */
    struct meter_context context[CONTEXTS];
    struct {
        uint8_t kind;
        uint16_t sp;
        uint32_t own;
    } nest[8];
    uint8_t depth;
    uint16_t deepest;                               /* the lowest stack pointer, and its program
                                                     * counter */
    uint32_t deepest_pc;
    uint32_t *profile;                              /* cycles per flash word, or NULL */

    bool armed, begun;                              /* slots are counted from the first one on; a
                                                     * pulse was seen */
    uint64_t slot_first, slot_last, slot_late;      /* cycles */
    uint32_t period;                                /* of the slots, in cycles */

    uint64_t empty, starved;                        /* slots that found the ring empty: since the
                                                     * last pulse, and before a later one */
    uint64_t low, left_least;                       /* the smallest count that a slot found:
                                                     * likewise */

    struct host_record record;
    uint8_t port, step, dir;                        /* PORTD; pulses since `when`, and their
                                                     * directions */
    uint64_t when, rose[3], turned[3], last[3];
    uint64_t pulse_least, pulse_most, setup_least, hold_least, between_least;
    uint64_t pulses[3];
    uint16_t power;                                 /* outputs at the pins: see watch_outputs */
    uint8_t coolant;
    struct avr_servo servo;
    uint64_t path[3];                               /* a hash of the order of each axis' steps */
};

/* Watch the pins of `avr`; `tick_pc` is the address of the function that the slot calls for a
 * tick. */
void meter_init(struct meter *m, avr_t *avr, uint32_t tick_pc);

/* Run one instruction. */
void meter_run(struct meter *m);

/* Record the last pulses. */
void meter_flush(struct meter *m);

/* Slots that should have begun but did not. */
uint64_t meter_missed(const struct meter *m);

#endif
