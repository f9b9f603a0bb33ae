/* lib/motion/aim.c
 * SPDX-License-Identifier: MIT
 *
 * From the end back to the start the pace is as high as an even one may be, at most, and its slope
 * b' and curvature b'' are
 *
 *     b' <= 2 (a - |D2| b) / |D1|,  j / (3 |D2| sqrt b)       b'' <= 2 j / (|D1| sqrt b)
 *
 * on each axis: half the jerk is for one, the other half for the rest (timing.c). Where that meets
 * the pace there is, the same begins forwards. Means with the neighbours round off what is left of
 * its edges. That need not be feasible: the part of the way to it is taken that all limits allow,
 * first of all knots at once, then of stretches from the end to the start.
 */
#include "motion/aim.h"

#include "motion/bump.h" /* loft_bump_part */
#include "num/part.h"    /* loft_part, loft_part_root */

#define MEANS   4
#define STRETCH 32    /* knots on both sides of the middle of one */
#define STEEP   (2 * LOFT_BUMP_ONE / STRETCH / STRETCH)
#define LEAST   (LOFT_BUMP_ONE / 128)

static int32_t least(int32_t a, int32_t b) { return a < b ? a : b; }

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
                         d2 = loft_coord_abs(loft_coord_abs(first) > loft_coord_abs(last) ? first
                                                                                          : last);
        const int32_t accel = (t->period->accel[i] >> 6) * share,
                      jerk = (t->period->jerk[i] >> 6) * share,
                      left = accel - accel / 16 - (int32_t)((int64_t)d2 * b >> 24),
                      held = loft_part(loft_part_scaled(jerk - jerk / 16, half - 1), root);
        const int32_t slope = least(over(left > 0 ? 2 * left : 0, d1), over(held / 3, d2));
        out.slope = least(out.slope, slope);
        out.curve = least(out.curve, over(2 * held, d1));
    }
    return out;
}

/* The pace behind one of v2, with a slope that grows. */
static int32_t rise(const loft_timing *t, unsigned k, int32_t v2, int32_t *slope, int32_t most)
{
    const bounds on = bounds_at(t, k == 0 ? 1 : k < t->end ? k : t->end - 1, v2 + *slope);
    const int32_t to = v2 + least(*slope + on.curve, on.slope);

    *slope = least(to, most) - v2;
    return v2 + *slope;
}

/* The most that an even pace may be around knot k. */
static int32_t even_at(const loft_timing *t, unsigned k)
{
    int32_t most = LOFT_V2_MAX / 2;

    for (unsigned n = k > 4 ? k - 4 : 1; n <= k + 2 && n < t->end; n++)
        most = least(most, t->knot[n].is.pace.goal);
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
            t->knot[k].is.pace.aim = least(at, mean);
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

void loft_aim_raise(const loft_timing *t)
{
    if (t->to < t->from + 4)
        return;
    const unsigned first = set_aim(t);
    if (first == t->to)
        return;
    take_means(t, first);
    step s = { t, first, t->to, 0, 0 };
    take_step(&s);
    for (unsigned middle = t->to - STRETCH / 2; s.to > first; middle -= STRETCH) {
        s.middle = middle;
        s.from = middle > first + STRETCH ? middle - STRETCH : first;
        s.to = middle + STRETCH < t->to ? middle + STRETCH : t->to;
        take_step(&s);
        if (middle <= first || middle <= STRETCH)
            break;
    }
}
