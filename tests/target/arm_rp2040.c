/* tests/target/arm_rp2040.c -- registers of an RP2040: a state machine of PIO0, channel 0 of its
 * DMA, UART0, clocks, and what the boot ROM does
 * SPDX-License-Identifier: MIT
 *
 * RP2040 datasheet: 2.5 DMA, 2.8 boot, 3 PIO, 4.2 UART, 4.10.13 SSI. A transfer takes no time.
 */
#include <stdio.h>
#include <string.h>
#include <sysexits.h>

#include "arm_chip.h"

#define RESETS  0x4000C000u
#define UART    0x40034000u
#define DMA     0x50000000u
#define PIO     0x50200000u
#define SSI     0x18000000u
#define SIO     0xD0000000u
#define BOOT    0x20041F00u             /* where the first 256 bytes run */

static uint64_t byte_cycles(const struct chip *c)
{
    const uint32_t divider = *plain_register(c, UART + 0x24) * 64 + *plain_register(c, UART + 0x28);

    return divider ? 10ull * divider / 4 : 1;
}

static bool asks_to_send(const struct chip *c) { return *plain_register(c, UART + 0x38) >> 5 & 1; }


// Slots
// -----

/* The channel gives words as long as the FIFO takes them. */
static void feed(struct chip *c)
{
    struct arm_transfer *t = &c->stream.transfer[UPDATE];

    while (c->feeds && arm_pio_put(&c->pio, arm_core_word(&c->core, t->from))) {
        t->from += 4;
        if (--t->left == 0) {
            c->feeds = false;
            t->flags |= 2;
            if (t->end_asks)
                arm_core_raise(&c->core, c->kind->irq_stream);
        }
    }
}

/* Are pins 0..5 those of PIO0? */
static bool pins_given(const struct chip *c)
{
    for (uint32_t pin = 0; pin < 6; pin++)
        if ((*plain_register(c, 0x40014004u + 8 * pin) & 31) != 6 || !(c->pio.dirs >> pin & 1))
            return false;
    return true;
}

/* stream.begun: the cycle at which the state machine's clock was begun last. */
static void advance(struct chip *c, uint64_t now)
{
    const uint32_t divider = arm_pio_divider(&c->pio);

    feed(c);
    for (; c->pio.runs && c->stream.begun + divider <= now; feed(c)) {
        const uint32_t was = c->pio.out & 0x3F;
        c->stream.begun += divider;
        if (c->pio.stalls && c->pio.level == 0 && !c->feeds) {  /* nothing until it is fed */
            c->stream.begun += (now - c->stream.begun) / divider * divider;
            return;
        }
        arm_pio_cycle(&c->pio);
        const uint32_t is = c->pio.out & 0x3F;
        if (is != was && pins_given(c))
            arm_pins_write(&c->stream, is | (~is & 0x3F) << 16, c->stream.begun);
    }
    c->stream.waits = (uint32_t)c->pio.stalled;
    if (c->pio.failed && !c->core.failed) {
        fprintf(stderr, "chip: the state machine cannot do that\n");
        c->core.failed = true;
    }
}

/* A slot is at least two cycles of the state machine. */
static uint64_t next(const struct chip *c)
{
    const uint64_t most = 2ull * arm_pio_divider(&c->pio), left = c->stream.transfer[UPDATE].left;

    return c->feeds && c->pio.runs ? c->core.now + (left > 2 ? (left - 1) * most : 1) : ARM_NEVER;
}

static void begin_transfer(struct chip *c, uint32_t from)
{
    struct arm_transfer *t = &c->stream.transfer[UPDATE];

    t->from = from;
    t->left = t->count;
    c->feeds = t->enabled && t->to == PIO + 0x10 && t->count > 0;
    feed(c);
}

static void write_dma(struct chip *c, uint32_t offset, uint32_t value)
{
    struct arm_transfer *t = &c->stream.transfer[UPDATE];

    switch (offset) {
    case 0x04: t->to = value; break;
    case 0x08: t->count = value; break;
    case 0x10:              /* on, words, from memory that goes on, chained to none, PIO0 asks */
        t->enabled = (value & 0x1FFFFFu & ~2u) == (1u << 4 | 2u << 2 | 1u << 0);
        break;
    case 0x3C: begin_transfer(c, value); break;
    case 0x404: t->end_asks = value & 1; break;
    case 0x40C: t->flags &= value & 1 ? ~2u : ~0u; break;
    default: c->core.failed = true; break;
    }
}

static void write_pio(struct chip *c, uint32_t offset, uint32_t value)
{
    struct arm_pio *p = &c->pio;

    if (offset - 0x48 < 4 * 32)
        p->program[(offset - 0x48) / 4] = (uint16_t)value;
    switch (offset) {
    case 0x00:
        if (!p->runs && value & 1)
            c->stream.begun = c->core.now;
        p->runs = value & 1;
        break;
    case 0xC8: p->clock = value; break;
    case 0xCC: p->exec = value; break;
    case 0xD0: p->shift = value; break;
    case 0xD8: arm_pio_run(p, (uint16_t)value); break;
    case 0xDC: p->pins = value; break;
    default: break;
    }
}


// Other registers
// ---------------

/* PADS_BANK0: input enabled, pulled up; the pin is SIO's. */
static bool pulls_up(const struct chip *c, unsigned pin)
{
    return (*plain_register(c, 0x4001C004 + 4 * pin) & 0xC8) == 0x48 &&
           (*plain_register(c, 0x40014004 + 8 * pin) & 31) == 5;
}

static uint32_t read_register(struct chip *c, uint32_t address, uint32_t plain)
{
    switch (address) {
    case RESETS + 0x08: return ~*plain_register(c, RESETS);
    case 0x40024004: return 1u << 31;                           /* XOSC: stable */
    case 0x40028000: return plain | 1u << 31;                   /* PLL: locked */
    case 0x40008038: return 1u << (*plain_register(c, 0x40008030) & 3);
    case 0x40008044: return 1u << (*plain_register(c, 0x4000803C) & 1);
    case 0x4006001C: return c->core.now >> 3 & 1;
    case UART + 0x00: return chip_take(c);
    case UART + 0x18: return (uint32_t)!c->came << 4 | (uint32_t)(c->core.now < c->sent_at) << 5;
    case SIO + 0x04: return chip_inputs(c);
    case DMA + 0x08: return c->stream.transfer[UPDATE].left;
    case PIO + 0x0C: return c->pio.level;
    default: return plain;
    }
}

static void write_register(struct chip *c, uint32_t address, uint32_t value)
{
    static const struct {
        uint32_t at, value;
    } flash[] = { { 0x00, 0x001F0300 }, { 0x04, 0 }, { 0xF4, 0x03000218 }, { 0x08, 1 } };
    static unsigned known;

    if (address - SSI < 0x100) {
        for (unsigned k = 0; k < 4; k++)
            if (address - SSI == flash[k].at && value == flash[k].value)
                known |= 1u << k;
        c->flash_is_set = known == 15;
    } else if (address - DMA < 0x1000) {
        write_dma(c, address - DMA, value);
    } else if (address - PIO < 0x1000) {
        write_pio(c, address - PIO, value);
    } else if (address == UART + 0x38) {
        c->core.pending[16 + c->kind->irq_line] = c->came;
    } else if (address == UART) {
        chip_send(c, (uint8_t)value);
    } else if (address == RESETS && !c->flash_is_set) {
        fprintf(stderr, "chip: the program runs, but its flash was not set up\n");
        c->core.failed = true;
    }
}

/* Polynomial 0x04C11DB7, from all ones, bits in their order. */
static uint32_t crc_of(const uint8_t *bytes, size_t count)
{
    uint32_t crc = UINT32_MAX;

    for (size_t k = 0; k < count; k++) {
        crc ^= (uint32_t)bytes[k] << 24;
        for (int bit = 0; bit < 8; bit++)
            crc = crc << 1 ^ (crc >> 31 ? 0x04C11DB7u : 0);
    }
    return crc;
}

static int boot(struct chip *c)
{
    uint32_t said;

    arm_pio_init(&c->pio);
    c->plain[(RESETS - 0x40000000) / 4] = 0x01FFFFFF;
    memcpy(&said, c->core.flash_bytes + 252, 4);
    if (crc_of(c->core.flash_bytes, 252) != said) {
        fprintf(stderr, "boot ROM: the checksum of the first 256 bytes is wrong\n");
        return EX_DATAERR;
    }
    memcpy(c->core.ram_bytes + (BOOT - 0x20000000u), c->core.flash_bytes, 256);
    arm_core_jump(&c->core, BOOT | 1, 0x20042000);
    return 0;
}

const struct family arm_rp2040 = { .read = read_register,
                                   .write = write_register,
                                   .advance = advance,
                                   .next = next,
                                   .byte_cycles = byte_cycles,
                                   .asks_to_send = asks_to_send,
                                   .boot = boot,
                                   .pulls_up = pulls_up };
