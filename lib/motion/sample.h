/* lib/motion/sample.h -- places of the timed path at even periods
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_SAMPLE_H
#define LOFT_MOTION_SAMPLE_H

#include "motion/timing.h"  /* loft_knot */

LOFT_BEGIN_C

/* Time: 2^30 is a period. */
typedef int64_t loft_time;
#define LOFT_TIME_ONE ((loft_time)1 << 30)

/* A place between knot k and the next, `time` after knot k. */
typedef struct {
    unsigned  knot;
    loft_time time, whole;      /* whole: the time from knot k to the next; 0: not known yet */
} loft_sample;

/* The time from knot k to the next.
 *
 *   error   2^-20 of it where the pace changes by less than a third
 */
loft_time loft_sample_time(const loft_knot knot[], unsigned k);

/* Go on by `time`, up to knot `last`; gives what is left of it. */
loft_time loft_sample_pass(loft_sample *at, const loft_knot knot[], unsigned last, loft_time time);

/* How far between its knots it is, 2^-30. */
int32_t loft_sample_part(const loft_sample *at, const loft_knot knot[]);

/* Where it is on the path. */
void loft_sample_place(const loft_sample *at, const loft_knot knot[], loft_position *out);

LOFT_END_C

#endif
