/* lib/path/place.h -- place: a point of the path that knots are made of, and the cubic through some
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PATH_PLACE_H
#define LOFT_PATH_PLACE_H

#include "path/period.h"  /* loft_period, loft_position */

LOFT_BEGIN_C

/* A place of the path. */
typedef struct {
    loft_coord feed;        /* the speed that is asked for from the last place to this one */
    uint16_t   number;      /* of its curve */
    bool       sharp;       /* it is a corner */
    bool       loose;       /* up to the next one it is near corners */
    loft_position at;
    uint16_t   skip;        /* how far the path is from the cubic through four places
                             * (loft_path_between), from this one to the next, grains */
    uint16_t   room;        /* how far a control point may be moved, grains: tube.h */
#if LOFT_FOLDS
    loft_fold  fold;        /* what is left out before it */
#endif
} loft_path_place;

static inline loft_coord loft_path_skip(const loft_path_place *p)
{
    return p->skip * LOFT_COORD_GRAIN;
}

static inline void loft_path_set_skip(loft_path_place *p, loft_coord skip)
{
    p->skip = loft_coord_grains(skip + LOFT_COORD_GRAIN - 1);
}

/* How far the motion may be from the path, from this place to the next. */
static inline loft_coord loft_path_tol(const loft_period *p, const loft_path_place *from)
{
    return p->tol + (from->loose ? p->more : 0);
}

/* The cubic from b to c, of the places a, b, c, d: at part z, 2^-24, of the way. It ends along its
 * chord at a sharp place. */
void loft_path_between(const loft_path_place *const at[4], int32_t z, loft_position *out);

/* How far p is from it, near that part.
 *
 *   error   never too small
 */
loft_coord loft_path_off(const loft_path_place *const at[4], int32_t z, const loft_position *p);

/* The same of a cubic that is asked several times. Do not rely on the fields. */
typedef struct {
    const loft_position *from;
    loft_coord before[LOFT_AXES], chord[LOFT_AXES], after[LOFT_AXES];
} loft_path_cubic;

/* The cubic of four places, which are kept. */
loft_path_cubic loft_path_cubic_of(const loft_path_place *const at[4]);

/* As loft_path_off. */
loft_coord loft_path_cubic_off(const loft_path_cubic *cubic, int32_t z, const loft_position *p);

/* Does the path from a by b to c turn back at b? */
bool loft_path_turns_back(const loft_path_place *a, const loft_path_place *b,
                          const loft_path_place *c);

/* How far p is from the cubics around the middle one of five places. Where the path turns back
 * there, its tip is as far from p as any of it. */
loft_coord loft_path_miss(const loft_path_place *const at[5], const loft_position *p);

/* The same of five places none of which is sharp. */
loft_coord loft_path_miss_of(const loft_position at[5], const loft_position *p);

/* Is the smooth path (tube.h) farther than that from the middle one, before it is smoothed? */
bool loft_path_missed(const loft_path_place *const at[5], loft_coord most);

/* How far it is from the cubic in the middle of six places, half the way between the third and the
 * fourth. */
loft_coord loft_path_missed_between(const loft_path_place *const at[6]);

LOFT_END_C

#endif
