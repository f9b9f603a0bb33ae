/* ports/linux-gpio/pulses.h -- slots for the lines: made by the main loop, given by a thread of its
 * own SPDX-License-Identifier: MIT
 *
 * The thread sleeps until a slot is due, and then reads the clock once more. Lateness that Linux
 * causes stays: no pulse is lost or joined with another. Two pulses come closer than planned by at
 * most one slot. Lateness beyond one slot delays everything that follows. So the machine is slower
 * by as much, and reports it.
 */
#ifndef LOFT_PULSES_H
#define LOFT_PULSES_H

#include <pthread.h>
#include <semaphore.h>

#include "linux-gpio/machine_lines.h"
#include "linux-gpio/powers.h"
#include "machine/step.h"        /* loft_pins */

#define PULSES_BINS 10

/* The lateness of pulses: counts by upper bounds in us, the last without a bound. */
struct pulses_late {
    uint64_t pulses, count[PULSES_BINS];
    int64_t  worst_ns;
    uint64_t moved;             /* how often everything was delayed */
    int64_t  moved_ns;          /* and the total delay              */
};

/* The outputs from a slot on. */
struct pulses_levels {
    uint16_t level[LOFT_MACHINE_OUTPUTS + 1];
    uint8_t  moving;            /* bit k: output k is off while the machine stands */
};

/* One slot with an action, or the last slot so far. */
struct pulses_entry {
    uint64_t  slot;
    loft_pins pins;
    struct pulses_levels outputs;
};

struct pulses {
    struct lines *lines;
    struct powers *powers;
    uint32_t slot_hz;
    int64_t  slot_ns, pulse_ns, setup_ns;
    unsigned priority;

    struct pulses_entry *ring;
    uint32_t room;              /* a power of two                                           */
    uint32_t head;              /* written by the main loop                                 */
    uint32_t given;             /* slots modulo 2^32, written by the thread                 */
    bool     waiting, stop, broken;
    uint32_t stands;            /* step lines of motors that stand, written by the main loop */
    sem_t    wake;
    pthread_t thread;
    bool     runs;

    uint64_t put, covered;      /* main loop: slots made; slots up to the last in the ring  */
    uint8_t  dir_put;
    struct pulses_levels outputs_put;
    bool     fresh;             /* they have changed since the last entry */
    uint64_t dry;               /* main loop: how often the ring was empty in mid-job       */
    bool     begun;             /* main loop: slots were given since the last report        */

    struct pulses_late late;    /* thread; main loop while no slots are left                */
    uint64_t done;              /* thread: slots given                                      */
    int64_t  origin;            /* thread: when slot 0 would have been due                  */
    int64_t  rose, fell, turned;    /* thread: last changes of the step and dir lines       */
    uint8_t  dir;
    struct pulses_levels outputs;   /* thread: given */
};

/* Start the thread. At most `most` slots are made ahead. Returns 0 or an exit code after one line
 * on standard error. */
int pulses_begin(struct pulses *p, struct lines *lines, struct powers *powers,
                 const struct settings *s, uint32_t slot_hz, uint32_t most);

/* The level of an output, from 1, from the next slot on; `moving`: off while no slot is given. */
void     pulses_level(struct pulses *p, int output, uint16_t level, bool moving);

/* The pins of slot number `slot`, which follows the last one. */
void     pulses_put(struct pulses *p, uint64_t slot, loft_pins pins);

/* Motors that stand from now on (loft_machine_gated), in slots that are made already as well. */
void     pulses_stand(struct pulses *p, uint16_t gated);

/* All slots so far may be given from now on. */
void     pulses_give(struct pulses *p);

/* The number of slots still to give. */
uint64_t pulses_left(const struct pulses *p);

/* The steps that are made and not given. */
void     pulses_ahead(const struct pulses *p, int32_t steps[LOFT_AXES]);

/* True if all lines have obeyed. */
bool     pulses_work(const struct pulses *p);

/* Print the lateness of pulses, and reset it. Call it when no slots are left, or after
 * pulses_end. */
void     pulses_report(struct pulses *p);

/* End the thread after its current pulse. */
void     pulses_end(struct pulses *p);

#endif
