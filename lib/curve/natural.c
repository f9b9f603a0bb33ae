/* lib/curve/natural.c
 * SPDX-License-Identifier: MIT
 *
 * The unknowns are the slopes m_i at the points. Let h_i be the chords, d_i = p_(i+1) - p_i the
 * rises, q_i = d_i / h_i, and w_i = h_i / (h_(i-1) + h_i). The second derivatives are equal at each
 * inner point and vanish at the ends, which gives
 *
 *     2 m_0 + m_1 = 3 q_0
 *     w_i m_(i-1) + 2 m_i + (1 - w_i) m_(i+1) = 3 (w_i q_(i-1) + (1 - w_i) q_i)
 *                                             = 3 q_i + w_i 3 (q_(i-1) - q_i)
 *     m_(n-1) + 2 m_n = 3 q_(n-1)
 *
 * In each row the diagonal entry 2 exceeds the sum of the others by at least 1. Therefore |m| <= 3
 * max |q|, and residuals of size r change the solution by at most r. This holds for any number of
 * points: errors do not accumulate along the spline.
 *
 * Forward elimination: m_i = r_i - c_i m_(i+1), with c_0 = 1/2, r_0 = 3/2 q_0 and
 *
 *     den = 2 - w_i c_(i-1) >= 3/2      c_i = (1 - w_i) / den in 0..1/2
 *     r_i = (3 q_i + w_i (3 (q_(i-1) - q_i) - r_(i-1))) / den
 *
 * |r| <= 3 max |q|, since r solves a shorter system of the same kind. Back substitution gives the
 * m. An error of 2^-32 in a slope would be multiplied by chords up to 2^17.3. Dimensionless numbers
 * (w, c, den) and the slopes per chord length are therefore scaled by ONE = 2^24: in q16 to 2^-57,
 * in rounding steps of e = 2^-33. The largest intermediate value is 9 ONE < 2^27.2. Slopes per
 * uniform knot are coordinates, |q| <= 2^16, and are not scaled: 9 * 2^16.
 *
 * Errors with chord knots, in e, of numbers scaled by ONE. Lengths are known to 2^-59
 * (num/muldiv.h), so q: 1.25, w: 1.75 (both lengths, their common scale, the division). The
 * right-hand side: 3.75 + 7.5 from q, 9 * 1.75 from w, 1 of its own: 28. c: 3.3. den: 5.2, which is
 * multiplied by the unknown, up to 3. r = (28 + 15.6 + w r') / den + 1 with den >= 3/2: r <= 90. m
 * = 90 + 3 * 3.3 + 1/2 m + 1: m <= 202 e / ONE < 2^-49. Uniform knots: q and w are exact, r = (1 +
 * r' / 2) / 1.75 + 1 <= 2.2 e, m <= 2 (2.2 + 1) e = 6.4 e < 2^-30.
 *
 * A point needs m h (at most 3 * 2^17.3): 2^-49 * 2^17.3, and 2 e of its own: below 4 e. The curve
 * sees t (1 - t) <= 1/4 of it, a control point 1/3. With the roundings of loft_ends3 the error is 6
 * e = 6 * 2^-17 LSB.
 */
#include "curve/natural.h"
#include "basis/interp.h"   /* loft_ends3_deriv */
#include "num/muldiv.h"     /* loft_acc_muldiv, loft_acc_length */

#define ONE_SHIFT 24
#define ONE       (loft_to_acc(LOFT_REAL(1)) * 16777216)

static loft_acc axis_rise(const loft_vec *p, int axis)
{
    return loft_to_acc(p[1].axis[axis]) - loft_to_acc(p[0].axis[axis]);
}

/* The length of the chord from p[0] to p[1], times 2^shift. */
static loft_acc chord_length(const loft_vec *p, uint8_t *shift)
{
    loft_acc d[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        d[i] = axis_rise(p, i);
    return loft_acc_length(d, LOFT_AXES, shift);
}

/* A chord and the rises over it */
typedef struct {
    loft_acc length, rise[LOFT_AXES];
    uint8_t shift;
} leg;

/* False if the chord has length 0. d 2^shift <= length is exact in q16. */
static bool leg_init(leg *g, const loft_vec *p, enum loft_spacing knots)
{
    g->length = ONE;
    g->shift = 0;
    if (knots == LOFT_CHORD)
        g->length = chord_length(p, &g->shift);
    if (!(g->length > 0))
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        g->rise[i] = axis_rise(p, i);
        if (knots == LOFT_CHORD)
            g->rise[i] = loft_acc_muldiv(g->rise[i] * (loft_acc)((uint64_t)1 << g->shift), ONE,
                                         g->length);
    }
    return true;
}

/* w at the point between two legs: both lengths are brought to the coarser of their scales. */
static loft_acc leg_share(const leg *before, const leg *after)
{
    const unsigned common = before->shift < after->shift ? before->shift : after->shift;
    const loft_acc a = loft_acc_down(before->length, before->shift - common);
    const loft_acc b = loft_acc_down(after->length, after->shift - common);

    return loft_acc_muldiv(b, ONE, a + b);
}

/* One row: knot[0] holds c in `length` and r in `slope`; knot[1] gets its own. */
static void eliminate_row(loft_natural_knot *knot, const leg *before, const leg *after)
{
    const loft_acc w = leg_share(before, after),
                   den = 2 * ONE - loft_acc_muldiv(w, knot[0].length, ONE);

    knot[1].length = loft_acc_muldiv(ONE - w, ONE, den);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc back = 3 * (before->rise[i] - after->rise[i]) - knot[0].slope[i];
        knot[1].slope[i] = loft_acc_muldiv(3 * after->rise[i] + loft_acc_muldiv(back, w, ONE), ONE,
                                           den);
    }
}

/* Eliminate over all points; false if two coincide. */
static bool eliminate_forward(const loft_vec p[], uint32_t count, enum loft_spacing knots,
                              loft_natural_knot knot[])
{
    leg before, after;

    if (!leg_init(&before, p, knots))
        return false;
    knot[0].length = loft_acc_ratio(ONE, 2);
    for (int i = 0; i < LOFT_AXES; i++)
        knot[0].slope[i] = loft_acc_ratio(3 * before.rise[i], 2);
    for (uint32_t k = 1; k + 1 < count; k++) {
        if (!leg_init(&after, p + k, knots))
            return false;
        eliminate_row(&knot[k-1], &before, &after);
        before = after;
    }

    loft_natural_knot *last = &knot[count-1];
    for (int i = 0; i < LOFT_AXES; i++)
        last->slope[i] = loft_acc_muldiv(3 * before.rise[i] - last[-1].slope[i], ONE,
                                         2 * ONE - last[-1].length);
    return true;
}

/* Substitute back. Each c is then replaced by the length of the chord. */
static void substitute_back(const loft_vec p[], uint32_t count, enum loft_spacing knots,
                            loft_natural_knot knot[])
{
    knot[count-1].length = 0;
    knot[count-1].shift = 0;
    for (uint32_t k = count - 1; k-- > 0; ) {
        for (int i = 0; i < LOFT_AXES; i++)
            knot[k].slope[i] -= loft_acc_muldiv(knot[k].length, knot[k+1].slope[i], ONE);
        knot[k].length = ONE;
        knot[k].shift = 0;
        if (knots == LOFT_CHORD)
            knot[k].length = chord_length(p + k, &knot[k].shift);
    }
}

enum loft_status loft_natural_init(loft_natural *s, const loft_vec p[], uint32_t count,
                                   enum loft_spacing knots, loft_natural_knot memory[])
{
    if (count < 2)
        return LOFT_ERR_ARG;
    for (uint32_t k = 0; k < count; k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    if (!eliminate_forward(p, count, knots, memory))
        return LOFT_SINGULAR;
    substitute_back(p, count, knots, memory);

    s->p = p;
    s->knot = memory;
    s->count = count;
    s->knots = (uint8_t)knots;
    return LOFT_OK;
}

static bool segment_valid(const loft_natural *s, uint32_t i, loft_unit t)
{
    return i < s->count - 1 && t >= 0 && t <= LOFT_UNIT(1);
}

/* The slope at `end` for a parameter that runs from 0 to 1 over the chord of `knot` */
static loft_acc segment_slope(const loft_natural *s, const loft_natural_knot *knot,
                              const loft_natural_knot *end, int axis)
{
    if (s->knots == LOFT_UNIFORM)
        return end->slope[axis];
    return loft_acc_down(loft_acc_muldiv(end->slope[axis], knot->length, ONE), knot->shift);
}

static void segment_ends(const loft_natural *s, uint32_t i, int axis, loft_acc e[4])
{
    const loft_natural_knot *knot = &s->knot[i];

    e[0] = loft_to_acc(s->p[i].axis[axis]);
    e[1] = loft_to_acc(s->p[i+1].axis[axis]);
    e[2] = segment_slope(s, knot, knot, axis);
    e[3] = segment_slope(s, knot, knot + 1, axis);
}

enum loft_status loft_natural_eval(const loft_natural *s, uint32_t i, loft_unit t, loft_vec *out)
{
    loft_acc e[4], x[LOFT_AXES];

    if (!segment_valid(s, i, t))
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        segment_ends(s, i, axis, e);
        x[axis] = loft_ends3_deriv(e, 0, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* On a chord, per unit of its length: take the cubic with the rise q h and the slopes m h, divided
 * by h. Its derivatives are the wanted ones times h^(k-1). In q16 the division by h for k = 2 gives
 * x ONE / length with |x| <= 24 ONE (below) and length >= 4 ONE: below 2^26.6. That is the second
 * derivative times 2^(48 - shift), and shift <= 42, so only a right shift remains.
 *
 * Errors in e / ONE: m 202, q 1.25. k = 1: between m and 3 q - 2 m, 410 and 2 for the scheme,
 * 2^-48, and 2^-33 for the last division: 2^-17 LSB. k = 2: 2 (3 q - 3 m), 1220: 2^-46.7, divided
 * by h >= 2^-16: 2^-14 LSB. */
static loft_acc derivative_per_length(const loft_natural *s, uint32_t i, unsigned k, loft_unit t,
                                      int axis)
{
    const loft_natural_knot *knot = &s->knot[i];
    const loft_acc unit = (loft_acc)((uint64_t)1 << knot->shift);
    const loft_acc q = loft_acc_muldiv(axis_rise(&s->p[i], axis) * unit, ONE, knot->length);
    const loft_acc e[4] = { 0, q, knot[0].slope[axis], knot[1].slope[axis] };
    const loft_acc x = loft_ends3_deriv(e, k, t);

    return k == 1
               ? loft_acc_down(x, ONE_SHIFT)
               : loft_acc_down(loft_acc_muldiv(x, ONE, knot->length), 2u * ONE_SHIFT - knot->shift);
}

enum loft_status loft_natural_deriv(const loft_natural *s, uint32_t i, unsigned k, loft_unit t,
                                    loft_vec *out)
{
    loft_acc e[4], x[LOFT_AXES];

    if (!segment_valid(s, i, t) || k < 1 || k > 2)
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        if (s->knots == LOFT_UNIFORM) {
            segment_ends(s, i, axis, e);
            x[axis] = loft_ends3_deriv(e, k, t);
        } else {
            x[axis] = derivative_per_length(s, i, k, t, axis);
        }
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_cubic_from_natural(const loft_natural *s, uint32_t i, loft_cubic *out)
{
    loft_acc e[4], c[4];

    if (!segment_valid(s, i, 0))
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        segment_ends(s, i, axis, e);
        loft_ends3_bernstein(e, c);
        if (!loft_vec_round_axis(c, 4, axis, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}
