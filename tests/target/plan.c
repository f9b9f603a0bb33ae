/* tests/target/plan.c -- the cost of planning a chain on a Cortex-M, in instructions
 * SPDX-License-Identifier: MIT
 *
 * With microbit.c, netduino.ld, -DSPEED= -DACCEL= -DJERK= (mm, s), -DKNOTS= -DMOVES= (the rings).
 * `chain.h` is `static const int32_t chain[][4][2]`, raw Q16.16. Prints `name number` lines: spans,
 * microseconds of motion; the cost of planning and of the most expensive call; bytes.
 */

#include "meter.h"              /* meter_start, meter_now       */
#include "motion/plan.h"        /* loft_plan                    */
#include "say.h"                /* say_line                     */

#include "chain.h"              /* chain: after what it is made of */

#define CURVES (sizeof chain / sizeof chain[0])
#define TICK_HZ 1000
#define STACK 1024              /* words below the stack pointer that are looked at */
#define UNUSED 0x5a5a5a5au

void debugger_put(char c);
int  main(void);

static loft_move       moves[MOVES];
static loft_knot       knots[KNOTS];
static loft_plan       plan;

static loft_vec last;           /* where the last span ends */
static uint64_t planning;       /* a sum may exceed 2^32 */
static uint32_t worst, ticks, calls, spans, empty;

static void take(uint32_t start)
{
    const uint32_t cost = meter_since(start) - empty;

    planning += cost;
    worst = cost > worst ? cost : worst;
    calls++;
}

static loft_move curve(unsigned c)
{
    loft_move m = { .feed = LOFT_REAL(SPEED) };

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            m.curve.p[k].axis[i] = chain[c][k][i];
    return m;
}

static volatile uint32_t *stack_low(void)
{
    uint32_t here;
    volatile uint32_t *at = &here;
    return at - STACK;
}

static __attribute__((noinline)) void paint_stack(void)
{
    volatile uint32_t *low = stack_low();

    for (int k = 0; k < STACK - 32; k++)
        low[k] = UNUSED;
}

static __attribute__((noinline)) uint32_t used_stack(void)
{
    volatile uint32_t *low = stack_low();
    unsigned k = 0;

    while (k < STACK && low[k] == UNUSED)
        k++;
    return (uint32_t)(STACK - k) * 4;
}

/* As a machine does whose queue always has room. */
static void plan_chain(void)
{
    enum loft_plan_state state = LOFT_PLAN_SPAN;
    unsigned next = 0;
    loft_span span;

    while (next < CURVES || state != LOFT_PLAN_REST) {
        while (next < CURVES && loft_plan_room(&plan) > 0) {
            const loft_move m = curve(next);
            const uint32_t start = meter_now();
            if (loft_plan_push(&plan, &m) != LOFT_OK)
                return;
            next++;
            if (next == CURVES)
                loft_plan_end(&plan);
            take(start);
        }
        const uint32_t start = meter_now();
        state = loft_plan_part(&plan, &span);
        take(start);
        spans += state == LOFT_PLAN_SPAN;
        ticks += state == LOFT_PLAN_SPAN ? span.ticks : 0u;
        if (state == LOFT_PLAN_SPAN)
            last = span.p[3];
    }
}

int main(void)
{
    loft_limits limits = { .tol = LOFT_REAL(0.005), .tick_hz = TICK_HZ };
    uint32_t start;

    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = LOFT_REAL(SPEED);
        limits.max_accel[i] = LOFT_REAL(ACCEL);
        limits.max_jerk[i]  = JERK;
    }
    meter_start();
    start = meter_now();
    empty = meter_since(start);
    if (loft_plan_init(&plan, &limits, moves, MOVES, knots, KNOTS) != LOFT_OK)
        return 1;
    paint_stack();
    plan_chain();
    say_line(debugger_put, "curves", CURVES);
    say_line(debugger_put, "spans", spans);
    say_line(debugger_put, "ticks", ticks);
    say_line(debugger_put, "calls", calls);
    say_wide(debugger_put, "planning", planning);
    say_line(debugger_put, "worst", worst);
    say_line(debugger_put, "stack", used_stack());
    say_line(debugger_put, "bytes_plan", sizeof plan);
    say_line(debugger_put, "bytes_knots", sizeof knots);
    say_line(debugger_put, "bytes_moves", sizeof moves);
    return last.axis[0] == chain[CURVES - 1][3][0] && last.axis[1] == chain[CURVES - 1][3][1] ? 0
                                                                                              : 1;
}
