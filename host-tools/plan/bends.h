/* host-tools/plan/bends.h -- the corners of a chain of curves
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_BENDS_H
#define LOFT_BENDS_H

#include "engine/engine.h"  /* engine_move */

/* A place where the direction changes by more than 5 degrees. */
typedef struct {
    double at[ENGINE_AXES];
    size_t move;                /* the curve that begins there, or has a cusp there */
    double t;                   /* its parameter */
} bend;

typedef struct {
    bend *bend;
    size_t count, room;
    double last[ENGINE_AXES];   /* the direction so far, */
    bool moves;                 /* if there is one */
} bends;

/* Find them, in the order of the chain.
 *
 *   shape   bends that are as tight as 2^-16 mm are corners
 *   error   of 5 degrees: a 20th of a degree less
 */
void bends_find(bends *out, const engine_move move[], size_t count);
void bends_free(bends *b);

/* Find those where curve `move` begins, and in it; begin with { .count = 0 }. */
void bends_more(bends *b, size_t move, const double p[4][ENGINE_AXES]);

#endif
