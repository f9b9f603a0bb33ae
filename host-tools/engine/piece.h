/* host-tools/engine/piece.h -- one Bezier piece of a curve, polynomial or rational, in double
 * SPDX-License-Identifier: MIT
 *
 * The library gives the pieces (engine.h). This file computes their derivatives, for combs.
 */
#ifndef LOFT_PIECE_H
#define LOFT_PIECE_H

#include "engine/curve.h"          /* CURVE_AXES, CURVE_DRAWN_MAX */

typedef struct piece {
    double p[CURVE_DRAWN_MAX + 1][CURVE_AXES];
    double w[CURVE_DRAWN_MAX + 1];              /* weights, 1 for a polynomial */
    unsigned degree;
} piece;

/* True if the weights differ. */
bool piece_is_rational(const piece *c);

/* The point at t in 0..1, and its first and second derivatives. */
void piece_eval(const piece *c, double t, double out[3][CURVE_AXES]);

/* The parts before and behind t. */
void piece_split(const piece *c, double t, piece *left, piece *right);

/* The curvature at t in the plane of x and y, > 0 for a left turn. Returns false where the first
 * derivative vanishes. */
bool piece_bend(const piece *c, double t, double *out);

#endif
