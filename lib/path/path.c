/* lib/path/path.c
 * SPDX-License-Identifier: MIT
 *
 * From a place to the next is a period, at the speed that the launches from corners behind (see
 * corner.c), the landings on those ahead, and the cap of speed allow.
 */
#include "path/path.h"

#include "path/slow.h"      /* loft_slow_look */

#define ONE         LOFT_CORNER_ONE                 /* a period, in times of corners */
#define REACH       48                              /* periods that corners are known ahead */
#define STEPS       12                              /* and more to the next corner */
#define AHEAD       8                               /* places that are settled */
#define NEXT        3                               /* and those that may not wait for it */
#define RUN         3                               /* ways that are spaced anew at once */
#define MOVED       1                               /* room of a place that does not lie at s yet */
#define CHORD       (4 * LOFT_COORD_MM)             /* what is longer is a line */
#define POINT       64                              /* what is shorter is a point */
#define MEAN        16                              /* points of the path in a mean, */
#define LATER       (EVENED ? 4 : 2)                /* places behind one that goes onto it, */
#define EVENED      (LOFT_PLAN_EFFORT > 1 ? 0 : 2)  /* which are made even so often: or guessed, */
#define CLEAR       4                               /* but not so near to a sharp one */


// Places
// ------

/* As far as the corners behind, those ahead and the cap allow. Where launch and landing meet their
 * jerks would add up: less then, by up to 3/10. */
static int64_t allowed(const loft_path *path, loft_coord cap, int32_t part)
{
    const int64_t most = (int64_t)cap * part >> 10;
    int64_t from = most, to = most, even = most;

    for (unsigned i = 0; i < path->corners.count; i++) {
        const loft_corner *c = &path->corners.corner[i];
        const int64_t way = loft_corner_allows(c, path->s, part) - path->s;
        if (loft_corner_lasts(c, path->s))
            even = way * 3 / 4 < even ? way * 3 / 4 : even;
        else if (c->s <= path->s)
            from = way < from ? way : from;
        else
            to = way < to ? way : to;
    }
    const int64_t low = from < to ? from : to, high = from < to ? to : from;
    const int64_t meet = low - low * low / (high + 1) * 3 / 10, way = meet < even ? meet : even;
    return path->s + (way > 1 ? way : 1);
}

/* The time to the next place: it grows by a 24th from one to the next while the path is known `far`
 * ahead. */
static int32_t step_here(const loft_path *path, bool far)
{
    int32_t step = far ? loft_coord_least(path->step + path->step / 24, LOFT_CORNER_STEP)
                       : path->step - path->step / 8;

    for (unsigned i = 0; i < path->corners.count && step > ONE; i++)
        step = loft_coord_least(step, loft_corner_time(&path->corners.corner[i], path->s) / STEPS);
    return step > ONE ? step : ONE;
}

/* Whole periods to the next sharp corner: all of them somewhat shorter or longer. */
static int64_t next_s(loft_path *path, loft_coord cap, bool far)
{
    const loft_corner *c = loft_corners_next_sharp(&path->corners, path->s);
    int64_t to;

    path->step = step_here(path, far);
    to = allowed(path, cap, path->step);
    if (!c)
        return to;
    if (to < c->s) {
        const int32_t time = loft_corner_time(c, path->s);
        if (time < 6 * ONE && time > ONE) {
            const int32_t n = (time + ONE * 6 / 10) / ONE;
            to = allowed(path, cap, time / n);
        }
    }
    return to + (to - path->s) * 3 / 8 >= c->s ? c->s : to;
}

/* Set the cap of this arc, and the launch to it. */
static void look_along(loft_path *path)
{
    const loft_period *p = path->chain.period;
    int16_t u[LOFT_AXES];

    if (path->along == path->walk.s)
        return;
    path->along = path->walk.s;
    loft_chain_direction(&path->walk, 1, u);
    path->cap = loft_corner_cap(p, u, path->walk.feed);
    loft_chain_direction(&path->walk, 0, u);
    path->launch = loft_corner_of(0, path->cap, loft_corner_jerk(p, u, path->cap), false);
}

static void set_fold(loft_path_place *on, const loft_chain_walk *w, int64_t s)
{
#if LOFT_FOLDS
    on->fold = loft_chain_fold(w, s);
#else
    (void)on, (void)w, (void)s;
#endif
}

/* The first place, when there is a way. Curves without one are dropped, or they would fill the
 * ring. */
static enum loft_path_state start(loft_path *path, loft_path_waiting *out)
{
    loft_chain *chain = &path->chain;

    if (!loft_chain_advance(chain, &path->walk)) {
        path->corners.walk = path->check = path->walk;
        loft_chain_drop(chain, path->check.number);
        return loft_chain_ends(chain) ? LOFT_PATH_END : LOFT_PATH_WAIT;
    }
    (void)loft_chain_advance(chain, &path->check);
    look_along(path);
    loft_corners_add(&path->corners, loft_corner_of(0, 0, path->launch.jerk, false));
    chain->walked = true;
#if LOFT_FOLDS
    path->from = chain->from;
#endif
    out->s = 0;
    loft_chain_place(&path->walk, 0, &out->on.at);
    out->on.number = path->walk.number;
    out->on.feed   = path->walk.feed;
    out->on.sharp  = out->on.loose = false;
    out->on.room   = 0;
    set_fold(&out->on, &path->walk, 0);
    return LOFT_PATH_PLACE;
}

/* Zones that are behind all places; where it can only go on so, one more. */
static void drop_zones(loft_path *path)
{
    loft_corners_drop_zones(&path->corners, path->queued > 0 ? path->queue[0].s : path->s,
                            path->s >= path->corners.known);
}

/* How far ahead places must be known: a launch, and a little. */
static int64_t need_of(const loft_path *path) { return path->launch.way + 2 * (int64_t)path->cap; }

/* Look ahead, as far as it matters: what a step is spent on is not more then. True: the end of the
 * chain is known. */
static bool look_ahead(loft_path *path)
{
    loft_chain *chain = &path->chain;
    loft_corners *c = &path->corners;
    const int64_t to = path->s + 3 * need_of(path) + REACH * (int64_t)path->cap;

    drop_zones(path);
    loft_corners_scan(c, to);
    if (path->s >= c->known) {
        loft_corners_drop(c, path->s, path->cap);
        drop_zones(path);
        loft_corners_scan(c, to);
    }
    if (path->s >= c->known && chain->count == chain->room)
        chain->ended = true;            /* nothing more can come before it is passed */
    return loft_corners_end_known(c);
}

/* Exactly where the last curve ends. */
static void set_end(const loft_path *path, loft_path_place *on)
{
    const loft_vec to = loft_chain_end(&path->chain);

    for (int i = 0; i < LOFT_AXES; i++) {
        on->at.axis[i] = loft_coord_of(loft_to_acc(to.axis[i]));
#if LOFT_FOLDS
        on->at.axis[i] = loft_coord_folded(on->at.axis[i], on->fold.axis[i]);
#endif
    }
}

/* Go to s. */
static void set_place(loft_path *path, int64_t s, bool ends, loft_path_waiting *out)
{
    const loft_corner *c = loft_corners_next_sharp(&path->corners, s - 1);

    loft_path_place *on = &out->on;

    on->sharp = c && c->s == s;
    on->loose = false;
    on->room  = 0;
    on->feed  = loft_chain_go(&path->chain, &path->walk, s);
    loft_chain_place(&path->walk, s, &on->at);
    set_fold(on, &path->walk, s);
    if (ends)
        set_end(path, on);
    on->number = path->walk.number;
    out->s = path->s = s;
    look_along(path);
}

/* The next place of the guess. */
static enum loft_path_state march(loft_path *path, loft_path_waiting *out)
{
    loft_corners *c = &path->corners;

#if LOFT_FOLDS
    loft_slow_look(&path->chain);
#endif
    if (!path->chain.walked)
        return start(path, out);
    const bool ends = look_ahead(path);
    if (path->s >= c->known)
        return ends ? LOFT_PATH_END : LOFT_PATH_WAIT;
    const bool full = path->chain.count == path->chain.room || loft_chain_ends(&path->chain) ||
                      loft_corners_full(c);
    const int64_t left = c->known - path->s, need = need_of(path);
    const bool near = left < need;
    if (!ends && near && !full)
        return LOFT_PATH_WAIT;
    loft_corners_drop(c, path->s, path->cap);
    const uint8_t kept = c->count;
    if (ends || near)
        c->corner[c->count++] = loft_corners_last(c, ends);
    const int64_t next = next_s(path, path->cap, ends || left > 2 * need),
                  to = next < c->known ? next : c->known;
    c->count = kept;
    set_place(path, to, ends && to == c->known, out);
    return LOFT_PATH_PLACE;
}


// Checked places
// --------------

/* The n places from place k on; those after the last one are itself. */
static void places_from(const loft_path *path, unsigned k, unsigned n, const loft_path_place *at[])
{
    for (unsigned i = 0; i < n; i++)
        at[i] = &path->queue[k + i < path->queued ? k + i : path->queued - 1u].on;
}

/* How far the path is at s from the cubic, near its part z. */
static loft_coord off_at(const loft_chain_walk *w, int64_t s, const loft_path_cubic *cubic,
                         int32_t z)
{
    loft_position p;

    loft_chain_place(w, s, &p);
    return loft_path_cubic_off(cubic, z, &p);
}

/* The last walk that has not passed s. */
static const loft_chain_walk *walk_before(const loft_path *path, int64_t s)
{
    return path->last.s > path->check.s && path->last.s <= s ? &path->last : &path->check;
}

/* Go to the next arc, which another walk may know. */
static bool follow(const loft_path *path, loft_chain_walk *w)
{
    const loft_chain_walk *const known[] = { &path->last, &path->walk };
    const int64_t s = w->s + w->length;

    for (unsigned n = 0; n < 2; n++)
        if (known[n]->s == s && known[n]->length > 0) {
            *w = *known[n];
            return true;
        }
    return loft_chain_try(&path->chain, w);
}

/* How far the path is from the cubic from place k to the next, at joints and eighths of the way; of
 * one arc, which turns by little, at quarters. */
static loft_coord skipped(loft_path *path, unsigned k)
{
    const loft_path_place *at[4];
    loft_coord most = 0;

    places_from(path, k - 1, 4, at);
    const int64_t from = path->queue[k].s, way = path->queue[k + 1].s - from;
    if (way <= 0)
        return 0;
    const loft_path_cubic cubic = loft_path_cubic_of(at);
    loft_chain_walk w = *walk_before(path, from);
    while (from >= w.s + w.length && follow(path, &w))
        ;
    const int step = from + way <= w.s + w.length ? 2 : 1;
    for (int n = step; n <= 8; n += step) {
        const int64_t s = from + way * n / 8;
        while (s > w.s + w.length) {
            const int64_t joint = w.s + w.length;
            const loft_coord off = off_at(&w, joint, &cubic,
                                          (int32_t)(((joint - from) << 24) / way));
            most = off > most ? off : most;
            if (!follow(path, &w))
                break;
        }
        const loft_coord off = n < 8 ? off_at(&w, s, &cubic, (int32_t)n << 21) : 0;
        most = off > most ? off : most;
    }
    path->last = w;
    return most;
}

/* A curve is outside of its chords: by up to l turn / 8, with chords of the length l, and by 2/3 of
 * that on a mean. So at a joint their mean goes out by a 6th: then both sides are as far. */
static void go_out(const loft_chain_walk *before, const loft_chain_walk *after, int64_t way,
                   int weight, int64_t sum[])
{
    const int64_t length = loft_coord_least(before->length, after->length),
                  l = length < way ? length : way, part = l * l / way * weight;
    int16_t u[LOFT_AXES], v[LOFT_AXES];

    loft_chain_direction(before, 2, u);
    loft_chain_direction(after, 0, v);
    for (int i = 0; i < LOFT_AXES; i++)
        sum[i] += ((int64_t)u[i] - v[i]) * part / LOFT_CHAIN_UNIT / 6;
}

/* The mean of the path around s that a parabola goes through: 4/3 of that with weights which fall
 * to nothing within half of the way before and behind, less 1/3 of that within all of it. So it
 * hardly depends on where joints are, if the way is as long as two chords. It is given as seen from
 * `at`. Is it off a bend by less than a 12th of the tolerance? Of a radius r it is, by way^4 / (465
 * r^3), and the points at both ends are (15 way / 16)^2 / r off the middle. */
static bool mean_of(const loft_path *path, int64_t s, int64_t way, const loft_position *at,
                    loft_coord out[])
{
    static const int8_t weights[MEAN / 2] = { 96, 69, 37, 7, -8, -5, -3, -1 };
    loft_chain_walk w = *walk_before(path, s - way);
    int64_t sum[LOFT_AXES] = { 0 };
    loft_coord ends[LOFT_AXES] = { 0 };

    for (int n = 0; n < MEAN; n++) {
        const int64_t to = s - way + way * (2 * n + 1) / MEAN;
        const int weight = weights[n < MEAN / 2 ? MEAN / 2 - 1 - n : n - MEAN / 2];
        loft_position p;
        while (to > w.s + w.length) {
            const loft_chain_walk before = w;
            if (!follow(path, &w))
                break;
            if (w.s > s - way)
                go_out(&before, &w, way, weight, sum);
        }
        loft_chain_place(&w, to, &p);
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_coord off = loft_coord_sub(p.axis[i], at->axis[i]);
            sum[i] += (int64_t)weight * off;
            ends[i] += n == 0 || n == MEAN - 1 ? off : 0;
        }
    }
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = (loft_coord)(sum[i] / (24 * MEAN));
    const int64_t d = loft_coord_length(ends) >> 9, l = way >> 9;
    return d * d * d <= 26 * (path->chain.period->tol >> 9) * l * l;
}

/* How far the path is known before and behind place k, without a sharp place. */
static int64_t clear_way(const loft_path *path, unsigned k)
{
    const loft_path_waiting *q = path->queue;
    const loft_corner *sharp = loft_corners_next_sharp(&path->corners, path->s);
    unsigned from = k, to = k + 1;
    int64_t end = path->corners.known;

    while (from > 0 && !q[--from].on.sharp)
        ;
    while (to < path->queued && !q[to].on.sharp)
        to++;
    if (to < path->queued)
        end = q[to].s;
    else if (sharp && sharp->s < end)
        end = sharp->s;
    const int64_t back = q[k].s - q[from].s, on = end - q[k].s;
    return back < on ? back : on;
}

/* The length of the arc at s, of which 128 tolerances matter at most. */
static int64_t chord_at(const loft_path *path, int64_t s)
{
    loft_chain_walk w = path->walk.s <= s ? path->walk : *walk_before(path, s);

    while (s > w.s + w.length && follow(path, &w))
        ;
    return loft_coord_least(w.length, loft_coord_least(path->chain.period->tol, CHORD >> 7) << 7);
}

/* Place k goes onto the mean of the path around it, where that has joints: a place is where the
 * motion could pass, not a point of the chords that a curve was written in. The mean is within 9/2
 * ways, but no more than 4 chords, as it has 16 points, and no less than 2 chords, nor 2 ways. It
 * is within 2/3 of that, and so on, while it leaves the path by more than 5/8 of the tolerance, or
 * its bend by a 12th, but not within less than 2 ways. */
static void average(loft_path *path, unsigned k)
{
    loft_path_waiting *q = &path->queue[k];
    const loft_position at = q->on.at;

    if (k == 0 || k + 1 >= path->queued || q->on.sharp)
        return;
    const int64_t back = q->s - q[-1].s, on = q[1].s - q->s, one = back < on ? back : on,
                  chord = chord_at(path, q->s), clear = clear_way(path, k);
    int64_t most = 4 * chord < 9 * one / 2 ? 4 * chord : 9 * one / 2;

    most = most < 2 * chord ? 2 * chord : most;
    for (most = most < 2 * one ? 2 * one : most;; most = most * 2 / 3) {
        const int64_t way = most < clear ? most : clear;
        const bool last = way <= 2 * one;
        loft_coord mean[LOFT_AXES];
        if (way < POINT || loft_corners_smooth(&path->corners, q->s - way))
            return;
        const bool near = mean_of(path, q->s, way, &at, mean);
        if (!last && (!near || loft_coord_length(mean) > path->chain.period->tol / 8 * 5))
            continue;
        for (int i = 0; i < LOFT_AXES; i++)
            q->on.at.axis[i] = loft_coord_add(at.axis[i], mean[i]);
        return;
    }
}

/* Place k is at s. */
static void put(loft_path *path, unsigned k, int64_t s, loft_coord feed)
{
    loft_path_waiting *q = &path->queue[k];
    loft_chain_walk w = path->walk.s <= s ? path->walk : *walk_before(path, s);

    while (s > w.s + w.length && follow(path, &w))
        ;
    q->s = s;
    q->on.feed = feed;
    loft_chain_place(&w, s, &q->on.at);
    set_fold(&q->on, &w, s);
    q->on.number = w.number;
    q->on.sharp = q->on.loose = false;
}

/* Way k and those beside it are spaced anew, one more of them: so ways change by little from one to
 * the next. Places that ways which have been given depend on stay. Gives the first of them. */
static unsigned respace(loft_path *path, unsigned k)
{
    loft_path_waiting *q = path->queue;
    const unsigned fixed = q[1].s > q[0].s ? 2 : 1;
    const bool back = k > fixed && !q[k].on.sharp, on = k + 2 < path->queued && !q[k + 1].on.sharp;
    const unsigned first = back ? k - 1 : k, n = 1u + back + on;
    int64_t s[RUN + 1];
    loft_coord feed[RUN + 2];

    q += first;
    for (unsigned j = 0; j <= n; j++) {
        s[j] = q[j].s;
        feed[j] = q[j > 0 ? j : 1].on.feed;
    }
    feed[n + 1] = feed[n];
    for (unsigned i = path->queued - first; i > n; i--)
        q[i] = q[i - 1];
    path->queued++;
    path->averaged++;
    for (unsigned j = n; j > 0; j--)
        put(path, first + j, s[j - 1] + (s[j] - s[j - 1]) * (n + 1 - j) / (n + 1),
            loft_coord_least(feed[j - 1], feed[j]));
    for (unsigned j = 1; j <= n; j++)
        average(path, first + j);
    return first;
}

/* The longest of the ways around place k, if it is so long beside shorter ones, or a tip, that the
 * path leaves the tolerance before it is smoothed: at the place, or in the middle of the way to it,
 * where what one is longer by than twice that matters by an 18th. Of even ways smoothing takes off
 * a quarter of the tolerance. Ways as short as that do not matter. 0: there is none. */
static unsigned too_long(const loft_path *path, unsigned k)
{
    const loft_path_place *at[6];
    const loft_period *p = path->chain.period;
    const loft_path_waiting *q = path->queue;
    unsigned longest = k, n;
    int64_t most = 0, least = INT64_MAX;

    if (k < 3)
        return 0;
    for (n = k - 2; n < k + 2 && n + 1 < path->queued; n++) {
        const int64_t way = q[n + 1].s - q[n].s;
        if (way > most)
            longest = n;
        most = way > most ? way : most;
        least = way < least ? way : least;
    }
    const loft_coord skip = loft_coord_most(loft_path_skip(&q[k].on), loft_path_skip(&q[k - 1].on)),
                     left = p->tube + (q[k].on.loose && q[k - 1].on.loose ? p->more : 0) - skip;
    if (most < 2 * (int64_t)p->tol)
        return 0;
    places_from(path, k - 2, 5, at);
    const loft_coord even = most < 2 * least && !loft_path_turns_back(at[1], at[2], at[3])
                                ? p->tol / 4
                                : 0;
    if (loft_path_missed(at, left + even))
        return longest;
    if (most <= 2 * (q[k].s - q[k - 1].s) + 18 * (int64_t)left)
        return 0;
    places_from(path, k - 3, 6, at);
    return loft_path_missed_between(at) > left ? longest : 0;
}

/* Set what is skipped from place k to the next. May it not be, though the way is no point? Of a
 * smooth path, where it falls with the fourth power of the way, half of that may. */
static bool skips_too_much(loft_path *path, unsigned k)
{
    const loft_period *p = path->chain.period;
    loft_path_waiting *q = &path->queue[k];
    const loft_coord skip = skipped(path, k);

    loft_path_set_skip(&q->on, skip);
    q->on.loose = loft_corners_loose(&path->corners, q[0].s, q[1].s);
    const loft_coord tube = p->tube + (q->on.loose ? p->more : 0);
    const bool smooth = loft_corners_smooth(&path->corners, path->queue[k > 2 ? k - 2 : 0].s);
    const loft_coord most = smooth ? tube / 2 : tube / 16 * 15;
    return skip > most && q[1].s - q[0].s >= POINT;
}

/* Room for a place: one of the last, if it may be one that is not sharp, is dropped. */
static void make_room(loft_path *path)
{
    unsigned k = path->queued - 2u;

    while (k > NEXT + RUN && path->queue[k].on.sharp)
        k--;
    if (k == NEXT + RUN)
        k = path->queued - 2u;
    path->queued--;
    path->averaged = (uint8_t)loft_coord_least(path->averaged, path->queued);
    path->settled  = (uint8_t)loft_coord_least(path->settled, (int32_t)k - 3);
    for (; k < path->queued; k++)
        path->queue[k] = path->queue[k + 1];
}

/* No place is given with a way that skips too much, or is too long: it is spaced anew, with those
 * beside it. That changes the cubics of the ways around them as well. Where there is no room for a
 * place, there is when those before have been given; the next ways may not wait so long. */
static void settle(loft_path *path)
{
    const unsigned behind = path->chain.closed ? 0 : 2;

    while (path->settled < AHEAD && path->settled + 2u < path->queued &&
           path->settled + 1u + behind < path->averaged) {
        const unsigned k = path->settled + 1u, at = skips_too_much(path, k) ? k : too_long(path, k);
        path->settled = (uint8_t)k;
        if (at == 0)
            continue;
        if (path->queued >= LOFT_PATH_QUEUE) {
            path->settled--;
            if (k > NEXT)
                break;
            make_room(path);
        }
        const unsigned first = respace(path, at);
        path->settled = (uint8_t)(first > 2 ? first - 2 : 0);
    }
}

/* Bits of the places near ones that stay: sharp ones, the start, or the end of what is known. */
static uint32_t tied_places(const loft_path *path)
{
    uint32_t tied = 0;

    for (unsigned k = 0; k < path->queued; k++) {
        const loft_path_waiting *q = &path->queue[k];
        if (q->on.sharp || q->s == 0 || q->s == path->corners.known)
            tied |= ((UINT32_C(2) << 2 * CLEAR) - 1) << k >> CLEAR;
    }
    return tied;
}

/* Places that are not on the mean yet go half of the way to the middle between their neighbours.
 * The cap of speed jumps from arc to arc, and so would ways: but of uneven ways third differences
 * are large, along the path, and the tolerance is too small to smooth that. */
static void even_out(loft_path *path)
{
    const uint32_t tied = tied_places(path);
    loft_path_waiting *q = path->queue;

    for (int n = 0; n < EVENED; n++)
        for (unsigned k = path->queued - 1u; k-- > path->averaged;) {
            const int64_t before = q[k].s - q[k > 0 ? k - 1 : 0].s,
                          by = (q[k + 1].s - q[k].s - before) / 4;
            if ((tied >> k & 1) || before == 0 || loft_long_abs(by) <= before >> 8)
                continue;
            const loft_coord feed = loft_coord_least(q[k].on.feed, q[k + 1].on.feed);
            q[by > 0 ? k : k + 1].on.feed = feed;
            q[k].s += by;
            q[k].on.room = MOVED;
        }
}

/* Queue places as far ahead as is looked, or the last one. */
static enum loft_path_state fill(loft_path *path)
{
    while (path->queued < AHEAD + 3 && !path->chain.closed) {
        const enum loft_path_state state = march(path, &path->queue[path->queued]);
        if (state == LOFT_PATH_WAIT)
            return state;
        if (state == LOFT_PATH_END) {
            path->chain.closed = true;
            break;
        }
        path->queued++;
        if (path->queued == 1) {            /* the place before the first one is itself */
            path->queue[1] = path->queue[0];
            path->queued++;
        }
        even_out(path);
    }
    while (path->averaged + (path->chain.closed ? 0u : LATER) < path->queued) {
        const loft_path_waiting *q = &path->queue[path->averaged];
        if (q->on.room == MOVED)
            put(path, path->averaged, q->s, q->on.feed);
        average(path, path->averaged++);
    }
    return LOFT_PATH_PLACE;
}

static void finish(loft_path *path)
{
    loft_chain *chain = &path->chain;

    path->over = true;
    path->end = loft_chain_end(chain);
    loft_chain_finish(chain);
}

enum loft_path_state loft_path_next(loft_path *path, loft_path_place *out)
{
    if (path->over)
        return LOFT_PATH_END;
    if (fill(path) == LOFT_PATH_WAIT)
        return LOFT_PATH_WAIT;
    if (path->queued < 2) {
        finish(path);
        return LOFT_PATH_END;
    }
    settle(path);
    *out = path->queue[1].on;
    if (path->queued == 2)
        out->skip = 0;
    (void)loft_chain_go(&path->chain, &path->check, path->queue[1].s);
#if LOFT_FOLDS
    if (loft_chain_is_straight(&path->check, path->queue[1].s))
        loft_path_set_skip(out, path->chain.period->tube - LOFT_COORD_GRAIN);
#endif
    path->queued--;
    path->averaged--;
    path->settled = (uint8_t)(path->settled > 0 ? path->settled - 1 : 0);
    for (unsigned k = 0; k < path->queued; k++)
        path->queue[k] = path->queue[k + 1];
    loft_chain_drop(&path->chain, path->check.number);
    return LOFT_PATH_PLACE;
}

void loft_path_begin(loft_path *path)
{
    path->chain.walked = path->chain.closed = path->over = false;
    loft_corners_begin(&path->corners, &path->chain);
    path->last = path->check = path->walk = path->corners.walk;
    path->queued = path->averaged = path->settled = 0;
    path->s = 0;
    path->along = -1;
    path->step = ONE;
}

void loft_path_init(loft_path *path, const loft_period *period, loft_move moves[], uint16_t room)
{
    loft_chain_init(&path->chain, period, moves, room);
    loft_path_begin(path);
}
