/* tests/target/arm_stream.h -- a model of a timer whose requests let DMA write to pins, and of the
 * pins
 * SPDX-License-Identifier: MIT
 *
 * The timer counts from 0 to its reload value; it updates when it begins again, and compares on the
 * way. Each of the two is a request, if DIER says so (RM0090, 17.3; RM0008, 14.3: TIM1). A request
 * lets an enabled transfer write one word to the register at PAR; the counter NDTR goes down, at 0
 * it begins again with the first word (circular), and flags are set at one half and at the end. A
 * stream of the STM32F4 in direct mode reads each word when the one before is written (RM0090,
 * 10.3.7: it preloads one), the first when it is enabled; a channel of the others when it writes it
 * (RM0008, 13.3). What a transfer takes on the bus is not modelled.
 *
 * The update can also interrupt (RM0444, 22.3: TIM1), as long as its flag stands: then the core
 * writes the pins.
 *
 * BSRR sets pins by its low half and clears pins by its high half; to set wins (RM0090, 8.4.7).
 */
#ifndef TARGET_ARM_STREAM_H
#define TARGET_ARM_STREAM_H

#include "arm_core.h"
#include "host/record.h"    /* struct host_record */

enum { UPDATE, COMPARE, REQUESTS };

struct arm_transfer {
    bool enabled, increments, half_asks, end_asks;
    uint32_t count, left, to, from, fetched;
    uint32_t flags;                     /* 1: half, 2: end */
};

struct arm_pins {
    struct host_record record;
    uint16_t now;                       /* 0..2 step, 3..5 direction */
    uint64_t rose[LOFT_AXES], fell[LOFT_AXES], turned[LOFT_AXES];
    uint64_t pulses[LOFT_AXES];
    uint64_t pulse_least, pulse_most, setup_least, hold_least, low_least, between_least;
    uint64_t first, last;               /* pulse of any axis */
};

struct arm_stream {
    struct arm_core *core;
    bool preloads;
    unsigned irq;
    uint32_t bsrr;                      /* address */
    bool runs;
    uint32_t reload, compare, requests; /* requests: bit of UPDATE, of COMPARE */
    uint64_t begun;                     /* the cycle at which the timer was 0 */
    uint32_t stands;                    /* its count while it stands */
    bool compared;                      /* since it was 0 */
    bool interrupts, updated;           /* at the update; its flag */
    uint32_t waits;                     /* how often the firmware let it stand */
    struct arm_transfer transfer[REQUESTS];
    struct arm_pins pins;
    void (*pulse)(void *context);       /* CALLBACK: a pulse has begun */
    void *context;
};

void arm_stream_init(struct arm_stream *s, struct arm_core *core);

/* All requests up to the cycle `now`; when the next interrupt comes. */
void arm_stream_advance(struct arm_stream *s, uint64_t now);
uint64_t arm_stream_next(const struct arm_stream *s);

/* The firmware lets the timer run or stand; enables a transfer. */
void arm_stream_run(struct arm_stream *s, bool runs, uint64_t now);
void arm_stream_enable(struct arm_stream *s, int which, bool enabled);

/* A write to BSRR. */
void arm_pins_write(struct arm_stream *s, uint32_t word, uint64_t when);

#endif
