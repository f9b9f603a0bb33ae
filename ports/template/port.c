/* ports/template/port.c -- a board that does nothing: copy this file and fill in the bodies
 * SPDX-License-Identifier: MIT
 *
 * It compiles as it is, with any C99 compiler:
 *     cc -std=c99 -Ilib -Iports -c ports/template/port.c
 */
#include "machine/machine.h"    /* loft_machine: all that a firmware needs */
#include "port.h"

/* The machine: what it is, where it stands, and the memory of its queue. Values in mm go through LOFT_RAW. */
#define AXIS { LOFT_RAW(80), LOFT_RAW(200), LOFT_RAW(1000) }    /* steps/mm, mm/s, mm/s^2 */

static volatile loft_cell cells[LOFT_MACHINE_QUEUE];
static loft_machine machine;
static loft_machine_config config = {
    .traits = { .boot = 1, .tick_hz = 1000, .slots = 25, .axis = { AXIS } },
    .ramp = 50, .cell = cells, .cells = LOFT_MACHINE_QUEUE
};


// The board
// ---------

/* Set the clock, make the step and direction pins outputs, open the serial line at the rate that the host uses. Put
 * another number into config.traits.boot at each start (a counter in flash, noise from an unconnected ADC pin): the host
 * tells by it that the machine restarted and lost its position. */
void loft_port_init(void)
{
    for (int i = 1; i < LOFT_AXES; i++)
        config.traits.axis[i] = config.traits.axis[0];
}

/* Let a timer interrupt call loft_port_slot at `slot_hz`, then enable interrupts. */
void loft_port_start(uint32_t slot_hz)
{
    (void)slot_hz;
}

/* Write the direction pins, then raise the step pins; lower them some microseconds later, with a second compare of the
 * same timer or at the next call. */
void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    (void)step_bits;
    (void)dir_bits;
}

/* Take what the receive interrupt has put into a ring buffer; port.h says how large it should be. */
size_t loft_port_read(uint8_t *bytes, size_t max)
{
    (void)bytes;
    (void)max;
    return 0;
}

/* Put into the ring buffer of the transmit interrupt as much as fits. */
size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    (void)bytes;
    return count;
}


// The firmware: the same on every board
// -------------------------------------

void loft_port_slot(void)
{
    const loft_pins pins = loft_machine_slot(&machine);
    loft_port_pins(pins.step, pins.dir);
    loft_machine_tick(&machine);            /* on a slow part: not here, see port.h */
}

int main(void)
{
    uint8_t byte[32], wire[LOFT_FRAME_MAX];
    size_t count = 0, sent = 0;

    loft_port_init();
    if (loft_machine_init(&machine, &config) != LOFT_OK)
        return 1;                           /* the configuration does not fit: see drive.h */
    loft_port_start((uint32_t)config.traits.tick_hz * config.traits.slots);
    for (;;) {
        loft_machine_push(&machine, byte, loft_port_read(byte, sizeof byte));
        if (sent == count) {
            sent = 0;
            count = loft_machine_poll(&machine, wire);
        }
        sent += loft_port_write(wire + sent, count - sent);
    }
}
