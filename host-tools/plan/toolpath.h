/* host-tools/plan/toolpath.h -- from a drawing to one connected chain of moves: pen down, pen up,
 * travel
 * SPDX-License-Identifier: MIT
 *
 * Paths are drawn in the order of the file at z = 0; between them the pen is lifted to z = lift.
 */
#ifndef LOFT_TOOLPATH_H
#define LOFT_TOOLPATH_H

#include "read/drawing.h"        /* drawing */
#include "engine/engine.h"         /* engine_move */

typedef struct {
    double feed, travel;            /* mm/s, pen down and pen up                            */
    double lift;                    /* mm                                                   */
    double start[ENGINE_AXES];      /* where the machine stands, mm                         */
    bool park;                      /* at the end go to `zero`                              */
    double zero[ENGINE_AXES];       /* where the machine's motors are at 0, mm              */
} toolpath_options;

#define TOOLPATH_TRAVEL ((size_t)-1)

typedef struct {
    engine_move *move;
    size_t *curve;                  /* of each move: which of the drawing, or TOOLPATH_TRAVEL */
    size_t count;
    size_t curves;                  /* moves with the pen down */
    double drawn, travelled;        /* mm                      */
} toolpath;

/* Make the chain; each move starts exactly where the one before ended, the first at the start. Free
 * with toolpath_free. A drawing without any curve gives an empty chain. */
void toolpath_make(toolpath *t, const drawing *d, const toolpath_options *o);
void toolpath_free(toolpath *t);

#endif
