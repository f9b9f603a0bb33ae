/* ports/mps2/port.c -- Arm's MPS2 boards, as AN385 (Cortex-M3), AN386 (M4), AN500 (M7) and AN505
 * (M33): three axes
 * SPDX-License-Identifier: MIT
 *
 *     step  GPIO0 0..2     dir  GPIO0 3..5     line  UART0, 8N1
 *     limits  GPIO1 0..2, closing to 3.3 V    buttons  GPIO1 3 abort, 4 hold, 5 resume, closing to
 *             3.3 V; each with a resistor to ground
 *
 * Registers: Arm's Cortex-M System Design Kit. MPS2_BASE is 0x40000000, with AN505 its secure alias
 * 0x50000000 and the blocks 2 MB higher; the rules give it, and the clock in Hz.
 */
#include "cortex-m/cortex.h"
#include "port.h"
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200
#endif
#define PULSE   (MPS2_CLOCK / 500000)   /* 2 us */

#define STEPS   0x07u
#define DIR_AT  3
#define CELLS   1024
#include "plans.h"

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(160), LOFT_RAW(1000), 20000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = 40, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 160,
    .cell = cells,
    .cells = CELLS
};

loft_machine_config *loft_port_init(void)
{
    config.info.boot = cortex_starts();
    REG(MPS2_GPIO0 + 0x10) = STEPS | STEPS << DIR_AT;   /* OUTENSET                  */
    REG(MPS2_UART0 + 0x10) = MPS2_CLOCK / LOFT_BAUD;    /* BAUDDIV, at least 16      */
    REG(MPS2_UART0 + 0x08) = 1 << 3 | 1 << 1 | 1 << 0;  /* both ways, with interrupt */
    loft_port_plans(&config);
    return &config;
}

void loft_port_start(uint32_t slot_hz)
{
    cortex_enable(CORTEX_LINE_IRQ, 0);
    cortex_systick(MPS2_CLOCK / slot_hz);
    cortex_interrupts();
}

void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    static uint8_t dir_last;
    const uint32_t dir = (uint32_t)dir_bits << DIR_AT;

    if (dir_bits != dir_last) {
        REG(MPS2_GPIO0 + 0x04) = dir;
        dir_last = dir_bits;
    }
    if (step_bits) {
        REG(MPS2_GPIO0 + 0x04) = dir | step_bits;
        cortex_delay(PULSE);
        REG(MPS2_GPIO0 + 0x04) = dir;
    }
}

void cortex_line(void)
{
    REG(MPS2_UART0 + 0x0C) = 1 << 1;
    loft_port_byte((uint8_t)REG(MPS2_UART0 + 0x00));
}

size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0 || REG(MPS2_UART0 + 0x04) & 1 << 0)
        return 0;
    REG(MPS2_UART0 + 0x00) = *bytes;
    return 1;
}

uint16_t loft_port_inputs(void) { return loft_switches_of(REG(MPS2_GPIO1 + 0x00)); }
