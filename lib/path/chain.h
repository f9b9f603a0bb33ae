/* lib/path/chain.h -- chain: curves that wait in a ring, walked by their length
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PATH_CHAIN_H
#define LOFT_PATH_CHAIN_H

#include "path/arc.h"     /* loft_arc    */
#include "path/period.h"  /* loft_period */

LOFT_BEGIN_C

/* Coordinates of the path must be within +-LOFT_PLAN_REACH mm. */
#define LOFT_PLAN_REACH LOFT_REAL(8191)

/* A curve to follow, with its speed along the path in mm/s. */
typedef struct {
    loft_cubic curve;
    loft_real  feed;
} loft_move;

/* Directions are in multiples of 1 / LOFT_CHAIN_UNIT; a turn of 5 degrees is sharp. */
#define LOFT_CHAIN_UNIT  16384
#define LOFT_CHAIN_SHARP 1430

/* Do not rely on the fields. */
typedef struct {
    const loft_period *period;
    loft_move         *moves;
    uint16_t           room, first, count;
    uint16_t           dropped;             /* curves before the oldest one, modulo 2^16 */
    bool               ended;
    bool               walked;              /* has the walk begun, but not ended? */
    bool               closed;              /* has it come to the end? */
    loft_vec           from, to;            /* where the chain begins; where the last curve ends */
    int16_t            heading[LOFT_AXES];  /* the direction at `to`; 0: none is known */
#if LOFT_FOLDS
    uint16_t           known;               /* of the curves, those that may be walked: slow.h */
    bool               stops;               /* it ends with these: a slow run follows */
#endif
} loft_chain;

/* A curve that is walked by its length. */
typedef struct {
    loft_arc arc;
    int64_t  s;                 /* where the arc begins */
    uint32_t to;                /* the parameter where the arc ends */
    loft_coord length;           /* of the arc; 0: none yet */
    loft_coord feed;            /* the speed that is asked for, in a period */
    uint16_t number;            /* of the curve, of all that were pushed */
#if LOFT_FOLDS
    loft_fold fold, left;       /* what is left out before the arc, and in its middle */
#endif
} loft_chain_walk;

/* Start without a curve in the caller's memory; `period` is kept. */
void loft_chain_init(loft_chain *chain, const loft_period *period, loft_move moves[],
                     uint16_t room);

/* Can a plan take this curve?
 *
 *   range   as loft_plan_push, but for where it begins
 */
enum loft_status loft_chain_accepts(const loft_move *move);

/* Append a curve (copied). Where it has to stop before it, that ends the chain, and there is no
 * room until all of that has been walked.
 *
 *   range   as loft_plan_push
 */
enum loft_status loft_chain_push(loft_chain *chain, const loft_move *move) LOFT_CHECKED;

/* Curves that can be pushed now. */
static inline uint16_t loft_chain_room(const loft_chain *chain)
{
    return chain->closed ? 0 : (uint16_t)(chain->room - chain->count);
}

/* Drop the curves before this one, modulo 2^16. */
void loft_chain_drop(loft_chain *chain, uint16_t number);

/* The oldest curves, that may be walked. */
static inline uint16_t loft_chain_known(const loft_chain *chain)
{
#if LOFT_FOLDS
    return chain->known;
#else
    return chain->count;
#endif
}

/* Does it end with these? */
static inline bool loft_chain_ends(const loft_chain *chain)
{
#if LOFT_FOLDS
    return chain->stops || (chain->ended && chain->known == chain->count);
#else
    return chain->ended;
#endif
}

/* Are all known curves behind this walk? */
static inline bool loft_chain_walked(const loft_chain *chain, const loft_chain_walk *w)
{
    return (uint16_t)(w->number - chain->dropped) >= loft_chain_known(chain);
}

/* Curve i of those that wait. */
const loft_move *loft_chain_move(const loft_chain *chain, unsigned i);

/* Where the known curves end. */
loft_vec loft_chain_end(const loft_chain *chain);

/* What is known has been walked: what is left begins a chain of its own. */
void loft_chain_finish(loft_chain *chain);

/* Stand before the first arc. */
void loft_chain_begin(const loft_chain *chain, loft_chain_walk *w);

/* Go to the next arc; false: it is not known yet, and all before it have been passed. */
bool loft_chain_advance(const loft_chain *chain, loft_chain_walk *w);

/* Go to the next arc, or stay on this one. */
bool loft_chain_try(const loft_chain *chain, loft_chain_walk *w);

/* Walk to the arc at the length s, or to the last one; gives the least feed on the way. */
loft_coord loft_chain_go(const loft_chain *chain, loft_chain_walk *w, int64_t s);

/* The place at the length s, or at the end of the arc. */
void loft_chain_place(const loft_chain_walk *w, int64_t s, loft_position *out);

/* What is left out of the path before the length s, which is on the arc. */
loft_fold loft_chain_fold(const loft_chain_walk *w, int64_t s);

/* Is it so near to where a way is left out that the path has to be straight? */
bool loft_chain_is_straight(const loft_chain_walk *w, int64_t s);

/* The direction of the arc at its start, its middle or its end: n = 0..2. */
void loft_chain_direction(const loft_chain_walk *w, unsigned n, int16_t out[]);

/* The square of the turn between two directions, 2^-28. */
int64_t loft_chain_turn(const int16_t a[], const int16_t b[]);

LOFT_END_C

#endif
