/* lib/motion/emit.h -- samples of the motion become spans
 * SPDX-License-Identifier: MIT
 *
 * The spans are those of a uniform cubic B-spline in time, with the samples X at its knots: control
 * points C = X - D2 X / 6, moved by as little as holds all limits, and rounded to 2^-16 mm so that
 * they are held exactly, but in f32.
 */
#ifndef LOFT_MOTION_EMIT_H
#define LOFT_MOTION_EMIT_H

#include "motion/period.h"  /* loft_period, loft_position */
#include "motion/span.h"    /* loft_span */

LOFT_BEGIN_C

#define LOFT_EMIT_SAMPLES 16

/* Do not rely on the fields. Sample number `first` of the chain is sample[0]. */
typedef struct {
    const loft_period *period;
    loft_position sample[LOFT_EMIT_SAMPLES], point[LOFT_EMIT_SAMPLES];
    loft_coord feed[LOFT_EMIT_SAMPLES];     /* the speed that is asked for before each */
    uint16_t   number[LOFT_EMIT_SAMPLES];   /* curves that are behind each */
    uint8_t    count, next;                 /* the next span begins at sample `next` */
    bool       begun, moves, ended;
    int64_t    at[LOFT_AXES];               /* of point[next], from the start of the chain */
    int64_t    grains[LOFT_AXES];           /* 2^-16 mm from there to the end of the last span */
    loft_vec   from, to;                    /* ends of the chain */
    loft_vec   last;                        /* the end of the last span */
} loft_emit;

/* Begin a chain of at least two samples. */
void loft_emit_begin(loft_emit *emit, const loft_period *period, loft_vec from);

/* Append a sample; there is room for it. `feed`: the speed that is asked for before it; `number`:
 * the curves behind it. */
void loft_emit_add(loft_emit *emit, const loft_position *sample, loft_coord feed, uint16_t number);
static inline bool loft_emit_room(const loft_emit *emit) { return emit->count < LOFT_EMIT_SAMPLES; }

/* The last sample was the end of the chain, `to`. */
void loft_emit_end(loft_emit *emit, loft_vec to);

/* The next span, when it is sure; false: more samples are needed, or all is done. */
bool loft_emit_next(loft_emit *emit, loft_span *out);

LOFT_END_C

#endif
