/* tests/target/avr_trials.c -- jobs over a bad line: loft_sender, the line and the emulated chip in
 * one program with one clock
 * SPDX-License-Identifier: MIT
 * usage: trials FIRMWARE.elf KIND COUNT [SEED]
 *
 * KIND is the fault that each trial has, at a random byte of either direction:
 *     byte       one byte flipped in one bit, dropped, doubled, or another one inserted
 *     cut        the line is dead from there on, for 0.1 to 60 s (each duration as likely as its
 *                double)
 *     frames     the same at the boundary of each frame that the host sends, one after the other;
 *                COUNT is the most
 *     killed     the sender is killed there, and another one begins the same job 0.1 to 5 s later,
 *                unless the job is drawn, reported and closed
 *     noise      one bit of 10,000 is flipped, the job is the whole drawing
 * Each trial must end with the whole job drawn: the chip's report, the pulses counted at its pins
 * and the order of each axis' steps are those of an undisturbed run. One line per kind: `KIND
 * trials N wrong N incomplete N resent FRAMES seconds ..`
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "avr_core.h"
#include "motion/plan.h"        /* the job is planned here */
#include "wire/sender.h"

#define MS          (AVR_HZ / 1000)
#define ITEMS       400
#define LONGEST     200000          /* ms of machine time after which a trial is given up */
#define WORKERS     2

enum kind { CALM, BYTE, CUT, FRAMES, KILLED, NOISE };

struct fault {
    enum kind kind;
    uint64_t at;                    /* the number of a byte; both directions are counted together */
    uint32_t ms;                    /* the duration */
    uint32_t flip;                  /* probability of a flipped bit, times 2^32                   */
    unsigned what, bit;
};

struct outcome {
    bool done, exact;
    uint32_t ms, resent, bytes, frames;
};

static struct avr_core core;
static loft_sender sender;
static loft_item item[ITEMS];
static uint32_t items;
static loft_job job = { .kind = LOFT_SPANS };
static struct fault fault;
static uint64_t passed, dead_until, random_state;
static bool cut_done, told;         /* told: the sender that was killed had the report of the whole
                                     * job */
static loft_report report;
static uint32_t frames_sent;
static uint64_t calm_path[3], calm_pulses[3];
static int32_t calm_position[3];


// The job
// -------

static void item_source(void *context, uint32_t index, loft_item *out)
{
    (void)context;
    *out = item[index];
}

/* The first three curves of a drawing with one cubic per line, as spans. */
static int plan_job(const char *file, uint32_t most)
{
    static loft_plan plan;
    static loft_move moves[16];
    static loft_knot knots[400];
    loft_limits limits = { .tol = LOFT_REAL(0.005), .corner = LOFT_REAL(0.01), .tick_hz = 1000 };
    FILE *f = fopen(file, "r");
    char line[400];
    double v[8];
    loft_span span;

    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = LOFT_REAL(160);
        limits.max_accel[i] = LOFT_REAL(500);
    }
    if (f == NULL || loft_plan_init(&plan, &limits, moves, 16, knots, 400) != LOFT_OK)
        return 1;
    for (uint32_t n = 0; n < most && fgets(line, sizeof line, f);) {
        loft_move move = { .feed = LOFT_REAL(50) };
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2, v + 3, v + 4, v + 5,
                   v + 6, v + 7) != 8)
            continue;
        for (int k = 0; k < 8; k++)
            move.curve.p[k / 2].axis[k % 2] = loft_real_from_raw((int32_t)lround(v[k] * 65536));
        if (loft_plan_push(&plan, &move) != LOFT_OK)
            return 1;
        n++;
    }
    fclose(f);
    loft_plan_end(&plan);
    while (loft_plan_next(&plan, &span) == LOFT_PLAN_SPAN && items < ITEMS) {
        memcpy(item[items].p, span.p[1].axis, sizeof item[items].p);
        item[items++].ticks = span.ticks;
    }
    job.id = loft_job_id(&job, items, item_source, NULL);
    return items == 0 || items == ITEMS;
}


// The line
// --------

static uint64_t random_64(void)     /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (random_state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint32_t now_ms(void)        { return (uint32_t)(core.avr->cycle / MS); }

/* Deliver a byte: it goes to `carry` zero, one or two times. */
static void pass_byte(uint8_t byte, void (*carry)(uint8_t byte))
{
    const uint64_t number = passed++;

    if (core.avr->cycle < dead_until)
        return;
    for (unsigned bit = 0; fault.flip && bit < 8; bit++)
        if ((uint32_t)random_64() < fault.flip)
            byte ^= (uint8_t)(1u << bit);
    if (fault.kind == BYTE && number == fault.at) {
        switch (fault.what) {
        case 0:     carry((uint8_t)(byte ^ 1u << fault.bit));  return;
        case 1:     return;
        case 2:     carry(byte);  break;
        default:    carry((uint8_t)random_64());  break;
        }
    }
    carry(byte);
}

static void to_chip(uint8_t byte)   { avr_core_put(&core, byte); }
static void to_host(uint8_t byte)   { (void)loft_sender_push(&sender, byte, now_ms()); }

static void chip_said(void *context, uint8_t byte)
{
    (void)context;
    pass_byte(byte, to_host);
}

static void begin_trial(void) { loft_sender_init(&sender, (uint32_t)random_64(), now_ms()); }

/* Begin the fault at its place in the traffic. */
static void break_line(bool boundary)
{
    const bool here = fault.kind == FRAMES ? boundary && frames_sent == fault.at
                                           : passed >= fault.at;

    if (cut_done || fault.kind < CUT || fault.kind > KILLED || !here)
        return;
    cut_done = true;
    told = fault.kind == KILLED && sender.phase == LOFT_PHASE_CLOSING;
    report = sender.report;
    dead_until = core.avr->cycle + (uint64_t)fault.ms * MS;
    core.in_head = core.in_tail;
}

/* The host's work at a moment in which its line is free. */
static void host_turn(void)
{
    uint8_t wire[LOFT_FRAME_MAX];
    const bool dead = core.avr->cycle < dead_until;

    if (fault.kind == KILLED && cut_done && dead_until) {
        if (dead)
            return;
        dead_until = 0;
        begin_trial();
    }
    if (sender.phase == LOFT_PHASE_READY && told && sender.machine.ack.state == LOFT_STATE_IDLE) {
        sender.phase = LOFT_PHASE_DONE;
        sender.report = report;
    }
    if (sender.phase == LOFT_PHASE_READY &&
        loft_sender_begin(&sender, &job, items, item_source, NULL) != LOFT_OK)
        sender.phase = LOFT_PHASE_REFUSED;
    if (core.in_head != core.in_tail)
        return;
    const size_t count = loft_sender_poll(&sender, now_ms(), wire);
    for (size_t i = 0; i < count; i++)
        pass_byte(wire[i], to_chip);
    frames_sent += count > 0;
    break_line(count > 0);
}


// A trial
// -------

static struct outcome run_trial(void)
{
    struct outcome o = { 0 };
    const uint64_t from = core.avr->cycle;

    passed = 0;
    frames_sent = 0;
    begin_trial();
    while (sender.phase < LOFT_PHASE_DONE && core.avr->cycle - from < (uint64_t)LONGEST * MS) {
        if (!avr_core_run(&core, MS / 4, false))
            return o;
        host_turn();
        break_line(false);
    }
    meter_flush(&core.meter);
    o.done = sender.phase == LOFT_PHASE_DONE;
    o.exact = true;
    for (int i = 0; i < 3; i++)
        o.exact &= sender.report.position[i] == core.meter.record.position[i] &&
                   (fault.kind == CALM ||
                    (core.meter.record.position[i] == calm_position[i] &&
                     core.meter.pulses[i] == calm_pulses[i] && core.meter.path[i] == calm_path[i]));
    o.ms = (uint32_t)((core.avr->cycle - from) / MS);
    o.resent = sender.resent;
    o.bytes = (uint32_t)passed;
    o.frames = frames_sent;
    return o;
}

/* Each trial is a copy of this process; the chip waits for its first byte. */
static struct outcome run_in_child(struct outcome *shared, const struct fault *f)
{
    fault = *f;
    *shared = run_trial();
    if (f->kind != CALM && !(shared->done && shared->exact))
        fprintf(stderr,
                "trial: kind %d at %llu what %u bit %u for %u ms: %s, phase %d, position %d %d\n",
                f->kind, (unsigned long long)f->at, f->what, f->bit, f->ms,
                shared->done ? "wrong steps" : "incomplete", sender.phase,
                core.meter.record.position[0], core.meter.record.position[1]);
    return *shared;
}

static struct fault next_fault(enum kind kind, uint64_t bytes, uint32_t number)
{
    struct fault f = { .kind = kind,
                       .at = random_64() % bytes,
                       .what = (unsigned)(number % 4),
                       .bit = (unsigned)(random_64() % 8) };
    const double share = (double)(random_64() >> 11) / 9007199254740992.0;

    f.ms = (uint32_t)(100 * pow(kind == KILLED ? 50 : 600, share));
    if (kind == FRAMES)
        f.at = number + 1;
    return f;
}

static struct outcome calm_run(void)
{
    struct outcome *o = mmap(
        NULL, sizeof *o + sizeof calm_path + sizeof calm_pulses + sizeof calm_position,
        PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    uint8_t *rest = (uint8_t *)(o + 1);

    if (fork() == 0) {
        *o = run_in_child(o, &(struct fault){ .kind = CALM });
        memcpy(rest, core.meter.path, sizeof calm_path);
        memcpy(rest + sizeof calm_path, core.meter.pulses, sizeof calm_pulses);
        memcpy(rest + 2 * sizeof calm_path, core.meter.record.position, sizeof calm_position);
        _exit(0);
    }
    wait(NULL);
    memcpy(calm_path, rest, sizeof calm_path);
    memcpy(calm_pulses, rest + sizeof calm_path, sizeof calm_pulses);
    memcpy(calm_position, rest + 2 * sizeof calm_path, sizeof calm_position);
    return *o;
}

static int run_trials(enum kind kind, const char *name, uint32_t count, double rate)
{
    const struct outcome calm = calm_run();
    if (kind == FRAMES && calm.frames < count)
        count = calm.frames;
    struct outcome *o = mmap(NULL, (count + 1) * sizeof *o, PROT_READ | PROT_WRITE,
                             MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    uint32_t wrong = 0, incomplete = 0, resent = 0, running = 0;
    double seconds = 0, bytes = 0;

    if (!calm.done || !calm.exact || calm_pulses[0] == 0) {
        fprintf(stderr,
                "trials: the undisturbed job does not end: %d %d ms %u frames %u pulses %llu\n",
                calm.done, calm.exact, calm.ms, calm.frames, (unsigned long long)calm_pulses[0]);
        return 1;
    }
    for (uint32_t i = 0; i < count; i++) {
        struct fault f = next_fault(kind, calm.bytes, i);
        f.flip = (uint32_t)(rate * 4294967296.0);
        if (running == WORKERS) {
            wait(NULL);
            running--;
        }
        if (fork() == 0) {
            random_state += (uint64_t)i << 32;
            run_in_child(&o[i], &f);
            _exit(0);
        }
        running++;
    }
    while (wait(NULL) > 0) {
    }
    for (uint32_t i = 0; i < count; i++) {
        incomplete += !o[i].done;
        wrong += o[i].done && !o[i].exact;
        resent += o[i].resent;
        seconds += o[i].ms / 1000.0;
        bytes += o[i].bytes;
    }
    printf("%s trials %u wrong %u incomplete %u resent %u seconds %.1f bytes %.0f calm %.3f items "
           "%u\n",
           name, (unsigned)count, (unsigned)wrong, (unsigned)incomplete, (unsigned)resent, seconds,
           bytes, calm.ms / 1000.0, (unsigned)items);
    return wrong + incomplete > 0;
}

int main(int argc, char **argv)
{
    static const char *const names[] = { "calm", "byte", "cut", "frames", "killed", "noise" };
    enum kind kind = CALM;

    for (int k = BYTE; argc > 3 && k <= NOISE; k++)
        if (strcmp(argv[2], names[k]) == 0)
            kind = (enum kind)k;
    if (kind == CALM) {
        fprintf(stderr, "usage: trials FIRMWARE.elf byte|cut|frames|killed|noise COUNT [SEED]\n");
        return 64;
    }
    random_state = argc > 4 ? strtoull(argv[4], NULL, 10) : 1;
    core.out = chip_said;
    if (avr_core_start(&core, argv[1], 0) != 0 ||
        plan_job("tests/drawings/outline12.csv", kind == NOISE ? 12 : 3) != 0 ||
        !avr_core_run(&core, 50 * MS, false))
        return 70;
    return run_trials(kind, names[kind], (uint32_t)atoi(argv[3]), kind == NOISE ? 1e-4 : 0);
}
