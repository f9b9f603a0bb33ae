/* ports/linux-gpio/pulses.c
 * SPDX-License-Identifier: MIT
 *
 * Main loop and thread share `head` and `given`; each is written by one side. The thread sleeps on
 * `wake` when the ring is empty. `waiting` says so, and the side that clears it posts. After such a
 * sleep time begins anew: the slot after the last given one is due now.
 */
#include "linux-gpio/pulses.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sysexits.h>
#include <time.h>

#include "wire/message.h"       /* LOFT_INPUT_LOW */

#define SPIN_NS 50000           /* shorter waits do not sleep          */
#define STACK   65536           /* of the thread, all of it locked     */

static const int64_t bound_us[PULSES_BINS - 1] = { 10, 20, 50, 100, 200, 500, 1000, 2000, 5000 };

#define LOAD(x)     __atomic_load_n(&(x), __ATOMIC_SEQ_CST)
#define STORE(x, v) __atomic_store_n(&(x), (v), __ATOMIC_SEQ_CST)

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

/* Returns the time after the wait. */
static int64_t wait_until(int64_t when)
{
    const struct timespec t = { .tv_sec = (time_t)(when / 1000000000),
                                .tv_nsec = (long)(when % 1000000000) };
    int64_t now = now_ns();

    if (when - now > SPIN_NS)
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL) == EINTR) {
        }
    do
        now = now_ns();
    while (now < when);
    return now;
}

static int64_t max_i64(int64_t a, int64_t b) { return a > b ? a : b; }


// The thread
// ----------

/* The time since slot 0; exact for 2^64 slots. */
static int64_t time_of(const struct pulses *p, uint64_t slot)
{
    return (int64_t)(slot / p->slot_hz) * 1000000000 +
           (int64_t)(slot % p->slot_hz * 1000000000 / p->slot_hz);
}

static void set_lines(struct pulses *p, uint32_t which, uint32_t on)
{
    if (!lines_set(p->lines, which, on))
        STORE(p->broken, true);
}

/* Something was done `late` ns after its time. What follows moves by that. Before the first pulse
 * the job only begins later: that makes it no slower. */
static void note_late(struct pulses *p, int64_t late)
{
    if (late <= p->slot_ns)
        return;
    p->origin += late - p->slot_ns;
    if (p->late.pulses > 0) {
        p->late.moved++;
        p->late.moved_ns += late - p->slot_ns;
    }
}

static void count_pulse(struct pulses *p, int64_t late)
{
    int bin = 0;

    while (bin < PULSES_BINS - 1 && late > bound_us[bin] * 1000)
        bin++;
    p->late.count[bin]++;
    p->late.pulses++;
    p->late.worst_ns = max_i64(p->late.worst_ns, late);
}

/* Set the direction, but not before the step lines have been low for setup_ns. */
static void give_direction(struct pulses *p, int64_t due, uint8_t dir)
{
    const int64_t now = wait_until(max_i64(due, p->fell + p->setup_ns));

    set_lines(p, (uint32_t)(dir ^ p->dir) << LINE_DIR, (uint32_t)dir << LINE_DIR);
    p->turned = now_ns();
    p->dir = dir;
    note_late(p, now - due);
}

/* The lines of these steps, of both motors where an axis has two; not of those that stand. */
static uint32_t step_lines(struct pulses *p, uint8_t step)
{
    return ((uint32_t)step << LINE_STEP | (uint32_t)step << LINE_STEP2) & ~LOAD(p->stands);
}

/* Give a pulse. It waits until the direction has been stable for setup_ns, until half a slot after
 * the last pulse, and until the lines have been low for long enough. The thread may lose the
 * processor after it has read the clock (calls take less than two slots). Then the pulse is as late
 * as its rising edge was seen, and what follows counts from there. */
static void give_pulse(struct pulses *p, int64_t due, uint8_t step)
{
    const int64_t now = wait_until(
        max_i64(max_i64(due, p->turned + p->setup_ns),
                max_i64(p->rose + p->slot_ns / 2, p->fell + p->pulse_ns)));
    const uint32_t which = step_lines(p, step);

    set_lines(p, which, UINT32_MAX);
    p->rose = now_ns();
    wait_until(p->rose + p->pulse_ns);
    set_lines(p, which, 0);
    p->fell = now_ns();
    const int64_t late = (p->rose - now > 2 * p->slot_ns ? p->rose : now) - due;
    note_late(p, late);
    count_pulse(p, late);
}

static void give_level(struct pulses *p, int output, uint16_t level)
{
    if (level == p->outputs.level[output])
        return;
    p->outputs.level[output] = level;
    if (!powers_set(p->powers, p->lines, output, level))
        STORE(p->broken, true);
}

static void give_outputs(struct pulses *p, int64_t due, const struct pulses_levels *to)
{
    if (memcmp(to->level, p->outputs.level, sizeof to->level) != 0)
        wait_until(due);
    p->outputs.moving = to->moving;
    for (int k = 1; k <= LOFT_MACHINE_OUTPUTS; k++)
        give_level(p, k, to->level[k]);
}

/* Nothing follows: the machine stands, so a laser is off until it moves again. */
static void rest_outputs(struct pulses *p, bool all)
{
    for (int k = 1; k <= LOFT_MACHINE_OUTPUTS; k++)
        if (all || p->outputs.moving & 1u << k)
            give_level(p, k, 0);
}

static void give_entry(struct pulses *p, const struct pulses_entry *e)
{
    const int64_t due = p->origin + time_of(p, e->slot);

    give_outputs(p, due, &e->outputs);
    if (e->pins.dir != p->dir)
        give_direction(p, due, e->pins.dir);
    if (e->pins.step)
        give_pulse(p, p->origin + time_of(p, e->slot), e->pins.step);
    else
        wait_until(due);
}

/* Wait for an entry; false at the end. */
static bool await_entry(struct pulses *p, uint32_t tail)
{
    while (LOAD(p->head) == tail && !LOAD(p->stop)) {
        STORE(p->waiting, true);
        if (LOAD(p->head) != tail || LOAD(p->stop))
            break;
        rest_outputs(p, false);
        while (sem_wait(&p->wake) != 0) {
        }
        p->origin = now_ns() - time_of(p, p->done);
    }
    return !LOAD(p->stop);
}

static void *run_thread(void *argument)
{
    struct pulses *p = argument;
    const struct sched_param priority = { .sched_priority = (int)p->priority };

    prctl(PR_SET_TIMERSLACK, 1ul);
    if (p->priority && pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) != 0)
        fprintf(stderr,
                "loft-gpio: no real-time priority: run as root, or with `ulimit -r %u`; pulses may "
                "come late, and it will be said how late\n",
                p->priority);
    for (uint32_t tail = 0; await_entry(p, tail); tail++) {
        const struct pulses_entry e = p->ring[tail & (p->room - 1)];
        give_entry(p, &e);
        p->done = e.slot + 1;
        STORE(p->given, (uint32_t)p->done);
    }
    rest_outputs(p, true);
    return NULL;
}


// The main loop
// -------------

static bool start_thread(struct pulses *p)
{
    pthread_attr_t kind;
    int error = pthread_attr_init(&kind);

    if (error == 0) {
        error = pthread_attr_setstacksize(&kind, STACK);
        if (error == 0)
            error = pthread_create(&p->thread, &kind, run_thread, p);
        pthread_attr_destroy(&kind);
    }
    errno = error;
    return error == 0;
}

int pulses_begin(struct pulses *p, struct lines *lines, struct powers *powers,
                 const struct settings *s, uint32_t slot_hz, uint32_t most_slots)
{
    memset(p, 0, sizeof *p);
    p->lines = lines;
    p->powers = powers;
    p->slot_hz = slot_hz;
    p->slot_ns = 1000000000 / slot_hz;
    p->pulse_ns = s->pulse_us * INT64_C(1000);
    p->setup_ns = s->setup_us * INT64_C(1000);
    p->priority = s->priority;
    /* an entry for each slot, and one more for the last of each portion */
    for (p->room = 2; p->room <= 2 * most_slots; p->room *= 2) {
    }
    p->ring = calloc(p->room, sizeof *p->ring);
    if (!p->ring || sem_init(&p->wake, 0, 0) != 0 || !start_thread(p)) {
        fprintf(stderr, "loft-gpio: cannot start a thread: %s\n", strerror(errno));
        free(p->ring);
        return EX_OSERR;
    }
    p->runs = true;
    return 0;
}

static void append_entry(struct pulses *p, uint64_t slot, loft_pins pins)
{
    p->ring[p->head & (p->room - 1)] = (struct pulses_entry){ slot, pins, p->outputs_put };
    p->fresh = false;
    p->covered = slot + 1;
    STORE(p->head, p->head + 1);
}

/* The thread gets a slot without pulses once per millisecond, and the last one. So the main loop
 * learns its progress. */
void pulses_put(struct pulses *p, uint64_t slot, loft_pins pins)
{
    p->put = slot + 1;
    if (pins.step || pins.dir != p->dir_put || p->fresh || p->put - p->covered >= p->slot_hz / 1000)
        append_entry(p, slot, pins);
    p->dir_put = pins.dir;
}

void pulses_level(struct pulses *p, int output, uint16_t level, bool moving)
{
    p->outputs_put.level[output] = level;
    p->outputs_put.moving = (uint8_t)((p->outputs_put.moving & ~(1u << output)) | (unsigned)moving
                                                                                      << output);
    p->fresh = true;
}

void pulses_stand(struct pulses *p, uint16_t gated)
{
    uint32_t lines = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        lines |= (gated & LOFT_INPUT_LOW(i) ? 1u << (LINE_STEP + i) : 0) |
                 (gated & LOFT_INPUT_HIGH(i) ? 1u << (LINE_STEP2 + i) : 0);
    STORE(p->stands, lines);
}

uint64_t pulses_left(const struct pulses *p) { return (uint32_t)p->put - LOAD(p->given); }

/* Entries of slots that were given may be in the ring still, so it is read from its head. */
void pulses_ahead(const struct pulses *p, int32_t steps[LOFT_AXES])
{
    const uint64_t left = pulses_left(p), given = p->put - left;

    memset(steps, 0, LOFT_AXES * sizeof *steps);
    for (uint32_t k = p->head; p->head - k < p->room; k--) {
        const struct pulses_entry *e = &p->ring[(k - 1) & (p->room - 1)];
        if (k == 0 || e->slot < given)
            break;
        for (int i = 0; i < LOFT_AXES; i++)
            if (e->pins.step & 1u << i)
                steps[i] += e->pins.dir & 1u << i ? -1 : 1;
    }
}

void pulses_give(struct pulses *p)
{
    if (p->covered != p->put)
        append_entry(p, p->put - 1, (loft_pins){ 0, p->dir_put });
    if (pulses_left(p) == 0 || !__atomic_exchange_n(&p->waiting, false, __ATOMIC_SEQ_CST))
        return;
    p->dry += p->begun;
    p->begun = true;
    sem_post(&p->wake);
}

bool pulses_work(const struct pulses *p) { return !LOAD(p->broken); }

void pulses_report(struct pulses *p)
{
    const struct pulses_late *l = &p->late;

    printf("lateness of %llu pulses: worst %.1f us;", (unsigned long long)l->pulses,
           (double)l->worst_ns / 1000);
    for (int i = 0; i < PULSES_BINS; i++)
        if (l->count[i]) {
            if (i < PULSES_BINS - 1)
                printf(" to %d us %llu,", (int)bound_us[i], (unsigned long long)l->count[i]);
            else
                printf(" more %llu,", (unsigned long long)l->count[i]);
        }
    printf(" slower by %.3f ms in %llu places, ran dry %llu times\n", (double)l->moved_ns / 1e6,
           (unsigned long long)l->moved, (unsigned long long)p->dry);
    fflush(stdout);
    memset(&p->late, 0, sizeof p->late);
    p->dry = 0;
    p->begun = false;
}

void pulses_end(struct pulses *p)
{
    if (!p->runs)
        return;
    STORE(p->stop, true);
    sem_post(&p->wake);
    pthread_join(p->thread, NULL);
    sem_destroy(&p->wake);
    free(p->ring);
    p->ring = NULL;
    p->runs = false;
}
