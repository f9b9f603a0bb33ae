/* host-tools/arrange/areas.h -- strokes as areas, and painted areas cut at their clip paths
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_AREAS_H
#define LOFT_AREAS_H

#include "read/drawing.h"

struct host;                /* base/host.h */

/* Replace strokes by the outline of what they cover, if `strokes`; and, if there are `fills`, each
 * painted shape that is clipped by what is left of it. Returns 0, or an exit code after printing
 * one line.
 *
 *   error   REGION_TOL (arrange/region.h) */
int areas_apply(struct host *h, bool strokes, bool fills, drawing *d, const char *file);

#endif
