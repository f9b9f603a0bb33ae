/* lib/motion/thin.c
 * SPDX-License-Identifier: MIT
 *
 * Point Q[k] is the blossom of the motion at the times of knots k - 1, k, k + 1. So velocity has
 * the control points V[k] = 3 (Q[k] - Q[k-1]) / (t[k+1] - t[k-2]), the acceleration at knot k is
 * A[k] = 2 (V[k+1] - V[k]) / (t[k+1] - t[k-1]), and it is straight from knot to knot.
 *
 * To take out knot j, points R replace Q[j-1] and Q[j+1]. Putting the knot in again (Boehm) would
 * give three points of them, which should be Q[j-1], Q[j], Q[j+1]:
 *
 *     Q[j-1] = Q[j-2] + (R[j-1] - Q[j-2]) (t[j] - t[j-3]) / (t[j+1] - t[j-3])
 *     Q[j]   = R[j-1] + (R[j+1] - R[j-1]) (t[j] - t[j-2]) / (t[j+2] - t[j-2])
 *     Q[j+1] = Q[j+2] + (R[j+1] - Q[j+2]) (t[j+3] - t[j]) / (t[j+3] - t[j-1])
 *
 * With R from the first and the third, Q[j] is missed by e, which is the jump of the jerk at knot
 * j but for a factor. It is shared so that all three are missed by as little, in turns of sign
 * (Lyche and Moerken). Each knot is tried once, from left to right. One that is left to right of a
 * long span is judged with that, so that spans become as long as the motion is smooth.
 *
 * Control values p of spans are multiples of a grain, 2^-16 mm. Four of them, each rounded for
 * itself, would have a third difference that is up to 4 grains off, and jerk is 6 / h^3 of that.
 * Instead the differences are rounded,
 *
 *     v = p1 - p0,   n0 = p2 - 2 p1 + p0,   n1 = p3 - 2 p2 + p1,   p3 = p0 + 3 v + 2 n0 + n1
 *
 * where p0 is the end of the span before. Speed, acceleration and jerk are 3 v / h, 6 n / h^2 and
 * 6 (n1 - n0) / h^3, and the limits of a span are whole numbers of grains. What w1 - w0 exceeds the
 * jerk by is taken off both. If the wanted w0, w1 are within the limits then so are n0, n1 for a
 * choice of floor or floor + 1 of each: if floor(w1) - floor(w0) exceeds the jerk j, it is j + 1,
 * then w0 is no whole number and floor(w0) + 1 will do. So limits are held without any margin.
 * For each n0, n1 there is a v for which p3 is off by at most a grain and a half, and for one
 * choice of them by half a grain. Velocity and acceleration jump by a grain or two where spans
 * meet; rounded for themselves they would jump as well.
 */
#include "motion/thin.h"

#define FIRST       2       /* the next span begins at knot FIRST */
#define FINE        14      /* bits of velocities and accelerations below a unit */
#define SIX_GRAINS  (6 * LOFT_COORD_GRAIN)
#define EVEN        256     /* of an acceleration, is none */
#define WAITS       40      /* periods, for that: what is kept of a line lasts longer (chain.c) */
#define SLACK       64      /* units, a quarter of a grain, by which what is wanted of a span may be
                             * beyond the limits */


/* 2^32 / n, rounded up, for n = 2, 3, .. 64: as long as four spans. A small chip divides slowly. */
#define OVER(n)       UINT32_MAX / (n) + 1
#define OVER_SEVEN(n) OVER(n), OVER(n + 1), OVER(n + 2), OVER(n + 3), OVER(n + 4), OVER(n + 5), \
                      OVER(n + 6)
static const uint32_t inverses[] = { OVER_SEVEN(2),  OVER_SEVEN(9),  OVER_SEVEN(16),
                                     OVER_SEVEN(23), OVER_SEVEN(30), OVER_SEVEN(37),
                                     OVER_SEVEN(44), OVER_SEVEN(51), OVER_SEVEN(58) };

/* x / n, towards 0, too large by less than 2^-32 of x; n = 1 .. 64. */
static int64_t over(int64_t x, int32_t n)
{
    if (n == 1)
        return x;
    const uint32_t inverse = inverses[n - 2];
    const uint64_t size = (uint64_t)loft_long_abs(x);
    const int64_t q = (int64_t)((size >> 32) * inverse +
                                ((uint32_t)size * (uint64_t)inverse >> 32));

    return x < 0 ? -q : q;
}


// The spline
// ----------

/* Periods from knot a to knot b. */
static int32_t from_to(const loft_thin *t, unsigned a, unsigned b)
{
    return (uint16_t)(t->point[b].time - t->point[a].time);
}

/* Of an axis: velocities V and accelerations A, units and periods, FINE. */
typedef struct {
    int64_t v[LOFT_THIN_POINTS + 1], a[LOFT_THIN_POINTS + 1];
} rates;

static int64_t velocity(const loft_thin *t, unsigned k, int i)
{
    const int64_t leg = t->point[k].at[i] - t->point[k - 1].at[i];
    return leg == 0 ? 0 : over(leg * ((int32_t)3 << FINE), from_to(t, k - 2, k + 1));
}

/* V[from .. to] and A[from .. to - 1]; it rests beyond the ends of the chain. */
static void load(const loft_thin *t, int i, unsigned from, unsigned to, rates *out)
{
    for (unsigned k = from; k <= to; k++)
        out->v[k] = k < FIRST || k + 1u >= t->count ? 0 : velocity(t, k, i);
    for (unsigned k = from; k < to; k++)
        out->a[k] = k < FIRST || k + 2u >= t->count
                        ? 0
                        : over(2 * (out->v[k + 1] - out->v[k]), from_to(t, k - 1, k + 1));
}

/* The span from knot k: its ends from the start, in sixths of units, and its velocities there. */
typedef struct {
    int64_t six_p0, six_p3, v0, v1;
} ends_of_axis;

static int64_t velocity_at(const loft_thin *t, unsigned k, const rates *r)
{
    return over(r->v[k] * from_to(t, k, k + 1) + r->v[k + 1] * from_to(t, k - 1, k),
                from_to(t, k - 1, k + 1));
}

static ends_of_axis ends_of(const loft_thin *t, unsigned k, int i, const rates *r)
{
    const int32_t n = from_to(t, k, k + 1);
    const int64_t v = r->v[k + 1];
    ends_of_axis e = { .v0 = velocity_at(t, k, r), .v1 = velocity_at(t, k + 1, r) };

    e.six_p0 = 6 * t->point[k].at[i] + (2 * (v * from_to(t, k - 1, k) - e.v0 * n) >> FINE);
    e.six_p3 = 6 * t->point[k + 1].at[i] - (2 * (v * from_to(t, k + 1, k + 2) - e.v1 * n) >> FINE);
    return e;
}

/* Do points from .. to lie at one place of an axis? As a rule one of three axes stands still. */
static bool is_still(const loft_thin *t, unsigned from, unsigned to, int i)
{
    for (unsigned k = from + 1; k <= to; k++)
        if (t->point[k].at[i] != t->point[from].at[i])
            return false;
    return true;
}


// Fewer knots
// -----------

/* The points at both sides of knot j without it, and by how much the three are missed. */
typedef struct {
    int64_t left[LOFT_AXES], right[LOFT_AXES], off[LOFT_AXES];
} pair;

/* x a / b, for |x| < 2^46 */
static int64_t part(int64_t x, int32_t a, int32_t b) { return over(x * a, b); }

static void set_pair(const loft_thin *t, unsigned j, pair *out)
{
    const int32_t a = from_to(t, j - 3, j), a_all = from_to(t, j - 3, j + 1),
                  b = from_to(t, j - 2, j), b_all = from_to(t, j - 2, j + 2),
                  c = from_to(t, j, j + 3), c_all = from_to(t, j - 1, j + 3);
    const bool begins = j - 1 <= FIRST + 1, ends = t->ended && j + 5u >= t->count;
    const int32_t one = (int32_t)1 << 16,
                  shares = one + (begins ? 0 : (b_all - b) * a_all * (one / b_all) / a) +
                           (ends ? 0 : b * c_all * (one / b_all) / c);
    for (int i = 0; i < LOFT_AXES; i++) {
        if (is_still(t, j - 2, j + 2, i)) {
            out->left[i] = out->right[i] = t->point[j].at[i];
            out->off[i] = 0;
            continue;
        }
        const int64_t at[5] = { t->point[j - 2].at[i], t->point[j - 1].at[i], t->point[j].at[i],
                                t->point[j + 1].at[i], t->point[j + 2].at[i] };
        int64_t left = at[1] + part(at[1] - at[0], a_all - a, a),
                right = at[3] - part(at[4] - at[3], c_all - c, c);
        const int64_t e = at[2] - left - part(right - left, b, b_all), off = e * one / shares;
        if (!begins)
            left += part(off, a_all, a);
        if (!ends)
            right += part(off, c_all, c);
        out->left[i]  = left;
        out->right[i] = right;
        out->off[i]   = off;
    }
}

/* Does the axis hold its limits where points a and a + 1 have changed? */
static bool axis_holds(const loft_thin *t, unsigned a, int i, const rates *r)
{
    const int64_t speed = t->period->speed[i] + SLACK / 8, accel = t->period->accel[i],
                  jerk = t->period->jerk[i];

    for (unsigned k = a; k <= a + 2; k++)
        if (loft_long_abs(r->v[k]) >> FINE > speed)
            return false;
    for (unsigned k = a > FIRST + 2 ? a - 2 : FIRST; k <= a + 2; k++) {
        const int32_t n = from_to(t, k, k + 1), square = n * n;
        const int64_t a0 = loft_long_abs(r->a[k]), a1 = loft_long_abs(r->a[k + 1]),
                      d = loft_long_abs(r->a[k + 1] - r->a[k]);
        if ((a0 > a1 ? a0 : a1) * square >> FINE > accel * square + SLACK ||
            d * square >> FINE > jerk * (square * n) + 6 * SLACK)
            return false;
    }
    return true;
}

/* Is the span from knot k close to the samples? `square` sums how far it is from each. */
static bool axis_is_close(const loft_thin *t, unsigned k, int i, const rates *r,
                          int64_t square[LOFT_THIN_SAMPLES])
{
    const ends_of_axis e = ends_of(t, k, i, r);
    const int32_t n = from_to(t, k, k + 1);
    const int64_t most = t->period->off, d3 = over(r->a[k + 1] - r->a[k], n);
    int64_t at = over(e.six_p0 * ((int32_t)1 << FINE), 6), d1 = e.v0 + r->a[k] / 2 + over(d3, 6),
            d2 = r->a[k] + d3;

    for (int32_t m = 1; m <= n; m++) {
        const unsigned place = (t->point[k].time + (unsigned)m) % LOFT_THIN_SAMPLES;
        const loft_coord x = loft_coord_sub(t->sample[place].axis[i], t->origin.axis[i]);
        at += d1;
        d1 += d2;
        d2 += d3;
        const int64_t off = loft_coord_sub((loft_coord)(uint32_t)(uint64_t)(at >> FINE), x);
        if (loft_long_abs(off) > most)
            return false;
        square[place] += off * off;
        if (square[place] > most * most)
            return false;
    }
    return true;
}

static bool feed_holds(const loft_thin *t, unsigned k)
{
    const loft_coord feed = loft_coord_least(
        t->point[k - 1].feed, loft_coord_least(t->point[k].feed, t->point[k + 1].feed));
    loft_coord v[LOFT_AXES];
    int64_t sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        v[i] = (loft_coord)(velocity(t, k, i) >> FINE);
        sum += loft_coord_abs(v[i]);
    }
    return sum <= feed || loft_coord_length(v) <= feed + SLACK / 8;
}

/* Is the motion good where points a and a + 1 have become this pair? An axis that stands still need
 * not be looked at, if it did so before as well. */
static bool is_good(const loft_thin *t, unsigned a, const pair *p)
{
    int64_t square[LOFT_THIN_SAMPLES] = { 0 };
    rates r;

    for (int i = 0; i < LOFT_AXES; i++) {
        if (p->off[i] == 0 &&
            is_still(t, a > 3 ? a - 3 : 0, a + 5u < t->count ? a + 5 : t->count - 1u, i))
            continue;
        load(t, i, a - 2, a + 4, &r);
        if (!axis_holds(t, a, i, &r))
            return false;
        for (unsigned k = a > FIRST + 2 ? a - 2 : FIRST; k <= a + 2; k++)
            if (k + 3u < t->count && !axis_is_close(t, k, i, &r, square))
                return false;
    }
    for (unsigned k = a; k <= a + 2; k++)
        if (!feed_holds(t, k))
            return false;
    return true;
}

static void set_point(loft_thin_point *p, const int64_t at[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        p->at[i] = at[i];
}

/* Take out knot j if the motion is good without it. */
static bool take_out(loft_thin *t, unsigned j)
{
    pair p;

    if (from_to(t, j - 1, j + 1) > t->period->joined)
        return false;
    set_pair(t, j, &p);
    for (int i = 0; i < LOFT_AXES; i++)
        if (loft_long_abs(p.off[i]) > 4 * (int64_t)t->period->off)
            return false;
    const loft_thin_point left = t->point[j - 1], gone = t->point[j], right = t->point[j + 1];
    set_point(&t->point[j - 1], p.left);
    set_point(&t->point[j + 1], p.right);
    if (gone.feed < right.feed)
        t->point[j + 1].feed = gone.feed;
    t->count--;
    for (unsigned k = j; k < t->count; k++)
        t->point[k] = t->point[k + 1];
    if (is_good(t, j - 1, &p))
        return true;
    for (unsigned k = t->count; k > j; k--)
        t->point[k] = t->point[k - 1];
    t->count++;
    t->point[j - 1] = left;
    t->point[j]     = gone;
    t->point[j + 1] = right;
    return false;
}


// Grains
// ------

typedef struct {
    int64_t v, n0, n1;
} steps_of_axis;

static int64_t floor_of(int64_t x, int32_t n) { return x >= 0 ? x / n : -((n - 1 - x) / n); }

static int64_t within(int64_t x, int64_t most) { return x > most ? most : x < -most ? -most : x; }

static int64_t square_of(int64_t x) { return x * x; }

/* What is wanted of an axis in a span: 6 v, 6 n0, 6 n1 and 6 times the way to its end, in units; if
 * `ends` the next span is the last one, and the end of the chain is `rest` from here; if it
 * `begins` it starts from rest. Most of v, n and n1 - n0, in grains; of what remains to the end, in
 * units. */
typedef struct {
    int64_t v, n0, n1, way, rest;
    int64_t speed, accel, jerk, remains;
    bool    begins, ends;
} wanted;

/* Where the span ends, from its start. */
static int64_t way_of(steps_of_axis x) { return 3 * x.v + 2 * x.n0 + x.n1; }

static int64_t beyond(int64_t x, int64_t most)
{
    return loft_long_abs(x) > most ? loft_long_abs(x) - most : 0;
}

/* By how much limits are exceeded. */
static int64_t over_of(steps_of_axis x, const wanted *w)
{
    return beyond(x.v, w->speed) + beyond(x.v + x.n0, w->speed) +
           beyond(x.v + x.n0 + x.n1, w->speed) + beyond(x.n0, w->accel) + beyond(x.n1, w->accel) +
           beyond(x.n1 - x.n0, w->jerk) +
           (w->begins ? loft_long_abs(x.v) + loft_long_abs(x.n0) : 0) +
           (w->ends ? beyond(w->rest - way_of(x) * LOFT_COORD_GRAIN, w->remains) : 0);
}

static int64_t cost_of(steps_of_axis x, const wanted *w)
{
    const int64_t off = way_of(x) * SIX_GRAINS - w->way;
    return 9 * (square_of(x.v * SIX_GRAINS - w->v) + square_of(x.n0 * SIX_GRAINS - w->n0) +
                square_of(x.n1 * SIX_GRAINS - w->n1)) +
           square_of(off) + (beyond(off, SIX_GRAINS) << 24) + over_of(x, w) * ((int64_t)1 << 40);
}

/* The least change of them all; an end that is off counts a ninth, up to a grain. */
static steps_of_axis rounded(const wanted *w)
{
    const int64_t f0 = floor_of(w->n0, SIX_GRAINS), f1 = floor_of(w->n1, SIX_GRAINS);
    const int32_t left = (int32_t)floor_of(3 * w->v + w->way + 3 * SIX_GRAINS, SIX_GRAINS);
    steps_of_axis best = { 0, f0, f1 };
    int64_t least = INT64_MAX;

    if ((w->v | w->n0 | w->n1 | w->way) == 0 && !w->ends)
        return best;                        /* it stands still */
    for (int n = 0; n < 12; n++) {
        steps_of_axis x = { n / 4 - 1, f0 + (n & 1), f1 + (n >> 1 & 1) };
        if (w->begins) {                    /* v and n0 are 0, so n1 alone is the way */
            x.n1 += x.v;
            x.v = 0;
        } else {
            const int32_t six_v = left - (int32_t)(2 * x.n0 + x.n1);
            x.v = within(x.v + (six_v >= 0 ? six_v / 6 : -((5 - six_v) / 6)), w->speed);
            x.v = within(x.v + x.n0, w->speed) - x.n0;
            x.v = within(x.v + x.n0 + x.n1, w->speed) - x.n0 - x.n1;
        }
        const int64_t cost = cost_of(x, w);
        if (cost < least) {
            least = cost;
            best  = x;
        }
    }
    return best;
}

static int64_t least(int64_t a, int64_t b) { return a < b ? a : b; }

/* How far from the end the last span may begin. */
static int64_t most_of_last(const loft_thin *t, int i)
{
    const int64_t whole = t->period->ticks, last = t->last_ticks;
    return least(t->period->jerk[i] * last / whole, t->period->accel[i]) * last * last /
           (6 * whole * whole);
}

/* Whole grains of a limit. */
static int64_t grains_of(int64_t x) { return over(x / (SIX_GRAINS / 3), 3); }

/* What had been left out of the path, and has come back, grains. */
static int64_t cruised_of(const loft_thin *t, int i)
{
#if LOFT_FOLDS
    return t->cruised[i];
#else
    (void)t, (void)i;
    return 0;
#endif
}

/* From the end of the last span to that of the chain. */
static loft_coord rest_of(const loft_thin *t, int i)
{
    const uint32_t from = (uint32_t)loft_coord_of(loft_to_acc(t->from.axis[i])),
                   at = from + (uint32_t)((t->grains[i] + cruised_of(t, i)) * LOFT_COORD_GRAIN);
    return loft_coord_sub(loft_coord_of(loft_to_acc(t->to.axis[i])), (loft_coord)at);
}

/* What is wanted of the next span. */
static wanted want(const loft_thin *t, int i)
{
    const loft_period *p = t->period;
    const int64_t n = from_to(t, FIRST, FIRST + 1), accel = grains_of(p->accel[i] * n * n),
                  jerk = grains_of(p->jerk[i] * n * n * n), most = jerk * SIX_GRAINS,
                  steep = accel * SIX_GRAINS;
    const bool ends = t->ended && FIRST + 5u == t->count;
    rates r;

    load(t, i, FIRST, FIRST + 2, &r);
    const ends_of_axis e = ends_of(t, FIRST, i, &r);
    const int64_t n0 = r.a[FIRST] * n * n >> FINE, n1 = r.a[FIRST + 1] * n * n >> FINE,
                  rise = n1 - n0, more = rise - within(rise, most);
    const wanted w = { .v = 2 * e.v0 * n >> FINE,
        .n0 = within(n0 + more / 2, steep),
        .n1 = within(n1 - (more - more / 2), steep),
        .way  = e.six_p3 - t->grains[i] * SIX_GRAINS,
        .rest = ends ? rest_of(t, i) : 0,
        .speed = p->speed[i] / (3 * LOFT_COORD_GRAIN) * n,
        .accel = accel,
        .jerk  = jerk,
        .remains = ends ? most_of_last(t, i) : 0,
                       .begins = !t->moves,
                       .ends = ends };
    return w;
}

/* Units from the start, mm. */
static loft_real real_of(const loft_thin *t, int i, int64_t grains)
{
    return loft_acc_round(loft_to_acc(t->from.axis[i]) +
                          loft_coord_to_acc((grains + cruised_of(t, i)) * LOFT_COORD_GRAIN));
}

static void set_span(loft_thin *t, loft_span *out)
{
    out->p[0] = t->end;
    out->ticks = (uint16_t)(t->period->ticks * from_to(t, FIRST, FIRST + 1));
    for (int i = 0; i < LOFT_AXES; i++) {
        const wanted w = want(t, i);
        const steps_of_axis x = rounded(&w);
        const int64_t p0 = t->grains[i], p1 = p0 + x.v, p2 = p1 + x.v + x.n0;
        t->grains[i] = p0 + way_of(x);
        out->p[1].axis[i] = real_of(t, i, p1);
        out->p[2].axis[i] = real_of(t, i, p2);
        out->p[3].axis[i] = real_of(t, i, t->grains[i]);
    }
    if (!t->moves)
        out->p[1] = t->from;
    t->moves = true;
    if (t->ended && FIRST + 4u == t->count) {
        out->p[1] = out->p[2] = out->p[3] = t->to;
        out->ticks = t->last_ticks;
    }
    t->end = out->p[3];
    t->passed = t->point[FIRST + 1].number;
}


// Cruises
// -------

#if LOFT_FOLDS

#define TICK_BITS 20 /* of velocities below units in a tick */

/* Velocity rises evenly from v0 to v during `ramp` ticks, and falls at the end as it rose: the plan
 * of a feed leaves room for rounding spans, of which a cruise needs less. So the way is
 *
 *     v0 ramp + v (ticks - ramp)
 */

/* The way after so many ticks of the first half, units, TICK_BITS. */
static int64_t way_to(const loft_thin_cruise *c, int i, int64_t ticks)
{
    const int64_t r = c->ramp, n = ticks < r ? ticks : r;
    return c->v0[i] * ticks + (c->v[i] - c->v0[i]) * n / r * n / 2 +
           (c->v[i] - c->v0[i]) * (ticks - n);
}

static int64_t way_after(const loft_thin_cruise *c, int i, int64_t ticks)
{
    const int64_t left = c->ticks - ticks, all = c->way[i] * LOFT_COORD_GRAIN * (1 << TICK_BITS);
    return left < c->ramp ? all - way_to(c, i, left) : way_to(c, i, ticks);
}

static int64_t velocity_after(const loft_thin_cruise *c, int i, int64_t ticks)
{
    const int64_t left = c->ticks - ticks, n = ticks < left ? ticks : left, r = c->ramp;
    return c->v0[i] + (c->v[i] - c->v0[i]) * (n < r ? n : r) / r;
}

/* Ticks of the next span. */
static int64_t next_ticks(const loft_thin_cruise *c)
{
    const int64_t left = (int64_t)c->ticks - c->ramp - c->gone,
                  n = (left + LOFT_SPAN_TICKS_MAX - 1) / LOFT_SPAN_TICKS_MAX;
    return c->gone == 0 || left <= 0 ? c->ramp : (left + n - 1) / n;
}

static int64_t whole_grains(int64_t x)
{
    const int64_t one = (int64_t)LOFT_COORD_GRAIN << TICK_BITS;
    return floor_of(x + one / 2, (int32_t)one);
}

static void set_cruise_span(loft_thin *t, loft_span *out)
{
    loft_thin_cruise *c = &t->cruise;
    const int64_t n = next_ticks(c), from = c->gone, to = from + n;

    out->p[0] = t->end;
    out->ticks = (uint16_t)n;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t p0 = way_after(c, i, from), p3 = way_after(c, i, to),
                      p1 = p0 + velocity_after(c, i, from) * n / 3,
                      p2 = p3 - velocity_after(c, i, to) * n / 3, at = t->grains[i];
        out->p[1].axis[i] = real_of(t, i, at + whole_grains(p1));
        out->p[2].axis[i] = real_of(t, i, at + whole_grains(p2));
        out->p[3].axis[i] = real_of(t, i, at + whole_grains(p3));
    }
    c->gone += (uint32_t)n;
    t->end = out->p[3];
    t->passed = t->point[FIRST].number;
    for (int i = 0; i < LOFT_AXES && c->gone == c->ticks; i++)
        t->cruised[i] += c->way[i];
}

/* The least ticks in which an axis makes its way: within its speed, but for 3 grains in a ramp. */
static int64_t least_ticks(const loft_thin *t, int i)
{
    const loft_thin_cruise *c = &t->cruise;
    const int64_t one = (int64_t)1 << TICK_BITS, way = loft_long_abs(c->way[i]) * LOFT_COORD_GRAIN,
                  most = t->period->speed[i] * one / t->period->ticks,
                  left = most - 3 * LOFT_COORD_GRAIN * one / c->ramp,
                  least = left > most / 2 ? left : most / 2 + 1;
    return c->ramp + (way * one - loft_long_abs(c->v0[i]) * c->ramp) / least + 1;
}

/* How many ticks the ramps take more than the feed would, from the axis with the longest way. */
static int64_t more_ticks(const loft_thin_cruise *c)
{
    int most = 0;

    for (int i = 1; i < LOFT_AXES; i++)
        most = loft_long_abs(c->way[i]) > loft_long_abs(c->way[most]) ? i : most;
    const int64_t way = c->way[most] * LOFT_COORD_GRAIN,
                  part = (c->v0[most] * c->ramp >> TICK_BITS) * c->ticks / way;
    return part < c->ramp ? c->ramp - part : 0;
}

/* Is its speed even where the next span begins? Else a later one may wait for that, for as long as
 * the line is straight: where samples are not quite even, acceleration would jump. */
static bool is_even(const loft_thin *t)
{
    rates r;

    for (int i = 0; i < LOFT_AXES; i++) {
        load(t, i, FIRST, FIRST + 2, &r);
        if (loft_long_abs(r.a[FIRST]) >> FINE > t->period->accel[i] / EVEN)
            return false;
    }
    return true;
}

/* Begin a cruise of what is left out of the path before the next span, if anything is. */
static bool begin_cruise(loft_thin *t)
{
    const loft_fold *to = &t->point[FIRST].fold;
    loft_thin_cruise *c = &t->cruise;
    rates r;

    if (to->ticks == t->fold.ticks || !t->moves)
        return false;
    c->waited = (uint16_t)(c->waited + from_to(t, FIRST, FIRST + 1));
    if (c->waited < WAITS && !is_even(t))
        return false;
    c->waited = 0;
    c->gone  = 0;
    c->ticks = to->ticks - t->fold.ticks;
    c->ramp  = (uint16_t)least(t->period->joined * t->period->ticks, c->ticks / 4 + 1);
    for (int i = 0; i < LOFT_AXES; i++) {
        load(t, i, FIRST, FIRST + 2, &r);
        c->v0[i] = velocity_at(t, FIRST, &r) * (1 << (TICK_BITS - FINE)) / t->period->ticks;
        c->way[i] = (int32_t)((uint32_t)to->axis[i] - (uint32_t)t->fold.axis[i]);
    }
    t->fold = *to;
    int64_t ticks = c->ticks + more_ticks(c);
    for (int i = 0; i < LOFT_AXES; i++)
        ticks = ticks > least_ticks(t, i) ? ticks : least_ticks(t, i);
    c->ticks = (uint32_t)ticks;
    for (int i = 0; i < LOFT_AXES; i++)
        c->v[i] = (c->way[i] * LOFT_COORD_GRAIN * (1 << TICK_BITS) - c->v0[i] * c->ramp) /
                  (ticks - c->ramp);
    return true;
}

/* The next span of a cruise, if the next span is one. */
static bool cruise_on(loft_thin *t, loft_span *out)
{
    if (t->cruise.gone == t->cruise.ticks && !begin_cruise(t))
        return false;
    set_cruise_span(t, out);
    return true;
}

#endif


// One by one
// ----------

void loft_thin_begin(loft_thin *thin, const loft_period *period, loft_vec from)
{
    thin->period = period;
    thin->count = thin->next = 0;
    thin->ended = thin->moves = false;
    thin->from = thin->end = from;
    for (int i = 0; i < LOFT_AXES; i++)
        thin->grains[i] = 0;
#if LOFT_FOLDS
    for (int i = 0; i < LOFT_AXES; i++)
        thin->cruised[i] = 0;
    thin->fold = (loft_fold){ { 0 }, 0 };
    thin->cruise.ticks = thin->cruise.gone = thin->cruise.waited = 0;
#endif
}

/* Append the last point again, at the next knot. */
static void repeat(loft_thin *t)
{
    t->point[t->count] = t->point[t->count - 1];
    t->point[t->count].time++;
    t->count++;
}

/* There is one more point before the first. */
void loft_thin_add(loft_thin *thin, const loft_thin_input *in)
{
    if (thin->count == 0) {
        thin->origin = thin->last = in->point;
        thin->point[0] = (loft_thin_point){ .feed = in->feed, .number = in->number };
        thin->count = 1;
        thin->next = FIRST + 2;
    }
    repeat(thin);
    loft_thin_point *p = &thin->point[thin->count - 1];
    for (int i = 0; i < LOFT_AXES; i++)
        p->at[i] += loft_coord_sub(in->point.axis[i], thin->last.axis[i]);
    p->feed = in->feed;
    p->number = in->number;
#if LOFT_FOLDS
    p->fold = in->fold;
#endif
    thin->last = in->point;
    thin->sample[p->time % LOFT_THIN_SAMPLES] = in->sample;
}

/* And one behind the last. */
void loft_thin_end(loft_thin *thin, loft_vec to, uint16_t ticks)
{
    repeat(thin);
    thin->ended = true;
    thin->last_ticks = ticks;
    thin->to = to;
}

static void drop_first(loft_thin *t)
{
    t->count--;
    t->next--;
    for (unsigned k = 0; k < t->count; k++)
        t->point[k] = t->point[k + 1];
}

/* Point j + 1 of those that may change is not one of the last four; where the last period is longer
 * or shorter, not one of those that belong to it. */
static bool may_try(const loft_thin *t)
{
    const unsigned kept = !t->ended ? 5 : t->last_ticks == t->period->ticks ? 4 : 6;
    return t->next + kept < t->count;
}

bool loft_thin_next(loft_thin *thin, loft_span *out)
{
    while (may_try(thin) && thin->next < FIRST + 4u)
        if (!take_out(thin, thin->next))
            thin->next++;
    const bool sure = thin->next >= FIRST + 4u || (thin->ended && !may_try(thin));
    if (!sure || thin->count < FIRST + 4u)
        return false;
#if LOFT_FOLDS
    if (cruise_on(thin, out))
        return true;
#endif
    set_span(thin, out);
    drop_first(thin);
    return true;
}
