/* host-tools/fit/grid_fit.h -- the B-spline surface near a grid of measured points, with as few
 * knots as a tolerance takes
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_GRID_FIT_H
#define LOFT_HOST_GRID_FIT_H

#include "engine/engine.h"      /* engine, ENGINE_AXES */

typedef struct {
    double (*p)[ENGINE_AXES];   /* rows x columns, row by row */
    unsigned count[2];
    double *at[2], *knot[2], (*net)[ENGINE_AXES];       /* 0..1 along u and v; the result */
    unsigned points[2], degree[2];
    double off;                 /* the largest distance of a point from its place */
    double enough;              /* the smallest `off` of a net with a bounded shape, */
    unsigned best[2];           /* and its control points                            */
} grid_fit;

/* Fit it: more spans along both, until `off` is within tol and the shape between the points is
 * bounded (grid_fit.c), or until there are 2 control points for 3 points along both. Then `enough`
 * is above tol, and with it as tol the fit succeeds; INFINITY: with none. At most `degree`, less
 * where there are few points. Returns enum loft_status: LOFT_SINGULAR if rows coincide. */
int  grid_fit_make(grid_fit *g, const engine *e, unsigned degree, double tol);
void grid_fit_free(grid_fit *g);

#endif
