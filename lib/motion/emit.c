/* lib/motion/emit.c
 * SPDX-License-Identifier: MIT
 *
 * The third differences of the samples are averages of the jerk, those of the control points are
 * not: where the jerk changes from one limit to the other within a period they exceed it by some
 * percent. The points are moved by as little as brings them back: what d exceeds of the difference
 * with weights w is taken off as d w / |w|^2, again and again (projections onto convex sets).
 *
 * Then control values p of spans are rounded to grains, 2^-16 mm. Four of them, each rounded for
 * itself, would have a third difference that is up to 4 grains off, and jerk is 6 / h^3 of that.
 * Instead the differences are rounded,
 *
 *     v = p1 - p0,   n0 = p2 - 2 p1 + p0,   n1 = p3 - 2 p2 + p1,   p3 = p0 + 3 v + 2 n0 + n1
 *
 * where p0 is the end of the span before. Speed, acceleration and jerk are 3 v / h, 6 n / h^2 and
 * 6 (n1 - n0) / h^3, and limits are whole numbers of grains (period.c). If the wanted w0, w1 are
 * within the limits so are n0, n1 for a choice of floor or floor + 1 of each: if floor(w1) -
 * floor(w0) exceeds the jerk j, it is j + 1, then w0 is no whole number and floor(w0) + 1 will do.
 * What is left of an excess of w1 - w0 is taken off both. So limits are held without any margin.
 * The rounding of n0, n1 and of p0 is made good by v: p3 is off by 2 grains at most, and v by 2.
 * Velocity and acceleration jump by a grain or two where spans meet; rounded for themselves they
 * would jump as well.
 */
#include "motion/emit.h"

#define AHEAD       5       /* points looked at before one is used */
#define ROUNDS      8
#define GRAIN       ((int32_t)1 << (LOFT_COORD_BITS - 16))      /* in units */
#define SIX_GRAINS  (6 * GRAIN)

/* The first difference of axis i up to point k. */
static loft_coord d1(const loft_emit *e, unsigned k, int i)
{
    return loft_coord_sub(e->point[k].axis[i], e->point[k - 1].axis[i]);
}

/* The point of sample k, which two others surround. */
static void set_point(loft_emit *e, unsigned k)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord x = e->sample[k].axis[i];
        const int64_t d2 = (int64_t)loft_coord_sub(e->sample[k - 1].axis[i], x) +
                           loft_coord_sub(e->sample[k + 1].axis[i], x);
        e->point[k].axis[i] = loft_coord_add(x, -(loft_coord)(d2 / 6));
    }
}

/* The largest n-th difference that the limits allow of axis i. */
static int64_t most_of(const loft_emit *e, int i, int n)
{
    return n == 1 ? e->period->speed[i] : n == 2 ? e->period->accel[i] : e->period->jerk[i];
}

/* What the n-th difference of the points up to k exceeds its limit by. */
static int64_t excess(const loft_emit *e, unsigned k, int i, int n)
{
    const int64_t most = most_of(e, i, n);
    int64_t d = d1(e, k, i);

    if (n > 1)
        d -= (n - 1) * (int64_t)d1(e, k - 1, i);
    if (n > 2)
        d += d1(e, k - 2, i);
    return d > most ? d - most : d < -most ? d + most : 0;
}

/* Points that may be moved: from .. to - 1. */
typedef struct {
    unsigned from, to;
} range;

static bool is_loose(range r, unsigned k) { return k >= r.from && k < r.to; }

/* Take the excess off, with the least change of the points that are loose. */
static bool mend_one(loft_emit *e, unsigned k, int i, int n, range loose)
{
    static const int8_t weight[3][4] = { { 1, -1, 0, 0 }, { 1, -2, 1, 0 }, { 1, -3, 3, -1 } };
    const int64_t off = excess(e, k, i, n);
    int32_t square = 0;

    for (unsigned j = 0; off != 0 && j <= (unsigned)n; j++)
        if (is_loose(loose, k - j))
            square += weight[n - 1][j] * weight[n - 1][j];
    if (square == 0)
        return false;
    for (unsigned j = 0; j <= (unsigned)n; j++)
        if (is_loose(loose, k - j)) {
            loft_coord *x = &e->point[k - j].axis[i];
            *x = loft_coord_add(*x, -(loft_coord)(off * weight[n - 1][j] / square));
        }
    return true;
}

/* Shorten the leg to point k to what the feed allows. */
static bool mend_feed(loft_emit *e, unsigned k, range loose)
{
    const int n = is_loose(loose, k - 1) + is_loose(loose, k);
    const loft_coord feed = e->feed[k] > e->feed[k - 1] ? e->feed[k] : e->feed[k - 1];
    loft_coord leg[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        leg[i] = d1(e, k, i);
    const loft_coord size = loft_coord_length(leg);
    if (n == 0 || size <= feed)
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord off = (loft_coord)((int64_t)leg[i] * (size - feed) / size / n);
        loft_coord *x = &e->point[k].axis[i], *y = &e->point[k - 1].axis[i];
        if (is_loose(loose, k))
            *x = loft_coord_add(*x, -off);
        if (is_loose(loose, k - 1))
            *y = loft_coord_add(*y, off);
    }
    return true;
}

/* Take off by what limits are exceeded up to point `last`. */
static void mend(loft_emit *e, unsigned last, range loose)
{
    bool bad = true;

    for (int round = 0; round < ROUNDS && bad; round++) {
        bad = false;
        for (unsigned k = loose.from; k <= last; k++) {
            bad = mend_feed(e, k, loose) || bad;
            for (int i = 0; i < LOFT_AXES; i++)
                for (int n = 1; n <= 3; n++)
                    bad = mend_one(e, k, i, n, loose) || bad;
        }
    }
}

/* Points that have not been used, and are not at the start. */
static unsigned first_loose(const loft_emit *e) { return e->next > 1 ? e->next + 2u : 3; }

void loft_emit_begin(loft_emit *emit, const loft_period *period, loft_vec from)
{
    emit->count = emit->next = 0;
    emit->begun = emit->moves = emit->ended = false;
    emit->period = period;
    emit->from = emit->last = from;
    for (int i = 0; i < LOFT_AXES; i++)
        emit->at[i] = emit->grains[i] = 0;
}

static void append(loft_emit *e, const loft_position *sample, loft_coord feed, uint16_t number)
{
    const unsigned k = e->count++;

    e->sample[k] = e->point[k] = *sample;
    e->number[k] = number;
    e->feed[k] = feed;
}

/* At the start there is a sample before the first one, and the next point is on it. */
void loft_emit_add(loft_emit *emit, const loft_position *sample, loft_coord feed, uint16_t number)
{
    if (!emit->begun) {
        emit->begun = true;
        emit->next = 1;
        append(emit, sample, feed, number);
    }
    append(emit, sample, feed, number);
    const unsigned last = emit->count - 1u;
    if (last < 3)
        return;
    if (last == 3 && emit->next == 1)
        emit->point[2] = emit->sample[1];
    else
        set_point(emit, last - 1);
    if (last > 3)
        mend(emit, last - 1, (range){ first_loose(emit), last });
}

/* There is a sample behind the last one, and the point before that is on it. */
void loft_emit_end(loft_emit *emit, loft_vec to)
{
    const unsigned k = emit->count - 1u;

    emit->ended = true;
    emit->to = to;
    emit->point[k - 1] = emit->sample[k];
    append(emit, &emit->sample[k], emit->feed[k], emit->number[k]);
    mend(emit, k + 1, (range){ first_loose(emit), k - 1 });
}

/* --- grains -------------------------------------------------------------------------------------
 */

typedef struct {
    int64_t v, n0, n1;
} steps_of_axis;

static int64_t floor_of(int64_t x, int32_t n) { return x >= 0 ? x / n : -((n - 1 - x) / n); }

static int64_t square_of(int64_t x) { return x * x; }

/* What is wanted of an axis in a span: 6 v, 6 n0, 6 n1 and 6 times the way to its end, in units; if
 * `ends` the next span is the last one, and the end of the chain is `rest` from here. */
typedef struct {
    int64_t v, n0, n1, way, rest;
    bool    ends;
} wanted;

/* Where the span ends, from its start. */
static int64_t way_of(steps_of_axis x) { return 3 * x.v + 2 * x.n0 + x.n1; }

static int64_t beyond(int64_t x, int64_t most)
{
    return loft_long_abs(x) > most ? loft_long_abs(x) - most : 0;
}

/* By how much limits are exceeded. */
static int64_t over_of(steps_of_axis x, const wanted *w, const loft_period *p, int i)
{
    const int64_t v = p->speed[i] / (3 * GRAIN), a = p->accel[i] / (6 * GRAIN),
                  j = p->jerk[i] / (6 * GRAIN);
    return beyond(x.v, v) + beyond(x.v + x.n0, v) + beyond(x.v + x.n0 + x.n1, v) + beyond(x.n0, a) +
           beyond(x.n1, a) + beyond(x.n1 - x.n0, j) +
           (w->ends ? beyond(w->rest - way_of(x) * GRAIN, p->jerk[i] / 6) : 0);
}

static int64_t cost_of(steps_of_axis x, const wanted *w, const loft_period *p, int i)
{
    return 9 * (square_of(x.v * SIX_GRAINS - w->v) + square_of(x.n0 * SIX_GRAINS - w->n0) +
                square_of(x.n1 * SIX_GRAINS - w->n1)) +
           square_of(way_of(x) * SIX_GRAINS - w->way) + over_of(x, w, p, i) * ((int64_t)1 << 40);
}

/* The least change of them all; an end that is off counts a ninth. */
static steps_of_axis rounded(const loft_period *p, int i, const wanted *w)
{
    const int64_t f0 = floor_of(w->n0, SIX_GRAINS), f1 = floor_of(w->n1, SIX_GRAINS);
    steps_of_axis best = { 0, f0, f1 };
    int64_t least = INT64_MAX;

    for (int n = 0; n < 12; n++) {
        steps_of_axis x = { n / 4 - 1, f0 + (n & 1), f1 + (n >> 1 & 1) };
        const int64_t left = w->way - (2 * x.n0 + x.n1) * SIX_GRAINS;       /* for 3 v */
        x.v += floor_of(3 * w->v + left + 3 * SIX_GRAINS, 6 * SIX_GRAINS);
        const int64_t cost = cost_of(x, w, p, i);
        if (cost < least) {
            least = cost;
            best  = x;
        }
    }
    return best;
}

/* Units from the start, mm. */
static loft_real real_of(const loft_emit *e, int i, int64_t units)
{
    return loft_acc_round(loft_to_acc(e->from.axis[i]) + loft_coord_to_acc(units));
}

/* The span from sample k, with points k - 1 .. k + 2. */
static void set_span(loft_emit *e, loft_span *out)
{
    const unsigned k = e->next;

    out->p[0] = e->last;
    out->ticks = e->period->ticks;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t ab = d1(e, k, i), bc = d1(e, k + 1, i), cd = d1(e, k + 2, i);
        const int64_t off = e->at[i] - e->grains[i] * GRAIN;        /* of point k */
        const int64_t jerk = cd - 2 * bc + ab, most = e->period->jerk[i],
                      more = jerk > most    ? jerk - most
                             : jerk < -most ? jerk + most
                                            : 0;
        wanted w = { .v = ab + bc,
                     .n0 = bc - ab + more / 2,
                     .ends = e->ended && k + 4u == e->count };
        w.n1 = cd - bc - (more - more / 2);
        w.way = 6 * off + 5 * bc + cd;
        w.rest = off + bc + cd;
        const steps_of_axis x = rounded(e->period, i, &w);
        const int64_t p0 = e->grains[i], p1 = p0 + x.v, p2 = p1 + x.v + x.n0;
        e->grains[i] = p0 + way_of(x);
        out->p[1].axis[i] = real_of(e, i, p1 * GRAIN);
        out->p[2].axis[i] = real_of(e, i, p2 * GRAIN);
        out->p[3].axis[i] = real_of(e, i, e->grains[i] * GRAIN);
        e->at[i] += bc;
    }
    if (!e->moves)
        out->p[1] = e->from;
    e->moves = true;
    if (e->ended && k + 3u == e->count)
        out->p[1] = out->p[2] = out->p[3] = e->to;
    e->last = out->p[3];
}

static void drop_first(loft_emit *e)
{
    e->count--;
    for (unsigned k = 0; k < e->count; k++) {
        e->sample[k] = e->sample[k + 1];
        e->point[k]  = e->point[k + 1];
        e->feed[k]   = e->feed[k + 1];
        e->number[k] = e->number[k + 1];
    }
}

bool loft_emit_next(loft_emit *emit, loft_span *out)
{
    if (!emit->begun || emit->next + 2u + (emit->ended ? 0 : AHEAD) >= emit->count)
        return false;
    set_span(emit, out);
    emit->next++;
    if (emit->next > 3) {
        emit->next--;
        drop_first(emit);
    }
    return true;
}
