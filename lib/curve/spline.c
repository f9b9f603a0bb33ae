/* lib/curve/spline.c
 * SPDX-License-Identifier: MIT
 *
 * The unknowns are the slopes m_i at the points. Let h_i be the steps, q_i = (p_(i+1) - p_i) / h_i,
 * w_i = h_i / (h_(i-1) + h_i) and v_i = 1 - w_i = h_(i-1) / (h_(i-1) + h_i), which is divided and
 * not subtracted. Equal second derivatives at an inner point, and at every point of a closed
 * spline, are
 *
 *     w_i m_(i-1) + 2 m_i + v_i m_(i+1) = 3 (w_i q_(i-1) + v_i q_i)
 *
 * The first row of a spline that is not closed, and the last one likewise from its end:
 *
 *     natural       m_0 + 1/2 m_1 = 3/2 q_0
 *     clamped       m_0 = the slope given
 *     not-a-knot    m_0 + (h_0 + h_1)/h_1 m_1 = ((3 h_0 + 2 h_1) h_1 q_0 + h_0^2 q_1) /
 *                                                ((h_0 + h_1) h_1)
 *
 * Forward elimination makes m_i = r_i - next_i m_(i+1) - last_i m_(n-1); last_i is 0 unless the
 * spline is closed. With den = 2 - w_i next_(i-1):
 *
 *     next_i = v_i / den      last_i = -w_i last_(i-1) / den      r_i = (right - w_i r_(i-1)) / den
 *
 * Behind natural, clamped and closed first rows next is in 0..1/2, so den >= 3/2. The first row of
 * not-a-knot has next_0 = 1 / w_1, so den = 1 there and next_1 = v_1 <= 1: then den >= 1. All
 * quantities keep their relative error, e = 2^-61 (q16) or 2^-53 per operation. As in natural.c,
 * residuals do not grow along the spline; they are below 30 e S. Only the first and the last row of
 * not-a-knot, by which m_0 and m_(n-1) are found from their neighbours, multiply them, by Q.
 *
 * The last row of a closed spline needs m_0 and m_(n-2) as a_i - b_i m_(n-1): one more pass back,
 * which keeps a and b of one row at a time. The denominator 2 - w b_(n-2) - v b_0 is at least 1.
 *
 * On a segment, with d = p_(i+1) - p_i, a = h m_i - d, b = h m_(i+1) - d and u = 1 - x,
 *
 *     P   = p_i + x (d + u (a u - b x))
 *     P'  = (d + a u (1 - 3 x) + b x (3 x - 2)) / h
 *     P'' = (a (6 x - 4) + b (6 x - 2)) / h^2
 */
#include "curve/spline.h"

static loft_sci sci_coordinate(const loft_spline *s, uint32_t i, int axis)
{
    if (i == s->count)
        i = 0;                      /* closed */
    return loft_sci_from_real(s->p[(size_t)i * s->stride].axis[axis]);
}

static loft_sci spline_rise(const loft_spline *s, uint32_t i, int axis)
{
    return loft_sci_sub(sci_coordinate(s, i + 1, axis), sci_coordinate(s, i, axis));
}

static loft_sci secant_of(const loft_spline *s, uint32_t i, int axis)
{
    return loft_sci_div(spline_rise(s, i, axis), s->knot[i].step);
}

static loft_sci times_int(int32_t k, loft_sci x) { return loft_sci_mul(loft_sci_from_int(k), x); }

/* w at point i; v is that of the other step. */
static loft_sci share_of(loft_sci step, loft_sci other)
{
    return loft_sci_div(step, loft_sci_add(step, other));
}

static loft_sci step_before(const loft_spline *s, uint32_t i)
{
    return s->knot[i > 0 ? i - 1 : s->count - 1].step;
}

/* The right side of the row of point i. */
static loft_sci right_side(const loft_spline *s, uint32_t i, int axis)
{
    const loft_sci before = step_before(s, i), step = s->knot[i].step;
    const loft_sci sum = loft_sci_add(
        loft_sci_mul(share_of(step, before), secant_of(s, i > 0 ? i - 1 : s->count - 1, axis)),
        loft_sci_mul(share_of(before, step), secant_of(s, i, axis)));

    return times_int(3, sum);
}

/* The right side of the first row of not-a-knot, from the first two steps or the last two. */
static loft_sci outer_right_side(const loft_spline *s, uint32_t outer, uint32_t inner, int axis)
{
    const loft_sci h0 = s->knot[outer].step, h1 = s->knot[inner].step;
    const loft_sci outer_part = loft_sci_mul(
        loft_sci_mul(loft_sci_add(times_int(3, h0), times_int(2, h1)), h1),
        secant_of(s, outer, axis));
    const loft_sci inner_part = loft_sci_mul(loft_sci_mul(h0, h0), secant_of(s, inner, axis));

    return loft_sci_div(loft_sci_add(outer_part, inner_part),
                        loft_sci_mul(loft_sci_add(h0, h1), h1));
}

/* The share of the neighbour in the first or the last row, and the right side of it; a slope that
 * is given stays. */
static loft_sci end_row(const loft_spline *s, uint32_t outer, uint32_t inner, int axis,
                        loft_sci *right)
{
    const loft_sci half = loft_sci_div(loft_sci_one(), loft_sci_from_int(2));

    switch (s->ends) {
    case LOFT_ENDS_NATURAL:
        *right = loft_sci_mul(times_int(3, half), secant_of(s, outer, axis));
        return half;
    case LOFT_ENDS_NOT_A_KNOT:
        *right = outer_right_side(s, outer, inner, axis);
        return loft_sci_div(loft_sci_add(s->knot[outer].step, s->knot[inner].step),
                            s->knot[inner].step);
    default: return loft_sci_zero();
    }
}

static void eliminate_forward(const loft_spline *s, loft_spline_knot *knot, uint32_t rows, int axis)
{
    for (uint32_t i = 0; i < rows; i++) {
        const loft_sci step = knot[i].step, before = step_before(s, i);
        if (i == 0 && s->ends != LOFT_ENDS_CLOSED) {
            knot[0].next = end_row(s, 0, 1, axis, &knot[0].slope[axis]);
            knot[0].last = loft_sci_zero();
            continue;
        }
        const loft_sci w = share_of(step, before), right = right_side(s, i, axis);
        loft_sci den = loft_sci_from_int(2);
        loft_sci last = w, rest = right;
        if (i > 0) {
            den = loft_sci_sub_product(den, w, knot[i-1].next);
            last = loft_sci_neg(loft_sci_mul(w, knot[i-1].last));
            rest = loft_sci_sub_product(right, w, knot[i-1].slope[axis]);
        }
        knot[i].next = loft_sci_div(share_of(before, step), den);
        knot[i].last = loft_sci_div(last, den);
        knot[i].slope[axis] = loft_sci_div(rest, den);
    }
}

/* The last slope of a closed spline. */
static loft_sci closing_slope(const loft_spline *s, const loft_spline_knot *knot, int axis)
{
    const uint32_t end = s->count - 1;
    const loft_sci w = share_of(knot[end].step, knot[end - 1].step),
                   v = share_of(knot[end - 1].step, knot[end].step);
    loft_sci a = knot[end - 1].slope[axis];
    loft_sci b = loft_sci_add(knot[end - 1].next, knot[end - 1].last);
    loft_sci right = loft_sci_sub_product(right_side(s, end, axis), w, a);
    loft_sci den = loft_sci_sub_product(loft_sci_from_int(2), w, b);

    for (uint32_t i = end - 1; i-- > 0; ) {
        a = loft_sci_sub_product(knot[i].slope[axis], knot[i].next, a);
        b = loft_sci_sub_product(knot[i].last, knot[i].next, b);
    }
    right = loft_sci_sub_product(right, v, a);
    den = loft_sci_sub_product(den, v, b);
    return loft_sci_div(right, den);
}

/* The last slope of a spline that is not closed: m + share m_before = right. */
static loft_sci ending_slope(const loft_spline *s, const loft_spline_knot *knot, int axis)
{
    const uint32_t end = s->count - 1;
    loft_sci right = knot[end].slope[axis];
    const loft_sci share = end_row(s, end - 1, end - 2, axis, &right);
    const loft_sci den = loft_sci_sub_product(loft_sci_one(), share, knot[end - 1].next);

    return loft_sci_div(loft_sci_sub_product(right, share, knot[end - 1].slope[axis]), den);
}

/* Three points with not-a-knot ends, or two: a parabola, a line. */
static bool solve_few(const loft_spline *s, loft_spline_knot *knot, int axis)
{
    if (s->ends != LOFT_ENDS_NOT_A_KNOT || s->count > 3)
        return false;
    const loft_sci first = secant_of(s, 0, axis);
    loft_sci middle = first, second = first;
    if (s->count == 3) {
        second = secant_of(s, 1, axis);
        middle = loft_sci_add(loft_sci_mul(share_of(knot[1].step, knot[0].step), first),
                              loft_sci_mul(share_of(knot[0].step, knot[1].step), second));
    }
    knot[0].slope[axis] = loft_sci_sub(times_int(2, first), middle);
    knot[1].slope[axis] = middle;
    knot[s->count - 1].slope[axis] = loft_sci_sub(times_int(2, second), middle);
    return true;
}

/* The last row of not-a-knot in terms of the two before it: den = 1 - share next_(n-2) would cancel
 * where share is large, so m_(n-2) is found first. With the row of n-2, and share = 1 / v_(n-2), it
 * is m_(n-2) (2 - 1 - w next_(n-3)) = right - v last_right - w r_(n-3). */
static void solve_last_knot(const loft_spline *s, loft_spline_knot *knot, int axis)
{
    const uint32_t end = s->count - 1, inner = end - 1;
    const loft_sci h = knot[inner].step, before = knot[inner - 1].step;
    const loft_sci w = share_of(h, before), v = share_of(before, h);
    const loft_sci outer = outer_right_side(s, inner, inner - 1, axis);
    const loft_sci rest = loft_sci_sub_product(
        loft_sci_sub_product(right_side(s, inner, axis), v, outer), w, knot[inner - 1].slope[axis]);

    knot[inner].slope[axis] = loft_sci_div(
        rest, loft_sci_sub_product(loft_sci_one(), w, knot[inner - 1].next));
    knot[end].slope[axis] = loft_sci_sub(
        outer,
        loft_sci_mul(loft_sci_div(loft_sci_add(before, h), before), knot[inner].slope[axis]));
}

static void solve_axis(const loft_spline *s, loft_spline_knot *knot, int axis)
{
    const uint32_t end = s->count - 1;
    uint32_t i = end;

    if (solve_few(s, knot, axis))
        return;
    eliminate_forward(s, knot, end, axis);
    if (s->ends == LOFT_ENDS_NOT_A_KNOT) {
        solve_last_knot(s, knot, axis);
        i = end - 1;
    } else {
        knot[end].slope[axis] = s->ends == LOFT_ENDS_CLOSED ? closing_slope(s, knot, axis)
                                                            : ending_slope(s, knot, axis);
    }
    while (i-- > 0)
        knot[i].slope[axis] = loft_sci_sub_product(
            loft_sci_sub_product(knot[i].slope[axis], knot[i].last, knot[end].slope[axis]),
            knot[i].next, knot[i + 1].slope[axis]);
}

static loft_sci chord_step(const loft_spline *s, uint32_t i)
{
    loft_sci sum = loft_sci_zero();

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci d = spline_rise(s, i, axis);
        sum = loft_sci_add(sum, loft_sci_mul(d, d));
    }
    return loft_sci_sqrt(sum);
}

static enum loft_status check_points(const loft_spline *s)
{
    if (s->count < (s->ends == LOFT_ENDS_CLOSED ? 3u : 2u))
        return LOFT_ERR_ARG;
    for (uint32_t i = 0; i < s->count; i++)
        if (!loft_vec_valid(s->p[(size_t)i * s->stride]))
            return LOFT_ERR_RANGE;
    return LOFT_OK;
}

static enum loft_status set_steps(loft_spline *s, enum loft_spacing spacing,
                                  loft_spline_knot memory[])
{
    const enum loft_status status = check_points(s);

    if (status != LOFT_OK)
        return status;
    s->knot = memory;
    memory[s->count - 1].step = loft_sci_one();
    for (uint32_t i = 0; i < loft_spline_segments(s); i++) {
        memory[i].step = spacing == LOFT_CHORD ? chord_step(s, i) : loft_sci_one();
        if (loft_sci_sign(memory[i].step) <= 0)
            return LOFT_SINGULAR;
    }
    return LOFT_OK;
}

static void solve_all(loft_spline *s, loft_spline_knot memory[])
{
    for (int axis = 0; axis < LOFT_AXES; axis++)
        solve_axis(s, memory, axis);
}

enum loft_status loft_spline_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                  enum loft_spline_ends ends, enum loft_spacing spacing,
                                  loft_spline_knot memory[])
{
    loft_spline own = { p, memory, count, 1, (uint8_t)ends };

    if (ends == LOFT_ENDS_CLAMPED)
        return LOFT_ERR_ARG;
    const enum loft_status status = set_steps(&own, spacing, memory);
    if (status != LOFT_OK)
        return status;
    solve_all(&own, memory);
    *s = own;
    return LOFT_OK;
}

enum loft_status loft_spline_clamped_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                          const loft_vec slope[2], enum loft_spacing spacing,
                                          loft_spline_knot memory[])
{
    loft_spline own = { p, memory, count, 1, LOFT_ENDS_CLAMPED };
    const enum loft_status status = set_steps(&own, spacing, memory);

    if (status != LOFT_OK)
        return status;
    if (!loft_vec_valid(slope[0]) || !loft_vec_valid(slope[1]))
        return LOFT_ERR_RANGE;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        memory[0].slope[axis] = loft_sci_from_real(slope[0].axis[axis]);
        memory[count - 1].slope[axis] = loft_sci_from_real(slope[1].axis[axis]);
    }
    solve_all(&own, memory);
    *s = own;
    return LOFT_OK;
}

enum loft_status loft_spline_knots_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                        uint32_t stride, const loft_real u[],
                                        enum loft_spline_ends ends, loft_spline_knot memory[])
{
    loft_spline own = { p, memory, count, stride, (uint8_t)ends };

    if (ends == LOFT_ENDS_CLAMPED || ends == LOFT_ENDS_CLOSED)
        return LOFT_ERR_ARG;
    const enum loft_status status = set_steps(&own, LOFT_UNIFORM, memory);
    if (status != LOFT_OK)
        return status;
    for (uint32_t i = 0; i + 1 < count; i++) {
        if (!loft_real_valid(u[i]) || !loft_real_valid(u[i + 1]))
            return LOFT_ERR_RANGE;
        if (!(u[i] < u[i + 1]))
            return LOFT_ERR_ARG;
        memory[i].step = loft_sci_sub(loft_sci_from_real(u[i + 1]), loft_sci_from_real(u[i]));
    }
    solve_all(&own, memory);
    *s = own;
    return LOFT_OK;
}

static loft_sci central_slope(const loft_vec p[3], int axis)
{
    return loft_sci_div(
        loft_sci_sub(loft_sci_from_real(p[2].axis[axis]), loft_sci_from_real(p[0].axis[axis])),
        loft_sci_from_int(2));
}

enum loft_status loft_spline_hidden_init(loft_spline *s, const loft_vec p[], uint32_t count,
                                         enum loft_spline_hidden hidden, loft_spline_knot memory[])
{
    const bool through = hidden == LOFT_HIDDEN_THROUGH;
    loft_spline own = { p, memory, count, 1, LOFT_ENDS_NATURAL };

    if (count < 4)
        return LOFT_ERR_ARG;
    if (check_points(&own) != LOFT_OK)
        return LOFT_ERR_RANGE;
    if (!through) {
        own.p = p + 1;
        own.count = count - 2;
        own.ends = LOFT_ENDS_CLAMPED;
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            memory[0].slope[axis] = central_slope(p, axis);
            memory[count - 3].slope[axis] = central_slope(p + count - 3, axis);
        }
    }
    const enum loft_status status = set_steps(&own, LOFT_UNIFORM, memory);
    if (status != LOFT_OK)
        return status;
    solve_all(&own, memory);
    if (through) {
        own.p = p + 1;
        own.knot = memory + 1;
        own.count = count - 2;
    }
    *s = own;
    return LOFT_OK;
}

uint32_t loft_spline_segments(const loft_spline *s)
{
    return s->ends == LOFT_ENDS_CLOSED ? s->count : s->count - 1;
}

loft_sci loft_spline_slope(const loft_spline *s, uint32_t i, unsigned k, loft_sci x, int axis)
{
    const loft_spline_knot *to = &s->knot[i + 1 < s->count ? i + 1 : 0];
    const loft_sci h = s->knot[i].step, d = spline_rise(s, i, axis);
    const loft_sci a = loft_sci_sub(loft_sci_mul(h, s->knot[i].slope[axis]), d),
                   b = loft_sci_sub(loft_sci_mul(h, to->slope[axis]), d);
    const loft_sci one = loft_sci_one(), two = loft_sci_from_int(2), u = loft_sci_sub(one, x);

    if (k == 0) {
        const loft_sci bend = loft_sci_sub(loft_sci_mul(a, u), loft_sci_mul(b, x));
        const loft_sci along = loft_sci_add(d, loft_sci_mul(u, bend));
        return loft_sci_add(sci_coordinate(s, i, axis), loft_sci_mul(x, along));
    }
    if (k == 1) {
        const loft_sci by_a = loft_sci_mul(u, loft_sci_sub(one, times_int(3, x))),
                       by_b = loft_sci_mul(x, loft_sci_sub(times_int(3, x), two));
        const loft_sci sum = loft_sci_add(loft_sci_mul(a, by_a), loft_sci_mul(b, by_b));
        return loft_sci_div(loft_sci_add(d, sum), h);
    }
    const loft_sci six = times_int(6, x);
    const loft_sci sum = loft_sci_add(loft_sci_mul(a, loft_sci_sub(six, loft_sci_from_int(4))),
                                      loft_sci_mul(b, loft_sci_sub(six, two)));
    return loft_sci_div(loft_sci_div(sum, h), h);
}

static enum loft_status slope_vec(const loft_spline *s, uint32_t i, unsigned k, loft_unit t,
                                  loft_vec *out)
{
    loft_acc x[LOFT_AXES];

    if (i >= loft_spline_segments(s) || !(t >= 0 && t <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (int axis = 0; axis < LOFT_AXES; axis++)
        if (!loft_sci_to_acc(loft_spline_slope(s, i, k, loft_sci_from_unit(t), axis), &x[axis]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_spline_eval(const loft_spline *s, uint32_t i, loft_unit t, loft_vec *out)
{
    return slope_vec(s, i, 0, t, out);
}

enum loft_status loft_spline_deriv(const loft_spline *s, uint32_t i, unsigned k, loft_unit t,
                                   loft_vec *out)
{
    return k < 1 || k > 2 ? LOFT_ERR_ARG : slope_vec(s, i, k, t, out);
}

enum loft_status loft_cubic_from_spline(const loft_spline *s, uint32_t i, loft_cubic *out)
{
    if (i >= loft_spline_segments(s))
        return LOFT_ERR_ARG;
    const uint32_t to = i + 1 < s->count ? i + 1 : 0;
    const loft_sci third = loft_sci_div(s->knot[i].step, loft_sci_from_int(3));
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci from = sci_coordinate(s, i, axis), end = sci_coordinate(s, i + 1, axis);
        const loft_sci b[4] = { from,
                                loft_sci_add(from, loft_sci_mul(third, s->knot[i].slope[axis])),
                                loft_sci_sub(end, loft_sci_mul(third, s->knot[to].slope[axis])),
                                end };
        loft_acc c[4];
        for (int k = 0; k < 4; k++)
            if (!loft_sci_to_acc(b[k], &c[k]))
                return LOFT_ERR_RANGE;
        if (!loft_vec_round_axis(c, 4, axis, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}
