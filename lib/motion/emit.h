/* lib/motion/emit.h -- places of the timed path at even periods, and spans of these samples
 * SPDX-License-Identifier: MIT
 *
 * The motion is a uniform cubic B-spline in time, with the samples X at its knots: control points
 * C = X - D2 X / 6, moved by as little as holds all limits. Of these thin.h makes spans.
 */
#ifndef LOFT_MOTION_EMIT_H
#define LOFT_MOTION_EMIT_H

#include "motion/thin.h"    /* loft_thin, loft_period, loft_span */
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
static inline void loft_sample_place(const loft_sample *at, const loft_knot knot[],
                                     loft_position *out)
{
    loft_tube_place(knot, at->knot, loft_sample_part(at, knot), out);
}

#define LOFT_EMIT_SAMPLES 10

/* Do not rely on the fields. Sample number `first` of the chain is sample[0]. */
typedef struct {
    const loft_period *period;
    loft_position sample[LOFT_EMIT_SAMPLES], point[LOFT_EMIT_SAMPLES];
    loft_coord feed[LOFT_EMIT_SAMPLES];     /* the speed that is asked for before each */
    uint16_t   number[LOFT_EMIT_SAMPLES];   /* curves that are behind each */
#if LOFT_FOLDS
    loft_fold  fold[LOFT_EMIT_SAMPLES], left_out;   /* of the path before each, and the next one */
#endif
    uint8_t    count, next;                 /* which point is used next? */
    bool       begun, ended;
    loft_thin  thin;
    loft_vec   to;                          /* the end of the chain */
    uint16_t   last;                        /* ticks of its last span */
} loft_emit;

/* Begin a chain of at least two samples. */
void loft_emit_begin(loft_emit *emit, const loft_period *period, loft_vec from);

/* What is left out of the path before the samples that follow. */
void loft_emit_fold(loft_emit *emit, const loft_path_place *before);

/* Append a sample; there is room for it. `feed`: the speed that is asked for before it; `number`:
 * the curves behind it. */
void loft_emit_add(loft_emit *emit, const loft_position *sample, loft_coord feed, uint16_t number);

/* Append the end of the chain, which is the place `sample`, exactly `to`, so many ticks after the
 * last one: loft_period.last, and less than a period more. Where limits ask for it there are some
 * more. */
void loft_emit_end(loft_emit *emit, const loft_position *sample, loft_coord feed, uint16_t number,
                   loft_vec to, uint16_t ticks);

/* The next span, when it is sure; false: more samples are needed, or all is done. */
bool loft_emit_next(loft_emit *emit, loft_span *out);

/* Curves that are behind the end of the last span. */
static inline uint16_t loft_emit_passed(const loft_emit *emit) { return emit->thin.passed; }

LOFT_END_C

#endif
