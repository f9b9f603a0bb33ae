/* host-tools/geometry/drawn.h -- curves in drawings and pictures: their pieces and cubics, in
 * double
 * SPDX-License-Identifier: MIT
 *
 * Pieces up to degree 9 are those of the library. Here `bezier` and `rational` may have degrees up
 * to CURVE_DRAWN_MAX, such as polygons of a curve that was raised: the host computes with them.
 */
#ifndef LOFT_HOST_DRAWN_H
#define LOFT_HOST_DRAWN_H

#include "engine/engine.h"      /* engine_cubic_sink */
#include "engine/piece.h"       /* piece */

typedef void drawn_sink(void *context, const piece *p, bool first);

/* All pieces of a curve, in order. enum loft_status */
int drawn_pieces(const curve *c, drawn_sink *take, void *context);

/* A chain of cubics within tol of the piece; neighbours share ends and directions. enum
 * loft_status */
int drawn_cubics(const piece *p, double tol, engine_cubic_sink *sink, void *context);

#endif
