/* host-tools/engine.c -- one number type behind the double interface of engine.h
 * SPDX-License-Identifier: MIT
 *
 * Compiled three times. Numbers are made and read through LOFT_REAL(1), the raw value of 1, so the file does
 * not know which type it is.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "curve/bezier.h"   /* loft_bezier */
#include "curve/forward.h"  /* loft_forward */
#include "curve/measure.h"  /* loft_flatten */
#include "motion/plan.h"    /* loft_plan */
#include "motion/step.h"    /* loft_steps_of */

#include "engine.h"
#include "tool.h"           /* tool_grow */

#define ONE ((double)LOFT_REAL(1.0))

typedef char axes_agree[LOFT_AXES == ENGINE_AXES ? 1 : -1];

static bool real_of(double x, loft_real *out)
{
    if (!(fabs(x) * ONE <= (double)LOFT_REAL_MAX))
        return false;
    *out = LOFT_REAL(x);
    return true;
}

static bool vec_of(const double point[ENGINE_AXES], loft_vec *out)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        if (!real_of(point[i], &out->axis[i]))
            return false;
    return true;
}

static bool vecs_of(const double p[][ENGINE_AXES], unsigned count, loft_vec out[])
{
    for (unsigned i = 0; i < count; i++)
        if (!vec_of(p[i], &out[i]))
            return false;
    return true;
}

static void point_of(loft_vec v, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = (double)v.axis[i] / ONE;
}

static int bezier_of(const double p[][ENGINE_AXES], unsigned degree, loft_vec points[], loft_bezier *out)
{
    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (!vecs_of(p, degree + 1, points))
        return LOFT_ERR_RANGE;
    return loft_bezier_init(out, points, degree);
}

static int eval(const double p[][ENGINE_AXES], unsigned degree, double t, double out[ENGINE_AXES])
{
    loft_vec points[LOFT_DEGREE_MAX + 1], at;
    loft_bezier b;
    int status = bezier_of(p, degree, points, &b);

    if (status != LOFT_OK)
        return status;
    if (t >= 0 && t <= 1)
        at = loft_bezier_eval(&b, LOFT_UNIT(t));
    else if (!(fabs(t) < 127))
        return LOFT_ERR_RANGE;
    else if ((status = loft_bezier_extend(&b, LOFT_UNIT(t), &at)) != LOFT_OK)
        return status;
    point_of(at, out);
    return LOFT_OK;
}

static int walk(const double p[][ENGINE_AXES], unsigned degree, uint32_t n, engine_point_sink *sink, void *context)
{
    loft_vec points[LOFT_DEGREE_MAX + 1], at;
    double point[ENGINE_AXES];
    loft_bezier b;
    loft_forward w;
    int status = bezier_of(p, degree, points, &b);

    if (status == LOFT_OK)
        status = loft_forward_init(&w, &b, n);
    if (status != LOFT_OK)
        return status;
    while (loft_forward_next(&w, &at)) {
        point_of(at, point);
        sink(context, point);
    }
    return LOFT_OK;
}

static int flatten(const double p[4][ENGINE_AXES], double tol, engine_point_sink *sink, void *context)
{
    double point[ENGINE_AXES];
    loft_real within;
    loft_flatten f;
    loft_cubic c;
    loft_vec at;

    if (!vecs_of(p, 4, c.p) || !real_of(tol, &within))
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

static bool limits_of(const engine_limits *from, loft_limits *out)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        if (!real_of(from->max_speed[i], &out->max_speed[i]) || !real_of(from->max_accel[i], &out->max_accel[i]))
            return false;
    out->tick_hz = (uint16_t)from->tick_hz;
    return from->tick_hz <= UINT16_MAX && real_of(from->corner, &out->corner) && real_of(from->tol, &out->tol);
}

/* A span as the wire carries it: raw Q16.16, whatever the type it was planned in. */
static engine_span raw_of(const loft_span *s)
{
    engine_span raw;

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            raw.p[k][i] = (int32_t)lround((double)s->p[k].axis[i] / ONE * 65536.0);
    raw.ticks = s->ticks;
    return raw;
}

static int plan(const engine_limits *limits, const engine_move moves[], size_t count, engine_span_sink *sink, void *context)
{
    loft_limits within;
    if (count > UINT32_MAX / 16 || !limits_of(limits, &within))
        return LOFT_ERR_RANGE;

    const uint32_t node_count = LOFT_PLAN_NODES((uint32_t)count);
    loft_move *chain      = tool_grow(NULL, count * sizeof *chain);
    loft_plan_node *nodes = tool_grow(NULL, node_count * sizeof *nodes);
    int status            = LOFT_OK;
    loft_plan p;
    loft_span span;

    for (size_t i = 0; i < count && status == LOFT_OK; i++)
        if (!vecs_of(moves[i].p, 4, chain[i].curve.p) || !real_of(moves[i].feed, &chain[i].feed))
            status = LOFT_ERR_RANGE;
    if (status == LOFT_OK)
        status = loft_plan_init(&p, &within, chain, (uint32_t)count, nodes, node_count);
    while (status == LOFT_OK && loft_plan_next(&p, &span)) {
        const engine_span raw = raw_of(&span);
        sink(context, &raw);
    }
    free(nodes);
    free(chain);
    return status;
}

static int32_t steps(double mm, double steps_per_mm)
{
    return loft_steps_of(LOFT_REAL(mm), LOFT_REAL(steps_per_mm));
}

#define ENGINE_OF_(tag)   engine_ ## tag
#define ENGINE_OF(tag)    ENGINE_OF_(tag)
#define ENGINE_TEXT_(tag) #tag
#define ENGINE_TEXT(tag)  ENGINE_TEXT_(tag)

const engine ENGINE_OF(LOFT_TAG) = {
    .name    = ENGINE_TEXT(LOFT_TAG),
    .fixed   = LOFT_REAL_LSB > 0,
    .lsb     = LOFT_REAL_LSB > 0 ? 1 / (double)LOFT_REAL(1.0) : sizeof(loft_real) == sizeof(double) ? DBL_EPSILON : (double)FLT_EPSILON,
    .reach   = (double)LOFT_PLAN_REACH / (double)LOFT_REAL(1.0),
    .eval    = eval,
    .walk    = walk,
    .flatten = flatten,
    .plan    = plan,
    .steps   = steps
};
