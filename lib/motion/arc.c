/* lib/motion/arc.c
 * SPDX-License-Identifier: MIT
 *
 * An arc is kept as the polynomial C(t) = c0 + c1 t + c2 t^2 + c3 t^3 of its own parameter, t = 0..1. With b = 1, b = 2 steps of a
 * half, the derivative at its start, middle and end is
 *
 *     D = c1 + c2 k + c3 3/4 k^2      k = 0, 1, 2
 *
 * and its control points, three times the legs between those of the curve, are c1, c1 + c2, c1 + 2 c2 + 3 c3.
 *
 * q16: control points are below 2^14, the sums of four with weights 1, 3, 3, 1 below 2^17. A product with t rounds by u = 2^-33, and
 * multiplies what was rounded before by t <= 1: where an arc begins c0, c1, c2 err by at most 3, 5, 3 u and, for the half of a
 * curve or less of it, the sum of all at its end by 9 u.
 */
#include "motion/arc.h"

#define SPECK        (3 * loft_acc_ratio(loft_wide(LOFT_REAL(1)), 65536))
#define DUST         (3 * loft_acc_ratio(loft_wide(LOFT_REAL(1)), 262144))
#define BLUR         16384                          /* grains: what is longer has a direction */
#define LENGTH_MAX   loft_wide(LOFT_REAL(64))       /* a loft_unit holds it */
#define BEND_MAX     (LOFT_REAL_MAX / 2)

static loft_acc size_of(loft_acc x)            { return x < 0 ? -x : x; }

/* Is p on the segment a..b, to within 2^-16 mm per plane? The distance of p from the line is |q x c| / |c| with
 * q = p - a, c = b - a, and |c| at least the largest of its coordinates. Products of coordinates are exact in q16; they sum to
 * less than 6 * 2^28. */
static bool on_chord(loft_vec p, loft_vec a, loft_vec b)
{
    const loft_vec q = loft_vec_sub(p, a), c = loft_vec_sub(b, a);
    loft_real largest = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        largest = c.axis[i] > largest ? c.axis[i] : largest;
        largest = -c.axis[i] > largest ? -c.axis[i] : largest;
    }
    const loft_acc most = loft_prod(largest, LOFT_REAL(0.0000152587890625));
    for (int i = 1; i < LOFT_AXES; i++)
        for (int j = 0; j < i; j++)
            if (size_of(loft_prod(q.axis[i], c.axis[j]) - loft_prod(q.axis[j], c.axis[i])) > most)
                return false;
    return loft_vec_dot(q, c) >= 0 && loft_vec_dot(q, q) <= loft_vec_dot(c, c);
}

/* The chord, walked evenly. */
static void straighten(loft_arc *a)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        a->c[1][i] += a->c[2][i] + a->c[3][i];
        a->c[2][i] = a->c[3][i] = 0;
    }
}

/* The whole curve from parameter `from` on, as a polynomial of t - from: control points, their differences, the powers' coefficients, and
 * three rounds of Horner's scheme. */
static void begin(loft_arc *a, const loft_cubic *curve, uint32_t from)
{
    const loft_vec *p = curve->p;
    const loft_unit t = loft_unit_of(from, LOFT_ARC_WHOLE);

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            a->c[k][i] = loft_wide(p[k].axis[i]);
    for (int n = 0; n < 3; n++)
        for (int k = 3; k > n; k--)
            for (int i = 0; i < LOFT_AXES; i++)
                a->c[k][i] -= a->c[k - 1][i];
    for (int k = 1; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            a->c[k][i] *= 3;
    if (on_chord(p[1], p[0], p[3]) && on_chord(p[2], p[0], p[3]))
        straighten(a);
    for (int n = 0; n < 3 && from > 0; n++)
        for (int k = 2; k >= n; k--)
            for (int i = 0; i < LOFT_AXES; i++)
                a->c[k][i] += loft_acc_scale(a->c[k + 1][i], t);
}

static void halve(loft_arc *a)
{
    loft_unit part = LOFT_UNIT(0.5);

    for (int k = 1; k < 4; k++, part /= 2)
        for (int i = 0; i < LOFT_AXES; i++)
            a->c[k][i] = loft_acc_scale(a->c[k][i], part);
}

/* Three times the legs: the derivative's control points. */
static void set_legs(const loft_arc *a, loft_acc leg[3][LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        leg[0][i] = a->c[1][i];
        leg[1][i] = leg[0][i] + a->c[2][i];
        leg[2][i] = leg[1][i] + a->c[2][i] + 3 * a->c[3][i];
    }
}

/* Legs whose mean is the chord. When all are within |chord| / 16 of it (per axis), direction and rate change by at most 1/8
 * over the arc, so no feature hides between the places looked at. */
static bool nearly_straight(loft_acc leg[3][LOFT_AXES], const loft_acc chord[LOFT_AXES], loft_acc length)
{
    if (!(length > 0) || length > LENGTH_MAX)
        return false;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (16 * size_of(leg[k][i] - chord[i]) > length)
                return false;
    return true;
}

static void set_direction(const loft_acc v[LOFT_AXES], loft_acc length, loft_vec *u)
{
    for (int i = 0; i < LOFT_AXES; i++)
        u->axis[i] = loft_acc_quot(v[i], length);
}

/* Split v into its part along u, which it gives, and what is left of it in v. */
static loft_acc take_along(loft_acc v[LOFT_AXES], const loft_vec *u)
{
    loft_acc along = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        along += loft_acc_mul(v[i], u->axis[i]);
    for (int i = 0; i < LOFT_AXES; i++)
        v[i] -= loft_acc_mul(along, u->axis[i]);
    return along;
}

/* Where a control point falls onto the end, rates grow from 0 and no part that begins there is nearly straight in the
 * sense above. A speck is, when all legs lead along its chord and no further than |chord| / 512 off it. */
static bool straight_speck(loft_acc leg[3][LOFT_AXES], const loft_acc chord[LOFT_AXES], loft_acc length)
{
    loft_vec u;

    if (!(length > 0))
        return false;
    set_direction(chord, length, &u);
    for (int k = 0; k < 3; k++) {
        if (take_along(leg[k], &u) < 0)
            return false;
        for (int i = 0; i < LOFT_AXES; i++)
            if (171 * size_of(leg[k][i]) > length)      /* a leg is a third of that */
                return false;
    }
    return true;
}

/* The derivative and its size. */
static loft_acc set_rate(const loft_arc *a, int k, loft_acc d[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        d[i] = a->c[1][i];
        for (int n = 0; n < k; n++)
            d[i] += a->c[2][i] + loft_acc_scale(a->c[3][i], k == 1 ? LOFT_UNIT(0.75) : LOFT_UNIT(1.5));
    }
    return loft_acc_hypot(d, LOFT_AXES);
}

/* x + v (a (1 - x) + b x + c v), v = x (1 - x): a polynomial with the right ends. */
static loft_acc bent(loft_unit x, const loft_unit at[3])
{
    const loft_acc v = loft_acc_scale(loft_unit_wide(x), LOFT_UNIT(1) - x);
    const loft_acc sum = loft_acc_lerp(loft_unit_wide(at[0]), loft_unit_wide(at[1]), x) + loft_acc_scale(v, at[2]);

    return loft_unit_wide(x) + loft_acc_scale(sum, loft_unit_round(v));
}

/* Where the rate is the parabola through its values r0, .. r1 the part w = s / length of the length ends at the parameter t with
 *
 *     w = t + v (h0 (1 - t) + h1 t)           h0 = r0 / length - 1,  h1 = 1 - r1 / length
 *
 * Its inverse is close to
 *
 *     t = w + v (g0 (1 - w) + g1 w + g2 v)    g0 = length / r0 - 1,  g1 = 1 - length / r1
 *
 * with g2 such that it is right where t = 1/2: there w is half to within 1/32, so v^2 is taken as 1/16. It errs by at most
 * 2^-12, which one step with the slope 1 instead of the right one, between 7/8 and 9/8, makes 2^-15. */
static loft_unit parameter_at(const loft_arc *arc, loft_acc s)
{
    const loft_unit w = loft_unit_ratio(s, arc->length), t = loft_unit_round(bent(w, arc->ahead));

    return t + loft_unit_round(loft_unit_wide(w) - bent(t, arc->behind));
}

/* Simpson's rule. Only dust rounds to nothing. */
static void set_length(loft_arc *a)
{
    loft_acc d[LOFT_AXES], rate[3];

    for (int k = 0; k < 3; k++)
        rate[k] = set_rate(a, k, d);
    a->length = rate[0] > 0 && rate[2] > 0 ? loft_acc_ratio(rate[0] + 4 * rate[1] + rate[2], 6) : 0;
    if (!(a->length > 0))
        return;
    for (int k = 0; k < 2; k++) {
        const loft_unit slope = loft_unit_ratio(rate[2 * k], a->length) - LOFT_UNIT(1);
        const loft_unit inverse = loft_unit_ratio(a->length, rate[2 * k]) - LOFT_UNIT(1);
        a->behind[k] = k == 0 ? slope : -slope;
        a->ahead[k]  = k == 0 ? inverse : -inverse;
    }
    a->behind[2] = a->ahead[2] = 0;
    const loft_unit half = loft_unit_round(bent(LOFT_UNIT(0.5), a->behind));
    a->ahead[2] = 16 * (LOFT_UNIT(0.5) - loft_unit_round(bent(half, a->ahead)));
}

/* Is the chord so long that rounding leaves its direction? Of q16's dust none is. */
static bool leads(const loft_arc *a, loft_acc length)
{
    loft_acc size = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        size = size_of(a->c[0][i]) > size ? size_of(a->c[0][i]) : size;
    return length > BLUR * loft_acc_grain(size);
}

/* Is it one that may be walked? `size` is that of its interval of parameters. What is too small for its bend to matter is a crumb if it has a
 * direction: the path may turn around where it begins and where it ends. */
static bool fits(loft_arc *a, uint32_t size)
{
    loft_acc leg[3][LOFT_AXES], chord[LOFT_AXES], legs = 0;

    set_legs(a, leg);
    for (int i = 0; i < LOFT_AXES; i++)
        chord[i] = a->c[1][i] + a->c[2][i] + a->c[3][i];
    const loft_acc length = loft_acc_hypot(chord, LOFT_AXES);
    const bool straight = nearly_straight(leg, chord, length);

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            legs += size_of(leg[k][i]);
    a->speck = !straight && legs <= SPECK && straight_speck(leg, chord, length);
    a->dust  = !straight && !a->speck && (legs <= DUST || size == 1);
    a->crumb = a->dust && leads(a, length);
    if (a->crumb) {
        a->speck = true;
        a->dust  = false;
    }
    if (a->speck || a->dust)
        straighten(a);
    if (straight || a->speck || a->dust)
        set_length(a);
    return straight || a->speck || a->dust;
}

void loft_arc_cut(loft_arc *arc, const loft_cubic *curve, uint32_t from, uint32_t to)
{
    begin(arc, curve, from);
    for (uint32_t size = LOFT_ARC_WHOLE; size > to - from; size /= 2)
        halve(arc);
    (void)fits(arc, to - from);
}

/* The largest binary interval that begins at `from`, halved until it is nearly straight. */
uint32_t loft_arc_next(loft_arc *arc, const loft_cubic *curve, uint32_t from)
{
    uint32_t size = LOFT_ARC_WHOLE;

    begin(arc, curve, from);
    while (from % size != 0 || !fits(arc, size)) {
        size /= 2;
        halve(arc);
    }
    return from + size;
}

/* With u = D / |D| the curvature vector is
 *
 *     K = (D' - u (u . D')) / |D|^2
 *
 * The quotient by |D| is below 1, as control points of the derivative differ by at most |chord| / 8. Arcs below 2^-15 mm may
 * bend more than a real of q16 can say: twice BEND_MAX stands for all of that. */
static loft_real curvature(loft_acc across, loft_acc rate)
{
    const loft_acc x = loft_wide(loft_acc_quot(across, rate));
    if (size_of(x) > loft_acc_mul(rate, BEND_MAX))
        return x < 0 ? -2 * BEND_MAX : 2 * BEND_MAX;
    return loft_acc_quot(x, rate);
}

static void set_station(const loft_arc *a, int k, loft_vec *u, loft_vec *bend)
{
    loft_acc v[LOFT_AXES];

    const loft_acc rate = set_rate(a, k, v);
    set_direction(v, rate, u);
    for (int i = 0; i < LOFT_AXES; i++)
        v[i] = 2 * a->c[2][i] + 3 * k * a->c[3][i];
    (void)take_along(v, u);
    for (int i = 0; i < LOFT_AXES; i++)
        bend->axis[i] = curvature(v[i], rate);
}

void loft_arc_measure(const loft_arc *arc, loft_arc_shape *shape)
{
    shape->tight = arc->dust;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            shape->along[k].axis[i] = LOFT_REAL(1);
            shape->bend[k].axis[i]  = 0;
        }
        if (!arc->dust)
            set_station(arc, k, &shape->along[k], &shape->bend[k]);
        if (!loft_vec_within(shape->bend[k], BEND_MAX))
            shape->tight = true;
    }
}

void loft_arc_eval(const loft_arc *arc, loft_acc s, loft_acc out[LOFT_AXES])
{
    const loft_unit t = parameter_at(arc, s);

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc x = arc->c[3][i];
        for (int k = 3; k > 0; k--)
            x = arc->c[k - 1][i] + loft_acc_scale(x, t);
        out[i] = x;
    }
}
