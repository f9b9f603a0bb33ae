/* lib/motion/barrier.c
 * SPDX-License-Identifier: MIT
 *
 * With the squared pace b, its derivatives b', b'' and those of the path, D1, D2, D3 (timing.c), a
 * part of a limit is used in each place:
 *
 *     v = b / top,  (D2 b + D1 b' / 2) / a  or  (D3 b + 3/2 D2 b' + D1 b'' / 2) sqrt b / j
 *
 * Its barrier is - m log(1 - v^2); m is a part of the time there, so that it does not matter how
 * slow that is. The sum of the times 1 / sqrt b and of all barriers is made least. The unknowns are
 * relative changes of the control values of b. A control value has a part in three intervals: the
 * matrix has five diagonals, and is L D L'. Of the second derivatives those of the root are left
 * out, so it is positive [Boyd and Vandenberghe: Convex Optimization, chapters 9 to 11].
 */
#include "motion/barrier.h"

#include "num/part.h" /* loft_part_root */

#define ONE      INT32_C(65536)
#define ROW_MAX  ((int64_t)1 << 27) /* of a leg in limits, 2^-12; of a derivative, 2^-12 */
#define STEEP    ((int64_t)1 << 34)
#define LEAST    64   /* of 1 - u^2 */
#define OPEN     4    /* knots at an open end that are tied */
#define FIRST    6554 /* 0.1: the first m, of the time */
#define LAST     131
#define STEP_MAX ((int64_t)3 << 23) /* 1.5, 2^-24 */

/* The sum to be made least: its derivative, and three diagonals of the second ones, 2^-16. After
 * the elimination the columns of L, 2^-24, and D. */
typedef struct {
    int64_t slope, same, next, after;
    int32_t was, tied; /* v2 before the step; that of a tied knot */
} column;

typedef struct {
    const loft_period *period;
    loft_knot *knot;
    unsigned count, tied, loose; /* knots before `tied`, and from `loose` on, are tied */
    int32_t share;               /* m of the time, 2^-16 */
    column at[LOFT_BARRIER_KNOTS];
} problem;

/* b and its derivatives in a place between two knots, 2^-20. */
typedef struct {
    int32_t b, slope, curve;
    int32_t root, time; /* sqrt b, 1 / sqrt b, 2^-16 */
} pace;

/* Derivatives of the path in units of a limit, 2^-12. */
typedef struct {
    int32_t d1[3], d2[3], d3;
} legs;

static int32_t in_limits(loft_coord leg, int64_t inverse)
{
    const int64_t x = leg * inverse >> 24;
    return (int32_t)(x > ROW_MAX / 4 ? ROW_MAX / 4 : x < -ROW_MAX / 4 ? -ROW_MAX / 4 : x);
}

static legs legs_of(const loft_coord leg[3], loft_coord limit)
{
    const int64_t inverse = ((int64_t)1 << 36) / limit;
    const int32_t a = in_limits(leg[0], inverse), b = in_limits(leg[1], inverse),
                  c = in_limits(leg[2], inverse);
    return (legs){ { (a + b) / 2, (a + 6 * b + c) / 8, (b + c) / 2 },
                   { b - a, (c - a) / 2, c - b },
                   c - 2 * b + a };
}

/* 1 / sqrt b, 2^-16. */
static int32_t inverse_root(int32_t b)
{
    int half = 0;

    for (; b < INT32_C(1) << 28; half++)
        b *= 4;
    const int32_t root = loft_part_root((uint32_t)b);
    return half < 3 ? root >> (3 - half) : root * (INT32_C(1) << (half - 3));
}
/* b = 2^-20 m 4^-half, m = 2^28 to 2^30: 1 / sqrt b = root 2^-15 2^(half - 4) */

/* In the places 0, 1 and 2: at knot k, in the middle, at the next. */
static bool set_pace(const loft_knot *k, pace at[3])
{
    const int32_t x = k[0].is.pace.v2 >> 4, y = k[1].is.pace.v2 >> 4, z = k[2].is.pace.v2 >> 4;

    at[0].b = (x + y) / 2;
    at[1].b = (x + 6 * y + z) / 8;
    at[2].b = (y + z) / 2;
    at[0].slope = y - x;
    at[1].slope = (z - x) / 2;
    at[2].slope = z - y;
    for (int n = 0; n < 3; n++) {
        if (at[n].b < 16)
            return false;
        at[n].curve = x - 2 * y + z;
        at[n].time = inverse_root(at[n].b);
        at[n].root = (int32_t)((int64_t)at[n].b * at[n].time >> 20);
    }
    return true;
}


// Derivatives
// -----------

/* What a change of b, b', b'' by 1 each, 2^-12, adds to the part of a limit, as relative changes of
 * the three control values. */
static void row_of(const loft_knot *k, int place, int64_t b, int64_t slope, int64_t curve,
                   int64_t out[3])
{
    const int64_t rows[3][3] = { { b / 2 - slope + curve, b / 2 + slope - 2 * curve, curve },
                                 { b / 8 - slope / 2 + curve, b * 3 / 4 - 2 * curve,
                                   b / 8 + slope / 2 + curve },
                                 { curve, b / 2 - slope - 2 * curve, b / 2 + slope + curve } };
    for (int e = 0; e < 3; e++) {
        const int64_t x = rows[place][e] * (k[e].is.pace.v2 >> 8) >> 16;
        out[e] = x > ROW_MAX ? ROW_MAX : x < -ROW_MAX ? -ROW_MAX : x;
    }
}

static void add(column *at, const int64_t row[3], int64_t slope, int64_t bend)
{
    int64_t most = 0, steep = STEEP;

    for (int e = 0; e < 3; e++)
        most = loft_long_abs(row[e]) > most ? loft_long_abs(row[e]) : most;
    for (; most >= INT32_C(1) << 20; most /= 2)
        steep /= 4;
    bend = bend < steep ? bend : steep;
    for (int e = 0; e < 3; e++) {
        const int64_t part = bend * row[e] >> 12;
        at[e].slope += slope * row[e] >> 12;
        at[e].same += part * row[e] >> 12;
        if (e < 2)
            at[e].next += part * row[e + 1] >> 12;
        if (e < 1)
            at[e].after += part * row[2] >> 12;
    }
}

/* The barrier of a limit of which v is used, 2^-16; row: the derivatives of v. */
static void add_barrier(column *at, const int64_t row[3], int64_t v, int64_t m)
{
    const int64_t u = loft_long_abs(v), square = u * u >> 16,
                  left = ONE - square > LEAST ? ONE - square : LEAST;
    const int64_t inverse = UINT32_MAX / (uint32_t)left, slope = (2 * m * u >> 16) * inverse >> 16,
                  bend = (((2 * m * (ONE + square) >> 16) * inverse >> 16) * inverse) >> 16;
    add(at, row, v < 0 ? -slope : slope, bend);
}

static int64_t accel_in(const legs *e, const pace *p, int n)
{
    return ((int64_t)e->d2[n] * p->b + (int64_t)e->d1[n] * p->slope / 2) >> 16;
}

static int64_t jerk_in(const legs *e, const pace *p, int n)
{
    const int64_t sum = (int64_t)e->d3 * p->b + (int64_t)e->d2[n] * p->slope * 3 / 2 +
                        (int64_t)e->d1[n] * p->curve / 2;
    return (sum >> 16) * p->root >> 16;
}

/* The limits of an axis between knot k and the next; false: one is not held. With `at` what they
 * add to the derivatives. */
static bool add_axis(const problem *p, unsigned k, const loft_coord leg[3], int i,
                     const pace places[3], column *at, int64_t m)
{
    const loft_knot *knot = &p->knot[k];
    int64_t row[3];
    const legs a = legs_of(leg, p->period->accel[i]), j = legs_of(leg, p->period->jerk[i]);

    for (int n = 0; n < 3; n++) {
        const pace *x = &places[n];
        const int64_t accel = n < 2 ? accel_in(&a, x, n) : 0, jerk = jerk_in(&j, x, n);
        if (loft_long_abs(accel) >= ONE || loft_long_abs(jerk) >= ONE)
            return false;
        if (at) {
            row_of(knot, n, a.d2[n], a.d1[n] / 2, 0, row);
            add_barrier(at, row, accel, m);
            const int64_t root = x->root, own = (jerk * x->time >> 16) * x->time >> 21;
            row_of(knot, n, (j.d3 * root >> 16) + own, (int64_t)j.d2[n] * 3 / 2 * root >> 16,
                   (int64_t)j.d1[n] / 2 * root >> 16, row);
            add_barrier(at, row, jerk, m);
        }
    }
    return true;
}
/* d(L sqrt b) = sqrt b dL + (L sqrt b) / (2 b) db, from 2^-16 to 2^-12 */

/* The part of a limit, 2^-16, that a speed is. */
static int32_t speed_part(int32_t b, int32_t top)
{
    top = top < LOFT_BARRIER_FASTEST ? top : LOFT_BARRIER_FASTEST;
    if (b >= top >> 4)
        return ONE;
    const int shift = top < INT32_C(1) << 20 ? 0 : 7;
    return (int32_t)(((uint32_t)b << (16 - shift)) / ((uint32_t)top >> (4 + shift)));
}
/* (b / 2^20) / (top / 2^24) = b 2^4 / top; 2^16 of it: b 2^(16 - s) / (top / 2^(4 + s)). Where top
 * is below 2^20, b is below 2^16 and all of it fits with s = 0. */

static bool add_interval(const problem *p, unsigned k, column *at)
{
    const loft_knot *knot = &p->knot[k];
    pace x[3];
    int64_t row[3];

    if (!set_pace(knot, x))
        return false;
    const int64_t time = x[1].time, m = (p->share * time >> 16) + 1;
    for (int n = 0; n < 2; n++) {
        const int32_t v = speed_part(x[n].b, knot->is.pace.top);
        if (v >= ONE)
            return false;
        if (at) {
            row_of(knot, n, (int64_t)v * 256 / (x[n].b / 256 + 1), 0, 0, row);
            add_barrier(at, row, v, m);
        }
    }
    if (at) {
        row_of(knot, 1, ((int64_t)1 << 24) / (x[1].b / 256 + 1), 0, 0, row);
        add(at, row, -time / 2, time * 3 / 4);
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_coord leg[3];
        for (int n = 0; n < 3; n++)
            leg[n] = loft_coord_sub(knot[n].point.axis[i], knot[n - 1].point.axis[i]);
        if ((leg[0] | leg[1] | leg[2]) != 0 && !add_axis(p, k, leg, i, x, at, m))
            return false;
    }
    return true;
}
/* A change of b by 1 is one of v = b / top by v / b, and of the relative b by 1 / b, all 2^-12. */

/* A tied knot: half the square of by how much of its pace it is off. */
static void add_tie(const loft_knot *knot, column *at)
{
    const int64_t whole = ((int64_t)knot->is.pace.v2 << 16) / (at->tied + 1),
                  part = whole < 16 * ONE ? whole : 16 * ONE;
    at->slope += (part - ONE) * part >> 16;
    at->same += part * part >> 16;
}

static bool all_hold(const problem *p)
{
    for (unsigned k = 1; k + 2 < p->count; k++)
        if (!add_interval(p, k, NULL))
            return false;
    return true;
}

static void set_derivatives(problem *p)
{
    for (unsigned k = 0; k < p->count; k++)
        p->at[k].slope = p->at[k].same = p->at[k].next = p->at[k].after = 0;
    for (unsigned k = 1; k + 2 < p->count; k++)
        (void)add_interval(p, k, &p->at[k]);
    for (unsigned k = 1; k < p->count; k++)
        if (k < p->tied || k >= p->loose)
            add_tie(&p->knot[k], &p->at[k]);
}


// A step
// ------

/* x * part, of 2^-24. */
static int64_t times(int64_t x, int64_t part)
{
    return (x >> 24) * part + ((x & ((INT32_C(1) << 24) - 1)) * part >> 24);
}

/* x / y, 2^-24, at most 8. */
static int64_t over(int64_t x, int64_t y)
{
    while (y >= (int64_t)1 << 35) {
        y >>= 4;
        x >>= 4;
    }
    const int64_t most = 8 * y;
    return (x > most ? most : x < -most ? -most : x) * (INT32_C(1) << 24) / y;
}

/* No part is above 8: where a knot is so much stiffer than the one before, that one moves less. */
static void eliminate(problem *p)
{
    column *c = p->at;

    for (unsigned k = 1; k < p->count; k++) {
        c[k].same += (c[k].same >> 26) + 256;
        if (k > 1) {
            const int64_t part = over(c[k - 1].next, c[k - 1].same);
            c[k].same -= times(c[k - 1].next, part);
            c[k].next -= times(c[k - 1].after, part);
            c[k].slope -= times(c[k - 1].slope, part);
            c[k - 1].next = part;
        }
        if (k > 2) {
            const int64_t part = over(c[k - 2].after, c[k - 2].same);
            c[k].same -= times(c[k - 2].after, part);
            c[k].slope -= times(c[k - 2].slope, part);
            c[k - 2].after = part;
        }
        const int64_t stiff = (loft_long_abs(c[k].next) + loft_long_abs(c[k].after)) / 8 + 256;
        c[k].same = c[k].same > stiff ? c[k].same : stiff;
    }
}

/* slope becomes the step, 2^-24. */
static void solve(problem *p)
{
    column *c = p->at;

    for (unsigned k = p->count; k-- > 1;) {
        int64_t step = -over(c[k].slope, c[k].same);
        if (k + 1 < p->count)
            step -= times(c[k + 1].slope, c[k].next);
        if (k + 2 < p->count)
            step -= times(c[k + 2].slope, c[k].after);
        c[k].slope = step > STEP_MAX * 4    ? STEP_MAX * 4
                     : step < -STEP_MAX * 4 ? -STEP_MAX * 4
                                            : step;
    }
}

/* The largest part of the step for which all limits are held: 1, 1/2, 1/4 .. */
static bool go(problem *p)
{
    column *c = p->at;
    int64_t most = STEP_MAX, part = INT32_C(1) << 24;

    for (unsigned k = 1; k < p->count; k++) {
        c[k].was = p->knot[k].is.pace.v2;
        most = loft_long_abs(c[k].slope) > most ? loft_long_abs(c[k].slope) : most;
    }
    part = most > STEP_MAX ? over(STEP_MAX, most) : part;
    for (int n = 0; n < 10; n++, part /= 2) {
        for (unsigned k = 1; k < p->count; k++) {
            int64_t by = times(c[k].slope, part);
            by = by < -(INT32_C(1) << 23) ? -(INT32_C(1) << 23) : by;
            p->knot[k].is.pace.v2 = c[k].was + (int32_t)times(c[k].was, by);
        }
        if (all_hold(p))
            return n == 0;
    }
    for (unsigned k = 1; k < p->count; k++)
        p->knot[k].is.pace.v2 = c[k].was;
    return true;
}

/* The even pace that all limits allow. */
static void set_even(const problem *p)
{
    const int32_t b = loft_timing_least(p->knot, p->count);

    for (unsigned k = 0; k < p->count; k++)
        p->knot[k].is.pace.v2 = b - b / 16;
}

void loft_barrier_time(const loft_period *period, loft_knot knot[], unsigned count, unsigned tied,
                       bool open, int steps)
{
    problem p;

    p.period = period;
    p.knot = knot;
    p.count = count;
    p.tied = tied;
    p.loose = open && count > tied + OPEN ? count - OPEN : count;
    p.share = FIRST;
    for (unsigned k = 0; k < count; k++)
        p.at[k].tied = k < tied ? knot[k].is.pace.v2 : LOFT_V2_ONE;
    set_even(&p);
    for (int n = 0; n < steps; n++) {
        set_derivatives(&p);
        eliminate(&p);
        solve(&p);
        if (go(&p))
            p.share = p.share / 3 > LAST ? p.share / 3 : LAST;
    }
    for (unsigned k = 0; k < tied; k++)
        knot[k].is.pace.v2 = p.at[k].tied;
}
