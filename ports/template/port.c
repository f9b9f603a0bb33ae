/* ports/template/port.c -- a board that does nothing: copy this file and fill in the bodies
 * SPDX-License-Identifier: MIT
 *
 * It compiles as it is, with any C99 compiler:
 *     cc -std=c99 -Ilib -Iports -c ports/template/port.c
 */
#include "port.h"

/* The machine. Values in mm go through LOFT_RAW. */
/* steps/mm, mm/s, mm/s^2, mm/s^3 or 0 */
#define AXIS { LOFT_RAW(80), LOFT_RAW(200), LOFT_RAW(1000), 0 }

static volatile loft_cell cells[LOFT_MACHINE_QUEUE];
static loft_machine_config config = {
    .info = { .boot = 1, .tick_hz = 1000, .slots = 25, .axis = { AXIS } },
    .ramp = 50,
    .cell = cells,
    .cells = LOFT_MACHINE_QUEUE
};

/* Set up the clock. Make the step and direction pins outputs. Open the serial line at the host's
 * rate, and let its receive interrupt pass each byte to loft_port_byte. */
loft_machine_config *loft_port_init(void)
{
    for (int i = 1; i < LOFT_AXES; i++)
        config.info.axis[i] = config.info.axis[0];
    return &config;
}

/* Let a timer interrupt call loft_port_slot and loft_port_tick at `slot_hz`, then enable
 * interrupts. */
void loft_port_start(uint32_t slot_hz) { (void)slot_hz; }

/* Write the direction pins, then raise the step pins; lower them some microseconds later, with a
 * second compare of the same timer or at the next call. */
void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    (void)step_bits;
    (void)dir_bits;
}

/* Put as many bytes into the transmitter as fit. */
size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    (void)bytes;
    return count;
}

/* Drive a laser, a spindle, a coolant: a duty cycle of level / 65535. Their number is
 * `.outputs` of the info. A pin floats while the chip is in reset: give it a resistor to its off
 * side. */
void loft_port_output(int output, uint16_t level)
{
    (void)output;
    (void)level;
}

/* Read the pins of limit switches and buttons: see switches.h. */
uint16_t loft_port_inputs(void) { return 0; }

/* The instruction that sleeps until an interrupt. */
void loft_port_wait(void) {}
