/* tests/target/arm_nrf51.c -- registers of an nRF51: timers 0 and 1, UART, pins
 * SPDX-License-Identifier: MIT
 *
 * nRF51 series reference manual. The pins are those of ports/nrf51/port.c; all inputs are open.
 */
#include "arm_chip.h"

#define UART    0x40002000u
#define TIMER   0x40008000u
#define SAMPLER 0x40009000u
#define GPIO    0x50000000u
#define SAMPLER_IRQ 9

static uint64_t byte_cycles(const struct chip *c)
{
    const uint64_t rate = *plain_register(c, UART + 0x524);

    return rate ? 10 * ((1ull << 32) / rate) : 1;
}

static bool asks_to_send(const struct chip *c)
{
    (void)c;
    return false;
}

static void advance(struct chip *c, uint64_t now)
{
    arm_stream_advance(&c->stream, now);
    while (c->sampler_period && now >= c->sampled_at + c->sampler_period) {
        c->sampled_at += c->sampler_period;
        c->sampled = true;
    }
    if (c->sampled)
        arm_core_raise(&c->core, SAMPLER_IRQ);
}

static uint64_t next(const struct chip *c)
{
    const uint64_t slot = arm_stream_next(&c->stream), sample = c->sampled_at + c->sampler_period;

    return c->sampler_period && sample < slot ? sample : slot;
}

static uint32_t read_register(struct chip *c, uint32_t address, uint32_t plain)
{
    switch (address) {
    case 0x40000100:
    case 0x4000D100: return 1; /* the clock runs; a number is there */
    case 0x4000D508: return (uint32_t)c->core.now >> 2 & 0xFF;
    case UART + 0x11C: return c->core.now >= c->sent_at;
    case UART + 0x518: return chip_take(c);
    case TIMER + 0x544: return (uint32_t)c->captured;
    case GPIO + 0x510: return UINT32_MAX;
    default: return plain;
    }
}

/* Steps are pins 3, 2, 1, directions 18, 20, 16. */
static void write_out(struct chip *c, uint32_t value)
{
    const uint32_t is = (value >> 3 & 1) | (value >> 2 & 1) << 1 | (value >> 1 & 1) << 2 |
                        (value >> 18 & 1) << 3 | (value >> 20 & 1) << 4 | (value >> 16 & 1) << 5;

    arm_pins_write(&c->stream, is | (~is & 0x3F) << 16, c->core.now);
}

static void write_timer(struct chip *c, uint32_t offset, uint32_t value)
{
    struct arm_stream *s = &c->stream;

    switch (offset) {
    case 0x000: arm_stream_run(s, true, c->core.now); break;
    case 0x004: arm_stream_run(s, false, c->core.now); break;
    case 0x044: c->captured = (uint32_t)(c->core.now - s->begun); break;
    case 0x140: c->core.pending[16 + s->irq] = s->updated = false; break;
    case 0x304: s->interrupts = value >> 16 & 1; break;
    case 0x540: s->reload = value - 1; break;
    default: break;
    }
}

static void write_register(struct chip *c, uint32_t address, uint32_t value)
{
    const uint32_t period = *plain_register(c, SAMPLER + 0x540);

    if (address - TIMER < 0x1000) {
        write_timer(c, address - TIMER, value);
    } else if (address == SAMPLER && c->sampler_period == 0) {
        c->sampler_period = period;
        c->sampled_at = c->core.now;
    } else if (address == SAMPLER + 0x004) {
        c->sampler_period = 0;
    } else if (address == SAMPLER + 0x140) {
        c->core.pending[16 + SAMPLER_IRQ] = c->sampled = false;
    } else if (address == GPIO + 0x504) {
        write_out(c, value);
    } else if (address == UART + 0x108) {
        c->core.pending[16 + c->kind->irq_line] = false;
    } else if (address == UART + 0x51C) {
        chip_send(c, (uint8_t)value);
    }
}

const struct family arm_nrf51 = { .read = read_register,
                                  .write = write_register,
                                  .advance = advance,
                                  .next = next,
                                  .byte_cycles = byte_cycles,
                                  .asks_to_send = asks_to_send };
