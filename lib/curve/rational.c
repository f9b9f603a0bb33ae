/* lib/curve/rational.c
 * SPDX-License-Identifier: MIT
 *
 * Numerator and denominator are polynomials of their own, evaluated wide one axis at a time, and divided once:
 *
 *     x_k = s w_k p_k         w'_k = 2^15 s w_k         point = 2^15 x / w'
 *
 * with a power of two s that brings the largest weight into 2^14 .. 2^15. In q16 then |x_k| < 2^30 and w'_k < 2^30,
 * exactly (s is whole), and in 0..1 no step leaves that range, which is what loft_acc_lerp asks for.
 *
 * Error. Each of n rows rounds x and w' by 2^-33. The smallest weight is s w >= 2^14 / R, so the quotient errs by
 *
 *     n 2^-33 / (2^14 / R)  +  2^15 n 2^-33 / (2^29 / R)  =  2 n R 2^-47        n R 2^-30 LSB,   < 0.001 for R = 2^16
 *
 * and its rounding by 1/2. In floats all terms of the denominator are positive: it errs by 3 n ulp of itself, the
 * numerator by 3 n ulp of the largest coordinate times the denominator, and four more operations round.
 */
#include "curve/rational.h"
#include "num/deep.h"   /* loft_acc_project, loft_deep_slope */

#define POINTS (LOFT_DEGREE_MAX + 1)
#define LARGEST LOFT_REAL(16384)

static bool inside(loft_unit t)
{
    return t >= 0 && t <= LOFT_UNIT(1);
}

static void denominators(const loft_rational *r, loft_acc w[])
{
    for (unsigned k = 0; k <= r->degree; k++)
        w[k] = loft_wide(r->p[k].w * (loft_real)r->scale) * LOFT_PROJECT;
}

static void numerators(const loft_rational *r, int axis, loft_acc x[])
{
    for (unsigned k = 0; k <= r->degree; k++)
        x[k] = loft_prod(r->p[k].p.axis[axis], r->p[k].w * (loft_real)r->scale);
}


/* Points */

static bool accepted(const loft_weighted *p)
{
    if (!(p->w >= LOFT_WEIGHT_MIN && p->w <= LOFT_WEIGHT_MAX))
        return false;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_real_valid(p->p.axis[i]))
            return false;
    return true;
}

enum loft_status loft_rational_init(loft_rational *r, const loft_weighted p[], unsigned degree)
{
    loft_real largest = 0;
    int32_t scale = 1;

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= degree; k++) {
        if (!accepted(&p[k]))
            return LOFT_ERR_RANGE;
        if (p[k].w > largest)
            largest = p[k].w;
    }
    for (; largest < LARGEST; largest += largest)
        scale *= 2;
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

/* All but the last step: c[0] and c[1] remain. */
static void two_of(loft_deep c[], unsigned degree, loft_unit t)
{
    for (unsigned k = degree; k > 1; k--)
        for (unsigned i = 0; i < k; i++)
            c[i] = loft_deep_lerp(c[i], c[i + 1], t);
}

/* With x_k = w_k (p_k - o), any o, and the pairs (x0, w0), (x1, w1) before the last step,
 *
 *     P' = n (x1 w0 - x0 w1) / w^2
 *
 * and with o the point at t rounded to a coordinate, x0 and x1 have opposite signs but for that rounding, so
 * nothing cancels. In q16 the x_k are whole in loft_acc, |x_k| < 2^16 2^8, and carried with 64 bits more: n rows
 * err by n 2^-97 where w >= 2^-8, and n w0 w1 / w^2 <= n 2^17, so the result errs by less than 2^-60. */
enum loft_status loft_rational_deriv(const loft_rational *r, loft_unit t, loft_vec *out)
{
    const unsigned n = r->degree;
    const loft_vec o = loft_rational_eval(r, t);
    loft_deep w[POINTS], x[POINTS];
    loft_vec v = { { 0 } };

    if (!inside(t))
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k <= n; k++)
        w[k] = loft_deep_guarded(loft_wide(r->p[k].w));
    two_of(w, n, t);
    for (int i = 0; i < LOFT_AXES && n > 0; i++) {
        loft_acc d = 0;
        for (unsigned k = 0; k <= n; k++)
            x[k] = loft_deep_guarded(loft_acc_mul(loft_wide(r->p[k].p.axis[i]) - loft_wide(o.axis[i]), r->p[k].w));
        two_of(x, n, t);
        if (!loft_deep_slope(x, w, t, (int32_t)n, &d) || !loft_acc_fits(d))
            return LOFT_ERR_RANGE;
        v.axis[i] = loft_acc_round(d);
    }
    *out = v;
    return LOFT_OK;
}


/* Pieces and other forms
 *
 * The weights of the result are written last: `out` may be the control points, of which each axis is read before it
 * is written. */

/* Two roundings of 2^-33 and one to a real. */
static loft_real unscaled(const loft_rational *r, loft_acc w)
{
    return loft_acc_round(loft_acc_ratio(loft_acc_ratio(w, LOFT_PROJECT), r->scale));
}

static void project(const loft_acc x[], const loft_acc w[], unsigned degree, int axis, loft_weighted out[])
{
    for (unsigned k = 0; k <= degree; k++)
        out[k].p.axis[axis] = loft_acc_project(x[k], w[k]);
}

/* The first value of each row goes to `left`; the last ones stay in c. */
static void halve(loft_acc c[], unsigned degree, loft_unit t, loft_acc left[])
{
    for (unsigned k = 0; k <= degree; k++) {
        left[k] = c[0];
        loft_bernstein_step(c, degree - k, t);
    }
}

enum loft_status loft_rational_split(const loft_rational *r, loft_unit t, loft_weighted left[], loft_weighted right[])
{
    const unsigned degree = r->degree;
    loft_acc w_left[POINTS], w_right[POINTS], x_left[POINTS], x_right[POINTS];

    if (!inside(t))
        return LOFT_ERR_ARG;
    denominators(r, w_right);
    halve(w_right, degree, t, w_left);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(r, i, x_right);
        halve(x_right, degree, t, x_left);
        project(x_left, w_left, degree, i, left);
        project(x_right, w_right, degree, i, right);
    }
    for (unsigned k = 0; k <= degree; k++) {
        left[k].w = unscaled(r, w_left[k]);
        right[k].w = unscaled(r, w_right[k]);
    }
    return LOFT_OK;
}

/* out[k] = c[from^(degree-k), to^k]: after degree - k rows at `from`, k rows at `to` in a copy. */
static void blossom(loft_acc c[], unsigned degree, loft_unit from, loft_unit to, loft_acc out[])
{
    loft_acc copy[POINTS];

    for (unsigned k = degree + 1; k-- > 0; ) {
        for (unsigned j = 0; j <= k; j++)
            copy[j] = c[j];
        out[k] = loft_bernstein_eval(copy, k, to);
        loft_bernstein_step(c, k, from);
    }
}

/* The least power of two that brings all weights to 256 at most. The smallest of them stay above 1/256, where
 * they were before: the factor 2^15 s / divisor that is left is a power of two and at least 1. */
static int32_t divisor_of(const loft_acc w[], unsigned degree)
{
    int32_t divisor = 1;

    for (unsigned k = 0; k <= degree; k++)
        while (loft_acc_ratio(w[k], divisor) > loft_wide(LOFT_WEIGHT_MAX))
            divisor *= 2;
    return divisor;
}

void loft_rational_weights(const loft_acc w[], unsigned degree, loft_weighted out[])
{
    const int32_t divisor = divisor_of(w, degree);

    for (unsigned k = 0; k <= degree; k++)
        out[k].w = loft_weight_clamp(loft_acc_round(loft_acc_ratio(w[k], divisor)));
}

enum loft_status loft_rational_part(const loft_rational *r, loft_unit from, loft_unit to, loft_weighted out[])
{
    const unsigned degree = r->degree;
    loft_acc c[POINTS], w[POINTS], x[POINTS];

    if (!inside(from) || !inside(to))
        return LOFT_ERR_ARG;
    denominators(r, c);
    blossom(c, degree, from, to, w);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(r, i, c);
        blossom(c, degree, from, to, x);
        project(x, w, degree, i, out);
    }
    loft_rational_weights(w, degree, out);
    return LOFT_OK;
}

/* b_k = k/(n+1) b_(k-1) + (1 - k/(n+1)) b_k, from the last one down, `times` times: each rounds by 2^-33. */
static void raise(loft_acc c[], unsigned degree, unsigned times)
{
    for (unsigned n = degree; n < degree + times; n++) {
        c[n + 1] = c[n];
        for (unsigned k = n; k > 0; k--)
            c[k] = loft_acc_lerp_at(c[k], c[k - 1], k, n + 1);
    }
}

enum loft_status loft_rational_raise(const loft_rational *r, unsigned times, loft_weighted out[])
{
    const unsigned degree = r->degree;
    loft_acc w[LOFT_RAISE_MAX + 1], x[LOFT_RAISE_MAX + 1];

    if (times > LOFT_RAISE_MAX - degree)
        return LOFT_ERR_ARG;
    denominators(r, w);
    raise(w, degree, times);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(r, i, x);
        raise(x, degree, times);
        project(x, w, degree + times, i, out);
    }
    for (unsigned k = 0; k <= degree + times; k++)
        out[k].w = unscaled(r, w[k]);
    return LOFT_OK;
}

loft_box loft_rational_box(const loft_rational *r)
{
    loft_box box = { r->p[0].p, r->p[0].p };

    for (unsigned k = 1; k <= r->degree; k++)
        box = loft_box_join(box, r->p[k].p);
    return box;
}
