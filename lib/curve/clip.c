/* lib/curve/clip.c
 * SPDX-License-Identifier: MIT
 *
 * For any direction u the values <p(t), u> of a piece are a polynomial, within the hull of its
 * coefficients. Where the curves are within `gap` of each other, the values of one are at most |u|
 * gap beyond those of the other. u is at a right angle to the chord of one piece, its line, and its
 * largest component is 1: |u| <= sqrt(axes) < (axes + 1) / 2. The hull of the points (k / degree,
 * <p_k, u>) of the other piece is in that strip only in a part of 0..1; the rest is cut off.
 *
 * Crossings. Let F = <a(s) - b(t), v> across the chord of b, and G = <a(s) - b(t), w> across that
 * of a. Let A be the least slope of <a, v> and c that of <b, v> at most, B the least slope of <b,
 * w> and d that of <a, w> at most. If F = G = 0 at s, t to g / 8, and both are at most g at s + x,
 * t + y, then
 *
 *     A |x| <= 9/8 g + c |y|      B |y| <= 9/8 g + d |x|
 *
 * and with c <= 3/4 B and d <= 3/4 A
 *
 *     A |x| <= 9/8 g + 3/4 (9/8 g + 3/4 A |x|), so |x| <= 4 (9/8 g) / A, and |y| likewise.
 *
 * So all that is near is around s, t, which Newton's method finds: with X = Fs x, Y = Gt y, p = Gs
 * / Fs and q = Ft / Gt, |p|, |q| <= 3/4, it is X (1 - p q) = q G - F and Y = p X + G. The division
 * is 1 + p q + (p q)^2: then a step leaves a fifth of the error at worst.
 *
 * Rounding. A piece runs from one to another multiple of 2^-24. What is cut off is rounded inward
 * by 2 of them: 1/2 for the ratio, 1/2 for the product, the rest for that of <p_k, u>. */
#include "curve/clip.h"
#include "basis/dyadic.h"   /* loft_bernstein_sub */


/* One piece */

void loft_piece_start(loft_piece *s, const loft_bezier *b)
{
    s->b = b;
    for (int i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k <= b->degree; k++)
            s->whole[i][k] = loft_to_acc(b->p[k].axis[i]);
    loft_piece_cut(s, 0, LOFT_PIECE_WHOLE);
}

void loft_piece_cut(loft_piece *s, uint32_t from, uint32_t to)
{
    const unsigned degree = s->b->degree;

    s->from = from;
    s->to = to;
    s->reach = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_bernstein_sub(s->whole[i], degree, loft_piece_from(s), loft_piece_to(s), s->p[i]);
        s->chord.u[i] = s->p[i][degree] - s->p[i][0];
        s->reach = loft_acc_max(s->reach, loft_acc_abs(s->chord.u[i]));
    }
    s->aimed = false;
}

void loft_piece_aim(loft_piece *s)
{
    if (!s->aimed)
        loft_chord_aim(&s->chord);
    s->aimed = true;
}

loft_unit loft_piece_at(const loft_piece *s, loft_unit t)
{
    return loft_unit_round(
        loft_acc_lerp(loft_unit_to_acc(loft_piece_from(s)), loft_unit_to_acc(loft_piece_to(s)), t));
}

void loft_piece_range(const loft_piece *s, int axis, loft_acc *low, loft_acc *high)
{
    *low = *high = s->p[axis][0];
    for (unsigned k = 1; k <= s->b->degree; k++) {
        *low = loft_acc_min(*low, s->p[axis][k]);
        *high = loft_acc_max(*high, s->p[axis][k]);
    }
}


/* Hulls */

/* Move x to the nearest point of the chord; r is the old x minus the new one. */
static void move_to_chord(const loft_piece *s, loft_acc x[], loft_acc r[])
{
    loft_acc w[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        w[i] = x[i] - s->p[i][0];
    loft_chord_foot(&s->chord, w, r);
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] -= r[i];
}

/* The maximum of <p_k - x, u> (sign 1) or of its negative (sign -1), but at least 0. */
static loft_acc hull_extreme(const loft_piece *s, const loft_acc x[], const loft_unit u[],
                             int32_t sign)
{
    loft_acc most = 0;

    for (unsigned k = 0; k <= s->b->degree; k++) {
        loft_acc along = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            along += loft_acc_scale(s->p[i][k] - x[i], u[i]);
        if (sign * along > most)
            most = sign * along;
    }
    return most + loft_acc_scale(most, LOFT_UNIT(1.0 / 4194304));       /* |u| may be 1 +- 2^-23 */
}

bool loft_piece_boxes_apart(const loft_piece *a, const loft_piece *b, loft_acc gap)
{
    loft_acc low_a, high_a, low_b, high_b;

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_piece_range(a, i, &low_a, &high_a);
        loft_piece_range(b, i, &low_b, &high_b);
        if (low_b - high_a > gap || low_a - high_b > gap)
            return true;
    }
    return false;
}

/* For any direction u, min <b_i, u> - max <a_i, u> is a lower bound of the distance. */
bool loft_piece_hulls_apart(loft_piece *a, loft_piece *b, loft_acc gap)
{
    loft_acc x[LOFT_AXES], y[LOFT_AXES], r[LOFT_AXES];
    loft_unit u[LOFT_AXES];

    if (loft_piece_boxes_apart(a, b, gap))
        return true;
    loft_piece_aim(a);
    loft_piece_aim(b);
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = b->p[i][0] + loft_acc_ratio(b->chord.u[i], 2);
    move_to_chord(a, x, r);
    move_to_chord(b, x, r);
    for (int i = 0; i < LOFT_AXES; i++)
        y[i] = x[i];
    move_to_chord(a, x, r);                     /* r = y - x, from a to b */

    const loft_acc m = loft_acc_hypot(r, LOFT_AXES);
    if (m <= gap)
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        u[i] = loft_unit_ratio(r[i], m);
    return m - hull_extreme(a, x, u, 1) - hull_extreme(b, y, u, -1) - 4 * loft_hypot_ulp(m) > gap;
}


/* Strips */

/* A direction at a right angle to the chord of `line`, whose largest component is 1 as a rule; null
 * if there is none. In more than two axes it is in the plane of both chords. */
static void aim_across(loft_piece *line, const loft_piece *s, loft_unit u[])
{
    loft_acc along = 0, across[LOFT_AXES], most = 0;

    if (LOFT_AXES == 2) {
        across[0] = -line->chord.u[LOFT_AXES - 1];
        across[LOFT_AXES - 1] = line->chord.u[0];
        most = line->reach;
    } else {
        loft_piece_aim(line);
        for (int i = 0; i < LOFT_AXES; i++)
            along += loft_acc_scale(s->chord.u[i], line->chord.toward[i]);
        for (int i = 0; i < LOFT_AXES; i++) {
            across[i] = s->chord.u[i] - loft_acc_scale(along, line->chord.toward[i]);
            most = loft_acc_max(most, loft_acc_abs(across[i]));
        }
    }
    for (int i = 0; i < LOFT_AXES; i++)
        u[i] = most > 0 ? loft_unit_ratio(across[i], most) : 0;
}

/* How both pieces lie across the chord of `line`, which is one of them: the polynomials <p(t) - x,
 * u> of the line and of the other piece, and the range of the line, wider by the gap. */
typedef struct {
    loft_acc line[LOFT_DEGREE_MAX + 1], other[LOFT_DEGREE_MAX + 1], low, high;
} across;

static void project_piece(const loft_piece *s, const loft_acc x[], const loft_unit u[],
                          loft_acc e[])
{
    for (unsigned k = 0; k <= s->b->degree; k++) {
        e[k] = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            e[k] += loft_acc_scale(s->p[i][k] - x[i], u[i]);
    }
}

/* Bounds of the values of a polynomial. It is between its end values e[0] = 0 and e[degree], but
 * for the weights of the coefficients between them, 1 - (1 - t)^degree - t^degree <= 1 - 2^(1 -
 * degree). */
static void hull_range(const loft_acc e[], unsigned degree, loft_acc *low, loft_acc *high)
{
    const loft_acc floor = loft_acc_min(e[0], e[degree]), ceiling = loft_acc_max(e[0], e[degree]);
    const loft_unit most = LOFT_UNIT(1) - loft_unit_of(2, (uint32_t)1 << degree);
    loft_acc below = 0, above = 0;

    for (unsigned k = 1; k < degree; k++) {
        below = loft_acc_min(below, e[k] - ceiling);
        above = loft_acc_max(above, e[k] - floor);
    }
    *low = floor + loft_acc_scale(below, most);
    *high = ceiling + loft_acc_scale(above, most);
}

static void look_across(loft_acc gap, loft_piece *line, const loft_piece *other, across *c)
{
    loft_acc x[LOFT_AXES];
    loft_unit u[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = line->p[i][0];
    aim_across(line, other, u);
    project_piece(line, x, u, c->line);
    project_piece(other, x, u, c->other);
    hull_range(c->line, line->b->degree, &c->low, &c->high);
    c->low -= gap;
    c->high += gap;
}

/* True if the other piece is outside the range of the line. */
static bool is_other_apart(const across *c, unsigned degree)
{
    bool below = true, above = true;

    for (unsigned k = 0; k <= degree; k++) {
        below = below && c->other[k] < c->low;
        above = above && c->other[k] > c->high;
    }
    return below || above;
}

/* The part of 0..1, times the degree, in which the hull of (k, e[k]) is within low..high; empty
 * (first > last) if it never is. */
typedef struct {
    loft_acc first, last;
} strip;

/* Where, between j and k, the line from e[j] to e[k] is at `level`: one of them is above it, the
 * other is not. */
static loft_acc pass_at(const loft_acc e[], unsigned j, unsigned k, loft_acc level)
{
    const loft_acc x = loft_acc_abs(e[j] - level), y = loft_acc_abs(e[k] - level);
    const loft_acc share = loft_unit_to_acc(loft_unit_ratio(x, x + y));
    return (int32_t)j * loft_unit_to_acc(LOFT_UNIT(1)) + ((int32_t)k - (int32_t)j) * share;
}

/* The first place where the hull is below (sign 1) or above (sign -1) `level`, which it is not at
 * 0. */
static loft_acc first_pass(const loft_acc e[], unsigned degree, loft_acc level, int32_t sign)
{
    loft_acc first = ((int32_t)degree + 1) * loft_unit_to_acc(LOFT_UNIT(1));

    for (unsigned k = 1; k <= degree; k++)
        for (unsigned j = 0; j < k && sign * e[k] <= sign * level; j++)
            if (sign * e[j] > sign * level)
                first = loft_acc_min(first, pass_at(e, j, k, level));
    return first;
}

/* The last one, which it is not at the end. */
static loft_acc last_pass(const loft_acc e[], unsigned degree, loft_acc level, int32_t sign)
{
    loft_acc last = -loft_unit_to_acc(LOFT_UNIT(1));

    for (unsigned k = 0; k < degree; k++)
        for (unsigned j = degree; j > k && sign * e[k] <= sign * level; j--)
            if (sign * e[j] > sign * level)
                last = loft_acc_max(last, pass_at(e, j, k, level));
    return last;
}

static strip strip_of(const loft_acc e[], unsigned degree, loft_acc low, loft_acc high)
{
    strip found = { 0, (int32_t)degree * loft_unit_to_acc(LOFT_UNIT(1)) };

    if (e[0] > high)
        found.first = first_pass(e, degree, high, 1);
    else if (e[0] < low)
        found.first = first_pass(e, degree, low, -1);
    if (e[degree] > high)
        found.last = last_pass(e, degree, high, 1);
    else if (e[degree] < low)
        found.last = last_pass(e, degree, low, -1);
    return found;
}

/* Cut the piece to first..last of its 0..1, if that is at most 3/4 of it. */
static bool shorten_piece(loft_piece *s, loft_acc first, loft_acc last)
{
    const int32_t width = (int32_t)(s->to - s->from);
    const int32_t from = loft_acc_int(first * width) - 2, to = loft_acc_int(last * width) + 2;
    const uint32_t start = from > 0 ? s->from + (uint32_t)from : s->from,
                   end = to < width ? s->from + (uint32_t)to : s->to;

    if (4 * (end - start) > 3 * (uint32_t)width)
        return false;
    loft_piece_cut(s, start, end);
    return true;
}

static bool clip_piece(loft_piece *s, const across *c)
{
    const int32_t degree = (int32_t)s->b->degree;
    const strip near = strip_of(c->other, s->b->degree, c->low, c->high);

    return shorten_piece(s, loft_acc_ratio(near.first, degree), loft_acc_ratio(near.last, degree));
}


/* Pieces that cross */

/* The least slope of a polynomial that only grows or only falls; 0 if it does neither. */
static loft_acc least_slope(const loft_acc e[], unsigned degree)
{
    loft_acc least = loft_acc_abs(e[1] - e[0]);

    for (unsigned k = 0; k < degree; k++) {
        const loft_acc d = e[0] < e[1] ? e[k + 1] - e[k] : e[k] - e[k + 1];
        least = loft_acc_min(least, d);
    }
    return least > 0 ? (int32_t)degree * least : 0;
}

static loft_acc most_slope(const loft_acc e[], unsigned degree)
{
    loft_acc most = 0;

    for (unsigned k = 0; k < degree; k++)
        most = loft_acc_max(most, loft_acc_abs(e[k + 1] - e[k]));
    return (int32_t)degree * most;
}

/* The value of a polynomial and its slope. */
static loft_acc value_at(const loft_acc e[], unsigned degree, loft_unit t, loft_acc *slope)
{
    loft_acc c[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= degree; k++)
        c[k] = e[k];
    for (unsigned n = degree; n > 1; n--)
        for (unsigned k = 0; k < n; k++)
            c[k] = loft_acc_lerp(c[k], c[k + 1], t);
    *slope = (int32_t)degree * (c[1] - c[0]);
    return loft_acc_lerp(c[0], c[1], t);
}

static loft_unit signed_ratio(loft_acc x, loft_acc y)
{
    return y > 0 ? loft_unit_ratio(x, y) : loft_unit_ratio(-x, -y);
}

/* Where a and b, of degrees m and n, are at the same place across both chords, to `fine`; false if
 * none is found. */
static bool meet_across(const across *by_a, const across *by_b, unsigned m, unsigned n,
                        loft_acc fine, loft_unit *s, loft_unit *t)
{
    loft_acc a1, a2, b1, b2;

    *s = *t = LOFT_UNIT(0.5);
    for (int round = 0; round < 6; round++) {
        const loft_acc f = value_at(by_b->other, m, *s, &a1) - value_at(by_b->line, n, *t, &b1),
                       g = value_at(by_a->line, m, *s, &a2) - value_at(by_a->other, n, *t, &b2);
        if (loft_acc_abs(f) <= fine && loft_acc_abs(g) <= fine)
            return true;
        const loft_unit p = signed_ratio(a2, a1), q = signed_ratio(b1, b2);
        const loft_acc r = loft_acc_scale(g, q) - f, r1 = loft_acc_scale(loft_acc_scale(r, p), q),
                       x = r + r1 + loft_acc_scale(loft_acc_scale(r1, p), q),
                       y = loft_acc_scale(x, p) + g;
        if (loft_acc_abs(x) > loft_acc_abs(a1) || loft_acc_abs(y) > loft_acc_abs(b2))
            return false;
        *s = loft_unit_clamp(*s + signed_ratio(x, a1));
        *t = loft_unit_clamp(*t + signed_ratio(y, b2));
    }
    return false;
}

static bool shorten_around(loft_piece *s, loft_unit at, loft_acc reach, loft_acc slope)
{
    const loft_unit by = loft_unit_ratio(reach, slope);
    return shorten_piece(s, loft_unit_to_acc(at - by), loft_unit_to_acc(at + by));
}

/* Cut both pieces to where they can be near, if they meet at an angle. */
static bool clip_crossing(loft_piece *a, loft_piece *b, const across *by_a, const across *by_b,
                          loft_acc gap)
{
    const unsigned m = a->b->degree, n = b->b->degree;
    const loft_acc fast_a = least_slope(by_b->other, m), fast_b = least_slope(by_a->other, n);
    const loft_acc fine = loft_acc_ratio(gap, 8), reach = 4 * (gap + fine);
    loft_unit s, t;

    if (fast_a < 4 * reach || fast_b < 4 * reach || 3 * fast_a < 4 * most_slope(by_a->line, m) ||
        3 * fast_b < 4 * most_slope(by_b->line, n) || !meet_across(by_a, by_b, m, n, fine, &s, &t))
        return false;
    const bool less_a = shorten_around(a, s, reach, fast_a),
               less_b = shorten_around(b, t, reach, fast_b);
    return less_a || less_b;
}


bool loft_piece_clip(loft_piece *a, loft_piece *b, loft_acc gap, bool *less)
{
    const loft_acc wide = loft_acc_ratio((LOFT_AXES + 1) * gap, 2);
    across by_a, by_b;

    *less = false;
    if (a->b->degree == 0 || b->b->degree == 0)
        return true;
    look_across(wide, a, b, &by_a);
    if (is_other_apart(&by_a, b->b->degree))
        return false;
    look_across(wide, b, a, &by_b);
    if (is_other_apart(&by_b, a->b->degree))
        return false;
    *less = clip_crossing(a, b, &by_a, &by_b, wide);
    if (!*less) {
        const bool less_a = clip_piece(a, &by_b), less_b = clip_piece(b, &by_a);
        *less = less_a || less_b;
    }
    return true;
}
