/* lib/motion/trajectory.c
 * SPDX-License-Identifier: MIT
 *
 *     0 ... at ... sure .......... timed ... placed ......... count
 *      passed | never  |   may be    |  smooth,  |  may still  |
 *             | changes|   raised    |  no pace  |   move      |
 */
#include "motion/trajectory.h"

#define BEHIND      4
#define SMOOTHING   24      /* knots whose points may still move */
#define ALL         (LOFT_TRAJECTORY_EFFORT > 1)
#define STEP        (ALL ? 20 : 32)     /* knots at a time, and what they need on both sides */
#define SWEEPS      60      /* of smoothing */
#define AT_ONCE     (ALL ? SWEEPS : 6)  /* of them in a part */
#define RAISES      (ALL ? 4 : 1)       /* of a whole chain 4 times as many */
#define REFINED     (ALL ? 2 : 0)
#define SETTLED     64      /* knots before new ones that are raised again */
#define MARGIN      4       /* of them, by which is seen if ones before hinder */
#define CREEP       (LOFT_V2_ONE / 1024)

/* --- knots ---------------------------------------------------------------------------------------
 */

static void forget(loft_trajectory *t)
{
    if (t->at.knot <= BEHIND)
        return;
    const unsigned n = t->at.knot - BEHIND;
    for (unsigned k = n; k < t->count; k++)
        t->knot[k - n] = t->knot[k];
    t->count  = (uint16_t)(t->count - n);
    t->loaded = (uint16_t)(t->loaded - n);
    t->placed = (uint16_t)(t->placed - n);
    t->timed  = (uint16_t)(t->timed - n);
    t->sure   = (uint16_t)(t->sure - n);
    t->at.knot -= n;
}

static void append(loft_trajectory *t, const loft_path_place *p)
{
    loft_knot *k = &t->knot[t->count++];
    k->on = *p;
    k->point = p->at;
    k->v2 = k->goal = 0;
}

/* Control points of three knots are at the start, and at the end. The third place is near it. */
static bool is_far(const loft_trajectory *t, const loft_path_place *a, const loft_path_place *b)
{
    loft_coord off[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        off[i] = loft_coord_sub(a->at.axis[i], b->at.axis[i]);
    return loft_coord_length(off) > t->period.tol / 2;
}

/* The last knot stands for the rest behind the end; there are seven at least. */
static void close_chain(loft_trajectory *t)
{
    loft_path_place first = t->knot[0].on, last = t->knot[t->count - 1].on;

    first.skip = last.skip = 0;
    while (t->placed == 0 && t->count < 6) {
        for (unsigned k = t->count; k > 0; k--)
            t->knot[k] = t->knot[k - 1];
        t->knot[0].on = first;
        t->count++;
    }
    if (is_far(t, &t->knot[t->count - 2].on, &last))
        append(t, &last);
    append(t, &last);
    t->ended = true;
    t->to = t->guess.path.end;
}

static void append_start(loft_trajectory *t)
{
    loft_path_place first = t->knot[0].on;

    t->knot[0].on.skip = t->knot[1].on.skip = 0;
    append(t, &first);
}

static enum loft_path_state next_place(loft_trajectory *t, loft_path_place *out)
{
    return ALL ? loft_guess_next(&t->guess, out) : loft_path_next(&t->guess.path, out);
}

/* One more knot; the chain ends, or there is no room: LOFT_PATH_END. */
static enum loft_path_state fill(loft_trajectory *t)
{
    loft_path_place p;

    if (t->ended || t->count + 2 >= t->room)
        return LOFT_PATH_END;
    const enum loft_path_state state = next_place(t, &p);
    if (state == LOFT_PATH_END && t->count > 0)
        close_chain(t);
    if (state != LOFT_PATH_PLACE)
        return state;
    if (t->count == 2 && is_far(t, &t->knot[1].on, &p))
        append_start(t);
    append(t, &p);
    if (t->count == 1)
        append(t, &p);
    return LOFT_PATH_PLACE;
}

/* Where smoothing begins. */
static unsigned first_loose(const loft_trajectory *t) { return t->placed < 3 ? 3 : t->placed; }

static void begin_smoothing(loft_trajectory *t)
{
    const unsigned from = first_loose(t);

    loft_tube_load(t->knot, t->known > 1 ? t->known - 1u : 1, t->count - 1u);
    for (int k = 0; k < 3 && t->placed == 0; k++)
        t->knot[k].point = t->knot[0].on.at;
    for (unsigned k = 1; k <= 3 && t->ended; k++)
        t->knot[t->count - k].point = t->knot[t->count - 1].on.at;
    if (from + 3 < t->count)
        loft_tube_measure(&t->period, t->knot, from, t->count - 3u);
}

/* Fix what is far enough from the end. */
static void place(loft_trajectory *t)
{
    const unsigned from = first_loose(t);

    t->placed = t->ended ? t->count : (uint16_t)(t->count - SMOOTHING);
    loft_timing_load(&t->period, t->knot, from > 3 ? from - 2 : 1, t->placed - 2u);
    t->loaded = t->count;
}

/* --- timing --------------------------------------------------------------------------------------
 */

static loft_timing timing_of(const loft_trajectory *t)
{
    const loft_timing timing = { .period = &t->period,
        .knot = t->knot,
        .from = t->sure == 0 ? 1 : t->sure + 2u,
        .to   = t->ended ? t->placed : t->placed - 3u,
        .end  = t->placed - 2u,
                                 .open = !t->ended };
    return timing;
}

/* The even pace that all limits allow from knot to knot. */
static int32_t evenly(const loft_trajectory *t)
{
    int32_t b = LOFT_V2_ONE;

    for (unsigned k = 1; k + 2 < t->count; k++)
        b = t->knot[k].goal < b ? t->knot[k].goal : b;
    return b - b / 32;
}

/* A pace for knots that have none: a creep, or, where the chain is known as a whole, an even one.
 */
static void creep(loft_trajectory *t)
{
    const unsigned from = t->timed, to = t->placed;
    const loft_timing timing = timing_of(t);
    int32_t b = t->ended && from == 0 ? evenly(t) : CREEP;

    for (;; b /= 2) {
        for (unsigned k = from; k < to; k++)
            t->knot[k].v2 = b;
        if (b < 256 || loft_timing_all_hold(&timing, from > 3 ? from - 2 : 1, timing.end))
            break;
    }
    t->timed = (uint16_t)to;
}

static int64_t time_of(const loft_timing *t)
{
    int64_t sum = 0;
    for (unsigned k = t->from > 3 ? t->from - 2 : 1; k < t->end; k++)
        sum += loft_timing_time(t->knot, k);
    return sum;
}

/* The pace of the first knots that are raised. */
static int32_t first_pace(const loft_trajectory *t, const loft_timing *timing)
{
    int32_t sum = 0;
    for (unsigned k = timing->from; k < timing->from + MARGIN && k < timing->end; k++)
        sum += t->knot[k].v2 / MARGIN;
    return sum;
}

/* One part of raising what is near the knots from `old` on; true: that was the last. Where it
 * changes the first ones of them, a ramp is longer, and those before hinder: then twice as many are
 * raised. */
static bool raise(loft_trajectory *t)
{
    loft_timing timing = timing_of(t);
    const unsigned from = timing.from;

    timing.from = t->old > from + t->near ? t->old - (unsigned)t->near : from;
    if (t->sweep == 0 && t->part == 0) {
        t->first = first_pace(t, &timing);
        t->time = ALL ? time_of(&timing) : 0;
    }
    loft_timing_raise_part(&timing, t->sweep * 3u, t->part);
    t->part++;
    if (t->part < LOFT_TIMING_PARTS)
        return false;
    t->part = 0;
    t->sweep++;
    const int64_t now = ALL ? time_of(&timing) : 0, gain = t->time - now;
    t->time = now;
    if (t->sweep < t->sweeps && (!ALL || gain >= (now + gain) >> 10))
        return false;
    if (!ALL || timing.from <= from ||
        first_pace(t, &timing) - t->first <= t->knot[timing.from].v2 / 64)
        return true;
    t->near = (uint16_t)(2 * t->near);
    t->sweep = 0;
    return false;
}

enum stage { IDLE, FILLING, SMOOTHING_THEM, PLACING, RAISING };

static void begin_raising(loft_trajectory *t, unsigned sweeps)
{
    t->old = t->timed;
    creep(t);
    t->near = SETTLED;
    t->sweep = t->part = 0;
    t->sweeps = (uint8_t)sweeps;
}

static void time_knots(loft_trajectory *t, unsigned sweeps)
{
    begin_smoothing(t);
    if (first_loose(t) + 3 < t->count)
        loft_tube_smooth(t->knot, first_loose(t), t->count - 3u, SWEEPS);
    place(t);
    begin_raising(t, sweeps);
    while (!raise(t)) {
    }
}

/* The whole chain is known and none of it has been used: its timing is a better guess than the
 * first one was. */
static void refine(loft_trajectory *t)
{
    for (int n = 0; n < REFINED && t->ended; n++) {
        if (!loft_guess_again(&t->guess, t->knot, t->count))
            break;
        t->count = t->placed = t->timed = t->known = 0;
        t->ended = false;
        while (fill(t) == LOFT_PATH_PLACE) {
        }
        time_knots(t, 2 * RAISES);
    }
}

/* All that was loaded is timed. */
static void finish_load(loft_trajectory *t)
{
    if (t->ended && t->known == 0)
        refine(t);
    const unsigned end = t->placed - 2u;
    const unsigned look = t->room - SMOOTHING - STEP - BEHIND;
    const unsigned sure = t->ended ? end : end > look ? end - look : 0;
    if (sure > t->sure)
        t->sure = (uint16_t)sure;
    if (t->at.knot == 0)
        t->at.knot = 1;
    t->stage = IDLE;
}

static bool is_all(const loft_trajectory *t)
{
    return t->ended && t->timed == t->count && t->stage == IDLE;
}

/* A part of making more knots: places, smoothed and timed. */
static enum loft_path_state load(loft_trajectory *t)
{
    enum loft_path_state state = LOFT_PATH_PLACE;

    switch ((enum stage)t->stage) {
    case IDLE:
        if (is_all(t))
            return LOFT_PATH_END;
        forget(t);
        t->known = t->loaded;
        t->stage = FILLING;
        break;
    case FILLING:
        state = fill(t);
        if (state == LOFT_PATH_WAIT || t->count == 0)
            return state;
        if (state == LOFT_PATH_END) {
            begin_smoothing(t);
            t->sweep = 0;
            t->stage = SMOOTHING_THEM;
        }
        break;
    case SMOOTHING_THEM:
        if (first_loose(t) + 3 < t->count)
            loft_tube_smooth(t->knot, first_loose(t), t->count - 3u, AT_ONCE);
        t->sweep = (uint8_t)(t->sweep + AT_ONCE);
        if (t->sweep >= SWEEPS)
            t->stage = PLACING;
        break;
    case PLACING:
        place(t);
        begin_raising(t, t->known == 0 ? 4 * RAISES : RAISES);
        t->stage = RAISING;
        break;
    case RAISING:
        if (raise(t))
            finish_load(t);
        break;
    }
    return LOFT_PATH_PLACE;
}

/* Is it time to make more knots, so that they are there when they are needed? */
static bool is_due(const loft_trajectory *t)
{
    return t->stage != IDLE || (!t->ended && t->at.knot > BEHIND + STEP / 2);
}

/* --- samples -------------------------------------------------------------------------------------
 */

/* Is all of it as good as straight? */
static bool is_straight(const loft_trajectory *t)
{
    loft_coord leg[LOFT_AXES], all[LOFT_AXES] = { 0 };
    int64_t way = 0;

    for (unsigned k = 1; k < t->count; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            leg[i] = loft_coord_sub(t->knot[k].point.axis[i], t->knot[k - 1].point.axis[i]);
            all[i] += leg[i] / 256;
        }
        way += loft_coord_length(leg);
    }
    return loft_coord_length(all) >= way / 256 - way / 16384;
}

/* Could all of it be faster by a 100th, as far as speed and acceleration are concerned? */
static bool has_spare(const loft_trajectory *t)
{
    loft_period p = t->period;
    bool has = !t->emit.begun && is_straight(t);

    for (int i = 0; i < LOFT_AXES; i++)
        p.jerk[i] = 0;
    for (unsigned k = 1; k < t->sure && has; k++)
        has = t->knot[k + 1].v2 < t->knot[k].top - t->knot[k].top / 8 &&
              loft_timing_holds(&p, t->knot, k, 60);
    return has;
}

/* The time that is left comes to a whole number of samples, each somewhat shorter, the more the
 * nearer to the end; in a chain of which none has been used all the same. On a line they may be
 * longer instead, where only the jerk is at its limit: spans are made to hold it. */
static void set_steps(loft_trajectory *t)
{
    loft_time left = -t->at.time;
    for (unsigned k = t->at.knot; k < t->sure; k++)
        left += loft_sample_time(t->knot, k);
    const loft_time more = has_spare(t) ? left / 100 : 0;
    const uint32_t n = (uint32_t)((left - more + LOFT_TIME_ONE - 1) / LOFT_TIME_ONE);

    t->steps = n > 4 ? n : 4;
    t->step = 0;
    t->even = !t->emit.begun || t->steps < 8;
    t->lag = (loft_time)t->steps * LOFT_TIME_ONE - left;
}

static loft_time step_of(const loft_trajectory *t)
{
    const int64_t n = t->steps, i = t->step;
    if (t->steps == 0)
        return LOFT_TIME_ONE;
    if (t->even)
        return LOFT_TIME_ONE - t->lag / n;
    return LOFT_TIME_ONE - t->lag / n * 6 * i / (n + 1) * i / (2 * n + 1);
}

/* The largest feed around a sample. */
static loft_coord feed_of(const loft_trajectory *t)
{
    const loft_knot *k = &t->knot[t->at.knot];
    return k[0].on.feed > k[1].on.feed ? k[0].on.feed : k[1].on.feed;
}

static void add_sample(loft_trajectory *t)
{
    loft_position p;

    loft_sample_place(&t->at, t->knot, &p);
    loft_emit_add(&t->emit, &p, feed_of(t), t->knot[t->at.knot].on.number);
}

static void add_end(loft_trajectory *t)
{
    const loft_knot *last = &t->knot[t->count - 1];
    loft_emit_add(&t->emit, &last->point, last->on.feed, t->guess.path.dropped);
    loft_emit_end(&t->emit, t->to);
}

/* Does a sample fit before `sure`? */
static bool step_fits(const loft_trajectory *t, loft_time step)
{
    loft_time left = -t->at.time;
    for (unsigned k = t->at.knot; k < t->sure && left <= step; k++)
        left += loft_sample_time(t->knot, k);
    return left > step;
}

/* One more sample; false: more knots are needed. */
static bool sample(loft_trajectory *t)
{
    const bool all = is_all(t);

    if (t->sure == 0)
        return false;
    if (all && t->steps == 0)
        set_steps(t);
    if (!t->emit.begun) {
        add_sample(t);
        return true;
    }
    t->step++;
    const loft_time step = step_of(t);
    if (all && t->step >= t->steps) {
        add_end(t);
        return true;
    }
    if (!all && !step_fits(t, step)) {
        t->step--;
        return false;
    }
    (void)loft_sample_pass(&t->at, t->knot, t->sure, step);
    add_sample(t);
    return true;
}

static void begin(loft_trajectory *t)
{
    loft_guess_begin(&t->guess);
    t->count = t->loaded = t->placed = t->timed = t->sure = 0;
    t->ended = false;
    t->stage = IDLE;
    t->at = (loft_sample){ 0, 0 };
    t->steps = t->step = 0;
    loft_emit_begin(&t->emit, &t->period, t->guess.path.from);
}

/* Why there is no span. */
static enum loft_trajectory_state without_span(loft_trajectory *t, enum loft_path_state state)
{
    if (state == LOFT_PATH_PLACE)
        return LOFT_TRAJECTORY_BUSY;
    if (state == LOFT_PATH_WAIT)
        return t->guess.path.count == 0 && t->count == 0 ? LOFT_TRAJECTORY_REST
                                                         : LOFT_TRAJECTORY_WAIT;
    begin(t);
    t->passed = t->guess.path.dropped;
    return LOFT_TRAJECTORY_REST;
}

enum loft_trajectory_state loft_trajectory_next(loft_trajectory *t, loft_span *out)
{
    enum loft_path_state state = !ALL && is_due(t) ? load(t) : LOFT_PATH_PLACE;
    bool loaded = !ALL && t->stage != IDLE;

    for (;;) {
        if (loft_emit_next(&t->emit, out)) {
            t->passed = loft_emit_passed(&t->emit);
            return LOFT_TRAJECTORY_SPAN;
        }
        if (t->emit.ended)
            begin(t);
        if (t->count == 0)
            loft_emit_begin(&t->emit, &t->period, t->guess.path.from);
        if (sample(t))
            continue;
        if (!loaded)
            state = load(t);
        if (state != LOFT_PATH_PLACE || !ALL)
            return without_span(t, state);
    }
}

enum loft_status loft_trajectory_push(loft_trajectory *t, const loft_move *move)
{
    return loft_path_push(&t->guess.path, move);
}

void loft_trajectory_end(loft_trajectory *t) { t->guess.path.ended = true; }

enum loft_status loft_trajectory_init(loft_trajectory *t, const loft_limits *limits,
                                      loft_move moves[], uint16_t move_room, loft_knot knots[],
                                      uint16_t knot_room)
{
    const enum loft_status status = loft_limits_check(limits);

    if (status != LOFT_OK)
        return status;
    if (move_room == 0 || knot_room < LOFT_TRAJECTORY_KNOTS_MIN)
        return LOFT_ERR_SPACE;
    loft_period_init(&t->period, limits);
    loft_guess_init(&t->guess, &t->period, moves, move_room);
    t->knot = knots;
    t->room = knot_room;
    t->passed = 0;
    begin(t);
    return LOFT_OK;
}
