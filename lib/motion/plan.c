/* lib/motion/plan.c
 * SPDX-License-Identifier: MIT
 *
 *     0 ... at ... sure .......... timed ... placed ......... count
 *      passed | never  |   may be    |  smooth,  |  may still  |
 *             | changes|   raised    |  no pace  |   move      |
 */
#include "motion/plan.h"

#define BEHIND    4
#define SMOOTHING 16 /* knots whose points may still move */
#define ALL       (LOFT_PLAN_EFFORT > 1)
#define STEP      (ALL ? 20 : 32)    /* knots at a time, and what they need on both sides */
#define SWEEPS    (ALL ? 54 : 42)    /* of smoothing */
#define MEASURED  (ALL ? 1024u : 32u) /* knots that are measured at once, the last one again */
#define AT_ONCE   (ALL ? SWEEPS : 6) /* of them in a part */
#define RAISES    (ALL ? 4 : 1)      /* of a whole chain 4 times as many */
#define REFINED   2
#define BENDS     (LOFT_TIME_ONE / (ALL ? 4 : 2)) /* more for the end of a chain that bends */
#define SETTLED   64 /* knots before new ones that are raised again */
#define MARGIN    4  /* of them, by which is seen if ones before hinder */
#define CREEP     (LOFT_V2_ONE / 1024)

enum stage { IDLE, FILLING, MEASURING, SMOOTHING_THEM, PLACING, AIMING, RAISING };


// Knots
// -----

static void forget(loft_plan *plan)
{
    if (plan->at.knot <= BEHIND)
        return;
    const unsigned n = plan->at.knot - BEHIND;
    for (unsigned k = n; k < plan->count; k++)
        plan->knot[k - n] = plan->knot[k];
    plan->count = (uint16_t)(plan->count - n);
    plan->loaded = (uint16_t)(plan->loaded - n);
    plan->placed = (uint16_t)(plan->placed - n);
    plan->timed = (uint16_t)(plan->timed - n);
    plan->sure = (uint16_t)(plan->sure - n);
    plan->at.knot -= n;
}

static void append(loft_plan *plan, const loft_path_place *p)
{
    loft_knot *k = &plan->knot[plan->count++];
    k->is.on = *p;
    k->point = p->at;
}

/* Control points of three knots are at the start, and at the end. The third place is near it: by
 * half of the tolerance, less what is skipped beside it. */
static bool is_far(const loft_plan *plan, const loft_path_place *a, const loft_path_place *b,
                   const loft_path_place *beside)
{
    return loft_position_distance(&a->at, &b->at) >
           (plan->period.tol - loft_coord_most(loft_path_skip(b), loft_path_skip(beside))) / 2;
}

/* The last knot stands for the rest behind the end; there are seven at least. */
static void close_chain(loft_plan *plan)
{
    loft_path_place first = plan->knot[0].is.on, last = plan->knot[plan->count - 1].is.on;

    first.skip = last.skip = 0;
    while (plan->placed == 0 && plan->count < 6) {
        for (unsigned k = plan->count; k > 0; k--)
            plan->knot[k] = plan->knot[k - 1];
        plan->knot[0].is.on = first;
        plan->count++;
    }
    if (is_far(plan, &last, &plan->knot[plan->count - 2].is.on, &plan->knot[plan->count - 3].is.on))
        append(plan, &last);
    append(plan, &last);
    plan->ended = true;
    plan->to = plan->guess.path.end;
}

static void append_start(loft_plan *plan)
{
    loft_path_place first = plan->knot[0].is.on;

    plan->knot[0].is.on.skip = plan->knot[1].is.on.skip = 0;
    append(plan, &first);
}

/* One more knot; the chain ends, or there is no room: LOFT_PATH_END. */
static enum loft_path_state fill(loft_plan *plan)
{
    loft_path_place p;

    if (plan->ended || plan->count + 2 >= plan->room)
        return LOFT_PATH_END;
    const enum loft_path_state state = loft_guess_next(&plan->guess, &p);
    if (state == LOFT_PATH_END && plan->count > 0)
        close_chain(plan);
    if (state != LOFT_PATH_PLACE)
        return state;
    if (plan->count == 0)
        loft_emit_begin(&plan->emit, &plan->period, loft_path_from(&plan->guess.path));
    if (plan->count == 2 && is_far(plan, &plan->knot[1].is.on, &p, &plan->knot[1].is.on))
        append_start(plan);
    append(plan, &p);
    if (plan->count == 1)
        append(plan, &p);
    return LOFT_PATH_PLACE;
}

/* Where smoothing begins. */
static unsigned first_loose(const loft_plan *plan) { return plan->placed < 3 ? 3 : plan->placed; }

static void begin_smoothing(loft_plan *plan)
{
    loft_tube_load(plan->knot, plan->known > 1 ? plan->known - 1u : 1, plan->count - 1u);
    loft_tube_tie(plan->knot, plan->count, plan->placed == 0, plan->ended);
    plan->part = plan->sweep = 0;
    plan->stage = MEASURING;
}

/* A part of measuring how far points may be moved; true: that was the last. Those before the last
 * four that were known have been measured. */
static bool measure(loft_plan *plan)
{
    const unsigned first = plan->known > 7 ? plan->known - 4u : 3,
                   from = first + plan->part * (MEASURED - 1), to = plan->count - 3u;

    if (from >= to)
        return true;
    loft_tube_measure(&plan->period, plan->knot, from, from + MEASURED < to ? from + MEASURED : to);
    plan->part++;
    return from + MEASURED >= to;
}

/* Fix what is far enough from the end. */
static void place(loft_plan *plan)
{
    const unsigned from = first_loose(plan);
    loft_knot *knot = plan->knot;

    if (plan->placed == 0)
        knot[0].is.pace.goal = 0;
    plan->placed = plan->ended ? plan->count : (uint16_t)(plan->count - SMOOTHING);
    loft_timing_load(&plan->period, knot, from > 3 ? from - 2 : 1, plan->placed - 2u);
    if (plan->ended)
        knot[plan->count - 2].is.pace.goal = knot[plan->count - 1].is.pace.goal = 0;
    plan->loaded = plan->count;
}


// Timing
// ------

static loft_timing timing_of(const loft_plan *plan)
{
    return (loft_timing){ .period = &plan->period,
                          .knot = plan->knot,
                          .from = plan->sure == 0 ? 1 : plan->sure + 2u,
                          .to = plan->ended ? plan->placed : plan->placed - 3u,
                          .end = plan->placed - 2u,
                          .open = !plan->ended };
}

/* A pace for knots that have none: a creep, or an even one of a chain that is known as a whole. */
static void creep(loft_plan *plan)
{
    const unsigned from = plan->timed, to = plan->placed;
    const loft_timing timing = timing_of(plan);
    const int32_t even = loft_timing_least(plan->knot, plan->count);
    int32_t b = plan->ended && from == 0 ? even - even / 32 : CREEP;

    for (;; b /= 2) {
        for (unsigned k = from; k < to; k++)
            plan->knot[k].is.pace.v2 = b;
        if (b < 256 || loft_timing_all_hold(&timing, from > 3 ? from - 2 : 1, timing.end))
            break;
    }
    plan->timed = (uint16_t)to;
}

static int64_t time_of(const loft_timing *t)
{
    int64_t sum = 0;
    for (unsigned k = t->from > 3 ? t->from - 2 : 1; k < t->end; k++)
        sum += loft_timing_time(t->knot, k);
    return sum;
}

/* The pace of the first knots that are raised. */
static int32_t first_pace(const loft_plan *plan, const loft_timing *timing)
{
    int32_t sum = 0;
    for (unsigned k = timing->from; k < timing->from + MARGIN && k < timing->end; k++)
        sum += plan->knot[k].is.pace.v2 / MARGIN;
    return sum;
}

/* One part of raising what is near the knots from `old` on; true: that was the last. Where it
 * changes the first ones of them, a ramp is longer, and those before hinder: then twice as many are
 * raised. */
static bool raise(loft_plan *plan)
{
    loft_timing timing = timing_of(plan);
    const unsigned from = timing.from;

    timing.from = plan->old > from + plan->near ? plan->old - (unsigned)plan->near : from;
    if (plan->sweep == 0 && plan->part == 0) {
        plan->first = first_pace(plan, &timing);
        plan->time = ALL ? time_of(&timing) : 0;
    }
    loft_timing_raise_part(&timing, plan->sweep * 3u, plan->part);
    plan->part++;
    if (plan->part < LOFT_TIMING_PARTS)
        return false;
    plan->part = 0;
    plan->sweep++;
    const int64_t now = ALL ? time_of(&timing) : 0, gain = plan->time - now;
    plan->time = now;
    if (plan->sweep < plan->sweeps && (!ALL || gain >= (now + gain) >> 10))
        return false;
    if (!ALL || timing.from <= from ||
        first_pace(plan, &timing) - plan->first <= plan->knot[timing.from].is.pace.v2 / 64)
        return true;
    plan->near = (uint16_t)(2 * plan->near);
    plan->sweep = 0;
    return false;
}

static void begin_raising(loft_plan *plan, unsigned sweeps)
{
    plan->old = plan->timed;
    creep(plan);
    plan->near = SETTLED;
    plan->sweep = plan->part = 0;
    plan->sweeps = (uint8_t)sweeps;
}

/* Where the whole chain is known and none of it has been used, its timing is a better guess than
 * the first one was: make its knots again. */
static bool refine(loft_plan *plan)
{
    if (!plan->ended || plan->known > 0 || plan->refined == REFINED ||
        !loft_guess_again(&plan->guess, plan->knot, plan->count))
        return false;
    plan->count = plan->placed = plan->timed = 0;
    plan->ended = false;
    plan->refined++;
    plan->stage = FILLING;
    return true;
}

/* All that was loaded is timed. */
static void finish_load(loft_plan *plan)
{
    const unsigned end = plan->placed - 2u;
    const unsigned look = plan->room - SMOOTHING - STEP - BEHIND;
    const unsigned sure = plan->ended ? end : end > look ? end - look : 0;
    if (sure > plan->sure)
        plan->sure = (uint16_t)sure;
    if (plan->at.knot == 0)
        plan->at.knot = 1;
    plan->stage = IDLE;
}

static bool is_all(const loft_plan *plan)
{
    return plan->ended && plan->timed == plan->count && plan->stage == IDLE;
}

/* A part of making more knots: places, smoothed and timed. */
static enum loft_path_state load(loft_plan *plan)
{
    enum loft_path_state state = LOFT_PATH_PLACE;
    const loft_timing timing = timing_of(plan);

    switch ((enum stage)plan->stage) {
    case IDLE:
        if (is_all(plan))
            return LOFT_PATH_END;
        forget(plan);
        plan->known = plan->loaded;
        plan->stage = FILLING;
        break;
    case FILLING:
        state = fill(plan);
        if (state == LOFT_PATH_WAIT || plan->count == 0)
            return state;
        if (state == LOFT_PATH_END)
            begin_smoothing(plan);
        break;
    case MEASURING:
        if (measure(plan))
            plan->stage = SMOOTHING_THEM;
        break;
    case SMOOTHING_THEM:
        if (first_loose(plan) + 3 < plan->count)
            loft_tube_smooth(&plan->period, plan->knot, first_loose(plan), plan->count - 3u,
                             AT_ONCE);
        plan->sweep = (uint8_t)(plan->sweep + AT_ONCE);
        if (plan->sweep >= SWEEPS)
            plan->stage = PLACING;
        break;
    case PLACING:
        place(plan);
        begin_raising(plan, RAISES * (plan->known > 0 ? 1u : plan->refined > 0 ? 2u : 4u));
        plan->stage = ALL ? RAISING : AIMING;
        break;
    case AIMING:
        loft_timing_aim(&timing);
        plan->stage = RAISING;
        break;
    case RAISING:
        if (raise(plan) && !refine(plan))
            finish_load(plan);
        break;
    }
    return LOFT_PATH_PLACE;
}

/* Is it time to make more knots, so that they are there when they are needed? */
static bool is_due(const loft_plan *plan)
{
    return plan->stage != IDLE || (!plan->ended && plan->at.knot > BEHIND + STEP / 2);
}


// Samples
// -------

/* Is all of it as good as straight? */
static bool is_straight(const loft_plan *plan)
{
    loft_coord leg[LOFT_AXES], all[LOFT_AXES] = { 0 };
    int64_t way = 0;

    for (unsigned k = 1; k < plan->count; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            leg[i] = loft_coord_sub(plan->knot[k].point.axis[i], plan->knot[k - 1].point.axis[i]);
            all[i] += leg[i] / 256;
        }
        way += loft_coord_length(leg);
    }
    return loft_coord_length(all) >= way / 256 - way / 16384;
}

/* Could all of it be faster by a 100th, as far as speed and acceleration are concerned? */
static bool has_spare(const loft_plan *plan)
{
    loft_period p = plan->period;
    bool has = !plan->emit.begun;

    for (int i = 0; i < LOFT_AXES; i++)
        p.jerk[i] = 0;
    for (unsigned k = 1; k < plan->sure && has; k++)
        has = plan->knot[k + 1].is.pace.v2 <
                  plan->knot[k].is.pace.top - plan->knot[k].is.pace.top / 8 &&
              loft_timing_holds(&p, plan->knot, k, 60);
    return has;
}

/* The time that is left comes to whole ticks: periods, and the last one, which has some more or
 * less; in bends a quarter of one more (a half with little effort), since timing does not look at
 * limits between its knots, and emit has no later points. Each is somewhat shorter, the more the
 * nearer to the end; in a chain of which none has been used all the same. On a line they may be
 * longer instead, where only the jerk is at its limit: spans are made to hold it. */
static void set_steps(loft_plan *plan)
{
    const uint32_t period = plan->period.ticks;
    loft_time left = -plan->at.time;

    for (unsigned k = plan->at.knot; k < plan->sure; k++)
        left += loft_sample_time(plan->knot, k);
    const bool straight = is_straight(plan);
    const loft_time more = !straight ? -BENDS : has_spare(plan) ? left / 100 : 0;
    const uint32_t least = (uint32_t)(((left - more) * period + LOFT_TIME_ONE - 1) / LOFT_TIME_ONE),
                   unit = 2 * period > LOFT_SPAN_TICKS_MAX ? period : 1,
                   n = least > 4 * period ? least + (unit - 1) - (least + unit - 1) % unit
                                          : 4 * period;

    plan->steps = (n - plan->period.last) / period + 1;
    plan->last = (uint16_t)(n - (plan->steps - 1) * period);
    plan->step = 0;
    plan->even = !plan->emit.begun || plan->steps < 8;
    plan->lag = n * (LOFT_TIME_ONE / period) - left;
}

static loft_time step_of(const loft_plan *plan)
{
    const int64_t n = plan->steps, i = plan->step;
    if (plan->steps == 0)
        return LOFT_TIME_ONE;
    if (plan->even)
        return LOFT_TIME_ONE - plan->lag / n;
    return LOFT_TIME_ONE - plan->lag / n * 6 * i / (n + 1) * i / (2 * n + 1);
}

/* With the feed of the way to the next knot. */
static bool add_sample(loft_plan *plan)
{
    const loft_knot *k = &plan->knot[plan->at.knot];
    loft_position p;

    loft_sample_place(&plan->at, plan->knot, &p);
    loft_emit_fold(&plan->emit, &k->is.on);
    loft_emit_add(&plan->emit, &p, k[1].is.on.feed, k->is.on.number);
    return true;
}

static bool add_end(loft_plan *plan)
{
    const loft_knot *last = &plan->knot[plan->count - 1];
    loft_emit_end(&plan->emit, &last->point, last->is.on.feed, plan->guess.path.chain.dropped,
                  plan->to, plan->last);
    return true;
}

/* One more sample; false: more knots are needed. */
static bool sample(loft_plan *plan)
{
    const bool all = is_all(plan);

    if (plan->sure == 0)
        return false;
    if (all && plan->steps == 0)
        set_steps(plan);
    if (!plan->emit.begun)
        return add_sample(plan);
    plan->step++;
    if (all && plan->step >= plan->steps)
        return add_end(plan);
    loft_sample next = plan->at;
    (void)loft_sample_pass(&next, plan->knot, plan->sure, step_of(plan));
    if (!all && next.knot >= plan->sure) {
        plan->step--;
        return false;
    }
    plan->at = next;
    return add_sample(plan);
}

static void begin(loft_plan *plan)
{
    loft_guess_begin(&plan->guess);
    plan->count = plan->loaded = plan->placed = plan->timed = plan->sure = 0;
    plan->ended = false;
    plan->stage = IDLE;
    plan->refined = 0;
    plan->at = (loft_sample){ 0, 0, 0 };
    plan->steps = plan->step = 0;
    loft_emit_begin(&plan->emit, &plan->period, plan->guess.path.chain.from);
}

/* A span of a slow run, which stands before a chain; true: that is it, or there is one to wait for.
 */
static bool cruise_on(loft_plan *plan, enum loft_plan_state *state, loft_span *out)
{
#if LOFT_FOLDS
    loft_chain *chain = &plan->guess.path.chain;

    if (plan->count > 0 || plan->emit.begun || chain->walked || plan->guess.path.over)
        return false;
    const enum loft_cruise_state now = loft_cruise_next(&plan->cruise, chain, out);
    if (now == LOFT_CRUISE_SPAN)
        plan->passed = chain->dropped;
    if (now == LOFT_CRUISE_SPAN && !plan->cruise.runs)
        loft_guess_begin(&plan->guess);         /* with the curves that are left */
    *state = now == LOFT_CRUISE_SPAN ? LOFT_PLAN_SPAN : LOFT_PLAN_WAIT;
    return now != LOFT_CRUISE_NONE;
#else
    (void)plan, (void)state, (void)out;
    return false;
#endif
}

/* Why there is no span. */
static enum loft_plan_state without_span(loft_plan *plan, enum loft_path_state state)
{
    if (state == LOFT_PATH_PLACE)
        return LOFT_PLAN_BUSY;
    if (state == LOFT_PATH_WAIT)
        return plan->guess.path.chain.count == 0 && plan->count == 0 ? LOFT_PLAN_REST
                                                                     : LOFT_PLAN_WAIT;
    begin(plan);
    plan->passed = plan->guess.path.chain.dropped;
    return plan->guess.path.chain.count > 0 ? LOFT_PLAN_BUSY : LOFT_PLAN_REST;
}

enum loft_plan_state loft_plan_part(loft_plan *plan, loft_span *out)
{
    enum loft_path_state state = !ALL && is_due(plan) ? load(plan) : LOFT_PATH_PLACE;
    bool loaded = !ALL && plan->stage != IDLE;

    for (;;) {
        enum loft_plan_state cruise;
        if (cruise_on(plan, &cruise, out))
            return cruise;
        if (loft_emit_next(&plan->emit, out)) {
            plan->passed = loft_emit_passed(&plan->emit);
            return LOFT_PLAN_SPAN;
        }
        if (plan->emit.ended) {
            begin(plan);
            continue;
        }
        if (sample(plan))
            continue;
        if (!loaded)
            state = load(plan);
        if (state != LOFT_PATH_PLACE || !ALL)
            return without_span(plan, state);
    }
}

enum loft_plan_state loft_plan_next(loft_plan *plan, loft_span *out)
{
    enum loft_plan_state state;

    do
        state = loft_plan_part(plan, out);
    while (state == LOFT_PLAN_BUSY);
    return state;
}

enum loft_status loft_plan_push(loft_plan *plan, const loft_move *move)
{
    return loft_chain_push(&plan->guess.path.chain, move);
}

void loft_plan_end(loft_plan *plan) { plan->guess.path.chain.ended = true; }

enum loft_status loft_plan_init(loft_plan *plan, const loft_limits *limits, loft_move moves[],
                                uint16_t move_room, loft_knot knots[], uint16_t knot_room)
{
    const enum loft_status status = loft_limits_check(limits);

    if (status != LOFT_OK)
        return status;
    if (move_room == 0 || knot_room < LOFT_PLAN_KNOTS_MIN)
        return LOFT_ERR_SPACE;
    loft_period_init(&plan->period, limits);
    loft_guess_init(&plan->guess, &plan->period, moves, move_room);
    plan->knot = knots;
    plan->room = knot_room;
    plan->passed = 0;
#if LOFT_FOLDS
    loft_cruise_init(&plan->cruise);
#endif
    begin(plan);
    return LOFT_OK;
}
