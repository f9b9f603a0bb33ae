/* lib/motion/limits.h -- what a machine can do, and what of it a plan may use
 * SPDX-License-Identifier: MIT
 *
 * Speeds are compared by their squares: along a path with even acceleration a the square of the
 * speed is a straight line, d(v^2) = 2 a ds. Such squares are loft_acc.
 */
#ifndef LOFT_MOTION_LIMITS_H
#define LOFT_MOTION_LIMITS_H

#include "geom/vec.h"   /* loft_vec */

LOFT_BEGIN_C

#define LOFT_SPEED_MIN LOFT_REAL(0.015625)  /* 1/64 mm/s: just below 1 mm/min */
#define LOFT_SPEED_MAX LOFT_REAL(16383)     /* mm/s; its square has 28 bits   */
#define LOFT_ACCEL_MIN LOFT_REAL(1)         /* mm/s^2                         */
#define LOFT_ACCEL_MAX LOFT_REAL(16383)     /* mm/s^2                         */
#define LOFT_JERK_MAX  10000000             /* mm/s^3                         */

/* Samples of the path that one span can see, 4..128: a span lasts up to three beats less. Cost: 8
 * LOFT_AXES bytes of RAM each. With 4 every beat is a span, two points are kept, the search for the
 * longest one is not part of the program, and beats may be longer. */
#ifndef LOFT_PLAN_WINDOW
#  define LOFT_PLAN_WINDOW 64
#endif

/* Beats a second, at least, where jerk is not limited, 50..500. Fewer cost less time of planning,
 * and corners are passed slower; where the acceleration is large for the tolerance they are more in
 * any case (limits.c). */
#ifndef LOFT_PLAN_BEATS
#  define LOFT_PLAN_BEATS 500
#endif

/* Beats over which a jerk limit may spread a change of acceleration; a longer spread is given up
 * for less acceleration. 1: jerk cannot be limited, a limit of it is refused, and what it takes is
 * not part of the program. Cost: 4 bytes of RAM each in q16. */
#ifndef LOFT_PLAN_FILTER
#  define LOFT_PLAN_FILTER 32
#endif

/* 1: motion with limited jerk is raised along the path where the ring of pieces is large (flow.h).
 * 0: it is averaged everywhere; a piece takes 200 bytes less, the program 10 kB less, motion up to
 * half as long again: small chips. */
#ifndef LOFT_PLAN_FLOW
#  define LOFT_PLAN_FLOW (LOFT_PLAN_FILTER > 1)
#endif

/* What the machine can do. */
typedef struct {
    loft_real max_speed[LOFT_AXES];     /* mm/s, 1/64..16383 */
    loft_real max_accel[LOFT_AXES];     /* mm/s^2, 1..16383; held by the whole vector of
                                         * acceleration, or see */
    loft_real max_across;               /* mm/s^2, 1..16383: acceleration across the path, by its
                                         * size; then max_accel counts for the change of speed along
                                         * it alone, as grbl means it. 0: max_accel counts for
                                         * both */
    uint32_t  max_jerk[LOFT_AXES];      /* mm/s^3, to 10,000,000; 0: not limited (0 for all: even
                                         * acceleration, trapezoids) */
    loft_real corner;                   /* junction deviation in mm, 0..1, as grbl's $11; 0: all but
                                         * stop */
    loft_real tol;                      /* how far spans may leave the path, rounding included, mm,
                                         * 1/1024..1 */
    uint16_t  tick_hz;                  /* ticks per second, 50..50000 */
} loft_limits;

/* The limits as a plan uses them. Do not rely on the fields. */
typedef struct {
    loft_real corner, tol;
    loft_real swing;                    /* mm/s: the change of velocity at a corner that leaves the
                                         * path by tol / 2 */
    loft_real across;                   /* mm/s^2, where `accel` is for acceleration along it alone;
                                         * or 0 */
    loft_unit pulse;                    /* seconds of a beat */
    uint16_t  tick_hz, beat;            /* the path is sampled every `beat` ticks */
    uint8_t   filter;                   /* beats over which acceleration changes; 1: at once */
    bool      jerk;                     /* is it limited? */
    loft_real max_speed[LOFT_AXES];
    loft_real accel[LOFT_AXES];         /* mm/s^2 for acceleration along and across the path */
    loft_real spare[LOFT_AXES];         /* mm/s: the change of velocity at one joint */
    loft_real share[LOFT_AXES];         /* mm/s^2: for the changes of velocity at joints that follow
                                         * each other */
    /* mm/s^2: how much it may change in a beat */
    loft_real gain[LOFT_PLAN_FILTER > 1 ? LOFT_AXES : 1];
} loft_budget;

/* Is jerk limited? */
#define LOFT_BUDGET_JERK(b) (LOFT_PLAN_FILTER > 1 && (b)->jerk)

/* Are these limits possible?
 *
 *   range   LOFT_ERR_ARG for a limit that is zero (except corner), negative or not a number: the
 *           machine could not move; LOFT_ERR_RANGE for one beyond the ranges beside the fields
 */
enum loft_status loft_limits_check(const loft_limits *limits) LOFT_CHECKED;

/* What a plan may use of `limits`, which have been checked. */
void loft_budget_init(loft_budget *b, const loft_limits *limits);

/* mm per beat at a speed of v mm/s, 0 <= v <= LOFT_SPEED_MAX.
 *
 *   error   q16: 2^-33 mm   f32, f64: 1 ulp of double
 */
loft_acc loft_budget_beat(const loft_budget *b, loft_real v);

/* The most that the square of the speed may be where the direction jumps from `before` to `after`
 * (of length 1); `spacing` is the distance to the next such place, mm. `corner`: a junction
 * deviation may be used.
 *
 *   range   gives at most LOFT_SPEED_MAX squared, and more than 0
 *   error   q16: below 1 % for turns of more than 0.002
 */
loft_acc loft_budget_joint(const loft_budget *b, const loft_vec *before, const loft_vec *after,
                           loft_acc spacing, bool corner);

/* The least of what the axes have. */
static inline loft_real loft_real_min(const loft_real of[LOFT_AXES])
{
    loft_real a = of[0];
    for (int i = 1; i < LOFT_AXES; i++)
        a = of[i] < a ? of[i] : a;
    return a;
}

/* a / b where that is less than v, else v; a, b >= 0.
 *
 *   error   as loft_div
 */
static inline loft_real loft_real_cap(loft_real v, loft_real a, loft_real b)
{
    return loft_prod(v, b) > loft_to_acc(a) ? loft_div(a, b) : v;
}

LOFT_END_C

#endif
