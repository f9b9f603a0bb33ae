/* lib/motion/cut.c
 * SPDX-License-Identifier: MIT
 *
 * Curves are cut into pieces when there is room for them; joints between them that limit the speed
 * become pieces without length.
 *
 * Where jerk is limited a joint may be eased, over a width that depends on the jump of its
 * curvature and on the room: a part of what it joins, within what is known, without a place of
 * rest. What the path does on that width is no matter of the joint alone (profile.c), so once the
 * width is known the pieces on it are looked at, on the far side before they are cut.
 */
#include "motion/cut.h"

#include "motion/scope.h"   /* loft_scope_init, loft_scope_join */

static bool set_piece(loft_plan_piece *p, const loft_course *c, const loft_arc *arc,
                      const loft_arc_shape *shape, loft_real feed)
{
    return LOFT_BUDGET_JERK(&c->budget) ? loft_profile_init(p, &c->budget, arc, shape, feed)
                                        : loft_scope_init(p, &c->budget, arc, shape, feed);
}

static void copy_station(loft_arc_shape *s, int to, const loft_vec *along, const loft_vec *bend)
{
    s->along[to] = *along;
    s->bend[to]  = *bend;
}

/* The shape of a piece that begins where the last one ended. */
static void measure(const loft_course *c, const loft_arc *arc, loft_arc_shape *shape)
{
    const bool goes_on = !LOFT_BUDGET_JERK(&c->budget) && c->smooth && !arc->speck && !arc->dust;

    if (goes_on)
        copy_station(shape, 0, &c->way.along, &c->way.bend);
    loft_arc_measure(arc, shape, goes_on ? LOFT_ARC_ALL - 1 : LOFT_ARC_ALL);
}

/* The first half of an arc, which ends in its middle. */
static void halve(const loft_course *c, loft_arc *arc, loft_arc_shape *shape, uint32_t size)
{
    const bool coarse = !LOFT_BUDGET_JERK(&c->budget), bends = !arc->speck && !arc->dust;

    loft_arc_cut(arc, &loft_course_move(c, c->cut)->curve, c->at, c->at + size / 2, coarse);
    copy_station(shape, 2, &shape->along[1], &shape->bend[1]);
    loft_arc_measure(arc, shape, coarse && bends && !arc->speck && !arc->dust ? 2 : LOFT_ARC_ALL);
}

/* A part of a curve that is to be one piece, and where it ends. */
typedef struct {
    loft_arc        arc;
    loft_arc_shape  shape;
    loft_plan_piece piece;
    uint32_t        to;
    loft_real       feed;
} part;

/* The next part of the curve. */
static void cut_part(const loft_course *c, part *t)
{
    uint32_t size = loft_arc_next(&t->arc, &loft_course_move(c, c->cut)->curve, c->at,
                                  !LOFT_BUDGET_JERK(&c->budget)) -
                    c->at;

    t->feed = loft_course_move(c, c->cut)->feed;
    measure(c, &t->arc, &t->shape);
    for (; t->arc.length > 0 && !set_piece(&t->piece, c, &t->arc, &t->shape, t->feed) && size > 1 &&
           t->arc.length >
               loft_budget_beat(&c->budget, t->piece.cap) / (LOFT_BUDGET_JERK(&c->budget) ? 1 : 32);
         size /= 2)
        halve(c, &t->arc, &t->shape, size);
    t->piece.chord = t->arc.speck || t->arc.dust;
    t->to = c->at + size;
}

/* The way where a part begins (0) or ends (2). Where jerk is not limited only the bend that the
 * next piece begins with matters. */
static loft_way way_at(const loft_course *c, const part *t, int k)
{
    if (LOFT_BUDGET_JERK(&c->budget))
        return loft_profile_way(&t->piece, &c->budget, &t->shape, k);
    return (loft_way){ .along = t->shape.along[k], .bend = t->shape.bend[k] };
}

#if LOFT_PLAN_FILTER > 1

/* How far from the end of what is known to the last place of rest, or of a cap below `slow`. */
static loft_acc since_rest(const loft_course *c, loft_acc most, loft_real slow)
{
    loft_acc d = 0;
    for (unsigned j = c->count; d < most && j > 0; j--) {
        const loft_plan_piece *p = loft_course_piece(c, j - 1);
        if (p->length > 0 && p->cap < slow)
            break;
        d += loft_unit_to_acc(p->length);
        if (p->stop)
            break;
    }
    return d;
}

/* How far the curve is known to go on from `to` likewise, in pieces that there is room for beside
 * two; to a side, if there is one, they are added. */
static loft_acc runs_on(loft_course *c, uint32_t to, loft_acc most, loft_real slow,
                        loft_flank *side)
{
    const uint32_t at = c->at;
    loft_acc d = 0;
    part t;

    c->at = to;
    for (unsigned n = c->count + 4u; n <= c->piece_room && d < most && c->at < LOFT_ARC_WHOLE;
         n++) {
        cut_part(c, &t);
        c->at = t.to;
        if (t.arc.speck || t.arc.dust || t.piece.cap < slow)
            break;
        if (side != NULL)
            loft_flank_add(side, &t.piece, &c->budget, &t.shape);
        d += t.arc.length;
    }
    c->at = at;
    return d;
}

/* Add the pieces within `width` of the end of what is known. Chords are left out: 2^-16 mm at most,
 * they do not bend. */
static void add_known(const loft_course *c, loft_flank *side, loft_acc width)
{
    loft_acc d = 0;
    loft_arc arc;
    loft_arc_shape shape;

    for (unsigned j = c->count; d < width && j > 0; j--) {
        const loft_plan_piece *p = loft_course_piece(c, j - 1);
        if (p->length > 0 && !p->chord) {
            loft_arc_cut(&arc, &c->moves[p->move].curve, p->from, p->to, false);
            loft_arc_measure(&arc, &shape, LOFT_ARC_ALL);
            loft_flank_add(side, p, &c->budget, &shape);
        }
        d += loft_unit_to_acc(p->length);
    }
}

/* Where jerk is limited: first it is found how far the joint is eased, then what lies there
 * matters, too. What asks for a lower speed by far than the path beside the joint ends the room for
 * it. */
static bool set_eased(loft_plan_piece *joint, loft_course *c, const part *t, loft_acc spacing)
{
    const loft_way start = way_at(c, t, 0);
    const loft_real slow = (start.cap < c->way.cap ? start.cap : c->way.cap) / 4 * 3;
    const loft_acc length = t->arc.length;
    loft_acc room = loft_acc_min(spacing / 8, loft_to_acc(LOFT_EASE_MAX));
    loft_flank before, after;

    room = loft_acc_min(room, since_rest(c, room, slow));
    room = loft_acc_min(room, length + runs_on(c, t->to, room - length, slow, NULL));
    loft_flank_init(&before, &c->way);
    loft_flank_init(&after, &start);
    const bool matters = loft_profile_join(joint, &c->budget, &before, &after, spacing, room,
                                           t->feed);
    const loft_acc width = matters ? loft_unit_to_acc(joint->ease.width) : 0;
    if (!(width > 0))
        return matters;
    add_known(c, &before, width);
    loft_flank_add(&after, &t->piece, &c->budget, &t->shape);
    (void)runs_on(c, t->to, width - length, slow, &after);
    return loft_profile_join(joint, &c->budget, &before, &after, spacing, room, t->feed);
}

#endif

static bool set_joint(loft_plan_piece *joint, loft_course *c, const part *t, loft_acc spacing)
{
#if LOFT_PLAN_FILTER > 1
    if (LOFT_BUDGET_JERK(&c->budget))
        return set_eased(joint, c, t, spacing);
#endif
    return loft_scope_join(joint, &c->budget, &c->way.along, &t->shape.along[0], spacing,
                           c->at == 0, c->feed, t->feed);
}

/* There is one more piece. */
static void widen(loft_course *c, const loft_plan_piece *last)
{
#if LOFT_PLAN_FILTER > 1
    if (LOFT_BUDGET_JERK(&c->budget))
        c->reach = loft_acc_max(c->count > 1 ? c->reach : 0, loft_course_zone(c, last));
#else
    (void)c;
    (void)last;
#endif
}

/* A joint before a part of the curve, if there is one that matters. */
static void add_joint(loft_course *c, const part *t)
{
    loft_acc spacing = c->at == 0 ? loft_acc_min(c->size, c->extent) : c->size;
    loft_plan_piece joint;

    if (t->arc.crumb)
        spacing = loft_acc_min(spacing, t->arc.length);
    if (c->crumb && c->count > 0)
        spacing = loft_acc_min(spacing,
                               loft_unit_to_acc(loft_course_piece(c, c->count - 1u)->length));
    if (set_joint(&joint, c, t, spacing)) {
        loft_plan_piece *p = loft_course_add(c);
        joint.from = p->from;
        joint.to   = p->to;
        joint.move = p->move;
        *p = joint;
        widen(c, p);
    }
}

/* Up to two pieces of the curve. */
static void load_pieces(loft_course *c)
{
    part t;

    cut_part(c, &t);
    if (t.arc.dust)
        c->smooth = false;
    else {
        if (c->known && (!c->smooth || t.arc.speck))
            add_joint(c, &t);
        c->way    = way_at(c, &t, 2);
        c->feed   = t.feed;
        c->known  = true;
        c->smooth = !t.arc.speck;
        c->crumb  = t.arc.crumb;
    }
    if (t.arc.length > 0) {
        loft_plan_piece *p = loft_course_add(c);
        t.piece.from = p->from;
        t.piece.to   = t.to;
        t.piece.move = p->move;
        *p = t.piece;
        widen(c, p);
    }
    c->at = t.to;
}

void loft_cut_load(loft_course *c)
{
    while (loft_course_cuts(c))
        load_pieces(c);
}
