/* tests/lib/path/test_path.c -- properties of lib/path/path.h
 * SPDX-License-Identifier: MIT
 */
#define CURVES 512

#include "support/motion_any.h"     /* arb_short_chain, path_distance */

#include "path/path.h"            /* loft_path_next */
#include "path/slow.h"            /* loft_slow_look */

#define PLACES 30000

static loft_period     period;
static loft_path       planned;
static loft_move       ring[CURVES];
static loft_path_place found_at[PLACES];
static int64_t         along[PLACES];       /* from the start, of each that was found */
static unsigned        found;
static path            track;

/* All places of the chain. */
static bool find_places(void)
{
    enum loft_path_state state = LOFT_PATH_PLACE;

    loft_period_init(&period, &limits);
    loft_path_init(&planned, &period, ring, CURVES);
    for (unsigned k = 0; k < curves; k++)
        if (loft_chain_push(&planned.chain, &chain[k]) != LOFT_OK)
            return false;
    planned.chain.ended = true;
    for (found = 0; found < PLACES && state == LOFT_PATH_PLACE;) {
        state = loft_path_next(&planned, &found_at[found]);
        along[found] = planned.queue[0].s;      /* it is kept as the one before the next */
        found += state == LOFT_PATH_PLACE;
    }
    return state == LOFT_PATH_END;
}

/* But for what is left out of the path before it, and for dust: curves of up to 2^-18 mm. */
static bool is_at(const loft_path_place *p, loft_vec v)
{
    bool good = true;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_coord at = loft_coord_of(loft_to_acc(v.axis[i]));
#if LOFT_FOLDS
        at = loft_coord_folded(at, p->fold.axis[i]);
#endif
        const loft_coord d = loft_coord_sub(p->at.axis[i], at);
        good = good && loft_coord_abs(d) <= 64 * (loft_coord)curves;
    }
    return good;
}

/* The same chain, walked by its length alone. */
static loft_chain beside;

static void walk_beside(loft_chain_walk *w)
{
    static loft_move moves[CURVES];

    loft_chain_init(&beside, &period, moves, CURVES);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_chain_push(&beside, &chain[k]) == LOFT_OK);
    beside.ended = true;
#if LOFT_FOLDS
    loft_slow_look(&beside);
#endif
    loft_chain_begin(&beside, w);
}

/* How far p is from the cubic from place k to the next, near that part. */
static loft_coord off_cubic(unsigned k, int32_t z, const loft_position *p)
{
    const loft_path_place *at[4];

    for (unsigned i = 0; i < 4; i++)
        at[i] = &found_at[k + i == 0 ? 0 : k + i - 1 < found ? k + i - 1 : found - 1];
    return loft_path_off(at, z, p);
}

/* How far the path is from the cubic from place k to the next, at joints and at eighths of the way,
 * and from that or those beside it. The walk is where place k is. */
static loft_coord missed_from(unsigned k, loft_chain_walk w, loft_coord *by_all)
{
    const int64_t from = along[k], way = along[k + 1] - from;
    loft_coord most = 0;
    loft_position p;

    *by_all = 0;
    for (int n = 1; n <= 8; n++) {
        const int64_t s = from + way * n / 8;
        do {
            const int64_t to = s < w.s + w.length ? s : w.s + w.length;
            if (n == 8 && to == s)
                break;
            loft_chain_place(&w, to, &p);
            loft_coord off = off_cubic(k, (int32_t)(((to - from) << 24) / way), &p);
            most = loft_coord_most(most, off);
            off = loft_coord_least(off, k > 0 ? off_cubic(k - 1, 1 << 24, &p) : off);
            off = loft_coord_least(off, k + 2 < found ? off_cubic(k + 1, 0, &p) : off);
            *by_all = loft_coord_most(*by_all, off);
        } while (s > w.s + w.length && loft_chain_try(&beside, &w));
    }
    return most;
}

/* Places go along the path, on it or beside it within the tolerance, but sharp ones on it. No feed
 * is faster than its curves ask for, nor slower than those near. What is skipped is what is said.
 */
static void places_are_of_the_path(bool skips)
{
    static loft_coord least[PLACES];
    loft_chain_walk w;

    walk_beside(&w);
    for (unsigned k = 0; k < found && !check_bad; k++) {
        const loft_path_place *on = &found_at[k];
        loft_position p;
        CHECK(k == 0 || along[k] >= along[k - 1]);
        CHECK(k == 0 || (int16_t)(on->number - found_at[k - 1].number) >= 0);
        if (k == 0)
            CHECK(loft_chain_advance(&beside, &w));
        least[k] = loft_chain_go(&beside, &w, along[k]);
        loft_chain_place(&w, along[k], &p);
        CHECK(on->number == w.number && on->feed <= least[k]);
        CHECK(loft_position_distance(&p, &on->at) <= (on->sharp ? 64 : period.tol));
#if LOFT_FOLDS
        const loft_fold fold = loft_chain_fold(&w, along[k]);
        CHECK(memcmp(&fold, &on->fold, sizeof fold) == 0);
        if (loft_chain_is_straight(&w, along[k]))
            continue;
#endif
        if (skips && k + 1 < found && along[k + 1] > along[k]) {
            loft_coord all;
            const loft_coord own = missed_from(k, w, &all);
            CHECK(loft_path_skip(on) <= own + own / 4 + period.tol / 8);
            CHECK(loft_path_skip(on) >= all - all / 4 - period.tol / 8);
        }
    }
    for (unsigned k = 0; k < found && LOFT_PLAN_EFFORT > 1; k++) {
        loft_coord slow = INT32_MAX;
        for (unsigned n = k > 20 ? k - 20 : 0; n < found && n <= k + 20; n++)
            slow = least[n] < slow ? least[n] : slow;
        CHECK(found_at[k].feed >= slow);
    }
}

static void arb_case(arb *a)
{
    const bool smooth = arb_below(a, 3) == 0;

    arb_limits(a);
    if (arb_below(a, 2))
        arb_jerk(a);
    arb_short_chain(a, smooth);
}

static void places_lead_from_end_to_end(arb *a)
{
    arb_case(a);
    CHECK(find_places() || found == PLACES);
    if (found == 0 || found == PLACES)
        return;
    CHECK(is_at(&found_at[0], chain[0].curve.p[0]));
    CHECK(is_at(&found_at[found - 1], chain[curves - 1].curve.p[3]));
    places_are_of_the_path(true);
}

/* A joint of the path as fast as the cubic through its places: nothing is skipped that is larger
 * than what they say, which is less than the tolerance. */
static void what_is_skipped_is_less_than_the_tolerance(arb *a)
{

    arb_case(a);
    CHECK(find_places());
    path_trace_near(&track, chain, curves, arb_value(limits.tol) / 64);
    for (unsigned k = 0; k + 1 < found; k++)
        CHECK(loft_path_skip(&found_at[k]) <= loft_path_tol(&period, &found_at[k]) / 2 ||
              along[k + 1] - along[k] < 64);
}

/* The tolerance of corners holds on ways that are near them from one end to the other. */
static void corners_are_near_where_they_count(arb *a)
{

    arb_case(a);
    limits.corner = real_of(arb_value(limits.tol) * 4);
    CHECK(find_places());
    corners_find(chain, curves);
    path_trace_by(&track, chain, curves, 1e-4, chord_is_near_by_corners);
    corners_measure(&track);
    const double reach = CORNER_NEAR * arb_value(limits.corner);
    for (unsigned k = 0; k + 1 < found; k++)
        CHECK(!found_at[k].loose || fmax(corner_way(ldexp((double)along[k], -24)),
                                         corner_way(ldexp((double)along[k + 1], -24))) <= reach);
}

/* Of a curve that is cut in two, exactly, the places are the same. */
static void it_does_not_matter_how_a_path_is_cut(arb *a)
{
    static loft_path_place whole[PLACES];

    even_limits(200, 3000, arb_below(a, 2) ? 100000 : 0);
    begin_chain();
    const unsigned n = 1 + arb_below(a, 4);
    for (unsigned k = 0; k < n; k++)
        arb_curve(a, SMOOTH, arb_between(a, 5, 20), 200, true);
    CHECK(find_places());
    const unsigned count_whole = found;
    memcpy(whole, found_at, found * sizeof found_at[0]);
    for (unsigned k = curves; k-- > 0;) {
        loft_cubic left, right;
        const loft_move m = chain[k];
        for (int i = 0; i < LOFT_AXES; i++) {
            double p[4], q[3], r[2];
            for (int j = 0; j < 4; j++)
                p[j] = arb_value(m.curve.p[j].axis[i]);
            for (int j = 0; j < 3; j++)
                q[j] = (p[j] + p[j + 1]) / 2;
            for (int j = 0; j < 2; j++)
                r[j] = (q[j] + q[j + 1]) / 2;
            left.p[0].axis[i]  = m.curve.p[0].axis[i];
            left.p[1].axis[i]  = real_of(q[0]);
            left.p[2].axis[i]  = real_of(r[0]);
            left.p[3].axis[i]  = real_of((r[0] + r[1]) / 2);
            right.p[0].axis[i] = left.p[3].axis[i];
            right.p[1].axis[i] = real_of(r[1]);
            right.p[2].axis[i] = real_of(q[2]);
            right.p[3].axis[i] = m.curve.p[3].axis[i];
        }
        chain[2 * k + 1] = (loft_move){ right, m.feed };
        chain[2 * k]     = (loft_move){ left, m.feed };
    }
    curves *= 2;
    CHECK(find_places());
    const double more = (double)found - count_whole;
    CHECK(fabs(more) <= 3 + count_whole / 50.0);
}

/* Axes in another order, and another origin, are the same path: in fixed point to the last bit. A
 * mirror image has about as many places. */
static void places_move_with_the_path(arb *a)
{
    static loft_path_place whole[PLACES];
    const loft_coord grains = (loft_coord)(arb_below(a, 2) * arb_below(a, 1u << 20));
    const bool mirror = arb_below(a, 3) == 0;
    const loft_limits before = limits;

    arb_case(a);
    if (!find_places())
        return;
    const unsigned places = found;
    memcpy(whole, found_at, found * sizeof found_at[0]);
    const loft_limits straight = limits;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int to = (i + 1) % LOFT_AXES;
        limits.max_speed[to] = straight.max_speed[i];
        limits.max_accel[to] = straight.max_accel[i];
        limits.max_jerk[to]  = straight.max_jerk[i];
    }
    for (unsigned k = 0; k < 4 * curves; k++) {
        loft_vec *p = &chain[k / 4].curve.p[k % 4];
        const loft_vec q = *p;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double x = arb_value(q.axis[i]) + grains / 65536.0;
            p->axis[(i + 1) % LOFT_AXES] = real_of(mirror ? -x : x);
        }
    }
    CHECK(find_places());
    CHECK_NEAR(found, places, mirror || BY_NUM(0, 1, 1) ? 4 + places / 20.0 : 0);
    for (unsigned k = 0; k < found && !mirror && BY_NUM(1, 0, 0); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(loft_coord_add(whole[k].at.axis[i], grains * LOFT_COORD_GRAIN) ==
                  found_at[k].at.axis[(i + 1) % LOFT_AXES]);
    limits = before;
}

/* How far a launch from a rest, or a landing, lets the next place be, x from there. */
static double launch_on(double jerk, double x)
{
    return jerk * pow(cbrt(6 * x / jerk) + 1, 3) / 6 - x;
}

static double landing_on(double jerk, double x)
{
    const double n = cbrt(6 * x / jerk) - 1;
    return n > 0 ? x - jerk * n * n * n / 6 : x;
}

/* Places of a line are as far apart as its launch, its landing and its feed let them be, less 3/10
 * where two of them meet. */
static void a_line_takes_the_time_of_its_launches(arb *a)
{
    const double accel = arb_decades(a, 200, 8000), feed = arb_decades(a, 10, 300);
    int16_t u[LOFT_AXES] = { LOFT_CHAIN_UNIT };

    even_limits(500, accel, arb_below(a, 2) ? accel * arb_decades(a, 5, 100) : 0);
    begin_chain();
    arb_curve(a, LINE, arb_decades(a, 5, 50), feed, false);
    for (int k = 0; k < 4; k++)
        for (int i = 1; i < LOFT_AXES; i++)
            chain[0].curve.p[k].axis[i] = 0;
    CHECK(find_places());
    if (found < 2)
        return;
    const double length = (double)along[found - 1],
                 cap = loft_corner_cap(&period, u, loft_period_speed(&period, chain[0].feed)),
                 jerk = loft_corner_jerk(&period, u, (loft_coord)cap);
    double s = 0;
    unsigned steps = 0;
    for (; s < length - 1 && steps < PLACES; steps++) {
        const double from = fmin(cap, launch_on(jerk, s)),
                     to = fmin(cap, landing_on(jerk, length - s)), low = fmin(from, to);
        s += fmax(1, low - 0.3 * low * low / fmax(from, to));
    }
    CHECK_NEAR(found, steps, 4 + steps / 200.0);
}

#if LOFT_FOLDS
/* What is left out of long slow lines is left out where they are straight, takes its time at the
 * feed, and comes back: with it, the last place is where the chain ends. */
static void what_is_left_out_comes_back(arb *a)
{
    const double feed = arb_decades(a, 10, 40), zero[4] = { 0 };
    double d[LOFT_AXES], way = 0;
    loft_chain_walk w;
    bool straight = false;
    unsigned folds = 0;

    even_limits(200, arb_decades(a, 1000, 5000), arb_below(a, 2) ? 100000 : 0);
    begin_chain();
    for (unsigned k = 0; k < 3; k++) {
        const double size = arb_between(a, 10, 40), u[4] = { 0, size / 3, size * 2 / 3, size };
        arb_direction(a, d);
        add_curve(d, d, u, zero, feed);
    }
    CHECK(find_places());
    walk_beside(&w);
    for (unsigned k = 0; k < found; k++) {
        (void)loft_chain_go(&beside, &w, along[k]);
        const bool was = straight;
        straight = loft_chain_is_straight(&w, along[k]);
        if (k == 0 || memcmp(&found_at[k].fold, &found_at[k - 1].fold, sizeof(loft_fold)) == 0)
            continue;
        const loft_fold *from = &found_at[k - 1].fold, *to = &found_at[k].fold;
        double left = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            left += pow(to->axis[i] - from->axis[i], 2);
        CHECK(straight && was && found_at[k].number == found_at[k - 1].number);
        CHECK_NEAR(to->ticks - from->ticks, sqrt(left) / 65536 / feed * limits.tick_hz, 2);
        way += sqrt(left) / 65536;
        folds++;
    }
    CHECK(folds <= 3);
    if (found > 1 && folds > 0)
        CHECK(is_at(&found_at[found - 1], chain[curves - 1].curve.p[3]) && way > 1);
}
#endif


// Chords
// ------

#define TURN 6.283185307179586

/* A circle of radius r about its start, as `n` chords, or as cubics of an eighth each; turned by
 * that angle, or its mirror image. */
typedef struct {
    double r, feed, angle;
    bool   mirror;
    double grid;            /* what coordinates of ends are multiples of; 0: of any */
} ring_of;

static void add_piece(const ring_of *c, double from, double to, bool chord)
{
    const double bow = chord ? 0 : 4 / 3.0 * tan((to - from) / 4) * c->r,
                 part[4] = { from, from, to, to }, side = c->mirror ? -1 : 1;
    const double zero[4] = { 0 };
    double at[4][2];

    for (int k = 0; k < 4; k++) {
        const double t = part[k] + c->angle, off = k == 1 ? bow : k == 2 ? -bow : 0;
        at[k][0] = c->r * cos(t) - off * sin(t);
        at[k][1] = side * (c->r * sin(t) + off * cos(t));
    }
    for (int k = 0; k < 4 && c->grid > 0; k++)
        for (int i = 0; i < 2; i++) {
            const double end = at[k < 2 ? 0 : 3][i], off = c->grid * round(end / c->grid) - end;
            if (k == 1 || k == 2)
                at[k][i] += off;
        }
    for (int k = 0; k < 4 && c->grid > 0; k += 3)
        for (int i = 0; i < 2; i++)
            at[k][i] = c->grid * round(at[k][i] / c->grid);
    for (int i = 0; i < 2 && chord; i++) {
        at[1][i] = at[0][i] + (at[3][i] - at[0][i]) / 3;
        at[2][i] = at[3][i] - (at[3][i] - at[0][i]) / 3;
    }
    add_curve(zero, zero, zero, zero, c->feed);
    loft_move *m = &chain[curves - 1];
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            m->curve.p[k].axis[i] = real_of(at[k][i]);
    if (curves > 1)
        m->curve.p[0] = chain[curves - 2].curve.p[3];
}

static void add_pieces(const ring_of *c, unsigned n, bool chords)
{
    begin_chain();
    for (unsigned k = 0; k < n; k++)
        add_piece(c, TURN * k / n, TURN * (k + 1) / n, chords);
}

/* sag: of a chord, a part of the tolerance; 0: cubics. */
static void add_ring(const ring_of *c, double sag)
{
    const double tol = arb_value(limits.tol);
    const double chords = fmin(500, ceil(TURN / sqrt(8 * sag * tol / c->r + 1e-9)));

    add_pieces(c, sag > 0 ? (unsigned)chords : 8, sag > 0);
}

static ring_of arb_ring(arb *a)
{
    const double accel = arb_decades(a, 300, 8000);

    even_limits(200, accel, accel * arb_decades(a, 10, 100));
    limits.tol = real_of(arb_decades(a, 0.003, 0.01));
    return (ring_of){ arb_decades(a, 1, 15), arb_decades(a, 30, 200), arb_between(a, 0, TURN),
                      false, 0 };
}

/* The joints of chords on the way from place k, which is on one from arc `*joint` on. */
static void joints_are_near(unsigned k, unsigned *joint, double *s)
{
    const loft_path_place *at[4];

    for (unsigned i = 0; i < 4; i++)
        at[i] = &found_at[k + i == 0 ? 0 : k + i - 1 < found ? k + i - 1 : found - 1];
    while (*joint + 1 < curves) {
        const loft_vec *p = chain[*joint].curve.p;
        double chord = 0, part;
        loft_position end;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double d = arb_value(p[3].axis[i]) - arb_value(p[0].axis[i]);
            chord += d * d;
            end.axis[i] = loft_coord_of(loft_to_acc(p[3].axis[i]));
        }
        part = (ldexp(*s + sqrt(chord), 24) - (double)along[k]) / (double)(along[k + 1] - along[k]);
        if (part > 1)
            return;
        CHECK(loft_path_off(at, (int32_t)ldexp(fmax(part, 0), 24), &end) <=
              loft_path_skip(&found_at[k]) + 8 * LOFT_COORD_GRAIN);
        *s += sqrt(chord);
        ++*joint;
    }
}

/* Nor is more of it skipped than is said, of chains of any curves, of chords, and of a circle in
 * many cubics or chords with 3 decimals at a feed that its bends do not allow. */
static void no_place_skips_more_than_the_tube(arb *a)
{
    const unsigned kind = arb_below(a, 8);
    ring_of c = arb_ring(a);
    unsigned joint = 0;
    double s = 0;

    if (kind == 0)
        arb_case(a);
    else if (kind == 1)
        add_ring(&c, arb_between(a, 0.05, 0.95));
    else {
        const double accel = arb_decades(a, 300, 8000);
        c.r = arb_decades(a, 1, 10);
        c.feed = arb_decades(a, 100, 500);
        c.grid = 0.001;
        even_limits(c.feed, accel, accel * arb_decades(a, 1, 10));
        limits.tol = real_of(arb_decades(a, 0.0015, 0.01));
        add_pieces(&c, (unsigned)arb_decades(a, 64, 500), kind < 4);
    }
    for (unsigned k = arb_below(a, 2) ? curves / 2 : curves; k < curves; k++)
        chain[k].feed = real_of(arb_value(chain[k].feed) * 0.7);
    CHECK(find_places() || found == PLACES);
    places_are_of_the_path(kind < 2);
    for (unsigned k = 0; k + 1 < found; k++) {
        const loft_coord most = period.tube + (found_at[k].loose ? period.more : 0);
        CHECK(loft_path_skip(&found_at[k]) <= most || along[k + 1] - along[k] < 64);
        if (kind == 1 && k > 0)
            joints_are_near(k, &joint, &s);
    }
}

/* Away from the ends of a circle of chords each way is as long as the last one, by little. */
static void ways_change_by_little(arb *a)
{
    const ring_of c = arb_ring(a);

    add_ring(&c, arb_between(a, 0.05, 0.7));
    CHECK(find_places());
    for (unsigned k = 12; k + 12 < found; k++) {
        const int64_t before = along[k] - along[k - 1], behind = along[k + 1] - along[k];
        CHECK(5 * before <= 7 * behind && 5 * behind <= 7 * before);
        CHECK(!found_at[k].sharp);
    }
}

/* Where the cap of speed depends on the direction, it jumps from arc to arc. Ways do not: with
 * little effort, otherwise guess.h takes care of that. */
static void ways_do_not_jump_with_the_cap(arb *a)
{
    ring_of c = arb_ring(a);

    c.feed = 1000;
    even_limits(arb_decades(a, 60, 200), 8000, 0);
    limits.max_speed[arb_below(a, 2)] = real_of(arb_decades(a, 40, 200));
    c.r = arb_between(a, 8, 15);
    add_pieces(&c, 4 + arb_below(a, 9), false);
    CHECK(find_places());
    for (unsigned k = 24; k + 24 < found; k++) {
        const int64_t way = along[k] - along[k - 1], jump = along[k + 1] - along[k] - way;
        CHECK(8 * loft_long_abs(jump) <= way);
    }
}

/* Places lie between the chords and their circle: so both are off by half of the sag, whatever the
 * chords are that a place is beside. Chords of more than 2 ways are longer than what is looked at,
 * and near an end it is less. */
static void chords_are_off_by_half_of_their_sag(arb *a)
{
    const ring_of c = arb_ring(a);
    const double sag = arb_between(a, 0.3, 0.95), tol = arb_value(limits.tol);

    add_ring(&c, sag);
    const double chord = TURN * c.r / curves;
    CHECK(find_places());
    for (unsigned k = 16; k + 16 < found; k++) {
        const double way = ldexp((double)(along[k + 1] - along[k]), -24);
        CHECK(!found_at[k].sharp);
        if (2 * way > chord && way < 2 * chord)
            CHECK_NEAR(ldexp(loft_path_skip(&found_at[k]), -24) / tol, sag / 2, 0.16);
    }
}

static unsigned places_of(const ring_of *c, double sag)
{
    add_ring(c, sag);
    CHECK(find_places());
    return found;
}

/* Chords of a circle have about as many places as the circle, however it is turned. */
static void a_circle_is_one_however_it_is_written(arb *a)
{
    ring_of c = arb_ring(a);
    const double sag = arb_between(a, 0.05, 0.6), whole = places_of(&c, 0),
                 chords = places_of(&c, sag);

    CHECK(chords < 1.5 * whole + 6);
    c.angle += TURN / 4;
    CHECK_NEAR(places_of(&c, sag), chords, 2 + chords / 50);
    c.mirror = true;
    CHECK_NEAR(places_of(&c, sag), chords, 2 + chords / 50);
}

static void curves_that_do_not_fit_are_refused(arb *a)
{
    arb_limits(a);
    begin_chain();
    arb_curve(a, LINE, 3, 10, false);
    arb_curve(a, LINE, 3, 10, false);
    loft_period_init(&period, &limits);
    loft_path_init(&planned, &period, ring, 2);
    CHECK(loft_chain_push(&planned.chain, &chain[0]) == LOFT_OK);
    CHECK(loft_chain_push(&planned.chain, &chain[0]) == LOFT_ERR_ARG);
    loft_move m = chain[1];
    m.feed = 0;
    CHECK(loft_chain_push(&planned.chain, &m) == LOFT_ERR_ARG);
    m.feed = LOFT_SPEED_MIN / 2;
    CHECK(loft_chain_push(&planned.chain, &m) == LOFT_ERR_RANGE);
    CHECK(loft_chain_push(&planned.chain, &chain[1]) == LOFT_OK);
    m = chain[1];
    m.curve.p[0] = m.curve.p[3];
    CHECK(loft_chain_push(&planned.chain, &m) == LOFT_ERR_SPACE);
}

/* Two lines with that turn between them. */
static void add_turn(double turn)
{
    const double zero[4] = { 0 };

    begin_chain();
    for (int n = 0; n < 2; n++) {
        add_curve(zero, zero, zero, zero, 20);
        for (int k = 0; k < 4; k++) {
            const double s = 2 * k / 3.0;
            chain[n].curve.p[k].axis[0] = real_of(n == 0 ? s : 2 + s * cos(turn));
            chain[n].curve.p[k].axis[1] = real_of(n == 0 ? 0 : s * sin(turn));
        }
    }
}

/* A chain ends before a curve whose direction differs by more than `exact` from the last one, or
 * where a plan has room for one curve alone. */
static void a_chain_ends_where_it_has_to_stop(arb *a)
{
    const double turn = arb_between(a, -3, 3), size = 2 * fabs(sin(turn / 2)),
                 exact = arb_between(a, 0.05, 1.9);

    arb_limits(a);
    limits.exact = real_of(arb_below(a, 4) ? exact : 0);
    add_turn(turn);
    loft_period_init(&period, &limits);
    loft_path_init(&planned, &period, ring, 2);
    CHECK(loft_chain_push(&planned.chain, &chain[0]) == LOFT_OK && !planned.chain.ended);
    const bool stops = loft_chain_push(&planned.chain, &chain[1]) == LOFT_ERR_SPACE;
    if (fabs(size - exact) > 0.01)
        CHECK(stops == (limits.exact > 0 && size > exact));
    CHECK(planned.chain.ended == stops);
    loft_path_init(&planned, &period, ring, 1);
    CHECK(loft_chain_push(&planned.chain, &chain[0]) == LOFT_OK && planned.chain.ended);
    limits.exact = 0;
}

int main(void)
{
    PROPERTY(places_lead_from_end_to_end, 120);
    PROPERTY(what_is_skipped_is_less_than_the_tolerance, 30);
    PROPERTY(corners_are_near_where_they_count, 30);
    PROPERTY(it_does_not_matter_how_a_path_is_cut, 20);
    PROPERTY(places_move_with_the_path, 40);
#if LOFT_FOLDS
    PROPERTY(what_is_left_out_comes_back, 100);
#endif
    if (LOFT_PLAN_EFFORT > 1)
        PROPERTY(a_line_takes_the_time_of_its_launches, 200);
    PROPERTY(no_place_skips_more_than_the_tube, 240);
    PROPERTY(ways_change_by_little, 200);
    if (LOFT_PLAN_EFFORT < 2)
        PROPERTY(ways_do_not_jump_with_the_cap, 30);
    PROPERTY(chords_are_off_by_half_of_their_sag, LOFT_PLAN_EFFORT > 1 ? 150 : 200);
    PROPERTY(a_circle_is_one_however_it_is_written, 200);
    PROPERTY(a_chain_ends_where_it_has_to_stop, 60);
    PROPERTY(curves_that_do_not_fit_are_refused, 5);
    return check_failures();
}
