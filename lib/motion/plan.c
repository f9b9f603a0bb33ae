/* lib/motion/plan.c
 * SPDX-License-Identifier: MIT
 *
 * The course gives a point c_k of the path per beat. They are the control points of a uniform quadratic
 * B-spline in time, whose knots lie half way between them:
 *
 *     position at knot k       P = (c_k + c_(k+1)) / 2
 *     velocity there           V = c_(k+1) - c_k                     per beat
 *     acceleration in between  c_(k-1) - 2 c_k + c_(k+1)             per beat^2, constant
 *
 * So it is C1, its speed is an average of the path's speed over one beat and its acceleration one over two beats: no
 * larger per axis than the largest of what is averaged, across joints and changes of phase (the variation diminishing
 * property). Doubled samples at both ends put the knots there onto the end points, at rest. c_k lies on the path, and
 * the spline passes at (c_(k-1) + 6 c_k + c_(k+1)) / 8: limits.c has the bound.
 *
 * One polynomial piece of it per beat would do. A span is the longest of its Hermite interpolants
 *
 *     P0   P0 + V0 m / 3   P1 - V1 m / 3   P1                        from one knot to the m-th after it
 *
 * whose acceleration is within the limits at both ends (it is a straight line in time), that passes the samples
 * within the tolerance at their times, and whose velocity is within the limits and that of the B-spline, to 1/256, at
 * every knot.
 */
#include "motion/plan.h"

#define SLACK loft_wide(LOFT_REAL(0.000244140625))   /* 2^-12 mm per beat, shared out like the speed */

static loft_acc size_of(loft_acc x) { return x < 0 ? -x : x; }

static const loft_acc *sample(const loft_plan *plan, unsigned k)
{
    return plan->sample[(plan->first + k) % LOFT_PLAN_WINDOW];
}

static void push(loft_plan *plan, const loft_acc point[])
{
    loft_acc *to = plan->sample[(plan->first + plan->held) % LOFT_PLAN_WINDOW];
    for (int i = 0; i < LOFT_AXES; i++)
        to[i] = point[i];
    plan->held++;
}

enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, const loft_move chain[], uint32_t count,
                                loft_plan_node nodes[], uint32_t node_count)
{
    enum loft_status status = loft_limits_check(limits);
    loft_budget budget;
    loft_acc start[LOFT_AXES];

    if (status != LOFT_OK)
        return status;
    loft_budget_init(&budget, limits);
    status = loft_course_init(&plan->course, &budget, chain, count, nodes, node_count);
    if (status != LOFT_OK)
        return status;

    plan->first = plan->held = 0;
    plan->ends  = plan->course.over ? 0 : 2;
    plan->at    = chain[0].curve.p[0];
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc accel = loft_wide(limits->max_accel[i]) * budget.beat;
        start[i] = loft_wide(plan->at.axis[i]);
        plan->speed[i] = loft_budget_beat(&budget, limits->max_speed[i]);
        plan->speed[i] += loft_acc_ratio(plan->speed[i], 256) + SLACK / 256;
        plan->accel[i] = loft_acc_ratio(loft_acc_ratio(accel, budget.tick_hz) * budget.beat, budget.tick_hz);
    }
    push(plan, start);
    push(plan, start);
    return LOFT_OK;
}

/* Samples up to the window's size; the end twice. */
static void fill(loft_plan *plan)
{
    loft_acc point[LOFT_AXES];

    while (plan->held < LOFT_PLAN_WINDOW && plan->ends > 0) {
        if (!loft_course_next(&plan->course, point))
            plan->ends--;
        push(plan, point);
    }
}

/* The Hermite interpolant over m beats; q16: m <= 62 beats of at most 2^15 mm / 62. */
static void interpolate(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    const loft_acc *a = sample(plan, 0), *b = sample(plan, 1), *c = sample(plan, m), *d = sample(plan, m + 1);

    for (int i = 0; i < LOFT_AXES; i++) {
        p[0][i] = (a[i] + b[i]) / 2;
        p[3][i] = (c[i] + d[i]) / 2;
        p[1][i] = p[0][i] + loft_acc_ratio((b[i] - a[i]) * (int32_t)m, 3);
        p[2][i] = p[3][i] - loft_acc_ratio((d[i] - c[i]) * (int32_t)m, 3);
    }
}

static bool accelerates_within(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc most = plan->accel[i] * (int32_t)(m * m);
        if (6 * size_of(p[0][i] - 2 * p[1][i] + p[2][i]) > most || 6 * size_of(p[1][i] - 2 * p[2][i] + p[3][i]) > most)
            return false;
    }
    return true;
}

/* Half way between the knots j - 1 and j: is the span near the sample there? |x| + |y| + .. bounds the distance. */
static bool passes(const loft_plan *plan, unsigned m, unsigned j, loft_acc p[4][LOFT_AXES], loft_acc tol)
{
    const loft_unit t = loft_unit_of(2 * j - 1, 2 * m);
    const loft_acc *want = sample(plan, j);
    loft_acc off = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc q0 = loft_acc_lerp(p[0][i], p[1][i], t), q1 = loft_acc_lerp(p[1][i], p[2][i], t);
        const loft_acc q2 = loft_acc_lerp(p[2][i], p[3][i], t);
        off += size_of(loft_acc_lerp(loft_acc_lerp(q0, q1, t), loft_acc_lerp(q1, q2, t), t) - want[i]);
    }
    return off <= tol;
}

/* At knot j: is the velocity within the limits, and that of the B-spline, both to 1/256 and 2^-20 mm per beat? */
static bool runs(const loft_plan *plan, unsigned m, unsigned j, loft_acc p[4][LOFT_AXES])
{
    const loft_unit t = loft_unit_of(j, m);
    const loft_acc *a = sample(plan, j), *b = sample(plan, j + 1);
    loft_acc off = 0, speed = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc d0 = p[1][i] - p[0][i], d1 = p[2][i] - p[1][i], d2 = p[3][i] - p[2][i], v = b[i] - a[i];
        const loft_acc d  = loft_acc_lerp(loft_acc_lerp(d0, d1, t), loft_acc_lerp(d1, d2, t), t);
        const loft_acc w  = loft_acc_ratio(3 * d, (int32_t)m), e = size_of(w - v);
        if (size_of(w) > plan->speed[i])
            return false;
        off   = e > off ? e : off;
        speed = size_of(v) > speed ? size_of(v) : speed;
    }
    return off * 256 <= speed + SLACK;
}

static bool fits(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    const loft_acc tol = loft_acc_ratio(loft_wide(plan->course.budget.tol) * 3, 4);

    interpolate(plan, m, p);
    if (!accelerates_within(plan, m, p))
        return false;
    for (unsigned j = 1; j <= m; j++)
        if (!passes(plan, m, j, p, tol) || (j < m && !runs(plan, m, j, p)))
            return false;
    return true;
}

/* The longest span that fits, found by doubling and then halving the step; one beat always does. */
static unsigned longest(const loft_plan *plan, unsigned most)
{
    loft_acc p[4][LOFT_AXES];
    unsigned m = 1, step = 1;

    while (m + step <= most && fits(plan, m + step, p)) {
        m += step;
        step *= 2;
    }
    while ((step /= 2) > 0)
        if (m + step <= most && fits(plan, m + step, p))
            m += step;
    return m;
}

bool loft_plan_next(loft_plan *plan, loft_span *out)
{
    const unsigned beat = plan->course.budget.beat;
    loft_acc p[4][LOFT_AXES];

    fill(plan);
    if (plan->held < 3)
        return false;

    const unsigned knots = plan->held - 2u, room = LOFT_SPAN_TICKS_MAX / beat;
    const unsigned m = longest(plan, knots < room ? knots : room);
    interpolate(plan, m, p);
    out->p[0] = plan->at;
    for (int k = 1; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out->p[k].axis[i] = loft_acc_round(p[k][i]);
    out->ticks  = (uint16_t)(m * beat);
    plan->at    = out->p[3];
    plan->first = (uint8_t)((plan->first + m) % LOFT_PLAN_WINDOW);
    plan->held  = (uint8_t)(plan->held - m);
    return true;
}
