/* lib/motion/cell.c
 * SPDX-License-Identifier: MIT
 *
 * With x = v^2 along the length s, the acceleration along the path is a = x' / 2 and the jerk j = v
 * x'' / 2. On a path with direction u, curvature vector k and its derivative k', the vectors of
 * acceleration and jerk are
 *
 *     u a + k x          v (u x'' / 2 + 3 k a + k' x)
 *
 * x is a quadratic B-spline in s, one cell between two knots, and one control value b per cell.
 * With the lengths l before a knot and h behind it, and the values b0, b1 there
 *
 *     x = (h b0 + l b1) / (l + h)          a = (b1 - b0) / (l + h)
 *
 * and in a cell x'' h / 2 = a1 - a0, the change of acceleration in it. The bracket times h must be
 * within J h / v, which is J times about the time in the cell, so everything that is compared is an
 * acceleration. It is asked at both ends.
 *
 * The acceleration of an axis, f = u a + k x, has f'' = 4 k a' + 5 k' a + k'' x, so between the
 * ends it is at most
 *
 *     (4 |k| h |a1 - a0| + 5 |k'| h |a| h + |k''| h^2 x) / 8
 *
 * above the larger of both. Where that may be more than BOW of the limit the middle is asked as
 * well, which leaves a quarter of it.
 *
 * At rest x = 0 and the jerk is constant: x = x1 (s / h)^(4/3), which gives a1 = 2/3 x1 / h, x1'' h
 * / 2 = 2/9 x1 / h, and b0 = b1 h0 / (3 h0 + 2 h1). An axis has a jerk of j (u + 9 k s + 9/2 k'
 * s^2) then, which bows by 27/8 |k1 - k0| h j: so near a rest the middle is always asked as well.
 *
 * A bump raises b by z P, so x, a and the brackets g become x + z X, a + z A, g + z G.
 * Accelerations are linear in z. J h / sqrt x is convex in x, so that it lies above its tangent,
 * and
 *
 *     |g + z G| <= (J h / v) (1 - z X / (2 x))
 *
 * is enough, which is linear too: each is one comparison, and a division where it is the least one.
 */
#include "motion/cell.h"

#define MOST_BEATS  1024        /* times J h: more than any change of acceleration */
/* part of the square of the speed that is left for what it is between beats */
#define BETWEEN     400
#define BOW         256         /* 1/256 of the acceleration may be exceeded between the ends */


loft_inverse loft_inverse_of(loft_acc length)
{
    loft_inverse by = { 0, 0 };
    if (length < loft_to_acc(LOFT_REAL(0.015625)))
        by.coarse = length > loft_acc_div(loft_to_acc(LOFT_REAL(1)), LOFT_REAL_MAX / 2)
                        ? loft_acc_quot(loft_to_acc(LOFT_REAL(1)), length)
                        : LOFT_REAL_MAX / 2;
    else
        by.fine = loft_unit_round(loft_acc_div(loft_to_acc(LOFT_REAL(1)), loft_acc_round(length)));
    return by;
}

loft_acc loft_inverse_mul(loft_acc x, const loft_inverse *by)
{
    return by->coarse > 0 ? loft_acc_mul(x, by->coarse) : loft_acc_scale(x, by->fine);
}

static loft_vec difference(loft_vec a, loft_vec b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.axis[i] -= b.axis[i];
    return a;
}

/* x, or accel / bend if that is less */
static loft_acc bend_most(loft_acc x, loft_real accel, loft_real bend)
{
    if (loft_acc_mul(loft_acc_min(x, loft_to_acc(LOFT_REAL(8191))), bend) > loft_to_acc(accel) ||
        loft_acc_mul(x / 32768, bend) > loft_to_acc(accel) / 32768)
        return loft_acc_min(x, loft_acc_div(loft_to_acc(accel), bend));
    return x;
}

/* The largest square of the speed that the feed, the speeds of the axes and the curvature allow at
 * one of three stations. */
static loft_acc station_most(const loft_budget *b, const loft_arc_shape *s, int k, loft_real feed)
{
    loft_real v = feed;
    loft_acc  x;

    for (int i = 0; i < LOFT_AXES; i++)
        v = loft_real_cap(v, b->max_speed[i], loft_real_abs(s->along[k].axis[i]));
    x = loft_prod(v, v);
    if (b->across > 0)
        return bend_most(x, b->across,
                         loft_acc_round(loft_vec_distance(s->bend[k], (loft_vec){ { 0 } })));
    for (int i = 0; i < LOFT_AXES; i++)
        x = bend_most(x, b->accel[i], loft_real_abs(s->bend[k].axis[i]));
    return x;
}

/* Does the derivative of the curvature change so much in it that between its ends it may ask for
 * more of the jerk than there? */
static bool varies(const loft_budget *b, const loft_plan_cell *p)
{
    const loft_real v = loft_acc_sqrt(p->most);
    const loft_inverse by = loft_inverse_of(loft_to_acc(v));
    const loft_acc beats = loft_inverse_mul(p->span, &by);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc change = loft_to_acc(p->turn[1].axis[i]) - loft_to_acc(p->turn[0].axis[i]);
        if (loft_acc_mul(p->most, loft_acc_round(change < 0 ? -change : change)) * 6 >
            loft_acc_mul(beats, b->gain[i]))
            return true;
    }
    return false;
}

/* x / accel, as a part; 1 is enough. */
static loft_unit part_of(loft_acc x, loft_real accel)
{
    return x < loft_to_acc(accel) ? loft_unit_ratio(x, loft_to_acc(accel)) : LOFT_UNIT(1);
}

/* How much more of the acceleration than at its ends may be asked for between them? */
static void set_bow(const loft_budget *b, loft_plan_cell *c)
{
    c->bow = c->bow_change = c->bow_accel = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real k0 = loft_real_abs(c->bend[0].axis[i]),
                        k1 = loft_real_abs(c->bend[1].axis[i]), t0 = c->turn[0].axis[i],
                        t1 = c->turn[1].axis[i];
        const loft_real k = k0 > k1 ? k0 : k1, t = loft_real_abs(t0) > loft_real_abs(t1)
                                                       ? loft_real_abs(t0)
                                                       : loft_real_abs(t1);
        const loft_unit change = part_of(loft_acc_scale(loft_to_acc(k), c->length) / 2,
                                         b->accel[i]);
        const loft_unit accel = part_of(loft_acc_scale(loft_to_acc(t), c->length) * 5 / 8,
                                        b->accel[i]);
        const loft_unit always = part_of(loft_acc_mul(c->most, loft_real_abs(t1 - t0)) / 8,
                                         b->accel[i]);
        c->bow_change = change > c->bow_change ? change : c->bow_change;
        c->bow_accel  = accel > c->bow_accel ? accel : c->bow_accel;
        c->bow        = always > c->bow ? always : c->bow;
    }
    c->bow = varies(b, c) ? LOFT_UNIT(1) : c->bow;
}

void loft_cell_init(loft_plan_cell *c, const loft_budget *b, const loft_arc *arc,
                    const loft_arc_shape *shape, loft_real feed)
{
    loft_arc_shape s = *shape;

    for (int k = 0; k < 3 && s.tight; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            s.bend[k].axis[i] = 0;
    for (int e = 0; e < 2; e++) {
        c->along[e] = s.along[2 * e];
        c->bend[e]  = s.bend[2 * e];
    }
    c->most = loft_prod(feed, feed);
    for (int k = 0; k < 3; k++)
        c->most = loft_acc_min(c->most, station_most(b, &s, k, feed));
    c->most -= c->most / BETWEEN;
    const loft_vec d0 = difference(s.bend[1], s.bend[0]), d1 = difference(s.bend[2], s.bend[1]);
    for (int i = 0; i < LOFT_AXES; i++) {       /* of the parabola through three */
        c->turn[0].axis[i] = 3 * d0.axis[i] - d1.axis[i];
        c->turn[1].axis[i] = 3 * d1.axis[i] - d0.axis[i];
    }
    c->length = loft_unit_round(arc->length);
    c->span   = loft_acc_ratio(loft_unit_to_acc(c->length) * b->tick_hz, b->beat);
    c->gate   = c->most;
    c->grip   = LOFT_UNIT(1);
    c->eased  = 0;
    set_bow(b, c);
}

/* Between its ends the slope turns, or easing begins: what holds there is asked at the ends,
 * too. */
static void set_cases(loft_plan_cell *c, int in, const loft_easing at[2], loft_unit outer,
                      loft_unit inner, bool beyond, loft_acc turn)
{
    const loft_easing p = loft_ease_eval(LOFT_EASE_TURN);
    const bool turns = inner > LOFT_EASE_TURN && outer < LOFT_EASE_TURN;
    const loft_acc sign = in == 1 ? 1 : -1;
    const int out = 1 - in;

    c->eased = 0;
    if (turns) {
        c->bends[0][in]  = loft_unit_round(sign * (p.bend - at[in].bend));
        c->bends[0][out] = loft_unit_round(sign * (p.bend - at[out].bend));
        c->turns[0][in]  = loft_unit_round(-2 * turn);
        c->turns[0][out] = loft_unit_round(2 * turn);
        c->eased = 1;
    }
    if (beyond && (turns || inner < LOFT_EASE_TURN)) {
        c->bends[c->eased][in]  = loft_unit_round(-sign * at[in].bend);
        c->bends[c->eased][out] = 0;
        c->turns[c->eased][in]  = loft_unit_round(turns ? -turn : turn);
        c->turns[c->eased][out] = loft_unit_round(turns ? turn : -turn);
        c->eased++;
    }
}

/* The speed that the direction u allows to an axis. */
static void turn_most(loft_plan_cell *c, const loft_budget *b, int i, loft_acc u)
{
    const loft_real v = loft_real_cap(LOFT_SPEED_MAX, b->max_speed[i],
                                      loft_real_abs(loft_acc_round(u)));
    const loft_acc  x = loft_prod(v, v);
    c->most = loft_acc_min(c->most, x - x / BETWEEN);
}

void loft_cell_ease(loft_plan_cell *c, const loft_budget *b, const loft_ease *e, loft_acc off)
{
    const loft_acc w = loft_unit_to_acc(e->width), h = loft_unit_to_acc(c->length),
                   top = loft_acc_scale(w, LOFT_UNIT(1) - 2 * LOFT_EASE_TURN);
    const loft_inverse by = loft_inverse_of(w);
    const int in = off < 0 ? 1 : 0;
    /* where it turns the direction most, r = 2 p */
    const loft_acc to_top = (in == 1 ? -top : top) - off;
    const loft_easing most = loft_ease_eval(2 * LOFT_EASE_TURN);
    const loft_acc before = c->most;
    loft_acc longest = 0;
    loft_unit r[2];
    loft_easing z[2];
    bool beyond[2];

    if (off >= w || -off - h >= w)
        return;
    for (int end = 0; end < 2; end++) {
        const loft_acc s = end ? off + h : off, d = s < 0 ? -s : s;
        r[end] = d < w ? LOFT_UNIT(1) - loft_unit_ratio(d, w) : 0;
        z[end] = loft_ease_eval(r[end]);
        beyond[end] = !(d < w);
    }
    for (int end = 0; end < 2; end++)       /* within, where the slope turns in it as well */
        z[end].turn = beyond[end] && !(r[in] > LOFT_EASE_TURN) ? 0 : z[end].turn;
    for (int i = 0; i < LOFT_AXES; i++) {
        c->jump.axis[i] = e->jump[i];
        if (to_top > 0 && to_top < h)
            turn_most(c, b, i,
                      loft_acc_lerp(loft_to_acc(c->along[0].axis[i]),
                                    loft_to_acc(c->along[1].axis[i]), loft_unit_ratio(to_top, h)) +
                          loft_acc_scale(loft_acc_mul(most.along, e->jump[i]), e->width));
        for (int end = 0; end < 2; end++) {
            const loft_acc bend = loft_acc_mul(z[end].bend, e->jump[i]),
                           turn = loft_acc_scale(
                               loft_inverse_mul(loft_acc_mul(z[end].turn, e->jump[i]), &by),
                               c->length);
            c->bend[end].axis[i]  += loft_acc_round(in == 1 ? bend : -bend);
            c->turn[end].axis[i]  += loft_acc_round(turn);
            c->along[end].axis[i] += loft_acc_round(
                loft_acc_scale(loft_acc_mul(z[end].along, e->jump[i]), e->width));
            turn_most(c, b, i, loft_to_acc(c->along[end].axis[i]));
        }
    }
    for (int end = 0; end < 2; end++)       /* the path moved aside is longer by that */
        longest = loft_acc_max(longest, loft_vec_dot(c->along[end], c->along[end]));
    if (longest > loft_to_acc(LOFT_REAL(1)))
        c->most = loft_acc_min(
            c->most, loft_acc_scale(before, loft_unit_ratio(loft_to_acc(LOFT_REAL(1)), longest)));
    const loft_acc turn = loft_acc_min(
        loft_acc_scale(loft_inverse_mul(loft_unit_to_acc(LOFT_EASE_SLOPE), &by), c->length),
        loft_to_acc(LOFT_REAL(60)));
    set_cases(c, in, z, r[1 - in], r[in], beyond[1 - in], turn);
    c->bow = c->eased > 0 ? 0 : LOFT_UNIT(1);
    c->bow_change = c->bow_accel = 0;
}


/* Limits
 * ------ */

/* g + z q <= most; a rise that does not add to g is not hindered where rounding has left g above
 * that. */
static loft_unit limit_below(loft_unit z, loft_acc g, loft_acc q, loft_acc most)
{
    const loft_acc room = loft_acc_max(most - g, 0);

    return loft_acc_scale(q, z) > room ? loft_unit_ratio(room, q) : z;
}

/* |g + z q| <= most */
static loft_unit limit(loft_unit z, loft_acc g, loft_acc q, loft_acc most)
{
    return q < 0 ? limit_below(z, -g, -q, most) : limit_below(z, g, q, most);
}

/* |g + z q| <= most - z less */
static loft_unit limit_jerk(loft_unit z, loft_acc g, loft_acc q, loft_acc most, loft_acc less)
{
    return limit_below(limit_below(z, g, q + less, most), -g, less - q, most);
}

/* A place with what is known there: x, a and how they would rise, 1 / v, half the part by which x
 * would grow. */
typedef struct {
    loft_acc x, a;
    loft_cell_rise up;
    loft_acc beats;             /* the cell takes at this speed */
    loft_unit w;
} place;

static place place_of(const loft_plan_cell *c, const loft_plan_cell *at, loft_cell_rise up)
{
    place p = {
        at->x, at->a, up,
        loft_acc_min(loft_acc_scale(c->span, at->r), loft_to_acc(LOFT_REAL(1)) * MOST_BEATS), 0
    };

    /* a part is left for what is not asked between the ends */
    p.beats = loft_acc_scale(p.beats - p.beats / 24, c->grip);
    p.w = loft_unit_round(loft_acc_scale(loft_acc_scale(up.x, at->r), at->r) / 2);
    return p;
}

#define AS_IT_IS (-1)

/* Where jerk is limited by the changes `change`, `up` of the acceleration along the path in the
 * cell; in a case of easing, or as it is; `slack` more of the acceleration may be used. */
static loft_unit limit_end(const loft_plan_cell *c, const loft_budget *b, const place *p, int end,
                           loft_acc change, loft_acc up, loft_unit z, int eased, loft_unit slack)
{
    const loft_real length = loft_acc_round(loft_unit_to_acc(c->length));

    for (int i = 0; i < LOFT_AXES && z > 0; i++) {
        const loft_real u = c->along[end].axis[i], jump = c->jump.axis[i];
        const loft_real k =
            c->bend[end].axis[i] +
            (eased >= 0 ? loft_acc_round(loft_acc_scale(loft_to_acc(jump), c->bends[eased][end]))
                        : 0);
        const loft_real turn =
            c->turn[end].axis[i] +
            (eased >= 0 ? loft_acc_round(loft_acc_scale(loft_to_acc(jump), c->turns[eased][end]))
                        : 0);
        if (!(u < 0 || u > 0 || k < 0 || k > 0 || turn < 0 || turn > 0))
            continue;
        const loft_acc  accel = loft_to_acc(b->accel[i]);
        const loft_unit kh = loft_unit_round(loft_prod(k, length) * 3);
        const loft_acc  most = loft_acc_mul(p->beats, b->gain[i]);
        const loft_real across = b->across > 0 ? 0 : k;         /* it has a limit of its own */
        z = limit(z, loft_acc_mul(p->a, u) + loft_acc_mul(p->x, across),
                  loft_acc_mul(p->up.a, u) + loft_acc_mul(p->up.x, across),
                  accel + loft_acc_scale(accel, slack));
        z = limit_jerk(
            z, loft_acc_mul(change, u) + loft_acc_scale(p->a, kh) + loft_acc_mul(p->x, turn),
            loft_acc_mul(up, u) + loft_acc_scale(p->up.a, kh) + loft_acc_mul(p->up.x, turn), most,
            loft_acc_scale(most, p->w));
    }
    return z;
}

static loft_unit limit_rest(const loft_plan_cell *c, const loft_budget *b, const place *p, int end,
                            loft_acc change, loft_acc up, loft_unit z)
{
    for (int i = 0; i < LOFT_AXES && z > 0; i++) {
        const loft_real u = c->along[end].axis[i];
        const loft_acc  most = loft_acc_mul(p->beats, b->gain[i]);
        z = limit_jerk(z, loft_acc_mul(change, u), loft_acc_mul(up, u), most,
                       loft_acc_scale(most, p->w));
    }
    return z;
}

/* What the middle begins with: the parabola of the curvature, and the direction between. */
static loft_plan_cell middle_of(const loft_plan_cell *c)
{
    loft_plan_cell middle = *c;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real d0 = (3 * c->turn[0].axis[i] + c->turn[1].axis[i]) / 8,
                        d = c->bend[1].axis[i] - c->bend[0].axis[i];
        middle.bend[0].axis[i]  = c->bend[0].axis[i] + d0;
        middle.turn[0].axis[i]  = d;
        middle.along[0].axis[i] = c->along[0].axis[i] / 2 + c->along[1].axis[i] / 2 -
                                  loft_acc_round(loft_acc_scale(loft_to_acc(d), c->length) / 8);
    }
    return middle;
}

/* Where it is eased it is asked with what is at its ends. */
static loft_unit limit_middle(const loft_plan_cell *c, const loft_budget *b, const place *p,
                              const place *q, loft_unit z)
{
    const loft_acc change = q->a - p->a, up = q->up.a - p->up.a, h = loft_unit_to_acc(c->length);
    loft_plan_cell middle = middle_of(c);

    middle.x = p->x + loft_acc_scale(p->a, c->length) + loft_acc_scale(change, c->length) / 4;
    middle.a = (p->a + q->a) / 2;
    if (!(middle.x > 0) || !(h > 0))
        return z;
    middle.r = loft_unit_round(loft_acc_div(loft_to_acc(LOFT_REAL(1)), loft_acc_sqrt(middle.x)));
    const loft_cell_rise rise = { p->up.x + loft_acc_scale(p->up.a, c->length) +
                                      loft_acc_scale(up, c->length) / 4,
                                  (p->up.a + q->up.a) / 2 };
    const place m = place_of(&middle, &middle, rise);
    if (c->eased == 0)
        return limit_end(&middle, b, &m, 0, change, up, z, AS_IT_IS, LOFT_UNIT(1) / BOW);
    for (int k = AS_IT_IS; k < c->eased; k++)       /* whatever curvature it has there */
        for (int end = 0; end < 2; end++)
            z = limit_end(c, b, &m, end, change, up, z, k, LOFT_UNIT(1) / BOW);
    return z;
}

/* The middle between a rest and the place p, where 1 / v is r: x, a, x'' and v are those of p times
 * 2^(-4/3), 2^(-1/3), 2^(2/3) and 2^(-2/3). */
static loft_unit limit_near_rest(const loft_plan_cell *c, const loft_budget *b, const place *p,
                                 loft_unit r, loft_acc change, loft_acc up, loft_unit z)
{
    const loft_unit two_thirds = LOFT_UNIT(1.5874010519682), third = LOFT_UNIT(0.7937005259841),
                    four_thirds = LOFT_UNIT(0.3968502629920);
    const loft_cell_rise rise = { loft_acc_scale(p->up.x, four_thirds),
                                  loft_acc_scale(p->up.a, third) };
    loft_plan_cell middle = middle_of(c);

    middle.x = loft_acc_scale(p->x, four_thirds);
    middle.a = loft_acc_scale(p->a, third);
    middle.r = loft_unit_round(loft_acc_scale(loft_unit_to_acc(r), two_thirds));
    const place m = place_of(&middle, &middle, rise);
    return limit_end(&middle, b, &m, 0, loft_acc_scale(change, two_thirds),
                     loft_acc_scale(up, two_thirds), z, AS_IT_IS, LOFT_UNIT(1) / BOW);
}

/* May more be asked for between the ends than there? Or is it fastest there? */
static bool bows(const loft_plan_cell *c, const place *p, const place *q)
{
    const loft_acc change = q->a - p->a, changed = change + q->up.a - p->up.a;
    const loft_acc a = loft_acc_max(loft_acc_abs(p->a), loft_acc_abs(q->a)),
                   raised = loft_acc_max(loft_acc_abs(p->a + p->up.a),
                                         loft_acc_abs(q->a + q->up.a));
    const loft_acc more = loft_acc_scale(loft_acc_max(loft_acc_abs(change), loft_acc_abs(changed)),
                                         c->bow_change) +
                          loft_acc_scale(loft_acc_max(a, raised), c->bow_accel);

    return (p->a > 0 && q->a < 0) || (p->up.a > 0 && q->up.a < 0) ||
           (loft_unit_to_acc(c->bow) + more) * BOW > loft_to_acc(LOFT_REAL(1));
}

loft_unit loft_cell_limit(const loft_plan_cell *c, const loft_plan_cell *next, const loft_budget *b,
                          loft_cell_rise at, loft_cell_rise to, loft_unit z, bool first, bool last)
{
    z = first ? z : limit(z, c->x, at.x, loft_acc_min(c->most, c->gate));
    z = last  ? z : limit(z, next->x, to.x, loft_acc_min(c->most, next->gate));
    if (!first && !last)
        z = limit(z, c->b, c->rise, c->most);
    if (!(z > 0))
        return 0;
    if (first || last) {
        const place p = first ? place_of(c, next, to) : place_of(c, c, at);
        const loft_acc change = first ? p.a / 3 : -p.a / 3, up = first ? p.up.a / 3 : -p.up.a / 3;
        for (int k = AS_IT_IS; k < c->eased; k++)
            z = limit_end(c, b, &p, first, change, up, z, k, 0);
        z = c->eased > 0 ? z : limit_near_rest(c, b, &p, first ? next->r : c->r, change, up, z);
        return limit_rest(c, b, &p, !first, change, up, z);
    }
    const place p = place_of(c, c, at), q = place_of(c, next, to);
    if (z > 0 && bows(c, &p, &q))
        z = limit_middle(c, b, &p, &q, z);
    for (int k = AS_IT_IS; k < c->eased; k++) {
        z = limit_end(c, b, &p, 0, q.a - p.a, q.up.a - p.up.a, z, k, 0);
        z = limit_end(c, b, &q, 1, q.a - p.a, q.up.a - p.up.a, z, k, 0);
    }
    return z;
}
