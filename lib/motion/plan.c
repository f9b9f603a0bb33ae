/* lib/motion/plan.c
 * SPDX-License-Identifier: MIT
 *
 * The law gives a place c_k of the path per beat. They are the control points of a uniform cubic
 * B-spline in time:
 *
 *     position at knot k     P = (c_k + 4 c_(k+1) + c_(k+2)) / 6
 *     velocity               V = (c_(k+2) - c_k) / 2                           per beat
 *     acceleration           A = c_k - 2 c_(k+1) + c_(k+2)                     per beat^2
 *     jerk up to knot k + 1  c_(k+3) - 3 c_(k+2) + 3 c_(k+1) - c_k             per beat^3, constant
 *
 * So it is C2, and all of them are averages of the path's: no larger per axis than the largest of
 * what is averaged, across joints and changes of phase (the variation diminishing property). Three
 * equal samples put a knot there, at rest. limits.c has the bound of its distance from the path.
 *
 * One polynomial piece of it per beat would do. A span is the longest of its Hermite interpolants
 *
 *     P0   P0 + V0 m / 3   P1 - V1 m / 3   P1                        from one knot to the m-th
 *          after it
 *
 * that passes the knots in time, within an eighth of the tolerance, at the velocity of the
 * B-spline, to 1/2048, at all knots and half way between them, with its speed and acceleration
 * within the limits everywhere. Where jerk is limited its acceleration is also that of the B-spline
 * at all knots, as closely as the rounding of a beat's control points would leave it, and its jerk
 * within the limit.
 */
#include "motion/plan.h"

#include "num/accs.h"   /* loft_accs_from */

#define SIXTH LOFT_UNIT(0.16666666666666667)
#define THIRD (2 * SIXTH)      /* rounded, on any compiler: the doubles of avr-gcc have 24 bits */
/* 2^-12 mm per beat, but a quarter of the slowest feed at most, shared out like the speed */
#define SLACK loft_to_acc(LOFT_REAL(0.000244140625))
#define GRAINS loft_to_acc(LOFT_REAL(0.000091552734))  /* 6 / 65536 mm per beat^2 */


/* Curves that the place of the law has left behind. */
static uint16_t behind(const loft_plan *plan)
{
    const loft_course *c = &plan->law.course;
    return c->count > 0 ? loft_course_number(c, loft_course_piece(c, plan->law.from))
                        : (uint16_t)(c->passed + c->cut);
}

static bool same(const loft_acc point[], const loft_vec *v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (loft_acc_abs(point[i] - loft_to_acc(v->axis[i])) > 0)
            return false;
    return true;
}

#if LOFT_PLAN_WINDOW > 4

static const loft_acc *sample(const loft_plan *plan, unsigned k)
{
    return plan->sample[(plan->first + k) % LOFT_PLAN_WINDOW];
}

static void push(loft_plan *plan, const loft_acc point[])
{
    const unsigned k = (plan->first + plan->held) % LOFT_PLAN_WINDOW;
    for (int i = 0; i < LOFT_AXES; i++)
        plan->sample[k][i] = point[i];
    plan->behind[k] = behind(plan);
    plan->held++;
}

/* The path begins here, at rest. */
static void begin(loft_plan *plan)
{
    loft_acc point[LOFT_AXES];

    loft_accs_from(point, plan->at.axis);
    for (int k = 0; k < 3; k++)
        push(plan, point);
}

#else

static void begin(loft_plan *plan)
{
    loft_accs_from(plan->point, plan->at.axis);
    plan->still = 3;
}

#endif

enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, loft_move moves[],
                                uint16_t move_room, loft_plan_piece pieces[], uint16_t piece_room)
{
    enum loft_status status = loft_limits_check(limits);
    loft_budget b;

    if (status == LOFT_OK && (move_room == 0 || piece_room < 3))
        status = LOFT_ERR_SPACE;
    if (status != LOFT_OK)
        return status;
    loft_budget_init(&b, limits);
    loft_course_init(&plan->law.course, &b, moves, move_room, pieces, piece_room);
    loft_law_init(&plan->law);

    plan->begun = plan->cut = false;
#if LOFT_PLAN_FILTER > 1
    plan->eased.width = 0;
    plan->past = 0;
#endif
#if LOFT_PLAN_WINDOW == 4
    for (int i = 0; i < LOFT_AXES; i++)
        plan->leg[i] = 0;
    plan->behind[0] = plan->behind[1] = plan->behind[2] = 0;
#else
    plan->first = plan->held = 0;
    plan->slack = SLACK;
    for (int i = 0; i < LOFT_AXES; i++) {
        plan->speed[i]  = loft_budget_beat(&b, limits->max_speed[i]);
        plan->accel[i] = loft_acc_scale(
            loft_budget_beat(&b, limits->max_accel[i] + limits->max_across), b.pulse);
        plan->jerk[i]   = loft_acc_scale(loft_budget_beat(&b, b.gain[i]), b.pulse);
    }
#endif
    return LOFT_OK;
}

enum loft_status loft_plan_push(loft_plan *plan, const loft_move *move)
{
    loft_course *c = &plan->law.course;
    if (plan->begun && !loft_vec_equal(move->curve.p[0], c->end))
        return LOFT_ERR_ARG;
    const enum loft_status status = loft_course_push(c, move);

    if (status == LOFT_OK && !plan->begun) {
        plan->begun = true;
        plan->at    = move->curve.p[0];
        begin(plan);
    }
#if LOFT_PLAN_WINDOW > 4
    if (status == LOFT_OK)
        plan->slack = loft_acc_min(plan->slack, loft_budget_beat(&c->budget, move->feed) / 4);
#endif
    return status;
}

void loft_plan_end(loft_plan *plan) { plan->law.course.ended = true; }


/* Samples
 * ------- */

#if LOFT_PLAN_FILTER > 1

/* Move the point at `off` on piece `from` aside for the joint before it, whose piece may be gone,
 * and those ahead. */
static void ease(loft_plan *plan, loft_acc off, loft_acc point[])
{
    const loft_course *c = &plan->law.course;
    const loft_acc reach = loft_to_acc(LOFT_EASE_MAX);
    const unsigned from  = plan->law.from;

    loft_acc d = off;
    for (unsigned j = from; d < reach; d += loft_unit_to_acc(loft_course_piece(c, --j)->length)) {
        const loft_plan_piece *p = loft_course_piece(c, j);
        if (p->ease.width > 0) {
            plan->eased = p->ease;
            plan->past  = d;
        }
        if (p->ease.width > 0 || j == 0)
            break;
    }
    loft_ease_point(&plan->eased, plan->past, point);
    d = loft_unit_to_acc(loft_course_piece(c, from)->length) - off;
    for (unsigned j = from + 1; d < reach && j < c->count; j++) {
        const loft_plan_piece *p = loft_course_piece(c, j);
        loft_ease_point(&p->ease, -d, point);
        d += loft_unit_to_acc(p->length);
    }
}

/* The place of the law is on the joint p, or on a piece without a length. */
static void ease_from(loft_plan *plan, const loft_plan_piece *p)
{
    if (p->ease.width > 0) {
        plan->eased = p->ease;
        plan->past  = 0;
    }
}

#endif

/* The place of the law on the path. */
static void set_place(loft_plan *plan, loft_acc point[])
{
    const loft_course *c = &plan->law.course;
    const loft_plan_piece  *p = loft_course_piece(c, plan->law.from);
    const loft_acc   off = loft_law_off(&plan->law);

#if LOFT_PLAN_FILTER > 1
    if (LOFT_BUDGET_JERK(&c->budget))
        plan->past += loft_law_mean(&plan->law, plan->law.sum);
#endif
    if (p->length > 0 && p->to == LOFT_ARC_WHOLE && off >= loft_unit_to_acc(p->length)) {
        loft_accs_from(point, c->moves[p->move].curve.p[3].axis);
        return;
    }
    if (!plan->cut || plan->number != loft_course_number(c, p) || plan->from != p->from) {
        loft_arc_pace(&plan->arc, &c->moves[p->move].curve, p->from, p->to, p->chord);
        plan->cut    = true;
        plan->number = loft_course_number(c, p);
        plan->from   = p->from;
    }
    if (p->length > 0) {
        loft_arc_eval(&plan->arc, off < plan->arc.length ? off : plan->arc.length, point);
#if LOFT_PLAN_FILTER > 1
        if (LOFT_BUDGET_JERK(&c->budget))
            ease(plan, off, point);
#endif
    } else {                    /* a joint, or too short to have a length */
#if LOFT_PLAN_FILTER > 1
        ease_from(plan, p);
#endif
        for (int i = 0; i < LOFT_AXES; i++)
            point[i] = plan->arc.c[0][i];
        plan->cut = false;      /* the next piece begins at the same parameter */
    }
}

#if LOFT_PLAN_WINDOW > 4

/* Do the last three samples lie on the end? */
static bool ends(const loft_plan *plan)
{
    for (unsigned k = 1; k <= 3; k++)
        if (!same(sample(plan, plan->held - k), &plan->law.course.end))
            return false;
    return true;
}

static enum loft_law_state fill(loft_plan *plan)
{
    enum loft_law_state state = LOFT_LAW_RUNS;
    loft_acc point[LOFT_AXES];

    while (plan->held < LOFT_PLAN_WINDOW && state != LOFT_LAW_WAITS) {
        state = loft_law_next(&plan->law);
        if (state == LOFT_LAW_RUNS)
            set_place(plan, point);
        else if (state == LOFT_LAW_RESTS) {
            if (!plan->begun || ends(plan))
                break;
            loft_accs_from(point, plan->law.course.end.axis);
        }
        if (state != LOFT_LAW_WAITS)
            push(plan, point);
    }
    return state;
}


/* Spans
 * ----- */

/* The Hermite interpolant over m beats; q16: m <= 125 beats of at most 2^15 mm / 125. */
static void interpolate(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    const loft_acc *a = sample(plan, 0), *b = sample(plan, 1), *c = sample(plan, 2);
    const loft_acc *d = sample(plan, m), *e = sample(plan, m + 1), *f = sample(plan, m + 2);

    for (int i = 0; i < LOFT_AXES; i++) {
        p[0][i] = b[i] + loft_acc_scale(a[i] - 2 * b[i] + c[i], SIXTH);
        p[3][i] = e[i] + loft_acc_scale(d[i] - 2 * e[i] + f[i], SIXTH);
        p[1][i] = p[0][i] + loft_acc_scale((c[i] - a[i]) * (int32_t)m, SIXTH);
        p[2][i] = p[3][i] - loft_acc_scale((f[i] - d[i]) * (int32_t)m, SIXTH);
    }
}

/* The velocity of an axis is a parabola with control values v0, v1, v2, the differences of the
 * points times 3 / m. If v1 is beyond both others it turns around at v0 + (v1 - v0)^2 / (v1 - v0 +
 * v1 - v2). */
static bool runs_within(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc d0 = p[1][i] - p[0][i], d1 = p[2][i] - p[1][i], d2 = p[3][i] - p[2][i],
                       rise = d1 - d0, fall = d1 - d2;
        const loft_acc most = (plan->speed[i] + plan->speed[i] / 2048) * (int32_t)m;
        const bool turns = (rise > 0) == (fall > 0) && loft_acc_abs(rise) > 0 &&
                           loft_acc_abs(fall) > 0;
        const loft_acc peak = turns ? d0 + loft_acc_scale(
                                               rise, loft_unit_ratio(loft_acc_abs(rise),
                                                                     loft_acc_abs(rise + fall)))
                                    : d0;

        if (3 * loft_acc_abs(d0) > most || 3 * loft_acc_abs(d2) > most ||
            3 * loft_acc_abs(peak) > most)
            return false;
    }
    return true;
}

static bool accelerates_within(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc most = plan->accel[i] * (int32_t)(m * m);
        if (6 * loft_acc_abs(p[0][i] - 2 * p[1][i] + p[2][i]) > most ||
            6 * loft_acc_abs(p[1][i] - 2 * p[2][i] + p[3][i]) > most)
            return false;
        if (LOFT_BUDGET_JERK(&plan->law.course.budget) &&
            6 * loft_acc_abs(p[3][i] - p[0][i] + 3 * (p[1][i] - p[2][i])) >
                (plan->jerk[i] + plan->jerk[i] / 128) * (int32_t)(m * m * m))
            return false;
    }
    return true;
}

/* With a limit of its own across the path, the sum that the test above allows is more than what
 * holds along it. Is the acceleration between those of the B-spline at the knots, to 1/64 of what
 * may be changed of the speed? */
static bool accelerates_between(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    const loft_budget *b = &plan->law.course.budget;

    for (int i = 0; i < LOFT_AXES && b->across > 0; i++) {
        loft_acc low = 0, high = 0;
        for (unsigned j = 0; j <= m; j++) {
            const loft_acc bend = sample(plan, j)[i] - 2 * sample(plan, j + 1)[i] +
                                  sample(plan, j + 2)[i];
            low  = j == 0 || bend < low ? bend : low;
            high = j == 0 || bend > high ? bend : high;
        }
        const loft_acc slack = loft_acc_scale(loft_budget_beat(b, b->accel[i]), b->pulse) / 64;
        for (int k = 0; k < 2; k++) {
            const loft_acc bend = 6 * (p[k][i] - 2 * p[k + 1][i] + p[k + 2][i]);
            if (bend > (high + slack) * (int32_t)(m * m) || bend < (low - slack) * (int32_t)(m * m))
                return false;
        }
    }
    return true;
}

/* The de Casteljau point, and the differences of the last rows that give velocity and
 * acceleration. */
typedef struct {
    loft_acc at, speed, accel;
} state;

static state state_at(loft_acc p[4][LOFT_AXES], int i, unsigned m, loft_unit t)
{
    const loft_acc q0 = loft_acc_lerp(p[0][i], p[1][i], t), q1 = loft_acc_lerp(p[1][i], p[2][i], t);
    const loft_acc q2 = loft_acc_lerp(p[2][i], p[3][i], t);
    const loft_acc r0 = loft_acc_lerp(q0, q1, t), r1 = loft_acc_lerp(q1, q2, t);

    return (state){ loft_acc_lerp(r0, r1, t), loft_acc_ratio(3 * (r1 - r0), (int32_t)m),
                    6 * (q0 - 2 * q1 + q2) };
}

/* Does the span pass knot j as the B-spline does? |x| + |y| + .. bounds the distance. */
static bool passes(const loft_plan *plan, unsigned m, unsigned j, loft_acc p[4][LOFT_AXES],
                   loft_acc tol)
{
    const loft_unit t = loft_unit_of(j, m);
    const loft_acc *a = sample(plan, j), *b = sample(plan, j + 1), *c = sample(plan, j + 2);
    const bool jerk = LOFT_BUDGET_JERK(&plan->law.course.budget);
    loft_acc off = 0, off_speed = 0, speed = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const state s = state_at(p, i, m, t);
        const loft_acc v = (c[i] - a[i]) / 2, bend = a[i] - 2 * b[i] + c[i],
                       e = loft_acc_abs(s.speed - v);
        const loft_acc most = plan->accel[i] / 256 < GRAINS ? plan->accel[i] / 256 : GRAINS;
        if (jerk && loft_acc_abs(s.accel - bend * (int32_t)(m * m)) > most * (int32_t)(m * m))
            return false;
        off  += loft_acc_abs(s.at - b[i] - loft_acc_ratio(bend, 6));
        off_speed = e > off_speed ? e : off_speed;
        speed = loft_acc_abs(v) > speed ? loft_acc_abs(v) : speed;
    }
    return off <= tol && off_speed * 2048 <= speed + plan->slack;
}

/* Half way between knots j and j + 1: is the velocity that of the B-spline there, too? */
static bool runs_between(const loft_plan *plan, unsigned m, unsigned j, loft_acc p[4][LOFT_AXES])
{
    const loft_unit t = loft_unit_of(2 * j + 1, 2 * m);
    loft_acc off = 0, speed = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc d1 = sample(plan, j + 2)[i] - sample(plan, j + 1)[i],
                       d = sample(plan, j + 3)[i] - sample(plan, j)[i];
        const loft_acc v = loft_acc_ratio(d + 5 * d1, 8),
                       e = loft_acc_abs(state_at(p, i, m, t).speed - v);
        off   = e > off ? e : off;
        speed = loft_acc_abs(v) > speed ? loft_acc_abs(v) : speed;
    }
    return off * 2048 <= speed + plan->slack;
}

static bool fits(const loft_plan *plan, unsigned m, loft_acc p[4][LOFT_AXES])
{
    const loft_acc tol = loft_to_acc(plan->law.course.budget.tol) / 8;

    interpolate(plan, m, p);
    if (!runs_within(plan, m, p) || !accelerates_within(plan, m, p) ||
        !accelerates_between(plan, m, p))
        return false;
    for (unsigned j = 0; j <= m; j++)
        if (!passes(plan, m, j, p, tol) || (j < m && !runs_between(plan, m, j, p)))
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

enum loft_plan_state loft_plan_next(loft_plan *plan, loft_span *out)
{
    const unsigned beat = plan->law.course.budget.beat;
    const enum loft_law_state law = fill(plan);
    loft_acc p[4][LOFT_AXES];

    if (plan->held < LOFT_PLAN_WINDOW && law == LOFT_LAW_WAITS)
        return LOFT_PLAN_WAIT;
    if (plan->held < 4)
        return LOFT_PLAN_REST;

    const unsigned knots = plan->held - 3u, room = LOFT_SPAN_TICKS_MAX / beat;
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
    return LOFT_PLAN_SPAN;
}

#else

/* One beat: with b, c, d the control points of the B-spline after the first, and l = c - b, its
 * Bezier points are
 *
 *     b + l / 3   c - l / 3   c + (d - c - l) / 6
 */
static void set_span(loft_plan *plan, const loft_acc d[], loft_span *out)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc c = plan->point[i], l = plan->leg[i], third = loft_acc_scale(l, THIRD);
        out->p[1].axis[i] = loft_acc_round(c - l + third);
        out->p[2].axis[i] = loft_acc_round(c - third);
        plan->leg[i]      = d[i] - c;
        out->p[3].axis[i] = loft_acc_round(c + loft_acc_scale(plan->leg[i] - l, SIXTH));
        plan->point[i]    = d[i];
    }
}

/* The end once more; false if it was so thrice, that is, the last span ended there. */
static bool set_end(loft_plan *plan, loft_acc point[])
{
    if (plan->still == 0 && same(plan->point, &plan->law.course.end))
        plan->still++;
    loft_accs_from(point, plan->law.course.end.axis);
    return plan->begun && plan->still++ < 3;
}

enum loft_plan_state loft_plan_next(loft_plan *plan, loft_span *out)
{
    const enum loft_law_state law = loft_law_next(&plan->law);
    loft_acc point[LOFT_AXES];

    if (law == LOFT_LAW_WAITS)
        return LOFT_PLAN_WAIT;
    if (law == LOFT_LAW_RUNS) {
        set_place(plan, point);
        plan->still = 0;
    } else if (!set_end(plan, point)) {
        plan->still = 3;
        return LOFT_PLAN_REST;
    }
    plan->behind[0] = plan->behind[1];
    plan->behind[1] = plan->behind[2];
    plan->behind[2] = behind(plan);
    set_span(plan, point, out);
    out->p[0]  = plan->at;
    out->ticks = plan->law.course.budget.beat;
    plan->at   = out->p[3];
    return LOFT_PLAN_SPAN;
}

#endif
