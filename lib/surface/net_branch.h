/* lib/surface/net_branch.h -- the curve in which two surfaces meet, followed from a place of it
 * SPDX-License-Identifier: MIT
 *
 * The steps of net_meet.h:
 *
 *     if (loft_net_settle(&both, held, &place) && loft_net_branch_init(&branch, &place))
 *         while ((went = loft_net_branch_next(&branch, &both)) == LOFT_NET_ON)
 *             use(branch.at.p);
 */
#ifndef LOFT_SURFACE_NET_BRANCH_H
#define LOFT_SURFACE_NET_BRANCH_H

#include "surface/net.h"    /* loft_net_form */

LOFT_BEGIN_C

/* Two surfaces seen from an origin, and the tolerance of chords. */
typedef struct {
    loft_net_form form[2];
    loft_vec origin;
    loft_acc tol;
    loft_sci wide;              /* tol */
    bool curve;                 /* the first is a curve: its second parameter means nothing */
} loft_net_both;

/* Parameters, the point on the first surface, and the derivatives of a - b there. */
typedef struct {
    loft_sci x[4], p[3], column[4][3];
} loft_net_place;

/* Set s->p and s->column by s->x, and b - a.
 *
 *   range   three axes, as all that follows
 *   error   as loft_net_form_jet
 *   cost    twice loft_net_form_jet of order 1
 */
void loft_net_look(const loft_net_both *z, loft_net_place *s, loft_sci apart[3]);

/* From s->x to a place where the surfaces meet, by Newton's method with the parameter `held` fixed.
 * False if there is none near.
 *
 *   range   parameters in -2..2
 *   error   parameters: 2^-40
 *   cost    some 3 to 24 times loft_net_look
 */
bool loft_net_settle(const loft_net_both *z, unsigned held, loft_net_place *s);

/* True if the parameters are in 0..1.
 *
 *   error   2^-30 beyond counts as within
 *   cost    8 comparisons
 */
bool loft_net_within(const loft_net_both *z, const loft_net_place *s);

/* The point as coordinates; false if they do not fit.
 *
 *   error   1/2 LSB (ulp)
 *   cost    3 conversions
 */
bool loft_net_place_vec(const loft_net_both *z, const loft_sci p[3], loft_vec *out);

/* True if p is within tol of the chord from a to b.
 *
 *   error   as loft_chord_foot
 *   cost    mostly a comparison per axis
 */
bool loft_net_chord_near(const loft_vec *a, const loft_vec *b, const loft_vec *p, loft_acc tol);

typedef struct {
    loft_net_place at, start;
    loft_sci ahead[3], by;      /* the last chord; the step */
    unsigned steps;
} loft_net_branch;

/* Begin at a place, in one of both directions. False where the surfaces are tangent.
 *
 *   error   none
 *   cost    4 determinants
 */
bool loft_net_branch_init(loft_net_branch *b, const loft_net_place *through);

/* Begin anew at b->at, back where it came from.
 *
 *   error   none
 *   cost    none
 */
void loft_net_branch_turn(loft_net_branch *b);

enum loft_net_went {
    LOFT_NET_ON,                /* to the next place */
    LOFT_NET_BORDER,            /* to the last place, on a border */
    LOFT_NET_BACK,              /* to the start: the branch is closed */
    LOFT_NET_LOST               /* nowhere: within tol the surfaces are tangent, or fold */
};

/* Go on to b->at.
 *
 *   error   places as loft_net_settle; the middle of the branch is within tol / 2 of the middle of
 *           the chord, and the chord within 0.35 of the directions at both ends
 *   cost    some 2 to 6 times loft_net_settle
 *   see     Barnhill and Kersey, A marching method for parametric surface/surface intersection,
 *           CAGD 7 (1990)
 */
enum loft_net_went loft_net_branch_next(loft_net_branch *b, const loft_net_both *z);

LOFT_END_C

#endif
