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

#include "motion/bump.h"    /* loft_bump_part */
#include "num/part.h"       /* loft_part, loft_part_root */

#define EASY        16      /* knots before an open end */
#define FINE        (LOFT_PLAN_EFFORT > 1 ? 1000 : 500)
#define SPARE       (LOFT_PLAN_EFFORT > 1 ? 2048 : 256) /* a part of the speed, for emit's rounds */
#define BACK        (LOFT_PLAN_EFFORT < 2)  /* from the end: a knot can rise when the next has */


// Limits
// ------

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
    return loft_coord_most(loft_coord_most(first, last), middle);
}

static int32_t top_of(const loft_period *p, const loft_knot knot[], unsigned k)
{
    loft_coord v[LOFT_AXES];
    const loft_coord feed = loft_coord_least(knot[k].is.on.feed, knot[k + 1].is.on.feed);
    int64_t most = 190000;                  /* 2^32 / sqrt LOFT_V2_MAX */

    for (int i = 0; i < LOFT_AXES; i++) {
        v[i] = fastest(legs_of(knot, k, i));
        const int64_t part = v[i] > 0 ? ((int64_t)v[i] << 19) / p->speed[i] : 0;
        most = part > most ? part : most;
    }
    const int64_t part = ((int64_t)loft_coord_length(v) << 19) / feed;
    most = part > most ? part : most;
    const int64_t root = ((int64_t)1 << 32) / (most + most / SPARE + 1);
    return (int32_t)(root * root);
}

void loft_timing_load(const loft_period *period, loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++) {
        knot[k].is.pace.top  = top_of(period, knot, k);
        knot[k].is.pace.goal = loft_timing_even(period, knot, k);
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
    const int32_t curve = knot[k].is.pace.v2 - 2 * knot[k + 1].is.pace.v2 + knot[k + 2].is.pace.v2,
                  top = knot[k].is.pace.top;

    set_pace(knot[k].is.pace.v2, knot[k + 1].is.pace.v2, knot[k + 2].is.pace.v2, at);
    if (at[0].b > top || at[1].b > top || at[2].b > top)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!axis_holds(period, legs_of(knot, k, i), i, at, curve, share))
            return false;
    return true;
}

/* part = 2^15 r, r = J / D3: b = 2^24 r^(2/3) = 2^24 (part^2 / 2^30)^(1/3)
 *      = 2^14 (part^2)^(1/3) = 2^7 (part^2 2^21)^(1/3) */
int32_t loft_timing_even(const loft_period *period, const loft_knot knot[], unsigned k)
{
    int64_t b = knot[k].is.pace.top;

    for (int i = 0; i < LOFT_AXES; i++) {
        const legs e = legs_of(knot, k, i);
        if ((e.a | e.b | e.c) == 0)
            continue;
        const loft_coord first = loft_coord_abs(e.b - e.a), last = loft_coord_abs(e.c - e.b);
        const int64_t d2 = loft_coord_most(first, last), d3 = loft_coord_abs(e.c - 2 * e.b + e.a);
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

int32_t loft_timing_least(const loft_knot knot[], unsigned count)
{
    int32_t b = LOFT_V2_ONE;

    for (unsigned k = 1; k + 2 < count; k++)
        b = knot[k].is.pace.goal < b ? knot[k].is.pace.goal : b;
    return b;
}

int loft_timing_share(const loft_timing *t, unsigned k)
{
    return !t->open || k + EASY <= t->end ? 64 : 10 + 16 * (int)(t->end - k) / EASY;
}

bool loft_timing_all_hold(const loft_timing *t, unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        if (!loft_timing_holds(t->period, t->knot, k, loft_timing_share(t, k)))
            return false;
    return true;
}


// Bumps
// -----

/* w(z) = 1 - 2 z^2 up to 1/2, then 2 (1 - z)^2, with z = i / (width + 1/2), 2^-15. */
static const uint16_t narrowest[] = { 32768, 7281 }, narrower[] = { 32768, 22282, 2621 },
                      medium[] = { 32768, 29531, 19822, 7281, 809 },
                      wider[] = { 32768, 31860, 29139, 24604, 18254, 11111, 5669, 2040, 226 },
                      widest[] = { 32768, 32527, 31805, 30601, 28916, 26750, 24102, 20972, 17361,
                                   13540, 10170, 7281, 4874, 2948, 1504, 541, 60 };

/* A bump around knot `at`, of the height `by`. */
typedef struct {
    const loft_timing *t;
    const uint16_t *part;
    unsigned at, width;
    int32_t  by;
} bump;

/* How much of it a knot gets. */
static int32_t add_at(const bump *b, unsigned k)
{
    const unsigned i = k > b->at ? k - b->at : b->at - k;
    return k < b->t->from || k >= b->t->to || i > b->width
               ? 0
               : (b->by >> 15) * b->part[i] +
                     (int32_t)((uint32_t)(b->by & 32767) * b->part[i] >> 15);
}

/* Take off it what limits do not allow between knot k and the next. */
static void shorten(bump *b, unsigned k)
{
    const int32_t add[3] = { add_at(b, k), add_at(b, k + 1), add_at(b, k + 2) };
    const int32_t part = loft_bump_part(b->t->period, b->t->knot, k, loft_timing_share(b->t, k),
                                        add);

    if (part < LOFT_BUMP_ONE)
        b->by = (b->by >> 15) * part + (int32_t)((uint32_t)(b->by & 32767) * (uint32_t)part >> 15);
}

/* Half of what all limits allow is used, so that others may be raised as well. */
static bool raise(bump *b)
{
    const loft_timing *t = b->t;
    loft_knot *q = &t->knot[b->at];
    const int32_t fine = q->is.pace.v2 / FINE, rise = q[-1].is.pace.goal - q->is.pace.v2;
    const unsigned from = b->at > t->from + b->width ? b->at - b->width : t->from,
                   first = from > 3 ? from - 2 : 1, last = b->at + b->width + 1,
                   to = last < t->to ? last : t->to, end = to < t->end ? to : t->end;

    b->by = rise > q->is.pace.v2 ? rise : q->is.pace.v2;
    if (b->by >= LOFT_V2_MAX - q->is.pace.v2)
        b->by = LOFT_V2_MAX - q->is.pace.v2 - 1;
    /* from the middle outwards: there it is most likely to be refused */
    for (unsigned n = 0; n <= b->width + 1 && b->by / 2 > fine; n++) {
        if (b->at + n < end)
            shorten(b, b->at + n);
        if (b->at >= first + n + 1 && b->at - n - 1 < end && b->by / 2 > fine)
            shorten(b, b->at - n - 1);
    }
    b->by /= 2;
    if (b->by <= fine)
        return false;
    for (unsigned k = from; k < to; k++)
        t->knot[k].is.pace.v2 += add_at(b, k);
    return true;
}

int32_t loft_timing_time(const loft_knot knot[], unsigned k)
{
    const uint32_t v0 = loft_coord_sqrt(
                       (uint64_t)(uint32_t)(knot[k].is.pace.v2 + knot[k + 1].is.pace.v2) << 23),
                   v1 = loft_coord_sqrt(
                       (uint64_t)(uint32_t)(knot[k + 1].is.pace.v2 + knot[k + 2].is.pace.v2) << 23);
    return (int32_t)(((uint64_t)2 << 40) / (v0 + v1 + 1));
}
/* v = sqrt(b 2^48) = 2^24 sqrt b */

void loft_timing_raise_part(const loft_timing *t, unsigned shift, unsigned part)
{
    static const uint16_t *const parts[] = { widest, wider, medium, narrower, narrowest };
    const unsigned width = 16u >> part, step = width > 1 ? width / 2 : 1;

    for (unsigned n = (BACK ? 0u - shift : shift) % step; t->from + n < t->to; n += step) {
        bump b = { t, parts[part], BACK ? t->to - 1 - n : t->from + n, width, 0 };
        (void)raise(&b);
    }
}


// The aim
// -------

/* From the end back to the start the pace is as high as an even one may be, at most, and its slope
 * b' and curvature b'' are
 *
 *     b' <= 2 (a - |D2| b) / |D1|,  j / (3 |D2| sqrt b)       b'' <= 2 j / (|D1| sqrt b)
 *
 * on each axis: half the jerk is for one, the other half for the rest (timing.c). Where that meets
 * the pace there is, the same begins forwards. Means with the neighbours round off what is left of
 * its edges. That need not be feasible: the part of the way to it is taken that all limits allow,
 * first of all knots at once, then of stretches from the end to the start. */

#define MEANS   4
#define STRETCH 32    /* knots on both sides of the middle of one */
#define STEEP   (2 * LOFT_BUMP_ONE / STRETCH / STRETCH)
#define LEAST   (LOFT_BUMP_ONE / 128)

/* x / leg, 2^24. */
static int32_t over(int32_t x, loft_coord leg)
{
    const uint32_t q = (uint32_t)x / (((uint32_t)leg >> 12) + 1);
    return q < LOFT_V2_MAX >> 12 ? (int32_t)(q << 12) : LOFT_V2_MAX;
}

typedef struct {
    int32_t slope, curve;
} bounds;

/* What is allowed a pace b between knot k and the next. */
static bounds bounds_at(const loft_timing *t, unsigned k, int32_t b)
{
    bounds out = { LOFT_V2_MAX, LOFT_V2_MAX };
    const int share = loft_timing_share(t, k);
    uint32_t m = b > LOFT_V2_MIN ? (uint32_t)b : LOFT_V2_MIN;
    int half = 0;

    for (; m < UINT32_C(1) << 28; m <<= 2)
        half++;
    const int32_t root = loft_part_root(m); /* 1 / sqrt b = root 2^(half - 17) */
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q0 = t->knot[k].point.axis[i], q1 = t->knot[k + 1].point.axis[i];
        const loft_coord leg = loft_coord_sub(q1, q0),
                         first = leg - loft_coord_sub(q0, t->knot[k - 1].point.axis[i]),
                         last = loft_coord_sub(t->knot[k + 2].point.axis[i], q1) - leg;
        if ((leg | first | last) == 0)
            continue;
        const loft_coord d1 = loft_coord_abs(leg),
                         d2 = loft_coord_most(loft_coord_abs(first), loft_coord_abs(last));
        const int32_t accel = (t->period->accel[i] >> 6) * share,
                      jerk = (t->period->jerk[i] >> 6) * share,
                      left = accel - accel / 16 - (int32_t)((int64_t)d2 * b >> 24),
                      held = loft_part(loft_part_scaled(jerk - jerk / 16, half - 1), root);
        const int32_t slope = loft_coord_least(over(left > 0 ? 2 * left : 0, d1),
                                               over(held / 3, d2));
        out.slope = loft_coord_least(out.slope, slope);
        out.curve = loft_coord_least(out.curve, over(2 * held, d1));
    }
    return out;
}

/* The pace behind one of v2, with a slope that grows. */
static int32_t rise(const loft_timing *t, unsigned k, int32_t v2, int32_t *slope, int32_t most)
{
    const bounds on = bounds_at(t, k == 0 ? 1 : k < t->end ? k : t->end - 1, v2 + *slope);
    const int32_t to = v2 + loft_coord_least(*slope + on.curve, on.slope);

    *slope = loft_coord_least(to, most) - v2;
    return v2 + *slope;
}

/* The most that an even pace may be around knot k. */
static int32_t even_at(const loft_timing *t, unsigned k)
{
    int32_t most = LOFT_V2_MAX / 2;

    for (unsigned n = k > 4 ? k - 4 : 1; n <= k + 2 && n < t->end; n++)
        most = loft_coord_least(most, t->knot[n].is.pace.goal);
    return most;
}

/* Set the aim; gives the first knot that it raises. */
static unsigned set_aim(const loft_timing *t)
{
    loft_knot *q = t->knot;
    int32_t v2 = t->open ? q[t->to].is.pace.v2 : LOFT_V2_MIN, slope = 0;
    unsigned first = t->to;

    for (unsigned k = t->to; k-- > t->from;) {
        q[k].is.pace.aim = v2 = rise(t, k, v2, &slope, even_at(t, k));
        if (v2 <= q[k].is.pace.v2 + q[k].is.pace.v2 / 32)
            break;
        first = k;
    }
    v2 = q[first - 1].is.pace.v2;
    slope = first > 1 ? v2 - q[first - 2].is.pace.v2 : 0;
    for (unsigned k = first; k < t->to; k++)
        q[k].is.pace.aim = v2 = rise(t, k - 1, v2, &slope, q[k].is.pace.aim);
    return first;
}

/* Never above what was aimed at. */
static void take_means(const loft_timing *t, unsigned first)
{
    for (int n = 0; n < MEANS; n++) {
        int32_t before = t->knot[first - 1].is.pace.v2;
        for (unsigned k = first; k + 1 < t->to; k++) {
            const int32_t at = t->knot[k].is.pace.aim,
                          mean = before / 4 + at / 2 + t->knot[k + 1].is.pace.aim / 4;
            before = at;
            t->knot[k].is.pace.aim = loft_coord_least(at, mean);
        }
    }
}

/* A step: of the knots from..to - 1 alone, falling off to both sides of `middle`; 0: evenly. */
typedef struct {
    const loft_timing *t;
    unsigned from, to, middle;
    int32_t part;
} step;

static int32_t step_at(const step *s, unsigned k)
{
    const loft_knot *q = &s->t->knot[k];
    int32_t part = s->part;

    if (k < s->from || k >= s->to || q->is.pace.aim <= q->is.pace.v2)
        return 0;
    if (s->middle > 0) {
        const int32_t off = loft_coord_abs((int32_t)k - (int32_t)s->middle),
                      fall = off <= STRETCH / 2 ? LOFT_BUMP_ONE - STEEP * off * off
                                                : STEEP * (STRETCH - off) * (STRETCH - off);
        part = part * fall >> 15;
    }
    return 2 * loft_part(q->is.pace.aim - q->is.pace.v2, part);
}

static void take_step(step *s)
{
    loft_knot *q = s->t->knot;

    s->part = LOFT_BUMP_ONE;
    for (unsigned k = s->from > 3 ? s->from - 2 : 1; k < s->to && k < s->t->end; k++) {
        const int32_t add[3] = { step_at(s, k), step_at(s, k + 1), step_at(s, k + 2) };
        if ((add[0] | add[1] | add[2]) != 0)
            s->part =
                s->part * loft_bump_part(s->t->period, q, k, loft_timing_share(s->t, k), add) >> 15;
        if (s->part < LEAST)
            return;
    }
    s->part -= s->part / 16;
    for (unsigned k = s->from; k < s->to; k++)
        q[k].is.pace.v2 += step_at(s, k);
}

void loft_timing_aim(const loft_timing *t)
{
    if (t->to < t->from + 4)
        return;
    const unsigned first = set_aim(t);
    if (first == t->to)
        return;
    take_means(t, first);
    step s = { t, first, t->to, 0, 0 };
    take_step(&s);
    unsigned middle = t->to > STRETCH / 2 ? t->to - STRETCH / 2 : t->to / 2;
    for (; s.to > first; middle -= STRETCH) {
        s.middle = middle;
        s.from = middle > first + STRETCH ? middle - STRETCH : first;
        s.to = middle + STRETCH < t->to ? middle + STRETCH : t->to;
        take_step(&s);
        if (middle <= first || middle <= STRETCH)
            break;
    }
}
