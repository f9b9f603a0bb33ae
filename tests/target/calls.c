/* tests/target/calls.c -- the worst cost of one call of lib/motion: cycles on an ATmega328P,
 * instructions on a Cortex-M
 * SPDX-License-Identifier: MIT
 *
 * Runs on the ATmega328P by itself (simavr), or with microbit.c and netduino.ld. Prints `function
 * worst` lines, and `bytes struct size` lines; calls.sh compares them with the table of
 * lib/motion/span.h and lib/motion/scurve.h.
 */
#include "machine/pace.h"
#include "motion/scurve.h"
#include "motion/span.h"
#include "surface/tensor/grid.h"
#include "machine/step.h"
#include "toolpath/lines.h"

#include "say.h"            /* say_line */
#include "states.h"         /* any, wrong_steps */

#define TICKS  600
#define SPANS  40
#define SLOTS  40
#define MOVES  40
#define BATCH  20           /* of loft_step_give */
#define STATES 20000u       /* of a step of walks */

int main(void);

#if defined(__AVR__)
#  include "avr_say.h"

#  define WRAPS true
#  define LONG  20           /* of loft_forward_run: the memory that there is */
#  define ROWS  8            /* lines of a patch, and steps of a line */
static volatile uint16_t wraps;
ISR(TIMER1_OVF_vect) { wraps++; }

static uint32_t now(void)
{
    cli();
    const uint16_t low = TCNT1, high = (uint16_t)(wraps + ((TIFR1 & 1) != 0 && low < 32768));
    sei();
    return (uint32_t)high << 16 | low;
}

static void start(void)
{
    serial_start();
    TCCR1B = 1;
    TIMSK1 = 1;
    sei();
}
#else
#  include "meter.h"        /* meter_start, meter_now */

#  define WRAPS false
#  define LONG  64
#  define ROWS  16
void debugger_put(char c);
static uint32_t now(void)   { return meter_now(); }
static void put(char c)     { debugger_put(c); }
static void start(void)     { meter_start(); }
static void stop(void)      {}
#endif

enum {
    SLOT,
    TAKE,
    GIVE,
    LOAD,
    PACE,
    TICK,
    STEPS,
    POSITION,
    WALK,
    MOVE,
    PLACE,
    TURN,
    RUN,
    LINE,
    ROW,
#if !defined(__AVR__)
    BALL,
    PROOF,
#endif
    CALLS
};
static const char names[CALLS][24] = {
    "loft_step_next", "loft_step_take",    "loft_step_give",   "loft_step_load",
    "loft_pace_next", "loft_forward_next", "loft_steps_of",    "loft_step_position",
    "loft_span_walk", "loft_scurve_init",  "loft_scurve_eval", "loft_scurve_retarget",
    "loft_forward_run", "loft_grid_next",    "loft_grid_run",
#if !defined(__AVR__)
    "loft_lines_next",  "loft_lines_check",
#endif
};
static uint32_t worst[CALLS], empty;

static loft_pace pace;
static loft_step step;
static loft_forward walk;

/* Not inlined: else the code around a call depends on all others. A short call in which the counter
 * of an ATmega328P wraps is left out: it has the interrupt of that in it. */
__attribute__((noinline)) static void took(int call, uint32_t end, uint32_t begin)
{
    const uint32_t cost = end - begin - empty;
    if (WRAPS && cost < 32768 && (end ^ begin) > 65535)
        return;
    worst[call] = cost > worst[call] ? cost : worst[call];
}

static void slots_of(uint16_t slots, bool batches)
{
    uint8_t bits[BATCH], dir;

    while (slots > 0) {
        uint8_t count = (uint8_t)(slots < BATCH ? slots : BATCH);
        uint32_t begin = now();
        if (!batches) {
            (void)loft_step_next(&step);
            took(SLOT, now(), begin);
            slots--;
            continue;
        }
        loft_step_tick *taken = loft_step_take(&step, &count, &dir);
        took(TAKE, now(), begin);
        slots = (uint16_t)(slots - count);
        begin = now();
        if (taken)
            loft_step_give(taken, bits, count);
        took(GIVE, now(), begin);
    }
}

static void ticks(void)
{
    int32_t target[LOFT_AXES] = { 0 }, position[LOFT_AXES];
    volatile loft_real gear = LOFT_REAL(250);           /* read, as a setting is */
    volatile int32_t steps;

    for (unsigned n = 0; n < TICKS; n++) {
        if (n % 50 == 0)
            loft_pace_aim(&pace, loft_pace_level(&pace, (unsigned)(any() % 201)));
        uint32_t begin = now();
        uint16_t slots = loft_pace_next(&pace);
        took(PACE, now(), begin);
        for (int i = 0; i < LOFT_AXES; i++)
            target[i] += (int32_t)(any() % 81) - 40;
        slots = slots == 0 || slots > 5 * SLOTS ? SLOTS : slots;
        begin = now();
        slots = loft_step_load(&step, target, slots);
        took(LOAD, now(), begin);
        slots_of(slots, n % 2 == 0);
        begin = now();
        loft_step_position(&step, position);
        took(POSITION, now(), begin);
        const loft_real mm = (loft_real)any();
        begin = now();
        steps = loft_steps_of(mm, gear);
        took(STEPS, now(), begin);
        (void)steps;
    }
}

/* Apart, so that few registers are in use around the call. */
__attribute__((noinline)) static void points(void)
{
    static loft_vec at;
    bool more = true;

    for (uint8_t k = 0; k < 20 && more; k++) {
        const uint32_t begin = now();
        more = loft_forward_next(&walk, &at);
        took(TICK, now(), begin);
    }
}

static void spans(void)
{
    loft_span s;

    for (unsigned n = 0; n < SPANS; n++) {
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                s.p[k].axis[i] = (loft_real)(any() << 2);
        s.ticks = (uint16_t)(n < 8 ? 64 : 1 + any() % LOFT_SPAN_TICKS_MAX);
        uint32_t begin = now();
        const enum loft_status status = loft_span_walk(&walk, &s);
        took(WALK, now(), begin);
        if (status == LOFT_OK)
            points();
    }
}

/* Its points are not in the frame of main. */
__attribute__((noinline)) static void runs(void)
{
    loft_vec at[LONG];
    loft_span s = { .ticks = SPANS * LONG / 4 };

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s.p[k].axis[i] = (loft_real)(any() << 2);
    if (loft_span_walk(&walk, &s) != LOFT_OK)
        return;
    for (unsigned n = 0; n < SPANS / 4; n++) {
        const uint32_t begin = now();
        (void)loft_forward_run(&walk, at, LONG);
        took(RUN, now(), begin);
    }
}

/* Lines of a bicubic patch: points one by one, at the start of a line as well, and 16 at once. */
__attribute__((noinline)) static void rows(void)
{
    loft_state memory[LOFT_GRID_STATES(3, 3)];
    loft_vec net[16], at[ROWS];
    loft_tensor patch;
    loft_grid grid;

    for (int k = 0; k < 16; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            net[k].axis[i] = (loft_real)any();
    for (unsigned run = 0; run < 2; run++) {
        if (loft_tensor_init(&patch, net, 3, 3) != LOFT_OK ||
            loft_grid_init(&grid, &patch, ROWS, ROWS, memory, LOFT_GRID_STATES(3, 3)) != LOFT_OK)
            return;
        for (unsigned n = 0; n < ROWS * (run ? 1u : ROWS + 1u); n++) {
            const uint32_t begin = now();
            if (run)
                (void)loft_grid_run(&grid, at, ROWS);
            else
                (void)loft_grid_next(&grid, at);
            took(run ? ROW : LINE, now(), begin);
        }
    }
}

#if !defined(__AVR__)
/* A ball over a bicubic patch: the proof, and its curves. */
__attribute__((noinline)) static void balls(void)
{
    static loft_tip row[ROWS + 1];
    static loft_lines lines;
    static loft_vec net[16];
    const loft_lines_way way = { LOFT_REAL(3), LOFT_REAL(0.01), LOFT_REAL(20), ROWS, ROWS, false };
    const loft_vec home = { { 0, 0, LOFT_REAL(20) } };
    loft_tensor patch;
    loft_cubic curve;
    bool cuts, near;

    for (int k = 0; k < 16; k++) {
        net[k].axis[0] = LOFT_REAL(20) * (k / 4) + (loft_real)(any() & 0xFFFFu);
        net[k].axis[1] = LOFT_REAL(20) * (k % 4) + (loft_real)(any() & 0xFFFFu);
        net[k].axis[2] = (loft_real)(any() & 0x3FFFFu);
    }
    if (loft_tensor_init(&patch, net, 3, 3) != LOFT_OK)
        return;
    uint32_t begin = now();
    const enum loft_lines_fault fault = loft_lines_check(&patch, &way, &near);
    took(PROOF, now(), begin);
    if (fault != LOFT_LINES_FINE ||
        loft_lines_init(&lines, &patch, &way, &home, row, ROWS + 1) != LOFT_OK)
        return;
    for (bool more = true; more;) {
        begin = now();
        more = loft_lines_next(&lines, &curve, &cuts);
        took(BALL, now(), begin);
    }
}
#endif

/* Each begins as one move, and becomes two. */
static void moves(void)
{
    loft_scurve move;
    volatile loft_real at;

    for (unsigned n = 0; n < MOVES; n++) {
        const loft_scurve_limits limits = { .max_speed = (loft_real)any(),
                                            .max_accel = LOFT_REAL(1) + (loft_real)(any() << 2),
                                            .max_jerk = 1000 + any() % 100000,
                                            .tick_hz = 1000 };
        uint32_t begin = now();
        enum loft_status status = loft_scurve_init(&move, 0, (loft_real)any(), &limits);
        took(MOVE, now(), begin);
        for (int k = 0; k < 4 && status == LOFT_OK; k++) {
            const uint32_t tick = any() % move.ticks;
            begin = now();
            at = loft_scurve_eval(&move, tick);
            took(PLACE, now(), begin);
            if (k == 1) {
                begin = now();
                status = loft_scurve_retarget(&move, tick, (loft_real)any());
                took(TURN, now(), begin);
            }
        }
        (void)at;
    }
}

int main(void)
{
    static const int32_t origin[LOFT_AXES] = { 0 };

    start();
    const uint32_t begin = now();
    empty = now() - begin;
    random_state = 12345;
#ifdef LINES                /* of patches, which an ATmega328P has no room for beside the others */
    rows();
    say_line(put, "loft_grid_next", worst[LINE]);
    say_line(put, "loft_grid_run", worst[ROW]);
    stop();
    return 0;
#else
    if (loft_pace_init(&pace, SLOTS, 100) != LOFT_OK || loft_step_init(&step, origin) != LOFT_OK)
        return 1;
    ticks();
    spans();
    moves();
    runs();
#  if !defined(__AVR__)
    rows();
    balls();
#  endif
    put('\n');
    for (int k = 0; k < CALLS; k++)
        say_line(put, names[k], worst[k]);
    say_line(put, "wrong_steps", wrong_steps(STATES));
    say_line(put, "bytes loft_step", sizeof step);
    say_line(put, "bytes loft_pace", sizeof pace);
    say_line(put, "bytes loft_forward", sizeof walk);
    say_line(put, "bytes loft_span", sizeof(loft_span));
    say_line(put, "bytes loft_scurve", sizeof(loft_scurve));
    stop();
    return 0;
#endif
}
