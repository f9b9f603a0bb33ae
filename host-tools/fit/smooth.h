/* host-tools/fit/smooth.h -- replaces chains of short lines, as dense G-code and many programs
 * write curves, by curves
 * SPDX-License-Identifier: MIT
 *
 * A machine that follows each chord must slow down at each vertex. If lines turn so little that a
 * smooth curve passes within `within` of all of them, that curve replaces them: a cubic spline with
 * continuous curvature. Corners stay corners.
 */
#ifndef LOFT_SMOOTH_H
#define LOFT_SMOOTH_H

#include "read/drawing.h"    /* drawing */

/* Convert `from` to *to, which must be zeroed; curves that are not lines are copied. Returns how
 * many lines were replaced.
 *
 *   error   no point of the spline is farther than `within` (mm) from the chain at the same length
 *           along it, checked at all vertices and at four places between them; none, `within` 0:
 *           all is copied
 *   cost    about 10 sums over all vertices */
size_t drawing_smooth(drawing *to, drawing *from, double within);

/* The same for a drawing that is still being read: curves that may belong to a chain that goes on
 * wait for the next call, except for the `last` one.
 *
 * With a laser, a straight row of lines in which only S changes, as rasters have, is one line. Its
 * events say how far `along` they are. No vertex of it is farther than `within` from that line. */
typedef struct {
    double within;
    bool laser;             /* set before the first call */
    int way;                /* of the last event that switched it: 3, 4 (M3, M4) or 0 */
    size_t given;           /* curves of `from` that are done */
    size_t events;          /* of `from` that are copied */
    size_t replaced;        /* lines */
    struct fit *fit;        /* NULL: not begun */
} smoothing;

void smooth_more(smoothing *s, drawing *to, drawing *from, bool last);
void smooth_end(smoothing *s);

#endif
