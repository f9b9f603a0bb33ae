/* tests/target/arm_chip.h -- a microcontroller whose slots are given from a ring: what the chips
 * share, and the registers of each family
 * SPDX-License-Identifier: MIT
 */
#ifndef TARGET_ARM_CHIP_H
#define TARGET_ARM_CHIP_H

#include "arm_flash.h"
#include "arm_pio.h"
#include "arm_stream.h"
#include "chip_line.h"

struct chip;

/* The registers of a family: what a read gives, of which `plain` was written last; a write; all
 * that gives slots, up to `now`, and when it needs the core next; a byte on the line, in cycles;
 * does the chip ask for an interrupt when it can send; what its boot ROM does, or NULL; is a pin of
 * the port of the switches an input that is pulled up. */
struct family {
    uint32_t (*read)(struct chip *c, uint32_t address, uint32_t plain);
    void     (*write)(struct chip *c, uint32_t address, uint32_t value);
    void     (*advance)(struct chip *c, uint64_t now);
    uint64_t (*next)(const struct chip *c);
    uint64_t (*byte_cycles)(const struct chip *c);
    bool     (*asks_to_send)(const struct chip *c);
    int      (*boot)(struct chip *c);
    bool     (*pulls_up)(const struct chip *c, unsigned pin);
};
extern const struct family arm_stm32, arm_rp2040, arm_rp2350, arm_nrf51;

/* Where an RP2040 and an RP2350 have their parts. */
struct arm_parts;
extern const struct arm_parts arm_rp2040_parts, arm_rp2350_parts;

/* What differs between the chips. Addresses: RCC's clock control; the pins of the slots, the port
 * of the switches, x and the probe in it; timer 1; its transfers; USART 1; the outputs; the flash.
 * */
struct kind {
    const char *name;
    const struct family *family;
    int model;
    bool fpu, streams, split;           /* streams: DMA as on an F4; split: USART as on a G0 */
    struct arm_memory memory;
    uint32_t hz, bus;                   /* of the core; of USART 1 */
    unsigned irq_line, irq_stream, x_switch, probe;
    uint32_t rcc, bsrr, idr, timer, dma, usart, random;
    uint32_t power, outputs;            /* timer 4 and its port, or 0 */
    uint32_t flashes;                   /* or 0 */
    const struct arm_parts *parts;      /* of an RP2040 or RP2350 */
};
struct chip {
    const struct kind *kind;
    struct arm_core core;
    struct arm_stream stream;
    struct arm_pio pio;
    uint64_t sampled_at, sampler_period, captured;  /* of an nRF51: timer 1; CC[1] of timer 0 */
    bool sampled;
    bool feeds, flash_is_set;           /* of an RP2040: its DMA is busy; its flash can be read */
    struct arm_flash flash;
    struct chip_line line;
    uint32_t plain[0x20000];            /* registers without an effect: 0x40000000.. */
    uint8_t in[65536];                  /* to the chip; indices wrap */
    uint16_t in_head, in_tail;
    uint32_t port[6];                   /* registers of the port of the switches, of an STM32 */
    uint16_t switched;                  /* pins of the port of the outputs */
    bool came;                          /* RXNE */
    uint8_t data;
    uint64_t came_at, sent_at, heard, received, overruns;
    int32_t x, touch;                   /* steps of x at the pins; where its contact closes, or 0 */
    unsigned contact;                   /* pin of that port: the switch of x, or the probe */
    uint64_t bounce, settled;           /* cycles */
    bool closed;
    uint64_t late;                      /* cycles; 0: no more */
    uint32_t jobs;
};


/* A register as it was written last, below 0x40080000. */
static inline const uint32_t *plain_register(const struct chip *c, uint32_t address)
{
    return &c->plain[(address - 0x40000000) / 4];
}

/* The firmware takes the byte that came; sends one. The pins of the port of the switches. */
uint8_t  chip_take(struct chip *c);
void     chip_send(struct chip *c, uint8_t byte);
uint32_t chip_inputs(const struct chip *c);

#endif
