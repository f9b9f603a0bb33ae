/* lib/curve/bspline.c
 * SPDX-License-Identifier: MIT
 *
 * Each axis is computed in wide numbers; basis/knots.c has the bounds.
 */
#include "curve/bspline.h"
#include "num/muldiv.h"           /* loft_acc_grow */

#define POINTS (LOFT_DEGREE_MAX + 1)

enum loft_status loft_bspline_init(loft_bspline *b, const loft_vec p[], unsigned points,
                                   const loft_real knots[], unsigned degree)
{
    loft_knots checked;
    const enum loft_status status = loft_knots_init(&checked, knots, points, degree);

    if (status != LOFT_OK)
        return status;
    for (unsigned k = 0; k < points; k++)
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    b->p = p;
    b->knots = checked;
    return LOFT_OK;
}

/* The coefficients of one axis on a span */
static void widen_axis(const loft_bspline *b, unsigned span, int axis, loft_acc c[])
{
    const loft_vec *p = &b->p[span - b->knots.degree];

    for (unsigned k = 0; k <= b->knots.degree; k++)
        c[k] = loft_to_acc(p[k].axis[axis]);
}

loft_vec loft_bspline_eval(const loft_bspline *b, loft_real u)
{
    const unsigned span = loft_knots_find(&b->knots, u);
    loft_acc c[POINTS];
    loft_vec v;

    u = loft_knots_clamp(&b->knots, u);
    for (int i = 0; i < LOFT_AXES; i++) {
        widen_axis(b, span, i, c);
        v.axis[i] = loft_acc_round(loft_knots_eval(&b->knots, span, u, c));
    }
    return v;
}

/* After degree - k rows at u, the k + 1 remaining values are the coefficients of a polynomial of
 * degree k on the same knots. Its Bernstein coefficients on the span have the constant k-th
 * difference D. The derivative is f D / h^k, computed by factors degree / h, (degree - 1) / h, ..
 * in turn. Each coefficient is off by degree 2^-33, so D by 2^k degree 2^-33. Each quotient rounds
 * by 2^-33. The following factors multiply that by at most max(1, f / h^k), since they decrease.
 * |D| <= 2^24, and no intermediate value exceeds the last one by more than 9^9 / 9!, below 2^11. If
 * one exceeds 2^26, the result does not fit either. */
enum loft_status loft_bspline_deriv(const loft_bspline *b, unsigned k, loft_real u, loft_vec *out)
{
    const unsigned span = loft_knots_find(&b->knots, u), degree = b->knots.degree;
    const loft_acc h = loft_to_acc(b->knots.k[span + 1]) - loft_to_acc(b->knots.k[span]);
    loft_knots lower = b->knots;
    loft_acc c[POINTS], piece[POINTS];
    loft_vec v = { { 0 } };

    u = loft_knots_clamp(&b->knots, u);
    lower.degree = (uint8_t)k;
    for (int i = 0; i < LOFT_AXES && k <= degree; i++) {
        widen_axis(b, span, i, c);
        for (unsigned rows = degree; rows > k; rows--)
            loft_knots_step(&b->knots, span, rows, u, c);
        loft_knots_bezier(&lower, span, c, piece);
        loft_bernstein_differences(piece, k);
        for (unsigned j = 0; j < k; j++)
            if (!loft_acc_grow(&piece[k], (int32_t)(degree - j), h))
                return LOFT_ERR_RANGE;
        if (!loft_acc_valid(piece[k]))
            return LOFT_ERR_RANGE;
        v.axis[i] = loft_acc_round(piece[k]);
    }
    *out = v;
    return LOFT_OK;
}

bool loft_bspline_next(const loft_bspline *b, unsigned *span, loft_vec out[])
{
    loft_acc c[POINTS], piece[POINTS];

    *span = loft_knots_next(&b->knots, *span);
    for (int i = 0; i < LOFT_AXES && *span; i++) {
        widen_axis(b, *span, i, c);
        loft_knots_bezier(&b->knots, *span, c, piece);
        for (unsigned k = 0; k <= b->knots.degree; k++)
            out[k].axis[i] = loft_acc_round(piece[k]);
    }
    return *span != 0;
}

/* Point k is interpolated where u lies between k[k] and k[k+degree], for the `degree` points whose
 * support contains the span. Points before them stay, points behind them move up. The loop runs
 * from the last point down, so that an insertion in place reads each point before it is
 * overwritten. */
enum loft_status loft_bspline_insert(const loft_bspline *b, loft_real u, loft_vec p[],
                                     loft_real knots[])
{
    const unsigned span = loft_knots_find(&b->knots, u), degree = b->knots.degree;
    const loft_real *lo = b->knots.k, *hi = lo + degree;

    if (!loft_knots_valid(&b->knots, u))
        return LOFT_ERR_ARG;
    for (unsigned k = b->knots.points; k > span; k--)
        p[k] = b->p[k - 1];
    for (unsigned k = span; k > span - degree; k--)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = loft_acc_round(loft_acc_lerp_in(
                loft_to_acc(b->p[k - 1].axis[i]), loft_to_acc(b->p[k].axis[i]), u, lo[k], hi[k]));
    for (unsigned k = 0; k <= span - degree; k++)
        p[k] = b->p[k];
    loft_knots_insert(&b->knots, u, knots);
    return LOFT_OK;
}
