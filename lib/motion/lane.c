/* lib/motion/lane.c
 * SPDX-License-Identifier: MIT
 *
 * Cells are about as long as what is passed in a third of the time in which the acceleration is
 * reached, and neighbours about as long as each other, as a row of even cells takes fewer sweeps
 * (raise.c); where nothing but limits along it counts they grow to twice the last one. On the way
 * to an arc with shorter ones they shrink by 8/5: in a long one there is one change of
 * acceleration, so the jerk allows it none before a tight bend, which then was reached at a crawl.
 * Where the path rests, with acceleration A and jerk J
 *
 *     A (A / J)^2 / 8, or 1/16 of the way between two rests + 3/4 of the way from there
 *
 * is the most, as the jerk is even in the first cell: the acceleration is reached after A (A / J)^2
 * / 6, and on a short way between two rests jerk changes after 1/12 of it. Curves are halved, and
 * up to 10/7 of it is taken. What is appended creeps; a rest at the end of what is known is planned
 * for only when nothing comes in time. The last cells before an open end creep, too: those that a
 * joint with the next curve may ease or take a part of the jerk from, and two more, which is what
 * it takes to come to rest from there.
 *
 * A joint's change of direction is passed at a speed at which it takes up to 4/5 of the jerk
 * (limits.c), for the two and a half beats before and behind it that the spline of the samples
 * spreads it over.
 *
 * Cells so short that not even creeping could begin there (below 2e-3 / sqrt(J) mm), or so tight
 * that it could not pass, are rows of their own, from rest to rest, passed at once (flow.c).
 */
#include "motion/lane.h"

#if LOFT_PLAN_FLOW

#define SWEEPS 16      /* at most */
#define PARTS  3       /* cells in the time in which the acceleration is reached */
#define LENGTH_MAX loft_to_acc(LOFT_REAL(64))    /* of an arc */
/* of the way between two rests the first and the last cell are such a part */
#define SHORT  16
/* a path is straight where its bends take less than such a part of the acceleration */
#define EVEN   1024

void loft_lane_init(loft_lane *l)
{
    l->closed = false;
    l->ease.width = 0;
    l->since = l->run = l->left = l->last = 0;
    l->grip = LOFT_UNIT(1);
    l->gate = 0;
    l->stop = true;
    l->hop = false;
    l->seen = 0;
    l->sure = 0;
}

static loft_acc length_of(const loft_course *c, unsigned i)
{
    return loft_unit_to_acc(loft_course_piece(c, i)->length);
}

/* The row that piece i is in, as far as it is known. */
static loft_row row_of(const loft_lane *l, const loft_course *c, unsigned i)
{
    loft_row row = { i, i + 1, 0, 0, false, false };

    while (row.first > 0 && !loft_course_piece(c, row.first)->stop)
        row.first--;
    while (row.end < c->count && !loft_course_piece(c, row.end)->stop)
        row.end++;
    row.starts = loft_course_piece(c, row.first)->stop;
    row.rests  = row.end < c->count || l->closed;
    return row;
}

/* Is it so short that not even creeping, at 1/64 mm/s, could end or begin there? x = 2^-12, and the
 * jerk is 2/9 x^(3/2) / h^2. */
static bool tiny(const loft_budget *b, const loft_plan_cell *p)
{
    const loft_acc jerk = loft_acc_ratio(loft_to_acc(loft_real_min(b->gain)) * b->tick_hz, b->beat);
    return p->length < LOFT_UNIT(0.0009765625) &&
           loft_acc_scale(loft_acc_scale(jerk, p->length), p->length) <
               loft_to_acc(LOFT_REAL(1)) / 262144;
}

/* Does it turn so much that not even creeping could pass? */
static bool tight(const loft_budget *b, const loft_plan_cell *p)
{
    for (int i = 0; i < LOFT_AXES; i++)
        for (int e = 0; e < 2; e++) {
            const loft_acc turn = loft_to_acc(p->turn[e].axis[i]),
                           most = loft_acc_mul(p->span, b->gain[i]);
            if ((turn < 0 ? -turn : turn) / 4096 > 32 * most)
                return true;
        }
    return p->most < 2 * LOFT_RAISE_CREEP;
}

/* Pass pieces first..end - 1 at once. */
static void hop(loft_course *c, unsigned first, unsigned end)
{
    loft_course_piece(c, first)->stop = true;
    for (unsigned i = first; i < end; i++)
        loft_course_piece(c, i)->hop = true;
}

/* The row that is known ends at rest: apart from its last pieces if those are tiny; at once if it
 * has less than three. */
static void settle(const loft_lane *l, loft_course *c)
{
    loft_row row = row_of(l, c, c->count - 1);
    unsigned end = row.end;

    if (loft_course_piece(c, row.first)->hop)
        return;
    while (end > row.first && tiny(&c->budget, &loft_course_piece(c, end - 1)->cell))
        end--;
    if (end < row.end)
        hop(c, end, row.end);
    row.end = end;
    if (row.end - row.first >= 3)
        loft_raise_close(c, &row);
    else if (row.end > row.first)
        hop(c, row.first, row.end);
}

void loft_lane_close(loft_lane *l, loft_course *c)
{
    if (!l->closed && c->count > 0)
        settle(l, c);
    l->closed = true;
}


/* Joints
 * ------ */

/* Ease the cells before the new one, if their speed has not been raised. */
static bool ease_back(const loft_lane *l, loft_course *c, const loft_ease *e)
{
    const loft_acc w = loft_unit_to_acc(e->width);
    loft_acc d = 0;
    unsigned i;

    for (i = c->count; i > 0 && d < w; d += length_of(c, i))
        i--;
    if (d < w || i < l->sure)
        return false;
    d = 0;
    for (i = c->count; i > 0 && d < w; ) {
        i--;
        d += length_of(c, i);
        loft_cell_ease(&loft_course_piece(c, i)->cell, &c->budget, e, -d);
    }
    return true;
}

/* Only a part of the jerk may be used near the new cell's start. */
static bool spare(loft_lane *l, loft_course *c, loft_unit grip)
{
    const loft_acc reach = loft_budget_beat(&c->budget, loft_acc_sqrt(l->gate)) * 5 / 2;
    loft_acc d = 0;

    for (unsigned i = c->count; i > 0 && d < reach; d += length_of(c, i)) {
        loft_plan_cell *p = &loft_course_piece(c, --i)->cell;
        if (i < l->sure)
            return false;
        p->grip = p->grip < grip ? p->grip : grip;
    }
    l->left = loft_acc_max(l->left, reach);
    l->grip = l->grip < grip ? l->grip : grip;
    return true;
}

/* How far the curve is known to go on without a feature at which the path may rest. */
static loft_acc runs_on(const loft_course *c, loft_acc most)
{
    const loft_cubic *curve = &loft_course_move(c, c->cut)->curve;
    loft_acc d = 0;
    loft_arc arc;

    for (uint32_t at = c->at; at < LOFT_ARC_WHOLE && d < most; d += arc.length) {
        at = loft_arc_next(&arc, curve, at, false);
        if (arc.dust || arc.speck)
            break;
    }
    return d;
}

/* The most where the feed changes. The speed of the samples' spline is that of the path and its
 * second derivative times h^2 / 6: that much of the jerk J that the direction allows is carried
 * across to the slower side. */
static loft_acc feed_most(const loft_course *c, const loft_way *after, loft_real feed)
{
    const loft_real slow = feed < c->feed ? feed : c->feed;
    loft_real gain = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++)
        gain = loft_real_cap(gain, c->budget.gain[i], loft_real_abs(after->along.axis[i]));
    const loft_real leak = loft_acc_round(loft_budget_beat(&c->budget, gain) / 6),
                    left = leak < slow / 2 ? slow - leak : slow / 2;
    return loft_prod(left, left);
}

/* What the joint before `next`, the first arc of what follows, asks for; false: a rest. */
static bool join(loft_lane *l, loft_course *c, const loft_plan_cell *next, const loft_way *after,
                 loft_acc spacing, loft_acc room)
{
    const loft_budget *b = &c->budget;
    const loft_acc most = loft_acc_max(loft_course_piece(c, c->count - 1)->cell.most, next->most);
    const loft_real feed = loft_acc_sqrt(most);
    const loft_acc turn = loft_budget_joint(b, &c->way.along, &after->along, spacing, true),
                   bend = loft_profile_jump(b, &c->way, after, spacing, feed);
    const loft_real slow = loft_acc_sqrt(loft_acc_min(turn, bend));
    loft_unit used = 0;

    if (slow < loft_acc_round(loft_acc_scale(loft_to_acc(loft_real_min(b->accel)), b->pulse) / 4))
        return false;
    if (turn / 1024 < most) {
        l->gate = loft_acc_min(l->gate, turn);
        used += loft_unit_round(loft_acc_scale(
            loft_to_acc(LOFT_REAL(0.8)),
            turn > most ? loft_unit_ratio(loft_to_acc(feed), loft_to_acc(loft_acc_sqrt(turn)))
                        : LOFT_UNIT(1)));
    }
    if (bend / 32 < most) {
        loft_ease e;
        for (int i = 0; i < LOFT_AXES; i++)
            e.jump[i] = after->bend.axis[i] - c->way.bend.axis[i];
        e.width = loft_ease_width(b, loft_vec_distance(c->way.bend, after->bend),
                                  loft_acc_min(room, l->run));
        if (loft_unit_to_acc(e.width) > 2 * loft_budget_beat(b, loft_acc_sqrt(bend))) {
            if (!ease_back(l, c, &e))
                return false;
            l->ease  = e;
            l->since = 0;
        } else {
            l->gate = loft_acc_min(l->gate, bend / 2);
            used += LOFT_UNIT(0.4);
        }
    }
    return !(used > 0) || spare(l, c, used < LOFT_UNIT(0.9) ? LOFT_UNIT(1) - used : LOFT_UNIT(0.1));
}


/* Cutting
 * ------- */

/* Beats in which the acceleration, or, if that is less, the one needed to reach speed v, J (n h)^2
 * = v, is reached. */
static int32_t reaches(const loft_budget *b, loft_real gain, loft_real v)
{
    int32_t n = 3;
    while (n < b->filter && loft_budget_beat(b, gain) * (n * n) < loft_to_acc(v))
        n++;
    return n;
}

/* What is passed at speed v in a third of n beats. */
static loft_acc even_part(const loft_budget *b, loft_real v, int32_t n)
{
    return loft_budget_beat(b, v) * n / PARTS;
}

/* Does it bend so little that only limits along it count? */
static bool straight(const loft_budget *b, const loft_plan_cell *c)
{
    for (int i = 0; i < LOFT_AXES; i++)
        for (int e = 0; e < 2; e++) {
            const loft_acc bend = loft_acc_mul(c->most, c->bend[e].axis[i]),
                           turn = loft_acc_mul(c->most, c->turn[e].axis[i]),
                           most = loft_to_acc(b->accel[i]) / EVEN;
            if (bend > most || bend < -most || turn > most || turn < -most)
                return false;
        }
    return true;
}

/* How long the first cell of the arc that begins at parameter `end` of the curve, or with the next
 * curve, may be. */
static loft_acc beyond(loft_lane *l, const loft_course *c, uint32_t end)
{
    const loft_budget *b = &c->budget;
    const bool over = end == LOFT_ARC_WHOLE, known = !over || c->cut + 1u < c->move_count;
    const loft_move *move = loft_course_move(c, known ? c->cut + over : c->cut);
    loft_arc arc;
    loft_arc_shape shape;
    loft_plan_cell cell;

    if (l->seen == end)
        return l->beyond;
    l->seen = end;
    l->beyond = LENGTH_MAX;
    if (!known)
        return LENGTH_MAX;
    (void)loft_arc_next(&arc, &move->curve, over ? 0 : end, false);
    if (arc.dust || !(arc.length > 0))
        return LENGTH_MAX;
    loft_arc_measure(&arc, &shape, LOFT_ARC_ALL);
    loft_cell_init(&cell, b, &arc, &shape, move->feed);
    const loft_real v = loft_acc_sqrt(cell.most);
    l->beyond = loft_acc_min(loft_unit_to_acc(cell.length),
                             even_part(b, v, reaches(b, loft_real_min(b->gain), v)));
    return l->beyond;
}

/* How long a cell should be: what is passed in a third of the time in which the acceleration is
 * reached; on a straight line longer and longer; shorter near a rest and at the end of a curve
 * which may be one; else about as long as the last one, and the `next` arc's. */
static loft_acc fitting(const loft_lane *l, const loft_course *c, const loft_plan_cell *whole,
                        bool ends, loft_acc next)
{
    const loft_budget *b = &c->budget;
    const loft_real gain = loft_real_min(b->gain), v = loft_acc_sqrt(whole->most);
    const int32_t  n = reaches(b, gain, v);
    const loft_acc rest = loft_unit_to_acc(whole->length);
    const loft_real accel = loft_acc_round(
        loft_acc_min(loft_to_acc(loft_real_min(b->accel)), loft_to_acc(gain) * n));
    /* A (A / J)^2 / 8 */
    const loft_acc reach = loft_acc_scale(loft_budget_beat(b, accel), b->pulse) * (n * n) / 8;
    const loft_acc near = l->may_rest
                              ? loft_acc_min(reach, loft_acc_max(l->run + rest, c->size) / SHORT)
                              : reach;
    loft_acc most = even_part(b, v, n);

    if (l->last > 0)
        most = loft_acc_min(loft_acc_max(loft_acc_min(most * 8 / 5, l->last), most / 2),
                            l->last * 2);
    if (straight(b, whole))
        most = loft_acc_max(most, loft_acc_min(l->last * 8 / 5, loft_to_acc(LOFT_REAL(32))));
    most = loft_acc_min(most, near + l->run * 3 / 4);
    most = loft_acc_min(most, ends ? loft_acc_max(near, rest * 3 / 7) : next + rest * 3 / 8);
    return loft_acc_max(loft_acc_min(most, c->size / 4), loft_to_acc(LOFT_REAL(1)) / 16384);
}

/* May the path rest at the end of the curve that is cut? */
static bool may_rest(const loft_course *c)
{
    const loft_move *move = loft_course_move(c, c->cut);
    loft_cubic back;
    loft_arc_shape end, start;
    loft_arc arc;

    if (c->cut + 1u >= c->move_count)
        return true;
    for (int k = 0; k < 4; k++)
        back.p[k] = move->curve.p[3 - k];
    (void)loft_arc_next(&arc, &back, 0, false);
    loft_arc_measure(&arc, &end, LOFT_ARC_ALL);
    (void)loft_arc_next(&arc, &loft_course_move(c, c->cut + 1u)->curve, 0, false);
    loft_arc_measure(&arc, &start, LOFT_ARC_ALL);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real turn = end.along[0].axis[i] + start.along[0].axis[i];
        if (turn > LOFT_REAL(0.01) || turn < LOFT_REAL(-0.01))
            return true;
    }
    return false;
}

static loft_way way_at(const loft_arc_shape *s, int k)
{
    loft_way way = { s->along[k], s->bend[k], 0, 0 };
    for (int i = 0; i < LOFT_AXES && s->tight; i++)
        way.bend.axis[i] = 0;
    return way;
}

/* What comes before the arc: does the path rest there? */
static void begin(loft_lane *l, loft_course *c, const loft_plan_cell *next,
                  const loft_arc_shape *shape, bool smooth, loft_acc spacing)
{
    const loft_way start = way_at(shape, 0);

    const loft_real feed = loft_course_move(c, c->cut)->feed;

    l->gate = next->most;
    l->stop = c->count == 0 || l->closed || !c->known;
    if (!l->stop && (feed < c->feed || feed > c->feed))
        l->gate = loft_acc_min(l->gate, feed_most(c, &start, feed));
    const loft_acc third = loft_acc_min(spacing / 3, loft_to_acc(LOFT_EASE_MAX));

    if (!l->stop && !smooth &&
        !join(l, c, next, &start, spacing, loft_acc_min(third, runs_on(c, third)))) {
        settle(l, c);
        l->stop = true;
        l->gate = next->most;
    }
    if (l->stop) {
        l->run = l->left = l->last = 0;
        l->ease.width = c->at > 0 ? l->ease.width : 0;      /* a rest on its way does not end it */
    }
    l->closed = false;
}

/* Is the last row one that is passed at once, and has not begun? Then what is passed at once behind
 * it is passed with it: a rest more takes two beats more. */
static bool continues(const loft_lane *l, const loft_course *c)
{
    return c->count > 0 && loft_course_piece(c, c->count - 1)->hop &&
           row_of(l, c, c->count - 1).first >= l->sure;
}

/* Does the cell belong to another row than the last one, as one of them is passed at once? */
static void part(loft_lane *l, loft_course *c, const loft_plan_cell *cell)
{
    const bool first = l->stop || l->hop,
               hops = tight(&c->budget, cell) || (first && tiny(&c->budget, cell));

    if (!l->stop && hops != l->hop) {
        settle(l, c);
        l->stop = true;
        l->run = l->left = 0;
    }
    l->hop = hops;
    if (l->stop && hops && continues(l, c))
        l->stop = false;
}

static void append(loft_lane *l, loft_course *c, const loft_plan_cell *cell, uint32_t to)
{
    const loft_acc length = loft_unit_to_acc(cell->length);
    loft_plan_piece *p = loft_course_add(c);

    p->length = cell->length;
    p->cap    = loft_acc_sqrt(cell->most);
    p->to     = to;
    p->cell   = *cell;
    p->stop   = l->stop;
    p->hop    = l->hop;
    p->ease   = l->ease;
    p->cell.gate = l->gate;
    if (l->since > 0)
        p->ease.width = 0;
    if (l->left > 0)
        p->cell.grip = l->grip;
    else
        l->grip = LOFT_UNIT(1);
    if (l->ease.width > 0)
        loft_cell_ease(&p->cell, &c->budget, &l->ease, l->since);
    l->last   = length;
    l->run   += length;
    l->since += length;
    l->left  -= length;
    l->sure   = l->stop && l->sure + 1 > c->count ? c->count - 1u : l->sure;
    const loft_row row = row_of(l, c, c->count - 1);
    loft_raise_append(c, &row);
}

/* Does the rate change so much that the length of the arc is not known well enough where it ends,
 * for the jerk? */
static bool uneven(const loft_arc *arc, loft_acc beat)
{
    const loft_unit most = LOFT_UNIT(0.03125);
    return (arc->ends[0] > most || arc->ends[0] < -most || arc->ends[1] > most ||
            arc->ends[1] < -most) &&
           arc->length > beat;
}

/* The next part of the curve that can be one cell. */
static void load_cell(loft_lane *l, loft_course *c)
{
    const loft_move *move = loft_course_move(c, c->cut);
    loft_arc arc;
    loft_arc_shape shape;
    loft_plan_cell cell;
    uint32_t to = loft_arc_next(&arc, &move->curve, c->at, false);

    if (c->at == 0) {
        l->may_rest = may_rest(c);
        l->seen = 0;
    }
    if (arc.dust || !(arc.length > 0)) {
        c->smooth = c->smooth && !arc.dust;
        c->at = to;
        return;
    }
    loft_arc_measure(&arc, &shape, LOFT_ARC_ALL);
    loft_cell_init(&cell, &c->budget, &arc, &shape, move->feed);
    begin(l, c, &cell, &shape, c->smooth && !arc.speck,
          c->at == 0 ? loft_acc_min(c->size, c->extent) : c->size);
    const loft_acc most = fitting(l, c, &cell, to == LOFT_ARC_WHOLE && l->may_rest,
                                  beyond(l, c, to));
    const loft_acc beat = loft_budget_beat(&c->budget, loft_acc_sqrt(cell.most));
    while (to - c->at > 1 && (arc.length > most * 10 / 7 || uneven(&arc, beat))) {
        to = c->at + (to - c->at) / 2;
        loft_arc_cut(&arc, &move->curve, c->at, to, false);
        loft_arc_measure(&arc, &shape, LOFT_ARC_ALL);
        loft_cell_init(&cell, &c->budget, &arc, &shape, move->feed);
    }
    part(l, c, &cell);
    append(l, c, &cell, to);
    loft_course_piece(c, c->count - 1u)->chord = arc.speck;
    c->way    = way_at(&shape, 2);
    c->feed   = move->feed;
    c->known  = true;
    c->smooth = !arc.speck;
    c->at     = to;
}

void loft_lane_load(loft_lane *l, loft_course *c)
{
    while (loft_course_cuts(c))
        load_cell(l, c);
}

void loft_lane_drop(loft_lane *l, loft_course *c, unsigned count)
{
    for (; count > 0; count--) {
        loft_course_drop(c);
        l->sure -= l->sure > 0;
    }
}


/* Raising
 * ------- */

/* The last two cells, and those that a joint at the end of the last curve may ease. */
unsigned loft_lane_open(const loft_lane *l, const loft_course *c)
{
    if (l->closed || c->count == 0)
        return c->count;
    const loft_plan_cell *last = &loft_course_piece(c, c->count - 1)->cell;
    const loft_acc ease = loft_acc_min(c->extent / 3, loft_to_acc(LOFT_EASE_MAX)),
                   seen = loft_acc_min(c->extent / 4,
                                       loft_budget_beat(&c->budget, loft_acc_sqrt(last->most)) * 5 /
                                           2);
    const loft_acc zone = c->at == 0 ? loft_acc_max(ease, seen) : 0;
    unsigned i = c->count;
    loft_acc d = 0;

    for (; i > 0 && (d < zone || tiny(&c->budget, &loft_course_piece(c, i - 1)->cell)); i--)
        d += length_of(c, i - 1);
    return i > 2 ? i - 2 : 0;
}

void loft_lane_raise(loft_lane *l, loft_course *c, unsigned begun)
{
    const unsigned open = loft_lane_open(l, c);

    if (open <= l->sure)
        return;
    for (unsigned i = row_of(l, c, l->sure).first; i < c->count; ) {
        loft_row row = row_of(l, c, i);
        row.from = row.first > begun ? row.first : begun;
        row.to   = row.rests ? row.end : open;
        if (row.from < row.to && !loft_course_piece(c, row.first)->hop)
            loft_raise(c, &row, SWEEPS);
        i = row.end;
    }
    l->sure = open;
}

#endif
