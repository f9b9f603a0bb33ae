/* ports/linux-gpio/pulses.h -- slots on their way to the lines: put down by the main loop, given by
 * a thread that does nothing else
 * SPDX-License-Identifier: MIT
 *
 * The thread sleeps until a slot is due, and looks at the clock once more. What Linux makes late
 * stays late: no pulse is lost, none is joined with another, and none comes closer to the one
 * before than planned but for one slot. Lateness beyond one slot moves everything that follows, so
 * the machine is slower by as much, and says so.
 */
#ifndef LOFT_PULSES_H
#define LOFT_PULSES_H

#include <pthread.h>
#include <semaphore.h>

#include "linux-gpio/lines.h"
#include "machine/step.h"        /* loft_pins */

#define PULSES_BINS 10

/* How late pulses were: counts by upper bounds in us, the last without one. */
struct pulses_late {
    uint64_t pulses, count[PULSES_BINS];
    int64_t  worst_ns;
    uint64_t moved;             /* how often everything was moved, */
    int64_t  moved_ns;          /* and by how much in all          */
};

/* One slot in which something happens, or the last of those put down. */
struct pulses_entry {
    uint64_t  slot;
    loft_pins pins;
};

struct pulses {
    struct lines *lines;
    uint32_t slot_hz;
    int64_t  slot_ns, pulse_ns, setup_ns;
    unsigned priority;

    struct pulses_entry *ring;
    uint32_t room;              /* a power of two                                           */
    uint32_t head;              /* by the main loop                                         */
    uint32_t given;             /* slots modulo 2^32, by the thread                         */
    bool     waiting, stop, broken;
    sem_t    wake;
    pthread_t thread;
    bool     runs;

    uint64_t put, told;         /* main loop: slots, and up to the last that is in the ring */
    uint8_t  dir_put;
    uint64_t dry;               /* main loop: how often the thread had nothing in mid-job   */
    bool     begun;             /* main loop: something was given since the last report     */

    struct pulses_late late;    /* thread; main loop while nothing is left to give          */
    uint64_t done;              /* thread: slots                                            */
    int64_t  origin;            /* thread: when slot 0 would have been due                  */
    int64_t  rose, fell, turned;    /* thread: when step and dir lines changed last         */
    uint8_t  dir;
};

/* Start the thread. `most` slots are put down at once at most. Gives 0 or an exit code after one
 * line on standard error. */
int pulses_begin(struct pulses *p, struct lines *lines, const struct settings *s, uint32_t slot_hz,
                 uint32_t most);

/* What the pins do in slot number `slot`, the one behind the last. */
void     pulses_put(struct pulses *p, uint64_t slot, loft_pins pins);

/* What was put down may be given from now on. */
void     pulses_give(struct pulses *p);

/* How many of these slots still are to be given. */
uint64_t pulses_left(const struct pulses *p);

/* Did all lines obey? */
bool     pulses_work(const struct pulses *p);

/* Print how late pulses were, and count anew. For when nothing is left to give, or behind
 * pulses_end. */
void     pulses_report(struct pulses *p);

/* End the thread behind the pulse that it is giving. */
void     pulses_end(struct pulses *p);

#endif
