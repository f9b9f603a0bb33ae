/* host-tools/plan/toolpath.h -- converts a drawing to one connected chain of moves: pen down, pen
 * up, travel
 * SPDX-License-Identifier: MIT
 *
 * Paths are drawn in the order of the file at their heights, 0 in a flat drawing. Between them the
 * pen is lifted by `lift` above the highest point. A program is drawn as it is, at its feeds.
 */
#ifndef LOFT_TOOLPATH_H
#define LOFT_TOOLPATH_H

#include "read/drawing.h"   /* drawing */
#include "engine/engine.h"  /* engine_move */

typedef struct {
    double feed, travel;            /* mm/s, pen down and pen up                            */
    double rapid;                   /* mm/s, travels of a program */
    double lift;                    /* mm                                                   */
    double start[ENGINE_AXES];      /* position of the machine, mm */
    double counted[ENGINE_AXES];    /* what loose axes have moved before this part of a program */
    bool laser;                     /* the spindle is a laser: off in travels */
    bool park;                      /* go to `zero` at the end */
    double zero[ENGINE_AXES];       /* position with the machine's motors at 0, mm; z NAN: it stays
                                     * lifted */
} toolpath_options;

/* What is done before a move; `move` == count: at the end; e.along not 0: in it, a line, after so
 * many mm. */
typedef struct {
    size_t move;
    drawing_event e;
    double feed;                    /* of a laser: mm/s at its power; 0: at any speed */
} toolpath_event;

#define TOOLPATH_TRAVEL ((size_t)-1)

typedef struct {
    engine_move *move;
    size_t *curve;                  /* of each move: the curve of the drawing, or TOOLPATH_TRAVEL */
    size_t count;
    size_t curves;                  /* moves with the pen down */
    double drawn, travelled;        /* mm                      */
    bool laser;                     /* as in the options */
    toolpath_event *event;          /* in their order */
    size_t events, event_room;
} toolpath;

/* Make the chain. Each move starts exactly where the one before ends, the first at the start. Free
 * with toolpath_free. A drawing without curves gives an empty chain. */
void toolpath_make(toolpath *t, const drawing *d, const toolpath_options *o);
void toolpath_free(toolpath *t);

#endif
