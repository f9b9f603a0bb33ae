/* host-tools/fit/scatter_fit.h -- the B-spline surface near points in no order, with as few
 * knots as a tolerance takes
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_SCATTER_FIT_H
#define LOFT_HOST_SCATTER_FIT_H

#include "engine/engine.h"      /* engine, ENGINE_AXES */

#define SCATTER_POINTS   20000
#define SCATTER_CONTROLS 256

typedef struct {
    const double (*p)[ENGINE_AXES];
    size_t count;
    double (*at)[2];            /* 0..1: the place on the surface that is nearest to each point */
    double frame[3][3];         /* along the rectangle around the points, and normal to it */
    double *knot[2], (*net)[ENGINE_AXES];       /* the result */
    unsigned points[2], degree[2];
    unsigned loose;             /* control points that no point determines */
    double off;                 /* the largest distance of a point from its place */
    double enough;              /* the smallest tolerance that a net meets, */
    unsigned best[2];           /* and its control points                   */
    double blank, guessed[ENGINE_AXES];     /* no point is within `blank` of this place, where the
                                             * surface is a guess; 0: there is none */
} scatter_fit;

/* Fit it: parameters are places in the smallest rectangle around the points, in the plane nearest
 * to them; then, again and again, the nearest places on the surface. More spans along both, until
 * `off` is within tol, points that a net has not seen are within 2 tol of it in the mean, and it
 * does not leave their box (scatter_fit.c), or until a control point is left without points, or
 * with less than two. Then `enough` is above tol, and with it as tol the fit succeeds; INFINITY:
 * with none. Returns enum loft_status: LOFT_SINGULAR if the points lie on a line, or if points are
 * missing for the first patch: then `loose` is their number. It is above 0, too, where a finer net
 * has loose ones. */
int  scatter_fit_make(scatter_fit *f, const engine *e, unsigned degree, double tol);
void scatter_fit_free(scatter_fit *f);

#endif
