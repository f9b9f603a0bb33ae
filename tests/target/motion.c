/* tests/target/motion.c -- the cost of planning and stepping the outline on a Cortex-M, in
 * instructions
 * SPDX-License-Identifier: MIT
 *
 * With microbit.c, netduino.ld, -DJERK=mm/s^3 (0: not limited), -DMOVES= and -DKNOTS=.
 * `outline.h` is `static const int32_t outline[12][4][2]`, raw Q16.16 (outline_array.sh). Prints
 * `name number` lines: curves, spans, ticks; the cost of planning, of the most expensive call, of
 * ticks, of the most expensive tick, of slots.
 */
#include "meter.h"          /* meter_start, meter_now       */
#include "motion/plan.h"    /* loft_plan                    */
#include "machine/step.h"   /* loft_step, loft_steps_of     */
#include "outline.h"        /* outline                      */
#include "say.h"            /* say_line                     */

#define SLOTS 40            /* in a tick: 40,000 per second */

void debugger_put(char c);
int  main(void);

static loft_move       moves[MOVES];
static loft_knot knots[KNOTS];
static loft_plan       plan;
static loft_step       step;

static uint64_t planning, ticking, slotting, begin;     /* sums: limited jerk on a Cortex-M0 may
                                                         * exceed 2^32 */
static uint32_t spans, ticks, plan_worst, tick_worst, slots;

static uint32_t since(uint32_t start)
{
    static uint32_t empty;
    const uint32_t cost = meter_since(start);
    if (empty == 0)
        empty = meter_since(meter_now());
    return cost - empty;
}

static void take(uint32_t cost, uint64_t *sum, uint32_t *worst)
{
    *sum += cost;
    *worst = cost > *worst ? cost : *worst;
}

static loft_move curve(unsigned c)
{
    loft_move m = { .feed = LOFT_REAL(50) };

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            m.curve.p[k].axis[i] = outline[c][k][i];
    return m;
}

/* Execute one span: its walk, the steps of each tick, its slots. */
static void run(const loft_span *span)
{
    loft_forward walk;
    loft_vec at;
    int32_t target[LOFT_AXES];

    uint32_t start = meter_now();
    if (loft_span_walk(&walk, span) != LOFT_OK)
        return;
    take(since(start), &begin, &tick_worst);
    for (;;) {
        start = meter_now();
        if (!loft_forward_next(&walk, &at))
            break;
        for (int i = 0; i < LOFT_AXES; i++)
            target[i] = loft_steps_of(at.axis[i], LOFT_REAL(250));
        uint16_t left = loft_step_load(&step, target, SLOTS);
        take(since(start), &ticking, &tick_worst);
        ticks++;
        slots += left;
        start = meter_now();
        while (left-- > 0)
            (void)loft_step_next(&step);
        slotting += since(start);
    }
}

int main(void)
{
    loft_limits limits = { .corner = LOFT_REAL(0.01), .tol = LOFT_REAL(0.005), .tick_hz = 1000 };
    static const int32_t origin[LOFT_AXES] = { 0 };
    enum loft_plan_state state = LOFT_PLAN_SPAN;
    unsigned next = 0;
    loft_span span;

    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = LOFT_REAL(1000);
        limits.max_accel[i] = LOFT_REAL(500);
        limits.max_jerk[i]  = JERK;
    }
    meter_start();
    if (loft_plan_init(&plan, &limits, moves, MOVES, knots, KNOTS) != LOFT_OK ||
        loft_step_init(&step, origin) != LOFT_OK)
        return 1;
    while (next < 12 || state == LOFT_PLAN_SPAN) {
        const loft_move m = curve(next < 12 ? next : 11);
        uint32_t start = meter_now();
        if (next < 12 && loft_plan_push(&plan, &m) == LOFT_OK)
            next++;
        if (next == 12)
            loft_plan_end(&plan);
        take(since(start), &planning, &plan_worst);
        start = meter_now();
        state = loft_plan_next(&plan, &span);
        take(since(start), &planning, &plan_worst);
        if (state == LOFT_PLAN_SPAN) {
            spans++;
            run(&span);
        }
    }
    say_line(debugger_put, "curves", next);
    say_line(debugger_put, "spans", spans);
    say_line(debugger_put, "ticks", ticks);
    say_wide(debugger_put, "planning", planning);
    say_line(debugger_put, "plan_worst", plan_worst);
    say_wide(debugger_put, "ticking", ticking);
    say_wide(debugger_put, "begin", begin);
    say_line(debugger_put, "tick_worst", tick_worst);
    say_wide(debugger_put, "slotting", slotting);
    say_line(debugger_put, "slots", slots);
    say_line(debugger_put, "plan_bytes", sizeof plan + sizeof moves + sizeof knots);
    int32_t position[LOFT_AXES];
    loft_step_position(&step, position);
    return position[0] == 0 && position[1] == 0 ? 0 : 1;
}
