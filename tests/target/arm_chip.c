/* tests/target/arm_chip.c -- a microcontroller whose slots a timer and DMA give, behind a line
 * SPDX-License-Identifier: MIT
 * usage: arm_chip KIND FIRMWARE.elf [--link PATH | --socket PATH] [--record FILE] [--steps N]
 *                 [--touch STEPS[,MS]] [--contact x|probe] [--late US] [--jobs N] [--flash FILE]
 *                 [--cut N]
 *
 * --touch: the limit switch of x closes with the pulse of x that reaches STEPS, and bounces for MS.
 * --contact probe: not the switch, but the probe.
 * --late: once, in mid-job, the interrupt that makes slots is held for US microseconds.
 * --flash: FILE holds the flash that the chip writes, between two runs.
 * --cut: the power fails in the N-th word that is written, or erasure.
 *
 * It ends when N jobs, or one, have been drawn and closed, and prints lines `name value`.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#include "arm_chip.h"

#define SETTLE  20                      /* ms after the last byte, time to answer it */

static const struct kind kinds[] = {
    { .name = "stm32f405",
      .family = &arm_stm32,
      .model = UC_CPU_ARM_CORTEX_M4,
      .fpu = true,
      .streams = true,
      .memory = { 0x08000000, 0xC0000, 0x20000000, 0x20000, .kept = true },
      .hz = 168000000,
      .bus = 84000000,
      .irq_line = 37,
      .irq_stream = 68,
      .probe = 6,
      .rcc = 0x40023800,
      .bsrr = 0x40020018,
      .idr = 0x40020810,
      .timer = 0x40010000,
      .dma = 0x40026400,
      .usart = 0x40011000,
      .random = 0x50060800,
      .power = 0x40000800,
      .outputs = 0x40020400,
      .flashes = 0x40023C00 },
    { .name = "stm32f103",
      .family = &arm_stm32,
      .model = UC_CPU_ARM_CORTEX_M3,
      .streams = false,
      .memory = { 0x08000000, 0x10000, 0x20000000, 0x5000 },
      .hz = 72000000,
      .bus = 72000000,
      .irq_line = 37,
      .irq_stream = 15,
      .x_switch = 10,
      .probe = 8,
      .rcc = 0x40021000,
      .bsrr = 0x40010810,
      .idr = 0x40010C08,
      .timer = 0x40012C00,
      .dma = 0x40020000,
      .usart = 0x40013800 },
    { .name = "stm32g0",
      .family = &arm_stm32,
      .model = UC_CPU_ARM_CORTEX_M0,
      .split = true,
      .memory = { 0x08000000, 0x10000, 0x20000000, 0x9000, 0 },
      .hz = 64000000,
      .bus = 64000000,
      .irq_line = 27,
      .irq_stream = 13,
      .probe = 8,
      .rcc = 0x40021000,
      .bsrr = 0x50000018,
      .idr = 0x50000410,
      .timer = 0x40012C00,
      .dma = 0x40020000,
      .usart = 0x40013800 },
    { .name = "nrf51",
      .family = &arm_nrf51,
      .model = UC_CPU_ARM_CORTEX_M0,
      .memory = { 0, 0x40000, 0x20000000, 0x4000, 0 },
      .hz = 16000000,
      .irq_line = 2,
      .irq_stream = 8 },
    { .name = "rp2040",
      .family = &arm_rp2040,
      .model = UC_CPU_ARM_CORTEX_M0,
      .memory = { 0x10000000, 0x200000, 0x20000000, 0x42000, 0x10000100 },
      .hz = 125000000,
      .irq_line = 20,
      .irq_stream = 11,
      .x_switch = 6,
      .probe = 15,
      .parts = &arm_rp2040_parts },
    { .name = "rp2350",
      .family = &arm_rp2350,
      .model = UC_CPU_ARM_CORTEX_M33,
      .fpu = true,
      .memory = { 0x10000000, 0x400000, 0x20000000, 0x82000, 0x10000100 },
      .hz = 150000000,
      .irq_line = 33,
      .irq_stream = 10,
      .x_switch = 6,
      .probe = 15,
      .parts = &arm_rp2350_parts },
};



// The line
// --------

static void byte_in(void *context, uint8_t byte)
{
    struct chip *c = context;

    if (c->in_head == c->in_tail && c->came_at < c->core.now)
        c->came_at = c->core.now;
    c->in[c->in_head++] = byte;
    c->heard = c->core.now;
}

/* A byte is there after ten bits. */
static void receive(struct chip *c, uint64_t now)
{
    while (c->in_head != c->in_tail && c->came_at + c->kind->family->byte_cycles(c) <= now) {
        c->came_at += c->kind->family->byte_cycles(c);
        c->overruns += c->came;
        c->data = c->in[c->in_tail++];
        c->came = true;
        c->received++;
        c->heard = now;
    }
    if (c->came || (c->kind->family->asks_to_send(c) && c->sent_at <= now))
        arm_core_raise(&c->core, c->kind->irq_line);
}

/* It asks as long as it is set. */
uint8_t chip_take(struct chip *c)
{
    c->came = c->core.pending[16 + c->kind->irq_line] = false;
    return c->data;
}

void chip_send(struct chip *c, uint8_t byte)
{
    chip_line_out(&c->line, byte);
    c->heard = c->core.now;
    c->sent_at = c->core.now + c->kind->family->byte_cycles(c);
}


// Registers
// ---------

static void x_pulse(void *context)
{
    struct chip *c = context;
    const unsigned pins = c->stream.pins.now;

    if (!(pins & 1))
        return;
    c->x = c->stream.pins.record.position[0];
    const bool closed = c->touch && (c->touch < 0 ? c->x <= c->touch : c->x >= c->touch);
    if (closed != c->closed)
        c->settled = c->stream.pins.last + c->bounce;
    c->closed = closed;
}

/* Of the switches; what is not pulled up reads as closed. A contact that bounces is first as it
 * will be, then changes each 64 us or later, by a pattern without a period. */
uint32_t chip_inputs(const struct chip *c)
{
    const uint64_t now = c->core.now, part = c->kind->hz / 1000000 * 64;
    bool closed = c->closed;

    if (now < c->settled) {
        const uint64_t k = (now + c->bounce - c->settled) / part;
        closed ^= k > 0 && (k * 2654435761u >> 9 & 1);
    }
    uint32_t open = 0;
    for (unsigned pin = 0; pin < 16; pin++)
        if (c->kind->family->pulls_up(c, pin) && !(closed && pin == c->contact))
            open |= 1u << pin;
    return open;
}

static uint32_t read_register(void *context, uint32_t address)
{
    struct chip *c = context;
    const bool low = address - 0x40000000 < sizeof c->plain;

    return c->kind->family->read(c, address, low ? *plain_register(c, address) : 0);
}

static void write_register(void *context, uint32_t address, uint32_t value)
{
    struct chip *c = context;

    if (address - 0x40000000 < sizeof c->plain)
        c->plain[(address - 0x40000000) / 4] = value;
    c->kind->family->write(c, address, value);
}

static void advance(void *context, uint64_t now)
{
    struct chip *c = context;

    c->kind->family->advance(c, now);
    receive(c, now);
    if (c->late && c->stream.pins.pulses[0] > 2000) {
        c->core.hold_irq = 14;
        c->core.hold_until = now + c->late;
        c->late = 0;
    }
}

static uint64_t next(void *context)
{
    struct chip *c = context;
    const uint64_t half = c->kind->family->next(c),
                   byte = c->in_head == c->in_tail ? ARM_NEVER
                                                   : c->came_at + c->kind->family->byte_cycles(c);

    const uint64_t first = half < byte ? half : byte;
    return c->kind->family->asks_to_send(c) && c->sent_at < first ? c->sent_at : first;
}


// What it came to
// ---------------

static void print_least(const char *name, uint64_t cycles)
{
    if (cycles != UINT64_MAX)
        printf("%s %llu\n", name, (unsigned long long)cycles);
}

/* Instructions of the time with pulses, to its cycles: all, those of slots and ticks, those of the
 * main loop. */
struct share {
    uint64_t from, all, slots, rest;
};

static void count_share(const struct arm_core *m, unsigned irq, struct share *at)
{
    at->all   = m->ran;
    at->slots = m->ran_in[14] + m->ran_in[15] + m->ran_in[16 + irq];
    at->rest  = m->ran_in[0];
}

static void print_results(const struct chip *c, const struct share *a, const struct share *b)
{
    const struct arm_pins *p = &c->stream.pins;
    const double per = b->from > a->from ? 1.0 / (double)(b->from - a->from) : 0;

    printf("load %.4f\nload_slots %.4f\nload_main %.4f\nmips %.2f\n",
           (double)(b->all - a->all) * per, (double)(b->slots - a->slots) * per,
           (double)(b->rest - a->rest) * per, (double)(b->all - a->all) * per * c->kind->hz / 1e6);
    print_least("pulse_least", p->pulse_least);
    print_least("pulse_most", p->pulse_most ? p->pulse_most : UINT64_MAX);
    print_least("low_least", p->low_least);
    print_least("setup_least", p->setup_least);
    print_least("hold_least", p->hold_least);
    print_least("between_least", p->between_least);
    printf("pulses %llu %llu %llu\n", (unsigned long long)p->pulses[0],
           (unsigned long long)p->pulses[1], (unsigned long long)p->pulses[2]);
    printf("position %d %d %d\n", (int)p->record.position[0], (int)p->record.position[1],
           (int)p->record.position[2]);
    printf("waits %u\n", (unsigned)c->stream.waits);
    printf("flash_written %u\nflash_again %u\nflash_erased %u\nflash_refused %u\n",
           (unsigned)c->flash.written, (unsigned)c->flash.again, (unsigned)c->flash.erased,
           (unsigned)c->flash.refused);
    printf("bytes_received %llu\noverruns %llu\nnaks %u\nhost_late %u\nseconds %.6f\n",
           (unsigned long long)c->received, (unsigned long long)c->overruns,
           (unsigned)c->line.gate.naks, (unsigned)c->line.waits, (double)c->core.now / c->kind->hz);
}

static void run_chip(struct chip *c)
{
    const uint64_t ms = c->kind->hz / 1000;
    const struct arm_pins *p = &c->stream.pins;
    struct share begun = { 0 }, ended = { 0 };
    uint64_t last = 0;

    while (c->line.gate.jobs < c->jobs && !chip_line_stopped() && !c->flash.cut) {
        if (!arm_core_run(&c->core, c->core.now + ms))
            break;
        if (p->first && !begun.from) {
            begun.from = c->core.now;
            count_share(&c->core, c->kind->irq_stream, &begun);
        }
        if (p->last != last) {
            last = p->last;
            ended.from = c->core.now;
            count_share(&c->core, c->kind->irq_stream, &ended);
        }
        chip_line_turn(&c->line, c->in_head != c->in_tail || c->core.now - c->heard < SETTLE * ms);
    }
    chip_line_leave(&c->line);
    print_results(c, &begun, &ended);
}

/* A new file is erased. */
static void load_flash(struct arm_flash *flash, const char *file)
{
    FILE *f = file ? fopen(file, "rb") : NULL;

    arm_flash_reset(flash);
    if (!f || fread(flash->word, sizeof flash->word, 1, f) != 1)
        arm_flash_erase_all(flash);
    if (f)
        fclose(f);
}

static int save_flash(const struct arm_flash *flash, const char *file)
{
    FILE *f = file ? fopen(file, "wb") : NULL;
    const bool good = f && fwrite(flash->word, sizeof flash->word, 1, f) == 1;

    if (f && fclose(f) == 0 && good)
        return 0;
    return file ? EX_CANTCREAT : 0;
}

static const struct kind *kind_of(const char *name)
{
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        if (strncmp(name, kinds[k].name, strlen(kinds[k].name)) == 0)
            return &kinds[k];
    return NULL;
}

int main(int argc, char **argv)
{
    static struct chip c;
    struct loft_host_options o = loft_host_defaults();
    const char *socket = NULL, *touch = "0", *flash = NULL;
    double steps = 250;
    char *tail;

    c.kind = argc > 2 ? kind_of(argv[1]) : NULL;
    if (!c.kind) {
        fprintf(stderr, "usage: arm_chip KIND FIRMWARE.elf [--link PATH] ..\n");
        return EX_USAGE;
    }
    c.contact = c.kind->x_switch;
    c.port[0] = c.kind->split ? 0xFFFFFFFF : 0;     /* RM0444, 7.4.1: the pins are analog */
    o.tick_hz = 8000;
    o.slots = c.kind->hz / o.tick_hz;   /* the record counts cycles */
    for (int i = 3; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--link") == 0)
            o.link = argv[i + 1];
        if (strcmp(argv[i], "--socket") == 0)
            socket = argv[i + 1];
        if (strcmp(argv[i], "--record") == 0)
            o.record = argv[i + 1];
        if (strcmp(argv[i], "--steps") == 0)
            steps = atof(argv[i + 1]);
        if (strcmp(argv[i], "--touch") == 0)
            touch = argv[i + 1];
        if (strcmp(argv[i], "--contact") == 0 && strcmp(argv[i + 1], "probe") == 0)
            c.contact = c.kind->probe;
        if (strcmp(argv[i], "--late") == 0)
            c.late = (uint64_t)(atof(argv[i + 1]) * c.kind->hz / 1e6);
        if (strcmp(argv[i], "--flash") == 0)
            flash = argv[i + 1];
        if (strcmp(argv[i], "--cut") == 0)
            c.flash.power = (uint32_t)strtoul(argv[i + 1], NULL, 0);
        if (strcmp(argv[i], "--jobs") == 0)
            c.jobs = (uint32_t)strtoul(argv[i + 1], NULL, 0);
    }
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = steps;
    c.jobs += c.jobs == 0;
    c.touch = (int32_t)strtol(touch, &tail, 0);
    c.bounce = (uint64_t)((*tail ? atof(tail + 1) : 0) * c.kind->hz / 1000);
    c.core.memory = c.kind->memory;
    c.core.read = read_register;
    c.core.write = write_register;
    c.core.advance = advance;
    c.core.next = next;
    c.core.chip = &c;
    c.line.put = byte_in;
    c.line.context = &c;
    c.stream.preloads = c.kind->streams;
    c.stream.irq = c.kind->irq_stream;
    c.stream.bsrr = c.kind->bsrr;
    c.stream.pulse = x_pulse;
    c.stream.context = &c;
    arm_stream_init(&c.stream, &c.core);
    load_flash(&c.flash, flash);
    int code = arm_core_start(&c.core, argv[2], c.kind->model, c.kind->fpu);
    if (code == 0 && c.kind->family->boot)
        code = c.kind->family->boot(&c);
    if (code == 0)
        code = host_record_open(&c.stream.pins.record, &o);
    if (code == 0)
        code = chip_line_open(&c.line, o.link, socket);
    if (code != 0)
        return code;
    run_chip(&c);
    chip_line_close(&c.line);
    int closed = host_record_close(&c.stream.pins.record, &o);
    if (closed == 0)
        closed = save_flash(&c.flash, flash);
    return c.core.failed ? EX_SOFTWARE : closed;
}
