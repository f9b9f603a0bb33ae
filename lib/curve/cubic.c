/* lib/curve/cubic.c -- the cubic's own functions (curve/bezier.h)
 * SPDX-License-Identifier: MIT
 */
#include "curve/bezier.h"

/* The chord plus the deviation from it, which has t (1 - t) as a factor:
 *
 *     P = lerp(p0, p3, t) + t (1 - t) lerp(u, v, t)
 *     u = 3 p1 - 2 p0 - p3,   v = 3 p2 - p0 - 2 p3
 *
 * since the chord as a cubic has the inner points (2 p0 + p3) / 3 and (p0 + 2 p3) / 3. This takes
 * four products instead of the six lerps of de Casteljau, and both ends stay exact in every number
 * type.
 *
 * q16: |u|, |v| <= 6 * 2^47 < 2^50. Errors: 2^-33 for the chord, 2^-33 (1/4 + 1 + 1) for the rest,
 * together below 2^-31, 2^-15 LSB. Floats, e = 2^-53: u and v are off by 14 e, lerp(u, v) by 32 e,
 * times 1/4, and so on: 16 e. */
static loft_acc point(loft_real p0, loft_real p1, loft_real p2, loft_real p3, loft_unit t)
{
    const loft_acc a = loft_to_acc(p0), d = loft_to_acc(p3);
    const loft_acc u = 3 * loft_to_acc(p1) - 2 * a - d;
    const loft_acc v = 3 * loft_to_acc(p2) - a - 2 * d;
    const loft_acc bulge = loft_acc_scale(loft_acc_scale(loft_acc_lerp(u, v, t), t),
                                          LOFT_UNIT(1) - t);

    return loft_acc_lerp(a, d, t) + bulge;
}

loft_cubic loft_cubic_line(loft_vec from, loft_vec to)
{
    loft_cubic line = { { from, from, to, to } };

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc a = loft_to_acc(from.axis[i]), b = loft_to_acc(to.axis[i]);
        line.p[1].axis[i] = loft_acc_round(loft_acc_lerp_at(a, b, 1, 3));
        line.p[2].axis[i] = loft_acc_round(loft_acc_lerp_at(a, b, 2, 3));
    }
    return line;
}

loft_vec loft_cubic_eval(const loft_cubic *c, loft_unit t)
{
    loft_vec v;

    t = loft_unit_clamp(t);
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_round(
            point(c->p[0].axis[i], c->p[1].axis[i], c->p[2].axis[i], c->p[3].axis[i], t));
    return v;
}

/* The hodograph, a quadratic with the coefficients 3 (p[j+1] - p[j]) < 2^49.6, and its
 * differences. */
void loft_cubic_deriv(const loft_cubic *c, unsigned k, loft_unit t, loft_acc out[LOFT_AXES])
{
    t = loft_unit_clamp(t);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc p1 = loft_to_acc(c->p[1].axis[i]), p2 = loft_to_acc(c->p[2].axis[i]);
        const loft_acc a = 3 * (p1 - loft_to_acc(c->p[0].axis[i]));
        const loft_acc b = 3 * (p2 - p1);
        const loft_acc d = 3 * (loft_to_acc(c->p[3].axis[i]) - p2);

        switch (k) {
        case 0:
            out[i] = point(c->p[0].axis[i], c->p[1].axis[i], c->p[2].axis[i], c->p[3].axis[i], t);
            break;
        case 1: out[i] = loft_acc_lerp(loft_acc_lerp(a, b, t), loft_acc_lerp(b, d, t), t); break;
        case 2: out[i] = loft_acc_lerp(2 * (b - a), 2 * (d - b), t); break;
        case 3: out[i] = 2 * (d - 2 * b + a); break;
        default: out[i] = 0;
        }
    }
}

/* The control points of a piece are blossoms:
 *
 *     b[a,a,a]   b[a,a,b]   b[a,b,b]   b[b,b,b]        a = from, b = to
 *
 * Two rows of de Casteljau at a and two at b; the third row combines them. */
loft_cubic loft_cubic_sub(const loft_cubic *c, loft_unit from, loft_unit to)
{
    loft_cubic piece;

    from = loft_unit_clamp(from);
    to   = loft_unit_clamp(to);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc a[4], b[4];
        for (int k = 0; k < 4; k++)
            a[k] = b[k] = loft_to_acc(c->p[k].axis[i]);

        loft_bernstein_step(a, 3, from);
        loft_bernstein_step(a, 2, from);
        loft_bernstein_step(b, 3, to);
        loft_bernstein_step(b, 2, to);

        piece.p[0].axis[i] = loft_acc_round(loft_acc_lerp(a[0], a[1], from));
        piece.p[1].axis[i] = loft_acc_round(loft_acc_lerp(a[0], a[1], to));
        piece.p[2].axis[i] = loft_acc_round(loft_acc_lerp(b[0], b[1], from));
        piece.p[3].axis[i] = loft_acc_round(loft_acc_lerp(b[0], b[1], to));
    }
    return piece;
}

void loft_cubic_split(const loft_cubic *c, loft_unit t, loft_cubic *left, loft_cubic *right)
{
    t = loft_unit_clamp(t);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc p0 = loft_to_acc(c->p[0].axis[i]), p1 = loft_to_acc(c->p[1].axis[i]);
        const loft_acc p2 = loft_to_acc(c->p[2].axis[i]), p3 = loft_to_acc(c->p[3].axis[i]);

        const loft_acc q0 = loft_acc_lerp(p0, p1, t), q1 = loft_acc_lerp(p1, p2, t),
                       q2 = loft_acc_lerp(p2, p3, t);
        const loft_acc r0 = loft_acc_lerp(q0, q1, t), r1 = loft_acc_lerp(q1, q2, t);
        const loft_acc s  = loft_acc_lerp(r0, r1, t);

        left->p[0].axis[i]  = loft_acc_round(p0);
        left->p[1].axis[i]  = loft_acc_round(q0);
        left->p[2].axis[i]  = loft_acc_round(r0);
        left->p[3].axis[i]  = loft_acc_round(s);
        right->p[0].axis[i] = loft_acc_round(s);
        right->p[1].axis[i] = loft_acc_round(r1);
        right->p[2].axis[i] = loft_acc_round(q2);
        right->p[3].axis[i] = loft_acc_round(p3);
    }
}
