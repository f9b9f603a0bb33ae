/* lib/path/corner.h -- corners: where the tolerance does not swallow what the path turns by
 * SPDX-License-Identifier: MIT
 *
 * They are found ahead of the walk, with the speed that they may be passed at. A launch is a motion
 * from rest with the jerk; corners say how far from them a launch has come.
 */
#ifndef LOFT_PATH_CORNER_H
#define LOFT_PATH_CORNER_H

#include "path/chain.h"   /* loft_chain */

LOFT_BEGIN_C

/* Corners that are known ahead, and stretches of the path around one. */
#define LOFT_CORNERS_MOST   (LOFT_PLAN_EFFORT > 1 ? 48 : 24)
#define LOFT_CORNERS_STRETCHES (LOFT_PLAN_EFFORT > 1 ? 40 : 26)
/* Parts of the path near corners: the next ones, if they have a tolerance of their own. */
#define LOFT_CORNERS_ZONES  (LOFT_PLAN_EFFORT > 1 ? 16 : 8)
/* A period, in times of corners. */
#define LOFT_CORNER_ONE     1024
/* Little effort: away from corners places are farther apart, so fewer of them look ahead as far. */
#define LOFT_CORNER_STEP    (LOFT_PLAN_EFFORT > 1 ? LOFT_CORNER_ONE : LOFT_CORNER_ONE * 7 / 4)

/* A place where the motion is slow. */
typedef struct {
    int64_t   s;            /* from the start of the chain */
    loft_coord jerk;         /* of a launch, along the path */
    loft_coord way;          /* from a rest to the speed that it is passed with */
    int32_t   time;         /* and how long that takes, 2^-10 periods */
    int32_t   on;           /* so far on as well; -1: a place goes onto it */
} loft_corner;

/* A part of the path that is near corners. */
typedef struct {
    int64_t from, to;
} loft_corner_zone;

/* A nearly straight part of the path. */
typedef struct {
    loft_position at;                                      /* where it begins */
    int16_t    from[LOFT_AXES], to[LOFT_AXES];          /* directions at its ends, 2^-14 */
    loft_coord  length, cap;                             /* cap: of speed, in a period */
} loft_corner_stretch;

/* Do not rely on the fields. */
typedef struct {
    const loft_chain   *chain;
    loft_chain_walk     walk;
    loft_corner_stretch stretch[LOFT_CORNERS_STRETCHES];
    uint8_t             stretches, looked;      /* at how many of their starts? */
    int64_t             known;                  /* what the corners are known of */
    loft_corner         corner[LOFT_CORNERS_MOST];
    uint8_t             count;
    int32_t             kink;                   /* the last joint that turns, 2^-8 mm */
    loft_corner_zone    zone[LOFT_CORNERS_ZONES];
    uint8_t             zones;
    loft_coord          wide;                   /* the largest radius since the last tip, */
    loft_coord          tip;                    /* that of it, */
    loft_coord          bent;                   /* and at the last joint */
} loft_corners;

/* Start at the first arc of the chain, which is kept. */
void loft_corners_begin(loft_corners *c, const loft_chain *chain);

/* Find corners up to the length `to`, as far as there is room. */
void loft_corners_scan(loft_corners *c, int64_t to);
bool loft_corners_full(const loft_corners *c);

/* Forget corners before s, but the one that allows the least still, with `cap` the most. */
void loft_corners_drop(loft_corners *c, int64_t s, loft_coord cap);

/* Forget zones before s; `one`: the first of as many as there is room for as well. */
void loft_corners_drop_zones(loft_corners *c, int64_t s, bool one);

/* Are all corners known up to the end of the chain? */
bool loft_corners_end_known(const loft_corners *c);

/* Is the path smooth from s on, as far as its corners are known? */
static inline bool loft_corners_smooth(const loft_corners *c, int64_t s)
{
    return s >> (LOFT_COORD_BITS - 8) > c->kink;
}

/* A corner at s that is passed with a speed in a period. */
loft_corner loft_corner_of(int64_t s, loft_coord speed, loft_coord jerk, bool sharp);

/* A corner that is reached from the one before, or left to it, with less than its own speed is
 * forgotten. */
void loft_corners_add(loft_corners *c, loft_corner corner);

/* The corner at the end of what is known; `ends`: it is the end of the chain. */
loft_corner loft_corners_last(const loft_corners *c, bool ends);

/* Is s within a bend that is passed evenly? */
static inline bool loft_corner_lasts(const loft_corner *c, int64_t s)
{
    return c->s <= s && s < c->s + c->on;
}

/* Where a corner lets the next place be, `part` of a period after s. */
int64_t loft_corner_allows(const loft_corner *c, int64_t s, int32_t part);

/* The time of a launch from it to s, or of a landing from there. */
int32_t loft_corner_time(const loft_corner *c, int64_t s);

/* The next one behind s onto which a place goes; NULL: none is known. */
const loft_corner *loft_corners_next_sharp(const loft_corners *c, int64_t s);

/* Does the path between these have the tolerance of corners? */
bool loft_corners_loose(const loft_corners *c, int64_t from, int64_t to);

/* The most speed in a period along a direction, with a feed. */
loft_coord loft_corner_cap(const loft_period *p, const int16_t u[], loft_coord feed);

/* And the jerk of a launch to it. */
loft_coord loft_corner_jerk(const loft_period *p, const int16_t u[], loft_coord cap);

LOFT_END_C

#endif
