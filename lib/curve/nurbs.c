/* lib/curve/nurbs.c
 * SPDX-License-Identifier: MIT
 *
 * As in rational.c, numerator x and denominator w' are separate splines on the same knots, with one
 * scale for all spans:
 *
 *     x_k = s w_k p_k         w'_k = 2^15 s w_k         point = 2^15 x / w'
 *     |x_k|, w'_k < 2^30
 *
 * No row leaves the range, since each is an average. Each rounds x and w' by 2^-33. The smallest w'
 * is 2^29 / R, so a quotient is off by degree R 2^-30 LSB, and its rounding adds 1/2. In floats the
 * denominator is off by 5 degree roundings of itself, since all its terms are positive. The
 * numerator is off by as many of the largest coordinate times the denominator, and four more
 * operations round.
 */
#include "curve/nurbs.h"
#include "num/acc128.h"           /* loft_acc_project, loft_acc128_slope */

#define POINTS (LOFT_DEGREE_MAX + 1)

/* Each single point is a rational curve of degree 0 with the scale of its weight. The largest
 * weight has the smallest scale. */
enum loft_status loft_nurbs_init(loft_nurbs *n, const loft_weighted p[], unsigned points,
                                 const loft_real knots[], unsigned degree)
{
    int32_t scale = INT32_MAX;
    loft_knots checked;
    enum loft_status status = loft_knots_init(&checked, knots, points, degree);

    for (unsigned k = 0; k < points && status == LOFT_OK; k++) {
        loft_rational one = { NULL, 0, 0 };
        status = loft_rational_init(&one, &p[k], 0);
        if (one.scale < scale)
            scale = one.scale;
    }
    if (status != LOFT_OK)
        return status;
    n->p = p;
    n->knots = checked;
    n->scale = scale;
    return LOFT_OK;
}

static loft_acc denominator(const loft_nurbs *n, unsigned k)
{
    return loft_to_acc(n->p[k].w * (loft_real)n->scale) * LOFT_PROJECT;
}

static loft_acc numerator(const loft_nurbs *n, unsigned k, int axis)
{
    return loft_prod(n->p[k].p.axis[axis], n->p[k].w * (loft_real)n->scale);
}

static void denominators(const loft_nurbs *n, unsigned span, loft_acc w[])
{
    for (unsigned k = 0; k <= n->knots.degree; k++)
        w[k] = denominator(n, span - n->knots.degree + k);
}

static void numerators(const loft_nurbs *n, unsigned span, int axis, loft_acc x[])
{
    for (unsigned k = 0; k <= n->knots.degree; k++)
        x[k] = numerator(n, span - n->knots.degree + k, axis);
}

loft_vec loft_nurbs_eval(const loft_nurbs *n, loft_real u)
{
    const unsigned span = loft_knots_find(&n->knots, u);
    loft_acc c[POINTS];
    loft_vec v;

    u = loft_knots_clamp(&n->knots, u);
    denominators(n, span, c);
    const loft_acc w = loft_knots_eval(&n->knots, span, u, c);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(n, span, i, c);
        v.axis[i] = loft_acc_project(loft_knots_eval(&n->knots, span, u, c), w);
    }
    return v;
}

/* All rows except the last: c[0] and c[1] remain. */
static void last_two(const loft_nurbs *n, unsigned span, loft_real u, loft_acc128 c[])
{
    const loft_real *hi = &n->knots.k[span + 1];

    for (unsigned rows = n->knots.degree; rows > 1; rows--)
        for (unsigned j = 0; j < rows; j++)
            c[j] = loft_acc128_lerp_in(c[j], c[j + 1], u, hi[(int)j - (int)rows], hi[j]);
}

/* As loft_rational_deriv. The last row would interpolate (x0, w0) and (x1, w1) at k[s] and k[s+1],
 * with x_k = s w_k (p_k - o) and o the rounded point at u. The pairs are off by degree 2^-79 for w
 * >= 2^14 / R, the quotient rounds by 2^-33, and all is divided by h < 2^16. If the rate fits, its
 * numerator is below 2^31. */
enum loft_status loft_nurbs_deriv(const loft_nurbs *n, loft_real u, loft_vec *out)
{
    const unsigned span = loft_knots_find(&n->knots, u), degree = n->knots.degree;
    const loft_real lo = n->knots.k[span], hi = n->knots.k[span + 1];
    const loft_vec o = loft_nurbs_eval(n, u);
    loft_acc128 w[POINTS], x[POINTS];
    loft_acc c[POINTS];
    loft_vec v;

    u = loft_knots_clamp(&n->knots, u);
    denominators(n, span, c);
    for (unsigned k = 0; k <= degree; k++)
        w[k] = loft_acc128_guarded(loft_acc_ratio(c[k], LOFT_PROJECT));
    last_two(n, span, u, w);
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc d = 0;
        numerators(n, span, i, c);
        for (unsigned k = 0; k <= degree; k++)
            x[k] = loft_acc128_guarded(
                c[k] - loft_prod(o.axis[i], n->p[span - degree + k].w * (loft_real)n->scale));
        last_two(n, span, u, x);
        if (!loft_acc128_slope(x, w, loft_acc128_lerp_in(w[0], w[1], u, lo, hi), (int32_t)degree,
                               &d) ||
            !loft_acc_rate(d, loft_to_acc(hi) - loft_to_acc(lo), &v.axis[i]))
            return LOFT_ERR_RANGE;
    }
    *out = v;
    return LOFT_OK;
}

bool loft_nurbs_next(const loft_nurbs *n, unsigned *span, loft_weighted out[])
{
    const unsigned degree = n->knots.degree;
    loft_acc c[POINTS], x[POINTS], w[POINTS];

    *span = loft_knots_next(&n->knots, *span);
    if (!*span)
        return false;
    denominators(n, *span, c);
    loft_knots_bezier(&n->knots, *span, c, w);
    for (int i = 0; i < LOFT_AXES; i++) {
        numerators(n, *span, i, c);
        loft_knots_bezier(&n->knots, *span, c, x);
        for (unsigned k = 0; k <= degree; k++)
            out[k].p.axis[i] = loft_acc_project(x[k], w[k]);
    }
    loft_rational_weights(w, degree, out);
    return true;
}

/* The point between k - 1 and k; u lies between the knots lo and hi. The factor 2^15 s of the
 * weight is removed in the order in which it was applied. */
static loft_weighted point_between(const loft_nurbs *n, unsigned k, loft_real u, loft_real lo,
                                   loft_real hi)
{
    const loft_acc w = loft_acc_lerp_in(denominator(n, k - 1), denominator(n, k), u, lo, hi);
    loft_weighted q;

    q.w = loft_weight_clamp(
        loft_acc_round(loft_acc_ratio(loft_acc_ratio(w, LOFT_PROJECT), n->scale)));
    for (int i = 0; i < LOFT_AXES; i++)
        q.p.axis[i] = loft_acc_project(
            loft_acc_lerp_in(numerator(n, k - 1, i), numerator(n, k, i), u, lo, hi), w);
    return q;
}

enum loft_status loft_nurbs_insert(const loft_nurbs *n, loft_real u, loft_weighted p[],
                                   loft_real knots[])
{
    const unsigned span = loft_knots_find(&n->knots, u), degree = n->knots.degree;
    const loft_real *lo = n->knots.k, *hi = lo + degree;

    if (!loft_knots_valid(&n->knots, u))
        return LOFT_ERR_ARG;
    for (unsigned k = n->knots.points; k > span; k--)
        p[k] = n->p[k - 1];
    for (unsigned k = span; k > span - degree; k--)
        p[k] = point_between(n, k, u, lo[k], hi[k]);
    for (unsigned k = 0; k <= span - degree; k++)
        p[k] = n->p[k];
    loft_knots_insert(&n->knots, u, knots);
    return LOFT_OK;
}
