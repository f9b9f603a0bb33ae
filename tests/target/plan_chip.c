/* tests/target/plan_chip.c -- runs the planner on an emulated AVR chip: its spans, its cycles and
 * its stack
 * SPDX-License-Identifier: MIT
 * usage: plan_chip FIRMWARE.elf CHIP SPAN_ADDRESS ; spans to standard output, `cycles N` and `stack
 * N` to standard error
 */
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#include "motion/span.h"        /* LOFT_AXES */

#define GPIOR0  0x3E
#define AT_MOST (UINT64_C(16000000) * 60)

static uint64_t begun;
static uint16_t span_at;

static int32_t word(const avr_t *avr, int at)
{
    int32_t x;
    memcpy(&x, avr->data + span_at + at, sizeof x);
    return x;
}

static void told(avr_t *avr, avr_io_addr_t address, uint8_t value, void *param)
{
    (void)address;
    (void)param;
    if (value == 2)
        begun = avr->cycle;
    if (value != 1)
        return;
    printf("%d", (int)(word(avr, 16 * LOFT_AXES) & 0xffff));
    for (int k = 0; k < 4 * LOFT_AXES; k++)
        printf(" %ld", (long)word(avr, 4 * k));
    printf("\n");
}

static void quiet_log(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

int main(int argc, char **argv)
{
    static elf_firmware_t firmware;
    avr_t *avr = argc == 4 ? avr_make_mcu_by_name(argv[2]) : NULL;
    uint16_t deepest = UINT16_MAX;

    avr_global_logger_set(quiet_log);
    if (avr == NULL || elf_read_firmware(argv[1], &firmware) != 0)
        return EX_USAGE;
    avr_init(avr);
    avr_load_firmware(avr, &firmware);
    avr->frequency = 16000000;
    avr->run_cycle_limit = 1;
    span_at = (uint16_t)strtoul(argv[3], NULL, 16);
    avr_register_io_write(avr, GPIOR0, told, NULL);
    while (avr->cycle < AT_MOST) {
        const uint32_t pc = avr->pc;
        const unsigned instruction = (unsigned)(avr->flash[pc] | avr->flash[pc + 1] << 8);
        const int state = avr_run(avr);
        const uint16_t sp = (uint16_t)(avr->data[R_SPL] | avr->data[R_SPH] << 8);
        /* not between the writes of its two bytes */
        if (begun && sp < deepest && instruction >> 9 != 0xBF >> 1)
            deepest = sp;
        if (state == cpu_Sleeping || state == cpu_Done || state == cpu_Crashed)
            break;
    }
    fprintf(stderr, "cycles %llu\nstack %d\n", (unsigned long long)(avr->cycle - begun),
            (int)avr->ramend - deepest);
    return avr->state == cpu_Crashed;
}
