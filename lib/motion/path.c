/* lib/motion/path.c
 * SPDX-License-Identifier: MIT
 *
 * From rest, with jerk j in a period, a path is at X(n) = j n^3 / 6 after n periods. A corner that
 * is passed at speed v = j t^2 / 2 is like a rest that lies X(t) beyond it: at a distance x from it
 * the launch has lasted N = cbrt(6 (x + X(t)) / j) periods, and a period later, or before, it is at
 * X(N +- 1). The next place is the nearest that any corner, or the cap of speed, allows.
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
 * Where corners have a larger tolerance, that is the one at joints that turn by more than 5
 * degrees, at the scale of the tolerance as well. It holds on ways from a place to the next that
 * are wholly within 31 times itself from them.
 */
#include "motion/path.h"

#include "geom/normal.h"    /* loft_vec_unit */

#define ONE         1024                            /* a period, in times of corners */
/* Little effort: away from corners places are farther apart, so fewer of them look ahead as far. */
#define STEP_MAX    (LOFT_PLAN_EFFORT > 1 ? ONE : ONE * 7 / 4)
#define STEPS       12                              /* and more to the next corner */
#define TIME_MAX    ((int32_t)256 * ONE)
#define FAR         ((int64_t)1 << 30)              /* what is farther has no effect */
#define CAP_MAX     (4 * LOFT_COORD_MM)
#define PART_ONE    (INT32_C(1) << 24)              /* a part */
#define UNIT        16384                           /* of directions */
#define SCALES      5
#define SHARP       1430                            /* 5 degrees */
#define NEAR        31                              /* tolerances of a corner */
#define AHEAD       6                               /* places that are settled */
#define DUST        4                               /* arcs that are no longer are nothing */

static loft_coord least(loft_coord a, loft_coord b) { return a < b ? a : b; }


// Launches
// --------

/* X(n). */
static int64_t launched(loft_coord jerk, int32_t n)
{
    const int64_t x = ((int64_t)jerk * n >> 4) * n >> 10;
    return n >= TIME_MAX || x > (int64_t)1 << 42 ? 4 * FAR : (x * n >> 10) / (6 * 64);
}

/* N(x). */
static int32_t launch_time(loft_coord jerk, int64_t x)
{
    const uint32_t n = x >= FAR ? TIME_MAX
                                : loft_coord_cbrt(((uint64_t)x * 6 << 30) / (uint32_t)jerk);
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

static loft_coord jerk_along(const loft_period *p, const int16_t u[], loft_coord cap)
{
    const int64_t a = along(p->accel, u), soft = 2 * a * a / cap;
    loft_coord jerk = soft < CAP_MAX ? (loft_coord)soft + 1 : CAP_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(u[i]);
        if (p->jerk[i] > 0 && part * jerk > (int64_t)p->jerk[i] * UNIT)
            jerk = (loft_coord)((int64_t)p->jerk[i] * UNIT / part) + 1;
    }
    return jerk;
}

static loft_coord cap_of(const loft_path *path, const int16_t u[], loft_real feed)
{
    const loft_period *p = path->period;
    return least(least(along(p->speed, u), loft_period_speed(p, feed)), CAP_MAX) + 1;
}


// Curves
// ------

static loft_move *move_at(const loft_path *path, unsigned i)
{
    const unsigned k = path->first + i;
    return &path->moves[k < path->room ? k : k - path->room];
}

static loft_move *move_of(const loft_path *path, uint16_t number)
{
    return move_at(path, (uint16_t)(number - path->dropped));
}

/* Go to the next arc; false: it is not known yet. */
static bool advance(const loft_path *path, loft_path_walk *w)
{
    for (;;) {
        if (w->to == LOFT_ARC_WHOLE) {
            w->number++;
            w->to = 0;
        }
        if ((uint16_t)(w->number - path->dropped) >= path->count)
            return false;
        const loft_cubic *curve = &move_of(path, w->number)->curve;
        loft_arc arc;
        const uint32_t from = w->to, to = loft_arc_next(&arc, curve, from, true);
        w->to = to;
        if (arc.dust || loft_coord_of(arc.length) < DUST)
            continue;
        w->arc  = arc;
        w->from = from;
        w->s += w->length;
        loft_arc_pace(&w->arc, curve, from, to, arc.speck);
        w->length = loft_coord_of(w->arc.length);
        if (w->length >= DUST)
            return true;
        w->length = 0;
    }
}

static void place_at(const loft_path_walk *w, loft_coord off, loft_position *out)
{
    loft_acc at[LOFT_AXES];

    loft_arc_eval(&w->arc, loft_coord_to_acc(off < w->length ? off : w->length), at);
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_coord_of(at[i]);
}

static void direction(loft_vec u, int16_t out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = (int16_t)((loft_raw_from_real(u.axis[i]) + 2) >> 2);
}


// Corners
// -------

/* The square of the turn between two directions, 2^-28. */
static int64_t turn(const int16_t a[], const int16_t b[])
{
    int64_t square = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        square += (int64_t)(b[i] - a[i]) * (b[i] - a[i]);
    return square;
}

/* Is `after` so short that it may belong to the stretch before? At a cusp arcs become shorter and
 * shorter: too many of them would hide what is around a joint. */
static bool is_scrap(const loft_path *path, const loft_path_stretch *before,
                     const loft_path_stretch *after)
{
    return before->length + (int64_t)after->length <= path->period->tol / 4 &&
           turn(before->from, after->to) <= (int64_t)UNIT * UNIT &&
           turn(before->to, after->from) <= (int64_t)SHARP * SHARP;
}

static void add_stretch(loft_path *path)
{
    loft_path_stretch e;
    const loft_path_walk *w = &path->scan;
    loft_path_stretch *last = &path->stretch[path->stretches > 0 ? path->stretches - 1u : 0];
    loft_arc_shape shape = { .tight = false };      /* the others are not asked for */

    loft_arc_measure(&w->arc, &shape, 1 | 4);
    place_at(w, 0, &e.at);
    direction(shape.along[0], e.from);
    direction(shape.along[2], e.to);
    e.length = w->length;
    e.s = w->s;
    const loft_real feed = move_of(path, w->number)->feed;
    e.cap = least(cap_of(path, e.from, feed), cap_of(path, e.to, feed));
    if (path->stretches == 0 || !is_scrap(path, last, &e)) {
        path->stretch[path->stretches++] = e;
        return;
    }
    last->length += e.length;
    last->cap = least(last->cap, e.cap);
    for (int i = 0; i < LOFT_AXES; i++)
        last->to[i] = e.to[i];
}

/* How far the path leads in a stretch within l of its start, or back from its end. */
static void bow(const loft_path_stretch *e, bool back, loft_coord l, loft_coord out[])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t bend = (int64_t)(e->to[i] - e->from[i]) * l / e->length * l / 2;
        out[i] = (loft_coord)((back ? bend - (int64_t)e->to[i] * l
                                    : e->from[i] * (int64_t)l + bend) /
                              UNIT);
    }
}

static bool is_sharp(const loft_path_stretch *before, const loft_path_stretch *after)
{
    return turn(before->to, after->from) > (int64_t)SHARP * SHARP;
}

/* The place l before or behind the start of stretch i, from there; false: it is not known, or, from
 * a joint that is not sharp, beyond one that is: that is a corner for itself. */
static bool probe(const loft_path *path, unsigned i, bool back, loft_coord l, loft_coord out[])
{
    const loft_path_stretch *e = path->stretch;
    const loft_position at = e[i].at;
    const bool sharp = is_sharp(&e[i - 1], &e[i]);
    unsigned k = back ? i - 1 : i;

    while (l > e[k].length) {
        l -= e[k].length;
        if (back ? k == 0 : k + 1 == path->stretches)
            return false;
        k = back ? k - 1 : k + 1;
        if (!sharp && is_sharp(&e[back ? k : k - 1], &e[back ? k + 1 : k]))
            return false;
    }
    const loft_position *from = &path->stretch[back ? k + 1 : k].at;
    bow(&path->stretch[k], back, l, out);
    for (int j = 0; j < LOFT_AXES; j++)
        out[j] += loft_coord_sub(from->axis[j], at.axis[j]);
    return true;
}

/* The most that the axes allow across the path, where its velocity changes by `v` of length
 * `size`. */
static loft_coord swing(const loft_period *p, loft_coord tol, const loft_coord v[], loft_coord size)
{
    int64_t accel = CAP_MAX, jerk = CAP_MAX;
    bool soft = false;

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = loft_coord_abs(v[i]) + 1;
        if (part * accel > (int64_t)p->accel[i] * size)
            accel = (int64_t)p->accel[i] * size / part;
        if (p->jerk[i] > 0 && part * jerk > (int64_t)p->jerk[i] * size)
            jerk = (int64_t)p->jerk[i] * size / part;
        soft = soft || p->jerk[i] > 0;
    }
    const uint64_t change = (uint64_t)jerk * (uint64_t)tol / 4096 * (uint64_t)tol / 4096;
    const loft_coord by_accel = (loft_coord)loft_coord_sqrt((uint64_t)(8 * accel * tol)),
                     by_jerk = (loft_coord)(29 * (int64_t)loft_coord_cbrt(change) * 256 / 10);
    return soft ? least(by_accel, by_jerk) : by_accel / 2;
}

/* By what the path turns at the joint before stretch i, at the scale l; false: not known. */
static bool turn_at(const loft_path *path, unsigned i, loft_coord l, loft_coord out[])
{
    loft_coord b[LOFT_AXES];

    if (!probe(path, i, true, l, out) || !probe(path, i, false, l, b))
        return false;
    for (int j = 0; j < LOFT_AXES; j++)
        out[j] += b[j];
    return true;
}

/* Does the joint before stretch i have the tolerance of corners? */
static bool is_corner(const loft_path *path, unsigned i)
{
    const loft_coord tol = path->period->tol;
    loft_coord a[LOFT_AXES];

    return path->period->more > 0 && is_sharp(&path->stretch[i - 1], &path->stretch[i]) &&
           turn_at(path, i, tol, a) && (int64_t)loft_coord_length(a) * UNIT > (int64_t)tol * SHARP;
}

/* The speed with which the joint before stretch i may be passed. */
static loft_coord joint_speed(const loft_path *path, unsigned i, bool corner)
{
    const loft_period *p = path->period;
    const loft_coord tol = p->tol + (corner ? p->more : 0);
    loft_coord speed = CAP_MAX, a[LOFT_AXES];

    for (int k = 0; k < SCALES && turn_at(path, i, tol << k, a); k++) {
        const loft_coord size = loft_coord_length(a);
        if ((int64_t)size * 10 > (int64_t)tol * 13) {
            const int64_t v = ((int64_t)swing(p, tol, a, size) << k) * tol / size;
            speed = v < speed ? (loft_coord)v : speed;
        }
    }
    return speed;
}

static void drop_zone(loft_path *path)
{
    path->zones--;
    for (unsigned k = 0; k < path->zones; k++)
        path->zone[k] = path->zone[k + 1];
}

/* It is near a corner at s. Zones that meet are one. */
static void add_zone(loft_path *path, int64_t s)
{
    const loft_period *p = path->period;
    const int64_t reach = (int64_t)(p->tol + p->more) * NEAR;
    loft_path_zone *last = &path->zone[path->zones > 0 ? path->zones - 1u : 0];

    if (path->zones > 0 && s - reach <= last->to) {
        last->to = s + reach;
        return;
    }
    if (path->zones == LOFT_PATH_ZONES)
        drop_zone(path);
    path->zone[path->zones++] = (loft_path_zone){ s - reach, s + reach };
}

/* Is it near corners all the way? */
static bool is_loose(const loft_path *path, int64_t from, int64_t to)
{
    bool inside = false;

    for (unsigned k = 0; k < path->zones; k++)
        inside = inside || (path->zone[k].from <= from && to <= path->zone[k].to);
    return inside;
}

static loft_path_corner corner_of(int64_t s, loft_coord speed, loft_coord jerk, bool sharp)
{
    loft_path_corner c = { .s = s, .jerk = jerk, .sharp = sharp };

    c.time = (int32_t)loft_coord_sqrt(((uint64_t)(uint32_t)speed * 2 << 20) / (uint32_t)jerk);
    c.way  = (loft_coord)launched(jerk, c.time);
    return c;
}

/* A corner that is reached from the one before, or left to it, with less than its own speed is
 * forgotten. */
static void add_corner(loft_path *path, loft_path_corner c)
{
    while (path->corners > 0) {
        const loft_path_corner *last = &path->corner[path->corners - 1];
        const int64_t off = c.s - last->s;
        if (!c.sharp && c.jerk >= last->jerk && last->way + off <= c.way)
            return;
        if (last->sharp || last->jerk < c.jerk || c.way + off > last->way)
            break;
        path->corners--;
    }
    path->corner[path->corners++] = c;
}

/* The joint before stretch `looked`. */
static void look_at_joint(loft_path *path)
{
    const unsigned i = path->looked;
    const loft_path_stretch *before = &path->stretch[i - 1], *after = &path->stretch[i];
    const bool corner = is_corner(path, i);
    const loft_coord speed = joint_speed(path, i, corner), cap = least(before->cap, after->cap);

    if (corner)
        add_zone(path, after->s);
    if (speed < cap)
        add_corner(path, corner_of(after->s, speed > 1 ? speed : 1,
                                   least(jerk_along(path->period, before->to, cap),
                                         jerk_along(path->period, after->from, cap)),
                                   is_sharp(before, after)));
}

/* The largest scale at which a joint is looked at. */
static loft_coord scale_most(const loft_path *path)
{
    return (path->period->tol + path->period->more) << (SCALES - 1);
}

static int64_t scanned(const loft_path *path) { return path->scan.s + path->scan.length; }

/* Forget stretches that no joint to come looks back at. */
static void forget(loft_path *path)
{
    unsigned n = 0;
    const int64_t from = path->looked < path->stretches ? path->stretch[path->looked].s
                                                        : scanned(path);

    while (n + 1u < path->looked && path->stretch[n + 1].s < from - 2 * (int64_t)scale_most(path))
        n++;
    if (n == 0 && path->stretches == LOFT_PATH_STRETCHES)
        n = path->looked > 1 ? (path->looked - 1u + 1) / 2 : 0;
    for (unsigned k = n; k < path->stretches; k++)
        path->stretch[k - n] = path->stretch[k];
    path->stretches = (uint8_t)(path->stretches - n);
    path->looked = (uint8_t)(path->looked - n);
}

/* Find corners as far ahead as there is room. */
static void scan(loft_path *path)
{
    const loft_coord need = scale_most(path);

    for (;;) {
        if (path->corners + 2 >= LOFT_PATH_CORNERS || path->zones == LOFT_PATH_ZONES)
            break;
        if (path->stretches == LOFT_PATH_STRETCHES)
            forget(path);
        const bool more = path->stretches < LOFT_PATH_STRETCHES && advance(path, &path->scan);
        if (more)
            add_stretch(path);
        const bool all = !more && (path->ended || path->count == path->room ||
                                   path->stretches == LOFT_PATH_STRETCHES);
        const unsigned before = path->looked;
        while (path->looked < path->stretches && path->corners + 2 < LOFT_PATH_CORNERS &&
               path->zones < LOFT_PATH_ZONES &&
               (all || scanned(path) - path->stretch[path->looked].s > need)) {
            if (path->looked > 0)
                look_at_joint(path);
            path->looked++;
        }
        if (!more && path->looked == before)
            break;
    }
    path->known = path->looked < path->stretches ? path->stretch[path->looked].s : scanned(path);
}


// Places
// ------

/* Where a corner lets the next place be, `part` of a period later. */
static int64_t corner_allows(const loft_path_corner *c, int64_t s, int32_t part)
{
    if (c->s <= s)
        return c->s - c->way + launched(c->jerk, launch_time(c->jerk, s - c->s + c->way) + part);

    const int32_t time = launch_time(c->jerk, c->s - s + c->way), n = time - part;
    return time == TIME_MAX ? s + FAR
           : n >= c->time   ? c->s + c->way - launched(c->jerk, n)
                            : c->s - c->way + launched(c->jerk, 2 * c->time - n);
}

/* As far as the corners behind, those ahead and the cap allow. Where launch and landing meet their
 * jerks would add up: less then, by up to 3/10. */
static int64_t allowed(const loft_path *path, loft_coord cap, int32_t part)
{
    const int64_t most = (int64_t)cap * part >> 10;
    int64_t from = most, to = most;

    for (unsigned i = 0; i < path->corners; i++) {
        const loft_path_corner *c = &path->corner[i];
        const int64_t way = corner_allows(c, path->s, part) - path->s;
        if (c->s <= path->s)
            from = way < from ? way : from;
        else
            to = way < to ? way : to;
    }
    const int64_t low = from < to ? from : to, high = from < to ? to : from;
    const int64_t way = low - low * low / (high + 1) * 3 / 10;
    return path->s + (way > 1 ? way : 1);
}

/* Of the corners behind only the one that allows the least still matters. */
static void drop_corners(loft_path *path, loft_coord cap)
{
    unsigned n = 0;
    int64_t to = path->s + cap;
    const loft_path_corner *tightest = NULL;

    for (unsigned i = 0; i < path->corners && path->corner[i].s <= path->s; i++) {
        const int64_t s = corner_allows(&path->corner[i], path->s, ONE);
        tightest = s < to ? &path->corner[i] : tightest;
        to = s < to ? s : to;
    }
    for (unsigned i = 0; i < path->corners; i++)
        if (path->corner[i].s > path->s || &path->corner[i] == tightest) {
            const loft_path_corner kept = path->corner[i];
            path->corner[n++] = kept;
        }
    path->corners = (uint8_t)n;
}

/* Zones that are behind all places; where it can only go on so, one more. */
static void drop_zones(loft_path *path)
{
    const int64_t from = path->queued > 0 ? path->queue[0].s : path->s;

    while (path->zones > 0 && path->zone[0].to < from)
        drop_zone(path);
    if (path->zones == LOFT_PATH_ZONES && path->s >= path->known)
        drop_zone(path);
}

static const loft_path_corner *next_sharp(const loft_path *path)
{
    const loft_path_corner *found = NULL;

    for (unsigned i = 0; i < path->corners && !found; i++)
        if (path->corner[i].sharp && path->corner[i].s > path->s)
            found = &path->corner[i];
    return found;
}

/* The time to the next place: it grows by a 24th from one to the next while the path is known `far`
 * ahead. */
static int32_t step_here(const loft_path *path, bool far)
{
    int32_t step = far ? least(path->step + path->step / 24, STEP_MAX)
                       : path->step - path->step / 8;

    for (unsigned i = 0; i < path->corners && step > ONE; i++) {
        const loft_path_corner *c = &path->corner[i];
        const int64_t off = c->s > path->s ? c->s - path->s : path->s - c->s;
        step = least(step, (launch_time(c->jerk, off + c->way) - c->time) / STEPS);
    }
    return step > ONE ? step : ONE;
}

/* Whole periods to the next sharp corner: all of them somewhat shorter or longer. */
static int64_t next_s(loft_path *path, loft_coord cap, bool far)
{
    const loft_path_corner *c = next_sharp(path);
    int64_t to;

    path->step = step_here(path, far);
    to = allowed(path, cap, path->step);
    if (!c)
        return to;
    if (to < c->s) {
        const int32_t time = launch_time(c->jerk, c->s - path->s + c->way) - c->time;
        if (time < 6 * ONE && time > ONE) {
            const int32_t n = (time + ONE * 6 / 10) / ONE;
            to = allowed(path, cap, time / n);
        }
    }
    return to + (to - path->s) * 3 / 8 >= c->s ? c->s : to;
}

/* The direction where it is: at the start, in the middle of its arc. */
static void heading(const loft_path *path, int k, int16_t u[])
{
    loft_arc_shape shape = { .tight = false };      /* the others are not asked for */

    loft_arc_measure(&path->walk.arc, &shape, 1u << k);
    direction(shape.along[k], u);
}

static loft_coord jerk_here(const loft_path *path, loft_coord cap)
{
    int16_t u[LOFT_AXES];

    heading(path, 0, u);
    return jerk_along(path->period, u, cap);
}

/* How far ahead places must be known from: a launch to the cap, and a little. */
static int64_t reach(const loft_path *path, loft_coord cap)
{
    const loft_coord jerk = jerk_here(path, cap);
    return launched(jerk, (int32_t)loft_coord_sqrt(((uint64_t)(uint32_t)cap * 2 << 20) /
                                                   (uint32_t)jerk)) +
           2 * (int64_t)cap;
}

static loft_coord cap_here(const loft_path *path)
{
    int16_t u[LOFT_AXES];

    heading(path, 1, u);
    return cap_of(path, u, move_of(path, path->walk.number)->feed);
}

/* Curves that are behind what is checked. */
static void drop_moves(loft_path *path)
{
    while (path->dropped != path->check.number) {
        path->dropped++;
        path->count--;
        path->first = (uint16_t)(path->first + 1 < path->room ? path->first + 1 : 0);
    }
}

/* The first place, when there is a way. Curves without one are dropped, or they would fill the
 * ring. */
static enum loft_path_state start(loft_path *path, loft_path_place *out)
{
    if (!advance(path, &path->walk)) {
        path->scan = path->check = path->walk;
        drop_moves(path);
        return path->ended ? LOFT_PATH_END : LOFT_PATH_WAIT;
    }
    (void)advance(path, &path->check);
    const loft_coord cap = cap_here(path);
    add_corner(path, corner_of(0, 0, jerk_here(path, cap), false));
    path->begun = true;
    place_at(&path->walk, 0, &out->at);
    out->number = path->walk.number;
    out->feed   = loft_period_speed(path->period, move_of(path, out->number)->feed);
    out->sharp  = out->loose = false;
    out->s = 0;
    return LOFT_PATH_PLACE;
}

/* All corners are known: so is the end. */
static bool end_known(const loft_path *path)
{
    return path->ended && path->looked == path->stretches &&
           (uint16_t)(path->scan.number - path->dropped) >= path->count;
}

/* Walk to a place; gives the least feed on the way. */
static loft_coord walk_to(const loft_path *path, loft_path_walk *w, int64_t s, loft_position *out)
{
    loft_coord feed = loft_period_speed(path->period, move_of(path, w->number)->feed);
    loft_path_walk last = *w;

    while (s > w->s + w->length && advance(path, w)) {
        feed = least(feed, loft_period_speed(path->period, move_of(path, w->number)->feed));
        last = *w;
    }
    *w = last;
    const int64_t off = s - w->s;
    place_at(w, (loft_coord)(off < w->length ? off : w->length), out);
    return feed;
}

/* The next place of the guess. */
static enum loft_path_state march(loft_path *path, loft_path_place *out)
{
    if (!path->begun)
        return start(path, out);
    drop_zones(path);
    scan(path);
    if (path->s >= path->known) {
        drop_corners(path, cap_here(path));
        drop_zones(path);
        scan(path);
    }
    if (path->s >= path->known && path->count == path->room)
        path->ended = true;             /* nothing more can come before it is passed */
    const bool ends = end_known(path);
    if (path->s >= path->known)
        return ends ? LOFT_PATH_END : LOFT_PATH_WAIT;
    const loft_coord cap = cap_here(path);
    const bool full = path->count == path->room || path->corners + 2 >= LOFT_PATH_CORNERS ||
                      path->zones == LOFT_PATH_ZONES || path->ended;
    const int64_t left = path->known - path->s, need = reach(path, cap);
    const bool near = left < need;
    if (!ends && near && !full)
        return LOFT_PATH_WAIT;
    drop_corners(path, cap);
    const unsigned kept = path->corners;
    if (ends || near) {
        const loft_path_stretch *e = &path->stretch[path->stretches - 1];
        path->corner[path->corners++] = corner_of(path->known, 0,
                                                  jerk_along(path->period, e->to, e->cap), ends);
    }
    const int64_t next = next_s(path, cap, ends || left > 2 * need),
                  to = next < path->known ? next : path->known;
    path->corners = (uint8_t)kept;
    out->sharp = out->loose = false;
    for (unsigned i = 0; i < path->corners; i++)
        out->sharp = out->sharp || (path->corner[i].sharp && path->corner[i].s == to);
    out->feed = walk_to(path, &path->walk, to, &out->at);
    for (int i = 0; i < LOFT_AXES && ends && to == path->known; i++)
        out->at.axis[i] = loft_coord_of(loft_to_acc(path->to.axis[i]));
    out->number = path->walk.number;
    out->s = path->s = to;
    return LOFT_PATH_PLACE;
}


// The cubic through places
// ------------------------

static void legs_of(const loft_position *a, const loft_position *b, loft_coord leg[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        leg[i] = loft_coord_sub(b->axis[i], a->axis[i]);
}

static loft_coord largest(const loft_coord x[])
{
    loft_coord most = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        most = loft_coord_abs(x[i]) > most ? loft_coord_abs(x[i]) : most;
    return most;
}

/* Half of what a leg differs by from the chord: of one much longer, half the chord at most, so that
 * the cubic does not turn back. At a sharp place there is none. */
static void set_turn(loft_coord leg[], const loft_coord chord[], bool sharp)
{
    const int64_t size = largest(leg), most = 2 * (int64_t)largest(chord);

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t part = size > most ? leg[i] * most / size : leg[i];
        leg[i] = sharp ? 0 : (loft_coord)((part - chord[i]) / 2);
    }
}

/* P + z (chord + (1 - z) ((1 - z) before - z after)). */
typedef struct {
    const loft_position *from;
    loft_coord before[LOFT_AXES], chord[LOFT_AXES], after[LOFT_AXES];
} between;

static between between_of(const loft_path_place *const at[4])
{
    between w = { .from = &at[1]->at };

    legs_of(&at[0]->at, &at[1]->at, w.before);
    legs_of(&at[1]->at, &at[2]->at, w.chord);
    legs_of(&at[2]->at, &at[3]->at, w.after);
    set_turn(w.before, w.chord, at[1]->sharp);
    set_turn(w.after, w.chord, at[2]->sharp);
    return w;
}

static void place_between(const between *w, int32_t z, loft_position *out)
{
    const int32_t y = PART_ONE - z, in = (int32_t)((int64_t)z * y >> 24);

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t bow = ((int64_t)w->before[i] * y - (int64_t)w->after[i] * z) >> 24;
        out->axis[i] = loft_coord_add(w->from->axis[i],
                                      (loft_coord)(((int64_t)w->chord[i] * z + bow * in) >> 24));
    }
}

void loft_path_between(const loft_path_place *const at[4], int32_t z, loft_position *out)
{
    const between w = between_of(at);
    place_between(&w, z, out);
}

/* Its derivative by z. */
static void tangent_between(const between *w, int32_t z, loft_coord out[])
{
    const int32_t y = PART_ONE - z, in = (int32_t)((int64_t)z * y >> 24);

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t bow = ((int64_t)w->before[i] * y - (int64_t)w->after[i] * z) >> 24,
                      sum = (int64_t)w->before[i] + w->after[i];
        out[i] = (loft_coord)(w->chord[i] + ((bow * (y - z) - sum * in) >> 24));
    }
}

/* Along its tangent, twice; then across that, but beyond its ends. */
loft_coord loft_path_off(const loft_path_place *const at[4], int32_t z, const loft_position *p)
{
    const between w = between_of(at);

    for (int round = 0;; round++) {
        loft_position on;
        loft_coord off[LOFT_AXES], along[LOFT_AXES];
        int64_t dot = 0;

        place_between(&w, z, &on);
        tangent_between(&w, z, along);
        legs_of(&on, p, off);
        for (int i = 0; i < LOFT_AXES; i++)
            dot += (int64_t)off[i] * along[i];
        const int64_t size = (int64_t)loft_coord_length(along) + 1, way = dot / size,
                      next = z + way * PART_ONE / size;
        const bool inside = next >= 0 && next <= PART_ONE;
        if (round < 2 && (inside || (z > 0 && z < PART_ONE))) {
            z = next < 0 ? 0 : next > PART_ONE ? PART_ONE : (int32_t)next;
            continue;
        }
        for (int i = 0; i < LOFT_AXES && inside; i++)
            off[i] -= (loft_coord)(way * along[i] / size);
        return loft_coord_length(off);
    }
}


// Checked places
// --------------

/* The places around the way from place k to the next. */
static void four(const loft_path_place queue[], unsigned count, unsigned k,
                 const loft_path_place *at[4])
{
    for (unsigned i = 0; i < 4; i++)
        at[i] = &queue[k + i - 1 < count ? k + i - 1 : count - 1];
}

static loft_coord off_at(const loft_path *path, loft_path_walk *w,
                         const loft_path_place *const at[4], int64_t s)
{
    loft_position p;

    (void)walk_to(path, w, s, &p);
    const int64_t z = ((s - at[1]->s) << 24) / (at[2]->s - at[1]->s);
    return loft_path_off(at, (int32_t)z, &p);
}

/* How far the path is from the cubic from place k to the next, at joints and eighths of the way. */
static loft_coord skipped(const loft_path *path, unsigned k)
{
    const loft_path_place *at[4];
    loft_path_walk w = path->check;
    loft_coord most = 0;

    four(path->queue, path->queued, k, at);
    const int64_t way = at[2]->s - at[1]->s;
    if (way <= 0)
        return 0;

    for (int n = 1; n < 8; n++) {
        const int64_t s = at[1]->s + way * n / 8;
        while (s > w.s + w.length) {
            const int64_t joint = w.s + w.length;
            if (joint > at[1]->s) {
                const loft_coord off = off_at(path, &w, at, joint);
                most = off > most ? off : most;
            }
            loft_path_walk next = w;
            if (!advance(path, &next))
                break;
            w = next;
        }
        const loft_coord off = off_at(path, &w, at, s);
        most = off > most ? off : most;
    }
    return most;
}

/* A place in the middle of place k and the next. */
static void halve(loft_path *path, unsigned k)
{
    loft_path_place *q = &path->queue[k];
    loft_path_walk w = path->check;

    for (unsigned i = path->queued - k; i > 1; i--)
        q[i] = q[i - 1];
    path->queued++;
    q[1].s = (q[0].s + q[2].s) / 2;
    q[1].feed = walk_to(path, &w, q[1].s, &q[1].at);
    q[1].feed = least(q[1].feed, q[2].feed);
    q[1].number = w.number;
    q[1].sharp = q[1].loose = false;
}

/* A place in the middle, if less is skipped then: not of teeth that the tolerance swallows. */
static bool is_better_halved(loft_path *path, unsigned k)
{
    loft_path_place *q = &path->queue[k];
    const loft_coord whole = q->skip, most = loft_path_tol(path->period, q) * 13 / 20;

    halve(path, k);
    const loft_coord first = skipped(path, k), last = skipped(path, k + 1);
    if (whole > most || (first > last ? first : last) < whole - whole / 4)
        return true;
    path->queued--;
    for (unsigned i = k + 1; i < path->queued; i++)
        path->queue[i] = path->queue[i + 1];
    return false;
}

/* Set what is skipped from place k to the next; true: a place was put between them. */
static bool is_halved(loft_path *path, unsigned k)
{
    loft_path_place *q = &path->queue[k];

    q->skip = skipped(path, k);
    q->loose = is_loose(path, q[0].s, q[1].s);
    return q->skip > loft_path_tol(path->period, q) / 4 && path->queued < LOFT_PATH_QUEUE &&
           q[1].s - q[0].s >= 64 && is_better_halved(path, k);
}

/* A place that is put between two changes the cubic before them as well. */
static void settle(loft_path *path)
{
    while (path->settled < AHEAD && path->settled + 2u < path->queued) {
        const unsigned k = path->settled + 1u;
        if (is_halved(path, k))
            path->settled = (uint8_t)(k > 2 ? k - 2 : 0);
        else
            path->settled++;
    }
}

/* Queue places as far ahead as is looked, or the last one. */
static enum loft_path_state fill(loft_path *path)
{
    while (path->queued < AHEAD + 3 && !path->last) {
        const enum loft_path_state state = march(path, &path->queue[path->queued]);
        if (state == LOFT_PATH_WAIT)
            return state;
        if (state == LOFT_PATH_END) {
            path->last = true;
            break;
        }
        path->queued++;
        if (path->queued == 1) {            /* the place before the first one is itself */
            path->queue[1] = path->queue[0];
            path->queued++;
        }
    }
    return LOFT_PATH_PLACE;
}

static void finish(loft_path *path)
{
    path->over = true;
    path->end = path->to;
    path->dropped = (uint16_t)(path->dropped + path->count);
    path->first = path->count = 0;
}

enum loft_path_state loft_path_next(loft_path *path, loft_path_place *out)
{
    loft_position p;

    if (path->over)
        return LOFT_PATH_END;
    if (fill(path) == LOFT_PATH_WAIT)
        return LOFT_PATH_WAIT;
    if (path->queued < 2) {
        finish(path);
        return LOFT_PATH_END;
    }
    settle(path);
    *out = path->queue[1];
    if (path->queued == 2)
        out->skip = 0;
    (void)walk_to(path, &path->check, out->s, &p);
    path->queued--;
    path->settled = (uint8_t)(path->settled > 0 ? path->settled - 1 : 0);
    for (unsigned k = 0; k < path->queued; k++)
        path->queue[k] = path->queue[k + 1];
    drop_moves(path);
    return LOFT_PATH_PLACE;
}

void loft_path_begin(loft_path *path)
{
    path->begun = path->over = path->last = false;
    path->walk.number = path->dropped;
    path->walk.from = path->walk.to = 0;
    path->walk.s = 0;
    path->walk.length = 0;
    path->check = path->scan = path->walk;
    path->zones = 0;
    path->stretches = path->looked = path->corners = path->queued = path->settled = 0;
    path->s = path->known = 0;
    path->step = ONE;
}

void loft_path_init(loft_path *path, const loft_period *period, loft_move moves[], uint16_t room)
{
    path->period = period;
    path->moves = moves;
    path->room = room;
    path->first = path->count = path->dropped = 0;
    loft_path_begin(path);
    path->ended = false;
}

/* Is there a curve before the next one that is pushed? */
static bool is_joined(const loft_path *path)
{
    return path->count > 0 || (path->begun && !path->over);
}

/* As loft_plan_push states it. */
static enum loft_status accepts(const loft_path *path, const loft_move *move)
{
    if (!(move->feed > 0))
        return LOFT_ERR_ARG;
    if (move->feed < LOFT_SPEED_MIN || move->feed > LOFT_SPEED_MAX)
        return LOFT_ERR_RANGE;
    for (int k = 0; k < 4; k++)
        if (!loft_vec_within(move->curve.p[k], LOFT_PLAN_REACH))
            return LOFT_ERR_RANGE;
    return is_joined(path) && !loft_vec_equal(move->curve.p[0], path->to) ? LOFT_ERR_ARG : LOFT_OK;
}

/* The direction in which a curve begins, or ends; false: it has none. */
static bool direction_of(const loft_cubic *c, bool end, int16_t out[])
{
    loft_acc leg[LOFT_AXES];
    loft_vec u;

    for (int k = 1; k < 4; k++) {
        const loft_vec *a = &c->p[end ? 3 - k : 0], *b = &c->p[end ? 3 : k];
        for (int i = 0; i < LOFT_AXES; i++)
            leg[i] = loft_to_acc(b->axis[i]) - loft_to_acc(a->axis[i]);
        if (loft_vec_unit(leg, &u) == LOFT_OK) {
            direction(u, out);
            return true;
        }
    }
    return false;
}

/* Does it stop before this curve? */
static bool stops_before(const loft_path *path, const loft_move *move)
{
    static const int16_t none[LOFT_AXES] = { 0 };
    int16_t to[LOFT_AXES];

    return path->period->exact > 0 && is_joined(path) && turn(path->heading, none) > 0 &&
           direction_of(&move->curve, false, to) && turn(path->heading, to) > path->period->exact;
}

enum loft_status loft_path_push(loft_path *path, const loft_move *move)
{
    const enum loft_status status = accepts(path, move);

    if (status != LOFT_OK)
        return status;
    if (loft_path_room(path) == 0)
        return LOFT_ERR_SPACE;
    if (stops_before(path, move)) {
        path->ended = true;
        return LOFT_ERR_SPACE;
    }
    if (!is_joined(path)) {
        path->from = move->curve.p[0];
        for (int i = 0; i < LOFT_AXES; i++)
            path->heading[i] = 0;
    }
    (void)direction_of(&move->curve, true, path->heading);
    *move_at(path, path->count) = *move;
    path->count++;
    path->to = move->curve.p[3];
    path->ended = path->room == 1;
    return LOFT_OK;
}
