/* host-tools/mill/patch.h -- a surface as a patch that a machine cuts by itself
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_PATCH_H
#define LOFT_PATCH_H

#include "engine/patch_lines.h"       /* lines_patch */
#include "engine/surface.h"     /* surface */
#include "plan/toolpath.h"      /* toolpath */
#include "read/drawing.h"       /* drawing */

struct host;                /* base/host.h */

/* How it is cut. Lengths in mm, feeds in mm/s. */
typedef struct {
    double radius;              /* of the ball */
    double step;                /* between lines, along the surface, at most */
    double tol, above;          /* of a curve; of ways, above the surface */
    double feed, travel;
    unsigned axis;              /* along which lines run: 0, u; 1, v */
    bool one_way;
    unsigned columns;           /* of a line, at most: the machine's */
    engine_lines *lines;        /* in its number type */
} patch_order;

/* The patch of a surface, with the fewest columns that keep the tolerance; it begins where the
 * motors are. Returns 0, or an exit code after printing one line: what prevents it, and the
 * remedy. */
int patch_make(struct host *h, lines_patch *p, const surface *s, const patch_order *o,
               const double start[ENGINE_AXES], const char *file);

/* Its items. Returns their number. */
unsigned patch_items(const lines_patch *p, loft_item item[LOFT_PATCH_PARTS]);

/* The moves that the machine makes of it: a path, and a drawing of those that cut. Free with
 * toolpath_free and drawing_free. */
void patch_path(const lines_patch *p, const patch_order *o, unsigned line, toolpath *path,
                drawing *d);

#endif
