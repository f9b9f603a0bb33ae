/* lib/motion/span.h -- a span: a cubic in time, for a whole number of ticks
 * SPDX-License-Identifier: MIT
 *
 * Position at time tau = 0..ticks is the Bezier curve p at tau / ticks, per axis, in mm. A chain of
 * spans is what a machine executes; each starts where the one before ended.
 *
 * From curves to pulses a firmware has three contexts. Each may interrupt those above it; what
 * crosses from one to the next is a queue of spans (yours: one writes, one reads), the one byte in
 * loft_step, and loft_pace_aim (where storing 16 bits takes two stores, as on AVR, with interrupts
 * off).
 *
 *   main loop    loft_plan_push, loft_plan_next: as long as they take; each span into the queue.
 *                Before any: loft_limits, loft_plan_init, loft_pace_init, loft_step_init
 *   each tick    while loft_step_room(&step):                // a timer's interrupt, or the main
 *                loop where that is never late
 *                    slots = loft_pace_next(&pace)           // 0: it stands, on the path; nothing
 *                                                            else to do
 *                    if (!loft_forward_next(&walk, &at))     // the walk is over: the next span's,
 *                                                            or, none there, all is done
 *                        loft_span_walk(&walk, the next span), loft_forward_next(&walk, &at)
 *                    target[i] = loft_steps_of(at.axis[i], steps_per_mm[i]) for each axis
 *                    loft_step_load(&step, target, slots)
 *   each slot    pins = loft_step_next(&step)                // the timer's interrupt of tick_hz *
 *                slots: directions, then pulses, to the pins
 *
 * A tick lasts at least 1 / tick_hz; what it calls must be done by then. On a small chip
 * loft_span_walk takes longer: make the walk of the next span in the main loop while the one before
 * is walked (two loft_forward), as machine/drive_tick.c does. When the queue empties before its
 * end, aim the pace at 0 in good time: loft_pace_distance. Everything here is reentrant and keeps
 * nothing but its structs.
 *
 * A call costs at most, in cycles of an ATmega328P (-Os), in instructions of a Cortex-M0 and M4
 * (-O2), for three axes in q16; and bytes (`make check-calls`):
 *
 *   loft_step_next           330      140     110     loft_step 128
 *   loft_step_take           220       90      60
 *   loft_step_give         1,600    1,010     700     (20 slots)
 *   loft_step_load         1,600      410     130
 *   loft_pace_next         1,500      280     170     loft_pace 20
 *   loft_forward_next        490       62      48     loft_forward 152
 *   loft_steps_of            150       30      10
 *   loft_step_position       670      280     100
 *   loft_span_walk        24,300   11,000   2,900     loft_span 52
 */
#ifndef LOFT_MOTION_SPAN_H
#define LOFT_MOTION_SPAN_H

#include "curve/forward.h"  /* loft_forward */

LOFT_BEGIN_C

#define LOFT_SPAN_TICKS_MAX 1023    /* the most for which a walk errs by at most 0.521 LSB */

typedef struct {
    loft_vec p[4];          /* mm; p[0] is the end of the span before */
    uint16_t ticks;         /* 1..LOFT_SPAN_TICKS_MAX                 */
} loft_span;

/* Prepare to yield the position after each tick of `s` (by exact forward differences).
 *
 *   shape   will yield s->ticks points, the last one is s->p[3]; `s` is not kept
 *   range   ticks 1..LOFT_SPAN_TICKS_MAX, otherwise LOFT_ERR_RANGE; any coordinates that a walk
 *           accepts
 *   error   that of loft_forward_next for a cubic: q16: 0.521 LSB
 *   cost    one loft_forward_init of degree 3
 *   stack   Cortex-M4 364   Cortex-M0+ 484   ATmega328P 243
 */
enum loft_status loft_span_walk(loft_forward *w, const loft_span *s) LOFT_CHECKED;

LOFT_END_C

#endif
