/* lib/motion/thin.h -- control points of a motion in time become spans, as few as will do
 * SPDX-License-Identifier: MIT
 *
 * The points are those of a cubic B-spline in time with a knot at each. Knots are taken out where
 * limits are held without them, and the motion stays close to its samples. Then a span lasts from
 * knot to knot. Its control values are rounded to 2^-16 mm so that limits are held exactly, but in
 * f32.
 */
#ifndef LOFT_MOTION_THIN_H
#define LOFT_MOTION_THIN_H

#include "path/period.h"  /* loft_period, loft_position */
#include "motion/span.h"    /* loft_span */

LOFT_BEGIN_C

#define LOFT_THIN_POINTS  12
#define LOFT_THIN_SAMPLES (4 * LOFT_PERIOD_JOINED)  /* three long spans, and six periods */

/* A control point. Its knot is at `time`. */
typedef struct {
    int64_t    at[LOFT_AXES];       /* from the start of the chain */
    loft_coord feed;                /* the speed that is asked for since the knot before */
    uint16_t   time;                /* periods, modulo 2^16 */
    uint16_t   number;              /* curves that are behind the sample there */
#if LOFT_FOLDS
    loft_fold  fold;                /* what is left out of the path before it */
#endif
} loft_thin_point;

/* What was left out of a line, at the velocity that the motion has before and after it: from v0 it
 * rises to v in the first span, and in the last one it falls again. Of the axes, units. */
typedef struct {
    int64_t  way[LOFT_AXES];        /* all of it, grains; */
    int64_t  v0[LOFT_AXES], v[LOFT_AXES];   /* in 2^20 ticks */
    uint32_t ticks, gone;           /* all of them, and those behind the last span */
    uint16_t ramp, waited;          /* waited: periods, to begin where the speed is even */
} loft_thin_cruise;

/* Do not rely on the fields. */
typedef struct {
    const loft_period *period;
    loft_thin_point point[LOFT_THIN_POINTS];
    loft_position   sample[LOFT_THIN_SAMPLES];      /* after `time` periods, modulo their count */
    loft_position   origin, last;   /* the first point, the last one */
    uint8_t    count, next;         /* which knot may be taken out next? */
    bool       ended, moves;
    uint16_t   last_ticks;          /* of the last span */
    uint16_t   passed;              /* curves behind the end of the last span */
    int64_t    grains[LOFT_AXES];   /* 2^-16 mm from the start to the end of the last span */
    loft_vec   from, to, end;       /* ends of the chain, of the last span */
#if LOFT_FOLDS
    int64_t    cruised[LOFT_AXES];  /* what has been left out of the path, and came back, grains: */
    loft_fold  fold;                /* the same, modulo 2^32 */
    loft_thin_cruise cruise;
#endif
} loft_thin;

/* Begin a chain. */
void loft_thin_begin(loft_thin *thin, const loft_period *period, loft_vec from);

/* A point and the sample at its knot. */
typedef struct {
    loft_position point, sample;
    loft_coord    feed;             /* the speed that is asked for since the one before */
    uint16_t      number;           /* curves behind it */
#if LOFT_FOLDS
    loft_fold     fold;             /* what is left out of the path before it */
#endif
} loft_thin_input;

/* Append a point; there is room for one after loft_thin_next gave false. The first three are where
 * the chain begins. */
void loft_thin_add(loft_thin *thin, const loft_thin_input *in);

/* The last point was the end of the chain, `to`; two before it those of emit.c. The last span lasts
 * so many ticks. */
void loft_thin_end(loft_thin *thin, loft_vec to, uint16_t ticks);

/* The next span, when it is sure.
 *
 *   shape   it begins where the last one ended, with its velocity and acceleration, to rounding
 *   error   of its end: a grain, 2^-16 mm, more where limits ask for it
 *   cost    LOFT_AXES times 60 quotients and 300 sums for each point that was added
 */
bool loft_thin_next(loft_thin *thin, loft_span *out);

LOFT_END_C

#endif
