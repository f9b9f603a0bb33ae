/* lib/motion/course.c
 * SPDX-License-Identifier: MIT
 *
 * Curves are cut into pieces (cut.c); each has a cap of the speed.
 *
 *        v^2   ______ cap
 *             /      \   __         \
 *            /        \_/  \    brake: from the right
 *           0               0
 *
 * The law of motion (law.c) is averaged over n beats afterwards, a window of time whose mean place
 * has left a piece while its ends are still there or before it. Therefore a piece with the cap c
 * casts its bounds to all places within
 *
 *     z = c (n + 2) h / 2
 *
 * on both sides (n h for the window, one more h as the law changes its acceleration between beats
 * only, and one as the spline of the samples looks beyond them: what is left of its reach weighs 1
 * / (48 n); and where a joint is eased, the way that takes). That is enough: a window of places
 * whose mean is in the piece lies within z of it. If its one end were further off, the time from
 * there to the mean's place would be more than half the window, at a speed of at most c, and the
 * mean would lie on that side.
 */
#include "motion/course.h"

#define GOALS   8       /* steps in which a brake's rising line is drawn in a stretch */


loft_move *loft_course_move(const loft_course *c, unsigned i)
{
    const unsigned k = c->move_first + i;
    return &c->moves[k < c->move_room ? k : k - c->move_room];
}

/* A joint's own jerk is spread over three beats by the spline of the samples. */
static loft_acc zone_at(const loft_course *c, loft_real v, bool joint)
{
    return loft_budget_beat(&c->budget, v) * (c->budget.filter + (joint ? 4 : 2)) / 2;
}

loft_acc loft_course_zone(const loft_course *c, const loft_plan_piece *p)
{
    const loft_acc zone = zone_at(c, p->cap, !(p->length > 0));
#if LOFT_PLAN_FILTER > 1
    return zone + loft_unit_to_acc(p->ease.width);
#else
    return zone;
#endif
}

/* How far the zones of all pieces reach, which features of the path may make much less than the
 * feed would. */
static loft_acc reach_of(const loft_course *c)
{
#if LOFT_PLAN_FILTER > 1
    return c->reach;
#else
    return c->zone;
#endif
}

void loft_course_init(loft_course *c, const loft_budget *budget, loft_move moves[],
                      uint16_t move_room, loft_plan_piece pieces[], uint16_t piece_room)
{
    c->budget     = *budget;
    c->moves      = moves;
    c->pieces     = pieces;
    c->move_room  = move_room;
    c->piece_room = piece_room;
    c->move_first = c->move_count = c->first = c->count = c->cut = c->passed = 0;
    c->at         = 0;
    c->size       = c->extent = c->zone = 0;
    c->feed       = 0;
    c->gear       = LOFT_UNIT(1);
    c->known      = c->smooth = c->crumb = c->ended = false;
}


/* The rings
 * --------- */

/* The largest distance of a control point from the first: 0 for a curve that is a point. */
static loft_acc extent(const loft_cubic *c)
{
    loft_acc most = 0;
    for (int k = 1; k < 4; k++)
        most = loft_acc_max(most, loft_vec_distance(c->p[0], c->p[k]));
    return most;
}

loft_plan_piece *loft_course_add(loft_course *c)
{
    loft_plan_piece *p = loft_course_piece(c, c->count++);
    p->from = p->to = c->at;
    p->move = (uint16_t)(loft_course_move(c, c->cut) - c->moves);
    return p;
}

bool loft_course_cuts(loft_course *c)
{
    while (c->cut < c->move_count) {
        if (c->at < LOFT_ARC_WHOLE && c->count + 2u > c->piece_room)
            return false;
        if (c->at == 0) {
            c->size   = extent(&loft_course_move(c, c->cut)->curve);
            c->smooth = false;
            c->at     = c->size > 0 ? 0 : LOFT_ARC_WHOLE;
        }
        if (c->at < LOFT_ARC_WHOLE)
            return true;
        c->extent = c->size > 0 ? c->size : c->extent;
        c->at = 0;
        c->cut++;
        if (c->count == 0)          /* it was a point, and nothing before it matters */
            loft_course_drop(c);
    }
    return false;
}

enum loft_status loft_course_push(loft_course *c, const loft_move *move)
{
    if (c->move_count == c->move_room)
        return LOFT_ERR_SPACE;
    if (!(move->feed > 0) || (c->move_count > 0 && !loft_vec_equal(move->curve.p[0], c->end)))
        return LOFT_ERR_ARG;
    if (move->feed < LOFT_SPEED_MIN || move->feed > LOFT_SPEED_MAX)
        return LOFT_ERR_RANGE;
    for (int k = 0; k < 4; k++)
        if (!loft_vec_within(move->curve.p[k], LOFT_PLAN_REACH))
            return LOFT_ERR_RANGE;
    *loft_course_move(c, c->move_count++) = *move;
    for (unsigned i = 0; c->ended && i < c->count; i++)     /* what was sure had no need to go on */
        loft_course_piece(c, i)->sure = false;
    c->end   = move->curve.p[3];
    c->ended = false;
    if (LOFT_BUDGET_JERK(&c->budget))
        c->zone = loft_acc_max(c->zone, zone_at(c, move->feed, true) + loft_to_acc(LOFT_EASE_MAX));
    return LOFT_OK;
}

bool loft_course_full(const loft_course *c)
{
    return c->cut < c->move_count || c->move_count == c->move_room;
}

/* Curves before the one that `piece` is of; all that have been cut without one. */
void loft_course_drop(loft_course *c)
{
    if (c->count > 0) {
        c->first = (uint16_t)(c->first + 1u < c->piece_room ? c->first + 1u : 0);
        c->count--;
    }
    while (c->cut > 0 && !(c->count > 0 && loft_course_piece(c, 0)->move == c->move_first)) {
        c->move_first = (uint16_t)(c->move_first + 1u < c->move_room ? c->move_first + 1u : 0);
        c->move_count--;
        c->cut--;
        c->passed++;
    }
}


/* Braking
 * ------- */

/* What holds at a place: bounds of its piece and of those whose zones it is in, and how far to the
 * left nothing changes. */
typedef struct {
    loft_acc  cap2, left;
    loft_real accel;
} bounds;

static void bound(const loft_plan_piece *p, bounds *b, loft_acc x, bool fore)
{
    const loft_real a = loft_profile_grip(p, x, fore);
    b->cap2  = loft_acc_min(b->cap2, loft_prod(p->cap, p->cap));
    b->accel = a < b->accel ? a : b->accel;
}

static bounds around(const loft_course *c, unsigned i, loft_acc off, loft_acc x, bool fore)
{
    const loft_acc reach = reach_of(c);
    const loft_plan_piece *p = loft_course_piece(c, i);
    bounds b = { loft_prod(p->cap, p->cap), off, LOFT_ACCEL_MAX };
    loft_acc d = loft_unit_to_acc(p->length) - off;

    bound(p, &b, x, fore);
    for (unsigned j = i + 1; j < c->count && d < reach; j++) {
        const loft_plan_piece *q = loft_course_piece(c, j);
        const loft_acc z = loft_course_zone(c, q);
        if (q->stop)
            break;
        if (d < z) {
            bound(q, &b, x, fore);
            b.left = loft_acc_min(b.left, z - d);
        }
        d += loft_unit_to_acc(q->length);
    }
    d = off;
    for (unsigned j = i; j > 0 && d <= reach + off && !loft_course_piece(c, j)->stop; j--) {
        const loft_plan_piece *q = loft_course_piece(c, j - 1);
        const loft_acc z = loft_course_zone(c, q);
        if (d <= z)
            bound(q, &b, x, fore);
        else
            b.left = loft_acc_min(b.left, d - z);
        d += loft_unit_to_acc(q->length);
    }
    if (c->gear < LOFT_UNIT(1))
        b.accel = loft_acc_round(loft_acc_scale(loft_to_acc(b.accel), c->gear));
    return b;
}

loft_acc loft_course_around(const loft_course *c, loft_course_place at, loft_acc x, bool fore,
                            loft_real *accel)
{
    const bounds b = around(c, at.piece, at.off, x, fore);
    *accel = b.accel;
    return b.cap2;
}

static loft_real grip_at(const loft_course *c, unsigned i, loft_acc off, loft_acc x)
{
    return around(c, i, off, x, false).accel;
}

/* From x, the square of the speed at `off`, backward over `way`, on which the bounds `b` hold,
 * b.accel at x or, for an x beyond the cap, where nothing rises. Goals are as far as the
 * acceleration leads that holds now, and not much nearer to the cap than where it is; that of the
 * goal is used if it is smaller. */
static loft_acc rise(const loft_course *c, unsigned i, loft_acc off, loft_acc way, loft_acc x,
                     bounds b)
{
    const loft_acc cap2 = b.cap2;
    loft_real here = b.accel;

    for (int n = 0; n < GOALS && x < cap2; n++) {
        const loft_acc far = x + 2 * loft_acc_mul(way, here),
                       most = n < GOALS - 1 && cap2 - x > cap2 / 16 ? x + (cap2 - x) / 4 : cap2;
        const loft_acc  goal = loft_acc_min(far, most);
        const loft_real there = grip_at(c, i, off, goal), g = there < here ? there : here;
        const loft_acc  gain = 2 * loft_acc_mul(way, g);
        if (gain <= goal - x)
            return x + gain;
        way -= loft_acc_min(way, loft_acc_scale(way, loft_unit_ratio(goal - x, gain)));
        x = goal;
        here = there;
    }
    return x;
}

bool loft_course_rests(const loft_course *c, unsigned i)
{
    return i + 1u >= c->count || loft_course_piece(c, i + 1)->stop;
}

/* Does nothing in the zones around piece i, nor what follows it, ask for less than its cap? The
 * brake curve is at the cap then. */
static bool runs(const loft_course *c, unsigned i)
{
    const loft_acc  reach = reach_of(c);
    const loft_real cap = loft_course_piece(c, i)->cap;
    loft_acc d = 0;

    if (loft_course_rests(c, i) || loft_course_piece(c, i + 1)->brake < cap)
        return false;
    for (unsigned j = i + 1; j < c->count && d < reach; j++) {
        if (loft_course_piece(c, j)->cap < cap)
            return false;
        d += loft_unit_to_acc(loft_course_piece(c, j)->length);
    }
    d = 0;
    for (unsigned j = i; j > 0 && d <= reach; j--) {
        if (loft_course_piece(c, j - 1)->cap < cap)
            return false;
        d += loft_unit_to_acc(loft_course_piece(c, j - 1)->length);
    }
    return true;
}

/* From x, the square of the speed at `off` on piece i, backward to `to`. */
static loft_acc back_over(const loft_course *c, unsigned i, loft_acc off, loft_acc x, loft_acc to)
{
    /* zones are not told apart by less */
    const loft_acc fine = loft_unit_to_acc(loft_course_piece(c, i)->length) / 1024;

    while (off > to) {
        const bounds   b   = around(c, i, off, x, false);
        const loft_acc way = loft_acc_min(loft_acc_max(b.left, fine), off - to);
        x = rise(c, i, off, way, loft_acc_min(x, b.cap2), b);
        off -= way;
    }
    return loft_acc_min(x, around(c, i, off, x, false).cap2);
}

loft_acc loft_course_brake(const loft_course *c, loft_course_place at)
{
    const loft_plan_piece *p = loft_course_piece(c, at.piece),
                          *next = loft_course_piece(c, at.piece + 1);

    if (runs(c, at.piece))
        return loft_prod(p->cap, p->cap);
    return back_over(c, at.piece, loft_unit_to_acc(p->length),
                     loft_course_rests(c, at.piece) ? 0 : loft_prod(next->brake, next->brake),
                     at.off);
}

unsigned loft_course_stop(const loft_course *c, unsigned i)
{
    for (i++; i < c->count; i++)
        if (loft_course_piece(c, i)->stop)
            return i;
    return c->count;
}

/* At the worst the path rests where the zones of what is to come begin: so `sure`, the square of
 * the speed at piece i's end, rises to what is given at its start; `open` is how far from its end
 * to the end of what is known. */
static loft_acc least_brake(const loft_course *c, unsigned i, loft_acc sure, loft_acc open)
{
    const loft_acc length = loft_unit_to_acc(loft_course_piece(c, i)->length),
                   closed = length - loft_acc_max(c->zone - open, 0);
    return closed > 0 ? back_over(c, i, closed, sure, 0) : 0;
}

/* A speed is sure when the one it is braked to is, or when it does not depend on that: at the cap,
 * whatever comes at the open end. */
void loft_course_look_back(loft_course *c, unsigned i)
{
    const unsigned stop = loft_course_stop(c, i);
    bool sure = stop < c->count || (c->ended && c->cut == c->move_count);
    loft_acc open = 0, least = 0;

    for (unsigned j = stop; j-- > i + 1; ) {
        loft_plan_piece *p = loft_course_piece(c, j);
        if (p->sure && sure)
            return;
        if (!sure)
            least = least_brake(c, j, least, open);
        open += loft_unit_to_acc(p->length);
        sure  = sure || !(least < loft_prod(p->cap, p->cap));
        p->brake = loft_acc_sqrt(loft_course_brake(c, (loft_course_place){ j, 0 }));
        p->sure  = sure;
    }
}
