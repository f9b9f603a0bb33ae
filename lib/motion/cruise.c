/* lib/motion/cruise.c
 * SPDX-License-Identifier: MIT
 *
 * Where the velocity changes by w, from rest or to it, or at a joint, that takes two spans of m
 * ticks. With va before and vb behind, in the first velocity is va + w / 2 (t / m)^2, and in the
 * second it is the mirror of that. So acceleration is at most w / m, jerk is w / m^2, and the way
 * from A to B is (va + vb) m, as long as the ways along the curves. The middle is at
 *
 *     (A + B) / 2 - w m / 3
 *
 * and its velocity is (va + vb) / 2. All others are cubics with the places and velocities of the
 * curve at their ends.
 *
 * Control values are rounded to grains each: a second difference errs by 2 grains, a third one by
 * 4. Spans last 2 periods at least, in which limits allow 4 and 8, and those in which the velocity
 * changes 3 periods, in which half of the limits are 9/2 and 27/2.
 */
#include "motion/cruise.h"

#if LOFT_FOLDS

static uint32_t turn_ticks(const loft_chain *chain)
{
    return LOFT_SLOW_TURN * (uint32_t)chain->period->ticks;
}

static uint32_t from_start(const loft_cruise *c, int i)
{
    return (uint32_t)loft_coord_of(loft_to_acc(c->from.axis[i])) + (uint32_t)c->node.at[i];
}

/* Where the curve that is walked is after so many ticks. */
static void set_node(loft_cruise *c, uint32_t ticks, loft_cruise_node *out)
{
    const int64_t s = c->now.speed * ticks >> LOFT_SLOW_BITS;
    int32_t heading[LOFT_AXES];
    loft_position at;

    loft_slow_go(&c->walk, s);
    loft_slow_place(&c->walk, s, &at, heading);
    for (int i = 0; i < LOFT_AXES; i++) {
        out->at[i] = c->node.at[i] + (int32_t)((uint32_t)at.axis[i] - from_start(c, i));
        out->v[i] = c->now.speed * heading[i] / 65536;
    }
}

/* And at its end, at rest. */
static void set_end(const loft_cruise *c, loft_cruise_node *out)
{
    const loft_vec *end = &c->walk.curve->p[3];

    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t at = (uint32_t)loft_coord_of(loft_to_acc(end->axis[i]));
        out->at[i] = c->node.at[i] + (int32_t)(at - from_start(c, i));
        out->v[i] = 0;
    }
}

static loft_real real_of(const loft_cruise *c, int i, int64_t at)
{
    const int64_t half = LOFT_COORD_GRAIN / 2, all = at + half,
                  grains = (all - (all & (LOFT_COORD_GRAIN - 1))) / LOFT_COORD_GRAIN;
    return loft_acc_round(loft_to_acc(c->from.axis[i]) +
                          loft_coord_to_acc(grains * LOFT_COORD_GRAIN));
}

/* The span to a node. */
static void set_span(loft_cruise *c, const loft_cruise_node *to, uint32_t ticks, loft_span *out)
{
    const int64_t n = ticks;

    out->ticks = (uint16_t)ticks;
    out->p[0] = c->end;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t a = c->node.v[i] * n / 3 >> LOFT_SLOW_BITS,
                      b = to->v[i] * n / 3 >> LOFT_SLOW_BITS;
        out->p[1].axis[i] = real_of(c, i, c->node.at[i] + a);
        out->p[2].axis[i] = real_of(c, i, to->at[i] - b);
        out->p[3].axis[i] = real_of(c, i, to->at[i]);
    }
    c->node = *to;
    c->end = out->p[3];
}

/* Change the velocity from that of this node to the one of `behind`. */
static void begin_change(loft_cruise *c, uint32_t ticks)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t w = c->behind.v[i] - c->node.v[i];
        c->middle.at[i] = (c->node.at[i] + c->behind.at[i]) / 2 - (w * ticks / 3 >> LOFT_SLOW_BITS);
        c->middle.v[i] = (c->node.v[i] + c->behind.v[i]) / 2;
    }
    c->halves = 2;
}

/* A run begins, with a launch. */
static void begin(loft_cruise *c, const loft_chain *chain)
{
    const loft_move *first = loft_chain_move(chain, 0);

    c->runs = true;
    c->lands = false;
    (void)loft_slow_measure(chain, 0, &c->now);
    loft_slow_begin(&c->walk, &first->curve);
    c->from = c->end = first->curve.p[0];
    for (int i = 0; i < LOFT_AXES; i++)
        c->node.at[i] = c->node.v[i] = 0;
    c->gone = turn_ticks(chain);
    set_node(c, c->gone, &c->behind);
    begin_change(c, c->gone);
}

/* Go to the next curve, of which so many ticks are gone. */
static void enter(loft_cruise *c, loft_chain *chain, uint32_t gone)
{
    loft_chain_drop(chain, (uint16_t)(chain->dropped + 1));
    c->now = c->next;
    c->gone = gone;
    loft_slow_begin(&c->walk, &loft_chain_move(chain, 0)->curve);
}

/* The run ends with this curve, exactly on its end. */
static void finish(loft_cruise *c, loft_chain *chain, loft_span *out)
{
    out->p[2] = out->p[3] = c->walk.curve->p[3];
    c->runs = false;
    chain->known = 1;
    loft_chain_finish(chain);
}

/* How this curve ends. */
enum end { UNKNOWN, EVEN, TURN, REST };

static enum end end_of(loft_cruise *c, const loft_chain *chain)
{
    int64_t change[LOFT_AXES];

    if (chain->count < 2)
        return chain->ended || chain->room == 1 ? REST : UNKNOWN;
    if (!loft_slow_measure(chain, 1, &c->next) ||
        !loft_slow_goes_on(chain->period, &c->now, &c->next))
        return REST;
    return loft_slow_turns(chain->period, &c->now, &c->next, change) ? TURN : EVEN;
}

/* A span towards `end`, where no other follows, or towards what is behind it. */
static void go_on(loft_cruise *c, uint32_t end, loft_span *out)
{
    const uint32_t left = end - c->gone, parts = (left + c->now.longest - 1u) / c->now.longest,
                   ticks = (left + parts - 1) / parts;
    loft_cruise_node to;

    set_node(c, c->gone + ticks, &to);
    set_span(c, &to, ticks, out);
    c->gone += ticks;
}

/* The next span along this curve, or the first of a change behind it. */
static bool walk_on(loft_cruise *c, loft_chain *chain, loft_span *out)
{
    const uint32_t m = turn_ticks(chain), ticks = c->now.ticks, spare = m + 2 * c->now.longest;

    if (c->gone + spare < ticks) {          /* however it ends */
        go_on(c, c->gone + c->now.longest, out);
        return true;
    }
    const enum end end = end_of(c, chain);
    if (end == UNKNOWN)
        return false;
    const uint32_t to = end == EVEN ? ticks : ticks - m;
    if (c->gone < to) {
        go_on(c, to, out);
        if (c->gone == ticks)
            enter(c, chain, 0);
        return true;
    }
    c->lands = end == REST;
    if (end == REST)
        set_end(c, &c->behind);
    else {
        enter(c, chain, m);
        set_node(c, m, &c->behind);
    }
    begin_change(c, m);
    return true;
}

enum loft_cruise_state loft_cruise_next(loft_cruise *cruise, loft_chain *chain, loft_span *out)
{
    if (!cruise->runs) {
        loft_slow_look(chain);
        if (chain->known > 0 || chain->count == 0)
            return LOFT_CRUISE_NONE;
        if (!chain->stops)
            return LOFT_CRUISE_WAIT;
        begin(cruise, chain);
    }
    if (cruise->halves == 0 && !walk_on(cruise, chain, out))
        return LOFT_CRUISE_WAIT;
    if (cruise->halves > 0) {
        const loft_cruise_node to = cruise->halves == 2 ? cruise->middle : cruise->behind;
        set_span(cruise, &to, turn_ticks(chain), out);
        cruise->halves--;
        if (cruise->halves == 0 && cruise->lands)
            finish(cruise, chain, out);
    }
    return LOFT_CRUISE_SPAN;
}

#endif
