/* lib/curve/rational.c
 * SPDX-License-Identifier: MIT
 *
 * Numerator and denominator are separate polynomials, evaluated in wide numbers one axis at a time,
 * and divided once:
 *
 *     x_k = s w_k p_k         w'_k = 2^15 s w_k         point = 2^15 x / w'
 *
 * The power of two s brings the largest weight into 2^14 .. 2^15. In q16 then |x_k| < 2^30 and w'_k
 * < 2^30, exactly (s is an integer). In 0..1 no step leaves that range, which is that of
 * loft_acc_lerp.
 *
 * Error. Each of n rows rounds x and w' by 2^-33. The smallest weight is s w >= 2^14 / R, so the
 * quotient is off by
 *
 *     n 2^-33 / (2^14 / R)  +  2^15 n 2^-33 / (2^29 / R)  =  2 n R 2^-47
 *     = n R 2^-30 LSB,   < 0.001 for R = 2^16
 *
 * and its rounding adds 1/2. In floats all terms of the denominator are positive: it is off by 3 n
 * ulp of itself, and the numerator by 3 n ulp of the largest coordinate times the denominator. Four
 * more operations round.
 *
 * Beyond the ends a row multiplies by at most L = |1 - t| + |t| <= 3, and the denominator may be
 * arbitrarily small, 0 or negative. Numbers to be divided by it are loft_acc128 with 46 guard bits,
 * |x|, w' < 2^62 2^46 3^9 < 2^123. A denominator below 1 / FLOOR of the largest weight W is
 * refused, since no bound holds for all. Rows round by (1 + L + .. + L^8) / 2 < 2^12.3 last bits,
 * of a denominator of at least 2^(61 - 20 + 46): this adds less than 2^-40 LSB to the error of a
 * point. In floats the n rows are off by 3 n L^n ulp of W, which is 3 n K ulp of the denominator,
 * with
 *
 *     K = L^n W / w(t)
 *
 * Subdivision uses the same computation inside and outside of 0..1.
 */
#include "curve/rational.h"
#include "num/acc128.h"   /* loft_acc_project, loft_acc128_slope */

#define POINTS (LOFT_DEGREE_MAX + 1)
#define LARGEST LOFT_REAL(16384)
/* Its reciprocal is the limit. In 0..1 a denominator is at least 1/65536. */
#define FLOOR 1048576

static bool parameter_inside(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

static bool parameter_valid(loft_unit t) { return t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2); }

static void denominators(const loft_rational *r, loft_acc w[])
{
    for (unsigned k = 0; k <= r->degree; k++)
        w[k] = loft_to_acc(r->p[k].w * (loft_real)r->scale) * LOFT_PROJECT;
}

static void numerators(const loft_rational *r, int axis, loft_acc x[])
{
    for (unsigned k = 0; k <= r->degree; k++)
        x[k] = loft_prod(r->p[k].p.axis[axis], r->p[k].w * (loft_real)r->scale);
}

static void guard_coefficients(const loft_acc c[], unsigned degree, loft_acc128 out[])
{
    for (unsigned k = 0; k <= degree; k++)
        out[k] = loft_acc128_guarded(c[k]);
}

/* As numerators and denominators, with guard bits; without the factor LOFT_PROJECT of w' if `by` is
 * LOFT_PROJECT. */
static void acc128_denominators(const loft_rational *r, int32_t by, loft_acc128 w[])
{
    loft_acc c[POINTS];

    denominators(r, c);
    for (unsigned k = 0; k <= r->degree; k++)
        c[k] = loft_acc_ratio(c[k], by);
    guard_coefficients(c, r->degree, w);
}

/* Relative to the coordinate `origin`: |p - origin| s w < 2^31 in q16. */
static void acc128_numerators(const loft_rational *r, int axis, loft_real origin, loft_acc128 x[])
{
    loft_acc c[POINTS];

    numerators(r, axis, c);
    for (unsigned k = 0; k <= r->degree; k++)
        c[k] -= loft_prod(origin, r->p[k].w * (loft_real)r->scale);
    guard_coefficients(c, r->degree, x);
}

static void casteljau_row(loft_acc128 c[], unsigned degree, loft_unit t)
{
    for (unsigned i = 0; i < degree; i++)
        c[i] = loft_acc128_lerp(c[i], c[i + 1], t);
}

/* The smallest valid denominator for the weights c[0..degree]. */
static loft_acc128 smallest_denominator(const loft_acc128 c[], unsigned degree)
{
    loft_acc128 most = c[0];

    for (unsigned k = 1; k <= degree; k++)
        if (loft_acc128_below(most, c[k]))
            most = c[k];
    return loft_acc128_guarded(loft_acc128_to_acc(most, FLOOR));
}


/* Points */

enum loft_status loft_weighted_scale(const loft_weighted p[], unsigned count, int32_t *scale)
{
    loft_real largest = 0;

    for (unsigned k = 0; k < count; k++) {
        if (!(p[k].w >= LOFT_WEIGHT_MIN && p[k].w <= LOFT_WEIGHT_MAX) || !loft_vec_valid(p[k].p))
            return LOFT_ERR_RANGE;
        if (p[k].w > largest)
            largest = p[k].w;
    }
    for (*scale = 1; largest < LARGEST; largest += largest)
        *scale *= 2;
    return LOFT_OK;
}

enum loft_status loft_rational_init(loft_rational *r, const loft_weighted p[], unsigned degree)
{
    int32_t scale;

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (loft_weighted_scale(p, degree + 1, &scale) != LOFT_OK)
        return LOFT_ERR_RANGE;
    r->p = p;
    r->degree = (uint8_t)degree;
    r->scale = scale;
    return LOFT_OK;
}

loft_vec loft_rational_eval(const loft_rational *r, loft_unit t)
{
    loft_acc c[POINTS];
    loft_vec v;

    t = loft_unit_clamp(t);
    denominators(r, c);
    const loft_acc w = loft_bernstein_eval(c, r->degree, t);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(r, i, c);
        v.axis[i] = loft_acc_project(loft_bernstein_eval(c, r->degree, t), w);
    }
    return v;
}

static loft_acc128 acc128_eval(loft_acc128 c[], unsigned degree, loft_unit t)
{
    for (unsigned k = degree; k > 0; k--)
        casteljau_row(c, k, t);
    return c[0];
}

enum loft_status loft_rational_extrapolate(const loft_rational *r, loft_unit t, loft_vec *out)
{
    loft_acc128 c[POINTS];
    loft_vec v;

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    acc128_denominators(r, 1, c);
    const loft_acc128 least = smallest_denominator(c, r->degree), w = acc128_eval(c, r->degree, t);
    if (loft_acc128_below(w, least))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        acc128_numerators(r, i, 0, c);
        if (!loft_acc128_rate(acc128_eval(c, r->degree, t), w, &v.axis[i]))
            return LOFT_ERR_RANGE;
    }
    *out = v;
    return LOFT_OK;
}

/* All steps except the last: c[0] and c[1] remain. */
static void last_two(loft_acc128 c[], unsigned degree, loft_unit t)
{
    for (unsigned k = degree; k > 1; k--)
        casteljau_row(c, k, t);
}

/* With x_k = s w_k (p_k - o), any o, and the pairs (x0, w0), (x1, w1) before the last step,
 *
 *     P' = n (x1 w0 - x0 w1) / w^2
 *
 * If o is the point at t rounded to a coordinate, (1 - t) x0 + t x1 is close to 0. Inside 0..1 both
 * terms then have the same sign, so nothing cancels. In q16 the pairs are off by n 2^-79 there,
 * with w >= 2^-2 and n w0 w1 / w^2 <= n 2^17, so the result is off by less than 2^-55.
 *
 * Outside, x0 / w and x1 / w are at most 2 |P'| / n plus that rounding, below 2^17, and |w0| / w
 * and |w1| / w are at most K. Each term is below 2^18 K and computed to 2^-58 of itself, so the sum
 * is off by less than 2^-24 K LSB. In floats x0 / w is off by 3 n K ulp of the largest value, times
 * K for w0 / w, times n. */
enum loft_status loft_rational_deriv(const loft_rational *r, loft_unit t, loft_vec *out)
{
    const unsigned n = r->degree;
    loft_acc128 w[POINTS], x[POINTS];
    loft_vec o, v = { { 0 } };
    const enum loft_status status = loft_rational_extrapolate(r, t, &o);

    if (status != LOFT_OK)
        return status;
    acc128_denominators(r, LOFT_PROJECT, w);
    last_two(w, n, t);
    for (int i = 0; i < LOFT_AXES && n > 0; i++) {
        loft_acc d = 0;
        acc128_numerators(r, i, o.axis[i], x);
        last_two(x, n, t);
        if (!loft_acc128_slope(x, w, loft_acc128_lerp(w[0], w[1], t), (int32_t)n, &d) ||
            !loft_acc_valid(d))
            return LOFT_ERR_RANGE;
        v.axis[i] = loft_acc_round(d);
    }
    *out = v;
    return LOFT_OK;
}


/* Pieces and other forms
 *
 * The weights of the result are written last: `out` may be the control points, of which each axis
 * is read before it is written. */

/* Two roundings of 2^-33 and one to a real. */
static loft_real unscaled_weight(const loft_rational *r, loft_acc w)
{
    return loft_acc_round(loft_acc_ratio(loft_acc_ratio(w, LOFT_PROJECT), r->scale));
}

/* One axis of the control points; false if one does not fit. */
static bool project_axis(const loft_acc128 x[], const loft_acc128 w[], unsigned degree, int axis,
                         loft_weighted out[])
{
    for (unsigned k = 0; k <= degree; k++)
        if (!loft_acc128_rate(x[k], w[k], &out[k].p.axis[axis]))
            return false;
    return true;
}

static bool denominators_valid(const loft_acc128 w[], unsigned degree, loft_acc128 least)
{
    for (unsigned k = 0; k <= degree; k++)
        if (loft_acc128_below(w[k], least))
            return false;
    return true;
}

/* The first value of each row goes to `left`; the last values remain in c. */
static void split_rows(loft_acc128 c[], unsigned degree, loft_unit t, loft_acc128 left[])
{
    for (unsigned k = 0; k <= degree; k++) {
        left[k] = c[0];
        casteljau_row(c, degree - k, t);
    }
}

/* The weights without a common factor. Inside 0..1 they are averages, which can leave the range
 * only by a last bit. */
static bool set_weights(const loft_rational *r, const loft_acc128 w[], bool means,
                        loft_weighted out[])
{
    const loft_acc128 most = loft_acc128_times(
        loft_acc128_guarded(loft_to_acc(LOFT_WEIGHT_MAX) * LOFT_PROJECT), (uint32_t)r->scale);

    for (unsigned k = 0; k <= r->degree; k++) {
        if (!means && loft_acc128_below(most, w[k]))
            return false;
        const loft_real weight = loft_acc_round(
            loft_acc_ratio(loft_acc128_to_acc(w[k], (uint32_t)r->scale), LOFT_PROJECT));
        if (!means && weight < LOFT_WEIGHT_MIN)
            return false;
        out[k].w = loft_weight_clamp(weight);
    }
    return true;
}

enum loft_status loft_rational_split(const loft_rational *r, loft_unit t, loft_weighted left[],
                                     loft_weighted right[])
{
    const unsigned degree = r->degree;
    loft_acc128 w_left[POINTS], w_right[POINTS], x_left[POINTS], x_right[POINTS];

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    acc128_denominators(r, 1, w_right);
    const loft_acc128 least = smallest_denominator(w_right, degree);
    split_rows(w_right, degree, t, w_left);
    if (!denominators_valid(w_left, degree, least) || !denominators_valid(w_right, degree, least))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        acc128_numerators(r, i, 0, x_right);
        split_rows(x_right, degree, t, x_left);
        if (!project_axis(x_left, w_left, degree, i, left) ||
            !project_axis(x_right, w_right, degree, i, right))
            return LOFT_ERR_RANGE;
    }
    return set_weights(r, w_left, parameter_inside(t), left) &&
                   set_weights(r, w_right, parameter_inside(t), right)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

/* out[k] = c[from^(degree-k), to^k]: degree - k rows at `from`, then k rows at `to` in a copy. */
static void blossom_points(loft_acc128 c[], unsigned degree, loft_unit from, loft_unit to,
                           loft_acc128 out[])
{
    loft_acc128 copy[POINTS];

    for (unsigned k = degree + 1; k-- > 0; ) {
        for (unsigned j = 0; j <= k; j++)
            copy[j] = c[j];
        out[k] = acc128_eval(copy, k, to);
        casteljau_row(c, k, from);
    }
}

/* The smallest power of two that brings all weights to at most 256. The smallest weight stays above
 * 1/256, as before: the remaining factor 2^15 s / divisor is a power of two and at least 1. */
static int32_t weight_divisor(const loft_acc w[], unsigned degree)
{
    int32_t divisor = 1;

    for (unsigned k = 0; k <= degree; k++)
        while (loft_acc_ratio(w[k], divisor) > loft_to_acc(LOFT_WEIGHT_MAX))
            divisor *= 2;
    return divisor;
}

void loft_rational_weights(const loft_acc w[], unsigned degree, loft_weighted out[])
{
    const int32_t divisor = weight_divisor(w, degree);

    for (unsigned k = 0; k <= degree; k++)
        out[k].w = loft_weight_clamp(loft_acc_round(loft_acc_ratio(w[k], divisor)));
}

/* The weights as accs below 2^30, all divided by the same power of two, which is 1 inside 0..1;
 * false if one is below 1/256 after the largest is brought into 128..256. */
static bool narrow_weights(const loft_acc128 w[], unsigned degree, bool means, loft_acc out[])
{
    const loft_acc128 limit = loft_acc128_times(loft_acc128_guarded(loft_to_acc(LARGEST)),
                                                2 * LOFT_PROJECT);
    uint32_t by = 1;

    for (unsigned k = 0; k <= degree; k++)
        while (!loft_acc128_below(w[k], loft_acc128_times(limit, by)))
            by *= 2;
    for (unsigned k = 0; k <= degree; k++)
        out[k] = loft_acc128_to_acc(w[k], by);
    const int32_t divisor = weight_divisor(out, degree);
    for (unsigned k = 0; k <= degree; k++)
        if (!means && loft_acc_round(loft_acc_ratio(out[k], divisor)) < LOFT_WEIGHT_MIN)
            return false;
    return true;
}

enum loft_status loft_rational_sub(const loft_rational *r, loft_unit from, loft_unit to,
                                   loft_weighted out[])
{
    const unsigned degree = r->degree;
    const bool means = parameter_inside(from) && parameter_inside(to);
    loft_acc128 c[POINTS], w[POINTS], x[POINTS];
    loft_acc narrowed[POINTS];

    if (!parameter_valid(from) || !parameter_valid(to))
        return LOFT_ERR_ARG;
    acc128_denominators(r, 1, c);
    const loft_acc128 least = smallest_denominator(c, degree);
    blossom_points(c, degree, from, to, w);
    if (!denominators_valid(w, degree, least) || !narrow_weights(w, degree, means, narrowed))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++) {
        acc128_numerators(r, i, 0, c);
        blossom_points(c, degree, from, to, x);
        if (!project_axis(x, w, degree, i, out))
            return LOFT_ERR_RANGE;
    }
    loft_rational_weights(narrowed, degree, out);
    return LOFT_OK;
}

/* b_k = k/(n+1) b_(k-1) + (1 - k/(n+1)) b_k, from the last one down, `times` times. Each rounds by
 * 2^-33. */
static void elevate_axis(loft_acc c[], unsigned degree, unsigned times)
{
    for (unsigned n = degree; n < degree + times; n++) {
        c[n + 1] = c[n];
        for (unsigned k = n; k > 0; k--)
            c[k] = loft_acc_lerp_at(c[k], c[k - 1], k, n + 1);
    }
}

enum loft_status loft_rational_elevate(const loft_rational *r, unsigned times, loft_weighted out[])
{
    const unsigned degree = r->degree;
    loft_acc w[LOFT_ELEVATE_MAX + 1], x[LOFT_ELEVATE_MAX + 1];

    if (times > LOFT_ELEVATE_MAX - degree)
        return LOFT_ERR_ARG;
    denominators(r, w);
    elevate_axis(w, degree, times);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(r, i, x);
        elevate_axis(x, degree, times);
        for (unsigned k = 0; k <= degree + times; k++)
            out[k].p.axis[i] = loft_acc_project(x[k], w[k]);
    }
    for (unsigned k = 0; k <= degree + times; k++)
        out[k].w = unscaled_weight(r, w[k]);
    return LOFT_OK;
}

loft_box loft_rational_box(const loft_rational *r)
{
    loft_box box = { r->p[0].p, r->p[0].p };

    for (unsigned k = 1; k <= r->degree; k++)
        box = loft_box_join(box, r->p[k].p);
    return box;
}
