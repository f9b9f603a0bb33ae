/* tests/target/arm_rp2040.c -- registers of an RP2040 and an RP2350: a state machine of PIO0,
 * channel 0 of the DMA, UART0, clocks, pads, and what the boot ROM does
 * SPDX-License-Identifier: MIT
 *
 * RP2040 datasheet: 2.5 DMA, 2.8 boot, 3 PIO, 4.2 UART, 4.10.13 SSI. RP2350 datasheet: 2.2 address
 * map, 5.9.5 the least block of an image, 7.5 resets, 9.7 pads that are apart, 11 PIO, 12.1 UART,
 * 12.6 DMA. A transfer takes no time.
 */
#include <stdio.h>
#include <string.h>
#include <sysexits.h>

#include "arm_chip.h"

#define DMA     0x50000000u
#define PIO     0x50200000u
#define SSI     0x18000000u
#define SIO     0xD0000000u
#define BOOT    0x20041F00u             /* where the first 256 bytes run */

/* Where the parts are; bits of RESETS: all, and those that must run; the register in which a pin of
 * the core is an output. */
struct arm_parts {
    uint32_t clocks, resets, pins, pads, xosc, pll, uart, random, drives, all, needed;
};
const struct arm_parts arm_rp2040_parts = { 0x40008000,
                                            0x4000C000,
                                            0x40014000,
                                            0x4001C000,
                                            0x40024000,
                                            0x40028000,
                                            0x40034000,
                                            0x4006001C,
                                            0xD0000020,
                                            0x01FFFFFF,
                                            1 << 2 | 1 << 5 | 1 << 8 | 1 << 10 | 1 << 12 |
                                                1 << 22 };
const struct arm_parts arm_rp2350_parts = { 0x40010000,
                                            0x40020000,
                                            0x40028000,
                                            0x40038000,
                                            0x40048000,
                                            0x40050000,
                                            0x40070000,
                                            0x400E8020,
                                            0xD0000030,
                                            0x1FFFFFFF,
                                            1 << 2 | 1 << 6 | 1 << 9 | 1 << 11 | 1 << 14 |
                                                1 << 26 };

static uint64_t byte_cycles(const struct chip *c)
{
    const uint32_t uart = c->kind->parts->uart;
    const uint32_t divider = *plain_register(c, uart + 0x24) * 64 + *plain_register(c, uart + 0x28);

    return divider ? 10ull * divider / 4 : 1;
}

static bool asks_to_send(const struct chip *c)
{
    return *plain_register(c, c->kind->parts->uart + 0x38) >> 5 & 1;
}


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

/* Are pins 0..5 those of PIO0, and their pads on? Bit 7 turns a pad off, bit 8 leaves it apart. */
static bool pins_given(const struct chip *c)
{
    const struct arm_parts *p = c->kind->parts;

    for (uint32_t pin = 0; pin < 6; pin++)
        if ((*plain_register(c, p->pins + 4 + 8 * pin) & 31) != 6 || !(c->pio.dirs >> pin & 1) ||
            *plain_register(c, p->pads + 4 + 4 * pin) & 0x180)
            return false;
    return (*plain_register(c, p->resets) & p->needed) == 0;
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

/* Input enabled, pulled up, the pad on and not apart; the pin is SIO's. */
static bool pulls_up(const struct chip *c, unsigned pin)
{
    const struct arm_parts *p = c->kind->parts;

    return (*plain_register(c, p->pads + 4 + 4 * pin) & 0x1C8) == 0x48 &&
           (*plain_register(c, p->pins + 4 + 8 * pin) & 31) == 5;
}

/* The clock that was chosen; the crystal is stable, the PLL locked. */
static uint32_t read_part(struct chip *c, uint32_t address, uint32_t plain)
{
    const struct arm_parts *p = c->kind->parts;

    if (address == p->resets + 0x08)
        return ~*plain_register(c, p->resets);
    if (address == p->xosc + 0x04)
        return 1u << 31;
    if (address == p->pll)
        return plain | 1u << 31;
    if (address == p->clocks + 0x38)
        return 1u << (*plain_register(c, p->clocks + 0x30) & 3);
    if (address == p->clocks + 0x44)
        return 1u << (*plain_register(c, p->clocks + 0x3C) & 1);
    if (address == p->random)
        return c->core.now >> 3 & 1;
    if (address == p->uart)
        return chip_take(c);
    if (address == p->uart + 0x18)
        return (uint32_t)!c->came << 4 | (uint32_t)(c->core.now < c->sent_at) << 5;
    return plain;
}

static uint32_t read_register(struct chip *c, uint32_t address, uint32_t plain)
{
    switch (address) {
    case SIO + 0x04: return chip_inputs(c);
    case DMA + 0x08: return c->stream.transfer[UPDATE].left;
    case PIO + 0x0C: return c->pio.level;
    default: return read_part(c, address, plain);
    }
}

/* The PLL gives the clock of the core: 12 MHz times its factor, by two numbers. */
static bool clock_is_right(const struct chip *c)
{
    const uint32_t pll = c->kind->parts->pll, after = *plain_register(c, pll + 0x0C);
    const uint32_t by = (after >> 16 & 7) * (after >> 12 & 7);

    return by && 12000000u * *plain_register(c, pll + 0x08) / by == c->kind->hz;
}

static void write_register(struct chip *c, uint32_t address, uint32_t value)
{
    static const struct {
        uint32_t at, value;
    } flash[] = { { 0x00, 0x001F0300 }, { 0x04, 0 }, { 0xF4, 0x03000218 }, { 0x08, 1 } };
    static unsigned known;
    const struct arm_parts *p = c->kind->parts;

    if (address - SSI < 0x100) {
        for (unsigned k = 0; k < 4; k++)
            if (address - SSI == flash[k].at && value == flash[k].value)
                known |= 1u << k;
        c->flash_is_set = known == 15;
    } else if (address - DMA < 0x1000) {
        write_dma(c, address - DMA, value);
    } else if (address - PIO < 0x1000) {
        write_pio(c, address - PIO, value);
    } else if (address == p->uart + 0x38) {
        c->core.pending[16 + c->kind->irq_line] = c->came;
    } else if (address == p->uart) {
        chip_send(c, (uint8_t)value);
    } else if (address == p->resets && !c->flash_is_set) {
        fprintf(stderr, "chip: the program runs, but its flash was not set up\n");
        c->core.failed = true;
    } else if (address == p->clocks + 0x3C && value & 1 && !clock_is_right(c)) {
        fprintf(stderr, "chip: the core has another clock than it should\n");
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

static void reset_parts(struct chip *c, uint32_t pad)
{
    const struct arm_parts *p = c->kind->parts;

    arm_pio_init(&c->pio);
    c->plain[(p->resets - 0x40000000) / 4] = p->all;
    for (uint32_t pin = 0; pin < 30; pin++)
        c->plain[(p->pads + 4 + 4 * pin - 0x40000000) / 4] = pad;
}

static int boot(struct chip *c)
{
    uint32_t said;

    reset_parts(c, 0x56);
    memcpy(&said, c->core.flash_bytes + 252, 4);
    if (crc_of(c->core.flash_bytes, 252) != said) {
        fprintf(stderr, "boot ROM: the checksum of the first 256 bytes is wrong\n");
        return EX_DATAERR;
    }
    memcpy(c->core.ram_bytes + (BOOT - 0x20000000u), c->core.flash_bytes, 256);
    arm_core_jump(&c->core, BOOT | 1, 0x20042000);
    return 0;
}

/* The block of a program for this chip is in the first 4096 bytes, without other items; the core
 * begins by the vectors at the begin of the flash, which can be read. */
static int boot_block(struct chip *c)
{
    static const uint32_t block[5] = { 0xFFFFDED3, 0x10210142, 0x000001FF, 0, 0xAB123579 };

    reset_parts(c, 0x116);
    c->flash_is_set = true;
    for (uint32_t at = 0; at + sizeof block <= 4096; at += 4)
        if (memcmp(c->core.flash_bytes + at, block, sizeof block) == 0)
            return 0;
    fprintf(stderr, "boot ROM: no block says that the image is a program\n");
    return EX_DATAERR;
}

const struct family arm_rp2350 = { .read = read_register,
                                   .write = write_register,
                                   .advance = advance,
                                   .next = next,
                                   .byte_cycles = byte_cycles,
                                   .asks_to_send = asks_to_send,
                                   .boot = boot_block,
                                   .pulls_up = pulls_up };
const struct family arm_rp2040 = { .read = read_register,
                                   .write = write_register,
                                   .advance = advance,
                                   .next = next,
                                   .byte_cycles = byte_cycles,
                                   .asks_to_send = asks_to_send,
                                   .boot = boot,
                                   .pulls_up = pulls_up };
