/* host-tools/fit/point_fit.h -- curves near measured points, with their corners
 * SPDX-License-Identifier: MIT
 *
 * A row of points is cut at its corners, and each part becomes a B-spline within a tolerance
 * (spline_fit.h). A corner is a point at which the row turns by more than an angle, seen from the
 * points that are some tolerances away, and more than anywhere near it; noise within the tolerance
 * makes none.
 */
#ifndef LOFT_POINT_FIT_H
#define LOFT_POINT_FIT_H

#include "fit/spline_fit.h"

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

#define POINT_FIT_NOISY (-1)    /* result: the points are noisier than the tolerance */

/* Fit all parts in order; f has its engine. EX_DATAERR: the numbers do not fit its type.
 * POINT_FIT_NOISY: it takes more than 2 control points for 3 points to come within `tol`, and more
 * than degree + 1 between two corners, or more than 12 in all. Such curves follow the noise. The
 * sink sees nothing then.
 *
 *   error   no point is farther than `tol` from the curve of its part; between points the curve is
 *           bounded as spline_fit.h says
 *   cost    about 20 sums over all points for each part; corners: the points near each one */
int point_fit(const point_row *row, const point_fit_options *o, spline_fit *f, point_fit_sink *sink,
              void *context);

/* The first of 1, 2, .. 9, 10, 20, .. above o->tol with which point_fit succeeds; 0 if none up to
 * `most` does. */
double point_fit_enough(const point_row *row, const point_fit_options *o, double most,
                        spline_fit *f);

#endif
