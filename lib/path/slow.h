/* lib/path/slow.h -- slow runs: curves that can be followed at their feed as they are
 * SPDX-License-Identifier: MIT
 *
 * Where spans cost most, what is slow for the machine is not planned: a run of such curves becomes
 * a chain of its own, whose spans lead along the curves (cruise.h). So places and spans of a slow
 * way are as many as its geometry asks for, however long it takes.
 */
#ifndef LOFT_PATH_SLOW_H
#define LOFT_PATH_SLOW_H

#include "path/chain.h"   /* loft_chain */

LOFT_BEGIN_C

#if LOFT_FOLDS

#define LOFT_SLOW_TURN  3           /* periods of half a change of velocity at a joint */
#define LOFT_SLOW_SPAN  2           /* and of the shortest span */
#define LOFT_SLOW_BITS  20          /* of speeds below units in a tick */

/* A curve that is walked by its arcs. Do not rely on the fields. */
typedef struct {
    const loft_cubic *curve;
    loft_arc   arc;
    uint32_t   to;              /* the parameter where the arc ends */
    int64_t    s;               /* where it begins */
    loft_coord length;
} loft_slow_walk;

/* What is known of a slow curve: it lasts whole ticks. */
typedef struct {
    int64_t  length, speed;     /* units; in a tick, LOFT_SLOW_BITS */
    uint32_t ticks;
    uint16_t longest;           /* ticks of a span */
    int32_t  from[LOFT_AXES], to[LOFT_AXES];    /* directions where it begins and ends, 2^-16 */
} loft_slow_curve;

/* Measure curve i of those that wait; false: it is not slow.
 *
 *   cost    that of its arcs
 */
bool loft_slow_measure(const loft_chain *chain, unsigned i, loft_slow_curve *out);

/* The change of velocity from the end of a curve to the start of the next, LOFT_SLOW_BITS. Gives
 * whether it is more than rounding. */
bool loft_slow_turns(const loft_period *p, const loft_slow_curve *before,
                     const loft_slow_curve *after, int64_t out[LOFT_AXES]);

/* Can a run go on from a curve to the next, without a rest? */
bool loft_slow_goes_on(const loft_period *p, const loft_slow_curve *before,
                       const loft_slow_curve *after);

/* Set how many curves may be walked: those before the next slow run, which ends the chain. Where
 * it depends on what comes whether there is one, those before that. */
void loft_slow_look(loft_chain *chain);

/* Stand before the first arc of a curve, which is kept. */
void loft_slow_begin(loft_slow_walk *w, const loft_cubic *curve);

/* Go to the arc at the length s, or to the last one. */
void loft_slow_go(loft_slow_walk *w, int64_t s);

/* Where it is at the length s, and its direction there, 2^-16. */
void loft_slow_place(const loft_slow_walk *w, int64_t s, loft_position *out,
                     int32_t heading[LOFT_AXES]);

#endif

LOFT_END_C

#endif
