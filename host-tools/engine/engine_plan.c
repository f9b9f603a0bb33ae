/* host-tools/engine/engine_plan.c -- plans moves into spans, one at a time
 * SPDX-License-Identifier: MIT
 *
 * Compiled once per number type. The result depends on when moves are pushed. This file pushes as
 * many as there is room for, then takes spans until the plan waits. So the result does not depend
 * on how long the caller pauses between two steps.
 */
#include <stdlib.h>

#include "motion/plan.h"    /* loft_plan */

#include "engine/engine_num.h"  /* real_of, vecs_of, double_of */
#include "base/tool.h"          /* tool_grow */

enum { MOVES = 512, KNOTS = 400 };

#define EVERY_AXIS ((1u << ENGINE_AXES) - 1)
#define STRAIGHT   (4 / 65536.0)    /* mm: rounding */

struct engine_plan {
    engine_move_source *source;
    void *context;
    size_t count, next;             /* moves, and moves pushed */
    size_t passed;                  /* moves that end by the end of the last span */
    bool pushing;
    loft_plan plan;
    loft_move ring[MOVES];
    loft_knot knots[KNOTS];
};

static bool limits_of(const engine_limits *from, loft_limits *out)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        if (!real_of(from->max_speed[i], &out->max_speed[i]) ||
            !real_of(from->max_accel[i], &out->max_accel[i]) ||
            !(from->max_jerk[i] >= 0 && from->max_jerk[i] <= UINT32_MAX))
            return false;
        out->max_jerk[i] = (uint32_t)lround(from->max_jerk[i]);
    }
    out->tick_hz = (uint16_t)from->tick_hz;
    out->one_sided = (uint8_t)from->one_sided;
    return from->tick_hz <= UINT16_MAX && real_of(from->corner, &out->corner) &&
           real_of(from->exact, &out->exact) && real_of(from->tol, &out->tol);
}

/* Points are rounded to 2^-16 mm, as spans are sent: what is beyond would be left to the last span
 * of a chain, which would exceed its limits by up to a part of 2^-16 mm. */
static bool move_of(const engine_plan *p, size_t n, loft_move *out)
{
    engine_move move;

    p->source(p->context, n, &move);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            move.p[k][i] = round(move.p[k][i] * 65536.0) / 65536.0;
    return vecs_of((const double(*)[ENGINE_AXES])move.p, 4, out->curve.p) &&
           real_of(move.feed, &out->feed);
}

/* Check all moves now: nothing may be refused later, when the machine moves. */
static bool moves_fit(const engine_plan *p)
{
    loft_move move;
    loft_vec end;

    for (size_t n = 0; n < p->count; n++) {
        if (!move_of(p, n, &move) || move.feed < LOFT_SPEED_MIN || move.feed > LOFT_SPEED_MAX ||
            (n > 0 && !loft_vec_equal(move.curve.p[0], end)))
            return false;
        for (int k = 0; k < 4; k++)
            if (!loft_vec_within(move.curve.p[k], LOFT_PLAN_REACH))
                return false;
        end = move.curve.p[3];
    }
    return true;
}

/* The way from a to b. */
static double way_of(loft_vec a, loft_vec b, double out[ENGINE_AXES])
{
    double square = 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        out[i] = double_of(b.axis[i]) - double_of(a.axis[i]);
        square += out[i] * out[i];
    }
    return sqrt(square);
}

/* True if it is one straight line that never turns back, however it is cut. */
static bool is_one_line(const engine_plan *p)
{
    double along[ENGINE_AXES], off[ENGINE_AXES], before = 0;
    loft_move first, last;

    (void)move_of(p, 0, &first);
    (void)move_of(p, p->count - 1, &last);
    const double size = way_of(first.curve.p[0], last.curve.p[3], along);
    for (size_t n = 0; n < p->count; n++) {
        loft_move m;
        (void)move_of(p, n, &m);
        for (int k = 0; k < 4; k++) {
            const double far = way_of(first.curve.p[0], m.curve.p[k], off);
            double part = 0;
            for (int i = 0; i < ENGINE_AXES && size > 0; i++)
                part += off[i] * along[i] / size;
            if (!(far * far - part * part <= STRAIGHT * STRAIGHT) || part < before - STRAIGHT)
                return false;
            before = part;
        }
    }
    return true;
}

static int plan_open(const engine_limits *limits, engine_move_source *source, void *context,
                     size_t count, engine_plan **out)
{
    loft_limits within;

    *out = NULL;
    if (count == 0 || !limits_of(limits, &within))
        return count == 0 ? LOFT_ERR_ARG : LOFT_ERR_RANGE;
    engine_plan *p = tool_grow(NULL, sizeof *p);
    p->source  = source;
    p->context = context;
    p->count   = count;
    p->next    = p->passed = 0;
    p->pushing = true;
    int status = LOFT_ERR_RANGE;
    if (moves_fit(p)) {
        if (is_one_line(p))
            within.one_sided = EVERY_AXIS;
        status = loft_plan_init(&p->plan, &within, p->ring, MOVES, p->knots, KNOTS);
    }
    if (status == LOFT_OK)
        *out = p;
    else
        free(p);
    return status;
}

/* Push a move, or the end after the last one. */
static int push_move(engine_plan *p)
{
    loft_move move;

    if (p->next == p->count) {
        loft_plan_end(&p->plan);
        p->pushing = false;
        return ENGINE_PLAN_BUSY;
    }
    if (!move_of(p, p->next, &move))
        return LOFT_ERR_RANGE;
    const int status = loft_plan_push(&p->plan, &move);
    if (status == LOFT_ERR_SPACE)
        p->pushing = false;
    else if (status != LOFT_OK)
        return status;
    else
        p->next++;
    return ENGINE_PLAN_BUSY;
}

/* Convert a span to raw Q16.16, as it is sent, whatever type it was planned in. */
static void raw_of(const loft_span *s, engine_span *out)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            out->p[k][i] = (int32_t)lround(double_of(s->p[k].axis[i]) * 65536.0);
    out->ticks = s->ticks;
}

static int plan_step(engine_plan *p, engine_span *out)
{
    loft_span span;

    if (p->pushing)
        return push_move(p);
    if (loft_plan_next(&p->plan, &span) != LOFT_PLAN_SPAN) {
        p->pushing = p->next < p->count;
        return p->pushing ? ENGINE_PLAN_BUSY : ENGINE_PLAN_DONE;
    }
    raw_of(&span, out);
    p->passed += (uint16_t)(loft_plan_passed(&p->plan) - (uint16_t)p->passed);
    return ENGINE_PLAN_SPAN;
}

static size_t plan_passed(const engine_plan *p) { return p->passed; }

static void plan_close(engine_plan *p) { free(p); }

const engine_plans ENGINE_OF(engine_plans) = {
    .open = plan_open, .step = plan_step, .passed = plan_passed, .close = plan_close
};
