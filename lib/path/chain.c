/* lib/path/chain.c
 * SPDX-License-Identifier: MIT
 *
 * Where a line is long for its feed the motion cruises on it: the same velocity, for as long as it
 * is. So the middle of the line can be left out, and the path behind it moved to there: the motion
 * along this folded path passes the joint at that velocity, and when it does, the cruise is put in
 * again (thin.c). Its cost does not grow with its duration then. On both sides the line is kept for
 * as long as a launch to the feed lasts, and the tube needs to be straight again.
 */
#include "path/chain.h"

#include "geom/normal.h"    /* loft_vec_unit */

#define DUST        4                               /* arcs that are no longer are nothing */
#define LAUNCH      24                              /* periods, in which the feed is reached */
#define KEPT        (40 + LAUNCH / 2)               /* of a line that is folded, on both sides */
#define STRAIGHT    24                              /* of them, where it is straight */
#define FLAT        64                              /* of the tolerance it may bend */
#define CORNERS     32                              /* tolerances of corners, along the path */

static loft_move *move_at(const loft_chain *chain, unsigned i)
{
    const unsigned k = chain->first + i;
    return &chain->moves[k < chain->room ? k : k - chain->room];
}

const loft_move *loft_chain_move(const loft_chain *chain, unsigned i) { return move_at(chain, i); }

static loft_move *move_of(const loft_chain *chain, uint16_t number)
{
    return move_at(chain, (uint16_t)(number - chain->dropped));
}


// Walks
// -----

#if LOFT_FOLDS

/* Is the feed reached within a launch, at a third of acceleration and jerk? */
static bool is_slow(const loft_period *p, const int16_t u[], loft_coord feed)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t v = (int64_t)feed * loft_coord_abs(u[i]) / LOFT_CHAIN_UNIT;
        if (v > p->speed[i] || v > p->accel[i] / 3 * LAUNCH ||
            v > (int64_t)p->jerk[i] / 3 * (LAUNCH * LAUNCH / 4))
            return false;
    }
    return true;
}

/* How long a way takes that is left out, at a feed in mm/s. */
static uint32_t ticks_of(const loft_period *p, loft_coord way, loft_real feed)
{
    const uint64_t unit = (uint64_t)loft_raw_from_real(feed) << (LOFT_COORD_BITS - 16);
    return (uint32_t)(((uint64_t)way * p->tick_hz + unit - 1) / unit);
}

/* Leave the middle of a long slow line out. */
static void fold(const loft_period *p, loft_chain_walk *w, loft_real feed)
{
    const int64_t corner = p->more > 0 ? ((int64_t)p->tol + p->more) * CORNERS : 0,
                  side = (int64_t)w->feed * KEPT, kept = 2 * (side > corner ? side : corner);
    int16_t u[LOFT_AXES];
    loft_acc by[LOFT_AXES];

    w->left = (loft_fold){ { 0 }, 0 };
    if (w->length <= kept + kept / 2 ||
        !loft_arc_is_straight(&w->arc, loft_coord_to_acc(p->tol / FLAT)))
        return;
    loft_chain_direction(w, 1, u);
    if (!is_slow(p, u, w->feed))
        return;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t leg = loft_coord_of(w->arc.c[1][i] + w->arc.c[2][i] + w->arc.c[3][i]);
        w->left.axis[i] = (int32_t)(leg * (w->length - kept) / w->length / LOFT_COORD_GRAIN);
        by[i] = loft_coord_to_acc((int64_t)w->left.axis[i] * LOFT_COORD_GRAIN);
    }
    loft_arc_fold(&w->arc, by);
    const loft_coord length = loft_coord_of(w->arc.length);
    w->left.ticks = ticks_of(p, w->length - length, feed);
    w->length = length;
}
/* arcs are shorter than 64 mm, 2^30 units */

static int32_t sum_of(int32_t a, int32_t b) { return (int32_t)((uint32_t)a + (uint32_t)b); }

loft_fold loft_chain_fold(const loft_chain_walk *w, int64_t s)
{
    loft_fold out = w->fold;

    if (s - w->s <= w->length / 2)
        return out;
    for (int i = 0; i < LOFT_AXES; i++)
        out.axis[i] = sum_of(out.axis[i], w->left.axis[i]);
    out.ticks += w->left.ticks;
    return out;
}

bool loft_chain_is_straight(const loft_chain_walk *w, int64_t s)
{
    return w->left.ticks > 0 &&
           loft_long_abs(s - w->s - w->length / 2) < (int64_t)w->feed * STRAIGHT;
}

#endif

/* Go on to an arc of this length. */
static void take_arc(const loft_chain *chain, loft_chain_walk *w, const loft_arc *arc,
                     loft_coord length)
{
#if LOFT_FOLDS
    w->fold = loft_chain_fold(w, w->s + w->length);
#endif
    w->arc = *arc;
    w->feed = loft_period_speed(chain->period, move_of(chain, w->number)->feed);
    w->s += w->length;
    w->length = length;
#if LOFT_FOLDS
    fold(chain->period, w, move_of(chain, w->number)->feed);
#endif
}

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
        take_arc(chain, w, &arc, length);
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
#if LOFT_FOLDS
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_coord_folded(out->axis[i], w->fold.axis[i]);
#endif
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
#if LOFT_FOLDS
    w->fold = w->left = (loft_fold){ { 0 }, 0 };
#endif
}


// Curves that come and go
// -----------------------

void loft_chain_drop(loft_chain *chain, uint16_t number)
{
    while (chain->dropped != number) {
        chain->dropped++;
        chain->count--;
#if LOFT_FOLDS
        chain->known = (uint16_t)(chain->known - (chain->known > 0));
#endif
        chain->first = (uint16_t)(chain->first + 1 < chain->room ? chain->first + 1 : 0);
    }
}

loft_vec loft_chain_end(const loft_chain *chain)
{
    const unsigned n = loft_chain_known(chain);
    return n < chain->count ? move_at(chain, n)->curve.p[0] : chain->to;
}

void loft_chain_finish(loft_chain *chain)
{
    const unsigned known = loft_chain_known(chain);

#if LOFT_FOLDS
    chain->from = loft_chain_end(chain);
#endif
    loft_chain_drop(chain, (uint16_t)(chain->dropped + known));
    chain->walked = chain->closed = false;
#if LOFT_FOLDS
    chain->known = 0;
    chain->stops = false;
#endif
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
#if LOFT_FOLDS
    chain->known = 0;
    chain->stops = false;
#endif
}
