/* lib/geom/chord_pair.c
 * SPDX-License-Identifier: MIT
 *
 * False position finds the zero of the slope, which is linear between its kinks, at once as a rule;
 * every fourth round halves the range, which bounds the rounds by 96.
 */
#include "geom/chord_pair.h"

loft_foot loft_chord_foot_at(const loft_chord_pair *c, loft_unit at)
{
    loft_foot f = { at, 0, 0, 0 };
    loft_acc w[LOFT_AXES], r[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        w[i] = c->apart[i] + loft_acc_scale(c->a->u[i], at);
    const loft_acc to = loft_chord_foot(c->b, w, r);
    f.other = to <= 0 ? 0 : to < c->b->length ? loft_unit_ratio(to, c->b->length) : LOFT_UNIT(1);
    for (int i = 0; i < LOFT_AXES; i++)
        f.slope += loft_acc_scale(r[i], c->a->toward[i]);
    f.gap = loft_acc_hypot(r, LOFT_AXES);
    return f;
}

/* Between two parameters, by what part; the middle every fourth round, and if rounding leaves
 * none. */
static loft_unit parameter_between(loft_unit from, loft_unit to, loft_unit share, unsigned round)
{
    const loft_unit at = from + loft_unit_round(loft_acc_scale(loft_unit_to_acc(to - from), share));
    const bool inside = from < to ? from < at && at < to : to < at && at < from;
    return round % 4 == 3 || !inside ? from + (to - from) / 2 : at;
}

loft_foot loft_chord_closest(const loft_chord_pair *c, const loft_foot end[2], loft_acc fine)
{
    loft_foot low = end[0], high = end[1];

    if (low.slope >= 0)
        return low;
    if (high.slope <= 0)
        return high;
    for (unsigned round = 0; high.at - low.at > LOFT_UNIT(1.0 / 16777216); round++) {
        const loft_unit share = loft_unit_ratio(-low.slope, high.slope - low.slope);
        const loft_foot f = loft_chord_foot_at(c, parameter_between(low.at, high.at, share, round));
        if (f.gap <= fine)
            return f;
        if (f.slope > 0)
            high = f;
        else
            low = f;
    }
    return low.gap <= high.gap ? low : high;
}

/* True if the gap at `at` is at least `near`. A convex function is above its tangent, that at
 * `out`. */
static bool is_far_at(const loft_chord_pair *c, const loft_foot *out, loft_unit at, loft_acc near)
{
    const loft_unit way = out->at > at ? out->at - at : at - out->at;
    const loft_unit steep = loft_unit_ratio(loft_acc_abs(out->slope), out->gap);
    return out->gap - loft_acc_scale(loft_acc_scale(c->a->length, way), steep) >= near;
}

/* The line through two values of a convex function is above it, so the gap at `at` is below the
 * middle of `near` and `most`. */
loft_unit loft_chord_near_end(const loft_chord_pair *c, loft_foot in, loft_foot out, loft_acc near,
                              loft_acc most)
{
    const loft_unit step = LOFT_UNIT(1.0 / 16777216);
    const loft_acc goal = near + loft_acc_ratio(most - near, 2);

    for (unsigned round = 0; out.gap > most; round++) {
        if (out.at - in.at <= step && in.at - out.at <= step)
            break;
        const loft_unit share = loft_unit_ratio(goal - in.gap, out.gap - in.gap);
        const loft_unit at = parameter_between(in.at, out.at, share, round);
        if (round == 0 && is_far_at(c, &out, at, near))
            return at;
        const loft_foot f = loft_chord_foot_at(c, at);
        if (f.gap < near)
            in = f;
        else
            out = f;
    }
    return out.at;
}
