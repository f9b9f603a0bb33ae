/* lib/polygon/weighted_sum.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/weighted_sum.h"
#include "curve/rational.h"     /* loft_rational_eval, loft_bezier_eval: the edges as curves */

void loft_weighted_sum_start(loft_weighted_sum *b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        b->x[i] = loft_sci_zero();
    b->w = loft_sci_zero();
}

void loft_weighted_sum_add(loft_weighted_sum *b, const loft_vec *p, loft_sci weight)
{
    for (int i = 0; i < LOFT_AXES; i++)
        b->x[i] = loft_sci_add(b->x[i], loft_sci_mul(weight, loft_sci_from_real(p->axis[i])));
    b->w = loft_sci_add(b->w, weight);
}

void loft_weighted_sum_join(loft_weighted_sum *b, const loft_weighted_sum *other, loft_sci factor)
{
    for (int i = 0; i < LOFT_AXES; i++)
        b->x[i] = loft_sci_add(b->x[i], loft_sci_mul(factor, other->x[i]));
    b->w = loft_sci_add(b->w, loft_sci_mul(factor, other->w));
}

enum loft_status loft_weighted_sum_point(const loft_weighted_sum *b, loft_vec *out)
{
    loft_acc x[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_sci_to_acc(b->x[i], &x[i]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_weighted_sum_project(const loft_weighted_sum *b, loft_vec *out)
{
    loft_weighted_sum quotient = *b;

    if (loft_sci_sign(b->w) == 0)
        return LOFT_SINGULAR;
    for (int i = 0; i < LOFT_AXES; i++)
        quotient.x[i] = loft_sci_div(b->x[i], b->w);
    return loft_weighted_sum_point(&quotient, out);
}

/* The point as curve/ computes it, for a t that loft_unit holds. */
static enum loft_status curve_point(const loft_vec p[], const loft_real w[], unsigned degree,
                                    loft_unit t, loft_vec *out)
{
    loft_weighted weighted[LOFT_DEGREE_MAX + 1];
    loft_rational r;
    loft_bezier b;

    if (!w) {
        const enum loft_status status = loft_bezier_init(&b, p, degree);
        if (status == LOFT_OK)
            *out = loft_bezier_eval(&b, t);
        return status;
    }
    for (unsigned k = 0; k <= degree; k++) {
        weighted[k].p = p[k];
        weighted[k].w = w[k];
    }
    const enum loft_status status = loft_rational_init(&r, weighted, degree);
    if (status == LOFT_OK)
        *out = loft_rational_eval(&r, t);
    return status;
}

/* The weights are C(degree, k) t^k (1 - t)^(degree - k). All are positive, and each errs by 2
 * degree + 2 roundings. */
enum loft_status loft_weighted_sum_curve(const loft_vec p[], const loft_real w[], unsigned degree,
                                         const loft_sci share[2], loft_vec *out)
{
    loft_weighted_sum sum;
    loft_unit t;

    if (loft_sci_is_unit(share[1], &t))
        return curve_point(p, w, degree, t, out);
    loft_weighted_sum_start(&sum);
    for (unsigned k = 0; k <= degree; k++) {
        loft_sci weight = loft_sci_mul(loft_sci_pow(share[0], degree - k),
                                       loft_sci_pow(share[1], k));
        weight = loft_sci_mul(weight, loft_sci_from_int(loft_binomial(degree, k)));
        loft_weighted_sum_add(&sum, &p[k],
                              w ? loft_sci_mul(weight, loft_sci_from_real(w[k])) : weight);
    }
    return loft_weighted_sum_project(&sum, out);
}
