/* lib/path/corner.c
 * SPDX-License-Identifier: MIT
 *
 * From rest, with jerk j in a period, a path is at X(n) = j n^3 / 6 after n periods. A corner that
 * is passed at speed v = j t^2 / 2 is like a rest that lies X(t) beyond it: at a distance x from it
 * the launch has lasted N = cbrt(6 (x + X(t)) / j) periods, and a period later, or before, it is at
 * X(N +- 1). The next place is the nearest that any corner, or the cap of speed, allows.
 *
 * A launch to the speed v has at most the jerk of the axes, and what acceleration a allows. With
 * 2 a^2 / v it reaches v in the time v / a, as even acceleration does, and has 2 a in the end. If
 * that is longer than a window of a guess (guess.h), places would be too far apart there to brake
 * for when the next window is known. So from LONG periods on it is a^2 / (2 v), and ends with a:
 * where there is a guess.
 *
 * The size of a corner is measured at the scale of the tolerance. Let a and b be the points of the
 * path at the distance l before and behind a joint P, with l = 1, 2, 4, 8, 16 times the tolerance.
 * If P is nearer to the middle of a and b than 0.65 tol the tolerance swallows it. Otherwise it
 * turns by w = |a + b - 2 P| / l, and may be passed at
 *
 *     v = min(sqrt(8 a tol), 2.9 (j tol^2)^(1/3)) / w
 *
 * since a change of velocity v w that takes T = sqrt(4 v w / j) leaves the corner by j T^3 / 40.
 *
 * A place goes onto each sharp joint, but not onto two within a quarter of a period.
 *
 * Where corners have a larger tolerance, that is the one at joints that turn by more than 5
 * degrees, at the scale of the tolerance as well. It holds on ways from a place to the next that
 * are wholly within 31 times itself from them.
 *
 * A joint of chords is a part of a bend, not a corner, where a curve in the tolerance follows it.
 * Let the path turn by w around the joint, on the way s: as far as it turns by about a radian, at
 * most 128 tol to each side, less where it begins or ends. Then its curvature is k = 2 w / s. If
 * what that explains of the second differences, k l^2, leaves no more than 5/2 tol of them at any
 * scale, and w is larger than the turn of the joint alone by a quarter, no place goes onto it.
 * Chords that are off their curve by the tolerance leave 2 tol at half of their length, and few
 * decimals some more. So neither the feed nor the length of chords says what a corner is.
 *
 * Curves turn by too little at that scale. Where one of more than 16 tol is tightest, with the
 * curvature k, it is passed at sqrt(a / k): if that is less than half of the cap it is a corner as
 * well. So places come to the tip of a bend at a distance that shrinks slowly. The tip of a bend
 * of chords is the joint with the largest k, passed at min(sqrt(a / k), cbrt(j / k^2)): where k was
 * less by a third before, and grows no more as far as is seen. While it grows, the last tip lasts
 * until the next one.
 *
 * Where the cubic through places at the cap would skip more than a quarter of the tolerance, ways
 * are shorter as long as that lasts: at the largest k, or on chords, where half of their sag is
 * taken off the tolerance, and a fifth of what is left is for the cubic and for the mean (path.c).
 * Such a corner lasts, so one is enough for a whole circle. Corners are also where the
 * cap of speed depends on the direction, or the feed changes: where the next arc has a cap that is
 * larger or smaller by more than an eighth, the joint is passed at the smaller one.
 */
#include "path/corner.h"

#define ONE         LOFT_CORNER_ONE
#define TIME_MAX    ((int32_t)4096 * ONE)
#define FAR         ((int64_t)1 << 34)              /* what is farther has no effect */
#define NEARER      ((int64_t)1 << 31)              /* from here on times are rounded to 2^-7 */
#define WAY_MAX     ((loft_coord)1 << 30)
#define GUESSED     (LOFT_PLAN_EFFORT > 1)          /* places are a guess, made again */
#define SHORT       51                              /* periods of a ramp, */
#define LONG        64                              /* and of one that is long for a guess */
#define CAP_MAX     (4 * LOFT_COORD_MM)
#define UNIT        LOFT_CHAIN_UNIT
#define SHARP       LOFT_CHAIN_SHARP
#define SCALES      5
#define WIDE        7                               /* doublings of tol around a bend, */
#define FAR_MAX     ((loft_coord)1 << 28)           /* and no farther than this */
#define KINK        (UNIT / 400)                    /* what turns by less is smooth */
#define BOW         (8 * LOFT_COORD_GRAIN)          /* of an arc that is not rounding alone */
#define CLOSE       4                               /* parts of a period */
#define HALF        (LOFT_CORNERS_STRETCHES / 2)
#define NEAR        31                              /* tolerances of a corner */
#define EVEN        8                               /* of a cap: by a part it may change at once */


// Launches
// --------

/* X(n). */
static int64_t launched(loft_coord jerk, int32_t n)
{
    const int64_t most = (int64_t)1 << 41, v = (int64_t)jerk * n >> 4,
                  x = v < most ? v * n >> 10 : v;
    return n >= TIME_MAX || x >= most ? 4 * FAR : (x * n >> 10) / (6 * 64);
}

/* N(x). */
static int32_t launch_time(loft_coord jerk, int64_t x)
{
    const uint32_t n = x < NEARER ? loft_coord_cbrt(((uint64_t)x * 6 << 30) / (uint32_t)jerk)
                       : x < FAR  ? loft_coord_cbrt(((uint64_t)x * 6 << 21) / (uint32_t)jerk) << 3
                                  : TIME_MAX;
    return n < TIME_MAX ? (int32_t)n : TIME_MAX;
}

/* The least that the axes allow along a direction. */
static loft_coord along(const loft_coord limit[], const int16_t u[])
{
    int64_t most = CAP_MAX * (int64_t)16;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(u[i]);
        if (part * most > (int64_t)limit[i] * UNIT)
            most = (int64_t)limit[i] * UNIT / part;
    }
    return (loft_coord)most;
}

loft_coord loft_corner_jerk(const loft_period *p, const int16_t u[], loft_coord cap)
{
    const int64_t a = along(p->accel, u), ramp = cap / a,
                  times = !GUESSED || ramp <= SHORT ? 8
                          : ramp < LONG ? 8 - 6 * (ramp - SHORT) / (LONG - SHORT)
                                                    : 2,
                  soft = a * a * times / (4 * (int64_t)cap);
    loft_coord jerk = soft < CAP_MAX ? (loft_coord)soft + 1 : CAP_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(u[i]);
        if (p->jerk[i] > 0 && part * jerk > (int64_t)p->jerk[i] * UNIT)
            jerk = (loft_coord)((int64_t)p->jerk[i] * UNIT / part) + 1;
    }
    return jerk;
}

loft_coord loft_corner_cap(const loft_period *p, const int16_t u[], loft_coord feed)
{
    return loft_coord_least(loft_coord_least(along(p->speed, u), feed), CAP_MAX) + 1;
}


// Stretches
// ---------

/* Is `after` so short, or so straight, that it may belong to the stretch before? At a tip arcs
 * become shorter and shorter: too many of them would hide what is around a joint. What bends by
 * less than a 32nd of the tolerance is one. */
static bool is_scrap(const loft_corners *c, const loft_corner_stretch *before,
                     const loft_corner_stretch *after)
{
    const loft_period *p = c->chain->period;
    const int64_t length = before->length + (int64_t)after->length,
                  turn = loft_chain_turn(before->from, after->to);

    return length <= p->tol + p->more && turn <= (int64_t)UNIT * UNIT &&
           length * loft_coord_sqrt((uint64_t)turn) <= p->tol / 4 * (int64_t)UNIT &&
           loft_chain_turn(before->to, after->from) <= (int64_t)SHARP * SHARP;
}

static void add_stretch(loft_corners *c)
{
    loft_corner_stretch e;
    const loft_chain_walk *w = &c->walk;
    loft_corner_stretch *last = &c->stretch[c->stretches > 0 ? c->stretches - 1u : 0];

    loft_chain_place(w, w->s, &e.at);
    loft_chain_direction(w, 0, e.from);
    loft_chain_direction(w, 2, e.to);
    e.length = w->length;
    e.cap = loft_coord_least(loft_corner_cap(c->chain->period, e.from, w->feed),
                             loft_corner_cap(c->chain->period, e.to, w->feed));
    if (c->stretches == 0 || !is_scrap(c, last, &e)) {
        c->stretch[c->stretches++] = e;
        return;
    }
    last->length += e.length;
    last->cap = loft_coord_least(last->cap, e.cap);
    for (int i = 0; i < LOFT_AXES; i++)
        last->to[i] = e.to[i];
}

/* How far the path leads in a stretch within l of its start, or back from its end. */
static void bow(const loft_corner_stretch *e, bool back, loft_coord l, loft_coord out[])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t bend = (int64_t)(e->to[i] - e->from[i]) * l / e->length * l / 2;
        out[i] = (loft_coord)((back ? bend - (int64_t)e->to[i] * l
                                    : e->from[i] * (int64_t)l + bend) /
                              UNIT);
    }
}

static bool is_sharp(const loft_corner_stretch *before, const loft_corner_stretch *after)
{
    return loft_chain_turn(before->to, after->from) > (int64_t)SHARP * SHARP;
}

/* The place l before or behind the start of stretch i, from there; less far off where no more is
 * known, or, `near`, where a joint is sharp that is not: that is a corner for itself. Gives how
 * far. */
static loft_coord reach(const loft_corners *c, unsigned i, bool back, loft_coord l, bool near,
                        loft_coord out[])
{
    const loft_corner_stretch *e = c->stretch;
    const loft_position at = e[i].at;
    const bool stops = near && !is_sharp(&e[i - 1], &e[i]);
    unsigned k = back ? i - 1 : i;
    loft_coord left = l;

    while (left > e[k].length) {
        const unsigned joint = back ? k : k + 1;
        if (joint == (back ? 0 : c->stretches) || (stops && is_sharp(&e[joint - 1], &e[joint]))) {
            l -= left - e[k].length;
            left = e[k].length;
            break;
        }
        left -= e[k].length;
        k = back ? k - 1 : k + 1;
    }
    const loft_position *from = &e[back ? k + 1 : k].at;
    bow(&e[k], back, left, out);
    for (int j = 0; j < LOFT_AXES; j++)
        out[j] += loft_coord_sub(from->axis[j], at.axis[j]);
    return l;
}

/* What the axes allow across the path, where its velocity changes along v: by that much. */
typedef struct {
    int64_t accel, jerk;
    bool    soft;           /* is jerk limited? */
} across;

static across allowed_along(const loft_period *p, const loft_coord v[])
{
    const int64_t size = loft_coord_length(v) + 1;
    across most = { CAP_MAX, CAP_MAX, false };

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(v[i]) + 1;
        if (part * most.accel > (int64_t)p->accel[i] * size)
            most.accel = (int64_t)p->accel[i] * size / part;
        if (p->jerk[i] > 0 && part * most.jerk > (int64_t)p->jerk[i] * size)
            most.jerk = (int64_t)p->jerk[i] * size / part;
        most.soft = most.soft || p->jerk[i] > 0;
    }
    return most;
}

/* The most change of velocity along v that the tolerance swallows. */
static loft_coord swing(const loft_period *p, loft_coord tol, const loft_coord v[])
{
    const across most = allowed_along(p, v);
    const uint64_t change = (uint64_t)most.jerk * (uint64_t)tol / 4096 * (uint64_t)tol / 4096;
    const loft_coord by_accel = (loft_coord)loft_coord_sqrt((uint64_t)(8 * most.accel * tol)),
                     by_jerk = (loft_coord)(29 * (int64_t)loft_coord_cbrt(change) * 256 / 10);
    return most.soft ? loft_coord_least(by_accel, by_jerk) : by_accel / 2;
}

/* By what the path turns at the joint before stretch i, at the scale l; false: not known. */
static bool turn_at(const loft_corners *c, unsigned i, loft_coord l, loft_coord out[])
{
    loft_coord b[LOFT_AXES];

    if (reach(c, i, true, l, true, out) < l || reach(c, i, false, l, true, b) < l)
        return false;
    for (int j = 0; j < LOFT_AXES; j++)
        out[j] += b[j];
    return true;
}

/* Does the joint before stretch i have the tolerance of corners? */
static bool is_corner(const loft_corners *c, unsigned i)
{
    const loft_coord tol = c->chain->period->tol;
    loft_coord a[LOFT_AXES];

    return c->chain->period->more > 0 && is_sharp(&c->stretch[i - 1], &c->stretch[i]) &&
           turn_at(c, i, tol, a) && (int64_t)loft_coord_length(a) * UNIT > (int64_t)tol * SHARP;
}

/* How a path turns around a joint. */
typedef struct {
    loft_coord turn[LOFT_AXES];     /* between its directions before and behind, 2^-14, */
    loft_coord size;                /* so much, */
    int64_t    way;                 /* on this way */
} bend;

/* Does the path, which is at x after that way along u, turn by more than half a radian off it? */
static bool strays(const loft_coord x[], const int16_t u[], loft_coord way)
{
    loft_coord off[LOFT_AXES];

    for (int j = 0; j < LOFT_AXES; j++)
        off[j] = x[j] - (loft_coord)((int64_t)u[j] * way / UNIT);
    return 2 * (int64_t)loft_coord_length(off) > way;
}

/* As far around the joint before stretch i as it turns by about a radian. */
static bend bend_at(const loft_corners *c, unsigned i)
{
    const loft_coord tol = c->chain->period->tol;
    loft_coord a[LOFT_AXES], b[LOFT_AXES], l = loft_coord_least(tol, FAR_MAX >> WIDE) << WIDE, back,
                                           on;
    int16_t u[LOFT_AXES];

    for (int j = 0; j < LOFT_AXES; j++)
        u[j] = (int16_t)-c->stretch[i - 1].to[j];
    for (;; l /= 2) {
        back = reach(c, i, true, l, false, a);
        on   = reach(c, i, false, l, false, b);
        if (l <= tol || !(strays(a, u, back) || strays(b, c->stretch[i].from, on)))
            break;
    }
    bend near = { .way = (int64_t)back + on };
    for (int j = 0; j < LOFT_AXES; j++)
        near.turn[j] = (loft_coord)((int64_t)a[j] * UNIT / back + (int64_t)b[j] * UNIT / on);
    near.size = loft_coord_length(near.turn);
    return near;
}

/* Is the joint before stretch i a part of the bend alone? What the bend explains of its second
 * differences, turn * 2 l^2 / way, is taken off them; and it turns by more than the joint does. */
static bool is_bend(const loft_corners *c, unsigned i, loft_coord tol, const bend *near)
{
    loft_coord a[LOFT_AXES];
    int64_t dot = 0, size = 0;

    for (int k = 0; k < SCALES && turn_at(c, i, tol << k, a); k++) {
        const int64_t l = (int64_t)tol << k;
        dot = 0;
        size = (int64_t)loft_coord_length(a) * UNIT / l;
        for (int j = 0; j < LOFT_AXES; j++) {
            dot += (int64_t)a[j] * UNIT / l * near->turn[j];
            a[j] -= (loft_coord)(near->turn[j] * l / UNIT * 2 * l / near->way);
        }
        if (loft_coord_length(a) > tol / 2 * 5)
            return false;
    }
    return size > 0 && 4 * dot >= 5 * size * size;
}

static loft_coord bend_radius(const bend *near)
{
    const int64_t r = near->way * UNIT / (2 * (int64_t)near->size + 1);
    return r < INT32_MAX ? (loft_coord)r : INT32_MAX;
}

/* The speed with which the axes can follow it: the curvature is 2 turn / way. */
static loft_coord bend_speed(const loft_period *p, const bend *near)
{
    const across most = allowed_along(p, near->turn);
    const int64_t r = bend_radius(near);
    int thirds = 0;

    while (r >> 3 * thirds >= INT64_C(1) << 17)
        thirds++;
    const uint64_t part = (uint64_t)(r >> 3 * thirds);
    const int64_t by_accel = loft_coord_sqrt((uint64_t)(most.accel * r)),
                  by_jerk = (int64_t)loft_coord_cbrt((uint64_t)most.jerk * part * part)
                            << 2 * thirds,
                  speed = most.soft && by_jerk < by_accel ? by_jerk : by_accel;
    return speed < CAP_MAX ? (loft_coord)speed : CAP_MAX;
}

/* The speed with which the joint before stretch i may be passed. */
static loft_coord joint_speed(const loft_corners *c, unsigned i, loft_coord tol)
{
    const loft_period *p = c->chain->period;
    loft_coord speed = CAP_MAX, a[LOFT_AXES];

    for (int k = 0; k < SCALES && turn_at(c, i, tol << k, a); k++) {
        const loft_coord size = loft_coord_length(a);
        if ((int64_t)size * 10 > (int64_t)tol * 13) {
            const int64_t v = ((int64_t)swing(p, tol, a) << k) * tol / size;
            speed = v < speed ? (loft_coord)v : speed;
        }
    }
    return speed;
}

static void drop_zone(loft_corners *c)
{
    c->zones--;
    for (unsigned k = 0; k < c->zones; k++)
        c->zone[k] = c->zone[k + 1];
}

/* It is near a corner at s. Zones that meet are one. */
static void add_zone(loft_corners *c, int64_t s)
{
    const loft_period *p = c->chain->period;
    const int64_t reach = (int64_t)(p->tol + p->more) * NEAR;
    loft_corner_zone *last = &c->zone[c->zones > 0 ? c->zones - 1u : 0];

    if (c->zones > 0 && s - reach <= last->to) {
        last->to = s + reach;
        return;
    }
    if (c->zones == LOFT_CORNERS_ZONES)
        drop_zone(c);
    c->zone[c->zones++] = (loft_corner_zone){ s - reach, s + reach };
}

bool loft_corners_loose(const loft_corners *c, int64_t from, int64_t to)
{
    bool inside = false;

    for (unsigned k = 0; k < c->zones; k++)
        inside = inside || (c->zone[k].from <= from && to <= c->zone[k].to);
    return inside;
}

void loft_corners_drop_zones(loft_corners *c, int64_t s, bool one)
{
    while (c->zones > 0 && c->zone[0].to < s)
        drop_zone(c);
    if (c->zones == LOFT_CORNERS_ZONES && one)
        drop_zone(c);
}


// Corners
// -------

loft_corner loft_corner_of(int64_t s, loft_coord speed, loft_coord jerk, bool sharp)
{
    loft_corner k = { .s = s, .jerk = jerk, .on = sharp ? -1 : 0 };

    k.time = (int32_t)loft_coord_sqrt(((uint64_t)(uint32_t)speed * 2 << 20) / (uint32_t)jerk);
    const int64_t way = launched(jerk, k.time);
    k.way = way < WAY_MAX ? (loft_coord)way : WAY_MAX;
    if (way > WAY_MAX)
        k.time = launch_time(jerk, WAY_MAX);
    return k;
}

/* Where it ends to last. */
static int64_t end_of(const loft_corner *k) { return k->s + (k->on > 0 ? k->on : 0); }

void loft_corners_add(loft_corners *c, loft_corner k)
{
    while (c->count > 0) {
        const loft_corner *last = &c->corner[c->count - 1];
        const int64_t off = k.s - last->s;
        if (k.on >= 0 && k.jerk >= last->jerk && last->way + k.s - end_of(last) <= k.way)
            return;
        if (last->on < 0 || last->jerk < k.jerk || k.way + off > last->way)
            break;
        c->count--;
    }
    c->corner[c->count++] = k;
}

loft_corner loft_corners_last(const loft_corners *c, bool ends)
{
    const loft_corner_stretch *e = &c->stretch[c->stretches - 1];
    return loft_corner_of(c->known, 0, loft_corner_jerk(c->chain->period, e->to, e->cap), ends);
}

static int64_t scanned(const loft_corners *c) { return c->walk.s + c->walk.length; }

/* The start of stretch `looked`: corners are known before it. */
static int64_t known(const loft_corners *c)
{
    int64_t s = scanned(c);

    for (unsigned k = c->looked; k < c->stretches; k++)
        s -= c->stretch[k].length;
    return s;
}

/* Is it passed so soon after a sharp one? Places on both would be a stop: a period for so short a
 * way. */
static bool is_close(const loft_corners *c, int64_t s, loft_coord speed)
{
    const loft_corner *last = &c->corner[c->count > 0 ? c->count - 1u : 0];
    return c->count > 0 && last->on < 0 && s - last->s < speed / CLOSE;
}

/* With which it is passed: j t^2 / 2. */
static int64_t speed_of(const loft_corner *k)
{
    return ((int64_t)k->jerk * k->time >> 10) * k->time >> 11;
}

/* Does the last one go on to s, with nearly that speed? */
static bool goes_on(loft_corners *c, int64_t s, loft_coord speed)
{
    loft_corner *last = &c->corner[c->count > 0 ? c->count - 1u : 0];

    if (c->count == 0 || last->on < 0 || s - end_of(last) > 4 * (int64_t)speed ||
        s - last->s > WAY_MAX)
        return false;
    const int64_t v = speed_of(last);
    if (8 * loft_long_abs(v - speed) > v)
        return false;
    last->on = (int32_t)(s - last->s);
    return true;
}

/* A corner at s between two directions, around which the cap of speed is `cap`. */
static void add_corner(loft_corners *c, int64_t s, loft_coord speed, loft_coord cap,
                       const int16_t before[], const int16_t after[], bool sharp)
{
    const loft_period *p = c->chain->period;
    const loft_coord jerk = loft_coord_least(loft_corner_jerk(p, before, cap),
                                             loft_corner_jerk(p, after, cap));

    loft_corners_add(c, loft_corner_of(s, speed > 1 ? speed : 1, jerk, sharp));
}

/* The radius of the bend of a stretch. */
static loft_coord radius_of(const loft_corner_stretch *e)
{
    const int64_t turn = (int64_t)loft_coord_sqrt((uint64_t)loft_chain_turn(e->from, e->to) << 8),
                  r = (int64_t)e->length * UNIT * 16 / (turn + 1);
    return r < INT32_MAX ? (loft_coord)r : INT32_MAX;
}

/* The speed with which the axes can follow the bend of a stretch. */
static loft_coord tip_speed(const loft_period *p, const loft_corner_stretch *e)
{
    int64_t most = (int64_t)CAP_MAX * CAP_MAX / UNIT;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(e->to[i] - e->from[i]),
                      way = (int64_t)p->accel[i] * e->length;
        if (part * most > way)
            most = way / part;
    }
    return (loft_coord)loft_coord_sqrt((uint64_t)most * UNIT);
}

/* The longest way in a bend of radius r of which the cubic through places skips no more than a
 * quarter of tol: 3 w^4 / (128 r^3) = tol / 4. */
static loft_coord bend_way(loft_coord tol, int64_t r)
{
    const uint32_t square = loft_coord_sqrt(((uint64_t)tol << 32) * 11 / (uint64_t)(r + 1));
    const int64_t way = r * loft_coord_sqrt((uint64_t)square << 16) >> 16;
    return way < CAP_MAX ? (loft_coord)way : CAP_MAX;
}

/* A bend at s, of radius r, that is passed at that speed and in ways no longer than that. While it
 * becomes tighter, the last one lasts until there. */
static void add_bend(loft_corners *c, int64_t s, loft_coord r, loft_coord speed, loft_coord way,
                     const loft_corner_stretch *before, const loft_corner_stretch *after)
{
    const loft_coord cap = loft_coord_least(before->cap, after->cap);
    loft_corner *last = c->count > 0 ? &c->corner[c->count - 1] : NULL;

    if (speed < cap / 2 && r / 7 < c->wide / 8) {
        if (last && last->on >= 0 && last->time > 0 && c->wide < INT32_MAX &&
            c->wide - c->tip <= c->tip / 8 && s - last->s < WAY_MAX)
            last->on = (int32_t)(s - last->s);
        add_corner(c, s, loft_coord_least(speed, way), cap, before->to, after->from, false);
        c->wide = c->tip = r;
    } else if (way < (int64_t)cap * LOFT_CORNER_STEP / ONE && !goes_on(c, s, way)) {
        if (!last || loft_corner_allows(last, s, ONE) - s > way)
            loft_corners_add(c, loft_corner_of(s, way, way / 128 + 1, false));
    }
}

/* The tip of a bend, if that is the stretch before `looked`: smaller ones are corners. Where the
 * path has not become wider by a seventh since the last one, it is the same bend. */
static void look_at_tip(loft_corners *c)
{
    const loft_period *p = c->chain->period;
    const loft_corner_stretch *e = &c->stretch[c->looked - 1u];
    const loft_coord r = radius_of(e);

    if ((int64_t)e->length * e->length / ((int64_t)r + 1) < 8 * BOW ||
        (r == INT32_MAX && (int64_t)e->length * e->length / 32 <= (int64_t)p->tol * c->bent))
        return;
    c->wide = loft_coord_most(c->wide, r);
    if (c->looked < 2 || e->length <= (int64_t)p->tol << (SCALES - 1) || radius_of(e - 1) <= r ||
        radius_of(e + 1) < r)
        return;
    add_bend(c, known(c) - e->length / 2, r, tip_speed(p, e), bend_way(p->tol, r), e, e);
}

/* Is the path nowhere tighter behind the joint before stretch i, as far as it is known? */
static bool is_tightest(const loft_corners *c, unsigned i, loft_coord r)
{
    while (++i < c->stretches) {
        const bend next = bend_at(c, i);
        if (bend_radius(&next) < r - r / 64)
            return false;
    }
    return true;
}

/* The joint before stretch `looked`, if it is a part of a bend. Chords are off it by half of their
 * sag. */
static bool look_at_bend(loft_corners *c, loft_coord tol)
{
    const loft_period *p = c->chain->period;
    const unsigned i = c->looked;
    const loft_corner_stretch *before = &c->stretch[i - 1], *after = &c->stretch[i];

    const bend near = bend_at(c, i);
    if (!is_bend(c, i, tol, &near))
        return false;
    const loft_coord r = bend_radius(&near), was = c->bent,
                     chord = loft_coord_most(before->length, after->length);
    const int64_t off = (int64_t)chord * chord / 16 / ((int64_t)r + 1);
    const loft_coord left = p->tube > off ? (loft_coord)(p->tube - off) : 0,
                     way = bend_way(loft_coord_most(left, p->tol / 16) / 5, r);
    if (r > c->wide)
        c->wide += (r - c->wide) / 4;
    c->bent = r;
    const bool tip = r < was && r < c->wide / 4 * 3 && is_tightest(c, i, r);
    add_bend(c, known(c), r, tip ? bend_speed(p, &near) : CAP_MAX, way, before, after);
    if (tip)
        c->wide = r;
    return true;
}

/* The joint before stretch `looked`. */
static void look_at_joint(loft_corners *c)
{
    const loft_period *p = c->chain->period;
    const int64_t s = known(c);
    const unsigned i = c->looked;
    const loft_corner_stretch *before = &c->stretch[i - 1], *after = &c->stretch[i];
    const bool corner = is_corner(c, i), sharp = is_sharp(before, after);
    const bool kinks = loft_chain_turn(before->to, after->from) > KINK * KINK;
    const loft_coord tol = p->tol + (corner ? p->more : 0),
                     slow = loft_coord_least(before->cap, after->cap),
                     fast = loft_coord_most(before->cap, after->cap);

    if (corner)
        add_zone(c, s);
    if (kinks)
        c->kink = (int32_t)(s >> (LOFT_COORD_BITS - 8));
    loft_coord speed = CAP_MAX;
    const bool bends = kinks && look_at_bend(c, tol);
    if (!bends) {
        c->bent = INT32_MAX;
        speed = joint_speed(c, i, tol);
    }
    const bool turns = !bends && speed < (sharp ? fast : slow);
    if (turns || slow < fast - fast / EVEN)
        add_corner(c, s, loft_coord_least(speed, slow), fast, before->to, after->from,
                   turns && sharp && !is_close(c, s, speed));
}

/* The largest scale at which a joint is looked at. */
static loft_coord scale_most(const loft_corners *c)
{
    const loft_period *p = c->chain->period;
    return loft_coord_most((p->tol + p->more) << (SCALES - 1),
                           loft_coord_least(p->tol, FAR_MAX >> WIDE) << WIDE);
}

/* Forget stretches that no joint to come looks back at, nor the tip of a bend: two are kept. */
static void forget(loft_corners *c)
{
    unsigned n = c->looked > 1 ? c->looked - 2u : 0;
    const loft_coord need = scale_most(c);

    for (int64_t back = c->stretch[n + 1].length; n > 0 && back + c->stretch[n].length <= need; n--)
        back += c->stretch[n].length;
    if (n == 0 && c->stretches == LOFT_CORNERS_STRETCHES && c->looked > HALF)
        n = HALF / 4;
    for (unsigned k = n; k < c->stretches; k++)
        c->stretch[k - n] = c->stretch[k];
    c->stretches = (uint8_t)(c->stretches - n);
    c->looked = (uint8_t)(c->looked - n);
}

bool loft_corners_full(const loft_corners *c)
{
    return c->count + 2 >= LOFT_CORNERS_MOST || c->zones == LOFT_CORNERS_ZONES;
}

/* Look at joints behind which enough is known, or all that will be; where there is no room for
 * more, half of it is behind a joint. */
static void look(loft_corners *c, bool all)
{
    const loft_coord need = scale_most(c);
    const bool half = c->stretches == LOFT_CORNERS_STRETCHES;

    while (c->looked < c->stretches && !loft_corners_full(c) &&
           (all || (half && c->looked <= HALF) || scanned(c) - known(c) > need)) {
        if (c->looked > 0) {
            look_at_tip(c);
            look_at_joint(c);
        }
        c->looked++;
    }
}

void loft_corners_scan(loft_corners *c, int64_t to)
{
    const loft_chain *chain = c->chain;

    while (!loft_corners_full(c) && known(c) < to) {
        if (c->stretches == LOFT_CORNERS_STRETCHES)
            forget(c);
        const bool room = c->stretches < LOFT_CORNERS_STRETCHES,
                   more = room && loft_chain_advance(chain, &c->walk);
        if (more)
            add_stretch(c);
        const unsigned before = c->looked;
        look(c, room && !more && (loft_chain_ends(chain) || chain->count == chain->room));
        if (!more && c->looked == before)
            break;
    }
    c->known = known(c);
}

bool loft_corners_end_known(const loft_corners *c)
{
    return loft_chain_ends(c->chain) && c->looked == c->stretches &&
           loft_chain_walked(c->chain, &c->walk);
}

void loft_corners_begin(loft_corners *c, const loft_chain *chain)
{
    c->chain = chain;
    loft_chain_begin(chain, &c->walk);
    c->stretches = c->looked = c->count = c->zones = 0;
    c->known = 0;
    c->kink = -1;
    c->wide = c->bent = c->tip = INT32_MAX;
}


// Where they let it be
// --------------------

int64_t loft_corner_allows(const loft_corner *k, int64_t s, int32_t part)
{
    const int64_t end = end_of(k);

    if (end <= s)
        return end - k->way + launched(k->jerk, launch_time(k->jerk, s - end + k->way) + part);
    if (k->s <= s)
        return s + (speed_of(k) * part >> 10);

    const int32_t time = launch_time(k->jerk, k->s - s + k->way), n = time - part;
    return time == TIME_MAX ? s + FAR
           : n >= k->time   ? k->s + k->way - launched(k->jerk, n)
           : k->on > 0      ? k->s + (speed_of(k) * (k->time - n) >> 10)
                            : k->s - k->way + launched(k->jerk, 2 * k->time - n);
}

int32_t loft_corner_time(const loft_corner *k, int64_t s)
{
    const int64_t end = end_of(k), off = k->s > s ? k->s - s : end < s ? s - end : 0;
    return launch_time(k->jerk, off + k->way) - k->time;
}

void loft_corners_drop(loft_corners *c, int64_t s, loft_coord cap)
{
    unsigned n = 0;
    int64_t to = s + cap;
    const loft_corner *tightest = NULL;

    for (unsigned i = 0; i < c->count && end_of(&c->corner[i]) < s; i++) {
        const int64_t next = loft_corner_allows(&c->corner[i], s, ONE);
        tightest = next < to ? &c->corner[i] : tightest;
        to = next < to ? next : to;
    }
    for (unsigned i = 0; i < c->count; i++)
        if (end_of(&c->corner[i]) >= s || &c->corner[i] == tightest) {
            const loft_corner kept = c->corner[i];
            c->corner[n++] = kept;
        }
    c->count = (uint8_t)n;
}

const loft_corner *loft_corners_next_sharp(const loft_corners *c, int64_t s)
{
    for (unsigned i = 0; i < c->count; i++)
        if (c->corner[i].on < 0 && c->corner[i].s > s)
            return &c->corner[i];
    return NULL;
}
