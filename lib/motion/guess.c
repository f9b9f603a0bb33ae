/* lib/motion/guess.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/guess.h"

#include "motion/barrier.h" /* loft_barrier_time */

#if LOFT_PLAN_EFFORT > 1

#define PERIOD      65536           /* of times */
#define SWEEPS          30
#define AHEAD       22              /* knots that the pace of one looks ahead */
#define BEHIND      16
#define ROUGH       6
#define STEPS       8               /* towards the least time */
#define WHOLE       12              /* periods before a sharp place that become whole */


// The pace
// --------

/* The last knots before an open end are not smooth yet. */
static void set_pace(loft_guess_round *g, const loft_period *period)
{
    const unsigned rough = g->ended || g->count <= 2 * ROUGH ? 0 : ROUGH, n = g->count - rough;

    loft_barrier_time(period, g->knot, n, g->timed, !g->ended, STEPS);
    for (unsigned k = n; k < g->count; k++)
        g->knot[k].is.pace.v2 = g->knot[n - 1].is.pace.v2;
    if (g->timed < 2)
        g->knot[0].is.pace.v2 = g->knot[1].is.pace.v2 = g->knot[2].is.pace.v2;
    g->knot[g->count - 1].is.pace.v2 = g->knot[g->count - 2].is.pace.v2;
}


// Knots
// -----

/* Knots that do not matter any more. */
static void forget(loft_guess_round *g)
{
    if (g->at <= BEHIND)
        return;
    const unsigned n = g->at - BEHIND;
    for (unsigned k = n; k < g->count; k++)
        g->knot[k - n] = g->knot[k];
    g->count  = (uint8_t)(g->count - n);
    g->loaded = (uint8_t)(g->loaded - n);
    g->placed = (uint8_t)(g->placed - n);
    g->timed  = (uint8_t)(g->timed - n);
    g->at -= n;
}

static void append(loft_guess_round *g, const loft_path_place *p)
{
    g->knot[g->count].is.on = *p;
    g->knot[g->count].point = p->at;
    g->count++;
}

/* The last knot stands for the rest behind the end; there are six at least. */
static void close_chain(loft_guess_round *g)
{
    loft_path_place first = g->knot[0].is.on, last = g->knot[g->count - 1].is.on;

    first.skip = last.skip = 0;
    while (g->placed == 0 && g->count < 5) {
        for (unsigned k = g->count; k > 0; k--)
            g->knot[k] = g->knot[k - 1];
        g->knot[0].is.on = first;
        g->count++;
    }
    append(g, &last);
    g->ended = true;
}

static bool has_room(const loft_guess_round *g) { return g->count + 1 < LOFT_GUESS_KNOTS; }

static void add_place(loft_guess_round *g, const loft_path_place *p)
{
    append(g, p);
    if (g->count == 1)
        append(g, p);
}

/* The knots before which places may be taken. */
static unsigned sure(const loft_guess_round *g)
{
    return g->ended ? g->count - 2u : g->count > AHEAD ? g->count - (unsigned)AHEAD : 0;
}

/* Smooth and time what is known. */
static void load(loft_guess_round *g, const loft_period *period)
{
    const unsigned known = g->loaded, from = g->placed < 3 ? 3 : g->placed;

    loft_tube_load(g->knot, known > 1 ? known - 1 : 1, g->count - 1u);
    loft_tube_tie(g->knot, g->count, g->placed == 0, g->ended);
    if (from + 3 < g->count) {
        loft_tube_measure(period, g->knot, from, g->count - 3u);
        loft_tube_smooth(period, g->knot, from, g->count - 3u, SWEEPS);
    }
    loft_timing_load(period, g->knot, from - 2, g->count - 2u);
    set_pace(g, period);
    g->loaded = g->count;
    g->placed = (uint8_t)(g->ended ? g->count : sure(g));
    g->timed  = (uint8_t)(g->placed < g->count ? g->placed : g->count);
    g->filling = false;
}


// Places
// ------

/* The time from the last place to knot k. */
static int64_t time_to(const loft_guess_round *g, unsigned k)
{
    int64_t time = -g->time;
    for (unsigned i = g->at; i < k; i++)
        time += loft_timing_time(g->knot, i);
    return time;
}

/* The next knot that is sharp or a tip, or the last that is sure. */
static unsigned next_sharp(const loft_guess_round *g, unsigned end)
{
    const loft_knot *at = g->knot;
    unsigned k = g->at + 1;
    while (k < end && !at[k].is.on.sharp &&
           !loft_path_turns_back(&at[k - 1].is.on, &at[k].is.on, &at[k + 1].is.on))
        k++;
    return k;
}

/* Whole periods to such a place. */
static int64_t step_of(const loft_guess_round *g, unsigned sharp, bool known)
{
    const int64_t left = time_to(g, sharp);
    if (!known || left >= WHOLE * PERIOD)
        return PERIOD;
    const int64_t n = (left + PERIOD * 6 / 10) / PERIOD;
    return n > 1 ? left / n : left;
}

/* The place that is `time` after knot `at`. */
static void place_at(const loft_guess_round *g, int64_t time, loft_position *out)
{
    const loft_path_place *at[4];
    const loft_knot *k = &g->knot[g->at];
    const int64_t whole = loft_timing_time(g->knot, g->at);
    const int64_t v0 = loft_coord_sqrt((uint64_t)((int64_t)k[0].is.pace.v2 + k[1].is.pace.v2) << 7),
                  v1 = loft_coord_sqrt((uint64_t)((int64_t)k[1].is.pace.v2 + k[2].is.pace.v2) << 7);
    const int64_t z = (v0 * time + (v1 - v0) * time / whole * time / 2) >> 8;   /* 2^-24 */

    loft_tube_places(g->knot, g->at - 1u, 4, at);
    loft_path_between(at, z < INT32_C(1) << 24 ? (int32_t)z : INT32_C(1) << 24, out);
}
/* sqrt(2 b 2^24 2^7) = 2^16 sqrt b */

/* Go on by `time`; never beyond knot `end`. */
static void pass(loft_guess_round *g, int64_t time, unsigned end)
{
    time += g->time;
    while (g->at < end && time >= loft_timing_time(g->knot, g->at)) {
        time -= loft_timing_time(g->knot, g->at);
        g->at++;
    }
    g->time = g->at < end ? (int32_t)time : 0;
}

static void place_here(const loft_guess_round *g, loft_position *out)
{
    if (g->time == 0)
        *out = g->knot[g->at].is.on.at;
    else
        place_at(g, g->time, out);
}

static void take(loft_guess_round *g, loft_path_place *out)
{
    const loft_path_place *p = &g->knot[g->at].is.on, *next = &g->knot[g->at + 1].is.on;

    place_here(g, &out->at);
    out->feed   = next->feed < p->feed ? next->feed : p->feed;
    out->number = p->number;
    out->skip   = p->skip > next->skip ? p->skip : next->skip;
    out->loose  = p->loose && next->loose;
    out->fold   = p->fold;
    out->sharp  = g->time == 0 && p->sharp;
}

/* The first place, or one a period behind the last. */
static void next_place(loft_guess_round *g, unsigned end)
{
    loft_guess_place *q = &g->queue[g->queued];

    if (!g->begun) {
        g->begun = true;
        take(g, &q->on);
        q[1] = q[0];
        for (int n = 0; n < 3; n++)
            q[0].inner[n] = q[0].on.at;
        g->queued = 2;
        return;
    }
    const unsigned sharp = next_sharp(g, end);
    const int64_t step = step_of(g, sharp, sharp < end || g->ended);
    int64_t gone = 0;
    bool to_sharp = time_to(g, sharp) <= step && (sharp < end || g->ended);
    uint16_t skip = 0;
    loft_coord feed = g->knot[g->at].is.on.feed;
    bool loose = g->knot[g->at].is.on.loose;

    for (int n = 0; n < 3; n++) {
        pass(g, step * (n + 1) / 4 - gone, end);
        gone = step * (n + 1) / 4;
        place_here(g, &q[-1].inner[n]);
        skip = g->knot[g->at].is.on.skip > skip ? g->knot[g->at].is.on.skip : skip;
        feed = g->knot[g->at].is.on.feed < feed ? g->knot[g->at].is.on.feed : feed;
        loose = loose && g->knot[g->at].is.on.loose;
    }
    pass(g, step - gone, end);
    if (to_sharp) {
        g->at = sharp;
        g->time = 0;
    }
    take(g, &q->on);
    q->on.feed = q->on.feed < feed ? q->on.feed : feed;
    q[-1].on.skip = q[-1].on.skip > skip ? q[-1].on.skip : skip;
    q[-1].on.loose = q[-1].on.loose && loose;
    g->queued++;
    g->arrived = g->ended && g->at == end;
}

/* Does the window end too soon for whole periods? Then more is loaded, if there is room for more.
 */
static bool wants_more(const loft_guess_round *g)
{
    if (g->count == 0)
        return true;
    return !g->ended && time_to(g, sure(g)) <= (WHOLE + 1) * PERIOD &&
           (g->at > BEHIND || has_room(g));
}

/* The first place of the queue, behind one more. */
static void pop_place(loft_guess_round *g, loft_path_place *out)
{
    const unsigned n = g->queued;
    const loft_path_place *at[4];
    loft_coord off = 0;

    for (unsigned k = 0; k < 4; k++)
        at[k] = &g->queue[k < n ? k : n - 1].on;
    for (int k = 0; k < 3 && n > 2; k++) {
        const int32_t quarter = (int32_t)(k + 1) * (INT32_C(1) << 22);
        off = loft_coord_most(off, loft_path_off(at, quarter, &g->queue[1].inner[k]));
    }
    *out = g->queue[1].on;
    loft_path_set_skip(out, n > 2 ? loft_path_skip(out) + off : 0);
    g->queued--;
    for (unsigned k = 0; k < g->queued; k++)
        g->queue[k] = g->queue[k + 1];
}

/* The next place; LOFT_PATH_WAIT: places are missing. */
static enum loft_path_state round_next(loft_guess_round *g, const loft_period *period,
                                       loft_path_place *out)
{
    while (g->queued < LOFT_GUESS_QUEUE && !g->arrived) {
        if (!g->filling && wants_more(g)) {
            forget(g);
            g->filling = true;
        }
        if (g->filling && !g->ended && has_room(g))
            return LOFT_PATH_WAIT;
        if (g->filling)
            load(g, period);
        next_place(g, sure(g));
    }
    if (g->queued < 2)
        return LOFT_PATH_END;
    pop_place(g, out);
    return LOFT_PATH_PLACE;
}

/* No place comes any more. */
static void round_end(loft_guess_round *g)
{
    g->ended = true;
    g->arrived = g->count == 0;
    if (g->count > 0)
        close_chain(g);
}

enum loft_path_state loft_guess_next(loft_guess *guess, loft_path_place *out)
{
    for (int r = LOFT_GUESS_ROUNDS - 1;;) {
        const enum loft_path_state state = r < 0 ? loft_path_next(&guess->path, out)
                                                 : round_next(&guess->round[r], guess->period, out);
        if (r < 0 && state == LOFT_PATH_WAIT)
            return state;
        if (state == LOFT_PATH_WAIT) {
            r--;
            continue;
        }
        if (++r == LOFT_GUESS_ROUNDS)
            return state;
        if (state == LOFT_PATH_END)
            round_end(&guess->round[r]);
        else
            add_place(&guess->round[r], out);
    }
}

static void round_begin(loft_guess_round *g)
{
    g->count = g->loaded = g->placed = g->timed = g->queued = 0;
    g->at = 1;
    g->time = 0;
    g->begun = g->filling = g->ended = g->arrived = false;
}

void loft_guess_begin(loft_guess *guess)
{
    loft_path_begin(&guess->path);
    for (int r = 0; r < LOFT_GUESS_ROUNDS; r++)
        round_begin(&guess->round[r]);
}

bool loft_guess_again(loft_guess *guess, const loft_knot knots[], unsigned count)
{
    loft_guess_round *g = &guess->round[LOFT_GUESS_ROUNDS - 1];

    if (count > LOFT_GUESS_KNOTS)
        return false;
    round_begin(g);
    for (unsigned k = 0; k < count; k++)
        g->knot[k] = knots[k];
    g->count = g->loaded = g->placed = g->timed = (uint8_t)count;
    g->ended = true;
    return true;
}

#else

enum loft_path_state loft_guess_next(loft_guess *guess, loft_path_place *out)
{
    return loft_path_next(&guess->path, out);
}

void loft_guess_begin(loft_guess *guess) { loft_path_begin(&guess->path); }

bool loft_guess_again(loft_guess *guess, const loft_knot knots[], unsigned count)
{
    (void)guess, (void)knots, (void)count;
    return false;
}

#endif

void loft_guess_init(loft_guess *guess, const loft_period *period, loft_move moves[], uint16_t room)
{
    guess->period = period;
    loft_path_init(&guess->path, period, moves, room);
    loft_guess_begin(guess);
}
