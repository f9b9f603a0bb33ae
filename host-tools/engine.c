/* host-tools/engine.c -- one number type behind the double interface of engine.h
 * SPDX-License-Identifier: MIT
 *
 * Compiled three times.
 */
#include <float.h>
#include <stdlib.h>

#include "curve/circle.h"   /* loft_circle */
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

static int ellipse(const double from[2], const double to[2], const double radii[2], double degrees, bool large, int turns, double tol,
                   engine_cubic_sink *sink, void *context)
{
    const double ends[2][ENGINE_AXES] = { { from[0], from[1] }, { to[0], to[1] } };
    loft_circle_spans s;
    loft_circle arc;
    loft_cubic c;
    loft_vec p[2];
    loft_real r[2], angle, within;

    if (!vecs_of(ends, 2, p) || !real_of(radii[0], &r[0]) || !real_of(radii[1], &r[1]) || !real_of(degrees, &angle) || !tol_of(tol, &within))
        return LOFT_ERR_RANGE;
    int status = loft_circle_from_ellipse(&arc, p[0], p[1], LOFT_PLANE_XY, r, angle, large, turns);
    if (status == LOFT_OK)
        status = loft_circle_spans_init(&s, &arc, LOFT_CIRCLE_CUBIC, within);
    while (status == LOFT_OK && loft_circle_spans_next(&s, &c)) {
        double out[4][ENGINE_AXES];
        for (int k = 0; k < 4; k++)
            point_of(c.p[k], out[k]);
        sink(context, out);
    }
    return status;
}

static int flatten(const double p[4][ENGINE_AXES], double tol, engine_point_sink *sink, void *context)
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

static bool limits_of(const engine_limits *from, loft_limits *out)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        if (!real_of(from->max_speed[i], &out->max_speed[i]) || !real_of(from->max_accel[i], &out->max_accel[i])
            || !(from->max_jerk[i] >= 0 && from->max_jerk[i] <= UINT32_MAX))
            return false;
        out->max_jerk[i] = (uint32_t)lround(from->max_jerk[i]);
    }
    out->tick_hz = (uint16_t)from->tick_hz;
    return from->tick_hz <= UINT16_MAX && real_of(from->max_across, &out->max_across) && real_of(from->corner, &out->corner) && real_of(from->tol, &out->tol);
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

/* The moves that there is room for, from number `next` on; those beyond the last one end the path. */
static int push_moves(loft_plan *p, const engine_move moves[], size_t count, size_t *next)
{
    for (; *next < count; ++*next) {
        loft_move move;
        if (!vecs_of(moves[*next].p, 4, move.curve.p) || !real_of(moves[*next].feed, &move.feed))
            return LOFT_ERR_RANGE;
        const enum loft_status status = loft_plan_push(p, &move);
        if (status != LOFT_OK)
            return status == LOFT_ERR_SPACE ? LOFT_OK : status;
    }
    loft_plan_end(p);
    return LOFT_OK;
}

static int plan(const engine_limits *limits, const engine_move moves[], size_t count, engine_span_sink *sink, void *context)
{
    enum { MOVES = 512, PIECES = MOVES * LOFT_PLAN_PIECES };
    loft_limits within;
    if (count == 0 || !limits_of(limits, &within))
        return count == 0 ? LOFT_ERR_ARG : LOFT_ERR_RANGE;

    loft_move *ring    = tool_grow(NULL, MOVES * sizeof *ring);
    loft_plan_piece *pieces = tool_grow(NULL, PIECES * sizeof *pieces);
    loft_plan *p       = tool_grow(NULL, sizeof *p);
    enum loft_plan_state state = LOFT_PLAN_SPAN;
    loft_span span;
    size_t next = 0;

    int status = loft_plan_init(p, &within, ring, MOVES, pieces, PIECES);
    while (status == LOFT_OK && (next < count || state == LOFT_PLAN_SPAN)) {
        status = push_moves(p, moves, count, &next);
        while (status == LOFT_OK && (state = loft_plan_next(p, &span)) == LOFT_PLAN_SPAN) {
            const engine_span raw = raw_of(&span);
            sink(context, &raw);
        }
    }
    free(p);
    free(pieces);
    free(ring);
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
    .ellipse = ellipse,
    .surface = &ENGINE_OF(engine_surfaces),
    .maps    = &ENGINE_OF(engine_maps),
    .flatten = flatten,
    .plan    = plan,
    .steps   = steps
};
