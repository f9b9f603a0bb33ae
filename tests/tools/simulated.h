/* tests/tools/simulated.h -- a machine in this program, its table and its line, in simulated time
 * SPDX-License-Identifier: MIT
 *
 * Nothing here knows the real time: a millisecond passes when it is said so. The line brings 115200
 * baud. Whoever computes is charged for it: each look at tool_clock takes a millisecond.
 */
#ifndef LOFT_TESTS_SIMULATED_H
#define LOFT_TESTS_SIMULATED_H

#include <errno.h>
#include <string.h>

#include "base/tool.h"
#include "check.h"
#include "host/world.h"         /* walls, switches */
#include "machine/machine.h"
#include "send/task.h"
#include "send/transport.h"
#include "switches.h"           /* loft_switches */

#define SIMULATED_BYTES 11.52   /* of the line in a millisecond */

#define SIMULATED_ROOM  600     /* bytes for settings */

typedef struct {
    uint8_t byte[1 << 16];
    size_t in, out;
} simulated_queue;

static struct {
    double clock;               /* s */
    loft_machine machine;
    loft_machine_config config;
    volatile loft_cell cell[257];
    struct loft_host_options options;
    struct host_world world;
    loft_switches switches;
    uint64_t slot;
    simulated_queue down, up;
    double credit[2];           /* bytes that the line may bring, down and up */
    uint8_t wire[LOFT_FRAME_MAX];
    size_t count, sent;
    bool mute;                  /* nothing reaches it */
    bool gone;                  /* the port has vanished */
    bool open;
    unsigned looks;             /* at the clock, of the step that runs; the most of any step */
    unsigned most;
    uint8_t kept[2 * SIMULATED_ROOM];   /* its settings */
} sim;

double tool_clock(void)
{
    sim.looks++;
    sim.clock += 0.001;
    return sim.clock;
}


// Its line
// --------

static long simulated_read(transport *t, void *bytes, size_t most)
{
    size_t count = 0;

    (void)t;
    errno = EIO;
    if (sim.gone)
        return -1;
    while (count < most && sim.up.out < sim.up.in)
        ((uint8_t *)bytes)[count++] = sim.up.byte[sim.up.out++ % sizeof sim.up.byte];
    return (long)count;
}

static long simulated_write(transport *t, const void *bytes, size_t count)
{
    size_t put = 0;

    (void)t;
    errno = EIO;
    if (sim.gone)
        return -1;
    while (put < count && sim.down.in - sim.down.out < 256)
        sim.down.byte[sim.down.in++ % sizeof sim.down.byte] = ((const uint8_t *)bytes)[put++];
    return (long)put;
}

static void simulated_close(transport *t)
{
    (void)t;
    sim.open = false;
}

int transport_open(transport *t, host *h, const char *name, unsigned baud)
{
    static const transport_kind kind = { simulated_read, simulated_write, simulated_close };

    (void)h;
    *t = (transport){ .kind = &kind, .in = 5, .out = 6, .baud = baud };
    snprintf(t->text, sizeof t->text, "%s", name);
    sim.open = true;
    return 0;
}

int transport_step(transport *t, double now, task_wants *w)
{
    (void)t;
    (void)now;
    (void)w;
    return 0;
}

int transport_ports(host *h, void (*each)(void *context, const transport_port *port), void *context)
{
    (void)h;
    (void)each;
    (void)context;
    return 0;
}


// The machine
// -----------

static uint8_t simulated_get(uint16_t at) { return sim.kept[at]; }

static void simulated_put(uint16_t at, uint8_t byte) { sim.kept[at] = byte; }

/* A machine at 0,0,0, whose table is as in the options. */
static void simulated_begin(const struct loft_host_options *o)
{
    loft_machine_config *c = &sim.config;

    memset(&sim, 0, sizeof sim);
    memset(sim.kept, 0xFF, sizeof sim.kept);
    sim.options        = *o;
    c->info.boot       = 77;
    c->info.tick_hz    = (uint16_t)o->tick_hz;
    c->info.slots      = (uint16_t)o->slots;
    for (int i = 0; i < LOFT_AXES; i++)
        c->info.axis[i] = (loft_axis_config){ .steps_per_mm = LOFT_RAW(o->steps_per_mm[i]),
                                              .max_speed    = LOFT_RAW(o->max_speed[i]),
                                              .max_accel    = LOFT_RAW(o->max_accel[i]) };
    c->settings.get  = simulated_get;
    c->settings.put  = simulated_put;
    c->settings.room = SIMULATED_ROOM;
    c->senses = true;
    c->ramp   = (uint16_t)o->ramp;
    c->cell   = sim.cell;
    c->cells  = 256;
    CHECK(loft_machine_init(&sim.machine, c) == LOFT_OK);
    host_world_init(&sim.world, &sim.options);
}

static void simulated_slots(void)
{
    for (unsigned i = 0; i < sim.options.slots * sim.options.tick_hz / 1000; i++) {
        loft_machine_tick(&sim.machine);
        host_world_slot(&sim.world, sim.slot++, loft_machine_slot(&sim.machine), 0);
        if (loft_machine_senses(&sim.machine))
            loft_machine_sense(&sim.machine, sim.world.inputs);
    }
}

static void simulated_line(void)
{
    for (sim.credit[0] += SIMULATED_BYTES; sim.credit[0] >= 1 && sim.down.out < sim.down.in;
         sim.credit[0]--) {
        const uint8_t byte = sim.down.byte[sim.down.out++ % sizeof sim.down.byte];
        if (!sim.mute)
            loft_machine_push(&sim.machine, &byte, 1);
    }
    for (sim.credit[1] += SIMULATED_BYTES; sim.credit[1] >= 1; sim.credit[1]--) {
        if (sim.sent == sim.count) {
            sim.sent  = 0;
            sim.count = loft_machine_poll(&sim.machine, sim.wire);
            if (sim.count == 0)
                break;
        }
        sim.up.byte[sim.up.in++ % sizeof sim.up.byte] = sim.wire[sim.sent++];
    }
    sim.credit[0] = fmin(sim.credit[0], SIMULATED_BYTES);
    sim.credit[1] = fmin(sim.credit[1], SIMULATED_BYTES);
}

static void simulated_ms(void)
{
    sim.clock += 0.001;
    simulated_line();
    loft_machine_sample(&sim.machine, sim.world.inputs);
    if (loft_switches_steady(&sim.switches, sim.world.inputs))
        loft_machine_inputs(&sim.machine, sim.world.inputs);
    (void)loft_machine_plan(&sim.machine);
    simulated_slots();
}

static bool simulated_moves(void) { return loft_state_busy(sim.machine.drive.state); }

/* The time that a step of the sender took passes for the machine, too. */
static int simulated_step(const task *t, task_wants *w)
{
    sim.looks      = 0;
    const int code = task_step(t, sim.clock, w);
    sim.most       = sim.looks > sim.most ? sim.looks : sim.most;
    for (sim.clock -= 0.001 * sim.looks; sim.looks > 0; sim.looks--)
        simulated_ms();
    return code;
}

/* Wait as a loop would: for bytes, for room, or until the time that the task wants. */
static void simulated_wait(const task_wants *w)
{
    CHECK(w->until < HUGE_VAL);
    while (sim.clock < w->until && (w->in < 0 || sim.up.out == sim.up.in) &&
           (w->out < 0 || sim.down.in - sim.down.out >= 256))
        simulated_ms();
}

#endif
