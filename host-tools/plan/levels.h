/* host-tools/plan/levels.h -- where the level of a laser changes while the machine moves
 * SPDX-License-Identifier: MIT
 *
 * A row of a raster is one line with many levels (smooth.h). It is planned as one motion. Its spans
 * are cut at whole ticks: the tick from which a level holds is an action (action_code.h), which
 * moves on as its span does.
 *
 * A tick in which the level changes has the mean of its levels, each by its part of the way. So an
 * edge is as wide as the way of a tick, is where it is asked, and what is finer keeps its energy.
 */
#ifndef LOFT_LEVELS_H
#define LOFT_LEVELS_H

#include "engine/engine.h"      /* engine_span */
#include "engine/machine_kinematics.h"  /* kinematics */
#include "plan/toolpath.h"      /* toolpath_event */

typedef struct {
    const kinematics *k;
    const engine_move *line;            /* of the tool */
    double s_max;                       /* S of full power */
    const toolpath_event *event;        /* in this line: the next one, and how many are left */
    size_t left;
    double is, given;                   /* the level of the place, and of the output: 0..1 */
    /* ---- */
    const engine_span *span;
    unsigned at, looked;                /* ticks of it that are cut, and where none is */
    double due;                         /* the level at the tick `looked`; NAN: none */
} levels;

/* A piece of a span: ticks from .. to - 1. With a level it is the tick in which that begins. */
typedef struct {
    unsigned from, to;
    double level;                       /* NAN: a span */
} levels_piece;

/* The level of an event: its S of s_max; without any S full. */
double levels_of(const drawing_event *e, double s_max);

/* True if the output must still follow. */
static inline bool levels_wait(const levels *l) { return l->is < l->given || l->is > l->given; }

/* Begin to cut a span of the line; it must not move. */
void levels_begin(levels *l, const engine_span *span);

/* The next piece, in order; false: there is no more.
 *
 *   error   of the sum of levels times way, up to the end of any tick: 2 LSB for each change
 *   cost    a change: the place of the tool at 12 ticks */
bool levels_next(levels *l, levels_piece *out);

/* Points 1 to 3 of a piece, raw as the span.
 *
 *   error   1/2 LSB each */
void levels_cut(const engine_span *span, const levels_piece *piece, int32_t p[3][ENGINE_AXES]);

#endif
