/* tests/target/avr_core.h -- an ATmega328P in libsimavr, cycle by cycle, with a serial line of the
 * baud rate that the firmware has set
 * SPDX-License-Identifier: MIT
 */
#ifndef TARGET_AVR_CORE_H
#define TARGET_AVR_CORE_H

#include <simavr/avr_uart.h>

#include "avr_meter.h"

#define AVR_HZ 16000000

struct avr_core {
    avr_t *avr;
    avr_uart_t *uart;
    avr_irq_t *input;
    struct meter meter;
    uint32_t byte_cycles;               /* ten bits */
    uint8_t in[65536];                  /* to the chip; indices wrap */
    uint16_t in_head, in_tail, silent_at;
    uint64_t silence;                   /* cycles without a byte, before that of silent_at */
    uint64_t free_at;                   /* when the line to the chip is free again */
    uint64_t heard;                     /* cycle of the last byte either way */
    uint64_t received, given, overruns;
    void (*out)(void *context, uint8_t byte);   /* CALLBACK: the chip begins to send a byte */
    void *context;
};

/* Load the firmware. Returns 0, or an exit code after printing one line on standard error. */
int avr_core_start(struct avr_core *c, const char *file, uint32_t tick_pc);

/* Send a byte to the chip: it arrives after the bytes before it, each in ten bits. */
static inline void avr_core_put(struct avr_core *c, uint8_t byte)   { c->in[c->in_head++] = byte; }

/* Run for `cycles`; with `metered`, measure each instruction. Returns false if the firmware has
 * stopped. */
bool avr_core_run(struct avr_core *c, uint32_t cycles, bool metered);

#endif
