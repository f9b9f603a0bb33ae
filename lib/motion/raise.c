/* lib/motion/raise.c
 * SPDX-License-Identifier: MIT
 *
 * The control values b of a row of cells (cell.c) are raised by smooth bumps: over 2 W of the
 * length, with z = |s| / W
 *
 *     1 - 2 z^2  up to z = 1/2        2 (1 - z)^2  up to z = 1
 *
 * whose control value in a cell from z1 to z2 is its polar form, 1 - 2 z1 z2 or 2 (1 - z1) (1 -
 * z2), so that it is as smooth whatever the lengths of the cells. Each bump is raised by half of
 * what all limits of all cells that it touches allow. After every bump the row holds them, so the
 * work may end at any time, what has begun to move stays as it is, and cells that are appended
 * creep at first.
 *
 * Half, as what one bump uses up others, of other widths or beside it, cannot: whole ones end at
 * 1.10 of the least time of an outline, halves at 1.06.
 *
 * Wide bumps first, W = 16 cells, 8, 4, 2, 1, with their middles half of that apart: what hinders a
 * wide one hinders some of the narrow ones only.
 *
 * A row that creeps as a whole is fastest raised as a whole: all control values are doubled as
 * often as all limits allow, less seven times, as where one limit is used up alone bumps find no
 * way on. Sweeps end when one gains less than 1/1024 of the time.
 *
 * Where all of the jerk is used no bump can be raised. Braking must not do that before an end that
 * is open, for when more cells come the speed could not grow there. At the distance d before it no
 * more is allowed than
 *
 *     x = (s d)^2  up to v = A / 2 s        x = A d - (A / 2 s)^2  beyond            s = J / 3 A
 *
 * which slows down by A / 2 at most, with a jerk of s^2 v, at most J / 6; joints have the rest.
 */
#include "motion/raise.h"

#if LOFT_PLAN_FLOW

#define WIDEST 16
#define EASY   3        /* J / A over s */
#define BACK   7        /* so often less than it could be */
#define ENOUGH 1024     /* a sweep that gains less than such a part of the time is the last one */

static loft_plan_cell *cell_of(const loft_course *c, unsigned i)
{
    return &loft_course_piece(c, i)->cell;
}

static loft_acc length_of(const loft_course *c, unsigned i)
{
    return loft_unit_to_acc(cell_of(c, i)->length);
}

/* Speed and acceleration at the start of piece i of the row. */
static void set_knot(const loft_course *c, const loft_row *row, unsigned i)
{
    loft_plan_cell *p = cell_of(c, i);

    if (i == row->first) {
        if (row->starts) {
            p->x = p->a = 0;
            p->v = 0;
            p->r = 0;
        }
        return;
    }
    const loft_acc before = cell_of(c, i - 1)->b;
    p->x = loft_acc_lerp(before, p->b, p->part);
    p->a = loft_inverse_mul(p->b - before, &p->both);
    p->v = loft_acc_sqrt(p->x);
    p->r = loft_unit_round(loft_acc_div(loft_to_acc(LOFT_REAL(1)), p->v));
}

/* The part of the second cell's control value that the first one has if it begins at rest; so for
 * the last. */
static loft_acc tied(const loft_course *c, unsigned i, unsigned inner, loft_acc b)
{
    const loft_acc h = length_of(c, i);
    return loft_acc_scale(b, loft_unit_ratio(h, 3 * h + 2 * length_of(c, inner)));
}

void loft_raise_append(const loft_course *c, const loft_row *row)
{
    const unsigned i = row->end - 1;
    loft_plan_cell *p = cell_of(c, i);

    p->b = LOFT_RAISE_CREEP;
    p->rise = 0;
    if (i > row->first) {
        const loft_acc h = length_of(c, i - 1), both = h + length_of(c, i);
        p->part = loft_unit_ratio(h, both);
        p->both = loft_inverse_of(both);
    }
    if (i == row->first + 1 && row->starts)
        cell_of(c, i - 1)->b = tied(c, i - 1, i, p->b);
    set_knot(c, row, i);
}

void loft_raise_close(const loft_course *c, const loft_row *row)
{
    cell_of(c, row->end - 1)->b = tied(c, row->end - 1, row->end - 2, cell_of(c, row->end - 2)->b);
    set_knot(c, row, row->end - 1);
}


/* Bumps
 * ----- */

/* How far the bump in the middle of piece `middle` reaches on one side: to the middle of piece
 * `last`, or beyond it by that of `more`. */
static loft_acc reach_of(const loft_course *c, unsigned middle, unsigned last, bool whole,
                         loft_acc more)
{
    loft_acc d = length_of(c, middle) / 2;
    for (unsigned i = middle; i != last; )
        d += length_of(c, i = i < last ? i + 1 : i - 1);
    return whole ? d + more : middle == last ? d : d - length_of(c, last) / 2;
}

static loft_unit least(loft_unit x, loft_unit y) { return x < y ? x : y; }

/* The bump's control value between two places on one side, parts of its reach. */
static loft_unit bump(loft_unit near, loft_unit far)
{
    const loft_unit one = LOFT_UNIT(1);
    if (near + far < one)
        return one - 2 * loft_unit_round(loft_acc_scale(loft_unit_to_acc(near), far));
    return far < one ? 2 * loft_unit_round(loft_acc_scale(loft_unit_to_acc(one - near), one - far))
                     : 0;
}

/* Give piece i its part of the rise, which is lowered to what it has room for. */
static loft_acc put(const loft_course *c, unsigned i, loft_unit part, loft_acc rise, loft_acc *top)
{
    loft_plan_cell *p = cell_of(c, i);
    const loft_acc room = loft_acc_min(p->top - p->b, 4 * p->b), want = loft_acc_scale(rise, part);

    p->rise = loft_unit_to_acc(part);
    if (want > room)
        *top = loft_acc_min(*top, room > 0 ? loft_acc_scale(rise, loft_unit_ratio(room, want)) : 0);
    return *top;
}

/* From the middle to one side, to piece `last`. */
static loft_acc put_side(const loft_course *c, unsigned middle, unsigned last, loft_acc reach,
                         loft_acc rise)
{
    loft_acc d = length_of(c, middle) / 2;
    loft_unit near = least(loft_unit_ratio(loft_acc_min(d, reach), reach), LOFT_UNIT(1));

    for (unsigned i = middle; i != last; ) {
        i = i < last ? i + 1 : i - 1;
        d += length_of(c, i);
        const loft_unit far = loft_unit_ratio(loft_acc_min(d, reach), reach);
        (void)put(c, i, bump(near, far), rise, &rise);
        near = far;
    }
    return rise;
}

typedef struct {
    unsigned low, high;         /* the pieces whose limits it may touch */
} touched;

static loft_cell_rise rise_at(const loft_course *c, const loft_row *row, unsigned i)
{
    const loft_cell_rise none = { 0, 0 };
    if (i == row->first || i >= row->end)
        return none;
    const loft_plan_cell *p = cell_of(c, i);
    const loft_acc before = cell_of(c, i - 1)->rise;
    return (loft_cell_rise){ loft_acc_lerp(before, p->rise, p->part),
                             loft_inverse_mul(p->rise - before, &p->both) };
}

/* The part of the rise that all limits allow. */
static loft_unit allowed(const loft_course *c, const loft_row *row, touched t)
{
    loft_cell_rise at = rise_at(c, row, t.low);
    loft_unit z = LOFT_UNIT(1);

    for (unsigned i = t.low; i <= t.high && z > 0; i++) {
        const loft_cell_rise to = rise_at(c, row, i + 1);
        const bool last = i + 1 == row->end;
        z = loft_cell_limit(cell_of(c, i), last ? NULL : cell_of(c, i + 1), &c->budget, at, to, z,
                            i == row->first && row->starts, last);
        at = to;
    }
    return z;
}

static void grow(const loft_course *c, const loft_row *row, touched t, loft_unit z)
{
    for (unsigned i = t.low; i <= t.high; i++)
        cell_of(c, i)->b += loft_acc_scale(cell_of(c, i)->rise, z);
    for (unsigned i = t.low; i <= t.high + 1 && i < row->end; i++)
        set_knot(c, row, i);
}

/* Raise the cells around `middle`, up to `width` on both sides. */
static void raise(const loft_course *c, const loft_row *row, unsigned middle, unsigned width)
{
    const bool tied_first = row->starts && row->from == row->first,
               tied_last = row->rests && row->to == row->end;
    const unsigned from = row->from + tied_first, to = row->to - tied_last;
    const unsigned low = middle - from >= width ? middle - width : from,
                   high = to - 1 - middle >= width ? middle + width : to - 1;
    const loft_acc left = reach_of(c, middle, low, low == from,
                                   tied_first ? length_of(c, from - 1) : 0);
    const loft_acc right = reach_of(c, middle, high, high == to - 1,
                                    tied_last ? length_of(c, to) : 0);
    touched t = { low > row->first ? low - 1 : low, high + 1 < row->end ? high + 1 : high };
    loft_acc rise = loft_acc_min(cell_of(c, middle)->top - cell_of(c, middle)->b,
                                 4 * cell_of(c, middle)->b);

    for (unsigned i = t.low > row->first ? t.low - 1 : t.low; i <= t.high + 1 && i < row->end; i++)
        cell_of(c, i)->rise = 0;
    (void)put(c, middle, LOFT_UNIT(1), rise, &rise);
    rise = put_side(c, middle, low, left, rise);
    rise = put_side(c, middle, high, right, rise);
    if (!(rise > 0))
        return;
    for (unsigned i = low; i <= high; i++)
        cell_of(c, i)->rise = loft_acc_scale(rise, loft_unit_round(cell_of(c, i)->rise));
    if (tied_first && low == from)
        cell_of(c, row->first)->rise = tied(c, row->first, row->first + 1, cell_of(c, from)->rise);
    if (tied_last && high == to - 1)
        cell_of(c, row->end - 1)->rise = tied(c, row->end - 1, row->end - 2,
                                              cell_of(c, to - 1)->rise);
    const loft_unit z = allowed(c, row, t);
    if (z > 0)
        grow(c, row, t, z / 2);
}

static loft_acc gentle(loft_real accel, loft_real s, loft_acc d)
{
    const loft_acc  v = loft_acc_mul(d, s);
    const loft_real turn = loft_real_cap(LOFT_SPEED_MAX, accel / 2, s);

    return v < loft_to_acc(turn) ? loft_prod(loft_acc_round(v), loft_acc_round(v))
                                 : loft_acc_mul(d, accel) - loft_prod(turn, turn);
}

/* How far the pieces may be raised. */
static void set_tops(const loft_course *c, const loft_row *row)
{
    const loft_budget *b = &c->budget;
    const loft_real accel = loft_real_min(b->accel);
    /* gain <= accel: at most 50000 */
    const loft_acc  rate = loft_acc_div(loft_to_acc(loft_real_min(b->gain)), accel) * b->tick_hz;
    const loft_real s = loft_acc_round(loft_acc_ratio(rate, EASY * b->beat)) + LOFT_REAL_LSB;
    loft_acc d = 0;

    for (unsigned i = row->to; i-- > row->from; ) {
        loft_plan_cell *p = cell_of(c, i);
        d += length_of(c, i) / 2;
        const loft_acc x = row->rests
                               ? p->most
                               : gentle(accel, s, loft_acc_min(d, loft_to_acc(LOFT_PLAN_REACH)));
        p->top = x < p->b ? p->b : loft_acc_min(x, p->most);
        d += length_of(c, i) / 2;
    }
}

/* Double all control values, if all limits allow that. */
static bool doubled(const loft_course *c, const loft_row *row)
{
    const touched all = { row->first, row->end - 1 };

    for (unsigned i = row->first; i < row->end; i++) {
        if (cell_of(c, i)->b * 2 > cell_of(c, i)->top)
            return false;
        cell_of(c, i)->rise = cell_of(c, i)->b;
    }
    if (allowed(c, row, all) < LOFT_UNIT(1))
        return false;
    grow(c, row, all, LOFT_UNIT(1));
    return true;
}

static void halve(const loft_course *c, const loft_row *row)
{
    for (unsigned i = row->first; i < row->end; i++) {
        cell_of(c, i)->b /= 2;
        set_knot(c, row, i);
    }
}

/* All of a row that creeps. */
static void lift(const loft_course *c, const loft_row *row)
{
    int n = 0;

    while (doubled(c, row))
        n++;
    for (int k = 0; k < BACK && k < n; k++)
        halve(c, row);
}

/* About the time that the pieces take, s. */
static loft_acc time_of(const loft_course *c, const loft_row *row)
{
    loft_acc t = 0;
    for (unsigned i = row->from; i < row->to; i++)
        t += loft_acc_scale(length_of(c, i), cell_of(c, i)->r);
    return t;
}

void loft_raise(const loft_course *c, const loft_row *row, int sweeps)
{
    set_tops(c, row);
    const unsigned from = row->from + (row->starts && row->from == row->first),
                   to = row->to - (row->rests && row->to == row->end);

    if (row->starts && row->rests && row->from == row->first &&
        !(cell_of(c, from)->b > LOFT_RAISE_CREEP))
        lift(c, row);
    loft_acc before = time_of(c, row), gain = before;

    for (int n = 0; n < sweeps && gain > before / ENOUGH; n++) {
        for (unsigned width = WIDEST; width > 0; width /= 2)
            for (unsigned step = width > 1 ? width / 2 : 1, i = from + (unsigned)n * 3 % step;
                 i < to; i += step)
                raise(c, row, i, width);
        const loft_acc after = time_of(c, row);
        gain = before - after;
        before = after;
    }
}

#endif
