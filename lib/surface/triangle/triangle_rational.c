/* lib/surface/triangle/triangle_rational.c
 * SPDX-License-Identifier: MIT
 *
 * Points: as for curves (curve/rational.c), with rows over three corners in place of two. Weights
 * are scaled to 2^14 .. 2^15. So numerators and denominators stay below 2^30 inside the triangle,
 * each row rounds them by 2^-33, and the quotient errs by n R 2^-30 LSB.
 */
#include "surface/triangle/triangle_rational.h"
#include "num/acc128.h"     /* loft_acc_project */
#include "num/sci.h"        /* loft_sci: derivatives */

#define MOST LOFT_TRIANGLE_MAX

enum loft_status loft_triangle_rational_init(loft_triangle_rational *t, const loft_weighted p[],
                                             unsigned degree)
{
    int32_t scale;

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (loft_weighted_scale(p, LOFT_TRIANGLE_POINTS(degree), &scale) != LOFT_OK)
        return LOFT_ERR_RANGE;
    t->p = p;
    t->degree = (uint8_t)degree;
    t->scale = scale;
    return LOFT_OK;
}

static loft_acc denominator(const loft_triangle_rational *t, loft_bary u)
{
    const unsigned degree = t->degree;
    loft_acc c[MOST];

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        c[k] = loft_to_acc(t->p[k].w * (loft_real)t->scale) * LOFT_PROJECT;
    return loft_bary_eval(c, degree, u);
}

static loft_acc numerator(const loft_triangle_rational *t, int axis, loft_bary u)
{
    const unsigned degree = t->degree;
    loft_acc c[MOST];

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++)
        c[k] = loft_prod(t->p[k].p.axis[axis], t->p[k].w * (loft_real)t->scale);
    return loft_bary_eval(c, degree, u);
}

loft_vec loft_triangle_rational_eval(const loft_triangle_rational *t, loft_bary u)
{
    loft_vec v;

    u = loft_bary_clamp(u);
    const loft_acc w = denominator(t, u);
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_project(numerator(t, i, u), w);
    return v;
}


/* Derivatives
 *
 * Let x and w be the last three numerators and weights, X / W their point at u, and N, V their sums
 * with the coordinates of z. Then
 *
 *     D = n (N W - X V) / W^2
 *
 * Each row errs by at most 5 * 2^-61 of the largest value, and W by that part of itself, because it
 * is a sum of positive numbers. N / W is at most Z R P with the largest coordinate P. So in q16 D
 * errs by n Z R P (10 n + 6) 2^-61, P = 2^31 LSB. */

typedef struct {
    loft_sci u, v, w;
} weights;

static weights weights_of(loft_bary u, loft_sci sum)
{
    weights x;

    x.v = loft_sci_from_unit(u.v);
    x.w = loft_sci_from_unit(u.w);
    x.u = loft_sci_sub(loft_sci_sub(sum, x.v), x.w);
    return x;
}

static loft_sci weighted_sum(loft_sci a, loft_sci b, loft_sci c, const weights *x)
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(x->u, a), loft_sci_mul(x->v, b)),
                        loft_sci_mul(x->w, c));
}

/* The three values of the last row but one: the numerators of an axis, or the weights for axis
 * -1. */
static void last_three(const loft_triangle_rational *t, int axis, const weights *u, loft_sci out[3])
{
    loft_sci c[MOST];
    const unsigned degree = t->degree;

    for (unsigned k = 0; k < LOFT_TRIANGLE_POINTS(degree); k++) {
        c[k] = loft_sci_from_real(t->p[k].w);
        if (axis >= 0)
            c[k] = loft_sci_mul(c[k], loft_sci_from_real(t->p[k].p.axis[axis]));
    }
    for (unsigned n = degree; n > 1; n--)
        for (unsigned m = 0, p = 0; m < n; m++)
            for (unsigned k = 0; k <= m; k++, p++)
                c[p] = weighted_sum(c[p], c[p + m + 1], c[p + m + 2], u);
    for (unsigned k = 0; k < 3; k++)
        out[k] = c[k];
}

enum loft_status loft_triangle_rational_deriv(const loft_triangle_rational *t, loft_bary z,
                                              loft_bary u, loft_vec *out)
{
    const weights at = weights_of(u, loft_sci_one()), toward = weights_of(z, loft_sci_zero());
    loft_acc d[LOFT_AXES] = { 0 };
    loft_sci w[3], x[3];

    if (!loft_bary_inside(u))
        return LOFT_ERR_ARG;
    if (t->degree > 0) {
        last_three(t, -1, &at, w);
        const loft_sci sum = weighted_sum(w[0], w[1], w[2], &at),
                       slope = weighted_sum(w[0], w[1], w[2], &toward);
        const loft_sci factor = loft_sci_div(loft_sci_from_int(t->degree), loft_sci_mul(sum, sum));
        for (int i = 0; i < LOFT_AXES; i++) {
            last_three(t, i, &at, x);
            const loft_sci rise = loft_sci_mul(weighted_sum(x[0], x[1], x[2], &toward), sum);
            const loft_sci fall = loft_sci_mul(weighted_sum(x[0], x[1], x[2], &at), slope);
            if (!loft_sci_to_acc(loft_sci_mul(factor, loft_sci_sub(rise, fall)), &d[i]))
                return LOFT_ERR_RANGE;
        }
    }
    return loft_vec_round(d, out) ? LOFT_OK : LOFT_ERR_RANGE;
}
