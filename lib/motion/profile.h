/* lib/motion/profile.h -- profile: how fast a piece of the path may be passed, and how it is passed
 * SPDX-License-Identifier: MIT
 *
 * This is where the law of speed is decided, and nowhere else: even acceleration here. A plan asks only how
 * far a speed reaches over a piece, and for the phases in which a piece is passed.
 */
#ifndef LOFT_MOTION_PROFILE_H
#define LOFT_MOTION_PROFILE_H

#include "motion/arc.h"     /* loft_arc_shape */
#include "motion/limits.h"  /* loft_budget */

/* A piece of the path. Squares of speeds in (mm/s)^2. */
typedef struct {
    loft_acc  length;               /* mm                                      */
    loft_acc  most[2], top;         /* the square of the speed at its ends, and up and down between them */
    loft_acc  start;                /* the square of the speed where it begins */
    loft_vec  along[3], bend[3];    /* direction and curvature vector (1/mm) at start, middle and end */
    uint32_t  first, last;          /* the curve's parameters at its ends      */
} loft_piece;

/* A length passed with even acceleration. */
typedef struct {
    loft_acc  length;               /* mm                                       */
    loft_acc  from, to;             /* squares of the speeds at its ends        */
    loft_real accel;                /* mm/s^2, negative when slowing down       */
} loft_phase;

#define LOFT_PHASES_MAX 3

/* Set the bounds of a piece of this length and shape: feed, speed per axis, curvature.
 *
 *   range   feed LOFT_SPEED_MIN..LOFT_SPEED_MAX; the arc's length > 0
 */
void loft_piece_init(loft_piece *p, const loft_budget *b, const loft_arc *arc, loft_real feed);

/* The largest square of the speed at the piece's end when it is `from` at its start, or, `back`, at its start when
 * it is `from` at its end.
 *
 *   range   0 <= from <= p->most at that end
 */
loft_acc loft_piece_reach(const loft_piece *p, const loft_budget *b, loft_acc from, bool back);

/* The phases in which the piece is passed as fast as allowed, from p->start to the square `end`, which can be
 * reached; gives their number.
 *
 *   error   the lengths sum to that of the piece exactly
 */
unsigned loft_piece_phases(const loft_piece *p, const loft_budget *b, loft_acc end, loft_phase out[LOFT_PHASES_MAX]);

/* The speed after `done` of the length of a phase, mm/s.
 *
 *   error   q16: 1/2 LSB
 */
loft_real loft_phase_speed(const loft_phase *phase, loft_acc done);

#endif
