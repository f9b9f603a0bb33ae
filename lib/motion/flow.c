/* lib/motion/flow.c
 * SPDX-License-Identifier: MIT
 *
 * In a cell the acceleration is a straight line of the way, s'' = a0 + q s, so that speed is a sum
 * of cosh and sinh (or cos and sin) of the time, and with the mean of both ends' speeds, S = v0 +
 * v1, length h and y = q h^2 / S^2 = (a1 - a0) h / S^2
 *
 *     T = (2 h / S) atanh(sqrt y) / sqrt y
 *
 * of which (945 - 735 y + 64 y^2) / (945 - 1050 y + 225 y^2) is within 3e-4 up to y = 1/2. The
 * place is the quintic in t / T that has place, speed and acceleration of both ends. From rest it
 * is (t / T)^3, T = 3 h / v1, exactly.
 *
 * Beats are given when nothing more can come: the course has ended, or is full. Pieces ahead of the
 * next one are raised until the motion gets there. If what is known is used up, the path rests at
 * its end.
 */
#include "motion/flow.h"

#if LOFT_PLAN_FLOW

void loft_flow_init(loft_flow *f)
{
    loft_lane_init(&f->lane);
    f->at = 0;
    f->off = f->way = f->time = f->whole = 0;
    f->moves = false;
}

static bool rests_after(const loft_course *c, unsigned i)
{
    return i + 1u >= c->count || loft_course_piece(c, i + 1)->stop;
}

/* Speed and acceleration at both ends, times the time, of the length. */
static void set_powers(loft_flow *f, loft_acc v0, loft_acc v1, loft_acc a0, loft_acc a1)
{
    const loft_acc d = loft_to_acc(LOFT_REAL(1)) - v0 - a0 / 2, e = v1 - v0 - a0, g = a1 - a0;

    f->power[0] = 0;
    f->power[1] = v0;
    f->power[2] = a0 / 2;
    f->power[3] = 10 * d - 4 * e + g / 2;
    f->power[4] = 7 * e - 15 * d - g;
    f->power[5] = 6 * d - 3 * e + g / 2;
}

/* Is it enough for a way of that length from rest to rest, whatever its shape? Speed at most 15/8
 * of the mean, jerk 60 of the length over the time's cube; and where the shape makes three ways of
 * a beat point anywhere, the spline's acceleration is at most twice, its jerk four times the
 * longest of them. */
static bool hops_in(const loft_budget *b, loft_acc span, loft_acc most, loft_acc beats)
{
    const loft_inverse by = loft_inverse_of(beats);
    const loft_acc v = 2 * loft_inverse_mul(span, &by), a = loft_acc_ratio(v * b->tick_hz, b->beat);
    const loft_acc j = loft_inverse_mul(loft_inverse_mul(a, &by), &by);
    bool good = v < loft_to_acc(LOFT_SPEED_MAX) &&
                loft_prod(loft_acc_round(v), loft_acc_round(v)) <= most;

    for (int i = 0; i < LOFT_AXES; i++)
        good = good && 4 * a <= loft_to_acc(b->accel[i]) && 60 * j <= loft_to_acc(b->gain[i]) &&
               8 * a <= loft_to_acc(b->gain[i]);
    return good;
}

/* The least such time, to a 64th. */
static loft_acc hop_time(const loft_budget *b, loft_acc span, loft_acc most)
{
    loft_acc beats = loft_to_acc(LOFT_REAL(2)), step = 0;

    while (!hops_in(b, span, most, beats)) {
        step   = beats / 4;
        beats += step;
    }
    for (int k = 0; k < 4; k++) {
        step /= 2;
        if (step > 0 && hops_in(b, span, most, beats - step))
            beats -= step;
    }
    return beats;
}

/* The row that begins with piece f->at. */
static void enter_hop(loft_flow *f, const loft_course *c)
{
    loft_acc span = 0, most = loft_prod(LOFT_SPEED_MAX, LOFT_SPEED_MAX);

    f->length = 0;
    for (unsigned i = f->at; i < c->count && (i == f->at || !loft_course_piece(c, i)->stop); i++) {
        const loft_plan_cell *p = &loft_course_piece(c, i)->cell;
        f->length += loft_unit_to_acc(p->length);
        span += p->span;
        most = p->most < most ? p->most : most;
    }
    set_powers(f, 0, 0, 0, 0);
    f->whole = hop_time(&c->budget, span, most > LOFT_RAISE_CREEP ? most : LOFT_RAISE_CREEP);
}

static void enter_moving(loft_flow *f, const loft_plan_cell *p, const loft_plan_cell *next)
{
    const loft_real sum = p->v + next->v;
    const loft_acc s2 = loft_prod(sum, sum), a0 = loft_acc_scale(p->a, p->length),
                   a1 = loft_acc_scale(next->a, p->length);
    const loft_acc  y = loft_unit_to_acc(loft_unit_ratio(a1 - a0, s2));
    const loft_acc  y2 = loft_acc_scale(y, loft_unit_round(y)), one = loft_to_acc(LOFT_REAL(1));
    const loft_acc  up = 945 * one - 735 * y + 64 * y2, down = 945 * one - 1050 * y + 225 * y2;
    const loft_acc  more = loft_unit_to_acc(loft_unit_ratio(up - down, down));
    const loft_unit z = loft_unit_round(one + more);
    const loft_acc w0 =
        loft_acc_scale(loft_unit_to_acc(loft_unit_ratio(loft_to_acc(p->v), loft_to_acc(sum))), z) *
        2;
    const loft_acc w1 =
        loft_acc_scale(loft_unit_to_acc(loft_unit_ratio(loft_to_acc(next->v), loft_to_acc(sum))),
                       z) *
        2;
    const loft_acc g0 =
        loft_acc_scale(loft_acc_scale(loft_unit_to_acc(loft_unit_ratio(a0, s2)), z), z) * 4;
    const loft_acc g1 =
        loft_acc_scale(loft_acc_scale(loft_unit_to_acc(loft_unit_ratio(a1, s2)), z), z) * 4;
    const loft_inverse by = loft_inverse_of(loft_to_acc(sum));

    set_powers(f, w0, w1, g0, g1);
    f->whole = loft_acc_scale(loft_inverse_mul(p->span, &by), z) * 2;
}

/* Begin piece f->at. */
static void enter(loft_flow *f, const loft_course *c)
{
    const loft_plan_piece *p = loft_course_piece(c, f->at);
    const bool rests = rests_after(c, f->at);
    const loft_plan_cell *cell = &p->cell;
    const loft_acc one = loft_to_acc(LOFT_REAL(1));

    f->time = 0;
    f->off  = 0;
    f->length = loft_unit_to_acc(p->length);
    if (p->hop)
        enter_hop(f, c);
    else if (p->stop) {
        set_powers(f, 0, 3 * one, 0, 6 * one);
        f->whole = 3 * loft_acc_scale(cell->span, loft_course_piece(c, f->at + 1)->cell.r);
    } else if (rests) {
        set_powers(f, 3 * one, 0, -6 * one, 0);
        f->whole = 3 * loft_acc_scale(cell->span, cell->r);
    } else
        enter_moving(f, cell, &loft_course_piece(c, f->at + 1)->cell);
}

/* How far on the piece, or the row, it is. */
static loft_acc place(const loft_flow *f)
{
    const loft_unit t = f->time < f->whole ? loft_unit_ratio(f->time, f->whole) : LOFT_UNIT(1);
    loft_acc sum = f->power[5];

    for (int k = 4; k >= 0; k--)
        sum = loft_acc_scale(sum, t) + f->power[k];
    const loft_acc off = loft_acc_scale(f->length, loft_unit_round(sum));
    return off < f->length ? off : f->length;
}

/* May piece i be entered, with what is known? */
static bool knows(const loft_flow *f, unsigned i)
{
    return f->lane.closed || i + 3 <= f->lane.sure;
}

/* Go to the end of the piece; false: it rests there. */
static bool pass(loft_flow *f, const loft_course *c)
{
    const loft_acc length = loft_unit_to_acc(loft_course_piece(c, f->at)->length);

    f->way += length - f->off;
    f->off  = length;
    if (rests_after(c, f->at))
        return false;
    f->at++;
    f->off = 0;
    return true;
}

/* A beat in a row that is passed at once; f->off counts from its piece. */
static bool hop(loft_flow *f, const loft_course *c)
{
    const loft_acc before = place(f);

    f->time += loft_to_acc(LOFT_REAL(1));
    loft_acc go = place(f) - before;
    while (f->time >= f->whole ||
           go > loft_unit_to_acc(loft_course_piece(c, f->at)->length) - f->off) {
        go -= loft_unit_to_acc(loft_course_piece(c, f->at)->length) - f->off;
        if (!pass(f, c))
            return false;
    }
    f->off += go > 0 ? go : 0;
    f->way += go > 0 ? go : 0;
    return true;
}

/* A beat. False: it is at rest. */
static bool run(loft_flow *f, const loft_course *c)
{
    loft_acc beat = loft_to_acc(LOFT_REAL(1));

    f->way = 0;
    if (loft_course_piece(c, f->at)->hop)
        return hop(f, c);
    while (f->whole - f->time < beat) {
        beat -= f->whole - f->time;
        if (!pass(f, c)) {
            f->time = f->whole;
            return false;
        }
        enter(f, c);
    }
    f->time += beat;
    const loft_acc off = place(f);
    f->way += off > f->off ? off - f->off : 0;
    f->off  = off > f->off ? off : f->off;
    return true;
}

/* The piece that a beat may lead to. */
static unsigned ahead(const loft_flow *f, const loft_course *c)
{
    loft_acc beat = loft_to_acc(LOFT_REAL(1)) - (f->whole - f->time);
    unsigned i = f->at;

    if (loft_course_piece(c, i)->hop)
        return i;
    while (beat >= 0 && !rests_after(c, i) && i < f->at + 64) {
        loft_flow g = *f;
        g.at = ++i;
        enter(&g, c);
        beat -= g.whole;
    }
    return i;
}

enum loft_flow_state loft_flow_next(loft_flow *f, loft_course *c)
{
    const bool last = !f->moves && c->count > 0 && f->off > 0;
    const unsigned behind = last ? f->at + 1 : f->at;

    loft_lane_drop(&f->lane, c, behind);
    f->at = 0;
    if (last)
        f->off = 0;
    if (c->count == 0 || c->count + c->piece_room / 4u < c->piece_room || !(c->cut < c->move_count))
        loft_lane_load(&f->lane, c);
    const bool full = loft_course_full(c);
    if (c->ended && c->cut == c->move_count)
        loft_lane_close(&f->lane, c);
    if (c->count == 0)
        return c->ended && c->cut == c->move_count ? LOFT_FLOW_RESTS : LOFT_FLOW_WAITS;
    if (!(c->ended || full))
        return LOFT_FLOW_WAITS;
    loft_lane_raise(&f->lane, c, f->moves ? 2 : 0);
    if (!knows(f, f->moves ? ahead(f, c) : 0)) {
        loft_lane_load(&f->lane, c);
        loft_lane_raise(&f->lane, c, f->moves ? 2 : 0);
        if (!knows(f, f->moves ? ahead(f, c) : 0)) {
            loft_lane_close(&f->lane, c);
            loft_lane_raise(&f->lane, c, f->moves ? 2 : 0);
        }
    }
    if (!f->moves) {
        enter(f, c);
        f->moves = true;
    }
    f->moves = run(f, c);
    return LOFT_FLOW_RUNS;
}

#endif
