/* lib/motion/law.c
 * SPDX-License-Identifier: MIT
 *
 * Beat by beat the law goes on (beat.c). The places that the plan uses are the means of n beats:
 * speed and acceleration are means, and acceleration changes by
 *
 *     (a(t) - a(t - n h)) / (n h)
 *
 * a second, which is at most the larger of both over n h, as they have not opposite signs. A law of
 * even acceleration with pauses of T becomes the fastest motion with limited jerk, and the path is
 * never left, for the mean of places of the path is taken along it.
 *
 * Where the path rests the window is empty, so n may be chosen anew: a way d from rest to rest with
 * jerk J is fastest with 2 J (n h)^3 = d, and speeds up to v do not need more than J (n h)^2 = v.
 *
 * That is for limited jerk in little room: where there is more, it is flow.c that moves, and
 * reach.c where jerk is not limited.
 */
#include "motion/law.h"

#include "motion/beat.h"    /* loft_beat_next, .. */
#include "motion/cut.h"     /* loft_cut_load */
#include "motion/reach.h"   /* loft_reach_next */

void loft_law_init(loft_law *law)
{
    law->at    = (loft_course_place){ 0, 0 };
    law->speed = 0;
    law->from  = 0;
    law->rests = true;
    law->parts = law->next = 0;
    law->left  = LOFT_UNIT(1);
#if LOFT_PLAN_FILTER > 1
    law->sum   = law->mean = 0;
    law->beats = law->course.budget.filter;
    law->slot  = 0;
    law->calm  = law->steady = UINT8_MAX;
    for (unsigned k = 0; k < LOFT_PLAN_FILTER; k++)
        law->way[k] = 0;
#endif
#if LOFT_PLAN_FLOW
    law->flows = LOFT_BUDGET_JERK(&law->course.budget) &&
                 law->course.piece_room >= LOFT_FLOW_PIECES;
    loft_flow_init(&law->flow);
#endif
}

#if LOFT_PLAN_FILTER > 1

/* A window of n beats has room for the section that begins at piece i: false if more curves may
 * make it longer. */
static bool choose_window(loft_law *law, unsigned i)
{
    loft_course *c = &law->course;
    const unsigned stop = loft_course_stop(c, i), most = c->budget.filter;
    const loft_real accel = loft_course_piece(c, i)->rest;
    loft_acc d = 0;
    loft_real v = 0;
    unsigned n = 1;

    for (unsigned j = i; j < stop; j++) {
        d += loft_course_length(c, j);
        v = loft_course_piece(c, j)->cap > v ? loft_course_piece(c, j)->cap : v;
    }
    const loft_real gain = loft_acc_round(
        loft_acc_ratio(loft_budget_beat(&c->budget, accel), (int32_t)most));
    for (; n < most; n++) {
        const loft_acc reach = loft_to_acc(gain) * (int32_t)(n * n);              /* J (n h)^2 */
        if (reach >= loft_to_acc(v) || 2 * loft_acc_scale(reach, c->budget.pulse) * (int32_t)n >= d)
            break;
    }
    if (n < most && stop == c->count && !c->ended && !loft_course_full(c))
        return false;
    law->beats = (uint8_t)n;
    c->gear = loft_unit_of(n, most);
    for (unsigned j = i; j < stop; j++)
        loft_course_piece(c, j)->sure = false;
    return true;
}

/* Drop pieces that the mean has passed and in whose zone the law is no more. */
static void forget(loft_law *law)
{
    loft_course *c = &law->course;

    while (law->from > 0) {
        loft_acc d = law->at.off;
        for (unsigned j = 1; j < law->at.piece; j++)
            d += loft_course_length(c, j);
        if (d <= loft_course_zone(c, loft_course_piece(c, 0)))
            return;
        loft_course_drop(c);
        law->from--;
        law->at.piece--;
    }
}

/* One beat more, in which it went `way`: the window forgets the oldest one. */
static void shift(loft_law *law, loft_unit way)
{
    law->sum += loft_unit_to_acc(way) - loft_unit_to_acc(law->way[law->slot]);
    law->way[law->slot] = way;
    law->slot = (uint8_t)(law->slot + 1u < law->beats ? law->slot + 1u : 0);
    law->mean += law->sum;
    while (law->at.piece > law->from &&
           law->mean >= loft_course_length(&law->course, law->from) * law->beats)
        law->mean -= loft_course_length(&law->course, law->from++) * law->beats;
    forget(law);
    law->calm = law->calm < UINT8_MAX ? (uint8_t)(law->calm + 1) : law->calm;
}

/* The path rests `d` before piece i, or is there already: a joint from piece `first` on that should
 * have been eased before it is a stop, too. */
static void late(loft_law *law, unsigned i, unsigned first, loft_acc d)
{
    loft_course *c = &law->course;

    for (; i < c->count && d < loft_to_acc(LOFT_EASE_MAX); i++) {
        loft_plan_piece *p = loft_course_piece(c, i);
        if (i >= first && d < loft_unit_to_acc(p->ease.width)) {
            p->stop = true;
            p->ease.width = 0;
            d = 0;
        }
        d += loft_unit_to_acc(p->length);
    }
}

/* Cut what has come, as far as there is room. Once the law rests, the way that the mean has still
 * to go is settled, too. */
static void load(loft_law *law)
{
    const unsigned known = law->course.count;

    loft_cut_load(&law->course);
    if (law->rests)
        late(law, law->at.piece, known, -law->at.off);
    else
        late(law, law->from, known, -loft_acc_ratio(law->mean, law->beats));
}

/* Nothing that was passed matters any more: the course begins with what comes next. */
static void settle(loft_law *law)
{
    /* that leads nowhere */
    const bool joint = law->course.count > 0 && !(loft_course_length(&law->course, 0) > 0) &&
                       loft_course_rests(&law->course, 0);

    if (law->at.off > 0 || law->at.piece > 0 || joint)
        for (unsigned drop = law->at.piece + 1; drop > 0; drop--)
            loft_course_drop(&law->course);
    law->at   = (loft_course_place){ 0, 0 };
    law->mean = law->sum = 0;
    law->slot = 0;
    law->from = 0;
    load(law);
}

/* At rest: empty the window, then begin what comes next. */
static enum loft_law_state leave(loft_law *law)
{
    loft_course *c = &law->course;

    if (law->calm <= law->beats) {
        shift(law, 0);
        return LOFT_LAW_RUNS;
    }
    settle(law);
    if (c->count == 0)
        return c->ended && c->cut == c->move_count ? LOFT_LAW_RESTS : LOFT_LAW_WAITS;
    if (!choose_window(law, 0))
        return LOFT_LAW_WAITS;
    law->calm  = UINT8_MAX;
    law->rests = false;
    loft_course_look_back(c, 0);
    return LOFT_LAW_RUNS;
}

/* Does the law, on its way to stop before piece `first`, hold what that and those after it ask for?
 * They cast their bounds to places where it is or was already, or where it will hold its speed
 * since it has just sped up. */
static bool agrees(const loft_law *law, unsigned first)
{
    const loft_course *c = &law->course;
    const int hold = law->steady <= law->beats ? law->beats + 1 - law->steady : 0;
    loft_acc d = -law->at.off;

    for (unsigned j = law->at.piece; j < first; j++)
        d += loft_course_length(c, j);
    for (unsigned j = first; j < c->count && d <= 2 * c->zone && !loft_course_piece(c, j)->stop;
         j++) {
        const loft_plan_piece *p = loft_course_piece(c, j);
        if (d < 2 * loft_course_zone(c, p))
            return false;
        d += loft_course_length(c, j);
    }
    return loft_beat_clear(law, loft_budget_beat(&c->budget, law->speed) * hold,
                           law->speed - law->speed / 2048);
}

/* New pieces while it moves: if they ask for less than what it counted on, the path rests before
 * them, as it would have. */
static void join(loft_law *law, unsigned first)
{
    loft_course *c = &law->course;
    const unsigned next = law->at.piece + 1;

    if (law->rests || first >= c->count || (next < first && loft_course_piece(c, next)->sure) ||
        loft_course_stop(c, law->at.piece) < first)
        return;
    loft_course_look_back(c, law->at.piece);
    if (!agrees(law, first)) {
        loft_course_piece(c, first)->stop = true;
        loft_course_piece(c, first)->ease.width = 0;
        late(law, first, first, 0);
        for (unsigned j = next; j < first; j++)
            loft_course_piece(c, j)->sure = false;
        loft_course_look_back(c, law->at.piece);
    }
}

#if LOFT_PLAN_FLOW

static enum loft_law_state flow(loft_law *law)
{
    const enum loft_flow_state state = loft_flow_next(&law->flow, &law->course);

    law->beats = 1;
    law->from  = law->flow.at;
    law->mean  = law->flow.off;
    law->sum   = law->flow.way;
    return state == LOFT_FLOW_RUNS    ? LOFT_LAW_RUNS
           : state == LOFT_FLOW_WAITS ? LOFT_LAW_WAITS
                                      : LOFT_LAW_RESTS;
}

#endif

/* The law of this file. */
static enum loft_law_state follow(loft_law *law)
{
    const unsigned known = law->course.count;

    load(law);
    join(law, known);
    if (law->rests) {
        const enum loft_law_state state = leave(law);
        if (state != LOFT_LAW_RUNS || law->rests)
            return state;
    }
    if (!loft_beat_knows(law))
        return LOFT_LAW_WAITS;
    shift(law, loft_beat_next(law));
    return LOFT_LAW_RUNS;
}

#endif

enum loft_law_state loft_law_next(loft_law *law)
{
#if LOFT_PLAN_FLOW
    if (law->flows)
        return flow(law);
#endif
#if LOFT_PLAN_FILTER > 1
    if (LOFT_BUDGET_JERK(&law->course.budget))
        return follow(law);
#endif
    return loft_reach_next(law);
}
