/* tests/target/avr_chip.c -- the emulated chip behind a pseudo terminal
 * SPDX-License-Identifier: MIT
 * usage: chip FIRMWARE.elf --tick ADDRESS [--link PATH] [--record FILE] [--steps N] [--profile
 * FILE] [--touch STEPS[,MS]] [--jobs N] [--eeprom FILE] [--states FILE]
 * [--starve ITEMS]
 *
 * --touch: the limit switch of x closes with the pulse of x that reaches STEPS, and bounces for MS;
 * behind STEPS, seen from 0, it is closed, and before it is open.
 *
 * --eeprom: FILE holds the EEPROM between two runs.
 * --starve: after so many items of a job, and after twice as many, the line is silent for 1 s.
 * --states: FILE gets the EEPROM after each byte that is written to it, one after the other.
 *
 * The chip's time stops while it is the host's turn (avr_gate.h). The program ends when N jobs, or
 * one, have been drawn and closed, and prints lines `name value`.
 */
#include <simavr/avr_eeprom.h>
#include <simavr/avr_ioport.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#include "avr_core.h"
#include "chip_line.h"

#define HZ          AVR_HZ
#define BATCH       (HZ / 1000)     /* cycles between two checks of the line */
#define SETTLE      (HZ / 50)       /* after the last byte, time to answer it: */
#define KEEPS       (HZ / 5)        /* more while it writes to its EEPROM, 3.3 ms a byte */
#define EECR        0x3F
#define EEPROM      1024
#define BOUNCE      (HZ / 10000)    /* cycles between two changes of a contact, at least */

struct chip {
    struct avr_core core;
    struct chip_line line;
    int32_t x, touch;                   /* steps of x at the pins; where its switch closes or 0 */
    bool closed, level;                 /* the switch, and its contact that bounces */
    avr_cycle_count_t bounce;           /* cycles, and until when */
    avr_cycle_count_t settled;
    uint32_t jobs;                      /* until it ends */
    uint32_t starve, silences;          /* items, 0: never; how often it was silent */
    const char *eeprom;                 /* a file, or NULL */
    FILE *states;                       /* of the EEPROM, or NULL */
    uint8_t written[EEPROM];            /* the latest of them */
    avr_io_write_t control;             /* what simavr does when EECR is written */
    void *control_of;
};


// The switch of x: D9, low when closed
// ------------------------------------

/* It stays so when the firmware writes to the port. */
static void set_switch(avr_t *avr, bool closed)
{
    avr_ioport_external_t pin = { .name = 'B', .mask = 1 << 1, .value = closed ? 0 : 1 << 1 };

    avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL('B'), &pin);
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), 1), !closed);
}

static avr_cycle_count_t bounces(avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct chip *c = param;

    c->level = when >= c->settled ? c->closed : !c->level;
    set_switch(avr, c->level);
    return when >= c->settled ? 0 : when + BOUNCE + when * 7 % (BOUNCE * 3);
}

static void x_steps(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct chip *c = param;
    avr_t *avr = c->core.avr;

    (void)irq;
    if (!value)
        return;
    c->x += avr->data[0x2B] & 0x20 ? -1 : 1;
    const bool closed = c->touch < 0 ? c->x <= c->touch : c->x >= c->touch;
    if (closed == c->closed)
        return;
    c->closed = c->level = closed;
    c->settled = avr->cycle + c->bounce + 1;
    set_switch(avr, closed);
    avr_cycle_timer_cancel(avr, bounces, c);
    if (c->bounce)
        avr_cycle_timer_register(avr, BOUNCE, bounces, c);
}

static void watch_x(struct chip *c, const char *touch)
{
    char *tail;

    c->touch = (int32_t)strtol(touch, &tail, 0);
    c->bounce = (avr_cycle_count_t)(*tail ? atof(tail + 1) : 0) * (HZ / 1000);
    if (c->touch)
        avr_irq_register_notify(avr_io_getirq(c->core.avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 2),
                                x_steps, c);
}


// The EEPROM
// ----------

/* A file that is not there is an EEPROM that was never written. */
static void load_eeprom(struct chip *c)
{
    uint8_t byte[EEPROM];
    avr_eeprom_desc_t all = { .ee = byte, .offset = 0, .size = EEPROM };
    FILE *f = c->eeprom ? fopen(c->eeprom, "rb") : NULL;

    if (f == NULL)
        return;
    if (fread(byte, 1, EEPROM, f) == EEPROM)
        avr_ioctl(c->core.avr, AVR_IOCTL_EEPROM_SET, &all);
    fclose(f);
}

/* The firmware has written to EECR: that writes a byte at most. */
static void follow_eeprom(avr_t *avr, avr_io_addr_t at, uint8_t value, void *param)
{
    struct chip *c = param;
    avr_eeprom_desc_t all = { .ee = NULL, .offset = 0, .size = EEPROM };

    c->control(avr, at, value, c->control_of);
    avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &all);
    if (memcmp(c->written, all.ee, EEPROM) == 0)
        return;
    memcpy(c->written, all.ee, EEPROM);
    fwrite(c->written, 1, EEPROM, c->states);
}

static void watch_eeprom(struct chip *c)
{
    avr_t *avr = c->core.avr;
    avr_eeprom_desc_t all = { .ee = c->written, .offset = 0, .size = EEPROM };

    if (c->states == NULL)
        return;
    avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &all);
    c->control = avr->io[AVR_DATA_TO_IO(EECR)].w.c;
    c->control_of = avr->io[AVR_DATA_TO_IO(EECR)].w.param;
    avr->io[AVR_DATA_TO_IO(EECR)].w.c = follow_eeprom;
    avr->io[AVR_DATA_TO_IO(EECR)].w.param = c;
}

static int save_eeprom(const struct chip *c)
{
    avr_eeprom_desc_t all = { .ee = NULL, .offset = 0, .size = EEPROM };
    FILE *f = c->eeprom ? fopen(c->eeprom, "wb") : NULL;

    if (f == NULL)
        return c->eeprom ? EX_CANTCREAT : 0;
    avr_ioctl(c->core.avr, AVR_IOCTL_EEPROM_GET, &all);
    const size_t written = fwrite(all.ee, 1, EEPROM, f);
    return fclose(f) == 0 && written == EEPROM ? 0 : EX_IOERR;
}


// The line to the host
// --------------------

static void byte_out(void *context, uint8_t byte)
{
    struct chip *c = context;

    chip_line_out(&c->line, byte);
}

/* The line is silent behind the frame with that item, whenever the host sends it. */
static void byte_in(void *context, uint8_t byte)
{
    struct chip *c = context;

    if (c->starve && c->silences < 2 && c->line.gate.sent >= c->starve * (c->silences + 1)) {
        c->silences++;
        c->core.silent_at = c->core.in_head;
        c->core.silence   = HZ;
    }
    avr_core_put(&c->core, byte);
}

static bool bytes_pending(const struct chip *c)
{
    const uint64_t settle = c->eeprom ? KEEPS : SETTLE;

    return c->core.in_tail != c->core.in_head || c->core.avr->cycle - c->core.heard < settle;
}

static void run_chip(struct chip *c)
{
    while (c->line.gate.jobs < c->jobs && !chip_line_stopped()) {
        if (!avr_core_run(&c->core, BATCH, true))
            return;
        chip_line_turn(&c->line, bytes_pending(c));
    }
    chip_line_leave(&c->line);
}


// What it came to
// ---------------

static void print_context(const char *name, const struct meter_context *c)
{
    printf("%s_calls %llu\n%s_mean %.1f\n%s_most %u\n", name, (unsigned long long)c->calls, name,
           c->calls ? (double)c->cycles / (double)c->calls : 0.0, name, c->most);
}

static void print_least(const char *name, uint64_t cycles)
{
    if (cycles != UINT64_MAX)
        printf("%s %llu\n", name, (unsigned long long)cycles);
}

static void print_results(const struct chip *c)
{
    const struct meter *m = &c->core.meter;
    const uint64_t slots = m->armed ? m->slot_last - m->slot_first : 1;

    print_context("slot", &m->context[SLOT]);
    print_context("tick", &m->context[TICK]);
    print_context("receive", &m->context[RECEIVE]);
    printf("slot_period %u\nslot_late %llu\nslots_missed %llu\nslots_empty %llu\n", m->period,
           (unsigned long long)m->slot_late, (unsigned long long)meter_missed(m),
           (unsigned long long)m->starved);
    printf("load %.3f\n", (double)(m->context[SLOT].cycles + m->context[TICK].cycles +
                                   m->context[RECEIVE].cycles) /
                              (double)slots);
    print_least("ring_least", m->left_least);
    print_least("pulse_least", m->pulse_least);
    print_least("setup_least", m->setup_least);
    print_least("hold_least", m->hold_least);
    print_least("between_least", m->between_least);
    printf("pulses %llu %llu %llu\n", (unsigned long long)m->pulses[0],
           (unsigned long long)m->pulses[1], (unsigned long long)m->pulses[2]);
    printf("position %d %d %d\n", (int)m->record.position[0], (int)m->record.position[1],
           (int)m->record.position[2]);
    printf("stack %d\nstack_at %#x\n", 0x8FF - m->deepest, (unsigned)m->deepest_pc);
    printf("bytes_received %llu\nbytes_given %llu\noverruns %llu\nnaks %u\nhost_late %u\n",
           (unsigned long long)c->core.received, (unsigned long long)c->core.given,
           (unsigned long long)c->core.overruns, (unsigned)c->line.gate.naks,
           (unsigned)c->line.waits);
    printf("silences %u\n", (unsigned)c->silences);
    printf("byte_cycles %u\nseconds %.6f\n", c->core.byte_cycles, (double)c->core.avr->cycle / HZ);
}

static int write_profile(const struct chip *c, const char *file)
{
    FILE *f = fopen(file, "w");

    if (f == NULL)
        return EX_CANTCREAT;
    for (uint32_t i = 0; i < 16384; i++)
        if (c->core.meter.profile[i])
            fprintf(f, "%u %u\n", 2 * i, c->core.meter.profile[i]);
    return fclose(f) == 0 ? 0 : EX_IOERR;
}

int main(int argc, char **argv)
{
    static struct chip c;
    struct loft_host_options o = loft_host_defaults();
    const char *touch = "0";
    const char *profile = NULL, *tick = "0";
    double steps = 250;

    o.tick_hz = 1000;
    o.slots = HZ / 1000;                /* the record counts cycles */
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--tick") == 0)
            tick = argv[i + 1];
        if (strcmp(argv[i], "--link") == 0)
            o.link = argv[i + 1];
        if (strcmp(argv[i], "--record") == 0)
            o.record = argv[i + 1];
        if (strcmp(argv[i], "--steps") == 0)
            steps = atof(argv[i + 1]);
        if (strcmp(argv[i], "--touch") == 0)
            touch = argv[i + 1];
        if (strcmp(argv[i], "--jobs") == 0)
            c.jobs = (uint32_t)strtoul(argv[i + 1], NULL, 0);
        if (strcmp(argv[i], "--starve") == 0)
            c.starve = (uint32_t)strtoul(argv[i + 1], NULL, 0);
        if (strcmp(argv[i], "--eeprom") == 0)
            c.eeprom = argv[i + 1];
        if (strcmp(argv[i], "--states") == 0 && (c.states = fopen(argv[i + 1], "wb")) == NULL)
            return EX_CANTCREAT;
        if (strcmp(argv[i], "--profile") == 0)
            profile = argv[i + 1];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = steps;
    c.jobs += c.jobs == 0;
    c.core.out = byte_out;
    c.core.context = &c;
    c.line.put = byte_in;
    c.line.context = &c;
    int code = argc < 2 ? EX_USAGE
                        : avr_core_start(&c.core, argv[1], (uint32_t)strtoul(tick, NULL, 0));
    if (code == 0) {
        watch_x(&c, touch);
        load_eeprom(&c);
        watch_eeprom(&c);
        code = host_record_open(&c.core.meter.record, &o);
    }
    if (code == 0)
        code = chip_line_open(&c.line, o.link, NULL);
    if (code != 0)
        return code;
    c.core.meter.profile = profile ? calloc(16384, sizeof *c.core.meter.profile) : NULL;
    run_chip(&c);
    meter_flush(&c.core.meter);
    chip_line_close(&c.line);
    print_results(&c);
    code = host_record_close(&c.core.meter.record, &o);
    if (code == 0)
        code = save_eeprom(&c);
    if (c.states && fclose(c.states) != 0)
        code = EX_IOERR;
    return profile && code == 0 ? write_profile(&c, profile) : code;
}
