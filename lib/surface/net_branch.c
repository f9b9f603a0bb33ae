/* lib/surface/net_branch.c
 * SPDX-License-Identifier: MIT
 *
 * A branch is followed by steps of the parameter that changes most; the other three follow by
 * Newton's method. With J_k the derivatives of a - b, it runs along (-1)^k det J without column k.
 * A step is halved until the place in its middle is within tol / 2 of the chord, and the chord
 * within 1/3 of the directions at both ends. Where a parameter leaves 0..1, it is put on the border
 * and the others follow. Through a place where the surfaces are tangent the branch goes on as
 * straight as it came: the direction there changes its sign. It ends where steps of tol / 16 fail.
 */
#include "surface/net_branch.h"

#include "geom/chord.h"         /* loft_chord_foot */
#include "surface/net_cell.h"   /* loft_sci_solve3 */

#if LOFT_AXES >= 3

#define ROUNDS 24

static loft_sci distance_of(const loft_sci a[3], const loft_sci b[3])
{
    loft_sci d[3];

    for (int axis = 0; axis < 3; axis++)
        d[axis] = loft_sci_sub(a[axis], b[axis]);
    return loft_sci_sqrt(loft_sci_dot3(d, d));
}

/* b - a at s->x, and the derivatives of a - b. */
void loft_net_look(const loft_net_both *z, loft_net_place *s, loft_sci apart[3])
{
    loft_sci jet[2][LOFT_NET_JET][LOFT_AXES];

    for (int k = 0; k < 2; k++)
        loft_net_form_jet(&z->form[k], 1, s->x[2 * k], s->x[2 * k + 1], jet[k]);
    for (int axis = 0; axis < 3; axis++) {
        s->p[axis] = jet[0][LOFT_NET_POINT][axis];
        apart[axis] = loft_sci_sub(jet[1][LOFT_NET_POINT][axis], s->p[axis]);
        for (int d = 0; d < 2; d++) {
            s->column[d][axis] = jet[0][LOFT_NET_BY_X + d][axis];
            s->column[2 + d][axis] = loft_sci_neg(jet[1][LOFT_NET_BY_X + d][axis]);
        }
    }
}

/* Newton's method from s->x, with the parameter `held` fixed. */
bool loft_net_settle(const loft_net_both *z, unsigned held, loft_net_place *s)
{
    const loft_sci least = loft_sci_power2(-40), far = loft_sci_power2(1);
    bool close = false;

    for (int round = 0; round < ROUNDS; round++) {
        loft_sci apart[3], column[3][3], by[3];
        loft_net_look(z, s, apart);
        if (close)
            return true;
        for (unsigned k = 0, i = 0; k < 4; k++)
            for (int axis = 0; axis < 3 && k != held; axis++) {
                column[i][axis] = s->column[k][axis];
                i += axis == 2;
            }
        if (!loft_sci_solve3(column, apart, by))
            return false;
        close = true;
        for (unsigned k = 0, i = 0; k < 4; k++) {
            if (k == held)
                continue;
            s->x[k] = loft_sci_add(s->x[k], by[i]);
            if (loft_sci_less(far, loft_sci_abs(s->x[k])))
                return false;
            close = close && loft_sci_less(loft_sci_abs(by[i]), least);
            i++;
        }
    }
    return false;
}

/* How far a parameter is beyond 0..1; 0 within. */
static loft_sci beyond(loft_sci x)
{
    const loft_sci over = loft_sci_sub(x, loft_sci_one()), slack = loft_sci_power2(-30);

    return loft_sci_less(x, loft_sci_neg(slack)) ? loft_sci_neg(x)
           : loft_sci_less(slack, over)          ? over
                                                 : loft_sci_zero();
}

bool loft_net_within(const loft_net_both *z, const loft_net_place *s)
{
    for (unsigned k = 0; k < 4; k++)
        if (loft_sci_sign(beyond(s->x[k])) > 0 && !(z->curve && k == 1))
            return false;
    return true;
}

bool loft_net_place_vec(const loft_net_both *z, const loft_sci p[3], loft_vec *out)
{
    *out = z->origin;
    for (int axis = 0; axis < 3; axis++) {
        loft_acc x;
        if (!loft_sci_to_acc(p[axis], &x) || !loft_acc_valid(x + loft_to_acc(z->origin.axis[axis])))
            return false;
        out->axis[axis] = loft_acc_round(x + loft_to_acc(z->origin.axis[axis]));
    }
    return true;
}

bool loft_net_chord_near(const loft_vec *a, const loft_vec *b, const loft_vec *p, loft_acc tol)
{
    loft_acc w[LOFT_AXES], r[LOFT_AXES];
    loft_chord c;

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_acc from = loft_to_acc(a->axis[axis]), to = loft_to_acc(b->axis[axis]),
                       at = loft_to_acc(p->axis[axis]);
        if ((at < from - tol && at < to - tol) || (at > from + tol && at > to + tol))
            return false;
        c.u[axis] = to - from;
        w[axis] = at - from;
    }
    loft_chord_aim(&c);
    (void)loft_chord_foot(&c, w, r);
    return loft_acc_hypot(r, LOFT_AXES) <= tol;
}


// Branches
// --------

/* The step of each parameter along the branch, the largest 1; *held is that one. False where the
 * surfaces are tangent. */
static bool direction_at(const loft_net_place *s, loft_sci k[4], unsigned *held)
{
    loft_sci most = loft_sci_zero();

    for (unsigned i = 0; i < 4; i++) {
        const loft_sci *p = s->column[i < 1 ? 1 : 0], *q = s->column[i < 2 ? 2 : 1],
                       *r = s->column[i < 3 ? 3 : 2];
        loft_sci n[3];
        loft_sci_cross3(q, r, n);
        k[i] = i % 2 ? loft_sci_neg(loft_sci_dot3(p, n)) : loft_sci_dot3(p, n);
        if (loft_sci_less(most, loft_sci_abs(k[i]))) {
            most = loft_sci_abs(k[i]);
            *held = i;
        }
    }
    for (unsigned i = 0; i < 4 && loft_sci_sign(most) > 0; i++)
        k[i] = loft_sci_div(k[i], most);
    return loft_sci_sign(most) > 0;
}

/* The velocity of the point for these steps of the parameters. */
static void velocity_of(const loft_net_place *s, const loft_sci k[4], loft_sci out[3])
{
    for (int axis = 0; axis < 3; axis++)
        out[axis] = loft_sci_add(loft_sci_mul(k[0], s->column[0][axis]),
                                 loft_sci_mul(k[1], s->column[1][axis]));
}

/* True if two directions are within a third of a radian. */
static bool are_aligned(const loft_sci a[3], const loft_sci b[3])
{
    const loft_sci cosine = loft_sci_from_unit(LOFT_UNIT(0.94));
    const loft_sci size = loft_sci_mul(loft_sci_sqrt(loft_sci_dot3(a, a)),
                                       loft_sci_sqrt(loft_sci_dot3(b, b)));
    return !loft_sci_less(loft_sci_dot3(a, b), loft_sci_mul(size, cosine));
}

static bool step_by(const loft_net_both *z, const loft_net_place *s, const loft_sci k[4],
                    unsigned held, loft_sci by, loft_net_place *to)
{
    for (unsigned i = 0; i < 4; i++)
        to->x[i] = loft_sci_add(s->x[i], loft_sci_mul(k[i], by));
    return loft_net_settle(z, held, to);
}

/* True if the step from s to `to` is within the tolerance. */
static bool is_step_good(const loft_net_both *z, const loft_net_place *s, const loft_sci k[4],
                         unsigned held, loft_sci by, const loft_net_place *to)
{
    const loft_sci half = loft_sci_power2(-1);
    loft_sci chord[3], velocity[3], here[4], middle[3];
    unsigned other;
    loft_net_place mid;

    if (!step_by(z, s, k, held, loft_sci_mul(by, half), &mid))
        return false;
    for (int axis = 0; axis < 3; axis++) {
        chord[axis] = loft_sci_sub(to->p[axis], s->p[axis]);
        middle[axis] = loft_sci_mul(loft_sci_add(to->p[axis], s->p[axis]), half);
    }
    velocity_of(s, k, velocity);
    if (!are_aligned(velocity, chord) ||
        loft_sci_less(loft_sci_mul(z->wide, half), distance_of(middle, mid.p)))
        return false;
    if (!direction_at(to, here, &other))
        return true;
    velocity_of(to, here, velocity);
    if (loft_sci_sign(loft_sci_dot3(velocity, chord)) < 0)
        for (int axis = 0; axis < 3; axis++)
            velocity[axis] = loft_sci_neg(velocity[axis]);
    return are_aligned(velocity, chord);
}

/* Put the parameter that is most beyond the border on it, until all are within. */
static bool stop_at_border(const loft_net_both *z, const loft_net_place *from, loft_net_place *to)
{
    const loft_sci one = loft_sci_one(), zero = loft_sci_zero();

    for (int tries = 0; tries < 4 && !loft_net_within(z, to); tries++) {
        loft_sci most = zero;
        unsigned held = 0;
        for (unsigned k = 0; k < 4; k++) {
            const loft_sci way = loft_sci_abs(loft_sci_sub(to->x[k], from->x[k]));
            if (loft_sci_sign(beyond(to->x[k])) == 0 || loft_sci_sign(way) == 0)
                continue;
            const loft_sci part = loft_sci_div(beyond(to->x[k]), way);
            if (loft_sci_less(most, part)) {
                most = part;
                held = k;
            }
        }
        const loft_sci border = loft_sci_sign(to->x[held]) < 0 ? zero : one;
        for (unsigned k = 0; k < 4; k++)
            to->x[k] = loft_sci_lerp(to->x[k], from->x[k], most);
        to->x[held] = border;
        if (!loft_net_settle(z, held, to))
            return false;
    }
    return loft_net_within(z, to);
}

/* One step on from *s, along `ahead`, which it sets. */
static enum loft_net_went step_on(const loft_net_both *z, loft_net_place *s, loft_sci ahead[3],
                                  loft_sci *by)
{
    const loft_sci half = loft_sci_power2(-1), least = loft_sci_mul(z->wide, loft_sci_power2(-4));
    const loft_net_place from = *s;
    loft_sci k[4], velocity[3];
    unsigned held;

    if (!direction_at(s, k, &held))
        return LOFT_NET_LOST;
    velocity_of(s, k, velocity);
    if (loft_sci_sign(loft_sci_dot3(velocity, ahead)) < 0)
        for (int i = 0; i < 4; i++)
            k[i] = loft_sci_neg(k[i]);
    const loft_sci speed = loft_sci_sqrt(loft_sci_dot3(velocity, velocity));
    while (!step_by(z, &from, k, held, *by, s) || !is_step_good(z, &from, k, held, *by, s)) {
        *by = loft_sci_mul(*by, half);
        if (loft_sci_less(loft_sci_mul(*by, speed), least)) {
            *s = from;
            return LOFT_NET_LOST;
        }
    }
    if (!loft_net_within(z, s))
        return stop_at_border(z, &from, s) ? LOFT_NET_BORDER : LOFT_NET_LOST;
    for (int axis = 0; axis < 3; axis++)
        ahead[axis] = loft_sci_sub(s->p[axis], from.p[axis]);
    if (loft_sci_less(*by, loft_sci_power2(-4)))
        *by = loft_sci_mul(*by, loft_sci_from_int(2));
    return LOFT_NET_ON;
}

/* True if the step from a to b passed the place where the branch began. */
static bool is_back(const loft_net_both *z, const loft_net_place *a, const loft_net_place *b,
                    const loft_net_place *start)
{
    loft_vec p, q, r;

    for (unsigned k = 0; k < 4; k++) {
        const loft_sci way = loft_sci_abs(loft_sci_sub(b->x[k], a->x[k]));
        const loft_sci off = loft_sci_abs(loft_sci_sub(start->x[k], a->x[k]));
        const loft_sci wide = loft_sci_add(way, loft_sci_power2(-6));
        if (loft_sci_less(wide, off))
            return false;
    }
    return loft_net_place_vec(z, a->p, &p) && loft_net_place_vec(z, b->p, &q) &&
           loft_net_place_vec(z, start->p, &r) && loft_net_chord_near(&p, &q, &r, z->tol);
}

bool loft_net_branch_init(loft_net_branch *b, const loft_net_place *through)
{
    loft_sci k[4];
    unsigned held;

    b->at = b->start = *through;
    b->by = loft_sci_power2(-5);
    b->steps = 0;
    if (!direction_at(&b->at, k, &held))
        return false;
    velocity_of(&b->at, k, b->ahead);
    return true;
}

void loft_net_branch_turn(loft_net_branch *b)
{
    b->start = b->at;
    b->by = loft_sci_power2(-5);
    b->steps = 0;
    for (int axis = 0; axis < 3; axis++)
        b->ahead[axis] = loft_sci_neg(b->ahead[axis]);
}

enum loft_net_went loft_net_branch_next(loft_net_branch *b, const loft_net_both *z)
{
    const loft_net_place before = b->at;
    const enum loft_net_went went = step_on(z, &b->at, b->ahead, &b->by);

    if (b->steps++ < 2 || went != LOFT_NET_ON || !is_back(z, &before, &b->at, &b->start))
        return went;
    b->at = b->start;
    return LOFT_NET_BACK;
}

#endif
