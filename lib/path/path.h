/* lib/path/path.h -- path: curves become places, graded by the path itself
 * SPDX-License-Identifier: MIT
 *
 * The places are those of a first guess of the motion, one a period apart: slow where the path has
 * a corner that the tolerance does not swallow, with the jerk of a launch from there, and fast
 * elsewhere. It is a guess of places only: their timing is found later (timing.h). Joints of the
 * curves matter only for what they do to the path at the scale of the tolerance, so that it does
 * not matter into how many curves a path is cut.
 */
#ifndef LOFT_PATH_PATH_H
#define LOFT_PATH_PATH_H

#include "path/corner.h"  /* loft_corners */
#include "path/place.h"   /* loft_path_place   */

LOFT_BEGIN_C

/* Places that are checked before they are given. */
#define LOFT_PATH_QUEUE     14

/* One that waits, at the length s from the start of the chain. */
typedef struct {
    int64_t         s;
    loft_path_place on;
} loft_path_waiting;

enum loft_path_state { LOFT_PATH_PLACE, LOFT_PATH_WAIT, LOFT_PATH_END };

/* Do not rely on the fields. */
typedef struct {
    loft_chain         chain;
    loft_corners       corners;
    loft_chain_walk    walk, check;
    loft_chain_walk    last;                /* behind check: at the end of the last way that was
                                             * looked at */
    bool               over;
    loft_vec           end;                 /* of the chain that is over */
#if LOFT_FOLDS
    loft_vec           from;                /* where the one begins that places are given of */
#endif
    int64_t            s;                   /* of the last place */
    int32_t            step;                /* to it, 2^-10 periods */
    int64_t            along;               /* where the arc begins to which these belong: */
    loft_coord         cap;                 /* the most speed in a period, */
    loft_corner        launch;              /* and a launch to it */
    loft_path_waiting  queue[LOFT_PATH_QUEUE];
    uint8_t            queued;
    uint8_t            averaged, settled;   /* how many of them are on the mean of the path, and how
                                             * many ways are known to be close enough? */
} loft_path;

/* Start an empty path in the caller's memory; `period` is kept. */
void loft_path_init(loft_path *path, const loft_period *period, loft_move moves[], uint16_t room);

/* The next place: the first is the start of the chain, the last its end.
 *
 *   shape   LOFT_PATH_WAIT: that depends on what comes; LOFT_PATH_END: the path ended with the
 *           place before; what is pushed then begins a chain of its own after loft_path_begin
 */
enum loft_path_state loft_path_next(loft_path *path, loft_path_place *out);

/* Where the chain begins that places are given of. */
static inline loft_vec loft_path_from(const loft_path *path)
{
#if LOFT_FOLDS
    return path->from;
#else
    return path->chain.from;
#endif
}

/* Begin the next chain, after the end of the last one. */
void loft_path_begin(loft_path *path);

LOFT_END_C

#endif
