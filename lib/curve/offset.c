/* lib/curve/offset.c
 * SPDX-License-Identifier: MIT
 *
 * A span over from..to is the piece of the curve plus d E(t). The cubic E approximates the unit
 * normal N of the piece: it has N and N' at both ends. With T the unit tangent and theta' the speed
 * of its angle, N' = -theta' T:
 *
 *     E0 = N(0)   E1 = N(0) - theta'(0) / 3 T(0)   E2 = N(1) + theta'(1) / 3 T(1)   E3 = N(1)
 *
 * The direction is that of H, the derivative without its zeros at 0 and 1 (coincident control
 * points), computed in loft_acc2. With H of degree m and coefficients h0..hm on the span, theta'(0)
 * = m (h0 x h1) / |h0|^2.
 *
 * Proof of a span. E = x T + (1 + y) N. Both deviations follow from polynomials, which are bounded
 * by their coefficients:
 *
 *     p = <E, H>, degree 3 + m:        |x| <= max |p_k| / min |H|
 *     q = <E, E> - 1, degree 6:        (1 + y)^2 = 1 + q - x^2,  so
 *                                      |y| <= (|q| + x^2) 9/16  for |q| + x^2 <= 1/4
 *
 * min |H| is at least the smallest of <h_j, T(0) + T(1)> / 2. The span is good if (|x| + |y|) |d|
 * is below tol minus rounding. E equals N with its derivative at both ends, so |x| and |y| decrease
 * with the fourth power of the length.
 *
 * Rounding, q16 (f32 likewise): T and the h_j are units, off by 2^-25 per axis. So p_k is off by
 * less than 2^-22.8, which with min |H| >= 1/8 of max |h_j| gives less than 2^-19.8 in x; q is off
 * by 2^-22. The margin is 2^-19 of d. The control points are rounded once: sqrt(2) / 2 LSB, within
 * a margin of 2.
 *
 * Range: on each span h is scaled to 2^27 .. 2^28, E and T are below 2, d E is below 2^16.
 *
 * Stretches left out. As a complex number H(t) = c (t - z_1) .. (t - z_m), m <= 2. With z_j = x_j +
 * i y_j
 *
 *     theta' = sum y_j / ((t - x_j)^2 + y_j^2),   a term is at most 1 / (2 |t - x_j|)
 *
 * The curve turns fast near x_1 and x_2 and nowhere else: there it has a cusp, or nearly one. A
 * span of one step of 2^-24 is good if both x_j are D >= 15 steps away from it. Let the step be the
 * unit. The k-th derivative of theta is at most 1, 1.3, 2.9, 9.4 over D^k for k = 1..4: twice the
 * maximum of (k-1)! cos^k(f) sin(kf). So N'''' is at most 17.1 / D^4 along T and 16.8 / D^4 along
 * N. With R = s^2 (1-s)^2, where s is 0..1 on the span:
 *
 *     p = R (10 p_2 (1-s) + 10 p_3 s) = <E - N, H> and |E - N| <= R |N''''| / 24. So
 *         |p_k| <= 18.3 / 240 / D^4 max |H|, since T turns by 1/D between the places. Further
 *         max |H| <= (1 + 1/D)^2 min |H|, and |x| <= 0.1 / D^4.
 *     q_2 and q_3 follow from theta' at the ends, mu - nu and mu + nu, and from the angle mu + e
 *         between them. Here mu <= 1 / D, |nu| <= 0.65 / D^2, |e| <= 2.9 / 12 / D^3. To the fourth
 *         order 15 q_2 = nu^2 - 4 mu e - mu^4 / 12 and 20 q_3 = 2 nu^2 - 8 mu e - mu^4 / 6.
 *         So |q_k| <= 0.15 / D^4, and |y| <= 0.09 / D^4.
 *
 * |x| + |y| <= 0.2 / D^4 < 4e-6; a search over all z_j finds 0.072 / D^4. The smallest tolerance
 * that init accepts leaves 2^-17 - 2^-19 = 5.7e-6. So steps are left out only within 15 of some
 * x_j, at most 32 for each: 2^-19 of the parameter, and 2^-18 for both.
 *
 * Elsewhere |H| >= M (15 2^-24)^2 / (1 + 2^-19) > 2^-41 M, where M is the largest of its
 * coefficients: |h_k| <= |c| R_1 R_2, with R_j the larger of |z_j| and |1 - z_j|, and R_j <= 1 + |t
 * - z_j|. The error of loft_acc2 is less than 2^-85 M, so the direction is exact to 2^-44.
 *
 * On a stretch that is left out |t - z_j| < 2^-18 for the near z_j, and the curve moves less than
 * 2^-30 M. At an end of the curve such a stretch is therefore still returned, as the curve with the
 * normal of the adjacent span. */
#include "curve/offset.h"
#include "basis/dyadic.h"   /* loft_bernstein_sub */
#include "num/acc2.h"       /* loft_acc2_lerp */

#define STEPS ((uint32_t)1 << 24)   /* of the parameter: all are exact in every number type */
#define Y     (LOFT_AXES > 1)       /* the second axis; with one axis init returns an error */
/* the smallest |h| with h scaled to 2^27 .. 2^28: 2^23. A good span has at least 2^24 */
#define SMALL (512 * loft_to_acc(LOFT_REAL(16384)))

/* A trial span. */
typedef struct {
    loft_acc  c[LOFT_AXES][4];      /* its control points, not rounded                */
    loft_acc  e[2][4];
    loft_unit h[2][3];              /* the coefficients of H, the largest of length 1 */
    loft_unit first[2], last[2];    /* T at both ends                                 */
} trial;

static loft_acc wide_unit(loft_unit t)  { return loft_acc_scale(loft_to_acc(LOFT_REAL(1)), t); }

static loft_acc cross_product(const loft_unit t[2], const loft_acc v[2])
{
    return loft_acc_scale(v[1], t[0]) - loft_acc_scale(v[0], t[1]);
}

static loft_acc dot_product(const loft_unit t[2], const loft_acc v[2])
{
    return loft_acc_scale(v[0], t[0]) + loft_acc_scale(v[1], t[1]);
}


/* The direction of travel */

static bool is_null_coefficient(const loft_offset *o, unsigned k)
{
    const loft_acc2 v[2] = { o->h[0][k], o->h[1][k] };
    loft_acc any[2];

    return !loft_acc2_scaled(v, 2, any);
}

/* sum C(m,j) h_j t^j (1-t)^(m-j) without h_0 is t times a sum of degree m - 1 with the coefficients
 * m / (j+1) h_(j+1). Without h_m it is (1-t) times one with m / (m-j) h_j. m is 1 or 2, so the
 * quotients are 1 or 2. False if all are 0. */
static bool divide_out_zeros(loft_offset *o)
{
    while (o->degree && (is_null_coefficient(o, 0) || is_null_coefficient(o, o->degree))) {
        const bool front = is_null_coefficient(o, 0);
        const unsigned m = o->degree;
        for (unsigned j = 0; j < m; j++)
            for (int i = 0; i < 2; i++) {
                const loft_acc2 h = o->h[i][front ? j + 1 : j];
                o->h[i][j] = m > (front ? j + 1 : m - j) ? loft_acc2_twice(h) : h;
            }
        o->degree--;
    }
    return !is_null_coefficient(o, 0);
}

enum loft_status loft_offset_init(loft_offset *o, const loft_cubic *c, loft_real distance,
                                  loft_real tol)
{
    const loft_acc d = loft_acc_abs(loft_to_acc(distance)), wide = loft_to_acc(tol);
    loft_acc size = 0;

    if (LOFT_AXES < 2 || !(tol > 0))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            if (!loft_real_valid(c->p[k].axis[i]))
                return LOFT_ERR_RANGE;
            if (loft_acc_abs(loft_to_acc(c->p[k].axis[i])) > size)
                size = loft_acc_abs(loft_to_acc(c->p[k].axis[i]));
        }
    size += 2 * d;
    const loft_acc rounding = 2 * loft_real_ulp(size);
    if (!loft_real_valid(tol) || !loft_acc_valid(size) ||
        wide < 2 * rounding + loft_acc_scale(d, LOFT_UNIT(1.0 / 131072)))
        return LOFT_ERR_RANGE;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            o->h[i][k] = loft_acc2_sub(c->p[k + 1].axis[i ? Y : 0], c->p[k].axis[i ? Y : 0]);
    o->degree = 2;
    if (!divide_out_zeros(o))
        return LOFT_SINGULAR;
    o->curve    = *c;
    o->distance = distance;
    o->limit = wide - rounding < d
                   ? wide_unit(loft_unit_ratio(wide - rounding, d) - LOFT_UNIT(1.0 / 524288))
                   : wide_unit(LOFT_UNIT(1));
    o->quarter_tol   = loft_acc_ratio(wide, 4);
    o->direction      = 0;
    o->at       = 0;
    return LOFT_OK;
}


/* A trial span */

/* A blossom of H: k of its arguments are `to`, the others are `from`. */
static loft_acc2 blossom_of(const loft_offset *o, int axis, unsigned k, loft_unit from,
                            loft_unit to)
{
    loft_acc2 row[3] = { o->h[axis][0], o->h[axis][1], o->h[axis][2] };

    for (unsigned left = o->degree; left > 0; left--)
        for (unsigned j = 0; j < left; j++)
            row[j] = loft_acc2_lerp(row[j], row[j + 1], left > k ? from : to);
    return row[0];
}

/* T from H; false if H is 0. */
static bool tangent_of(const loft_acc2 v[2], loft_unit out[2])
{
    loft_acc h[2];

    if (!loft_acc2_scaled(v, 2, h))
        return false;
    const loft_acc length = loft_acc_hypot(h, 2);
    for (int i = 0; i < 2; i++)
        out[i] = loft_unit_ratio(h[i], length);
    return true;
}

/* The tangents, which are the same for all spans that meet, and H in units. False if H has no
 * direction at an end, or is much longer elsewhere. */
static bool aim_tangents(const loft_offset *o, loft_unit from, loft_unit to, trial *r,
                         loft_acc h[2][3], loft_acc length[3])
{
    const unsigned m = o->degree;
    loft_acc2 coefficient[6];
    loft_acc all[6], most = 0;

    for (unsigned k = 0; k < 2 * m + 2; k++)
        coefficient[k] = blossom_of(o, (int)(k % 2), k / 2, from, to);
    if (!loft_acc2_scaled(coefficient, (int)(2 * m + 2), all))
        return false;
    for (unsigned j = 0; j <= m; j++) {
        h[0][j] = all[2 * j];
        h[1][j] = all[2 * j + 1];
        length[j] = loft_acc_hypot(&all[2 * j], 2);
        if (length[j] > most)
            most = length[j];
    }
    if (length[0] < SMALL || length[m] < SMALL)
        return false;
    for (int i = 0; i < 2; i++)
        for (unsigned j = 0; j <= m; j++)
            r->h[i][j] = loft_unit_ratio(h[i][j], most);
    return tangent_of(coefficient, r->first) && tangent_of(&coefficient[2 * m], r->last);
}

/* E from the tangents and the turning at both ends, at most m radians each. */
static bool turn_normal(const loft_offset *o, trial *r, loft_acc h[2][3], const loft_acc length[3])
{
    const unsigned m = o->degree;
    const loft_acc second[2] = { h[0][m ? 1 : 0], h[1][m ? 1 : 0] },
                   last_but_one[2] = { h[0][m ? m - 1 : 0], h[1][m ? m - 1 : 0] };
    const loft_acc x0 = cross_product(r->first, second), x1 = -cross_product(r->last, last_but_one);

    if (loft_acc_abs(x0) > length[0] || loft_acc_abs(x1) > length[m])
        return false;
    const loft_unit turn0 = loft_unit_ratio(x0, length[0]), turn1 = loft_unit_ratio(x1, length[m]);
    for (int i = 0; i < 2; i++) {
        const loft_acc n0 = i ? wide_unit(r->first[0]) : -wide_unit(r->first[1]),
                       t0 = wide_unit(r->first[i]);
        const loft_acc n1 = i ? wide_unit(r->last[0]) : -wide_unit(r->last[1]),
                       t1 = wide_unit(r->last[i]);
        r->e[i][0] = n0;
        r->e[i][1] = n0 - loft_acc_ratio((int32_t)m * loft_acc_scale(t0, turn0), 3);
        r->e[i][2] = n1 + loft_acc_ratio((int32_t)m * loft_acc_scale(t1, turn1), 3);
        r->e[i][3] = n1;
    }
    return true;
}

/* The control points from E. */
static void place_points(const loft_offset *o, loft_unit from, loft_unit to, trial *r)
{
    loft_acc p[4];

    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 4; k++)
            p[k] = loft_to_acc(o->curve.p[k].axis[i]);
        loft_bernstein_sub(p, 3, from, to, r->c[i]);
    }
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            r->c[i ? Y : 0][k] += loft_acc_mul(r->e[i][k], o->distance);
}

static bool try_span(const loft_offset *o, uint32_t start, uint32_t end, trial *r)
{
    const loft_unit from = loft_unit_of(start, STEPS), to = loft_unit_of(end, STEPS);
    loft_acc h[2][3], length[3];

    if (!aim_tangents(o, from, to, r, h, length) || !turn_normal(o, r, h, length))
        return false;
    place_points(o, from, to, r);
    return true;
}

/* The span with the constant normal at `where`. H is not 0 there, since it is an end of a good
 * span; or it is 0. */
static void hold_normal(const loft_offset *o, uint32_t start, uint32_t end, uint32_t where,
                        trial *r)
{
    const loft_unit at = loft_unit_of(where, STEPS);
    const loft_acc2 h[2] = { blossom_of(o, 0, 0, at, at), blossom_of(o, 1, 0, at, at) };
    loft_unit t[2];

    if (!tangent_of(h, t)) {
        t[0] = LOFT_UNIT(1);
        t[1] = 0;
    }
    for (int k = 0; k < 4; k++) {
        r->e[0][k] = -wide_unit(t[1]);
        r->e[1][k] = wide_unit(t[0]);
    }
    place_points(o, loft_unit_of(start, STEPS), loft_unit_of(end, STEPS), r);
}

/* The largest coefficient of <E, H>. */
static loft_acc largest_sideways(const trial *r, unsigned m)
{
    loft_acc most = 0;

    for (unsigned k = 0; k <= 3 + m; k++) {
        loft_acc sum = 0;
        for (unsigned j = k > 3 ? k - 3 : 0; j <= m && j <= k; j++)
            for (int i = 0; i < 2; i++)
                sum += loft_binomial(3, k - j) * loft_binomial(m, j) *
                       loft_acc_scale(r->e[i][k - j], r->h[i][j]);
        sum = loft_acc_abs(loft_acc_ratio(sum, loft_binomial(3 + m, k)));
        if (sum > most)
            most = sum;
    }
    return most;
}

/* The largest coefficient of <E, E> - 1. */
static loft_acc largest_outward(const trial *r)
{
    const loft_acc one = wide_unit(LOFT_UNIT(1));
    loft_acc most = 0;

    for (unsigned k = 0; k <= 6; k++) {
        loft_acc sum = 0;
        for (unsigned j = k > 3 ? k - 3 : 0; j <= 3 && j <= k; j++)
            for (int i = 0; i < 2; i++)
                sum += loft_binomial(3, k - j) * loft_binomial(3, j) *
                       loft_acc_scale(r->e[i][k - j], loft_unit_ratio(r->e[i][j], one));
        sum = loft_acc_abs(loft_acc_ratio(sum, loft_binomial(6, k)) - one);
        if (sum > most)
            most = sum;
    }
    return most;
}

/* A lower bound of |H|. */
static loft_acc smallest_speed(const trial *r, unsigned m)
{
    loft_acc least = wide_unit(LOFT_UNIT(1));

    for (unsigned j = 0; j <= m; j++) {
        const loft_acc v[2] = { wide_unit(r->h[0][j]), wide_unit(r->h[1][j]) };
        const loft_acc forward = loft_acc_ratio(dot_product(r->first, v) + dot_product(r->last, v),
                                                2);
        if (forward < least)
            least = forward;
    }
    return least;
}

/* True if the span is within the tolerance. */
static bool is_span_close(const loft_offset *o, const trial *r)
{
    const loft_acc quarter = wide_unit(LOFT_UNIT(0.25)), p = largest_sideways(r, o->degree),
                   q = largest_outward(r), least = smallest_speed(r, o->degree);

    if (least < loft_acc_ratio(quarter, 2) || p > loft_acc_ratio(least, 4) ||
        q > quarter - loft_acc_ratio(quarter, 4))
        return false;
    const loft_unit x = loft_unit_ratio(p, least);
    const loft_acc y = loft_acc_ratio(9 * (q + loft_acc_scale(wide_unit(x), x)), 16);
    return wide_unit(x) + y <= o->limit;
}


/* Cusps */

/* The direction of the offset at the start or the end of the span, with a leg longer than `least`:
 * 1 forwards, -1 backwards. */
static int run_direction(const trial *r, int end, loft_acc least)
{
    const loft_acc leg[2] = { r->c[0][2 * end + 1] - r->c[0][2 * end],
                              r->c[Y][2 * end + 1] - r->c[Y][2 * end] };
    const loft_acc forward = dot_product(end ? r->last : r->first, leg);

    return forward > least ? 1 : forward < -least ? -1 : 0;
}

/* The same at a place between `start` and `end`. The error of a leg does not shrink with the span,
 * so the longer part is used. */
static int run_direction_at(const loft_offset *o, uint32_t start, uint32_t at, uint32_t end,
                            loft_acc least)
{
    const bool before = at - start >= end - at;
    trial r;

    return try_span(o, before ? start : at, before ? at : end, &r)
               ? run_direction(&r, before, least)
               : 0;
}

/* The first step between low and high where the offset of start .. end no longer runs as at
 * `low`. */
static uint32_t find_cusp(const loft_offset *o, uint32_t start, uint32_t end, uint32_t low,
                          uint32_t high, int direction)
{
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (run_direction_at(o, start, middle, end, 0) == -direction)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* The end of the span from `start` to `end` if the offset turns back: *direction is how it runs up
 * to there. The direction is tested at the ends of the quarters. Where it is unclear, the previous
 * one continues, and a sudden change counts as an earlier one. */
static uint32_t span_until_cusp(const loft_offset *o, const trial *r, uint32_t start, uint32_t end,
                                int *direction)
{
    const int first = run_direction(r, 0, o->quarter_tol);
    uint32_t low = start;

    *direction = first ? first : o->direction;
    for (uint32_t quarter = 1; quarter <= 4; quarter++) {
        const uint32_t at = start + (uint32_t)((uint64_t)(end - start) * quarter / 4);
        const int then = quarter == 4 ? run_direction(r, 1, o->quarter_tol)
                         : at > start ? run_direction_at(o, start, at, end, o->quarter_tol)
                                      : 0;
        if (*direction && then == -*direction) {
            const uint32_t to = find_cusp(o, start, end, low, at, *direction);
            if (first || to - start > (end - start) / 64)
                return to;
        }
        if (then) {
            *direction = then;
            low = at;
        }
    }
    return end;
}


/* The end of the largest dyadic span from `start` that is close enough, or of its part before a
 * cusp; 0 if there is none. *direction is how it runs, *next how the following span does. */
static uint32_t longest_span(const loft_offset *o, uint32_t start, trial *r, int *direction,
                             int *next)
{
    for (uint32_t width = STEPS, before = 0; width; width /= 2) {
        const uint32_t end = (start | (width - 1)) + 1;

        if (end == before)
            continue;
        before = end;
        if (!try_span(o, start, end, r) || !is_span_close(o, r))
            continue;
        const uint32_t to = span_until_cusp(o, r, start, end, direction);
        *next = to == end ? *direction : -*direction;
        if (to == end || (try_span(o, start, to, r) && is_span_close(o, r)))
            return to;
    }
    return 0;
}

static void give_span(loft_offset *o, const trial *r, uint32_t start, uint32_t end, int direction,
                      loft_offset_span *out)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out->curve.p[k].axis[i] = loft_acc_round(r->c[i][k]);
    out->from   = loft_unit_of(start, STEPS);
    out->to     = loft_unit_of(end, STEPS);
    out->behind = direction < 0;
    out->apart  = start > o->at;
    o->at = end;
}

bool loft_offset_next(loft_offset *o, loft_offset_span *out)
{
    uint32_t start = o->at, end = 0;
    int direction = o->direction, next = o->direction;
    trial r;

    if (start == STEPS)
        return false;
    for (; start < STEPS && !end; start += end ? 0 : 1)
        end = longest_span(o, start, &r, &direction, &next);
    if (end && (o->at > 0 || start == 0)) {
        o->direction = (int8_t)next;
        give_span(o, &r, start, end, direction, out);
    } else {                            /* at the start, up to the first span; or the rest at the
                                         * end */
        hold_normal(o, o->at, start, end ? start : o->at, &r);
        give_span(o, &r, o->at, start, end ? direction : o->direction, out);
    }
    return true;
}
