/* host-tools/arrange/pieces.h -- a stroke that is wider than its bends, put together of pieces
 * SPDX-License-Identifier: MIT
 *
 * GEOS leads a line along each side. Where a bend is tighter than half the width, the inner one
 * crosses itself, and false holes are left. A stroke with such a bend, or with a corner beyond the
 * limit of mitres, which GEOS cuts longer than SVG does, is put together: of a rectangle for each
 * chord, a wedge for each join, and what the caps add.
 */
#ifndef LOFT_PIECES_H
#define LOFT_PIECES_H

#include <geos_c.h>
#include <stdbool.h>
#include <stddef.h>

#include "arrange/region.h"        /* region_stroke */

#define PIECES_GRID 1e-6        /* mm: where outlines meet is rounded to it */

typedef struct pieces pieces;

/* Has this chain of points, closed if it ends where it begins, such a bend or corner? */
bool pieces_needed(const double (*p)[2], size_t n, const region_stroke *s);

/* Begin a stroke; a quarter turn has `quarter` chords. `*s` outlives it. */
pieces *pieces_open(GEOSContextHandle_t h, const region_stroke *s, int quarter);

/* Add the pieces of a chain of two or more points, each apart from the next. */
void pieces_add(pieces *to, const double (*p)[2], size_t n);

/* What the pieces cover together; NULL if that fails. Frees the pieces. */
GEOSGeometry *pieces_join(pieces *all);

#endif
