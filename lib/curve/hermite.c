/* lib/curve/hermite.c
 * SPDX-License-Identifier: MIT
 *
 * Each axis is computed by basis/interp.h, which derives ranges and errors, and is rounded once.
 */
#include "curve/hermite.h"
#include "basis/interp.h"       /* loft_ends3_deriv, loft_ends5_deriv */

static bool parameter_valid(loft_unit t) { return t >= LOFT_UNIT(-1) && t <= LOFT_UNIT(2); }

static void ends3(const loft_hermite *h, int i, loft_acc e[4])
{
    e[0] = loft_to_acc(h->p0.axis[i]);
    e[1] = loft_to_acc(h->p1.axis[i]);
    e[2] = loft_to_acc(h->t0.axis[i]);
    e[3] = loft_to_acc(h->t1.axis[i]);
}

static void ends5(const loft_hermite5 *h, int i, loft_acc e[6])
{
    const loft_hermite cubic = { h->p0, h->p1, h->t0, h->t1 };

    ends3(&cubic, i, e);
    e[4] = loft_to_acc(h->a0.axis[i]);
    e[5] = loft_to_acc(h->a1.axis[i]);
}

enum loft_status loft_hermite_deriv(const loft_hermite *h, unsigned k, loft_unit t, loft_vec *out)
{
    loft_acc e[4], x[LOFT_AXES];

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        ends3(h, i, e);
        x[i] = loft_ends3_deriv(e, k, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_hermite5_deriv(const loft_hermite5 *h, unsigned k, loft_unit t, loft_vec *out)
{
    loft_acc e[6], x[LOFT_AXES];

    if (!parameter_valid(t))
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++) {
        ends5(h, i, e);
        x[i] = loft_ends5_deriv(e, k, t);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_hermite_eval(const loft_hermite *h, loft_unit t, loft_vec *out)
{
    return loft_hermite_deriv(h, 0, t, out);
}

enum loft_status loft_hermite5_eval(const loft_hermite5 *h, loft_unit t, loft_vec *out)
{
    return loft_hermite5_deriv(h, 0, t, out);
}

enum loft_status loft_cubic_from_hermite(const loft_hermite *h, loft_cubic *out)
{
    loft_acc e[4], c[4];

    for (int i = 0; i < LOFT_AXES; i++) {
        ends3(h, i, e);
        loft_ends3_bernstein(e, c);
        if (!loft_vec_round_axis(c, 4, i, out->p))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

enum loft_status loft_bezier_from_hermite5(const loft_hermite5 *h, loft_vec out[6])
{
    loft_acc e[6], c[6];

    for (int i = 0; i < LOFT_AXES; i++) {
        ends5(h, i, e);
        loft_ends5_bernstein(e, c);
        if (!loft_vec_round_axis(c, 6, i, out))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}
