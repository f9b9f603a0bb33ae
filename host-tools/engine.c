/* host-tools/engine.c -- one number type behind the double interface of engine.h
 * SPDX-License-Identifier: MIT
 *
 * Compiled three times.
 */
#include <float.h>
#include <stdlib.h>

#include "curve/measure.h"  /* loft_flatten */
#include "motion/plan.h"    /* loft_plan */
#include "motion/step.h"    /* loft_steps_of */

#include "engine_num.h"     /* real_of, vec_of, point_of */
#include "tool.h"           /* tool_grow */

static bool vecs_of(const double p[][ENGINE_AXES], unsigned count, loft_vec out[])
{
    for (unsigned i = 0; i < count; i++)
        if (!vec_of(p[i], &out[i]))
            return false;
    return true;
}

static int hold(double x, double *out)
{
    loft_real held;

    if (!real_of(x, &held))
        return LOFT_ERR_RANGE;
    *out = double_of(held);
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
            raw.p[k][i] = (int32_t)lround(double_of(s->p[k].axis[i]) * 65536.0);
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

#define ENGINE_TEXT_(tag) #tag
#define ENGINE_TEXT(tag)  ENGINE_TEXT_(tag)

const engine ENGINE_OF(engine) = {
    .name    = ENGINE_TEXT(LOFT_TAG),
    .fixed   = LOFT_REAL_LSB > 0,
    .lsb     = LOFT_REAL_LSB > 0 ? 1 / (double)LOFT_REAL(1.0) : sizeof(loft_real) == sizeof(double) ? DBL_EPSILON : (double)FLT_EPSILON,
    .reach   = (double)LOFT_PLAN_REACH / (double)LOFT_REAL(1.0),
    .hold    = hold,
    .curve   = &ENGINE_OF(engine_curves),
    .piece   = &ENGINE_OF(engine_pieces),
    .measure = &ENGINE_OF(engine_measures),
    .flatten = flatten,
    .plan    = plan,
    .steps   = steps
};
