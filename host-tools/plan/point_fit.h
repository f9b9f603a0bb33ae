/* host-tools/plan/point_fit.h -- curves near measured points, with their corners
 * SPDX-License-Identifier: MIT
 *
 * A row of points is cut at its corners, and each part becomes a B-spline within a tolerance
 * (spline_fit.h). A corner is a point at which the row turns by more than an angle, seen from the
 * points that are some tolerances away, and more than anywhere near it; noise within the tolerance
 * makes none.
 */
#ifndef LOFT_POINT_FIT_H
#define LOFT_POINT_FIT_H

#include "plan/spline_fit.h"

typedef struct {
    double (*p)[ENGINE_AXES];   /* none equals the one before it */
    size_t count;
    bool closed;                /* back to the first point, which stands there once */
} point_row;

typedef struct {
    double tol;                 /* mm */
    double corner;              /* radians; above pi: none */
    unsigned degree;            /* 1..9 */
} point_fit_options;

/* A part: the spline, or, of two points, the line between them. Of few points the degree is lower.
 * `f` is valid during the call. Returns an exit code. */
typedef int point_fit_sink(void *context, const spline_fit *f);

/* Fit all parts in order; f has its engine. EX_DATAERR: the numbers do not fit its type.
 *
 *   error   no point is farther than `tol` from the curve of its part
 *   cost    about 10 sums over all points for each part; corners: the points near each one */
int point_fit(const point_row *row, const point_fit_options *o, spline_fit *f, point_fit_sink *sink,
              void *context);

#endif
