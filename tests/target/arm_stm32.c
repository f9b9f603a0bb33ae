/* tests/target/arm_stm32.c -- registers of STM32 chips: timer 1, its DMA, USART 1, outputs, flash
 * SPDX-License-Identifier: MIT
 *
 * RM0090 (stm32f405), RM0008 (stm32f103), RM0444 (stm32g0).
 */
#include "arm_chip.h"

/* Of the USART: CR1, BRR, SR, and the data that is read and written. */
enum { CONTROL, RATE, STATUS, READ, WRITE };
static uint32_t usart(const struct chip *c, int which)
{
    static const uint8_t offset[2][5] = { { 0x0C, 0x08, 0x00, 0x04, 0x04 },
                                          { 0x00, 0x0C, 0x1C, 0x24, 0x28 } };

    return c->kind->usart + offset[c->kind->split][which];
}

static uint64_t byte_cycles(const struct chip *c)
{
    const uint32_t divider = *plain_register(c, usart(c, RATE));

    return 10ull * (divider ? divider : 1) * (c->kind->hz / c->kind->bus);
}

/* CR1: an interrupt when a byte can be sent. */
static bool asks_to_send(const struct chip *c)
{
    return *plain_register(c, usart(c, CONTROL)) >> 7 & 1;
}

/* The size of flash, in KB, is the upper half of its word. */
static bool read_flash(struct chip *c, uint32_t address, uint32_t *value)
{
    const uint32_t at = c->kind->flashes;

    if (!at)
        return false;
    if (address - ARM_FLASH_AT < 0x40000)
        *value = *arm_flash_word(&c->flash, address);
    else if (address == 0x1FFF7A20)
        *value = 1024u << 16;
    else if (address == at + ARM_FLASH_SR || address == at + ARM_FLASH_CR)
        *value = arm_flash_read(&c->flash, address - at);
    else
        return false;
    return true;
}

static bool write_flash(struct chip *c, uint32_t address, uint32_t value)
{
    const uint32_t at = c->kind->flashes;

    if (!at || (address - ARM_FLASH_AT >= 0x40000 && address - at >= 0x18))
        return false;
    if (address - at < 0x18)
        arm_flash_write(&c->flash, address - at, value);
    else
        arm_flash_store(&c->flash, address, value, c->core.stored);
    c->core.now += (uint64_t)c->flash.takes * (c->kind->hz / 1000000);
    return true;
}

/* MODER and PUPDR of an F4 or G0 (RM0090, 8.4); CRH and ODR of an F1 (RM0008, 9.2). */
static bool pulls_up(const struct chip *c, unsigned pin)
{
    if (c->kind->streams || c->kind->split)
        return (c->port[0] >> 2 * pin & 3) == 0 && (c->port[3] >> 2 * pin & 3) == 1;
    return pin >= 8 && (c->port[3] >> 4 * (pin - 8) & 15) == 8 && c->port[5] >> pin & 1;
}

/* The registers of the port of the switches, from 4 words before its IDR. */
static uint32_t *port_register(struct chip *c, uint32_t address)
{
    const uint32_t at = address - (c->kind->idr - 0x10);

    return at < sizeof c->port ? &c->port[at / 4] : NULL;
}

static uint32_t read_register(struct chip *c, uint32_t address, uint32_t plain)
{
    const struct kind *k = c->kind;

    if (read_flash(c, address, &plain))
        return plain;

    if (address == k->rcc)                      /* clocks that are on are ready */
        return plain | (plain & 0x01010001) << 1;
    if (address == k->rcc + 4 && !k->streams)   /* the clock that is chosen is used */
        return plain | (plain & 3) << 2;
    if (address == k->idr)
        return chip_inputs(c);
    if (port_register(c, address))
        return *port_register(c, address);
    if (address == usart(c, STATUS))
        return (uint32_t)c->came << 5 | (uint32_t)(c->core.now >= c->sent_at) << 7;
    if (address == usart(c, READ))
        return chip_take(c);
    if (address == k->timer + 0x24)
        return (uint32_t)(c->core.now - c->stream.begun);
    if (k->random && address == k->random + 4)
        return 1;
    if (k->random && address == k->random + 8)
        return 20260101;
    if (address == k->dma + (k->streams ? 0x10 + 0x18 * 5 + 4 : 8 + 20 * 4 + 4))
        return c->stream.transfer[UPDATE].left;
    return plain;
}

/* A stream: CR, NDTR, PAR, M0AR. Only what the firmware must set right. */
static void write_stream(struct arm_stream *s, int which, uint32_t offset, uint32_t value)
{
    struct arm_transfer *t = &s->transfer[which];
    const uint32_t wanted = 6u << 25 | 2u << 13 | 2u << 11 | 1u << 8 | 1u << 6;

    switch (offset) {
    case 0x00:
        t->increments = value >> 10 & 1;
        t->half_asks  = value >> 3 & 1;
        t->end_asks   = value >> 4 & 1;
        arm_stream_enable(s, which, (value & 1) && (value & (7u << 25 | 0x7800 | 0x1C0)) == wanted);
        break;
    case 0x04: t->count = value & 0xFFFF; break;
    case 0x08: t->to = value; break;
    case 0x0C: t->from = value; break;
    default: break;
    }
}

/* A channel: CCR, CNDTR, CPAR, CMAR. */
static void write_channel(struct arm_stream *s, int which, uint32_t offset, uint32_t value)
{
    struct arm_transfer *t = &s->transfer[which];
    const uint32_t wanted = 2u << 10 | 2u << 8 | 1u << 5 | 1u << 4;

    switch (offset) {
    case 0x00:
        t->increments = value >> 7 & 1;
        t->half_asks  = value >> 2 & 1;
        t->end_asks   = value >> 1 & 1;
        arm_stream_enable(s, which, (value & 1) && (value & (0xF00 | 1u << 5 | 1u << 4)) == wanted);
        break;
    case 0x04: t->count = value & 0xFFFF; break;
    case 0x08: t->to = value; break;
    case 0x0C: t->from = value; break;
    default: break;
    }
}

static void write_timer(struct arm_stream *s, uint32_t offset, uint32_t value)
{
    switch (offset) {
    case 0x00: arm_stream_run(s, value & 1, s->core->now); break;
    case 0x0C:
        s->interrupts = value & 1;
        s->requests = (value >> 8 & 1) << UPDATE | (value >> 9 & 1) << COMPARE;
        break;
    case 0x10:
        s->updated = s->updated && value & 1;
        s->core->pending[16 + s->irq] = s->updated && s->interrupts;
        break;
    case 0x2C: s->reload = value; break;
    case 0x34: s->compare = value; break;
    default: break;
    }
}

/* Output 1 is the part of the time that pin 8 is high, as channel 3 of its timer gives it, while
 * pin 9 is high; output 2 is pin 10. A pin that is no output is off. */
static void watch_outputs(struct chip *c)
{
    const uint32_t *t = plain_register(c, c->kind->power), *b = plain_register(c, c->kind->outputs),
                   *clocks = plain_register(c, c->kind->rcc);
    const uint32_t mode = b[0];
    const bool on = clocks[0x30 / 4] >> 1 & clocks[0x40 / 4] >> 2 & 1,
               pwm = t[0] & 1 && (t[0x1C / 4] & 0x73) == 0x60 && t[0x20 / 4] >> 8 & 1 &&
                     (mode >> 16 & 3) == 2 && (b[9] & 15) == 2,
               allowed = (mode >> 18 & 3) == 1 && c->switched >> 9 & 1,
               second = (mode >> 20 & 3) == 1 && c->switched >> 10 & 1;
    const uint64_t part = on && pwm && allowed ? 65536ull * t[0x3C / 4] / (t[0x2C / 4] + 1ull) : 0;
    struct host_record *r = &c->stream.pins.record;

    host_record_output(r, c->core.now, 1, (uint16_t)(part > 65535 ? 65535 : part));
    host_record_output(r, c->core.now, 2, on && second ? 65535 : 0);
}

static void write_output(struct chip *c, uint32_t offset, uint32_t value)
{
    if (offset == 0x18)
        c->switched = (uint16_t)((c->switched & ~(value >> 16)) | (value & 0xFFFF));
    watch_outputs(c);
}

static void write_register(struct chip *c, uint32_t address, uint32_t value)
{
    const struct kind *k = c->kind;
    struct arm_stream *s = &c->stream;

    if (write_flash(c, address, value))
        return;
    if (address == k->bsrr)
        arm_pins_write(s, value, c->core.now);
    else if (address - k->timer < 0x80)
        write_timer(s, address - k->timer, value);
    else if (k->streams && address - (k->dma + 0x10 + 0x18 * 5) < 0x18)
        write_stream(s, UPDATE, address - (k->dma + 0x10 + 0x18 * 5), value);
    else if (k->streams && address - (k->dma + 0x10 + 0x18 * 1) < 0x18)
        write_stream(s, COMPARE, address - (k->dma + 0x10 + 0x18 * 1), value);
    else if (!k->streams && address - (k->dma + 8 + 20 * 4) < 20)       /* channel 5: TIM1_UP */
        write_channel(s, UPDATE, address - (k->dma + 8 + 20 * 4), value);
    else if (!k->streams && address - (k->dma + 8 + 20 * 1) < 20)       /* channel 2: TIM1_CH1 */
        write_channel(s, COMPARE, address - (k->dma + 8 + 20 * 1), value);
    else if (k->power && address - k->power < 0x80)
        watch_outputs(c);
    else if (k->outputs && address - k->outputs < 0x80)
        write_output(c, address - k->outputs, value);
    else if (port_register(c, address))
        *port_register(c, address) = value;
    else if (address == usart(c, CONTROL))
        c->core.pending[16 + k->irq_line] = c->came;
    else if (address == usart(c, WRITE))
        chip_send(c, (uint8_t)value);
}

static void advance(struct chip *c, uint64_t now)   { arm_stream_advance(&c->stream, now); }
static uint64_t next(const struct chip *c)          { return arm_stream_next(&c->stream); }

const struct family arm_stm32 = { .read = read_register,
                                  .write = write_register,
                                  .advance = advance,
                                  .next = next,
                                  .byte_cycles = byte_cycles,
                                  .asks_to_send = asks_to_send,
                                  .pulls_up = pulls_up };
