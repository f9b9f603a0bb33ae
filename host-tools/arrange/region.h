/* host-tools/arrange/region.h -- areas: the inside of outlines, strokes as areas, areas made
 * smaller
 * SPDX-License-Identifier: MIT
 *
 * Curves are replaced by chords within REGION_TOL; GEOS does the rest. Without GEOS all of this
 * fails.
 */
#ifndef LOFT_REGION_H
#define LOFT_REGION_H

#include "read/drawing.h"

struct host;                /* base/host.h */

typedef struct region region;

#define REGION_TOL 0.002        /* mm */

/* A closed outline: its last point is not its first one again. A hole lies inside of another. */
typedef struct {
    double (*point)[2];
    size_t count;
    bool hole;
} region_ring;

typedef struct {
    region_ring *ring;
    size_t count;
} region_rings;

enum region_cap { REGION_BUTT, REGION_CAP_ROUND, REGION_SQUARE };
enum region_join { REGION_MITRE, REGION_JOIN_ROUND, REGION_BEVEL };

typedef struct {
    double width;               /* mm */
    enum region_cap cap;
    enum region_join join;
    double mitre;               /* the limit of SVG: length over width */
    double pen[3];              /* as in drawing_curve */
} region_stroke;

/* The exit code of what follows, after it has failed. */
int region_error(void);

/* What is inside of curves first .. last - 1 by their rule of filling; each of their paths is
 * closed by a line. NULL, after one line, if it fails. */
region *region_inside(struct host *h, const drawing *d, size_t first, size_t last, bool evenodd,
                      const char *file);

/* What a stroke covers, of which only the outlines may be taken. As above. */
region *region_of_stroke(struct host *h, const drawing *d, size_t first, size_t last,
                         const region_stroke *s, const char *file);

/* Replace it by what is inside of the shapes of an outline too, each by its own rule. Returns
 * false, after one line, if that fails; nothing may be left. */
bool region_cut(struct host *h, region *r, const drawing *outline, const char *file);

/* Replace it by all that is farther than `by` from its edge. Returns false, after one line, if that
 * fails; nothing may be left.
 *
 *   error   2 % of `by`, and REGION_TOL */
bool region_shrink(struct host *h, region *r, double by, const char *file);

/* Its outlines. Free with region_rings_free. */
void region_outlines(const region *r, region_rings *out);
void region_rings_free(region_rings *rings);

void region_free(region *r);

#endif
