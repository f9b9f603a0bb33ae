/* lib/motion/reach.c
 * SPDX-License-Identifier: MIT
 *
 * Time-optimal motion by reachability (H. Pham, Q.-C. Pham, IEEE Transactions on Robotics 34(3),
 * 2018) on pieces whose scope (scope.c) is a polygon in the plane of x, the square of the speed at
 * the start, and the acceleration a.
 *
 * Backward: from the largest x at the end of a piece follows the largest at its start, as far as
 * nothing changes any more. The known path ends in a stop, so what comes later only lets x grow;
 * where it is the cap, whatever comes, the speed is sure.
 *
 * Forward, piece by piece: the largest acceleration in the scope, unless that leads to more than
 * the next piece allows. Then up to three parts, each of even acceleration:
 *
 *      x     cap ________ last         1. as steep as the scope allows at the start
 *              /         \             2. along the cap, if the piece flows
 *             /           \            3. the line on which the next piece's speed is reached from
 *
 * Each is a part of a line through the piece that is in the scope. (The third may begin above the
 * cap, as far as the far end of the scope; where that is no further than the cap it is no steeper
 * than the second, and there is none.)
 *
 * A part that begins with speed v, ends with w and is d long takes 2 d / (v + w) seconds; after a
 * part z of that time the speed is v + z (w - v). So places at whole beats are exact.
 */
#include "motion/reach.h"

#include "motion/cut.h"     /* loft_cut_load */
#include "motion/scope.h"   /* loft_scope_most, loft_scope_brake */

static loft_acc square(loft_real v)                  { return loft_prod(v, v); }
static loft_acc length_of(const loft_plan_piece *p)  { return loft_unit_to_acc(p->length); }

static loft_unit part_of(loft_acc x, loft_acc whole)
{
    return x < whole ? x > 0 ? loft_unit_ratio(x, whole) : 0 : LOFT_UNIT(1);
}


/* Backward
 * -------- */

/* A joint holds its speed, a piece what it can brake from. */
static loft_acc before(const loft_plan_piece *p, loft_acc end)
{
    return p->length > 0 ? loft_scope_brake(p, end) : end;
}

static void look_back(loft_law *law)
{
    loft_course *c = &law->course;
    bool sure = c->ended && c->cut == c->move_count;
    loft_acc x = 0;

    for (unsigned j = c->count; j-- > law->at.piece + 1u; ) {
        loft_plan_piece *p = loft_course_piece(c, j);
        const loft_acc cap = p->stop ? 0 : square(p->cap), last = square(p->last);
        if (p->sure)
            return;
        const loft_acc end = loft_acc_min(x, last);
        x = before(p, end);
        sure = sure || !(x < cap);
        x = loft_acc_min(x, cap);
        p->brake = x < cap ? loft_acc_sqrt(x) : p->stop ? 0 : p->cap;
        p->sure  = sure;
    }
}

/* Is the speed at the end of the piece sure, or can nothing more be learned? */
static bool knows(loft_law *law)
{
    const loft_course *c = &law->course;
    const unsigned next = law->at.piece + 1u;

    for (int again = 0; again < 2; again++) {
        if (next < c->count ? loft_course_piece(c, next)->sure
                            : c->ended && c->cut == c->move_count)
            return true;
        if (again == 0)
            look_back(law);
    }
    return c->ended || loft_course_full(c);
}


/* Forward
 * ------- */

static loft_real aim_of(const loft_law *law)
{
    const loft_course *c = &law->course;
    const unsigned next = law->at.piece + 1u;
    const loft_real last = loft_course_piece(c, law->at.piece)->last,
                    brake = next < c->count ? loft_course_piece(c, next)->brake : 0;

    return brake < last ? brake : last;
}

static void add_part(loft_law *law, loft_acc end, loft_real speed)
{
    law->part[law->parts].end   = end;
    law->part[law->parts].speed = speed;
    law->parts++;
}

/* The square of the speed on what is left of a piece: at its start, and by how much it changes. */
typedef struct {
    loft_acc at, by;
} line;

static loft_acc value(const line *l, loft_unit z) { return l->at + loft_acc_scale(l->by, z); }

/* Where a meets b, which begins higher; the end, if it does not. */
static loft_unit meeting(const line *a, const line *b)
{
    const loft_acc nearer = a->by - b->by;
    return nearer > 0 ? part_of(b->at - a->at, nearer) : LOFT_UNIT(1);
}

/* A part that ends on l. */
static void add_to(loft_law *law, loft_acc way, const line *l, loft_unit z)
{
    add_part(law, law->at.off + loft_acc_scale(way, z), loft_acc_sqrt(value(l, z)));
}

/* The acceleration here. Beyond the start of the piece the line with acceleration a began with x -
 * 2 a off: that of x and that of the least such x there can be, whichever is less. */
static loft_real speeding_up(const loft_plan_piece *p, loft_acc off, loft_acc x)
{
    const loft_real a = loft_scope_most(p, x);
    if (!(off > 0 && a > 0))
        return a;
    const loft_acc  less = x - 2 * loft_acc_mul(off, a);
    const loft_real b = loft_scope_most(p, less > 0 ? less : 0);
    return b < a ? b : a;
}

/* More than what the end allows: speeding up, the cap, and braking to the end. */
static void add_parts(loft_law *law, const loft_plan_piece *p, const line *up, loft_acc way)
{
    const loft_acc  end = square(law->aim), last = square(p->last);
    const loft_unit left = law->at.off > 0 ? part_of(way, length_of(p)) : LOFT_UNIT(1);
    line cap, down;

    cap.by  = loft_acc_scale(last - square(p->cap), left);
    cap.at  = last - cap.by;
    down.by = loft_acc_scale(end - loft_scope_brake(p, end), left);
    down.at = end - down.by;
    if (down.at > up->at) {
        const loft_unit meet = meeting(up, &down);
        if (value(up, meet) <= value(&cap, meet))
            add_to(law, way, up, meet);
        else if (p->flows) {
            const loft_unit from = meeting(up, &cap), to = meeting(&cap, &down);
            add_to(law, way, &cap, from);
            add_to(law, way, &cap, to > from ? to : from);
        }
    }
    add_part(law, length_of(p), law->aim);
}

/* The parts of what is left of the piece. */
static void set_parts(loft_law *law)
{
    const loft_plan_piece *p = loft_course_piece(&law->course, law->at.piece);
    const loft_acc x = square(law->speed);

    law->aim  = aim_of(law);
    law->next = law->parts = 0;
    if (!(p->length > 0)) {
        add_part(law, 0, law->aim < law->speed ? law->aim : law->speed);
        return;
    }
    const loft_acc way = length_of(p) - law->at.off;
    const line up = { x, 2 * loft_acc_mul(way, speeding_up(p, law->at.off, x)) };
    if (x + up.by <= square(law->aim))
        add_part(law, length_of(p), loft_acc_sqrt(x + up.by));
    else
        add_parts(law, p, &up, way);
}

/* How far a beat gets that ends with speed v. */
static loft_acc beat_to(const loft_law *law, loft_real v)
{
    return loft_acc_scale((loft_to_acc(law->speed) + loft_to_acc(v)) / 2, law->course.budget.pulse);
}

/* And how far what is left of it. */
static loft_acc rest_of(const loft_law *law, loft_acc beat)
{
    return law->left < LOFT_UNIT(1) ? loft_acc_scale(beat, law->left) : beat;
}

/* Go on in the part, for what is left of the beat or to the part's end. */
static void run(loft_law *law)
{
    const loft_law_part *to = &law->part[law->next];
    const loft_acc way = to->end - law->at.off, beat = beat_to(law, to->speed),
                   here = rest_of(law, beat);

    if (here < way && beat > 0) {       /* q16: at speeds that are nothing nothing is far */
        const bool even = !(law->speed < to->speed || to->speed < law->speed);
        const loft_real v = even ? to->speed
                                 : loft_lerp(law->speed, to->speed, loft_unit_ratio(here, way));
        law->at.off += even ? here : loft_acc_min(rest_of(law, beat_to(law, v)), way);
        law->speed   = v;
        law->left    = 0;
    } else {
        law->left  -= way > 0 ? part_of(way, beat) : 0;
        law->left   = law->left > 0 ? law->left : 0;
        law->at.off = to->end;
        law->speed  = to->speed;
        law->next++;
    }
}

/* At the end of a piece: on to the next one, or rest. */
static bool pass(loft_law *law)
{
    if (law->at.piece + 1u >= law->course.count)
        return false;
    law->at    = (loft_course_place){ law->at.piece + 1u, 0 };
    law->parts = law->next = 0;
    return true;
}

/* At rest: drop what was passed, then begin what comes next. */
static bool leave(loft_law *law)
{
    loft_course *c = &law->course;

    if (law->parts > 0)
        for (unsigned drop = law->at.piece + 1u; drop > 0; drop--)
            loft_course_drop(c);
    law->at    = (loft_course_place){ 0, 0 };
    law->speed = 0;
    law->parts = law->next = 0;
    law->left  = LOFT_UNIT(1);
    loft_cut_load(c);
    law->rests = c->count == 0;
    return !law->rests;
}

/* The beat is over: pieces that were passed are not needed any more. */
static void tell(loft_law *law)
{
    while (law->at.piece > 0) {
        loft_course_drop(&law->course);
        law->at.piece--;
    }
    law->left = LOFT_UNIT(1);
}

enum loft_law_state loft_reach_next(loft_law *law)
{
    loft_course *c = &law->course;

    loft_cut_load(c);
    if (law->rests && !leave(law))
        return c->ended && c->cut == c->move_count ? LOFT_LAW_RESTS : LOFT_LAW_WAITS;
    if (law->next < law->parts && aim_of(law) > law->aim)
        set_parts(law);
    while (law->left > 0 && !law->rests) {
        if (law->parts == 0) {
            if (!knows(law))
                return LOFT_LAW_WAITS;
            set_parts(law);
        }
        run(law);
        if (law->next == law->parts)
            law->rests = !pass(law);
    }
    tell(law);
    return LOFT_LAW_RUNS;
}
