/* lib/curve/offset.c
 * SPDX-License-Identifier: MIT
 *
 * A span over from..to is the piece of the curve plus d E(t), where the cubic E stands for the unit normal N of the
 * piece: it has N and N' at both ends. With T the unit tangent and theta' the speed of its angle, N' = -theta' T:
 *
 *     E0 = N(0)   E1 = N(0) - theta'(0) / 3 T(0)   E2 = N(1) + theta'(1) / 3 T(1)   E3 = N(1)
 *
 * The direction is that of H, the derivative without its zeros at 0 and 1 (coincident control points) and
 * scaled to a convenient size; with H of degree m and coefficients h0..hm, theta'(0) = m (h0 x h1) / |h0|^2.
 *
 * Proof of a span. E = x T + (1 + y) N. Both deviations follow from polynomials whose coefficients bound them:
 *
 *     p = <E, H>, degree 3 + m:        |x| <= max |p_k| / min |H|
 *     q = <E, E> - 1, degree 6:        (1 + y)^2 = 1 + q - x^2,  so  |y| <= (|q| + x^2) 9/16  for |q| + x^2 <= 1/4
 *
 * min |H| is at least the least of <h_j, T(0) + T(1)> / 2. The span is good when (|x| + |y|) |d| is below tol less
 * rounding; as E meets N with its derivative at both ends, |x| and |y| fall with the fourth power of the length.
 *
 * Rounding, q16 (f32 the same): T and the h_j are units, off by 2^-25 per axis; so p_k is off by less than 2^-22.8, which
 * with min |H| >= 1/8 of max |h_j| makes less than 2^-19.8 in x, and q by 2^-22. 2^-19 of d is set aside. The control points are
 * rounded once: sqrt(2) / 2 LSB, of 2 set aside.
 *
 * Room: h is scaled to 2^27 .. 2^28, E and T are below 2, d E below 2^16. */
#include "curve/offset.h"
#include "basis/pieces.h"   /* loft_bernstein_part */

#define STEPS ((uint32_t)1 << 24)   /* of the parameter: all are exact in every number type */
#define Y     (LOFT_AXES > 1)       /* the second axis; with one, init refuses              */
#define LARGE (8192 * loft_wide(LOFT_REAL(16384)))  /* of H: 2^27 */
#define SMALL loft_wide(LOFT_REAL(0.0625))          /* its direction is good to 2^-25 from here on */

/* A span on trial. */
typedef struct {
    loft_acc  c[LOFT_AXES][4];      /* its control points, not rounded                */
    loft_acc  e[2][4];
    loft_unit h[2][3];              /* the coefficients of H, the largest of length 1 */
    loft_unit first[2], last[2];    /* T at both ends                                 */
} trial;

static loft_acc wide_unit(loft_unit t)  { return loft_acc_scale(loft_wide(LOFT_REAL(1)), t); }

static loft_acc cross(const loft_unit t[2], const loft_acc v[2])
{
    return loft_acc_scale(v[1], t[0]) - loft_acc_scale(v[0], t[1]);
}

static loft_acc dot(const loft_unit t[2], const loft_acc v[2])
{
    return loft_acc_scale(v[0], t[0]) + loft_acc_scale(v[1], t[1]);
}


/* The direction of travel */

static bool is_null(const loft_offset *o, unsigned k)
{
    return !(loft_acc_size(o->h[0][k]) > 0) && !(loft_acc_size(o->h[1][k]) > 0);
}

/* sum C(m,j) h_j t^j (1-t)^(m-j) without h_0 is t times a sum of degree m - 1 with coefficients m / (j+1) h_(j+1); without
 * h_m it is (1-t) times one with m / (m-j) h_j. m is 1 or 2: the quotients are whole. */
static void divide(loft_offset *o)
{
    while (o->degree && (is_null(o, 0) || is_null(o, o->degree))) {
        const bool front = is_null(o, 0);
        const int32_t m = o->degree;
        for (int32_t j = 0; j < m; j++)
            for (int i = 0; i < 2; i++)
                o->h[i][j] = front ? m / (j + 1) * o->h[i][j + 1] : m / (m - j) * o->h[i][j];
        o->degree--;
    }
}

/* The largest component to 2^27 .. 2^28; exact. False when all are 0. */
static bool normalise(loft_offset *o)
{
    loft_acc most = 0;

    for (int i = 0; i < 2; i++)
        for (int j = 0; j <= o->degree; j++)
            if (loft_acc_size(o->h[i][j]) > most)
                most = loft_acc_size(o->h[i][j]);
    if (!(most > 0))
        return false;
    for (; most < LARGE; most *= 2)
        for (int j = 0; j <= o->degree; j++) {
            o->h[0][j] *= 2;
            o->h[1][j] *= 2;
        }
    for (; most >= 2 * LARGE; most = loft_acc_ratio(most, 2))
        for (int j = 0; j <= o->degree; j++) {
            o->h[0][j] = loft_acc_ratio(o->h[0][j], 2);
            o->h[1][j] = loft_acc_ratio(o->h[1][j], 2);
        }
    return true;
}

enum loft_status loft_offset_init(loft_offset *o, const loft_cubic *c, loft_real distance, loft_real tol)
{
    const loft_acc d = loft_acc_size(loft_wide(distance)), wide = loft_wide(tol);
    loft_acc size = 0;

    if (LOFT_AXES < 2 || !(tol > 0))
        return LOFT_ERR_ARG;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            if (!loft_real_valid(c->p[k].axis[i]))
                return LOFT_ERR_RANGE;
            if (loft_acc_size(loft_wide(c->p[k].axis[i])) > size)
                size = loft_acc_size(loft_wide(c->p[k].axis[i]));
        }
    size += 2 * d;
    const loft_acc rounding = 2 * loft_real_grain(size);
    if (!loft_real_valid(tol) || !loft_acc_fits(size) || wide < 2 * rounding + loft_acc_scale(d, LOFT_UNIT(1.0 / 131072)))
        return LOFT_ERR_RANGE;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            o->h[i][k] = loft_wide(c->p[k + 1].axis[i ? Y : 0]) - loft_wide(c->p[k].axis[i ? Y : 0]);
    o->degree = 2;
    divide(o);
    if (!normalise(o))
        return LOFT_SINGULAR;
    o->curve    = *c;
    o->distance = distance;
    o->limit    = wide - rounding < d ? wide_unit(loft_unit_ratio(wide - rounding, d) - LOFT_UNIT(1.0 / 524288)) : wide_unit(LOFT_UNIT(1));
    o->hardly   = loft_acc_ratio(wide, 4);
    o->way      = 0;
    o->apart    = false;
    o->at       = 0;
    return LOFT_OK;
}


/* A span on trial */

/* Tangents, and H in units. False where H is too short to have a direction, or turns too far. */
static bool aim(const loft_offset *o, loft_unit from, loft_unit to, trial *r, loft_acc h[2][3], loft_acc length[3])
{
    const unsigned m = o->degree;
    loft_acc most = 0;

    for (int i = 0; i < 2; i++)
        loft_bernstein_part(o->h[i], m, from, to, h[i]);
    for (unsigned j = 0; j <= m; j++) {
        const loft_acc v[2] = { h[0][j], h[1][j] };
        length[j] = loft_acc_hypot(v, 2);
        if (length[j] > most)
            most = length[j];
    }
    if (length[0] < SMALL || length[m] < SMALL)
        return false;
    for (int i = 0; i < 2; i++) {
        for (unsigned j = 0; j <= m; j++)
            r->h[i][j] = loft_unit_ratio(h[i][j], most);
        r->first[i] = loft_unit_ratio(h[i][0], length[0]);
        r->last[i]  = loft_unit_ratio(h[i][m], length[m]);
    }
    return true;
}

/* E from the tangents and the turning at both ends, at most m radians each. */
static bool turn(const loft_offset *o, trial *r, loft_acc h[2][3], const loft_acc length[3])
{
    const unsigned m = o->degree;
    const loft_acc second[2] = { h[0][m ? 1 : 0], h[1][m ? 1 : 0] }, last_but_one[2] = { h[0][m ? m - 1 : 0], h[1][m ? m - 1 : 0] };
    const loft_acc x0 = cross(r->first, second), x1 = -cross(r->last, last_but_one);

    if (loft_acc_size(x0) > length[0] || loft_acc_size(x1) > length[m])
        return false;
    const loft_unit turn0 = loft_unit_ratio(x0, length[0]), turn1 = loft_unit_ratio(x1, length[m]);
    for (int i = 0; i < 2; i++) {
        const loft_acc n0 = i ? wide_unit(r->first[0]) : -wide_unit(r->first[1]), t0 = wide_unit(r->first[i]);
        const loft_acc n1 = i ? wide_unit(r->last[0]) : -wide_unit(r->last[1]), t1 = wide_unit(r->last[i]);
        r->e[i][0] = n0;
        r->e[i][1] = n0 - loft_acc_ratio((int32_t)m * loft_acc_scale(t0, turn0), 3);
        r->e[i][2] = n1 + loft_acc_ratio((int32_t)m * loft_acc_scale(t1, turn1), 3);
        r->e[i][3] = n1;
    }
    return true;
}

static bool try_span(const loft_offset *o, uint32_t start, uint32_t end, trial *r)
{
    const loft_unit from = loft_unit_of(start, STEPS), to = loft_unit_of(end, STEPS);
    loft_acc h[2][3], length[3], p[4];

    if (!aim(o, from, to, r, h, length) || !turn(o, r, h, length))
        return false;
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 4; k++)
            p[k] = loft_wide(o->curve.p[k].axis[i]);
        loft_bernstein_part(p, 3, from, to, r->c[i]);
    }
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            r->c[i ? Y : 0][k] += loft_acc_mul(r->e[i][k], o->distance);
    return true;
}

/* The largest coefficient of <E, H>. */
static loft_acc sideways(const trial *r, unsigned m)
{
    loft_acc most = 0;

    for (unsigned k = 0; k <= 3 + m; k++) {
        loft_acc sum = 0;
        for (unsigned j = k > 3 ? k - 3 : 0; j <= m && j <= k; j++)
            for (int i = 0; i < 2; i++)
                sum += loft_binomial(3, k - j) * loft_binomial(m, j) * loft_acc_scale(r->e[i][k - j], r->h[i][j]);
        sum = loft_acc_size(loft_acc_ratio(sum, loft_binomial(3 + m, k)));
        if (sum > most)
            most = sum;
    }
    return most;
}

/* The largest coefficient of <E, E> - 1. */
static loft_acc outward(const trial *r)
{
    const loft_acc one = wide_unit(LOFT_UNIT(1));
    loft_acc most = 0;

    for (unsigned k = 0; k <= 6; k++) {
        loft_acc sum = 0;
        for (unsigned j = k > 3 ? k - 3 : 0; j <= 3 && j <= k; j++)
            for (int i = 0; i < 2; i++)
                sum += loft_binomial(3, k - j) * loft_binomial(3, j) * loft_acc_scale(r->e[i][k - j], loft_unit_ratio(r->e[i][j], one));
        sum = loft_acc_size(loft_acc_ratio(sum, loft_binomial(6, k)) - one);
        if (sum > most)
            most = sum;
    }
    return most;
}

/* The least of H, at least. */
static loft_acc slowest(const trial *r, unsigned m)
{
    loft_acc least = wide_unit(LOFT_UNIT(1));

    for (unsigned j = 0; j <= m; j++) {
        const loft_acc v[2] = { wide_unit(r->h[0][j]), wide_unit(r->h[1][j]) };
        const loft_acc forward = loft_acc_ratio(dot(r->first, v) + dot(r->last, v), 2);
        if (forward < least)
            least = forward;
    }
    return least;
}

/* Is the span within the tolerance? */
static bool is_close(const loft_offset *o, const trial *r)
{
    const loft_acc quarter = wide_unit(LOFT_UNIT(0.25)), p = sideways(r, o->degree), q = outward(r), least = slowest(r, o->degree);

    if (least < loft_acc_ratio(quarter, 2) || p > loft_acc_ratio(least, 4) || q > quarter - loft_acc_ratio(quarter, 4))
        return false;
    const loft_unit x = loft_unit_ratio(p, least);
    const loft_acc y = loft_acc_ratio(9 * (q + loft_acc_scale(wide_unit(x), x)), 16);
    return wide_unit(x) + y <= o->limit;
}


/* Cusps */

/* Does the offset run forwards (1) or backwards (-1) at the start or the end of the span, with a leg beyond `least`? */
static int runs(const trial *r, int end, loft_acc least)
{
    const loft_acc leg[2] = { r->c[0][2*end + 1] - r->c[0][2*end], r->c[Y][2*end + 1] - r->c[Y][2*end] };
    const loft_acc forward = dot(end ? r->last : r->first, leg);

    return forward > least ? 1 : forward < -least ? -1 : 0;
}

static int runs_at(const loft_offset *o, uint32_t end)
{
    trial r;
    return try_span(o, o->at, end, &r) ? runs(&r, 1, o->hardly) : 0;
}

/* The first step at which the offset no longer runs as at `low`. */
static uint32_t cusp(const loft_offset *o, uint32_t low, uint32_t high, int way)
{
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        trial r;
        if (try_span(o, o->at, middle, &r) && runs(&r, 1, 0) == -way)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* Where the span from o->at to `end` is to end because the offset turns back; *way is how it runs up to there. At the
 * ends of its quarters is seen how it runs, and where hardly, as before; a change at once then happened before. */
static uint32_t until_cusp(const loft_offset *o, const trial *r, uint32_t end, int *way)
{
    const int start = runs(r, 0, o->hardly);
    uint32_t low = o->at;

    *way = start ? start : o->way;
    for (uint32_t quarter = 1; quarter <= 4; quarter++) {
        const uint32_t at = o->at + (uint32_t)((uint64_t)(end - o->at) * quarter / 4);
        const int then = quarter == 4 ? runs(r, 1, o->hardly) : at > o->at ? runs_at(o, at) : 0;
        if (*way && then == -*way) {
            const uint32_t to = cusp(o, low, at, *way);
            if (start || to - o->at > (end - o->at) / 64)
                return to;
        }
        if (then) {
            *way = then;
            low = at;
        }
    }
    return end;
}


static void give(loft_offset *o, const trial *r, uint32_t end, int way, loft_offset_span *out)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out->curve.p[k].axis[i] = loft_acc_round(r->c[i][k]);
    out->from   = loft_unit_of(o->at, STEPS);
    out->to     = loft_unit_of(end, STEPS);
    out->behind = way < 0;
    out->apart  = o->apart;
    o->apart = false;
    o->at    = end;
}

/* The largest dyadic interval that starts here and is close enough, or what a cusp leaves of it. */
static bool reach(loft_offset *o, loft_offset_span *out)
{
    for (uint32_t width = STEPS, before = 0; width; width /= 2) {
        const uint32_t end = (o->at | (width - 1)) + 1;
        trial r;
        int way;

        if (end == before)
            continue;
        before = end;
        if (!try_span(o, o->at, end, &r) || !is_close(o, &r))
            continue;
        const uint32_t to = until_cusp(o, &r, end, &way);
        if (to == end || (try_span(o, o->at, to, &r) && is_close(o, &r))) {
            give(o, &r, to, way, out);
            o->way = (int8_t)(to == end ? way : -way);
            return true;
        }
    }
    return false;
}

bool loft_offset_next(loft_offset *o, loft_offset_span *out)
{
    while (o->at < STEPS) {
        if (reach(o, out))
            return true;
        o->apart = true;
        o->at++;
    }
    return false;
}
