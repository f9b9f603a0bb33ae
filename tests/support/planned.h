/* tests/support/planned.h -- a machine that plans, a sender of a job of curves, and the line
 * between them, which may damage bytes
 * SPDX-License-Identifier: MIT
 *
 * Before it is included, LONG is the ms until a test gives up. The machine has 80 steps/mm, 1000
 * ticks/s and 40 slots; each axis may go 300 mm/s.
 */
#ifndef LOFT_TESTS_PLANNED_H
#define LOFT_TESTS_PLANNED_H

#include "check.h"
#include "machine/machine.h"
#include "wire/sender.h"

#define CELLS 16

static struct {
    loft_machine machine;
    loft_machine_config config;
    loft_sender  sender;
    loft_job     job;
    loft_job_limits limits;     /* of the job: set before turn_on */
    volatile loft_cell cell[CELLS];
    const loft_item *item;
    uint32_t items;
    uint32_t ms, bend, sent;    /* bend: bytes of 65536 that are damaged; sent: to the machine */
    int32_t  at[LOFT_AXES];     /* the sum of the pulses */
    arb      arb;
} w;

static void source(void *context, uint32_t index, loft_item *out)
{
    (void)context;
    *out = w.item[index];
}

static void dial(void)      { loft_sender_init(&w.sender, 1000 + w.ms, w.ms); }

static loft_machine_config plain_machine(void)
{
    loft_machine_config c = { .info = { .boot = 77, .tick_hz = 1000, .slots = 40 },
                              .ramp = 30,
                              .cell = w.cell,
                              .cells = CELLS };

    for (int i = 0; i < LOFT_AXES; i++)
        c.info.axis[i].steps_per_mm = 80 * 65536;
    return c;
}

/* A machine with a planner, and a sender with these items. */
static void turn_on(const arb *a, loft_planner *planner, const loft_planner_memory *memory,
                    const loft_item item[], uint32_t items)
{
    w.config = plain_machine();
#if LOFT_MACHINE_PLANS          /* on a chip that does not plan this is compiled, and not run */
    w.config.planner = planner;
    w.config.plan = *memory;
#else
    (void)planner;
    (void)memory;
#endif
    for (int i = 0; i < LOFT_AXES; i++) {
        w.config.info.axis[i].max_speed = 300 * 65536;
        w.config.info.axis[i].max_accel = 3000 * 65536;
        w.at[i] = 0;
    }
    w.ms = w.bend = w.sent = 0;
    w.arb = *a;
    w.item = item;
    w.items = items;
    CHECK(loft_machine_init(&w.machine, &w.config) == LOFT_OK);
    w.job = (loft_job){ .kind = LOFT_CURVES, .limits = &w.limits };
    w.job.id = loft_job_id(&w.job, items, source, NULL);
    dial();
}

static uint8_t bent(uint8_t byte)
{
    const unsigned bit = arb_below(&w.arb, 65536) < w.bend ? 1u << arb_below(&w.arb, 8) : 0;
    return (uint8_t)(byte ^ bit);
}

static void count_pulses(loft_pins pins)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (pins.step >> i & 1)
            w.at[i] += pins.dir >> i & 1 ? -1 : 1;
}

/* One ms. */
static void go_on(void)
{
    uint8_t wire[LOFT_FRAME_MAX];

    if (w.sender.phase == LOFT_PHASE_READY)
        CHECK(loft_sender_begin(&w.sender, &w.job, w.items, source, NULL) == LOFT_OK);
    size_t count = loft_sender_poll(&w.sender, w.ms, wire);
    for (size_t i = 0; i < count; i++, w.sent++) {
        const uint8_t byte = bent(wire[i]);
        loft_machine_push(&w.machine, &byte, 1);
    }
    count = loft_machine_poll(&w.machine, wire);
    for (size_t i = 0; i < count; i++)
        loft_sender_push(&w.sender, bent(wire[i]), w.ms);
    for (int slot = 0; slot < 40; slot++) {
        loft_machine_tick(&w.machine);
        count_pulses(loft_machine_slot(&w.machine));
    }
    loft_machine_tick(&w.machine);
    w.ms++;
}

static void finish(void)
{
    while (w.sender.phase < LOFT_PHASE_DONE && w.ms < LONG && !check_bad)
        go_on();
}

#endif
