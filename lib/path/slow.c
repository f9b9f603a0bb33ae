/* lib/path/slow.c
 * SPDX-License-Identifier: MIT
 *
 * Places of the path are a period apart in time, since its smooth path and its pace are found
 * from knots at such places. So planning costs what the motion lasts. That is well spent where the
 * feed is not reached, or is not held: for launches, corners and bends. Where the machine is that
 * much faster than the feed that nothing of it matters, all is known before: the motion follows
 * the given curve, at the feed.
 *
 * A curve is slow if, with h a period, v its feed, k its curvature, and a, j what an axis allows:
 *
 *   - v is reached from rest within 6 periods, with half of the limits: speed rises along a
 *     parabola for 3 h and along its mirror for 3 h more, so v h <= 4.5 j h^3, 3/2 a h^2
 *   - v^2 k <= a / 256, j h t / 4 with t a tick: so it does not matter that spans, which have the
 *     places and velocities of the curve at their ends, do not have its acceleration, and neither
 *     does its start
 *   - it lasts 8 periods, for a change of velocity at each end and spans between
 *
 * and between two of them velocity may change by w in 6 periods, around the joint: this leaves it
 * by w h / 2, at most tol / 8. Otherwise the run ends there, at rest. A run lasts at least RUN
 * periods, so that the rests before and behind it, which take 6 periods, are less than a 600th.
 *
 * A span turns by at most 1/8, so a cubic with the places and directions of the curve at its ends
 * is off by less than l (1/8)^3 / 384 of its length l.
 */
#include "path/slow.h"

#if LOFT_FOLDS

#define DUST        4                               /* arcs that are no longer are nothing */
#define RUN         4096                            /* periods */
#define TICKS_MAX   1023                            /* of a span */
#define WAY_MAX     ((int64_t)LOFT_COORD_MM * 32)   /* of a span */
#define LENGTH_MAX  ((int64_t)1 << 41)
#define ONE         65536                           /* of directions */
#define EIGHTH      (ONE / 8)
#define FLAT        256                             /* of acceleration, that does not matter */


// Walks
// -----

void loft_slow_begin(loft_slow_walk *w, const loft_cubic *curve)
{
    w->curve = curve;
    w->to = 0;
    w->s = 0;
    w->length = 0;
}

/* Go to the next arc; false: there is none. */
static bool advance(loft_slow_walk *w)
{
    loft_arc arc;
    uint32_t to = w->to;

    while (to < LOFT_ARC_WHOLE) {
        to = loft_arc_next(&arc, w->curve, to);
        const loft_coord length = loft_coord_of(arc.length);
        if (arc.dust || length < DUST)
            continue;
        w->arc = arc;
        w->to = to;
        w->s += w->length;
        w->length = length;
        return true;
    }
    return false;
}

void loft_slow_go(loft_slow_walk *w, int64_t s)
{
    while (s > w->s + w->length && advance(w))
        ;
}

static void set_heading(const loft_vec *u, int32_t out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = loft_raw_from_real(u->axis[i]);
}

void loft_slow_place(const loft_slow_walk *w, int64_t s, loft_position *out,
                     int32_t heading[LOFT_AXES])
{
    const int64_t off = s - w->s;
    const loft_acc at = loft_coord_to_acc(off < w->length ? off : w->length);
    loft_acc place[LOFT_AXES];
    loft_vec u;

    loft_arc_eval(&w->arc, at, place);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_coord_of(place[i]);
    loft_arc_heading(&w->arc, at, &u);
    set_heading(&u, heading);
}


// What is slow
// ------------

/* The most change of velocity of an axis in 6 periods, in a period. */
static int64_t most_change(const loft_period *p, int i)
{
    const int64_t by_jerk = 9 * (int64_t)p->jerk[i] / 2, by_accel = 3 * (int64_t)p->accel[i] / 2;
    return by_jerk < by_accel ? by_jerk : by_accel;
}

/* May the velocity change so much? */
static bool is_held(const loft_period *p, const int64_t change[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (loft_long_abs(change[i]) * p->ticks >> LOFT_SLOW_BITS > most_change(p, i))
            return false;
    return true;
}

/* The most acceleration of a bend, in a period. */
static int64_t most_bend(const loft_period *p)
{
    int64_t most = INT64_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t a = p->accel[i] / FLAT, j = p->jerk[i] / (4 * p->ticks);
        most = a < most ? a : most;
        most = j < most ? j : most;
    }
    return most;
}

static int64_t turn_of(const int32_t a[], const int32_t b[])
{
    uint64_t sum = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        sum += (uint64_t)(((int64_t)b[i] - a[i]) * ((int64_t)b[i] - a[i]));
    return loft_coord_sqrt(sum);
}

/* Does this arc hold what a slow curve has to, with v in a period? Then its end becomes that of the
 * curve, and `way` the longest of a span. */
static bool arc_holds(const loft_period *p, const loft_slow_walk *w, int64_t v,
                      loft_slow_curve *out, int64_t *way)
{
    int32_t u[3][LOFT_AXES];

    for (unsigned n = 0; n < 3; n++) {
        loft_vec to;
        loft_arc_direction(&w->arc, n, &to);
        set_heading(&to, u[n]);
        for (int i = 0; i < LOFT_AXES; i++)
            if (v * loft_long_abs(u[n][i]) / ONE + 2 * LOFT_COORD_GRAIN > p->speed[i])
                return false;
    }
    const int64_t a = turn_of(u[0], u[1]), b = turn_of(u[1], u[2]), turn = 2 * (a > b ? a : b),
                  most = (int64_t)w->length * EIGHTH, joint = w->s > 0 ? turn_of(out->to, u[0]) : 0;
    if ((v * turn / ONE) * v > w->length * most_bend(p) || v * joint / ONE > LOFT_COORD_GRAIN / 8)
        return false;
    if (turn * *way > most)
        *way = most / turn;
    for (int i = 0; i < LOFT_AXES; i++) {
        out->from[i] = w->s > 0 ? out->from[i] : u[0][i];
        out->to[i] = u[2][i];
    }
    return true;
}

static void set_change(const loft_slow_curve *c, const int32_t u[], int64_t out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = c->speed * u[i] / ONE;
}

/* Set how long it takes at a feed of v units in hz ticks. */
static bool set_ticks(const loft_period *p, int64_t v, int64_t way, loft_slow_curve *out)
{
    const int64_t n = (out->length * p->tick_hz + v - 1) / v;
    int64_t from[LOFT_AXES], to[LOFT_AXES];

    if (n < (2 * LOFT_SLOW_TURN + LOFT_SLOW_SPAN) * p->ticks || n > INT32_MAX)
        return false;
    out->ticks = (uint32_t)n;
    out->speed = (out->length << LOFT_SLOW_BITS) / n;
    const int64_t longest = (way << LOFT_SLOW_BITS) / (out->speed + 1);
    out->longest = (uint16_t)(longest < TICKS_MAX ? longest : TICKS_MAX);
    set_change(out, out->from, from);
    set_change(out, out->to, to);
    return out->longest >= 2 * LOFT_SLOW_SPAN * p->ticks && is_held(p, from) && is_held(p, to);
}

bool loft_slow_measure(const loft_chain *chain, unsigned i, loft_slow_curve *out)
{
    const loft_move *move = loft_chain_move(chain, i);
    const loft_period *p = chain->period;
    const int64_t v = loft_period_speed(p, move->feed);
    int64_t most = 0, way = WAY_MAX;
    loft_slow_walk w;

    for (int n = 0; n < LOFT_AXES; n++)
        most += most_change(p, n);
    if (v > most || TICKS_MAX < 2 * LOFT_SLOW_SPAN * p->ticks)
        return false;
    loft_slow_begin(&w, &move->curve);
    while (advance(&w))
        if (w.s > LENGTH_MAX || !arc_holds(p, &w, v, out, &way))
            return false;
    out->length = w.s + w.length;
    return set_ticks(p, (int64_t)loft_raw_from_real(move->feed) << (LOFT_COORD_BITS - 16), way,
                     out);
}


// Runs
// ----

bool loft_slow_turns(const loft_period *p, const loft_slow_curve *before,
                     const loft_slow_curve *after, int64_t out[LOFT_AXES])
{
    const int64_t most = (int64_t)LOFT_COORD_GRAIN / 8 << LOFT_SLOW_BITS;
    int64_t from[LOFT_AXES];
    bool turns = false;

    set_change(before, before->to, from);
    set_change(after, after->from, out);
    for (int i = 0; i < LOFT_AXES; i++) {
        out[i] -= from[i];
        turns = turns || loft_long_abs(out[i]) * p->ticks > most;
    }
    return turns;
}

bool loft_slow_goes_on(const loft_period *p, const loft_slow_curve *before,
                       const loft_slow_curve *after)
{
    int64_t change[LOFT_AXES];
    loft_coord in_period[LOFT_AXES];

    if (!loft_slow_turns(p, before, after, change))
        return true;
    if (!is_held(p, change))
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t x = change[i] * p->ticks >> LOFT_SLOW_BITS;
        if (loft_long_abs(x) > p->tol / 4)
            return false;
        in_period[i] = (loft_coord)x;
    }
    return loft_coord_length(in_period) <= p->tol / 4;
}

enum run { NONE, BEGINS, OPEN };

/* Does a run begin with curve k? If not, none begins before curve `*next`. OPEN: that depends on
 * what comes. */
static enum run run_at(const loft_chain *chain, unsigned k, unsigned *next)
{
    const int64_t least = RUN * (int64_t)chain->period->ticks;
    loft_slow_curve before, c;
    int64_t ticks = 0;

    for (unsigned i = k; i < chain->count; i++) {
        if (!loft_slow_measure(chain, i, &c) ||
            (i > k && !loft_slow_goes_on(chain->period, &before, &c))) {
            *next = i > k ? i : i + 1;
            return NONE;
        }
        ticks += c.ticks;
        if (ticks >= least)
            return BEGINS;
        before = c;
    }
    *next = chain->count;
    return chain->ended || chain->count == chain->room ? NONE : OPEN;
}

void loft_slow_look(loft_chain *chain)
{
    while (chain->known < chain->count && !chain->stops) {
        unsigned next;
        const enum run run = run_at(chain, chain->known, &next);
        if (run == OPEN)
            return;
        if (run == BEGINS)
            chain->stops = true;
        else
            chain->known = (uint16_t)next;
    }
}

#endif
