/* tests/target/stack.c -- the stack that functions of lib/ are seen to take, on a Cortex-M and on
 * an ATmega328P
 * SPDX-License-Identifier: MIT
 *
 * Prints `FUNCTION BYTES` lines: from the stack pointer before a call of run_FUNCTION to the
 * deepest byte that changed. tests/house/stack.py takes the frame of run_FUNCTION off, and compares
 * the rest with the bound that it found.
 */
#include "loft.h"

#include "say.h"            /* say_line */

#define PAINT 0xA5u
#define CALLS 40

int main(void);

#if defined(__AVR__)
#  include "avr_say.h"

extern uint8_t __heap_start[];
#  define LOWEST __heap_start
#  define STACK_POINTER ((volatile uint8_t *)SP + 1)        /* SP is at the next free byte */

static void start(void) { serial_start(); }
#else
void debugger_put(char c);
extern uint8_t bss_end[];
#  define LOWEST bss_end
static inline volatile uint8_t *stack_pointer(void)
{
    volatile uint8_t *at;
    __asm__ volatile("mov %0, sp" : "=r"(at));
    return at;
}
#  define STACK_POINTER stack_pointer()

static void put(char c)     { debugger_put(c); }
/* The compiler moves words through the registers of the floating-point unit. */
static void start(void)     { *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; }
static void stop(void)      { }
#endif

static uint32_t state;
static loft_cubic curve;
static loft_bezier bezier;
static loft_vec at;
static loft_forward walk;
static loft_flatten flat;
static loft_nearest nearest;
static loft_scurve move;
static const loft_scurve_limits slow = { LOFT_REAL(100), LOFT_REAL(1000), LOFT_REAL(20000), 1000 };
static volatile loft_real kept;

static uint32_t any(uint32_t below)
{
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
}

static void draw(void)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            curve.p[k].axis[i] = (loft_real)any((uint32_t)200 << 16) - LOFT_REAL(100);
    if (loft_bezier_init(&bezier, curve.p, 3) != LOFT_OK)
        stop();
}

#define RUNS(name) static __attribute__((noinline)) void run_##name(void)
RUNS(loft_cubic_eval)     { at = loft_cubic_eval(&curve, (loft_unit)any((uint32_t)1 << 24)); }
RUNS(loft_forward_init)   { kept = loft_forward_init(&walk, &bezier, 1 + any(500)); }
RUNS(loft_forward_next)   { kept = loft_forward_next(&walk, &at); }
RUNS(loft_flatten_init)   { kept = loft_flatten_init(&flat, &curve, LOFT_REAL(0.1)); }
RUNS(loft_flatten_next)   { kept = loft_flatten_next(&flat, &at); }
RUNS(loft_bezier_nearest) { kept = loft_bezier_nearest(&bezier, at, LOFT_REAL(.01), &nearest); }
RUNS(loft_scurve_init)
{
    kept = loft_scurve_init(&move, curve.p[0].axis[0], curve.p[1].axis[1], &slow);
}
RUNS(loft_scurve_eval)    { kept = loft_scurve_eval(&move, any(2000)); }
RUNS(loft_scurve_retarget) { kept = loft_scurve_retarget(&move, any(500), curve.p[2].axis[0]); }
#if !defined(__AVR__)
static loft_plan plan;
static loft_move moves[8];
static loft_knot knots[160];
static loft_natural_knot memory[6];
static loft_waypoints way;
static loft_vec points[6];
static loft_span span;
static loft_limits limits;
RUNS(loft_plan_part)      { kept = loft_plan_part(&plan, &span); }
RUNS(loft_waypoints_next) { kept = loft_waypoints_next(&way, &span); }

static void way_through_points(void)
{
    limits = (loft_limits){ .tol = LOFT_REAL(.01), .tick_hz = 1000 };
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = LOFT_REAL(100);
        limits.max_accel[i] = LOFT_REAL(1000);
        limits.max_jerk[i]  = 20000;
    }
    for (int k = 0; k < 6; k++) {
        draw();
        points[k] = curve.p[0];
    }
    if (loft_plan_init(&plan, &limits, moves, 8, knots, 160) != LOFT_OK ||
        loft_waypoints_init(&way, &plan, points, 6, LOFT_REAL(50), memory) != LOFT_OK)
        stop();
}
#endif

static __attribute__((noinline)) unsigned seen(void (*run)(void))
{
    volatile uint8_t *const top = STACK_POINTER, *p;

    for (p = LOWEST; p < top; p++)
        *p = PAINT;
    run();
    for (p = LOWEST; p < top && *p == PAINT; p++) {
    }
    return (unsigned)(top - p);
}

static void most(const char *name, void (*run)(void), void (*before)(void), int calls)
{
    unsigned deepest = 0;

    for (int n = 0; n < calls; n++) {
        if (before)
            before();
        const unsigned bytes = seen(run);
        deepest = bytes > deepest ? bytes : deepest;
    }
    say_line(put, name, deepest);
}

#define MOST(name, before) most(#name, run_##name, before, CALLS)

int main(void)
{
    start();
    MOST(loft_cubic_eval, draw);
    MOST(loft_forward_init, draw);
    MOST(loft_forward_next, NULL);
    MOST(loft_flatten_init, draw);
    MOST(loft_flatten_next, NULL);
    MOST(loft_bezier_nearest, draw);
    MOST(loft_scurve_init, draw);
    MOST(loft_scurve_eval, NULL);
    MOST(loft_scurve_retarget, draw);
#if !defined(__AVR__)
    way_through_points();
    most("loft_waypoints_next", run_loft_waypoints_next, NULL, 60);
    most("loft_plan_part", run_loft_plan_part, NULL, 60);
#endif
    stop();
    return 0;
}
