/* lib/motion/course.h -- course: the known part of a path, and the speed from which it can still be
 * braked
 * SPDX-License-Identifier: MIT
 *
 * Curves and the pieces they are cut into are kept in two rings of the caller's memory. Places are
 * counted by pieces from the oldest one that still matters.
 */
#ifndef LOFT_MOTION_COURSE_H
#define LOFT_MOTION_COURSE_H

#include "motion/profile.h" /* loft_plan_piece */

LOFT_BEGIN_C

/* Coordinates of the path must be within +-LOFT_PLAN_REACH mm. */
#define LOFT_PLAN_REACH LOFT_REAL(8191)

/* A curve to follow, with its speed along the path in mm/s. */
typedef struct {
    loft_cubic curve;
    loft_real  feed;
} loft_move;

/* Complete so that it can be static; do not rely on the fields. */
typedef struct {
    loft_acc         size, extent;                      /* of the curve that is cut, of the one
                                                         * before */
    loft_acc         zone;                                  /* how far any piece may reach */
    uint32_t         at;                                /* how far the next curve has been cut, its
                                                         * parameter */
    loft_real        feed;                                  /* of the last piece */
    loft_unit        gear;                              /* part of the acceleration that is used */
    loft_move       *moves;
    loft_plan_piece *pieces;
    uint16_t         move_room, piece_room;
    uint16_t         move_first, move_count, first, count;  /* what is in the rings */
    uint16_t         cut;                               /* curves that have become pieces, all of
                                                         * them */
    uint16_t         passed;                                /* curves dropped so far, modulo 2^16 */
    bool             known, smooth;                     /* is there a way; does the curve just go
                                                         * on */
    bool             crumb;                                 /* is the last piece one */
    bool             ended;                                 /* nothing more will come */
    loft_way         way;                                   /* where the last piece was heading */
    loft_vec         end;                                   /* where the last curve ends */
    loft_budget      budget;
#if LOFT_PLAN_FILTER > 1
    loft_acc         reach;                                 /* the largest zone of the pieces */
#endif
} loft_course;

/* A place: the distance from the start of a piece. */
typedef struct {
    unsigned piece;
    loft_acc off;
} loft_course_place;

/* Start an empty course within `budget`, in the caller's memory. */
void loft_course_init(loft_course *c, const loft_budget *budget, loft_move moves[],
                      uint16_t move_room, loft_plan_piece pieces[], uint16_t piece_room);

/* Append a curve.
 *
 *   range   it begins where the last one ended, otherwise LOFT_ERR_ARG; coordinates within
 *           +-LOFT_PLAN_REACH, feed LOFT_SPEED_MIN..LOFT_SPEED_MAX, otherwise LOFT_ERR_RANGE (0 or
 *           less: LOFT_ERR_ARG); LOFT_ERR_SPACE while the ring is full
 */
enum loft_status loft_course_push(loft_course *c, const loft_move *move) LOFT_CHECKED;

/* Curve number i from the oldest, i < move_count. */
loft_move *loft_course_move(const loft_course *c, unsigned i);

/* Is there a curve to be cut at `c->at`, and room for two pieces? Passes over curves that are cut,
 * and points. */
bool loft_course_cuts(loft_course *c);

/* One more piece, from where cutting has got to; there is room for it. */
loft_plan_piece *loft_course_add(loft_course *c);

/* Can nothing be appended before something is dropped? */
bool loft_course_full(const loft_course *c);

/* Drop the oldest piece, and curves before the next one. */
void loft_course_drop(loft_course *c);

/* Piece number i from the oldest, i < count. */
static inline loft_plan_piece *loft_course_piece(const loft_course *c, unsigned i)
{
    const unsigned k = c->first + i;
    return &c->pieces[k < c->piece_room ? k : k - c->piece_room];
}

/* Its length. */
static inline loft_acc loft_course_length(const loft_course *c, unsigned i)
{
    return loft_unit_to_acc(loft_course_piece(c, i)->length);
}

/* The number of the curve that a piece is of, from the start of the path, modulo 2^16. */
static inline uint16_t loft_course_number(const loft_course *c, const loft_plan_piece *p)
{
    const unsigned ahead = p->move >= c->move_first ? 0u : c->move_room;
    return (uint16_t)(c->passed + p->move + ahead - c->move_first);
}

/* How far beyond its ends a piece bounds speed and acceleration, mm. */
loft_acc loft_course_zone(const loft_course *c, const loft_plan_piece *p);

/* Does the path, as far as it is known, rest at the end of piece i? */
bool loft_course_rests(const loft_course *c, unsigned i);

/* The first piece after i whose start is a stop, or the number of pieces. */
unsigned loft_course_stop(const loft_course *c, unsigned i);

/* Set the speeds at the starts of the pieces after `i`, up to the next stop.
 *
 *   cost    pieces whose speed is sure already are not looked at again
 */
void loft_course_look_back(loft_course *c, unsigned i);

/* The square of the speed at a place from which all that is known ahead of it can be braked for. */
loft_acc loft_course_brake(const loft_course *c, loft_course_place at);

/* The square of the speed that place and neighbourhood allow; *accel: the acceleration at the
 * square x of the speed. */
loft_acc loft_course_around(const loft_course *c, loft_course_place at, loft_acc x, bool fore,
                            loft_real *accel);

LOFT_END_C

#endif
