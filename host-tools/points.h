/* host-tools/points.h -- curves as text: control points, one per line, and numbers on their way out
 * SPDX-License-Identifier: MIT
 *
 * A line `x y [z]` is a control point; an empty line ends the curve; `#` starts a comment; commas, semicolons
 * and tabs are spaces. A line of eight numbers is a whole cubic in the plane, and a file that starts with `<`
 * is an SVG drawing, of which the cubics are taken.
 */
#ifndef LOFT_POINTS_H
#define LOFT_POINTS_H

#include <stdbool.h>
#include <stddef.h>

#include "engine.h"         /* ENGINE_AXES */

#define POINTS_MAX 10       /* control points per curve */

typedef struct {
    double p[POINTS_MAX][ENGINE_AXES];
    unsigned degree;
    unsigned line;          /* where it starts in the file                  */
    bool fresh;             /* does not start where the one before it ended */
} points_curve;

typedef struct {
    points_curve *curve;
    size_t count;
    bool solid;             /* some point has a z */
} points;

/* Read `file` ("-" is standard input) or, if `text` is not NULL, the points of one curve in it: "0,0 1,2 3,0".
 * Gives 0 or an exit code after printing one line. */
int  points_read(points *all, const char *file, const char *text);
void points_free(points *all);

/* Print a point with just the digits that tell it from its neighbours in the number type of `e`; without z if
 * not solid. `context` is a points_printing: it serves as engine_point_sink. */
typedef struct {
    const engine *e;
    bool solid;
} points_printing;

void points_print(void *context, const double point[ENGINE_AXES]);

/* Print the start of all->curve[i] and an empty line before it, unless it begins where the curve before ended. */
int points_print_start(points_printing *p, const points *all, size_t i);

#endif
