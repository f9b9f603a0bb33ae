/* lib/motion/profile.c
 * SPDX-License-Identifier: MIT
 *
 * On a path with direction u, curvature vector k and its derivative k' (per mm), passed at speed v,
 * with acceleration a and jerk j along it, the vectors of velocity, acceleration and jerk are
 *
 *     u v          u a + k v^2          u j + 3 k v a + k' v^3
 *
 * With x = v^2 the second is a straight line in a and x: what it allows for a is the least of
 * straight lines in x, a concave function, and the chords between its values at x = 0, at 3/4 of
 * the cap's square (the knee) and at that lie below it. With a limit of its own for |k| x, that is
 * a cap of x, and what is left for u a does not depend on x.
 *
 * Acceleration is averaged over n beats of h seconds (course.c), so that j <= a / (n h) with the
 * largest a of that time. With a share of the jerk for k' v^3, which limits the speed, a is limited
 * by
 *
 *     a (|u| / n + 3 |k| v h) <= J h - |k'| v^3 h
 *
 * v being that of the middle of n beats, up to a n h / 2 faster than now. As a function of x the
 * right side over the left is mostly convex; its chords are lowered until they pass below it at
 * four places.
 *
 * It is asked at the start, the middle and the end of a piece; between them |k| is less than the
 * largest by an eighth of its second difference, which every k is lengthened by in advance.
 *
 * q16: x < 2^28, x k < 2^14; k' l is of the size of k, and k' v^3 h = (k' l) x (v h / l), the last
 * factor held below 2^12.
 */
#include "motion/profile.h"

#define SLOWEST LOFT_REAL(0.0005)   /* no feature is passed slower, mm/s             */
#define LEAST   LOFT_REAL(0.25)     /* nor with less acceleration from rest, mm/s^2 */
#define LSB     loft_to_acc(LOFT_REAL(0.000015258789))    /* 2^-16 */

#if LOFT_PLAN_FILTER > 1

static loft_real least(loft_real x, loft_real y)   { return x < y ? x : y; }
static loft_real most_of(loft_real x, loft_real y) { return x > y ? x : y; }

/* By how much a parabola through three may exceed the largest of them. */
static loft_real bulge_of(const loft_vec at[3], int i)
{
    const loft_acc bend = loft_to_acc(at[0].axis[i]) - 2 * loft_to_acc(at[1].axis[i]) +
                          loft_to_acc(at[2].axis[i]);
    return loft_real_abs(loft_acc_round(loft_acc_scale(bend, LOFT_UNIT(0.125))));
}

/* The largest size of three, and by how much a parabola through them may exceed it. */
static loft_real largest(const loft_vec at[3], int i)
{
    loft_real most = 0;
    for (int k = 0; k < 3; k++)
        most = loft_real_abs(at[k].axis[i]) > most ? loft_real_abs(at[k].axis[i]) : most;
    return most + bulge_of(at, i);
}

static loft_acc bend_cap(loft_acc x, loft_real accel, loft_real bend)
{
    return bend > 0 ? loft_acc_min(x, loft_acc_div(loft_to_acc(accel), bend)) : x;
}

/* The largest derivative of the parabola through three values, times the length: at one of its
 * ends. */
static loft_real change(const loft_vec at[3], int i)
{
    const loft_acc d0 = loft_to_acc(at[1].axis[i]) - loft_to_acc(at[0].axis[i]),
                   d1 = loft_to_acc(at[2].axis[i]) - loft_to_acc(at[1].axis[i]);
    const loft_acc start = 3 * d0 - d1, end = 3 * d1 - d0;
    const loft_acc a = start < 0 ? -start : start, b = end < 0 ? -end : end;
    return loft_acc_round(loft_acc_min(a > b ? a : b, loft_to_acc(LOFT_REAL_MAX)));
}

/* v h / l, the part of the piece that a beat passes, or 4095 */
static loft_real part_of(const loft_plan_piece *p, const loft_budget *b, loft_real v)
{
    const loft_acc way = loft_budget_beat(b, v), length = loft_unit_to_acc(p->length);
    return way / 4095 < length ? loft_acc_quot(way, length) : LOFT_REAL(4095);
}

/* |k'| v^3 h */
static loft_acc twist(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                      int i, loft_real v)
{
    return p->length > 0
               ? loft_acc_mul(loft_acc_mul(loft_prod(v, v), change(s->bend, i)), part_of(p, b, v))
               : 0;
}

static bool twists_within(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                          loft_real v)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (twist(p, b, s, i, v) > loft_to_acc(b->gain[i]) / 4 * 3)
            return false;
    return true;
}

/* The largest speed at which k' v^3 leaves a quarter of the jerk, to 1/64. */
static loft_real twist_cap(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                           loft_real v)
{
    while (v > SLOWEST && !twists_within(p, b, s, v)) {
        const loft_real half = v / 2;
        if (twists_within(p, b, s, half)) {
            loft_real step = v / 4;
            v = half;
            for (int n = 0; n < 5; n++, step /= 2)
                v = twists_within(p, b, s, v + step) ? v + step : v;
            return v;
        }
        v = half;
    }
    return v;
}

/* What the jerk leaves for a at speed v. */
static loft_real jerk_grip(const loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                           loft_real v)
{
    const loft_real way = loft_acc_round(loft_budget_beat(b, v) * 3);
    loft_real a = p->rest;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc  left = loft_to_acc(b->gain[i]) - twist(p, b, s, i, v);
        const loft_acc  turn = loft_prod(largest(s->bend, i), way);
        const loft_acc  both = loft_acc_ratio(loft_to_acc(largest(s->along, i)), b->filter) + turn;
        a = loft_real_cap(a, left > 0 ? loft_acc_round(left) : 0, loft_acc_round(both));
    }
    return a;
}

/* The same where the speed may yet grow by a n h / 2, but not beyond the cap. */
static loft_real jerk_grip_ahead(const loft_plan_piece *p, const loft_budget *b,
                                 const loft_arc_shape *s, loft_real v)
{
    const loft_real a = jerk_grip(p, b, s, v);
    const loft_real more = loft_acc_round(loft_budget_beat(b, a) * b->filter / 2);
    return jerk_grip(p, b, s, more < p->cap - v ? v + more : p->cap);
}

static void lower(loft_real bound[2], loft_real most, loft_real end)
{
    bound[0] = least(bound[0], most);
    bound[1] = least(bound[1], end);
}

/* Lower the first chord until it passes below at 1/4, 1/2 and 3/4 of the cap, x = 1/16, 4/16, 9/16
 * of its square. The second is nearly the curve: 1/24 less for what it lies above it. */
static void set_jerk_lines(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s)
{
    const loft_real slow = jerk_grip_ahead(p, b, s, 0), top = jerk_grip(p, b, s, p->cap);
    const loft_real at = loft_mul(p->cap, LOFT_REAL(0.8660254)),
                    most = jerk_grip_ahead(p, b, s, at);
    const bool      bent = top < slow;
    const loft_real high = bent ? most - most / 24 : most;
    loft_real rest = slow;

    for (int k = 1; k <= 3; k++) {
        const loft_real v = loft_acc_round(loft_acc_ratio(loft_to_acc(p->cap) * k, 4));
        const loft_acc f = loft_to_acc(jerk_grip_ahead(p, b, s, v)) * 12 -
                           loft_to_acc(high) * (k * k);
        rest = least(rest, f > 0 ? loft_acc_round(loft_acc_ratio(f, 12 - k * k)) : 0);
    }
    rest    = rest > high ? rest : high;
    p->rest = least(p->rest, rest > LEAST ? rest : LEAST);
    lower(p->fore, high, bent ? top - top / 24 : top);
    lower(p->back, high, bent ? top - top / 24 : top);
}

/* The size of a direction or curvature at a station, or the largest on all of the piece (station
 * 3). */
static loft_real size_at(const loft_vec at[3], int k, int i)
{
    return k < 3 ? loft_real_abs(at[k].axis[i]) : largest(at, i);
}

/* The length of the curvature vector likewise, rounded up. */
static loft_real bend_at(const loft_arc_shape *s, int k)
{
    loft_acc bend[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        bend[i] = loft_to_acc(size_at(s->bend, k, i));
    return loft_acc_round(
        loft_acc_min(loft_acc_hypot(bend, LOFT_AXES) + LSB / 2, loft_to_acc(LOFT_REAL(32767))));
}

/* What the limits of acceleration leave for a at the square x of the speed, at any of the three
 * stations. */
static loft_real accel_grip(const loft_budget *b, const loft_arc_shape *s, loft_acc x, bool fore)
{
    loft_real a = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real most = largest(s->bend, i), bulge = bulge_of(s->along, i);
        for (int k = 0; k < 3; k++) {
            const loft_real u = s->along[k].axis[i], k_i = s->bend[k].axis[i],
                            size = loft_real_abs(u);
            /* does the bend need the other direction? */
            const bool      more = size > bulge && ((u < 0) == (k_i < 0)) != fore;
            const loft_acc used = b->across > 0
                                      ? 0
                                      : loft_acc_mul(x, size > bulge ? loft_real_abs(k_i) : most);
            const loft_acc  left = loft_to_acc(b->accel[i]) + (more ? used : -used);
            a = loft_real_cap(a, left > 0 ? loft_acc_round(left) : 0, size + bulge);
        }
    }
    return a;
}

static void set_lines(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s)
{
    p->rest = LOFT_ACCEL_MAX;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc jerk = loft_to_acc(b->gain[i]) * b->filter, accel = loft_to_acc(b->accel[i]);
        p->rest = loft_real_cap(p->rest, loft_acc_round(loft_acc_min(jerk, accel)),
                                largest(s->along, i));
    }
    const loft_acc top = loft_prod(p->cap, p->cap);
    p->fore[0] = accel_grip(b, s, top / 4 * 3, true);
    p->fore[1] = accel_grip(b, s, top, true);
    p->back[0] = accel_grip(b, s, top / 4 * 3, false);
    p->back[1] = accel_grip(b, s, top, false);
    set_jerk_lines(p, b, s);
}

/* The square of the speed that directions and curvature allow at a station, or on all of the piece
 * (station 3). */
static loft_acc station_cap(const loft_budget *b, const loft_arc_shape *s, int k, loft_real feed)
{
    loft_real v = feed;
    loft_acc  x;

    for (int i = 0; i < LOFT_AXES; i++)
        v = loft_real_cap(v, b->max_speed[i], size_at(s->along, k, i));
    x = loft_prod(v, v);
    if (b->across > 0)
        return bend_cap(x, b->across, bend_at(s, k));
    for (int i = 0; i < LOFT_AXES; i++)
        x = bend_cap(x, b->accel[i], size_at(s->bend, k, i));
    return x;
}

static void set_bounds(loft_plan_piece *p, const loft_budget *b, const loft_arc_shape *s,
                       loft_real feed)
{
    p->cap = twist_cap(p, b, s, loft_acc_sqrt(station_cap(b, s, 3, feed)));
    set_lines(p, b, s);
    p->stop = p->sure = false;
    p->brake = 0;
    p->ease.width = 0;
}

bool loft_profile_init(loft_plan_piece *p, const loft_budget *b, const loft_arc *arc,
                       const loft_arc_shape *shape, loft_real feed)
{
    loft_arc_shape s = *shape;
    loft_acc low = loft_prod(feed, feed), high = 0;

    for (int k = 0; k < 3 && s.tight; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s.bend[k].axis[i] = 0;
    p->length = loft_unit_round(arc->length);
    set_bounds(p, b, &s, feed);
    for (int k = 0; k < 3; k++) {
        const loft_acc x = station_cap(b, &s, k, feed);
        low  = x < low ? x : low;
        high = x > high ? x : high;
    }
    return high - low <= low / 16;
}

/* The largest part of the jerk that k' v^3 uses at the cap, on any axis. */
static loft_unit twist_of(const loft_plan_piece *p, const loft_budget *b,
                          const loft_arc_shape *shape)
{
    loft_unit most = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc  used = twist(p, b, shape, i, p->cap), gain = loft_to_acc(b->gain[i]);
        const loft_unit part = loft_unit_ratio(loft_acc_min(used, gain), gain);
        most = part > most ? part : most;
    }
    return most;
}

/* The part of the jerk that k' v^3 uses beside a joint passed at speed v. */
static loft_unit twist_at(const loft_way *w, loft_real v)
{
    if (!(v < w->cap))
        return w->twist;
    const loft_unit z = loft_unit_ratio(loft_to_acc(v), loft_to_acc(w->cap));
    return loft_unit_round(
        loft_acc_scale(loft_acc_scale(loft_acc_scale(loft_unit_to_acc(w->twist), z), z), z));
}

void loft_flank_init(loft_flank *side, const loft_way *way)
{
    side->way = *way;
    for (int k = 0; k < 2; k++) {
        side->along[k] = way->along;
        side->bend[k]  = way->bend;
    }
}

/* Take in the parabola through three. */
static void take_in(loft_vec range[2], const loft_vec at[3])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real bulge = bulge_of(at, i);
        for (int k = 0; k < 3; k++) {
            const loft_real x = at[k].axis[i];
            range[0].axis[i] = least(range[0].axis[i], x - bulge);
            range[1].axis[i] = most_of(range[1].axis[i], x + bulge);
        }
    }
}

/* Of two uses of the jerk that grow with v^3 the larger one, at the lower cap. */
void loft_flank_add(loft_flank *side, const loft_plan_piece *p, const loft_budget *b,
                    const loft_arc_shape *shape)
{
    const loft_way piece = loft_profile_way(p, b, shape, 0);
    const loft_real cap = least(side->way.cap, piece.cap);
    const loft_unit one = twist_at(&side->way, cap), other = twist_at(&piece, cap);

    side->way.twist = one > other ? one : other;
    side->way.cap   = cap;
    take_in(side->along, shape->along);
    if (!shape->tight)
        take_in(side->bend, shape->bend);
}

/* A jump d of the curvature at speed v is one of acceleration, v^2 d, which the spline of the
 * samples spreads over beats: jerk 3/4 v^2 d / h; another one may follow `spacing` further, within
 * the four beats that the spline covers. */
loft_acc loft_profile_jump(const loft_budget *b, const loft_way *before, const loft_way *after,
                           loft_acc spacing, loft_real feed)
{
    const loft_acc most_seen = loft_acc_min(spacing, loft_to_acc(LOFT_REAL(64)));
    const loft_plan_piece gap = { .length = loft_unit_round(most_seen) };
    const loft_real seen = part_of(&gap, b, feed);
    loft_acc x = loft_prod(LOFT_SPEED_MAX, LOFT_SPEED_MAX);

    for (int i = 0; i < LOFT_AXES; i++) {
        /* below 2^15 */
        const loft_acc jump = loft_to_acc(after->bend.axis[i]) - loft_to_acc(before->bend.axis[i]);
        const loft_acc most = loft_acc_div(loft_to_acc(b->gain[i]), LOFT_REAL(1) + 3 * seen);
        x = bend_cap(x, loft_acc_round(most), loft_acc_round(jump < 0 ? -jump : jump));
    }
    return x;
}

/* The way that uses as much of the jerk as easing does, at most at the cap: so v^2 d is less than
 * twice the acceleration. */
static loft_way ease_way(const loft_plan_piece *p, const loft_budget *b)
{
    loft_plan_piece ramp = { .length = p->ease.width, .cap = p->cap };
    loft_arc_shape s = { .tight = false };

    for (int i = 0; i < LOFT_AXES; i++) {
        s.bend[1].axis[i] = p->ease.jump[i] / 16 * 7;       /* a little more than its slope */
        s.bend[2].axis[i] = p->ease.jump[i] / 8 * 7;
    }
    ramp.cap = twist_cap(&ramp, b, &s, p->cap);
    return loft_profile_way(&ramp, b, &s, 0);
}

/* What passing a joint at speed v uses of the jerk: four fifths at `turn` for the change of
 * direction, or at `bend` for that of curvature, and what the pieces use beside it. A turn's part
 * grows with v, so that the chord of the square must lie lower: as much as at `turn`. */
typedef struct {
    loft_real turn, bend;       /* speeds */
    bool      eased;
    loft_way  ease;
} joint;

static loft_unit joint_use(const joint *j, loft_real v, const loft_way *before,
                           const loft_way *after)
{
    const bool      turns = j->turn < j->bend;
    const loft_real slow  = turns ? j->turn : j->bend;
    const loft_unit w = v < slow ? loft_unit_ratio(loft_to_acc(v), loft_to_acc(slow))
                                 : LOFT_UNIT(1);
    const loft_acc  part = loft_acc_scale(loft_to_acc(LOFT_REAL(0.8)), w);
    const loft_unit first = twist_at(before, v), second = twist_at(after, v),
                    most = first > second ? first : second;

    if (j->eased)
        return most + twist_at(&j->ease, v) +
               (v < j->turn ? loft_unit_ratio(loft_to_acc(v) / 5 * 4, loft_to_acc(j->turn))
                            : LOFT_UNIT(0.8));
    return loft_unit_round(turns ? part : loft_acc_scale(part, w)) + most;
}

static void leave_for_joint(loft_plan_piece *p, const joint *j, const loft_way *before,
                            const loft_way *after)
{
    loft_unit used = joint_use(j, p->cap, before, after);

    while (used > LOFT_UNIT(0.97)) {
        p->cap -= p->cap / 16;
        used = joint_use(j, p->cap, before, after);
    }
    const loft_unit left = LOFT_UNIT(1) - used;
    if (j->eased || j->turn < j->bend)
        p->rest = loft_acc_round(loft_acc_scale(loft_to_acc(p->rest), LOFT_UNIT(0.8)));
    for (int k = 0; k < 2; k++) {
        p->fore[k] = loft_acc_round(loft_acc_scale(loft_to_acc(p->fore[k]), left));
        p->back[k] = loft_acc_round(loft_acc_scale(loft_to_acc(p->back[k]), left));
    }
}

/* The path is moved aside by g d. On its way to the joint the curvature goes beyond its own by p c
 * = 0.1757 of the jump, then half way to the other side, and likewise behind it; meanwhile its own
 * may change, too. Its direction turns by g' d. So the largest size u of a direction, with g' d,
 * and the least and the largest curvature there hold the acceleration everywhere: u a + k v^2 is
 * linear in each of them, and where u or a have the other sign or are smaller it is not beyond k
 * v^2. If the direction changes its sign each curvature may meet either. */
static void ease_bounds(loft_plan_piece *p, const loft_budget *b, const loft_flank *before,
                        const loft_flank *after, loft_real feed)
{
    loft_arc_shape s = { .tight = false };
    const loft_ease e = p->ease;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real beyond = e.jump[i] / 17 * 3, half = e.jump[i] / 2,
                        size = loft_real_abs(e.jump[i]);
        const loft_real turn = loft_acc_round(
            loft_acc_ratio(loft_acc_scale(loft_to_acc(size), e.width), 9));
        const loft_real u0 = least(before->along[0].axis[i], after->along[0].axis[i]),
                        u1 = most_of(before->along[1].axis[i], after->along[1].axis[i]);
        loft_real low = least(before->bend[0].axis[i] + least(-beyond, half),
                              after->bend[0].axis[i] + least(beyond, -half));
        loft_real high = most_of(before->bend[1].axis[i] + most_of(-beyond, half),
                                 after->bend[1].axis[i] + most_of(beyond, -half));
        if (u0 - turn < 0 && u1 + turn > 0) {
            high = most_of(high, -low);
            low  = -high;
        }
        for (int k = 0; k < 3; k++) {
            s.along[k].axis[i] = u1 > -u0 ? u1 + turn : u0 - turn;
            s.bend[k].axis[i]  = k == 0 ? low : k == 1 ? low / 2 + high / 2 : high;
        }
    }
    set_bounds(p, b, &s, feed);
    p->ease = e;
}

/* Ease the change of curvature if that can be passed faster than the change itself. */
static joint ease(loft_plan_piece *p, const loft_budget *b, const loft_flank *before,
                  const loft_flank *after, joint j, loft_acc room, loft_real feed)
{
    const loft_acc jump = loft_vec_distance(before->way.bend, after->way.bend);

    for (int i = 0; i < LOFT_AXES; i++)
        p->ease.jump[i] = after->way.bend.axis[i] - before->way.bend.axis[i];
    p->ease.width = loft_ease_width(b, jump, room);
    if (p->ease.width > 0)
        j.ease = ease_way(p, b);
    j.eased = p->ease.width > 0 && j.ease.cap > j.bend;
    if (j.eased) {
        ease_bounds(p, b, before, after, feed);
        j.bend  = j.ease.cap;
        p->cap -= loft_acc_round(
            loft_acc_ratio(loft_acc_scale(loft_acc_mul(jump, p->cap), p->ease.width), 9));
    } else
        p->ease.width = 0;
    return j;
}

bool loft_profile_join(loft_plan_piece *p, const loft_budget *b, const loft_flank *before,
                       const loft_flank *after, loft_acc spacing, loft_acc room, loft_real feed)
{
    const loft_way *w0 = &before->way, *w1 = &after->way;
    const loft_arc_shape s = { false,
                               { w0->along, w1->along, w1->along },
                               { w0->bend, w1->bend, w1->bend } };
    const loft_acc turn = loft_budget_joint(b, &w0->along, &w1->along, spacing, true),
                   feed2 = loft_prod(feed, feed);
    const loft_acc bend = loft_profile_jump(b, w0, w1, spacing, feed);

    p->length = 0;
    if (turn / 1024 > feed2 && bend / 32 > feed2)
        return false;
    set_bounds(p, b, &s, feed);

    const joint j = ease(p, b, before, after,
                         (joint){ .turn = loft_acc_sqrt(turn), .bend = loft_acc_sqrt(bend) }, room,
                         feed);
    const loft_real slow = least(j.turn, j.bend);
    p->stop = slow < loft_acc_round(loft_acc_scale(loft_to_acc(p->rest), b->pulse) / 4);
    if (p->stop) {
        p->ease.width = 0;
        return true;
    }
    p->cap = least(p->cap, slow);
    leave_for_joint(p, &j, w0, w1);
    return true;
}

#endif

loft_way loft_profile_way(const loft_plan_piece *p, const loft_budget *b,
                          const loft_arc_shape *shape, int k)
{
    loft_way way = { .along = shape->along[k] };

    if (!shape->tight)
        way.bend = shape->bend[k];
#if LOFT_PLAN_FILTER > 1
    way.cap = p->cap;
    if (LOFT_BUDGET_JERK(b) && !shape->tight)
        way.twist = twist_of(p, b, shape);
#else
    (void)p;
    (void)b;
#endif
    return way;
}

loft_real loft_profile_grip(const loft_plan_piece *p, loft_acc x, bool fore)
{
    const loft_acc   most = loft_prod(p->cap, p->cap), knee = most / 4 * 3;
    const loft_real *at   = fore ? p->fore : p->back;

    if (!(x < most))
        return at[1];
    if (x < knee)
        return loft_lerp(p->rest, at[0], loft_unit_ratio(x, knee));
    return loft_lerp(at[0], at[1], loft_unit_ratio(x - knee, most - knee));
}
