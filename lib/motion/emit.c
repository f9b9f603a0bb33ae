/* lib/motion/emit.c
 * SPDX-License-Identifier: MIT
 *
 * The third differences of the samples are averages of the jerk, those of the control points are
 * not: where the jerk changes from one limit to the other within a period they exceed it by some
 * percent. The points are moved by as little as brings them back: what d exceeds of the difference
 * with weights w is taken off as d w / |w|^2, again and again (projections onto convex sets).
 *
 * The last period before the end E has a length of its own, r others. All of it is one cubic, E - J
 * s^3 / 6 at the time s before the end, as are the points around: with a the distance of the point
 * for the times r + 2, r + 1, r from E, those for a period and two periods later are
 *
 *     E + a (1 - r) / (2 + r),   E - a (1 - r) (2 - r) / ((2 + r) (1 + r))
 *
 * and J is 6 a / (r (r + 1) (r + 2)).
 */
#include "motion/emit.h"

#include "num/part.h"       /* loft_part_root_fine */

#define ONE         ((int32_t)1 << 30)
#define CLOSE       256                         /* of a time, 2^-22 of a period */
#define LITTLE      8       /* units that are not taken off: dividing may leave them */
#define AHEAD       5       /* points looked at before one is used */
#define ROUNDS      (LOFT_PLAN_EFFORT > 1 ? 32 : 16)
#define LAST_ROUNDS 32


// Samples
// -------

/* The time from a knot to the part z of the way to the next is the integral of 1 / sqrt b, by
 * Gauss with three points: it errs by z^7 / 2,016,000 of the sixth derivative of the integrand. */

/* b at the part z, 2^-24. */
static int64_t pace_at(const loft_knot knot[], unsigned k, int32_t z)
{
    const int64_t b0 = ((int64_t)knot[k].is.pace.v2 + knot[k + 1].is.pace.v2) / 2,
                  rise = (int64_t)knot[k + 1].is.pace.v2 - knot[k].is.pace.v2,
                  curve = (int64_t)knot[k + 2].is.pace.v2 - knot[k + 1].is.pace.v2 - rise;
    return b0 + ((rise + (curve * z >> 31)) * z >> 30);
}

/* 1 / sqrt b, 2^-30. */
static int64_t slowness(int64_t b)
{
    const uint32_t size = b > 0 ? (uint32_t)b : 1;
    const int half = loft_doublings(size) / 2;
    const int64_t root = loft_part_root_fine(size << 2 * half);
    return half >= 2 ? root << (half - 2) : root >> (2 - half);
}

static loft_time time_to(const loft_knot knot[], unsigned k, int32_t z)
{
    /* (1 -+ sqrt(3/5)) / 2, weights 5/18, 8/18, 5/18 */
    static const int32_t at[3] = { 121015611, 536870912, 952726213 };
    loft_time sum = 0;

    for (int n = 0; n < 3; n++) {
        const int64_t b = pace_at(knot, k, (int32_t)((int64_t)at[n] * z >> 30));
        sum += (n == 1 ? 8 : 5) * slowness(b);
    }
    /* sum <= 18 * 2^30 * 2^12; 1 / 18 is 2^-29 29826162, but for 2^-27 of it */
    const int64_t mean = (sum >> 10) * 29826162 >> 19;
    return (mean >> 30) * z + (((mean & (ONE - 1)) * z) >> 30);
}

loft_time loft_sample_time(const loft_knot knot[], unsigned k) { return time_to(knot, k, ONE); }

loft_time loft_sample_pass(loft_sample *at, const loft_knot knot[], unsigned last, loft_time time)
{
    at->time += time;
    while (at->knot < last) {
        if (at->whole == 0)
            at->whole = loft_sample_time(knot, at->knot);
        if (at->time < at->whole)
            return 0;
        at->time -= at->whole;
        at->whole = 0;
        at->knot++;
    }
    const loft_time left = at->time;
    at->time = 0;
    return left;
}

/* Newton, from what even acceleration gives. */
int32_t loft_sample_part(const loft_sample *at, const loft_knot knot[])
{
    const unsigned k = at->knot;
    if (at->time == 0)
        return 0;
    const loft_time whole = at->whole > 0 ? at->whole : loft_sample_time(knot, k);
    int64_t z = (at->time << 20) / ((whole >> 10) + 1);

    for (int n = 0; n < 4; n++) {
        z = z > ONE ? ONE : z < 0 ? 0 : z;
        const int64_t off = at->time - time_to(knot, k, (int32_t)z);
        if (loft_long_abs(off) < CLOSE)
            break;
        const int64_t b = pace_at(knot, k, (int32_t)z), root = b * slowness(b) >> 25;
        z += (off >> 8) * (root >> 8) >> 13;
    }
    return z > ONE ? ONE : z < 0 ? 0 : (int32_t)z;
}


// Control points
// --------------

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

/* By how much a limit is exceeded: 0, or 1 and 1024ths of it once the end has come. Before it a
 * small chip need not divide. */
static int32_t badness(const loft_emit *e, int64_t off, int64_t most)
{
    if (off == 0 || !e->ended)
        return off != 0;
    const int64_t part = 1 + loft_long_abs(off) * 1024 / (most + 1);
    return part < 65536 ? (int32_t)part : 65536;
}

/* Take the excess off, with the least change of the points that are loose. */
static int32_t mend_one(loft_emit *e, unsigned k, int i, int n, range loose)
{
    static const int8_t weight[3][4] = { { 1, -1, 0, 0 }, { 1, -2, 1, 0 }, { 1, -3, 3, -1 } };
    const int64_t off = excess(e, k, i, n);
    int32_t square = 0;

    if (loft_long_abs(off) <= LITTLE)
        return 0;
    for (unsigned j = 0; j <= (unsigned)n; j++)
        if (is_loose(loose, k - j))
            square += weight[n - 1][j] * weight[n - 1][j];
    if (square == 0)
        return 0;
    for (unsigned j = 0; j <= (unsigned)n; j++)
        if (is_loose(loose, k - j)) {
            loft_coord *x = &e->point[k - j].axis[i];
            *x = loft_coord_add(*x, -(loft_coord)(off * weight[n - 1][j] / square));
        }
    return badness(e, off, most_of(e, i, n));
}

/* Shorten the leg to point k to what the feed allows. Before the end comes, all is taken off the
 * later point: so in one round legs hand on what is too much, and those after it are mended too. */
static int32_t mend_feed(loft_emit *e, unsigned k, range loose)
{
    const bool both = e->ended && is_loose(loose, k - 1);
    const int n = both + is_loose(loose, k);
    const loft_coord feed = loft_coord_most(e->feed[k], e->feed[k - 1]);
    loft_coord leg[LOFT_AXES];
    int64_t sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        leg[i] = d1(e, k, i);
        sum += loft_coord_abs(leg[i]);
    }
    if (n == 0 || sum <= feed + LITTLE)
        return 0;
    const loft_coord size = loft_coord_length(leg);
    if (size <= feed + LITTLE)
        return 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord off = (loft_coord)((int64_t)leg[i] * (size - feed) / size / n);
        loft_coord *x = &e->point[k].axis[i], *y = &e->point[k - 1].axis[i];
        if (is_loose(loose, k))
            *x = loft_coord_add(*x, -off);
        if (both)
            *y = loft_coord_add(*y, off);
    }
    return badness(e, size - feed, feed);
}

/* Take off by what limits are exceeded up to point `last`, once; gives the largest badness. */
static int32_t mend(loft_emit *e, unsigned last, range loose)
{
    int32_t bad = 0;

    for (unsigned k = loose.from; k <= last; k++) {
        bad = loft_coord_most(bad, mend_feed(e, k, loose));
        for (int i = 0; i < LOFT_AXES; i++)
            for (int n = 1; n <= 3; n++)
                bad = loft_coord_most(bad, mend_one(e, k, i, n, loose));
    }
    return bad;
}

/* Points that have not been used, and are not at the start. */
static unsigned first_loose(const loft_emit *e) { return e->next > 3 ? e->next : 3; }

void loft_emit_begin(loft_emit *emit, const loft_period *period, loft_vec from)
{
    emit->count = emit->next = 0;
    emit->begun = emit->ended = false;
    emit->period = period;
#if LOFT_FOLDS
    emit->left_out = (loft_fold){ { 0 }, 0 };
#endif
    loft_thin_begin(&emit->thin, period, from);
}

static void append(loft_emit *e, const loft_position *sample, loft_coord feed, uint16_t number)
{
    const unsigned k = e->count++;

    e->sample[k] = e->point[k] = *sample;
    e->number[k] = number;
    e->feed[k] = feed;
#if LOFT_FOLDS
    e->fold[k] = e->left_out;
#endif
}

void loft_emit_fold(loft_emit *emit, const loft_path_place *before)
{
#if LOFT_FOLDS
    emit->left_out = before->fold;
#else
    (void)emit, (void)before;
#endif
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
    for (int n = 0; n < ROUNDS && last > 3; n++)
        if (mend(emit, last - 1, (range){ first_loose(emit), last }) == 0)
            break;
}

/* The points around the last knot but one, which the point before them and the end give. */
static void set_last(loft_emit *e, int64_t ticks)
{
    const unsigned k = e->count - 2u;
    const int64_t t = e->period->ticks, around = (t + ticks) * (2 * t + ticks);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord end = e->sample[k].axis[i];
        const int64_t jerk = e->period->jerk[i] * ticks, accel = e->period->accel[i] * t,
                      most = (jerk < accel ? jerk : accel) * around / (6 * t * t * t);
        int64_t a = loft_coord_sub(end, e->point[k - 2].axis[i]);
        a = a > most ? most : a < -most ? -most : a;
        const int64_t first = a * (t - ticks) / (2 * t + ticks),
                      last = first * (ticks - 2 * t) / (t + ticks);
        e->point[k - 2].axis[i] = loft_coord_add(end, -(loft_coord)a);
        e->point[k - 1].axis[i] = loft_coord_add(end, (loft_coord)first);
        e->point[k].axis[i] = loft_coord_add(end, (loft_coord)last);
    }
}

/* By how much samples at loose points are left, beyond half of what the tube leaves for all. */
static int32_t missed(const loft_emit *e)
{
    const loft_coord left = (e->period->tol - e->period->tube) / 2;
    loft_coord most = left;

    for (unsigned k = first_loose(e); k + 2 < e->count; k++) {
        loft_position x;
        for (int i = 0; i < LOFT_AXES; i++)
            x.axis[i] = loft_coord_add(e->point[k].axis[i], (d1(e, k + 1, i) - d1(e, k, i)) / 6);
        most = loft_coord_most(most, loft_path_miss_of(&e->sample[k - 2], &x));
    }
    return badness(e, most - left, e->period->tol);
}

/* Move points so that limits are held where the last period has so many ticks; gives what remains
 * too much, up to 1 for a 1024th. */
static int32_t end_with(loft_emit *e, int64_t ticks)
{
    const unsigned k = e->count - 2u;
    int32_t bad = 2;

    for (int round = 0; round < LAST_ROUNDS && bad > 1; round++) {
        set_last(e, ticks);
        bad = mend(e, k, (range){ first_loose(e), k - 1 });
    }
    set_last(e, ticks);
    return loft_coord_most(bad, missed(e));
}

static void copy_points(loft_position *to, const loft_position *from, unsigned n)
{
    for (unsigned k = 0; k < n; k++)
        to[k] = from[k];
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
#if LOFT_FOLDS
        e->fold[k]   = e->fold[k + 1];
#endif
    }
}

/* Use the next point, if it will not be moved any more. */
static bool use_point(loft_emit *e)
{
    const unsigned k = e->next;

    if (k + (e->ended ? 0 : AHEAD) >= e->count)
        return false;
    loft_thin_input in = { .point = e->point[k],
                           .sample = e->sample[k],
                           .feed = loft_coord_most(e->feed[k], k > 0 ? e->feed[k - 1] : 0),
                           .number = e->number[k] };
#if LOFT_FOLDS
    in.fold = e->fold[k];
#endif
    loft_thin_add(&e->thin, &in);
    e->next++;
    if (e->next > 3)
        drop_first(e);
    if (e->ended && e->next == e->count)
        loft_thin_end(&e->thin, e->to, e->last);
    return true;
}

/* Make the last period longer than `ticks` while that brings limits nearer; gives what remains too
 * much, and the points as they were before. Longer ones need less acceleration after the last knot,
 * more before it, as samples stay where they are: what is too much falls to some length, and rises
 * again. */
static int32_t end_longer(loft_emit *e, uint16_t ticks, loft_position before[LOFT_EMIT_SAMPLES])
{
    const uint16_t more = (uint16_t)(e->period->ticks / 8 + 1);

    copy_points(before, e->point, e->count);
    int32_t bad = end_with(e, ticks);
    e->last = ticks;
    while (bad > 1 && e->last < 2 * e->period->ticks && e->last + more <= LOFT_SPAN_TICKS_MAX) {
        copy_points(e->point, before, e->count);
        const int32_t now = end_with(e, e->last + more);
        if (now >= bad) {
            copy_points(e->point, before, e->count);
            (void)end_with(e, e->last);
            break;
        }
        bad = now;
        e->last = (uint16_t)(e->last + more);
    }
    return bad;
}

/* Where that is not enough there is one more period at rest: most of all a way of three or four
 * periods at the feed needs it. There may be room for it only where the first point that is loose
 * is used, which it can be, since the one before it has been: it is asked for no sooner. */
void loft_emit_end(loft_emit *emit, const loft_position *sample, loft_coord feed, uint16_t number,
                   loft_vec to, uint16_t ticks)
{
    loft_position before[LOFT_EMIT_SAMPLES];

    emit->ended = true;
    emit->to = to;
    append(emit, sample, feed, number);
    append(emit, sample, feed, number);
    if (end_longer(emit, ticks, before) <= 1)
        return;
    copy_points(emit->point, before, emit->count);
    if (emit->count == LOFT_EMIT_SAMPLES)
        (void)use_point(emit);
    append(emit, sample, feed, number);
    (void)end_longer(emit, emit->period->ticks, before);
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
