/* lib/toolpath/pencil.c
 * SPDX-License-Identifier: MIT
 *
 * Where a ball touches two sheets, or one twice, its centre moves along both surfaces of centres:
 * at a right angle to both radii that lead to the contacts, so along their vector product. A step
 * ahead the ball is looked at to both sides of that way. There it touches different flanks, and
 * the place between them where the contact jumps is found by halving.
 */
#include "toolpath/pencil.h"

#define STEPS 8                 /* halvings of a step before a valley is over */

static const unsigned upright = LOFT_AXES > 2 ? 2 : 0;
static const unsigned across = LOFT_AXES > 1 ? 1 : 0;

enum loft_status loft_pencil_init(loft_pencil *p, const loft_drop *d, const loft_box *area)
{
    const loft_real fine = d->tol / 16, least = loft_drop_tol();

    if (LOFT_AXES < 3 || !loft_drop_takes(area) || d->cutter.corner < d->cutter.radius)
        return LOFT_ERR_ARG;
    p->d = *d;
    p->d.tol = fine > least ? fine : least;
    p->area = *area;
    p->least = d->tol / 2;
    p->most = d->cutter.radius / 2;
    p->apart = d->cutter.radius / 2;
    p->points = 0;
    p->over = true;
    return LOFT_OK;
}

bool loft_pencil_touch(const loft_pencil *p, loft_real x, loft_real y, loft_touch *out)
{
    loft_drop_spot spot = { 0, 0, 0 };
    loft_vec tip = { { 0 } };

    tip.axis[0] = x;
    tip.axis[across] = y;
    tip.axis[upright] = loft_drop_height(&p->d, x, y, &spot);
    out->tip = tip;
    const loft_surface *s = &p->d.sheet[spot.sheet].surface;
    return tip.axis[upright] > p->d.floor + 2 * p->d.tol &&
           s->eval(s->surface, spot.u, spot.v, &out->contact) == LOFT_OK;
}

static loft_acc distance_of(const loft_vec *a, const loft_vec *b)
{
    loft_acc by[3];

    for (int k = 0; k < 3; k++)
        by[k] = loft_to_acc(loft_vec_axis(a, k)) - loft_to_acc(loft_vec_axis(b, k));
    return loft_acc_hypot(by, 3);
}

bool loft_pencil_apart(const loft_pencil *p, const loft_touch *a, const loft_touch *b)
{
    return distance_of(&a->contact, &b->contact) > loft_to_acc(p->apart);
}

/* Halve the way between two touches to where the contact jumps. */
static bool narrow(const loft_pencil *p, loft_touch *a, loft_touch *b)
{
    while (loft_pencil_apart(p, a, b)) {
        const loft_real x = loft_vec_axis(&a->tip, 0), y = loft_vec_axis(&a->tip, 1),
                        u = loft_vec_axis(&b->tip, 0), v = loft_vec_axis(&b->tip, 1);
        loft_touch middle;
        if (loft_real_abs(u - x) + loft_real_abs(v - y) <= p->least)
            return true;
        if (!loft_pencil_touch(p, x / 2 + u / 2, y / 2 + v / 2, &middle))
            return false;
        *(distance_of(&middle.contact, &a->contact) < distance_of(&middle.contact, &b->contact)
              ? a
              : b) = middle;
    }
    return false;
}

/* The direction at a right angle to both radii, seen from above; false if there is none. */
static bool find_heading(const loft_pencil *p, const loft_touch *a, const loft_touch *b,
                         loft_real out[2])
{
    loft_real r[2][3];

    for (int k = 0; k < 3; k++) {
        const loft_real more = k == 2 ? p->d.cutter.radius : 0;
        r[0][k] = loft_vec_axis(&a->tip, k) + more - loft_vec_axis(&a->contact, k);
        r[1][k] = loft_vec_axis(&a->tip, k) + more - loft_vec_axis(&b->contact, k);
    }
    const loft_acc x = loft_prod(r[0][1], r[1][2]) - loft_prod(r[0][2], r[1][1]),
                   y = loft_prod(r[0][2], r[1][0]) - loft_prod(r[0][0], r[1][2]), of[2] = { x, y },
                   length = loft_acc_hypot(of, 2);
    if (!(length > loft_prod(p->least, p->least)))
        return false;
    for (int k = 0; k < 2; k++) {
        const loft_real share = loft_acc_quot(loft_acc_abs(of[k]), length);
        out[k] = of[k] < 0 ? -share : share;
    }
    return true;
}

/* The higher one of two places that are near: there the ball cuts neither flank. */
static void settle(loft_pencil *p, const loft_touch *a, const loft_touch *b)
{
    p->from = loft_vec_axis(&a->tip, 2) > loft_vec_axis(&b->tip, 2) ? a->tip : b->tip;
    p->contact[0] = a->contact;
    p->contact[1] = b->contact;
}

enum loft_status loft_pencil_begin(loft_pencil *p, const loft_touch *a, const loft_touch *b,
                                   bool back)
{
    loft_touch left = *a, right = *b;

    if (LOFT_AXES < 3 || !narrow(p, &left, &right) || !find_heading(p, &left, &right, p->heading))
        return LOFT_SINGULAR;
    if (back)
        for (int k = 0; k < 2; k++)
            p->heading[k] = -p->heading[k];
    const loft_acc turn =
        loft_prod(loft_vec_axis(&a->tip, 1) - loft_vec_axis(&b->tip, 1), p->heading[0]) -
        loft_prod(loft_vec_axis(&a->tip, 0) - loft_vec_axis(&b->tip, 0), p->heading[1]);
    if (turn < 0)
        settle(p, &right, &left);
    else
        settle(p, &left, &right);
    p->start = p->from;
    p->step = p->most;
    p->points = 1;
    p->over = false;
    return LOFT_OK;
}

static bool lies_inside(const loft_pencil *p, loft_real x, loft_real y)
{
    return x >= loft_vec_axis(&p->area.min, 0) && x <= loft_vec_axis(&p->area.max, 0) &&
           y >= loft_vec_axis(&p->area.min, 1) && y <= loft_vec_axis(&p->area.max, 1);
}

/* What the ball touches a step ahead, as far to one side. */
static bool touch_beside(const loft_pencil *p, loft_real side, loft_touch *out)
{
    const loft_real x = loft_vec_axis(&p->from, 0) + loft_mul(p->heading[0], p->step) -
                        loft_mul(p->heading[1], side),
                    y = loft_vec_axis(&p->from, 1) + loft_mul(p->heading[1], p->step) +
                        loft_mul(p->heading[0], side);

    return lies_inside(p, x, y) && loft_pencil_touch(p, x, y, out);
}

/* Try a step: what is touched to both sides follows from what was touched before. */
static bool go_on(loft_pencil *p)
{
    loft_touch left, right;
    loft_real heading[2];

    if (!touch_beside(p, p->step / 2, &left) || !touch_beside(p, -p->step / 2, &right) ||
        !narrow(p, &left, &right) || !find_heading(p, &left, &right, heading))
        return false;
    const loft_acc far = 4 * loft_to_acc(p->step);
    if (distance_of(&left.contact, &p->contact[0]) > far ||
        distance_of(&right.contact, &p->contact[1]) > far)
        return false;
    const loft_acc along = loft_prod(heading[0], p->heading[0]) +
                           loft_prod(heading[1], p->heading[1]);
    for (int k = 0; k < 2; k++)
        p->heading[k] = along < 0 ? -heading[k] : heading[k];
    settle(p, &left, &right);
    return true;
}

bool loft_pencil_next(loft_pencil *p, loft_vec *out)
{
    const loft_vec last = p->from;

    for (unsigned k = 0; k < STEPS && !p->over; k++) {
        if (go_on(p)) {
            const loft_acc gone = distance_of(&p->from, &last);
            p->over = ++p->points >= LOFT_PENCIL_MOST ||
                      (p->points > 4 && distance_of(&p->from, &p->start) < gone);
            p->step = p->step < p->most / 2 ? 2 * p->step : p->most;
            *out = p->from;
            return true;
        }
        p->step /= 2;
    }
    p->over = true;
    return false;
}
