/* host-tools/plan/way.h -- a chain of moves as short chords, and how far along it a motion is
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WAY_H
#define LOFT_WAY_H

#include "engine/engine.h"         /* engine_move, ENGINE_AXES */

/* Chord k ends here; chord 0 is the start and has length 0. */
typedef struct {
    double at[ENGINE_AXES], s;
    uint32_t move;
} way_end;

typedef struct {
    way_end *end;
    size_t count, room;
    double *length;             /* mm, of each move                  */
    double tol;                 /* largest distance of the motion */
    double x[ENGINE_AXES], s;   /* its last place */
    size_t near;                /* the chord there */
} way;

void   way_make(way *w, const engine_move move[], size_t moves, double tol);
void   way_free(way *w);
double way_length(const way *w);

/* The move of a motion that continues to x. The place only goes forward, by about as much as x
 * does. So a path that crosses or repeats itself is followed in its order. */
uint32_t way_follow(way *w, const double x[ENGINE_AXES]);

#endif
