/* lib/motion/beat.c
 * SPDX-License-Identifier: MIT
 *
 * Beat by beat the law chooses the next speed v1: as fast as the acceleration allows, and such that
 *
 *     v1^2 <= brake at all places from here to where it would be v1 T further on        T = (n + 1)
 *         h
 *
 * so that between speeding up and braking it holds its speed for T at least; else it holds, or
 * follows the brake curve. Between braking and speeding up the zones of the pieces (course.c) keep
 * it at their speed for T.
 *
 * Places are looked at at the ends of beats, zones are for places at all times. For the mean to be
 * passed at a piece's cap c it suffices that each beat's way w is at most c h when it leads to more
 * than c h behind the start of the zone: then of n places whose oldest is the first one within the
 * zone the mean is half a beat before the piece or more. A beat that brakes at an even rate may
 * miss that: its speed falls to c at once where the brake curve does so just before the zone, or it
 * passes zone and all. Such a beat is done in parts, halved until the way of each is at most c
 * times its time when it leads to more than that behind the start: what is left of the beat then
 * goes on at c or less, so the whole leads to no more than c h. Beats that speed up do not: they
 * end with the cap of the place where they began at most.
 */
#include "motion/beat.h"

#if LOFT_PLAN_FILTER > 1

/* of a beat, 2^-12: no part is shorter, as the brake curve may fall at once */
#define SHORTEST LOFT_UNIT(0.000244140625)

static loft_acc length_of(const loft_law *law, unsigned i)
{
    return loft_course_length(&law->course, i);
}

/* The place `way` further on; false beyond the next rest, which it then is. */
static bool move(const loft_law *law, loft_course_place *at, loft_acc way)
{
    at->off += way;
    while (at->off > length_of(law, at->piece)) {
        if (loft_course_rests(&law->course, at->piece)) {
            at->off = length_of(law, at->piece);
            return false;
        }
        at->off -= length_of(law, at->piece++);
    }
    return true;
}

/* In the part `time` of a beat, from the speed that it has to v. */
static loft_acc way_to(const loft_law *law, loft_real v, loft_unit time)
{
    return loft_acc_scale((loft_budget_beat(&law->course.budget, law->speed) +
                           loft_budget_beat(&law->course.budget, v)) /
                              2,
                          time);
}

bool loft_beat_clear(const loft_law *law, loft_acc way, loft_real v)
{
    loft_course_place at = law->at;
    const loft_acc x = loft_prod(v, v);

    if (!move(law, &at, way))
        return false;
    for (unsigned j = law->at.piece + 1; j <= at.piece; j++)
        if (loft_course_piece(&law->course, j)->brake < v)
            return false;
    return loft_course_brake(&law->course, at) >= x;
}

static bool can_speed_up(const loft_law *law, loft_real v)
{
    return loft_beat_clear(law,
                           way_to(law, v, LOFT_UNIT(1)) +
                               loft_budget_beat(&law->course.budget, v) * (law->beats + 1),
                           v);
}

/* How fast the acceleration in the middle of a beat that ends with speed `top`, with the bounds
 * here and there, lets it end. */
static loft_real gained(const loft_law *law, loft_real top)
{
    const loft_real v = law->speed + (top - law->speed) / 2;
    loft_course_place at = law->at;
    loft_real here, later;

    loft_course_around(&law->course, at, loft_prod(v, v), true, &here);
    (void)move(law, &at, way_to(law, top, LOFT_UNIT(1)));
    loft_course_around(&law->course, at, loft_prod(v, v), true, &later);
    return law->speed +
           loft_acc_round(loft_budget_beat(&law->course.budget, here < later ? here : later));
}

/* The speed after one beat of speeding up, as far as it can: to 1/128 of what a beat gains. */
static loft_real faster(const loft_law *law)
{
    const loft_real v = law->speed;
    loft_real g;

    if (law->calm <= law->beats || loft_course_piece(&law->course, law->at.piece)->cap <= v)
        return v;
    const loft_real cap = loft_acc_sqrt(
        loft_course_around(&law->course, law->at, loft_prod(v, v), true, &g));
    if (cap <= v)
        return v;
    loft_real top = v + loft_acc_round(loft_budget_beat(&law->course.budget, g));
    top = top < cap ? top : cap;
    loft_real most = gained(law, top);
    for (int n = 0; n < 6 && most < top; n++) {         /* less is allowed at `top`: meet half
                                                         * way */
        top -= (top - most) / 2;
        most = gained(law, top);
    }
    top = most < top ? most : top;
    if (can_speed_up(law, top))
        return top;

    loft_real low = v, step = (top - v) / 2;
    if (v > 0 && !can_speed_up(law, v + step / 8))
        return v;
    for (int n = 0; n < (v > 0 ? 7 : 24) && step > 0; n++, step /= 2)
        low = can_speed_up(law, low + step) ? low + step : low;
    return low;
}

/* How much the brake curve leaves after `time` when the speed is v then. */
static loft_acc spare(const loft_law *law, loft_real v, loft_unit time)
{
    loft_course_place at = law->at;
    return move(law, &at, way_to(law, v, time))
               ? loft_course_brake(&law->course, at) - loft_prod(v, v)
               : -loft_prod(v, v);
}

/* Follow the brake curve: the largest speed that leaves something, by the Illinois form of regula
 * falsi, from a bracket as wide as two beats of braking. */
static loft_real slower(const loft_law *law, loft_unit time)
{
    const loft_real step =
        2 * loft_acc_round(loft_budget_beat(&law->course.budget,
                                            loft_course_piece(&law->course, law->at.piece)->rest));
    loft_real low = step < law->speed ? law->speed - step : 0, high = law->speed;
    loft_acc  over = spare(law, high, time);

    if (over >= 0)
        return high;
    loft_acc left = spare(law, low, time);
    if (left < 0) {
        high = low;
        over = left;
        low  = 0;
        left = spare(law, low, time);
    }
    for (int n = 0, side = 0; n < 16 && left > 0 && high - low > high / 65536 + LOFT_REAL(0.00003);
         n++) {
        const loft_real z = loft_lerp(low, high, loft_unit_ratio(left, left - over));
        const loft_real v = z > low && z < high ? z : low + (high - low) / 2;
        const loft_acc  f = spare(law, v, time);
        if (f >= 0) {
            low  = v;
            left = f;
            over = side > 0 ? over / 2 : over;
            side = 1;
        } else {
            high = v;
            over = f;
            left = side < 0 ? left / 2 : left;
            side = -1;
        }
    }
    return low;
}

bool loft_beat_knows(loft_law *law)
{
    loft_course *c = &law->course;
    const loft_real most = law->speed +
                           loft_acc_round(loft_budget_beat(&c->budget, LOFT_ACCEL_MAX));
    loft_real v = loft_course_piece(c, law->at.piece)->rest;

    v = law->speed + loft_acc_round(loft_budget_beat(&c->budget, v));
    v = v < most ? v : most;
    for (int again = 0; again < 2; again++) {
        loft_course_place at = law->at;
        (void)move(law, &at, loft_budget_beat(&c->budget, v) * (law->beats + 2));
        const unsigned next = at.piece + 1;
        if (next < c->count ? loft_course_piece(c, next)->stop || loft_course_piece(c, next)->sure
                            : c->ended)
            return true;
        loft_course_look_back(c, law->at.piece);
    }
    return c->ended || loft_course_full(c);
}

/* What is left to the next rest. */
static loft_acc remains(const loft_law *law)
{
    unsigned  i   = law->at.piece;
    loft_acc left = length_of(law, i) - law->at.off;

    while (!loft_course_rests(&law->course, i))
        left += length_of(law, ++i);
    return left;
}

/* The way at speed v in `time`. */
static loft_acc way_at(const loft_law *law, loft_real v, loft_unit time)
{
    return loft_acc_scale(loft_budget_beat(&law->course.budget, v), time);
}

/* The way that is allowed in `time` at a place. */
static loft_acc allowed(const loft_law *law, loft_course_place at, loft_unit time)
{
    loft_real unused;
    return way_at(law, loft_acc_sqrt(loft_course_around(&law->course, at, 0, false, &unused)),
                  time);
}

/* Is the way to `to` in `time` as slow as all pieces ask for that it passes, and all zones that it
 * leads into by more than their speed does? The slowest of them at the end, where speed v is
 * allowed, stands for all. */
static bool enters(const loft_law *law, loft_course_place to, loft_acc way, loft_real v,
                   loft_unit time)
{
    loft_course_place at = law->at;

    for (unsigned j = at.piece + 1; j <= to.piece; j++)
        if (way_at(law, loft_course_piece(&law->course, j)->cap, time) < way)
            return false;
    if (!(way_at(law, v, time) < way))
        return true;
    const loft_acc slow = allowed(law, to, time);
    if (!(slow < way))
        return true;
    (void)move(law, &at, way - slow);
    return !(allowed(law, at, time) < way);
}

/* Hold the speed for a beat, or follow the brake curve; gives the way. Where that falls too fast
 * for a beat it is followed in parts. */
static loft_acc brake(loft_law *law)
{
    loft_unit left = LOFT_UNIT(1), time = left;
    loft_acc whole = 0;

    while (left > 0) {
        const loft_real v = slower(law, time);
        loft_course_place to = law->at;
        const bool rests = !move(law, &to, way_to(law, v, time)) || !(v > 0);
        const loft_acc way = rests ? remains(law) : way_to(law, v, time);

        if (rests)
            (void)move(law, &to, way);
        if (time > SHORTEST && !enters(law, to, way, v, time)) {
            time /= 2;
            continue;
        }
        law->at    = to;
        law->speed = rests ? 0 : v;
        whole += way;
        left  = rests ? 0 : left - time;
        time  = 2 * time < left ? 2 * time : left;
    }
    return whole;
}

/* Ways are whole multiples of what the ring of ways holds, so that the mean ends where the law
 * does. */
loft_unit loft_beat_next(loft_law *law)
{
    const loft_real before = law->speed, v = faster(law);
    loft_course_place to = law->at;
    loft_acc whole = way_to(law, v, LOFT_UNIT(1));

    if (v > before)
        law->speed = v;
    else
        whole = brake(law);
    law->at = to;
    law->calm   = law->speed < before ? 0 : law->calm;
    law->steady = v > before                ? 0
                  : law->steady < UINT8_MAX ? (uint8_t)(law->steady + 1)
                                            : law->steady;

    loft_unit way = loft_unit_round(whole);
    if (!(way > 0))
        way = LOFT_UNIT(0.00000006);    /* q16: the least there is, lest it creeps without getting
                                         * on */
    if (!move(law, &to, loft_unit_to_acc(way)) || !(law->speed > 0)) {
        way = loft_unit_round(remains(law));
        to  = law->at;
        (void)move(law, &to, 2 * remains(law));     /* onto the end itself */
        law->rests = true;
        law->calm  = 0;
        law->speed = 0;
    }
    law->at = to;
    return way;
}

#endif
