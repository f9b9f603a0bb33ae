/* tests/target/avr_core.c
 * SPDX-License-Identifier: MIT
 */
#include "avr_core.h"

#include <simavr/avr_extint.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <stdio.h>
#include <string.h>
#include <sysexits.h>

#define UNMETERED   32              /* cycles between two checks without a meter */

static void byte_out(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct avr_core *c = param;

    (void)irq;
    c->heard = c->avr->cycle;
    c->given++;
    c->out(c->context, (uint8_t)value);
}

/* simavr counts eleven bits per byte; the real line has ten. */
static void correct_baud(struct avr_core *c)
{
    const uint32_t divider = 1u + (c->avr->data[c->uart->ubrrl.reg] |
                                   (uint32_t)(c->avr->data[c->uart->ubrrh.reg] & 15) << 8);

    c->byte_cycles = divider * (avr_regbit_get(c->avr, c->uart->u2x) ? 80u : 160u);
    c->uart->cycles_per_byte = c->byte_cycles;
}

/* One byte per ten bits. Two wait in the chip; a third one is lost on silicon, so it is counted. */
static void give_byte(struct avr_core *c)
{
    if (c->silence && c->in_tail == c->silent_at) {
        c->free_at = c->avr->cycle + c->silence;
        c->silence = 0;
    }
    if (c->in_tail == c->in_head || c->avr->cycle < c->free_at)
        return;
    correct_baud(c);
    if (((c->uart->input.write - c->uart->input.read) & 63) > 2)
        c->overruns++;
    avr_raise_irq(c->input, c->in[c->in_tail++]);
    c->received++;
    c->heard = c->avr->cycle;
    c->free_at = (c->free_at + c->byte_cycles > c->avr->cycle ? c->free_at : c->avr->cycle) +
                 c->byte_cycles + 8;
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

int avr_core_start(struct avr_core *c, const char *file, uint32_t tick_pc)
{
    static elf_firmware_t firmware;
    uint32_t flags = 0;

    avr_global_logger_set(quiet_log);
    if (elf_read_firmware(file, &firmware) != 0 ||
        (c->avr = avr_make_mcu_by_name("atmega328p")) == NULL) {
        fprintf(stderr, "%s: cannot be loaded\n", file);
        return EX_NOINPUT;
    }
    avr_init(c->avr);
    avr_load_firmware(c->avr, &firmware);
    c->avr->frequency = AVR_HZ;
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
    return 0;
}

bool avr_core_run(struct avr_core *c, uint32_t cycles, bool metered)
{
    const uint64_t until = c->avr->cycle + cycles;

    c->avr->run_cycle_limit = metered ? 1 : UNMETERED;
    while (c->avr->cycle < until) {
        if (metered)
            meter_run(&c->meter);
        else
            avr_run(c->avr);
        give_byte(c);
        if (c->avr->state == cpu_Done || c->avr->state == cpu_Crashed) {
            fprintf(stderr, "chip: the firmware has stopped at %#x\n", (unsigned)c->avr->pc);
            return false;
        }
    }
    return true;
}
