/* lib/surface/net_meet.c
 * SPDX-License-Identifier: MIT
 *
 * Cells, parts of both surfaces, are halved until net_cell.h decides them. In a cell where the
 * surfaces meet at most once for each value of a free parameter f, the places at the ends and the
 * middle of the sure values of f are found by Newton's method. Where one is not within tol of a
 * branch that is known, its branch is followed, to both ends. If they all are, and the cell's other
 * values of f move the place by less than tol, nothing is left to do. So each branch is followed
 * once, and none is missed, whether or not it reaches a border.
 *
 * Where a branch runs along a border of a surface, or along a cut of the cells, it is in the cell
 * for no value of f for sure. The places of a cell are near a line: if they stray from it by less
 * than tol / 4, and those at both ends of f and in the middle are in the cell, all others are
 * within tol of the branch through them.
 *
 * What is left at the size of tol is a touch, unless a branch runs by.
 */
#include "surface/net_meet.h"

#include "surface/net_branch.h"
#include "surface/net_cell.h"

static loft_net curve_of(const loft_vec p[], const loft_weighted weighted[], uint8_t degree)
{
    const loft_net s = { p, weighted, degree, 0, false };
    return s;
}

loft_net loft_net_from_bezier(const loft_bezier *b) { return curve_of(b->p, NULL, b->degree); }

loft_net loft_net_from_rational(const loft_rational *r) { return curve_of(NULL, r->p, r->degree); }

#if LOFT_AXES >= 3

#define STEPS 16384             /* of one branch */

typedef struct {
    loft_net_both both;
    bool full;
    loft_net_meeting *out;
    unsigned room, *count;
} search;


// What is known
// -------------

static bool is_known(const search *z, const loft_vec *p, loft_acc tol)
{
    for (unsigned k = 0; k < *z->count; k++) {
        const loft_net_meeting *m = &z->out[k];
        if (!m->touch &&
            loft_net_chord_near(&z->out[m->start ? k : k - 1].point, &m->point, p, tol))
            return true;
    }
    return false;
}

static void add_place(search *z, const loft_net_place *s, bool start, bool touch)
{
    loft_net_meeting m = { .start = start, .touch = touch };

    if (*z->count == z->room || !loft_net_place_vec(&z->both, s->p, &m.point)) {
        z->full = true;
        return;
    }
    for (int k = 0; k < 2; k++) {
        loft_sci x[2];
        for (int d = 0; d < 2; d++) {
            x[d] = s->x[2 * k + d];
            x[d] = loft_sci_sign(x[d]) < 0                    ? loft_sci_zero()
                   : loft_sci_less(loft_sci_one(), x[d]) ? loft_sci_one()
                                                         : x[d];
        }
        loft_net_form_place(&z->both.form[k], x[0], x[1], &m.at[2 * k]);
    }
    z->out[(*z->count)++] = m;
}

/* To the end of a branch; true if it is closed. */
static bool follow(search *z, loft_net_branch *b, bool record)
{
    for (unsigned step = 0; step < STEPS && !z->full; step++) {
        const enum loft_net_went went = loft_net_branch_next(b, &z->both);
        if (record && went != LOFT_NET_LOST)
            add_place(z, &b->at, false, false);
        if (went != LOFT_NET_ON)
            return went == LOFT_NET_BACK;
    }
    z->full = true;
    return false;
}

/* The whole branch through a place: back to its start, then to its end. */
static void trace(search *z, const loft_net_place *through)
{
    loft_net_branch b;

    if (z->both.curve || !loft_net_branch_init(&b, through)) {
        add_place(z, through, true, false);
        return;
    }
    (void)follow(z, &b, false);
    loft_net_branch_turn(&b);
    add_place(z, &b.at, true, false);
    (void)follow(z, &b, true);
}


// Cells
// -----

static void place_in(const loft_dyad_box *pair, const loft_net_cell *cell, loft_sci f,
                     loft_net_place *s)
{
    for (unsigned k = 0; k < 4; k++)
        s->x[k] = loft_dyad_place(pair->n[k],
                                  loft_sci_add(cell->start[k], loft_sci_mul(cell->slope[k], f)));
}

/* True if the place for f is within the cell. */
static bool place_at(const search *z, const loft_dyad_box *pair, const loft_net_cell *cell,
                     loft_sci f, loft_net_place *s)
{
    const loft_sci slack = loft_sci_power2(-20);

    place_in(pair, cell, f, s);
    if (!loft_net_settle(&z->both, cell->loose, s) || !loft_net_within(&z->both, s))
        return false;
    for (unsigned k = 0; k < 4; k++) {
        const loft_sci from = loft_dyad_place(pair->n[k], loft_sci_neg(slack)),
                       to = loft_dyad_place(pair->n[k], loft_sci_add(loft_sci_one(), slack));
        if (loft_sci_less(s->x[k], from) || loft_sci_less(to, s->x[k]))
            return false;
    }
    return true;
}

static void follow_from(search *z, const loft_net_place *s)
{
    loft_vec p;

    if (!loft_net_place_vec(&z->both, s->p, &p) || (!is_known(z, &p, z->both.tol) && !z->full))
        trace(z, s);
}

/* Follow the branch through the places at from, to, and in between; false if one is not there. */
static bool follow_three(search *z, const loft_dyad_box *pair, const loft_net_cell *cell,
                         loft_sci from, loft_sci to)
{
    const loft_sci half = loft_sci_power2(-1);
    loft_net_place s[3];

    for (int k = 0; k < 3; k++)
        if (!place_at(z, pair, cell,
                      loft_sci_lerp(from, to, loft_sci_mul(loft_sci_from_int(k), half)), &s[k]))
            return false;
    for (int k = 0; k < 3; k++)
        follow_from(z, &s[k]);
    return true;
}

/* True if nothing is left to do in a cell where they meet once for each f. */
static bool is_once_done(search *z, const loft_dyad_box *pair, const loft_net_cell *cell)
{
    const loft_sci half = loft_sci_power2(-1), two = loft_sci_from_int(2);
    const bool sure = !loft_sci_less(cell->sure_to, cell->sure_from);
    loft_sci unsure = loft_sci_sub(cell->to, cell->from);
    loft_net_place s;

    if (z->both.curve) {
        if (!place_at(z, pair, cell, half, &s))
            return false;
        follow_from(z, &s);
        return true;
    }
    const loft_sci four = loft_sci_from_int(4);
    if (!loft_sci_less(z->both.wide, loft_sci_mul(four, cell->spread)) &&
        follow_three(z, pair, cell, cell->from, cell->to))
        return true;
    if (sure) {
        unsure = loft_sci_sub(unsure, loft_sci_sub(cell->sure_to, cell->sure_from));
        if (!follow_three(z, pair, cell, cell->sure_from, cell->sure_to))
            return false;
    } else if (place_at(z, pair, cell, loft_sci_lerp(cell->from, cell->to, half), &s))
        follow_from(z, &s);
    return !loft_sci_less(z->both.wide, loft_sci_mul(two, loft_sci_mul(unsure, cell->speed)));
}

/* Nothing is decided at the size of tol. */
static void add_touch(search *z, const loft_dyad_box *pair)
{
    const loft_sci half = loft_sci_power2(-1);
    loft_sci apart[3];
    loft_vec p;
    loft_net_place s;

    for (unsigned k = 0; k < 4; k++)
        s.x[k] = loft_dyad_place(pair->n[k], half);
    loft_net_look(&z->both, &s, apart);
    if (!loft_net_place_vec(&z->both, s.p, &p) || is_known(z, &p, 2 * z->both.tol))
        return;
    for (unsigned k = 0; k < *z->count; k++)
        if (z->out[k].touch &&
            loft_net_chord_near(&z->out[k].point, &z->out[k].point, &p, 2 * z->both.tol))
            return;
    add_place(z, &s, true, true);
}

/* False if there are too many. */
static bool walk_cells(search *z)
{
    uint32_t left = LOFT_NET_MEET_PARTS;
    loft_dyad_box pair;
    loft_net_cell cell;

    loft_dyad_box_start(&pair);
    do {
        for (;;) {
            const enum loft_net_known known = loft_net_cell_decide(&z->both.form[0],
                                                                   &z->both.form[1], &pair, &cell);
            if (left-- == 0)
                return false;
            if (known == LOFT_NET_APART ||
                (known == LOFT_NET_ONCE && is_once_done(z, &pair, &cell)) || z->full)
                break;
            if (!loft_sci_less(z->both.wide, cell.size) ||
                pair.n[cell.longest].level == LOFT_DYAD_LEVELS) {
                add_touch(z, &pair);
                break;
            }
            loft_dyad_box_halve(&pair, cell.longest);
        }
    } while (!z->full && loft_dyad_box_next(&pair));
    return !z->full;
}

/* Drop touches that a branch runs by which was found later; true if any are left. */
static bool keep_touches(search *z)
{
    unsigned kept = 0;
    bool touches = false;

    for (unsigned k = 0; k < *z->count; k++)            /* without a start: to be dropped */
        if (z->out[k].touch)
            z->out[k].start = !is_known(z, &z->out[k].point, 2 * z->both.tol);
    for (unsigned k = 0; k < *z->count; k++)
        if (z->out[k].start || !z->out[k].touch) {
            touches = touches || z->out[k].touch;
            z->out[kept++] = z->out[k];
        }
    *z->count = kept;
    return touches;
}

static loft_acc largest_coordinate(loft_net s)
{
    const unsigned count = s.triangle ? (s.m + 1u) * (s.m + 2u) / 2 : (s.m + 1u) * (s.n + 1u);
    loft_acc most = 0;

    for (unsigned k = 0; k < count; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const loft_vec *p = s.weighted ? &s.weighted[k].p : &s.p[k];
            const loft_acc x = loft_acc_abs(loft_to_acc(p->axis[axis]));
            most = x > most ? x : most;
        }
    return most;
}

#endif

enum loft_status loft_net_meet(loft_net a, loft_net b, loft_real tol, loft_net_meeting out[],
                               unsigned room, unsigned *count)
{
    *count = 0;
#if LOFT_AXES < 3
    (void)a;
    (void)b;
    (void)tol;
    (void)out;
    (void)room;
    return LOFT_ERR_ARG;
#else
    search z;

    if (!(tol > 0) || b.n == 0 || b.m == 0 || a.m == 0)
        return LOFT_ERR_ARG;
    const loft_acc one = largest_coordinate(a), two = largest_coordinate(b);
    if (!loft_real_valid(tol) || loft_to_acc(tol) < 32 * loft_real_ulp(one > two ? one : two))
        return LOFT_ERR_RANGE;
    z.both.origin = a.weighted ? a.weighted[0].p : a.p[0];
    z.both.tol = loft_to_acc(tol);
    z.both.wide = loft_sci_from_real(tol);
    z.both.curve = a.n == 0;
    z.full = false;
    z.out = out;
    z.room = room;
    z.count = count;
    loft_net_load(a, z.both.origin, &z.both.form[0]);
    loft_net_load(b, z.both.origin, &z.both.form[1]);
    const bool complete = walk_cells(&z);
    const bool touches = keep_touches(&z);
    return !complete ? LOFT_MORE : touches ? LOFT_SINGULAR : LOFT_OK;
#endif
}
