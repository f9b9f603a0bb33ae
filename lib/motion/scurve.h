/* lib/motion/scurve.h -- one axis from rest to rest, by limits of speed, acceleration and jerk
 * SPDX-License-Identifier: MIT
 *
 * The S-curve of a servo, a lift or a focus: at most seven pieces of even jerk, as fast as whole
 * ticks allow. Its places are a closed form, so that any tick may be asked for.
 *
 *     static const loft_scurve_limits limits = {
 *         .max_speed = LOFT_REAL(100), .max_accel = LOFT_REAL(500), .max_jerk = 10000,
 *         .tick_hz = 1000 };
 *     loft_scurve move;
 *     if (loft_scurve_init(&move, LOFT_REAL(0), LOFT_REAL(25), &limits) == LOFT_OK)
 *         for (uint32_t tick = 1; tick <= move.ticks; tick++)      // in the timer
 *             place = loft_scurve_eval(&move, tick);
 *
 * A unit of place is whatever the axis has: mm, degrees, steps. For several axes on one path see
 * motion/plan.h.
 *
 * A call costs at most, in cycles of an ATmega328P (-Os), in instructions of a Cortex-M0 and M4
 * (-O2), in q16; and bytes (`make check-calls`):
 *
 *   loft_scurve_init      56,000    9,300   1,600     loft_scurve 112
 *   loft_scurve_eval      70,000    6,000   2,100
 *   loft_scurve_retarget 105,000   17,500   4,700
 */
#ifndef LOFT_MOTION_SCURVE_H
#define LOFT_MOTION_SCURVE_H

#include "num/num.h"        /* loft_real, loft_acc */

LOFT_BEGIN_C

#define LOFT_SCURVE_TICKS 1048576       /* the longest of the three parts of a move, in ticks */

/* What the axis can do. In f32 and f64 these are used in steps of 2^-16, rounded down. */
typedef struct {
    loft_real max_speed;        /* units/s, above 0                     */
    loft_real max_accel;        /* units/s^2, 1 or more                 */
    uint32_t  max_jerk;         /* units/s^3; 0: not limited            */
    uint16_t  tick_hz;          /* ticks per second, 1..50000           */
} loft_scurve_limits;

/* A step of the place by `way`, averaged over three lengths of time. Do not rely on the fields. */
typedef struct {
    loft_acc way;
    uint32_t start;             /* tick                                                     */
    uint32_t cruise, ramp, ease;    /* ticks: cruise >= ramp + ease, ramp >= ease >= 1      */
} loft_scurve_part;

/* A move. Do not fill it yourself: call init. */
typedef struct {
    loft_real to;
    uint32_t ticks;             /* from this tick on the axis rests at `to` */
    loft_scurve_limits limits;
    loft_acc from;
    uint8_t count;
    loft_scurve_part part[3];   /* one, and more after a change of the target */
} loft_scurve;

/* Prepare a move that begins at rest at tick 0.
 *
 *   shape   no limit is exceeded, in the mean over any number of ticks; the way is monotone
 *   range   LOFT_ERR_ARG for a limit beyond its range; LOFT_ERR_RANGE for a way of 32767 or more,
 *           or one that takes LOFT_SCURVE_TICKS or more: use fewer ticks a second
 *   error   of the time, which is at most 4 ticks longer than the shortest; 4 ticks at least
 *   cost    10 divisions and 40 rounds of up to 5 products, of 64 bits
 *   stack   Cortex-M4 272   Cortex-M0+ 316   ATmega328P 220
 *   see     Biagiotti, Melchiorri: Trajectory Planning for Automatic Machines and Robots, 3.4
 */
enum loft_status loft_scurve_init(loft_scurve *s, loft_real from, loft_real to,
                                  const loft_scurve_limits *limits) LOFT_CHECKED;

/* The place at a tick: `from` until tick 0, `to` from s->ticks on, both exactly.
 *
 *   error   of the S-curve with these whole ticks, q16: 1/2 LSB + 2^-14 LSB   f32: 1/2 ulp + 4 ulp
 *           of double of the larger of |from|, |to|   f64: 4 ulp of it
 *   cost    q16: for each part that moves 12 products and a division of 128 bits (num/muldiv.h)
 *   stack   Cortex-M4 108   Cortex-M0+ 188   ATmega328P 235
 */
loft_real loft_scurve_eval(const loft_scurve *s, uint32_t tick);

/* Change the target while the axis moves, or after; places before `tick` are void then. Ticks go
 * on counting from the beginning of the first move.
 *
 *   shape   no limit is exceeded; a target ahead of a place where the axis can stop is met without
 *           a stop if that is sooner, any other after one
 *   range   as loft_scurve_init, of the way from where the axis would stop; on an error the move
 *           stays as it was. Ticks do not wrap: begin by init again before 2^32 of them
 *   error   of the time: a stop, and a move from rest, at most; the shortest is not searched for
 *   cost    twice that of loft_scurve_init
 *   stack   Cortex-M4 448   Cortex-M0+ 492   ATmega328P 395
 */
enum loft_status loft_scurve_retarget(loft_scurve *s, uint32_t tick, loft_real to) LOFT_CHECKED;

LOFT_END_C

#endif
