/* host-tools/fit/spline_fit.h -- a B-spline near a row of points, within a tolerance
 * SPDX-License-Identifier: MIT
 *
 *     spline_fit f = { .e = &engine_f64, .degree = 3 };
 *     spline_fit_begin(&f);
 *     for (..) spline_fit_add(&f, point);
 *     if (spline_fit_within(&f, 0.01, &where))
 *         for (size_t k = 0; k < f.intervals; k++)
 *             spline_fit_eval(&f, k, u, at, slope);
 *     spline_fit_free(&f);
 *
 * The parameter is the length along the points. The least squares are those of the library
 * (curve/fit.h); the knots are placed here: intervals with too large an error are halved until the
 * fit is good, or until one has too few points. Then there is a corner near `where`.
 */
#ifndef LOFT_SPLINE_FIT_H
#define LOFT_SPLINE_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "engine/engine.h"      /* engine, ENGINE_AXES */

typedef struct {
    const engine *e;
    unsigned degree;            /* 1..9                                                     */
    bool closed;                /* the last point is the first one again; the seam is smooth */
    bool between;               /* the chords between points count too, not the points alone */
    bool by_length;             /* each point weighs as the length around it                 */
    double (*p)[ENGINE_AXES], *u;
    size_t count, room;
    double *knot;               /* ends and inner knots, ascending: `intervals` + 1 */
    size_t *first;              /* of each interval: its first point                */
    size_t intervals;
    double (*c)[ENGINE_AXES];   /* intervals + degree control points                */
    double *weight, *whole;     /* room: of each point; all knots                   */
} spline_fit;

void spline_fit_begin(spline_fit *f);
void spline_fit_add(spline_fit *f, const double p[ENGINE_AXES]);
void spline_fit_free(spline_fit *f);

/* Find the knots and the curve. False: it cannot be done near point *where, counted from 0. The
 * points must differ from their neighbours.
 *
 *   error   no point is farther than `within` from the curve at the same length; with `between`,
 *           checked at four places of each chord too. Between two points L apart the curve is at
 *           most 2 L + 8 `within` long, so it stays within 0.87 L of their chord where `within` is
 *           small, and within 5 `within` where L is. Each interval has two points or more
 *   cost    about 10 sums over all points */
bool spline_fit_within(spline_fit *f, double within, size_t *where);

/* The largest such distance. */
double spline_fit_error(const spline_fit *f);

/* Knot i, also outside 0 .. intervals. The point and the slope at u on interval k. */
double spline_fit_knot(const spline_fit *f, long i);
void spline_fit_eval(const spline_fit *f, size_t k, double u, double out[ENGINE_AXES],
                     double slope[ENGINE_AXES]);

#endif
