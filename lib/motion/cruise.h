/* lib/motion/cruise.h -- spans along a slow run of curves, at their feed
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_CRUISE_H
#define LOFT_MOTION_CRUISE_H

#include "path/slow.h"      /* loft_slow_curve, loft_chain */
#include "motion/span.h"    /* loft_span */

LOFT_BEGIN_C

#if LOFT_FOLDS

/* A place between two spans: units from the start of the run, and its velocity. */
typedef struct {
    int64_t at[LOFT_AXES], v[LOFT_AXES];    /* LOFT_SLOW_BITS, in a tick */
} loft_cruise_node;

enum loft_cruise_state {
    LOFT_CRUISE_NONE,           /* no slow run begins here */
    LOFT_CRUISE_SPAN,
    LOFT_CRUISE_WAIT            /* that depends on what comes */
};

/* Do not rely on the fields. */
typedef struct {
    bool     runs;
    uint8_t  halves;            /* spans that are left of a change of velocity, */
    loft_cruise_node middle, behind;    /* and where the first and the second one end */
    bool     lands;             /* that is the end of the run */
    loft_slow_curve now, next;
    loft_slow_walk  walk;
    uint32_t gone;              /* ticks of this curve before the node */
    loft_cruise_node node;
    loft_vec from, end;         /* where the run began; the end of the last span */
} loft_cruise;

/* Nothing is known. */
static inline void loft_cruise_init(loft_cruise *cruise)
{
    cruise->runs = false;
    cruise->halves = 0;
}

/* The next span of a slow run that begins with the oldest curve of the chain, of which none is
 * walked. Curves that are behind it are dropped.
 *
 *   shape   spans connect with their velocities, to rounding; the acceleration of bends, which may
 *           jump, is less than a 256th of what axes allow
 *   error   of all but rounded joints: 2^-17 mm and a 10^5th of a span's length
 *   cost    the places at its ends, and those of arcs where a curve begins
 */
enum loft_cruise_state loft_cruise_next(loft_cruise *cruise, loft_chain *chain, loft_span *out);

#endif

LOFT_END_C

#endif
