/* host-tools/engine/engine.c -- one number type behind the double interface of engine.h
 * SPDX-License-Identifier: MIT
 *
 * Compiled three times.
 */
#include <float.h>

#include "curve/circle.h"   /* loft_circle */
#include "curve/measure.h"  /* loft_flatten */
#include "motion/plan.h"    /* LOFT_PLAN_REACH */
#include "machine/step.h"   /* loft_steps_of */

#include "engine/engine_fit.h"      /* engine_fit_spline */
#include "engine/engine_solid.h"
#include "engine/engine_num.h"     /* real_of, vec_of, point_of */

static int hold_number(double x, double *out)
{
    loft_real held;

    if (!real_of(x, &held))
        return LOFT_ERR_RANGE;
    *out = double_of(held);
    return LOFT_OK;
}

static int give_circle(const loft_circle *of, loft_real tol, engine_cubic_sink *sink, void *context)
{
    loft_circle_spans s;
    loft_cubic c;
    const int status = loft_circle_spans_init(&s, of, LOFT_CIRCLE_CUBIC, tol);

    while (status == LOFT_OK && loft_circle_spans_next(&s, &c)) {
        double out[4][ENGINE_AXES];
        for (int k = 0; k < 4; k++)
            point_of(c.p[k], out[k]);
        sink(context, out);
    }
    return status;
}

static int ellipse(const double from[2], const double to[2], const double radii[2], double degrees,
                   bool large, int turns, double tol, engine_cubic_sink *sink, void *context)
{
    const double ends[2][ENGINE_AXES] = { { from[0], from[1] }, { to[0], to[1] } };
    loft_circle arc;
    loft_vec p[2];
    loft_real r[2], angle, within;

    if (!vecs_of(ends, 2, p) || !real_of(radii[0], &r[0]) || !real_of(radii[1], &r[1]) ||
        !real_of(degrees, &angle) || !tol_of(tol, &within))
        return LOFT_ERR_RANGE;
    const int status = loft_circle_from_ellipse(&arc, p[0], p[1], LOFT_PLANE_XY, r, angle, large,
                                                turns);
    return status == LOFT_OK ? give_circle(&arc, within, sink, context) : status;
}

static int flatten(const double p[4][ENGINE_AXES], double tol, engine_point_sink *sink,
                   void *context)
{
    double point[ENGINE_AXES];
    loft_real within;
    loft_flatten f;
    loft_cubic c;
    loft_vec at;

    if (!vecs_of(p, 4, c.p) || !tol_of(tol, &within))
        return LOFT_ERR_RANGE;
    const int status = loft_flatten_init(&f, &c, within);
    if (status != LOFT_OK)
        return status;
    while (loft_flatten_next(&f, &at)) {
        point_of(at, point);
        sink(context, point);
    }
    return LOFT_OK;
}

static int32_t steps(double mm, double steps_per_mm)
{
    return loft_steps_of(LOFT_REAL(mm), LOFT_REAL(steps_per_mm));
}

#define ENGINE_TEXT_(tag) #tag
#define ENGINE_TEXT(tag)  ENGINE_TEXT_(tag)

const engine ENGINE_OF(engine) = { .name = ENGINE_TEXT(LOFT_TAG),
                                   .fixed = LOFT_REAL_LSB > 0,
                                   .lsb = LOFT_REAL_LSB > 0 ? 1 / (double)LOFT_REAL(1.0)
                                          : sizeof(loft_real) == sizeof(double)
                                              ? DBL_EPSILON
                                              : (double)FLT_EPSILON,
                                   .reach = (double)LOFT_PLAN_REACH / (double)LOFT_REAL(1.0),
                                   .hold = hold_number,
                                   .curve = &ENGINE_OF(engine_curves),
                                   .piece = &ENGINE_OF(engine_pieces),
                                   .measure = &ENGINE_OF(engine_measures),
                                   .fit = ENGINE_OF(engine_fit_spline),
                                   .fit_grid = ENGINE_OF(engine_fit_surface),
                                   .fit_basis = ENGINE_OF(engine_fit_basis),
                                   .fit_places = ENGINE_OF(engine_fit_places),
                                   .solid   = ENGINE_OF(engine_solid_eval),
                                   .ellipse = ellipse,
                                   .surface = &ENGINE_OF(engine_surfaces),
                                   .flatten = flatten,
                                   .plan = &ENGINE_OF(engine_plans),
                                   .steps = steps };
