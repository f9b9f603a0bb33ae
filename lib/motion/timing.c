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

#define EASY        16      /* knots before an open end */
#define FINE        (LOFT_PLAN_EFFORT > 1 ? 1000 : 500)
#define BACK        (LOFT_PLAN_EFFORT < 2)  /* from the end: a knot can rise when the next has */

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
    const loft_coord feed = knot[k + 1].is.on.feed < knot[k].is.on.feed ? knot[k + 1].is.on.feed
                                                                        : knot[k].is.on.feed;
    int64_t most = 190000;                  /* 2^32 / sqrt LOFT_V2_MAX */

    for (int i = 0; i < LOFT_AXES; i++) {
        v[i] = fastest(legs_of(knot, k, i));
        const int64_t part = v[i] > 0 ? ((int64_t)v[i] << 19) / p->speed[i] : 0;
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

/* Bumps: w(z) = 1 - 2 z^2 up to 1/2, then 2 (1 - z)^2, with z = i / (width + 1/2), 2^-15. */
static const uint16_t narrowest[] = { 32768, 7281 }, narrower[] = { 32768, 22282, 2621 },
                      middle[] = { 32768, 29531, 19822, 7281, 809 },
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
    static const uint16_t *const parts[] = { widest, wider, middle, narrower, narrowest };
    const unsigned width = 16u >> part, step = width > 1 ? width / 2 : 1;

    for (unsigned n = (BACK ? 0u - shift : shift) % step; t->from + n < t->to; n += step) {
        bump b = { t, parts[part], BACK ? t->to - 1 - n : t->from + n, width, 0 };
        (void)raise(&b);
    }
}

void loft_timing_raise(const loft_timing *t, unsigned shift)
{
    for (unsigned part = 0; part < LOFT_TIMING_PARTS; part++)
        loft_timing_raise_part(t, shift, part);
}
