/* lib/motion/timing.c
 * SPDX-License-Identifier: MIT
 *
 * With D1, D2, D3 the derivatives of the path by u, b the squared pace and b', b'' its derivatives,
 *
 *     velocity      D1 sqrt b
 *     acceleration  D2 b + D1 b' / 2
 *     jerk          (D3 b + 3/2 D2 b' + D1 b'' / 2) sqrt b
 *
 * Between two knots D3 and b'' are constant, D2 and b' straight lines, D1 and b parabolas. Limits
 * are asked for at both ends and in the middle.
 */
#include "motion/timing.h"

#define WIDEST      16
#define EASY        32      /* knots before an open end */
#define FINE        1000

typedef struct {
    int32_t b, slope;
} pace;

/* The legs between four control points. */
typedef struct {
    loft_coord a, b, c;
} legs;

static legs legs_of(const loft_knot knot[], unsigned k, int i)
{
    const loft_coord q0 = knot[k - 1].point.axis[i], q1 = knot[k].point.axis[i],
                     q2 = knot[k + 1].point.axis[i], q3 = knot[k + 2].point.axis[i];
    return (legs){ loft_coord_sub(q1, q0), loft_coord_sub(q2, q1), loft_coord_sub(q3, q2) };
}

/* The largest that twice D1 is between two knots, per axis. */
static loft_coord fastest(legs e)
{
    const loft_coord first = loft_coord_abs(e.a + e.b), last = loft_coord_abs(e.b + e.c),
                     middle = loft_coord_abs((e.a + 6 * e.b + e.c) / 4);
    const loft_coord most = first > last ? first : last;
    return most > middle ? most : middle;
}

static int32_t top_of(const loft_period *p, const loft_knot knot[], unsigned k)
{
    loft_coord v[LOFT_AXES];
    const loft_coord feed = knot[k + 1].on.feed < knot[k].on.feed ? knot[k + 1].on.feed
                                                                  : knot[k].on.feed;
    int64_t most = 190000;                  /* 2^32 / sqrt LOFT_V2_MAX */

    for (int i = 0; i < LOFT_AXES; i++) {
        v[i] = fastest(legs_of(knot, k, i));
        const int64_t part = ((int64_t)v[i] << 19) / p->speed[i];
        most = part > most ? part : most;
    }
    const int64_t part = ((int64_t)loft_coord_length(v) << 19) / feed;
    most = part > most ? part : most;
    const int64_t root = ((int64_t)1 << 32) / (most + most / 2048 + 1);
    return (int32_t)(root * root);
}

void loft_timing_load(const loft_period *period, loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++) {
        knot[k].top  = top_of(period, knot, k);
        knot[k].goal = loft_timing_even(period, knot, k);
    }
}

/* |g| sqrt b <= limit, with g 2^-8 units? */
static bool jerk_holds(int64_t g, int32_t b, loft_coord limit)
{
    const int64_t size = loft_long_abs(g) >> 8;
    if (size <= limit && b <= LOFT_V2_ONE)
        return true;
    if (size > (int64_t)limit * 128)
        return false;
    const int64_t part = (size << 14) / limit;          /* at most 2^21 */
    return part * part <= ((int64_t)1 << 52) / b;
}

/* b = 2^24 * (2^14 / part)^2 */

/* What is used of a limit: 63 / 64 at a full share. */
static loft_coord part_of(loft_coord limit, int share)
{
    return (loft_coord)((int64_t)limit * share >> 6);
}

static bool axis_holds(const loft_period *p, legs e, int i, const pace at[3], int32_t curve,
                       int share)
{
    const loft_coord d2[3] = { e.b - e.a, (e.c - e.a) / 2, e.c - e.b };
    const loft_coord d1[3] = { e.a + e.b, (e.a + 6 * e.b + e.c) / 4, e.b + e.c };
    const loft_coord d3 = d2[2] - d2[0], a = part_of(p->accel[i], share),
                     j = part_of(p->jerk[i], share);

    for (int n = 0; n < 3; n++) {
        const int64_t accel = (int64_t)d2[n] * at[n].b + (int64_t)d1[n] * at[n].slope / 4;
        if (loft_long_abs(accel) >> 24 > a)
            return false;
        if (p->jerk[i] == 0)
            continue;
        const int64_t jerk = (int64_t)d3 * at[n].b + (int64_t)d2[n] * at[n].slope * 3 / 2 +
                             (int64_t)d1[n] * curve / 4;
        if (!jerk_holds(jerk >> 16, at[n].b, j))
            return false;
    }
    return true;
}

static void set_pace(int32_t x, int32_t y, int32_t z, pace at[3])
{
    at[0] = (pace){ (x + y) / 2, y - x };
    at[1] = (pace){ (int32_t)(((int64_t)x + 6 * (int64_t)y + z) / 8), (z - x) / 2 };
    at[2] = (pace){ (y + z) / 2, z - y };
}

bool loft_timing_holds(const loft_period *period, const loft_knot knot[], unsigned k, int share)
{
    pace at[3];
    const int32_t curve = knot[k].v2 - 2 * knot[k + 1].v2 + knot[k + 2].v2, top = knot[k].top;

    set_pace(knot[k].v2, knot[k + 1].v2, knot[k + 2].v2, at);
    if (at[0].b > top || at[1].b > top || at[2].b > top)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!axis_holds(period, legs_of(knot, k, i), i, at, curve, share))
            return false;
    return true;
}

int32_t loft_timing_even(const loft_period *period, const loft_knot knot[], unsigned k)
{
    int64_t b = knot[k].top;

    for (int i = 0; i < LOFT_AXES; i++) {
        const legs e = legs_of(knot, k, i);
        const loft_coord first = loft_coord_abs(e.b - e.a), last = loft_coord_abs(e.c - e.b);
        const int64_t d2 = first > last ? first : last, d3 = loft_coord_abs(e.c - 2 * e.b + e.a);
        if (d2 * b > (int64_t)period->accel[i] << 24)
            b = ((int64_t)period->accel[i] << 24) / d2;
        if (period->jerk[i] == 0)
            continue;
        const int64_t whole = ((int64_t)period->jerk[i] << 15) / (d3 + 1);
        if (whole < (int64_t)1 << 23) {
            const int shift = whole < (int64_t)1 << 20 ? 0 : 3;
            const int64_t part = whole >> shift;
            const int64_t root = loft_coord_cbrt((uint64_t)(part * part) << 21);
            const int64_t most = root << (7 + shift * 2 / 3);
            b = most < b ? most : b;
        }
    }
    return b > LOFT_V2_MIN ? (int32_t)b : LOFT_V2_MIN;
}
/* part = 2^15 r, r = J / D3: b = 2^24 r^(2/3) = 2^24 (part^2 / 2^30)^(1/3)
 *      = 2^14 (part^2)^(1/3) = 2^7 (part^2 2^21)^(1/3) */

/* w(z) = 1 - 2 z^2 up to 1/2, then 2 (1 - z)^2; z = |i| / (width + 1/2); 2^-16 */
static int32_t bump(int i, int width)
{
    const int32_t z = (i < 0 ? -i : i) * 131072 / (2 * width + 1), y = 65536 - z;
    return z < 32768 ? 65536 - (int32_t)((int64_t)z * z >> 15) : (int32_t)((int64_t)y * y >> 15);
}

/* Towards an open end little is used of the limits, so that what comes later can still raise
 * it. */
static int share_of(const loft_timing *t, unsigned k)
{
    return !t->open || k + EASY <= t->end ? 64 : 10 + 16 * (int)(t->end - k) / EASY;
}

bool loft_timing_all_hold(const loft_timing *t, unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        if (!loft_timing_holds(t->period, t->knot, k, share_of(t, k)))
            return false;
    return true;
}

/* A bump around a knot: how much of it each of them gets, 2^-16. */
typedef struct {
    unsigned from, to;              /* knots from..to - 1 */
    int32_t  part[2 * WIDEST + 1];
} bump_of_knots;

static void set_bump(const loft_timing *t, unsigned at, int width, bump_of_knots *out)
{
    unsigned n = 0;

    out->from = at > t->from + (unsigned)width ? at - (unsigned)width : t->from;
    for (int i = (int)out->from - (int)at; i <= width && (int)at + i < (int)t->to; i++)
        out->part[n++] = bump(i, width);
    out->to = out->from + n;
}

static int32_t part_at(const bump_of_knots *bumps, unsigned k)
{
    return k >= bumps->from && k < bumps->to ? bumps->part[k - bumps->from] : 0;
}

/* 1 / sqrt b from below, 2^-24, for b of 2^14 at least: Newton from a straight line. */
static int64_t inverse_root(int32_t b)
{
    int p = -4;

    while (b >> (8 + 2 * p) >= 65536)
        p++;
    const uint32_t m = (uint32_t)b >> (8 + 2 * p);          /* b = 4^p m 2^8, m 2^14 to 2^16 */
    uint32_t y = 36258 - (m * 20324 >> 16);                 /* 2^-14 */
    for (int n = 0; n < 2; n++)
        y = y * (49152 - ((y * y >> 14) * m >> 16)) >> 15;
    y -= 8;
    return p < 0 ? (int64_t)y << (10 - p) : (int64_t)(y << 10) >> p;
}

/* The largest step, `by` at most, so that at + slope * step <= most. */
static int32_t step_up_to(int64_t most, int64_t at, int64_t slope, int32_t by)
{
    if (slope <= 0 || slope * by <= most - at)
        return by;
    return most > at ? (int32_t)((most - at) / slope) : 0;
}

/* The largest step, `by` at most, so that the size of at + slope * step is at most most - fall *
 * step. */
static int32_t step_to(int64_t most, int64_t fall, int64_t at, int64_t slope, int32_t by)
{
    if ((loft_long_abs(slope) + fall) * by <= most - loft_long_abs(at))
        return by;
    return step_up_to(most, -at, fall - slope, step_up_to(most, at, fall + slope, by));
}

/* What the pace is in one place between two knots, and what a bump adds to it. */
typedef struct {
    pace    now, more;
    int64_t root, fall;             /* 1 / sqrt b, and how it falls with a step, 2^-24 */
} place_of_pace;

static void set_fall(place_of_pace *x)
{
    const int32_t floor = (int32_t)1 << 14, b = x->now.b > floor ? x->now.b : floor;
    const int64_t root = inverse_root(b), square = root * root >> 24;

    x->root = root + ((root >> 1) * (b - x->now.b)) / b;
    x->fall = (root * square >> 24) * x->more.b >> 17;
}

/* 1 / sqrt b is convex: its tangent is below it. */
static int32_t axis_step(const loft_period *p, legs e, int i, const place_of_pace at[3],
                         int32_t curve, int32_t more, int share, int32_t by)
{
    const loft_coord d2[3] = { e.b - e.a, (e.c - e.a) / 2, e.c - e.b };
    const loft_coord d1[3] = { e.a + e.b, (e.a + 6 * e.b + e.c) / 4, e.b + e.c };
    const loft_coord d3 = d2[2] - d2[0], j = part_of(p->jerk[i], share);
    const int64_t a = (int64_t)part_of(p->accel[i], share) << 24;

    for (int n = 0; n < 3 && by > 0; n++) {
        const pace *x = &at[n].now, *y = &at[n].more;
        const int64_t accel = (int64_t)d2[n] * x->b + (int64_t)d1[n] * x->slope / 4,
                      rise = ((int64_t)d2[n] * y->b + (int64_t)d1[n] * y->slope / 4) >> 16;
        by = step_to(a, 0, accel, rise, by);
        const int64_t jerk = (int64_t)d3 * x->b + (int64_t)d2[n] * x->slope * 3 / 2 +
                             (int64_t)d1[n] * curve / 4,
                      swell = ((int64_t)d3 * y->b + (int64_t)d2[n] * y->slope * 3 / 2 +
                               (int64_t)d1[n] * more / 4) >>
                              16,
                      most = j * at[n].root, fall = (j * at[n].fall >> 24) + 1;
        by = step_to(most, fall, jerk, swell, by);
    }
    return by;
}

/* How much of a bump all limits allow between knot k and the next. at[0] is set if `k` is not the
 * first one; at[2] is the next at[0]. */
static int32_t step_between(const loft_timing *t, unsigned k, const bump_of_knots *bumps,
                            place_of_pace at[3], bool first, int32_t by)
{
    const loft_knot *q = &t->knot[k];
    const int32_t w0 = part_at(bumps, k), w1 = part_at(bumps, k + 1), w2 = part_at(bumps, k + 2);
    const int32_t curve = q[0].v2 - 2 * q[1].v2 + q[2].v2, more = w0 - 2 * w1 + w2;
    const int share = share_of(t, k);
    pace now[3], add[3];

    set_pace(q[0].v2, q[1].v2, q[2].v2, now);
    set_pace(w0, w1, w2, add);
    for (int n = first ? 0 : 1; n < 3; n++) {
        at[n].now = now[n];
        at[n].more = add[n];
        set_fall(&at[n]);
        if (((int64_t)by * add[n].b >> 16) > q->top - now[n].b)
            by = q->top > now[n].b ? (int32_t)(((int64_t)(q->top - now[n].b) << 16) / add[n].b) : 0;
    }
    for (int i = 0; i < LOFT_AXES && by > 0; i++) {
        const legs e = legs_of(t->knot, k, i);
        if ((e.a | e.b | e.c) != 0)
            by = axis_step(t->period, e, i, at, curve, more, share, by);
    }
    return by;
}

/* Half of what all limits allow is used, so that others may be raised as well. */
static bool raise(const loft_timing *t, unsigned at, int width)
{
    const loft_knot *q = &t->knot[at];
    const int32_t fine = q->v2 / FINE, wide = q[-1].goal - q->v2;
    bump_of_knots bumps;
    place_of_pace places[3];
    int32_t by = wide > q->v2 ? wide : q->v2;

    set_bump(t, at, width, &bumps);
    const unsigned to = bumps.to < t->end ? bumps.to : t->end;
    const unsigned from = bumps.from > 3 ? bumps.from - 2 : 1;
    for (unsigned k = from; k < to && by > fine; k++) {
        by = step_between(t, k, &bumps, places, k == from, by);
        places[0] = places[2];
    }
    by /= 2;
    if (by <= fine || q->v2 > LOFT_V2_MAX - by)
        return false;
    for (unsigned k = bumps.from; k < bumps.to; k++)
        t->knot[k].v2 += (int32_t)((int64_t)part_at(&bumps, k) * by >> 16);
    return true;
}

int32_t loft_timing_time(const loft_knot knot[], unsigned k)
{
    const uint32_t v0 = loft_coord_sqrt((uint64_t)(uint32_t)(knot[k].v2 + knot[k + 1].v2) << 23),
                   v1 = loft_coord_sqrt((uint64_t)(uint32_t)(knot[k + 1].v2 + knot[k + 2].v2)
                                        << 23);
    return (int32_t)(((uint64_t)2 << 40) / (v0 + v1 + 1));
}
/* v = sqrt(b 2^48) = 2^24 sqrt b */

void loft_timing_raise(const loft_timing *t, unsigned shift)
{
    for (int width = WIDEST; width > 0; width /= 2) {
        const unsigned step = width > 1 ? (unsigned)width / 2 : 1;
        for (unsigned k = t->from + shift % step; k < t->to; k += step)
            (void)raise(t, k, width);
    }
}
