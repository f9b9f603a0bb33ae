/* lib/motion/bump.c
 * SPDX-License-Identifier: MIT
 *
 * Let the legs between four control points be a, b, c, and p = a + b, r = b + c, d0 = b - a,
 * d1 = c - b, d3 = d1 - d0. With x, y, z the control values of the squared pace, b0 = (x + y) / 2,
 * b1 = (y + z) / 2, s0 = y - x, s1 = z - y, q = s1 - s0, acceleration and jerk over the root of the
 * pace are, at both knots,
 *
 *     A0 = d0 b0 + p s0 / 4                   A1 = d1 b1 + r s1 / 4
 *     J0 = d3 b0 + 3/2 d0 s0 + p q / 4        J1 = d3 b1 + 3/2 d1 s1 + r q / 4
 *
 * J is the derivative of A, and a parabola, as b is: so in the middle they are
 *
 *     (A0 + A1) / 2 + (J0 - J1) / 8           (J0 + J1) / 2 - 9/16 d3 q
 *
 * A is at most the acceleration a, and J at most j / sqrt(b), of which the tangent is taken: that
 * is below it. All is linear in the control values: what holds for none and for all of a change,
 * holds for each part of it.
 *
 * A product is of 32 and 16 bits, and loses 16: the paces are multiplied by 2^up so that they have
 * 30 bits, slopes by 2^slope more. Differences d are divided by 2^unit, p and r by 2^(unit + slope
 * + 2), to 14 bits. Then all sums are multiples of 2^(unit + 16 - up - 24) units, below 2^30.
 */
#include "motion/bump.h"

#include "num/part.h" /* loft_part, loft_part_root */

static inline int32_t shifted(int32_t x, int n) { return (int32_t)((uint32_t)x << n); }
static inline uint32_t size_of(int32_t x) { return (uint32_t)(x < 0 ? -x : x); }

/* The sums of an interval. */
typedef struct {
    int32_t pace[2], turn[2]; /* b; 3/2 s */
    int32_t slope[2], curve;  /* s, q, 2^slope more */
    int32_t bend;             /* 9/16 q */
} sums;

/* The differences of an axis. */
typedef struct {
    int32_t p[2], d[2], d3;
} legs;

/* Of an axis: at knot k, in the middle, at the next knot. */
typedef struct {
    int32_t accel[3], jerk[3];
} forms;

/* Where jerk is limited. */
typedef struct {
    int32_t root, drop; /* 1 / sqrt b, 2^15 .. 2^14; the part of it that a tangent falls by */
    int half;           /* of that power of 4 */
    int32_t held, fall; /* the most jerk over the root of the pace, and what it falls by */
} place;

static void set_sums(sums *out, int32_t x, int32_t y, int32_t z)
{
    const int32_t s0 = y - x, s1 = z - y;

    out->pace[0] = (x + y) >> 1;
    out->pace[1] = (y + z) >> 1;
    out->turn[0] = s0 + (s0 >> 1);
    out->turn[1] = s1 + (s1 >> 1);
    out->slope[0] = s0;
    out->slope[1] = s1;
    out->bend = 9 * ((s1 - s0) >> 4);
}

static void set_slopes(sums *out, int slope)
{
    out->slope[0] = shifted(out->slope[0], slope);
    out->slope[1] = shifted(out->slope[1], slope);
    out->curve = out->slope[1] - out->slope[0];
}

static void set_forms(forms *out, const sums *s, const legs *e)
{
    const int32_t a0 = loft_part(s->pace[0], e->d[0]) + loft_part(s->slope[0], e->p[0]),
                  a1 = loft_part(s->pace[1], e->d[1]) + loft_part(s->slope[1], e->p[1]);
    const int32_t j0 = loft_part(s->pace[0], e->d3) + loft_part(s->turn[0], e->d[0]) +
                       loft_part(s->curve, e->p[0]),
                  j1 = loft_part(s->pace[1], e->d3) + loft_part(s->turn[1], e->d[1]) +
                       loft_part(s->curve, e->p[1]);

    out->accel[0] = a0;
    out->accel[1] = (a0 >> 1) + (a1 >> 1) + (j0 >> 3) - (j1 >> 3);
    out->accel[2] = a1;
    out->jerk[0] = j0;
    out->jerk[1] = (j0 >> 1) + (j1 >> 1) - loft_part(s->bend, e->d3);
    out->jerk[2] = j1;
}

static inline bool holds(int32_t x, int32_t most) { return x <= most && -x <= most; }

/* The part of the way from `now` to `all` where the size is `most` less that part of `fall`, or
 * `by`, if that is less. */
static int32_t part_to(int32_t now, int32_t all, int32_t most, int32_t fall, int32_t by)
{
    const int32_t room = all >= 0 ? most - now : most + now,
                  need = (all >= 0 ? all - now : now - all) + fall;
    const uint32_t unit = ((uint32_t)need >> 15) + 1;       /* at most 2^17 */

    if (room <= 0)
        return 0;
    if (by < LOFT_BUMP_ONE && (uint32_t)room >= (uint32_t)by * unit)
        return by;                                          /* most are not divided */
    const int32_t to = (int32_t)((uint32_t)room / unit);
    return to < by ? to : by;
}

/* v2 4^half is 2^28 to 2^30. */
static void set_root(place *out, int32_t v2, int even)
{
    uint32_t m = (uint32_t)v2 << even;
    int half = even / 2;

    while (m < (uint32_t)1 << 28) {
        m <<= 2;
        half++;
    }
    out->root = loft_part_root(m);
    out->half = half;
}

/* more <= 2 v2 */
static void set_drop(place *x, int32_t more)
{
    x->drop = loft_part(shifted(more, 2 * x->half), x->root * x->root >> 15) >> 13;
}

/* Little effort: a pace may be more than trebled at once, so that creeps rise soon. That is greedy:
 * the way there and the way back take times that differ by 2 %. */
#define JUMPS (LOFT_PLAN_EFFORT < 2)

/* The part of `more` that speed allows. */
static int32_t by_speed(int32_t pace, int32_t more, int32_t top)
{
    const int32_t left = top - pace, most = !JUMPS && 2 * pace < left ? 2 * pace : left;

    if (more < most)
        return LOFT_BUMP_ONE;
    return most > 0 ? (int32_t)((uint32_t)most / (((uint32_t)more >> 15) + 1)) : 0;
}

/* The differences of all axes, and the largest p, r and d. */
static void measure(const loft_knot knot[], unsigned k, legs e[], uint32_t *p, uint32_t *d)
{
    *p = *d = 1;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q1 = knot[k].point.axis[i], q2 = knot[k + 1].point.axis[i];
        const loft_coord a = loft_coord_sub(q1, knot[k - 1].point.axis[i]),
                         b = loft_coord_sub(q2, q1),
                         c = loft_coord_sub(knot[k + 2].point.axis[i], q2);
        e[i].p[0] = a + b;
        e[i].p[1] = b + c;
        e[i].d[0] = b - a;
        e[i].d[1] = c - b;
        *p |= size_of(e[i].p[0]) | size_of(e[i].p[1]);
        *d |= size_of(e[i].d[0]) | size_of(e[i].d[1]);
    }
}

static void shrink(legs *e, int p, int d)
{
    p = p < 31 ? p : 31;
    e->p[0] >>= p;
    e->p[1] >>= p;
    e->d[0] >>= d;
    e->d[1] >>= d;
    e->d3 = e->d[1] - e->d[0];
}

/* What is, and what it is with all of a change. */
typedef struct {
    sums now, all;
    place at[3];
    int power, slope, unit; /* limits are multiplied by 2^power */
    int32_t jerk;           /* of which the places have the most: axes often have the same */
} interval;

/* Set what is held of a jerk. root / 2^(17 - half) */
static void set_held(interval *t, int32_t jerk, bool far)
{
    if (jerk == t->jerk)
        return;
    t->jerk = jerk;
    for (int n = 0; n < 3; n++) {
        place *x = &t->at[n];
        x->held = loft_part(loft_part_scaled(jerk, t->power + x->half - 1), x->root);
        x->fall = far ? 0 : 2 * loft_part(x->held, x->drop);
    }
}

/* Does jerk hold on the way to a pace whose inverse root is set: before and with all of it? */
static bool jumps(const interval *t, const legs *e, int32_t most)
{
    forms now, all;

    set_forms(&all, &t->all, e);
    set_forms(&now, &t->now, e);
    for (int n = 0; n < 3; n++)
        if (!holds(all.accel[n], most) || !holds(all.jerk[n], t->at[n].held) ||
            !holds(now.jerk[n], t->at[n].held))
            return false;
    return true;
}

/* The part, `by` at most, with which the limits of an axis hold. */
static int32_t axis_part(const interval *t, const legs *e, int32_t most, int32_t by)
{
    const place *at = t->at;
    forms now, all;

    set_forms(&all, &t->all, e);
    bool good = holds(all.accel[0], most) && holds(all.accel[1], most) && holds(all.accel[2], most);
    for (int n = 0; n < 3; n++)
        good = good && holds(all.jerk[n], at[n].held - at[n].fall);
    if (good)
        return by;
    set_forms(&now, &t->now, e);
    for (int n = 0; n < 3; n++) {
        if (!holds(all.accel[n], most))
            by = part_to(now.accel[n], all.accel[n], most, 0, by);
        if (!holds(all.jerk[n], at[n].held - at[n].fall))
            by = part_to(now.jerk[n], all.jerk[n], at[n].held, at[n].fall, by);
    }
    return by;
}

/* v2, the pace at knot k, in the middle and at the next knot. */
static void set_pace(const int32_t v2[3], int32_t pace[3])
{
    pace[0] = (v2[0] + v2[1]) >> 1;
    pace[1] = v2[1] - (v2[1] >> 2) + ((v2[0] + v2[2]) >> 3);
    pace[2] = (v2[1] + v2[2]) >> 1;
}

static int32_t part_of(int32_t x, int32_t part)
{
    return part < LOFT_BUMP_ONE ? 2 * loft_part(x, part) : x;
}

/* The part of the change x, y, z that limits allow. `far`: none or all, by what they are at its
 * end. */
static int32_t part_within(const loft_period *period, const loft_knot knot[], unsigned k, int share,
                           const int32_t add[3], bool far)
{
    interval t; /* an initial value would be set byte by byte */
    const int32_t v2[3] = { knot[k].is.pace.v2, knot[k + 1].is.pace.v2, knot[k + 2].is.pace.v2 };
    const int32_t x = v2[0] + add[0], y = v2[1] + add[1], z = v2[2] + add[2];
    int32_t pace[3], more[3];

    set_pace(v2, pace);
    set_pace(add, more);
    const int up = loft_doublings((uint32_t)(x | y | z));
    for (int n = 0; n < 3; n++) {
        set_root(&t.at[n], far ? pace[n] + more[n] : pace[n], up & ~1);
        if (!far)
            set_drop(&t.at[n], more[n]);
    }
    set_sums(&t.all, shifted(x, up), shifted(y, up), shifted(z, up));
    set_sums(&t.now, shifted(v2[0], up), shifted(v2[1], up), shifted(v2[2], up));
    t.slope = loft_doublings(size_of(t.all.slope[0]) | size_of(t.all.slope[1]) |
                             size_of(t.now.slope[0]) | size_of(t.now.slope[1]) | 1);
    set_slopes(&t.all, t.slope);
    set_slopes(&t.now, t.slope);

    legs e[LOFT_AXES];
    uint32_t p, d;
    measure(knot, k, e, &p, &d);
    const int by_p = 14 - loft_doublings(p) - t.slope, by_d = 17 - loft_doublings(d),
              least = by_p > by_d ? by_p : by_d;
    t.unit = least > 0 ? least : 0;
    t.power = up + 8 - t.unit;
    t.jerk = -1;
    int32_t by = LOFT_BUMP_ONE;
    for (int i = 0; i < LOFT_AXES && by > 0; i++) {
        if ((e[i].p[0] | e[i].p[1] | e[i].d[0] | e[i].d[1]) == 0)
            continue;
        int32_t accel = (period->accel[i] >> 6) * share, jerk = (period->jerk[i] >> 6) * share;
        accel -= accel >> 9;
        jerk -= jerk >> 9;
        shrink(&e[i], t.unit + t.slope + 2, t.unit);
        set_held(&t, jerk, far);
        const int32_t most = loft_part_scaled(accel, t.power);
        by = !far ? axis_part(&t, &e[i], most, by) : jumps(&t, &e[i], most) ? by : 0;
    }
    return by;
}

/* Does a change treble the pace, or more? Its tangent says nothing then. */
static bool is_far(const int32_t v2[3], const int32_t add[3])
{
    int32_t pace[3], more[3];

    set_pace(v2, pace);
    set_pace(add, more);
    return more[0] > 2 * pace[0] || more[1] > 2 * pace[1] || more[2] > 2 * pace[2];
}

/* The start of an interval is the end of the one before, but where a lower feed begins. */
int32_t loft_bump_part(const loft_period *period, const loft_knot knot[], unsigned k, int share,
                       const int32_t add[3])
{
    const int32_t v2[3] = { knot[k].is.pace.v2, knot[k + 1].is.pace.v2, knot[k + 2].is.pace.v2 },
                  top = knot[k].is.pace.top,
                  first = knot[k + 1].is.on.feed < knot[k].is.on.feed ? top : LOFT_V2_MAX;
    int32_t pace[3], more[3], some[3], part = LOFT_BUMP_ONE;

    set_pace(v2, pace);
    set_pace(add, more);
    for (int n = 0; n < 3; n++) {
        const int32_t to = by_speed(pace[n], more[n], n > 0 ? top : first);
        part = to < part ? to : part;
    }
    for (; part > 0; part /= 4) {
        for (int n = 0; n < 3; n++)
            some[n] = part_of(add[n], part);
        if (!JUMPS || !is_far(v2, some)) {
            const int32_t by = part_within(period, knot, k, share, some, false);
            return part < LOFT_BUMP_ONE ? 2 * loft_part(part, by) : by;
        }
        if (part_within(period, knot, k, share, some, true) > 0)
            return part;
    }
    return 0;
}
