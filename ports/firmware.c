/* ports/firmware.c -- the firmware: the part that all boards share
 * SPDX-License-Identifier: MIT
 */
#include "port.h"
#include "ring.h"
#include "switches.h"

static loft_machine machine;
static loft_ring line;
static volatile uint32_t slots;         /* since the start */

void loft_port_slot(void)
{
    const loft_pins pins = loft_machine_slot(&machine);

    loft_port_pins(pins.step, pins.dir);
    if (loft_machine_senses(&machine))
        loft_machine_sense(&machine, loft_port_inputs());
    slots = slots + 1;
}

void loft_port_tick(void)
{
    static uint16_t given[LOFT_MACHINE_OUTPUTS + 1];

    loft_machine_tick(&machine);
    for (int k = 1; k <= machine.drive.output_count; k++) {
        const uint16_t level = loft_drive_output(&machine.drive, k);
        if (level != given[k]) {
            given[k] = level;
            loft_port_output(k, level);
        }
    }
}

loft_step_tick *loft_port_take(uint8_t *count, uint8_t *dir)
{
    loft_step_tick *taken = loft_drive_take(&machine.drive, count, dir);

    slots = slots + *count;
    return taken;
}

bool loft_port_waits(void) { return loft_machine_senses(&machine); }

bool loft_port_changed(void)
{
    return loft_machine_senses(&machine) && loft_latch_wanted(&machine.latch, loft_port_inputs());
}

void loft_port_latch(const int32_t ahead[LOFT_AXES])
{
    int32_t at[LOFT_AXES];

    loft_step_position(&machine.drive.step, at);
    for (int i = 0; i < LOFT_AXES; i++)
        at[i] -= ahead[i];
    loft_latch_keep(&machine.latch, at);
}

void loft_port_byte(uint8_t byte) { loft_ring_put(&line, byte); }

/* Sample the switches about once per `every` slots. */
static void watch_switches(uint32_t every)
{
    static loft_switches switches;
    static uint32_t sampled;

    if (slots - sampled < every)
        return;
    sampled = slots;
    const uint16_t closed = loft_port_inputs();
    loft_machine_sample(&machine, closed);
    if (loft_switches_steady(&switches, closed))
        loft_machine_inputs(&machine, closed);
}

int main(void)
{
    static uint8_t wire[LOFT_FRAME_MAX];
    loft_machine_config *config = loft_port_init();
    const uint32_t slot_hz = (uint32_t)config->info.tick_hz * config->info.slots;
    size_t count = 0, sent = 0;

    config->senses = true;
    if (loft_machine_init(&machine, config) != LOFT_OK)
        return 1;                       /* the configuration does not fit: see drive.h */
    loft_port_start(slot_hz);
    for (;;) {
        uint8_t byte[32];
        const size_t came = loft_ring_take(&line, byte, sizeof byte);

        loft_machine_push(&machine, byte, came);
        if (sent == count) {
            sent = 0;
            count = loft_machine_poll(&machine, wire);
        }
        const size_t wrote = loft_port_write(wire + sent, count - sent);
        sent += wrote;
        watch_switches(slot_hz / 1000);
        if (!loft_machine_plan(&machine) && came == 0 && wrote == 0)
            loft_port_wait();
    }
}
