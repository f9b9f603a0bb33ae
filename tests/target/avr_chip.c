/* tests/target/chip.c -- an ATmega328P in libsimavr, cycle by cycle, behind a pseudo terminal
 * SPDX-License-Identifier: MIT
 * usage: chip FIRMWARE.elf --tick ADDRESS --ring HEAD,TAIL [--link PATH] [--record FILE] [--steps N] [--profile FILE]
 *
 * Bytes pass at the baud rate that the firmware has set, ten bits each. The chip's time stands while it is the host's turn
 * (avr_gate.h). Ends when a job has been drawn and closed, with lines `name value` on standard output.
 */
#include <simavr/avr_extint.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>
#include <time.h>
#include <unistd.h>

#include "avr_gate.h"
#include "host/line.h"          /* the pseudo terminal  */
#include "avr_meter.h"

#define HZ          16000000
#define BATCH       (HZ / 1000)     /* cycles between two looks at the line                           */
#define SETTLE      (HZ / 50)       /* after the last byte, to answer it                              */
#define QUIET_MS    400             /* of real time without a byte that is owed: the sender is gone   */
#define LEAVE_MS    1000            /* for the last answer to be read                                 */

struct chip {
    avr_t *avr;
    avr_uart_t *uart;
    avr_irq_t *input;
    uint32_t byte_cycles;
    struct meter meter;
    struct gate gate;
    struct host_line line;
    uint8_t in[65536], out[65536];      /* from the host, to the host; indices wrap */
    uint16_t in_head, in_tail, out_head, out_tail;
    uint64_t free_at;                   /* when the line to the chip is free again   */
    uint64_t heard;                     /* cycle of the last byte either way         */
    uint64_t received, given, overruns;
    uint32_t given_up;                  /* the limit up to which the host has not sent in time */
    uint32_t waits;                     /* how often it has not                                */
};

static volatile sig_atomic_t stop_wanted;

static void want_stop(int signal)
{
    (void)signal;
    stop_wanted = 1;
}

static int64_t now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}


// The serial port of the chip
// ---------------------------

static void byte_out(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct chip *c = param;

    (void)irq;
    c->out[c->out_head++] = (uint8_t)value;
    c->heard = c->avr->cycle;
    c->given++;
    gate_machine(&c->gate, (uint8_t)value);
}

/* simavr counts eleven bits per byte; a byte has ten. */
static void correct_baud(struct chip *c)
{
    const uint32_t divider = 1u + (c->avr->data[c->uart->ubrrl.reg] | (uint32_t)(c->avr->data[c->uart->ubrrh.reg] & 15) << 8);

    c->byte_cycles = divider * (avr_regbit_get(c->avr, c->uart->u2x) ? 80u : 160u);
    c->uart->cycles_per_byte = c->byte_cycles;
}

/* One byte each ten bits. Two wait in the chip; a third one that comes then is lost on silicon, so it is counted. */
static void give_byte(struct chip *c)
{
    if (c->in_tail == c->in_head || c->avr->cycle < c->free_at)
        return;
    correct_baud(c);
    if (((c->uart->input.write - c->uart->input.read) & 63) > 2)
        c->overruns++;
    avr_raise_irq(c->input, c->in[c->in_tail++]);
    c->received++;
    c->heard = c->avr->cycle;
    c->free_at = (c->free_at + c->byte_cycles > c->avr->cycle ? c->free_at : c->avr->cycle) + c->byte_cycles + 8;
}

static void no_sleep(avr_t *avr, avr_cycle_count_t cycles)
{
    (void)avr;
    (void)cycles;
}

static void quiet_log(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

static int start(struct chip *c, const char *file, uint32_t tick_pc)
{
    static elf_firmware_t firmware;
    uint32_t flags = 0;

    avr_global_logger_set(quiet_log);
    if (elf_read_firmware(file, &firmware) != 0 || (c->avr = avr_make_mcu_by_name("atmega328p")) == NULL) {
        fprintf(stderr, "chip: %s: cannot be loaded\n", file);
        return EX_NOINPUT;
    }
    avr_init(c->avr);
    avr_load_firmware(c->avr, &firmware);
    c->avr->frequency = HZ;
    c->avr->sleep = no_sleep;
    avr_extint_set_strict_lvl_trig(c->avr, 0, 0);
    avr_extint_set_strict_lvl_trig(c->avr, 1, 0);
    avr_ioctl(c->avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);

    avr_irq_t *uart = avr_io_getirq(c->avr, AVR_IOCTL_UART_GETIRQ('0'), 0);
    c->input = uart + UART_IRQ_INPUT;
    avr_irq_register_notify(uart + UART_IRQ_OUTPUT, byte_out, c);
    for (avr_io_t *io = c->avr->io_port; io; io = io->next)
        if (strcmp(io->kind, "uart") == 0)
            c->uart = (avr_uart_t *)io;
    meter_init(&c->meter, c->avr, tick_pc);
    gate_init(&c->gate);
    return 0;
}


// The line to the host
// --------------------

static void take_bytes(struct chip *c)
{
    uint8_t byte[256];
    const size_t count = host_line_read(&c->line, byte, sizeof byte);

    for (size_t i = 0; i < count; i++) {
        c->in[c->in_head++] = byte[i];
        gate_host(&c->gate, byte[i]);
    }
}

static void give_bytes(struct chip *c)
{
    while (c->out_tail != c->out_head) {
        const size_t most = c->out_head > c->out_tail ? (size_t)(c->out_head - c->out_tail) : sizeof c->out - c->out_tail;
        const size_t count = host_line_write(&c->line, c->out + c->out_tail, most);
        if (count == 0)
            return;
        c->out_tail = (uint16_t)(c->out_tail + count);
    }
}

static bool pending(const struct chip *c)
{
    return c->in_tail != c->in_head || c->avr->cycle - c->heard < SETTLE;
}

/* Let the host speak while it is its turn: in mid-job until it has sent what it may, else until it says anything. A host
 * that did not is given up until it may send more. */
static void wait_for_host(struct chip *c)
{
    const bool busy = gate_busy(&c->gate);
    const int64_t began = now_ms();
    sigset_t none;

    sigemptyset(&none);
    for (;;) {
        const uint16_t before = c->in_head;
        give_bytes(c);
        take_bytes(c);
        if (stop_wanted || (busy ? !gate_owed(&c->gate) : c->in_head != before))
            return;
        if (busy && now_ms() - began > QUIET_MS) {
            c->given_up = c->gate.ack.limit;
            c->waits++;
            return;
        }
        host_line_wait(&c->line, c->out_tail != c->out_head, busy ? 20 : -1, &none);
    }
}

static void run(struct chip *c)
{
    while (c->gate.jobs == 0 && !stop_wanted) {
        const uint64_t until = c->avr->cycle + BATCH;
        while (c->avr->cycle < until) {
            meter_run(&c->meter);
            give_byte(c);
            if (c->avr->state == cpu_Done || c->avr->state == cpu_Crashed) {
                fprintf(stderr, "chip: the firmware has stopped at %#x\n", c->avr->pc);
                return;
            }
        }
        give_bytes(c);
        if (gate_busy(&c->gate) ? gate_owed(&c->gate) && c->gate.ack.limit != c->given_up : !pending(c))
            wait_for_host(c);
        else
            take_bytes(c);
    }
    for (const int64_t began = now_ms(); now_ms() - began < LEAVE_MS;) {
        give_bytes(c);
        usleep(30000);                  /* a pseudo terminal passes bytes on when it likes */
        if (c->out_tail == c->out_head && host_line_drained(&c->line))
            break;
    }
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
    const struct meter *m = &c->meter;
    const uint64_t slots = m->armed ? m->slot_last - m->slot_first : 1;

    print_context("slot", &m->context[SLOT]);
    print_context("tick", &m->context[TICK]);
    print_context("receive", &m->context[RECEIVE]);
    printf("slot_period %u\nslot_late %llu\nslots_missed %llu\nslots_empty %llu\n", m->period, (unsigned long long)m->slot_late, (unsigned long long)meter_missed(m),
           (unsigned long long)m->starved);
    printf("load %.3f\n", (double)(m->context[SLOT].cycles + m->context[TICK].cycles + m->context[RECEIVE].cycles) / (double)slots);
    print_least("pulse_least", m->pulse_least);
    print_least("setup_least", m->setup_least);
    print_least("hold_least", m->hold_least);
    print_least("between_least", m->between_least);
    printf("pulses %llu %llu %llu\n", (unsigned long long)m->pulses[0], (unsigned long long)m->pulses[1], (unsigned long long)m->pulses[2]);
    printf("position %d %d %d\n", (int)m->record.position[0], (int)m->record.position[1], (int)m->record.position[2]);
    printf("stack %d\nstack_at %#x\n", 0x8FF - m->deepest, (unsigned)m->deepest_pc);
    printf("bytes_received %llu\nbytes_given %llu\noverruns %llu\nnaks %u\nhost_late %u\n", (unsigned long long)c->received, (unsigned long long)c->given,
           (unsigned long long)c->overruns, (unsigned)c->gate.naks, (unsigned)c->waits);
    printf("byte_cycles %u\nseconds %.6f\n", c->byte_cycles, (double)c->avr->cycle / HZ);
}

static int write_profile(const struct chip *c, const char *file)
{
    FILE *f = fopen(file, "w");

    if (f == NULL)
        return EX_CANTCREAT;
    for (uint32_t i = 0; i < 16384; i++)
        if (c->meter.profile[i])
            fprintf(f, "%u %u\n", 2 * i, c->meter.profile[i]);
    return fclose(f) == 0 ? 0 : EX_IOERR;
}

int main(int argc, char **argv)
{
    static struct chip c;
    struct loft_host_options o = loft_host_defaults();
    const char *profile = NULL, *tick = "0", *ring = "0,0";
    double steps = 250;

    o.tick_hz = 1000;
    o.slots = HZ / 1000;                /* the record counts cycles */
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--tick") == 0)    tick = argv[i + 1];
        if (strcmp(argv[i], "--ring") == 0)    ring = argv[i + 1];
        if (strcmp(argv[i], "--link") == 0)    o.link = argv[i + 1];
        if (strcmp(argv[i], "--record") == 0)  o.record = argv[i + 1];
        if (strcmp(argv[i], "--steps") == 0)   steps = atof(argv[i + 1]);
        if (strcmp(argv[i], "--profile") == 0) profile = argv[i + 1];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        o.steps_per_mm[i] = steps;
    int code = argc < 2 ? EX_USAGE : start(&c, argv[1], (uint32_t)strtoul(tick, NULL, 0));
    if (code == 0)
        code = host_record_open(&c.meter.record, &o);
    if (code == 0)
        code = host_line_open(&c.line, o.link, 0);
    if (code != 0)
        return code;
    char *tail;
    c.meter.ring_head = (uint16_t)strtoul(ring, &tail, 0);
    c.meter.ring_tail = (uint16_t)strtoul(*tail ? tail + 1 : tail, NULL, 0);
    c.meter.profile = profile ? calloc(16384, sizeof *c.meter.profile) : NULL;
    printf("machine: %s\n", c.line.name);
    fflush(stdout);
    signal(SIGTERM, want_stop);
    run(&c);
    meter_flush(&c.meter);
    host_line_close(&c.line);
    print_results(&c);
    code = host_record_close(&c.meter.record, &o);
    return profile && code == 0 ? write_profile(&c, profile) : code;
}
