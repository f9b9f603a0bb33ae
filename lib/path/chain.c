/* lib/path/chain.c
 * SPDX-License-Identifier: MIT
 */
#include "path/chain.h"

#include "geom/normal.h"    /* loft_vec_unit */

#define DUST        4                               /* arcs that are no longer are nothing */

static loft_move *move_at(const loft_chain *chain, unsigned i)
{
    const unsigned k = chain->first + i;
    return &chain->moves[k < chain->room ? k : k - chain->room];
}

static loft_move *move_of(const loft_chain *chain, uint16_t number)
{
    return move_at(chain, (uint16_t)(number - chain->dropped));
}


// Walks
// -----

bool loft_chain_advance(const loft_chain *chain, loft_chain_walk *w)
{
    for (;;) {
        if (w->to == LOFT_ARC_WHOLE) {
            w->number++;
            w->to = 0;
        }
        if (loft_chain_walked(chain, w))
            return false;
        const loft_cubic *curve = &move_of(chain, w->number)->curve;
        loft_arc arc;
        w->to = loft_arc_next(&arc, curve, w->to);
        const loft_coord length = loft_coord_of(arc.length);
        if (arc.dust || length < DUST)
            continue;
        w->arc = arc;
        w->feed = loft_period_speed(chain->period, move_of(chain, w->number)->feed);
        w->s += w->length;
        w->length = length;
        return true;
    }
}

bool loft_chain_try(const loft_chain *chain, loft_chain_walk *w)
{
    const uint32_t to = w->to;
    const uint16_t number = w->number;

    if (loft_chain_advance(chain, w))
        return true;
    w->to = to;
    w->number = number;
    return false;
}

void loft_chain_place(const loft_chain_walk *w, int64_t s, loft_position *out)
{
    const int64_t off = s - w->s;
    loft_acc at[LOFT_AXES];

    loft_arc_eval(&w->arc, loft_coord_to_acc(off < w->length ? off : w->length), at);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_coord_of(at[i]);
}

loft_coord loft_chain_go(const loft_chain *chain, loft_chain_walk *w, int64_t s)
{
    loft_coord feed = w->feed;

    while (s > w->s + w->length && loft_chain_try(chain, w))
        feed = w->feed < feed ? w->feed : feed;
    return feed;
}

static void round_direction(const loft_vec *u, int16_t out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = (int16_t)((loft_raw_from_real(u->axis[i]) + 2) >> 2);
}

void loft_chain_direction(const loft_chain_walk *w, unsigned n, int16_t out[])
{
    loft_vec u;

    loft_arc_direction(&w->arc, n, &u);
    round_direction(&u, out);
}

int64_t loft_chain_turn(const int16_t a[], const int16_t b[])
{
    int64_t square = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        square += (int64_t)(b[i] - a[i]) * (b[i] - a[i]);
    return square;
}

void loft_chain_begin(const loft_chain *chain, loft_chain_walk *w)
{
    w->number = chain->dropped;
    w->to = 0;
    w->s = 0;
    w->length = w->feed = 0;
}


// Curves that come and go
// -----------------------

void loft_chain_drop(loft_chain *chain, uint16_t number)
{
    while (chain->dropped != number) {
        chain->dropped++;
        chain->count--;
        chain->first = (uint16_t)(chain->first + 1 < chain->room ? chain->first + 1 : 0);
    }
}

/* Is there a curve before the next one that is pushed? */
static bool is_joined(const loft_chain *chain) { return chain->count > 0 || chain->walked; }

enum loft_status loft_chain_accepts(const loft_move *move)
{
    if (!(move->feed > 0))
        return LOFT_ERR_ARG;
    if (move->feed < LOFT_SPEED_MIN || move->feed > LOFT_SPEED_MAX)
        return LOFT_ERR_RANGE;
    for (int k = 0; k < 4; k++)
        if (!loft_vec_within(move->curve.p[k], LOFT_PLAN_REACH))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

/* The direction in which a curve begins, or ends; false: it has none. */
static bool direction_of(const loft_cubic *c, bool end, int16_t out[])
{
    loft_acc leg[LOFT_AXES];
    loft_vec u;

    for (int k = 1; k < 4; k++) {
        const loft_vec *a = &c->p[end ? 3 - k : 0], *b = &c->p[end ? 3 : k];
        for (int i = 0; i < LOFT_AXES; i++)
            leg[i] = loft_to_acc(b->axis[i]) - loft_to_acc(a->axis[i]);
        if (loft_vec_unit(leg, &u) == LOFT_OK) {
            round_direction(&u, out);
            return true;
        }
    }
    return false;
}

/* Does it stop before this curve? */
static bool stops_before(const loft_chain *chain, const loft_move *move)
{
    static const int16_t none[LOFT_AXES] = { 0 };
    int16_t to[LOFT_AXES];

    return chain->period->exact > 0 && is_joined(chain) &&
           loft_chain_turn(chain->heading, none) > 0 && direction_of(&move->curve, false, to) &&
           loft_chain_turn(chain->heading, to) > chain->period->exact;
}

enum loft_status loft_chain_push(loft_chain *chain, const loft_move *move)
{
    const enum loft_status status = loft_chain_accepts(move);

    if (status != LOFT_OK)
        return status;
    if (is_joined(chain) && !loft_vec_equal(move->curve.p[0], chain->to))
        return LOFT_ERR_ARG;
    if (loft_chain_room(chain) == 0)
        return LOFT_ERR_SPACE;
    if (stops_before(chain, move)) {
        chain->ended = true;
        return LOFT_ERR_SPACE;
    }
    if (!is_joined(chain)) {
        chain->from = move->curve.p[0];
        for (int i = 0; i < LOFT_AXES; i++)
            chain->heading[i] = 0;
    }
    if (chain->period->exact > 0)
        (void)direction_of(&move->curve, true, chain->heading);
    *move_at(chain, chain->count) = *move;
    chain->count++;
    chain->to = move->curve.p[3];
    chain->ended = chain->room == 1;
    return LOFT_OK;
}

void loft_chain_init(loft_chain *chain, const loft_period *period, loft_move moves[], uint16_t room)
{
    chain->period = period;
    chain->moves = moves;
    chain->room = room;
    chain->first = chain->count = chain->dropped = 0;
    chain->ended = chain->walked = chain->closed = false;
}
