/* lib/polygon/jet_ball.h -- the range of a function and of its derivatives over a piece of the
 * plane
 * SPDX-License-Identifier: MIT
 *
 * Every component lies within `off` of that of `mid`. Sums, products and quotients of balls contain
 * those of all functions in them (interval arithmetic). So a formula in the coordinates of a point
 * also bounds its second derivatives over a piece: toolpath/sector.h. The smaller the piece, the
 * nearer are the bounds.
 */
#ifndef LOFT_POLYGON_JET_BALL_H
#define LOFT_POLYGON_JET_BALL_H

#include "polygon/jet.h"    /* loft_jet */

LOFT_BEGIN_C

typedef struct {
    loft_jet mid, off;          /* no component of off is negative */
} loft_jet_ball;

/* A constant.
 *
 *   error   none
 *   cost    192 bytes written in q16, 96 in floats
 */
loft_jet_ball loft_jet_ball_of(loft_sci c);

/* a + b, a - b, c a, a b.
 *
 *   error   those of loft_jet, which the ball does not contain: see polygon/jet_ball_sum.h
 *   cost    twice that of loft_jet; product three times
 */
loft_jet_ball loft_jet_ball_add(const loft_jet_ball *a, const loft_jet_ball *b);
loft_jet_ball loft_jet_ball_sub(const loft_jet_ball *a, const loft_jet_ball *b);
loft_jet_ball loft_jet_ball_scale(const loft_jet_ball *a, loft_sci c);
loft_jet_ball loft_jet_ball_mul(const loft_jet_ball *a, const loft_jet_ball *b);

/* a^k; 1 for k = 0.
 *
 *   error   as mul
 *   cost    at most 2 log2 k + 1 of mul
 */
loft_jet_ball loft_jet_ball_pow(const loft_jet_ball *a, unsigned k);

/* a / b. Returns false, and leaves *out untouched, when b may be 0 or negative.
 *
 *   error   as mul
 *   cost    two quotients, two products and two sums of loft_jet
 */
bool loft_jet_ball_div(const loft_jet_ball *a, const loft_jet_ball *b,
                       loft_jet_ball *out) LOFT_CHECKED;

/* The root of a. Returns false, and leaves *out untouched, when a may be 0 or negative.
 *
 *   error   as mul
 *   cost    two roots, a quotient and a product of loft_jet
 */
bool loft_jet_ball_sqrt(const loft_jet_ball *a, loft_jet_ball *out) LOFT_CHECKED;

/* The largest absolute value of each component.
 *
 *   error   none
 *   cost    6 sums
 */
loft_jet loft_jet_ball_most(const loft_jet_ball *a);

LOFT_END_C

#endif
