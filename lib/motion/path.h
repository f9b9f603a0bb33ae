/* lib/motion/path.h -- path: curves become places, graded by the path itself
 * SPDX-License-Identifier: MIT
 *
 * The places are those of a first guess of the motion, one a period apart: slow where the path has
 * a corner that the tolerance does not swallow, with the jerk of a launch from there, and fast
 * elsewhere. It is a guess of places only: their timing is found later (timing.h). Joints of the
 * curves matter only for what they do to the path at the scale of the tolerance, so that it does
 * not matter into how many curves a path is cut.
 */
#ifndef LOFT_MOTION_PATH_H
#define LOFT_MOTION_PATH_H

#include "motion/arc.h"     /* loft_arc    */
#include "motion/period.h"  /* loft_period */

LOFT_BEGIN_C

/* Coordinates of the path must be within +-LOFT_PLAN_REACH mm. */
#define LOFT_PLAN_REACH LOFT_REAL(8191)

/* A curve to follow, with its speed along the path in mm/s. */
typedef struct {
    loft_cubic curve;
    loft_real  feed;
} loft_move;

/* Corners that are known ahead, and stretches of the path around one. */
#define LOFT_PATH_CORNERS   48
#define LOFT_PATH_STRETCHES 40
/* Parts of the path near corners: the next ones, if they have a tolerance of their own. */
#define LOFT_PATH_ZONES     16
/* Places that are checked before they are given. */
#define LOFT_PATH_QUEUE     24

/* A place where the first guess is slow. */
typedef struct {
    int64_t   s;            /* from the start of the chain */
    loft_coord jerk;         /* of a launch, along the path */
    loft_coord way;          /* from a rest to the speed that it is passed with */
    int32_t   time;         /* and how long that takes, 2^-10 periods */
    bool      sharp;        /* a place goes onto it */
} loft_path_corner;

/* A part of the path that is near corners. */
typedef struct {
    int64_t from, to;
} loft_path_zone;

/* A nearly straight part of the path. */
typedef struct {
    loft_position at;                                      /* where it begins */
    int16_t    from[LOFT_AXES], to[LOFT_AXES];          /* directions at its ends, 2^-14 */
    loft_coord  length, cap;                             /* cap: of speed, in a period */
    int64_t    s;
} loft_path_stretch;

/* A curve that is walked by its length. */
typedef struct {
    loft_arc arc;
    uint32_t from, to;          /* parameters */
    int64_t  s;                 /* where the arc begins */
    loft_coord length;           /* of the arc; 0: none yet */
    uint16_t number;            /* of the curve, of all that were pushed */
} loft_path_walk;

/* A place of the path. */
typedef struct {
    loft_position at;
    loft_coord feed;        /* the speed that is asked for from the last place to this one */
    loft_coord skip;        /* how far the path is from the cubic through four places
                             * (loft_path_between), from this one to the next */
    int64_t    s;           /* from the start of the chain */
    uint16_t   number;      /* of its curve */
    bool       sharp;       /* it is a corner */
    bool       loose;       /* up to the next one it is near corners */
} loft_path_place;

/* How far the motion may be from the path, from this place to the next. */
static inline loft_coord loft_path_tol(const loft_period *p, const loft_path_place *from)
{
    return p->tol + (from->loose ? p->more : 0);
}

enum loft_path_state { LOFT_PATH_PLACE, LOFT_PATH_WAIT, LOFT_PATH_END };

/* Do not rely on the fields. */
typedef struct {
    const loft_period *period;
    loft_move         *moves;
    uint16_t           room, first, count;
    uint16_t           dropped;             /* curves before the oldest one, modulo 2^16 */
    bool               ended, begun, over;
    loft_path_walk     scan, walk, check;
    loft_vec           from, to;            /* where the chain begins; where the last curve ends */
    loft_vec           end;                 /* of the chain that is over */
    int16_t            heading[LOFT_AXES];  /* the direction at `to`, 2^-14; 0: none is known */
    loft_path_stretch  stretch[LOFT_PATH_STRETCHES];
    uint8_t            stretches, looked;   /* at how many of their starts? */
    int64_t            known;               /* what the corners are known of */
    loft_path_corner   corner[LOFT_PATH_CORNERS];
    uint8_t            corners;
    loft_path_zone     zone[LOFT_PATH_ZONES];
    uint8_t            zones;
    int64_t            s;                   /* of the last place */
    int32_t            step;                /* to it, 2^-10 periods */
    loft_path_place    queue[LOFT_PATH_QUEUE];
    uint8_t            queued, settled;     /* how many of them are known to be close enough? */
    bool               last;                /* is the last of them the end? */
} loft_path;

/* Start an empty path in the caller's memory; `period` is kept. */
void loft_path_init(loft_path *path, const loft_period *period, loft_move moves[], uint16_t room);

/* Append a curve (copied). Where it has to stop before it, that ends the chain, and there is no
 * room until all of that has been walked.
 *
 *   range   as loft_plan_push
 */
enum loft_status loft_path_push(loft_path *path, const loft_move *move) LOFT_CHECKED;

/* Curves that can be pushed now. */
static inline uint16_t loft_path_room(const loft_path *p)
{
    return p->last && !p->over ? 0 : (uint16_t)(p->room - p->count);
}

/* The next place: the first is the start of the chain, the last its end.
 *
 *   shape   LOFT_PATH_WAIT: that depends on what comes; LOFT_PATH_END: the path ended with the
 *           place before; what is pushed then begins a chain of its own after loft_path_begin
 */
enum loft_path_state loft_path_next(loft_path *path, loft_path_place *out);

/* Begin the next chain, after the end of the last one. */
void loft_path_begin(loft_path *path);

/* The cubic from b to c, of the places a, b, c, d: at part z, 2^-24, of the way. It ends along its
 * chord at a sharp place. */
void loft_path_between(const loft_path_place *const at[4], int32_t z, loft_position *out);

/* How far p is from it, near that part.
 *
 *   error   never too small
 */
loft_coord loft_path_off(const loft_path_place *const at[4], int32_t z, const loft_position *p);

LOFT_END_C

#endif
