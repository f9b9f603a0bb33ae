/* host-tools/send/near_move.h -- where a move is nearest to a place
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NEAR_MOVE_H
#define LOFT_NEAR_MOVE_H

#include "engine/engine.h"      /* engine_move */

/* The place of a move at its parameter t, 0..1. */
void near_point(const engine_move *m, double t, double out[ENGINE_AXES]);

/* How far the move is from a place, in mm; *t is the parameter there, in steps of 1/64. */
double near_move(const engine_move *m, const double at[ENGINE_AXES], double *t);

#endif
