/* lib/motion/emit.c
 * SPDX-License-Identifier: MIT
 *
 * The third differences of the samples are averages of the jerk, those of the control points are
 * not: where the jerk changes from one limit to the other within a period they exceed it by some
 * percent. The points are moved by as little as brings them back: what d exceeds of the difference
 * with weights w is taken off as d w / |w|^2, again and again (projections onto convex sets).
 */
#include "motion/emit.h"

#define AHEAD       5       /* points looked at before one is used */
#define ROUNDS      8

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

/* Shorten the leg to point k to what the feed allows. Before the end comes, all is taken off the
 * later point: so in one round legs hand on what is too much, and those after it are mended too. */
static bool mend_feed(loft_emit *e, unsigned k, range loose)
{
    const bool both = e->ended && is_loose(loose, k - 1);
    const int n = both + is_loose(loose, k);
    const loft_coord feed = e->feed[k] > e->feed[k - 1] ? e->feed[k] : e->feed[k - 1];
    loft_coord leg[LOFT_AXES];
    int64_t sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        leg[i] = d1(e, k, i);
        sum += loft_coord_abs(leg[i]);
    }
    if (n == 0 || sum <= feed)
        return false;
    const loft_coord size = loft_coord_length(leg);
    if (size <= feed)
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord off = (loft_coord)((int64_t)leg[i] * (size - feed) / size / n);
        loft_coord *x = &e->point[k].axis[i], *y = &e->point[k - 1].axis[i];
        if (is_loose(loose, k))
            *x = loft_coord_add(*x, -off);
        if (both)
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
static unsigned first_loose(const loft_emit *e) { return e->next > 3 ? e->next : 3; }

void loft_emit_begin(loft_emit *emit, const loft_period *period, loft_vec from)
{
    emit->count = emit->next = 0;
    emit->begun = emit->ended = false;
    emit->period = period;
    loft_thin_begin(&emit->thin, period, from);
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
        append(emit, sample, feed, number);
    }
    append(emit, sample, feed, number);
    const unsigned last = emit->count - 1u;
    if (last < 3)
        return;
    if (last == 3 && emit->next == 0)
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

static void drop_first(loft_emit *e)
{
    e->count--;
    e->next--;
    for (unsigned k = 0; k < e->count; k++) {
        e->sample[k] = e->sample[k + 1];
        e->point[k]  = e->point[k + 1];
        e->feed[k]   = e->feed[k + 1];
        e->number[k] = e->number[k + 1];
    }
}

/* Use the next point, if it will not be moved any more. */
static bool use_point(loft_emit *e)
{
    const unsigned k = e->next;

    if (k + (e->ended ? 0 : AHEAD) >= e->count)
        return false;
    const loft_coord before = k > 0 ? e->feed[k - 1] : 0;
    const loft_thin_input in = { .point = e->point[k],
                                 .sample = e->sample[k],
                                 .feed = e->feed[k] > before ? e->feed[k] : before,
                                 .number = e->number[k] };
    loft_thin_add(&e->thin, &in);
    e->next++;
    if (e->next > 3)
        drop_first(e);
    if (e->ended && e->next == e->count)
        loft_thin_end(&e->thin, e->to);
    return true;
}

bool loft_emit_next(loft_emit *emit, loft_span *out)
{
    bool more = true;

    while (more) {
        if (loft_thin_next(&emit->thin, out))
            return true;
        more = use_point(emit);
    }
    return false;
}
