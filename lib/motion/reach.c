/* lib/motion/reach.c
 * SPDX-License-Identifier: MIT
 *
 * Time-optimal motion by reachability (H. Pham, Q.-C. Pham, IEEE Transactions on Robotics 34(3), 2018) on pieces whose scope (scope.c)
 * is a polygon in the plane of x, the square of the speed at the start, and the acceleration a.
 *
 * Backward: from the largest x at the end of a piece follows the largest at its start, as far as nothing changes any more. The known path
 * ends in a stop, so what comes later only lets x grow; where it is the cap, whatever comes, the speed is sure.
 *
 * Forward, piece by piece: the largest acceleration in the scope, unless that leads to more than the next piece allows. Then up to three
 * parts, each of even acceleration:
 *
 *      x     cap ________ last         1. as steep as the scope allows at the start
 *              /         \             2. along the cap, if the piece flows
 *             /           \            3. the line on which the next piece's speed is reached from
 *
 * Each is a part of a line through the piece that is in the scope. (The third may begin above the cap, as far as the far end of
 * the scope; where that is no further than the cap it is no steeper than the second, and there is none.)
 *
 * A part that begins with speed v, ends with w and is d long takes 2 d / (v + w) seconds; after a part z of that time the speed
 * is v + z (w - v). So places at whole beats are exact.
 */
#include "motion/reach.h"

#include "motion/scope.h"   /* loft_scope_most, loft_scope_brake */

static loft_acc smaller(loft_acc x, loft_acc y)      { return x < y ? x : y; }
static loft_acc square(loft_real v)                  { return loft_prod(v, v); }
static loft_acc length_of(const loft_plan_piece *p)  { return loft_unit_wide(p->length); }

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
        const loft_acc end = smaller(x, last);
        x = before(p, end);
        sure = sure || !(x < cap);
        x = smaller(x, cap);
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
        if (next < c->count ? loft_course_piece(c, next)->sure : c->ended && c->cut == c->move_count)
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
    const loft_real last = loft_course_piece(c, law->at.piece)->last, brake = next < c->count ? loft_course_piece(c, next)->brake : 0;

    return brake < last ? brake : last;
}

static void add_part(loft_law *law, loft_acc end, loft_real speed)
{
    law->part[law->parts].end   = end;
    law->part[law->parts].speed = speed;
    law->parts++;
}

/* The acceleration here. Beyond the start of the piece the line with acceleration a began with x - 2 a off: that of x and that
 * of the least such x there can be, whichever is less. */
static loft_real speeding_up(const loft_plan_piece *p, loft_acc off, loft_acc x)
{
    const loft_real a = loft_scope_most(p, x);
    if (!(off > 0 && a > 0))
        return a;
    const loft_acc  less = x - 2 * loft_acc_mul(off, a);
    const loft_real b = loft_scope_most(p, less > 0 ? less : 0);
    return b < a ? b : a;
}

/* More than what the end allows: `rise` and `fall` are the changes of x on the way that is left, by speeding up from x and by
 * braking to `end`. */
static void add_parts(loft_law *law, const loft_plan_piece *p, loft_acc x, loft_acc rise, loft_acc end)
{
    const loft_acc  off = law->at.off, length = length_of(p), way = length - off;
    const loft_acc  cap = square(p->cap), last = square(p->last);
    const loft_unit left = off > 0 ? part_of(way, length) : LOFT_UNIT(1);
    const loft_acc  fall = loft_acc_scale(loft_scope_brake(p, end) - end, left), top = last + loft_acc_scale(cap - last, left);
    const loft_acc  spare = end + fall - x;

    if (spare > 0) {
        const loft_unit meet = part_of(spare, rise + fall);
        const loft_acc  peak = x + loft_acc_scale(rise, meet), slope = last - top;
        if (peak <= top + loft_acc_scale(slope, meet))
            add_part(law, off + loft_acc_scale(way, meet), loft_acc_sqrt(peak));
        else if (p->flows) {
            const loft_unit from = part_of(top - x, rise - slope), brakes = fall + slope > 0 ? part_of(last - end, fall + slope) : 0;
            const loft_unit to = LOFT_UNIT(1) - brakes > from ? LOFT_UNIT(1) - brakes : from;
            add_part(law, off + loft_acc_scale(way, from), loft_acc_sqrt(top + loft_acc_scale(slope, from)));
            add_part(law, off + loft_acc_scale(way, to), loft_acc_sqrt(top + loft_acc_scale(slope, to)));
        }
    }
    add_part(law, length, law->aim);
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
    const loft_acc end = square(law->aim), rise = 2 * loft_acc_mul(length_of(p) - law->at.off, speeding_up(p, law->at.off, x));
    if (x + rise <= end)
        add_part(law, length_of(p), loft_acc_sqrt(x + rise));
    else
        add_parts(law, p, x, rise, end);
}

/* Go on in the part, for what is left of the beat or to the part's end. */
static void run(loft_law *law)
{
    const loft_budget *b = &law->course.budget;
    const loft_law_part *to = &law->part[law->next];
    const loft_acc way = to->end - law->at.off, beat = (loft_budget_beat(b, law->speed) + loft_budget_beat(b, to->speed)) / 2;
    const loft_acc here = loft_acc_scale(beat, law->left);

    if (here < way && beat > 0) {       /* q16: at speeds that are nothing nothing is far */
        const loft_real v = loft_lerp(law->speed, to->speed, loft_unit_ratio(here, way));
        const loft_acc  on = loft_acc_scale((loft_budget_beat(b, law->speed) + loft_budget_beat(b, v)) / 2, law->left);
        law->at.off += smaller(on, way);
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
    law->from  = 0;
    law->mean  = law->sum = 0;
    law->speed = 0;
    law->parts = law->next = 0;
    law->left  = LOFT_UNIT(1);
    loft_course_load(c);
    law->rests = c->count == 0;
    return !law->rests;
}

/* The beat is over: pieces that were passed are not needed any more. */
static void tell(loft_law *law, loft_acc before)
{
    while (law->at.piece > 0) {
        loft_course_drop(&law->course);
        law->at.piece--;
    }
    law->from = 0;
    law->sum  = law->at.off - before;
    law->mean = law->at.off;
    law->left = LOFT_UNIT(1);
}

enum loft_law_state loft_reach_next(loft_law *law)
{
    loft_course *c = &law->course;
    const loft_acc from = law->at.off;

    loft_course_load(c);
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
    tell(law, from);
    return LOFT_LAW_RUNS;
}
