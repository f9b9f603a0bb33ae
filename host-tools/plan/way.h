/* host-tools/plan/way.h -- a chain of moves as short chords, and how far along it a motion is
 * SPDX-License-Identifier: MIT
 *
 * Chords are made when the motion comes near them and forgotten when it has passed them.
 */
#ifndef LOFT_WAY_H
#define LOFT_WAY_H

#include "engine/engine.h"         /* engine_move, ENGINE_AXES */

/* Chord k ends here; the first one is the start and has length 0. */
typedef struct {
    double at[ENGINE_AXES], s;
    size_t move;
} way_end;

/* Called for each move when the motion comes near it, in order; `length` in mm. */
typedef void way_load(void *context, size_t n, const engine_move *move, double length);

typedef struct {
    const engine_move *move;
    size_t moves, loaded;
    way_load *load;
    void *context;
    way_end *end;               /* of the chords around the motion  */
    size_t count, room;
    double tol;                 /* largest distance of the motion */
    double x[ENGINE_AXES], s;   /* its last place */
    size_t near;                /* the chord there */
} way;

void way_make(way *w, const engine_move move[], size_t moves, double tol, way_load *load,
              void *context);
void way_free(way *w);

/* The motion is over: load the moves that it did not come near. */
void way_finish(way *w);

/* The move of a motion that continues to x. The place only goes forward, by about as much as x
 * does. So a path that crosses or repeats itself is followed in its order. */
size_t way_follow(way *w, const double x[ENGINE_AXES]);

#endif
