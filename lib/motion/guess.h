/* lib/motion/guess.h -- places of the path at even periods of a motion that is nearly the fastest
 * SPDX-License-Identifier: MIT
 *
 * The places of path.h become a smooth path (tube.h). What is nearly the least time along it
 * (barrier.h) gives places at even times. These go through the same once more. The result is the
 * guess that is smoothed and timed for good.
 */
#ifndef LOFT_MOTION_GUESS_H
#define LOFT_MOTION_GUESS_H

#include "motion/timing.h"  /* loft_knot */

LOFT_BEGIN_C

#define LOFT_GUESS_KNOTS  80
#define LOFT_GUESS_QUEUE  4
#define LOFT_GUESS_ROUNDS 2     /* the second begins better */

/* A place and three more on the way to the next. */
typedef struct {
    loft_path_place on;
    loft_position      inner[3];
} loft_guess_place;

/* Places become knots, which are smoothed and timed, and give places. */
typedef struct {
    loft_knot        knot[LOFT_GUESS_KNOTS];
    uint8_t          count, loaded, placed, timed;
    bool             filling;       /* knots are missing in the window */
    bool             ended;         /* is the last knot the end? */
    unsigned         at;            /* the last place is between knot `at` and the next, */
    int32_t          time;          /* and this long after it, 2^-16 periods */
    bool             begun, arrived;
    loft_guess_place queue[LOFT_GUESS_QUEUE];
    uint8_t          queued;
} loft_guess_round;

/* Do not rely on the fields. */
typedef struct {
    const loft_period *period;
    loft_path          path;
#if LOFT_PLAN_EFFORT > 1        /* otherwise the places of the path are taken as they are */
    loft_guess_round   round[LOFT_GUESS_ROUNDS];
#endif
} loft_guess;

/* Start without a curve, in the caller's memory; `period` is kept. */
void loft_guess_init(loft_guess *guess, const loft_period *period, loft_move moves[],
                     uint16_t room);

/* The next place; as loft_path_next. */
enum loft_path_state loft_guess_next(loft_guess *guess, loft_path_place *out);

/* Give places of the whole chain again, at even periods of its timed knots; false: there are too
 * many. */
bool loft_guess_again(loft_guess *guess, const loft_knot knots[], unsigned count);

/* Begin the next chain. */
void loft_guess_begin(loft_guess *guess);

LOFT_END_C

#endif
